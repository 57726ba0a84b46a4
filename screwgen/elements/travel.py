"""The contract of a transmission: the travel of what drives an axis as a function of its coordinate.

An example: a cylinder of the length ``l(q)``. The input of the axis is the effort ``F`` along the travel, so the axis
gets ``l' F``. A rotor of inertia ``J`` that turns by ``N`` per travel has the energy ``J N² l'² qdot² / 2``; friction
acts at the rate ``l' qdot``. Behind an elastic gear the rotor is ahead of the travel by ``e``, a coordinate that the
gear adds.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from typing import Any, ClassVar, NamedTuple

from .added import Added
from .law import Key, Value


class TravelSlopes(NamedTuple):
    """The first and second derivative of a travel with the coordinate, and what must be > 0 for them."""

    slope: Value
    curve: Value
    room: Value


@dataclass(frozen=True)
class Travel:
    """A kind of transmission, to be inherited; one object for each way in which it is assembled.

    ``KEYS``: its numbers by their keys, in the order in which functions take them, below ``TABLE`` of the file.
    """

    TABLE: ClassVar[str]
    KEYS: ClassVar[Mapping[str, Key]]
    WORD: ClassVar[str]
    """What it is, as in `a cylinder`."""
    PLURAL: ClassVar[str]
    SHORT: ClassVar[str]
    """The same in few words."""
    PART: ClassVar[str]
    """What the drive moves, as the crank of a linkage."""
    EFFORT: ClassVar[str]
    """What acts along the travel, in words."""
    EFFORTS: ClassVar[str]
    """All of them, where inputs are listed."""
    EFFORT_NAME: ClassVar[str]
    """The name of the input in tables, `force` or `torque`."""
    EFFORT_UNIT: ClassVar[str]
    EFFORT_NOTE: ClassVar[str]
    """What comments add to `torque about each joint axis`."""
    LEVER_UNIT: ClassVar[str]
    """The unit of l', of an axis in rad."""
    ADDED: ClassVar[Added]
    """The coordinate of an elastic gear: how far the rotor is ahead."""
    UNITS: ClassVar[Mapping[str, tuple[str, str]]]
    """Unit and meaning of the drive's own parameters, by their fields, where they are others than of an axis."""
    IS_LENGTH: ClassVar[bool] = False
    """Whether the travel is the length of what drives the axis."""
    LETTERS: ClassVar[tuple[str, str]]
    """Travel and effort in formulas."""
    SYMBOLS: ClassVar[tuple[tuple[str, str, str, bool], ...]]
    """Symbol, meaning, unit of what documents name, and whether it is a state."""
    EQUATIONS: ClassVar[str]
    """Its section in documents."""

    def length(self, t: Any, q: Value, *numbers: Value) -> Value:
        """l, where it is a length, computed with the tracer ``t``."""
        raise NotImplementedError

    def slopes(self, t: Any, q: Value, *numbers: Value, elastic: bool = False) -> TravelSlopes:
        """l' and l'' at ``q``, computed with the tracer ``t``; ``elastic``: behind an elastic gear."""
        raise NotImplementedError

    def travel(self, q: float, *numbers: float) -> float:
        """l itself. Raises ValueError where it does not reach the link."""
        raise NotImplementedError

    def reach(self, *numbers: float) -> tuple[float, float]:
        """The coordinates, rad, between which it reaches the link; infinite by default."""
        return -inf, inf

    def limit(self, elastic: bool) -> str:
        """Where it ends, for messages, also behind an elastic gear; empty where it does not."""
        return ""
