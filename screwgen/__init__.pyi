"""The public names, for type checkers."""

from .errors import RobotFileError, ScrewgenError, SingularError, UsageError
from .model import Model, derive
from .simulation.controllers import PD, Holding
from .simulation.integrate import DivergedError
from .simulation.rollout import Rollout, rollout
from .simulation.runs import Run
from .simulation.simulate import simulate
from .simulation.validity import ModelLeftError, ModelValidityWarning, Validity
from .spec.frequencies import Frequencies
from .spec.load import dump, load
from .spec.robot import Body, Damping, Joint, Link, Modes, Mount, Robot
from .spec.screw import Screw
from .spec.section import Section
from .studies.analysis import Analysis, analyse
from .studies.convergence import Convergence, convergence
from .studies.equilibrium import Equilibrium, NoEquilibriumError, equilibrium
from .studies.linear import LinearModel
from .studies.modes import natural_frequencies
from .version import __version__

__all__ = [
    "PD",
    "Analysis",
    "Body",
    "Convergence",
    "Damping",
    "DivergedError",
    "Equilibrium",
    "Frequencies",
    "Holding",
    "Joint",
    "LinearModel",
    "Link",
    "Model",
    "ModelLeftError",
    "ModelValidityWarning",
    "Modes",
    "Mount",
    "NoEquilibriumError",
    "Robot",
    "RobotFileError",
    "Rollout",
    "Run",
    "Screw",
    "ScrewgenError",
    "Section",
    "SingularError",
    "UsageError",
    "Validity",
    "__version__",
    "analyse",
    "convergence",
    "derive",
    "dump",
    "equilibrium",
    "load",
    "natural_frequencies",
    "rollout",
    "simulate",
]
