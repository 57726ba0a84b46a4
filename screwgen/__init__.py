"""screwgen: symbolic code generation for flexible robot arms.

One derivation in screw theory gives CasADi functions, standalone C and LaTeX.
"""

from .build import VERSION as __version__
from .build import Model, derive
from .errors import RobotFileError, ScrewgenError, SingularError, UsageError
from .spec.load import load
from .spec.robot import Body, Damping, Joint, Link, Modes, Mount, Robot
from .spec.section import Section

__all__ = [
    "Body", "Damping", "Joint", "Link", "Model", "Modes", "Mount", "Robot", "RobotFileError", "ScrewgenError",
    "Section", "SingularError", "UsageError", "derive", "load",
]
