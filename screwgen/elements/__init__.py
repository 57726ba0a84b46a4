"""What acts on single coordinates, one file per kind: forces, transmissions, added coordinates, each stated once."""

from .added import Added as Added
from .added import Linear as Linear
from .added import Terms as Terms
from .axis_element import AxisElement as AxisElement
from .axis_element import ElementLaw as ElementLaw
from .axis_element import key as key
from .cylinder import CYLINDER as CYLINDER
from .four_bar import FourBarLinkage as FourBarLinkage
from .friction import BEND as BEND
from .friction import FALLING as FALLING
from .friction import FALLING_LOADED as FALLING_LOADED
from .friction import FRICTION as FRICTION
from .friction import LOADED as LOADED
from .friction import Size as Size
from .gear import ROTOR as ROTOR
from .held import HeldLaw as HeldLaw
from .held import MemoryRate as MemoryRate
from .law import Bristle as Bristle
from .law import Key as Key
from .law import Law as Law
from .lugre import BristleFriction as BristleFriction
from .relation import Relation as Relation
from .spring import Spring
from .stop import STOP as STOP
from .travel import Travel as Travel

KINDS: dict[str, type[AxisElement]] = {one.KIND: one for one in (Spring,)}
"""The elements of axes that a robot file may state, by its keys."""

TRAVELS: tuple[Travel, ...] = (CYLINDER, FourBarLinkage(1), FourBarLinkage(-1))
"""The transmissions that a drive may have, in the order in which documents name their kinds."""

ADDED: tuple[Added, ...] = tuple(dict.fromkeys((ROTOR, *(one.ADDED for one in reversed(TRAVELS)))))
"""The coordinates that drives add, in the order of plots."""
