"""The public names, for type checkers."""

from .errors import (
    RobotFileError as RobotFileError,
)
from .errors import (
    ScrewgenError as ScrewgenError,
)
from .errors import (
    SingularError as SingularError,
)
from .errors import (
    UsageError as UsageError,
)
from .model import Model as Model
from .model import derive as derive
from .simulation.controllers import PD as PD
from .simulation.controllers import Holding as Holding
from .simulation.integrate import DivergedError as DivergedError
from .simulation.rollout import Rollout as Rollout
from .simulation.rollout import rollout as rollout
from .simulation.runs import Run as Run
from .simulation.simulate import simulate as simulate
from .simulation.validity import (
    ModelLeftError as ModelLeftError,
)
from .simulation.validity import (
    ModelValidityWarning as ModelValidityWarning,
)
from .simulation.validity import (
    Validity as Validity,
)
from .spec.frequencies import Frequencies as Frequencies
from .spec.load import dump as dump
from .spec.load import load as load
from .spec.robot import (
    Body as Body,
)
from .spec.robot import (
    Damping as Damping,
)
from .spec.robot import (
    Joint as Joint,
)
from .spec.robot import (
    Link as Link,
)
from .spec.robot import (
    Modes as Modes,
)
from .spec.robot import (
    Mount as Mount,
)
from .spec.robot import (
    Robot as Robot,
)
from .spec.screw import Screw as Screw
from .spec.section import Section as Section
from .studies.analysis import Analysis as Analysis
from .studies.analysis import analyse as analyse
from .studies.convergence import Convergence as Convergence
from .studies.convergence import convergence as convergence
from .studies.equilibrium import (
    Equilibrium as Equilibrium,
)
from .studies.equilibrium import (
    NoEquilibriumError as NoEquilibriumError,
)
from .studies.equilibrium import (
    equilibrium as equilibrium,
)
from .studies.linear import LinearModel as LinearModel
from .studies.modes import natural_frequencies as natural_frequencies
from .version import __version__ as __version__
