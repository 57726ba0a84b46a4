"""What acts between two frames, one file per kind, each stated once."""

from .bushing import Bushing
from .contact import Contact
from .drag import Drag
from .interaction import FORCE as FORCE
from .interaction import POTENTIAL as POTENTIAL
from .interaction import ROWS as ROWS
from .interaction import TORQUE as TORQUE
from .interaction import ForceInput as ForceInput
from .interaction import ForceState as ForceState
from .interaction import Interaction as Interaction
from .interaction import InteractionClass as InteractionClass
from .interaction import LawEquation as LawEquation
from .interaction import Number as Number
from .interaction import Relative as Relative
from .interaction import ReportedQuantity as ReportedQuantity
from .interaction import SoftRow as SoftRow
from .interaction import StateRate as StateRate
from .interaction import WrenchOnSecond as WrenchOnSecond
from .interaction import choice as choice
from .interaction import number as number
from .line import SHORTEST as SHORTEST
from .line import Length as Length
from .line import SpringLine

KINDS: dict[str, type[Interaction]] = {one.KIND: one for one in (SpringLine, Bushing, Contact, Drag)}
"""The interactions that a robot file may state, by its keys."""
