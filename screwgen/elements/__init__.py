"""What acts on single coordinates, one file per kind: forces that are not linear, stated once for every back end."""

from .axis_element import AxisElement as AxisElement
from .axis_element import Key as Key
from .axis_element import key as key
from .friction import FRICTION as FRICTION
from .law import Law as Law
from .relation import Relation as Relation
from .spring import Spring
from .stop import STOP as STOP

KINDS: dict[str, type[AxisElement]] = {one.KIND: one for one in (Spring,)}
"""The elements of axes that a robot file may state, by its keys."""
