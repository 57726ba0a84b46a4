"""screwgen: symbolic code generation for flexible robot arms.

One derivation in screw theory gives CasADi functions, standalone C and LaTeX.
"""

from .build import Model, derive
from .controllers import PD
from .errors import RobotFileError, ScrewgenError, SingularError, UsageError
from .integrate import DivergedError
from .modes import natural_frequencies
from .runs import Run
from .simulation import simulate
from .spec.load import dump, load
from .spec.robot import Body, Damping, Joint, Link, Modes, Mount, Robot
from .spec.section import Section
from .version import __version__

__all__ = [
    "PD",
    "Body",
    "Damping",
    "DivergedError",
    "Joint",
    "Link",
    "Model",
    "Modes",
    "Mount",
    "Robot",
    "RobotFileError",
    "Run",
    "ScrewgenError",
    "Section",
    "SingularError",
    "UsageError",
    "__version__",
    "derive",
    "dump",
    "load",
    "natural_frequencies",
    "simulate",
]
