"""A spring that is relaxed at an angle of its own: ``F = k (x - rest)``, with the potential ``k (x - rest)² / 2``.

At q = 0 it is wound, by the torque ``-k rest``: it carries the weight of an arm, or holds a gripper shut.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .axis_element import AxisElement, key
from .law import Value


@dataclass(frozen=True)
class Spring(AxisElement):
    """A preloaded spring between the carrier and the link."""

    KIND = "spring"
    WORDS = "preloaded springs"
    FORMULA = r"k\,(q - q_0)"

    stiffness: float = key("N·m/rad", "N/m", "stiffness of the spring", "k", sign="positive", least=1e-12, most=1e24)
    rest: float = key("rad", "m", "coordinate at which the spring is relaxed", "q_0", most=1e6)

    @staticmethod
    def force(t: Any, x: Value, w: Value, stiffness: Value, rest: Value) -> Value:
        return stiffness * (x - rest)

    @staticmethod
    def energy(t: Any, x: Value, stiffness: Value, rest: Value) -> Value:
        return 0.5 * stiffness * ((x - rest) * (x - rest))
