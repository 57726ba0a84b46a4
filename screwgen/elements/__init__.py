"""What acts on single coordinates, one file per kind: forces that are not linear, stated once for every back end."""

from .friction import FRICTION as FRICTION
from .law import Law as Law
from .stop import STOP as STOP
