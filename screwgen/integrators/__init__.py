"""Time steps as data: see :class:`Method`."""

from .method import Method, Move, Stage
from .methods import METHODS

__all__ = ["METHODS", "Method", "Move", "Stage"]
