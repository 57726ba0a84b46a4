"""Admissible ranges of quantities in files and states: wide for any arm, and safe from overflow when squared.

Powers up to the sixth of a length, and products and quotients of these quantities, occur on the way to accelerations
and frequencies. Beyond these ranges they overflow, or underflow to zero, and the result is no number or a wrong one. A
number outside is a slip of the unit or of the exponent.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from .values import SIGNS, Path, array, fraction, non_negative, number, numbers, positive, refuse, shown


class Range(NamedTuple):
    """The sizes of a quantity that is > 0, or >= 0, or of any sign; 0 is allowed if the first check accepts it."""

    sign: Callable[..., float]
    low: float
    high: float
    unit: str

    @property
    def sign_name(self) -> str:
        """``positive``, ``non-negative`` or ``any``, as :class:`screwgen.elements.Key` states it."""
        return {positive: "positive", non_negative: "non-negative"}.get(self.sign, "any")

    @property
    def units(self) -> tuple[str, ...]:
        """The unit; on a joint axis that of one that turns, then that of one that slides."""
        return tuple(self.unit.split(" or "))

    @property
    def text(self) -> str:
        """The range in words."""
        unit = f" {self.unit}" if self.units[0] != "1" else ""
        if self.sign is number:
            return f"from {-self.high:g} to {self.high:g}{unit}"
        zero = "" if self.sign is positive else "0, or "
        return f"{zero}from {self.low:g} to {self.high:g}{unit}"

    def check(self, value: Any, *, at: Path = ()) -> float:
        """`value`, a number in the range."""
        result = self.sign(value, at=at)
        if abs(result) > self.high or 0.0 < abs(result) < self.low:
            raise refuse(f"is {shown(value)}; it must be {self.text}", at)
        return result


RANGES = {
    "length": Range(positive, 1e-6, 1e6, "m"),
    "rest curvature": Range(number, 0.0, 1e6, "1/m"),
    "rest twist": Range(number, 0.0, 1e6, "rad/m"),
    "frame_at": Range(non_negative, 0.0, 1e6, "m"),
    "rhoA": Range(positive, 1e-9, 1e9, "kg/m"),
    "rhoIp": Range(non_negative, 1e-15, 1e12, "kg·m"),
    "EA": Range(non_negative, 1e-6, 1e18, "N"),
    "EIy": Range(non_negative, 1e-12, 1e18, "N·m²"),
    "EIz": Range(non_negative, 1e-12, 1e18, "N·m²"),
    "GJ": Range(non_negative, 1e-12, 1e18, "N·m²"),
    "GAy": Range(non_negative, 1e-6, 1e18, "N"),
    "GAz": Range(non_negative, 1e-6, 1e18, "N"),
    "rhoIy": Range(non_negative, 1e-15, 1e12, "kg·m"),
    "rhoIz": Range(non_negative, 1e-15, 1e12, "kg·m"),
    "density": Range(positive, 1e-6, 1e9, "kg/m³"),
    "area": Range(positive, 1e-14, 1e9, "m²"),
    "E": Range(positive, 1e-3, 1e18, "Pa"),
    "G": Range(positive, 1e-3, 1e18, "Pa"),
    "Iy": Range(non_negative, 1e-28, 1e18, "m⁴"),
    "Iz": Range(non_negative, 1e-28, 1e18, "m⁴"),
    "J": Range(non_negative, 1e-28, 1e18, "m⁴"),
    "dimension": Range(positive, 1e-7, 1e4, "m"),
    "nu": Range(non_negative, 0.0, 0.5, "1"),
    "frequency": Range(positive, 1e-6, 1e9, "Hz"),
    "damping ratio": Range(non_negative, 1e-12, 1e6, "1"),
    "damping time": Range(non_negative, 1e-12, 1e6, "s"),
    "stabilisation": Range(non_negative, 1e-6, 1e6, "1/s"),
    "coupling ratio": Range(number, 0.0, 1e6, "1, rad/m or m/rad"),
    "coupling offset": Range(number, 0.0, 1e6, "rad or m"),
    "armature": Range(non_negative, 1e-12, 1e12, "kg·m² or kg"),
    "damping": Range(non_negative, 1e-12, 1e18, "N·m·s/rad or N·s/m"),
    "stiffness": Range(non_negative, 1e-12, 1e24, "N·m/rad or N/m"),
    "stiffness of a row": Range(positive, 1e-9, 1e18, "N/m, N·m/rad"),
    "damping of a row": Range(non_negative, 1e-12, 1e18, "N·s/m, N·m·s/rad"),
    "ratio": Range(positive, 1e-6, 1e9, "1 or rad/m"),
    "rotor inertia": Range(positive, 1e-12, 1e12, "kg·m² or kg"),
    "gear stiffness": Range(positive, 1e-9, 1e24, "N·m/rad or N/m"),
    "coulomb": Range(non_negative, 1e-12, 1e12, "N·m or N"),
    "friction by load": Range(non_negative, 1e-12, 1e6, "1"),
    "static friction": Range(positive, 1e-12, 1e12, "N·m or N"),
    "limit": Range(number, 0.0, 1e6, "rad or m"),
    "stop stiffness": Range(positive, 1e-9, 1e24, "N·m/rad or N/m"),
    "brake inertia": Range(positive, 1e-12, 1e12, "kg·m² or kg"),
    "brake time": Range(positive, 1e-9, 1e6, "s"),
    "velocity": Range(positive, 1e-9, 1e6, "rad/s or m/s"),
    "pitch": Range(number, 0.0, 1e3, "m/rad"),
    "mass": Range(non_negative, 1e-12, 1e12, "kg"),
    "inertia": Range(number, 0.0, 1e18, "kg·m²"),
    "position": Range(number, 0.0, 1e6, "m"),
    "turn": Range(number, 0.0, 1e6, "rad"),
    "gravity": Range(number, 0.0, 1e6, "m/s²"),
    # states and controllers
    "q": Range(number, 0.0, 1e6, "rad or m"),
    "v": Range(number, 0.0, 1e9, "rad/s or m/s"),
    "tau": Range(number, 0.0, 1e15, "N·m or N"),
    "brake": Range(fraction, 0.0, 1.0, "1"),
    "force_input": Range(number, 0.0, 1e15, "m, m/s"),
    "w_ext": Range(number, 0.0, 1e15, "N·m or N"),
    "kp": Range(non_negative, 0.0, 1e15, "N·m/rad or N/m"),
    "kd": Range(non_negative, 0.0, 1e15, "N·m·s/rad or N·s/m"),
    "ki": Range(non_negative, 0.0, 1e15, "N·m/(rad·s) or N/(m·s)"),
    "tau_max": Range(positive, 1e-12, 1e15, "N·m or N"),
    "duration": Range(positive, 1e-9, 1e9, "s"),
}
"""Quantity -> range; a link's own mass, `rhoA` times its length, is within that of bodies for any arm there is."""


def range_of(key: Any) -> Range:
    """The range of a number that a class states: of a :class:`screwgen.elements.Key`, or of one of a force."""
    units = dict.fromkeys((key.unit, getattr(key, "sliding", key.unit)))
    return Range(SIGNS[key.sign], key.least, key.most, " or ".join(units))


def within(quantity: str | Range) -> Callable[..., float]:
    """The check that a value is a number in the range of `quantity`, or in one of its own."""
    return (RANGES[quantity] if isinstance(quantity, str) else quantity).check


def several(quantity: str | Range, size: int | None = None) -> Callable[[Any], tuple[float, ...]]:
    """The check that a value is an array of such numbers, of `size` or any number of them."""
    check = within(quantity)

    def check_all(value: Any) -> tuple[float, ...]:
        entries = array(value, "an array of numbers") if size is None else numbers(value, size)
        return tuple(check(entry, at=(i,)) for i, entry in enumerate(entries))

    return check_all
