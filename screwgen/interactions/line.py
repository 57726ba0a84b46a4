"""A spring and a damper along the line between two points; with `slack` a rope, which pulls alone.

With the length ``l`` between the points it pulls both together with ``T = k (l - rest) + c dl/dt``. A rope of that
stiffness pulls where it is longer than its rest length, and never pushes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from .interaction import Interaction, Quantity, Relative, Value, Vector, Wrench, choice, number

SHORTEST = 1e-24
"""m²: added to the square of the length, so that the direction of a line between points that coincide is no 0/0."""


@dataclass(frozen=True)
class Line(Interaction):
    """A spring with a damper between two points."""

    KIND = "line"
    WORDS = "springs and dampers along lines"
    FORMULA = r"T = k\,(\ell - \ell_0) + c\,\dot{\ell}"
    QUANTITIES: ClassVar = {
        "length": Quantity("m", "distance of the ends"),
        "pull": Quantity("N", "force that pulls the ends together"),
    }

    stiffness: float = number("N/m", "stiffness of the line", "k", sign="positive", least=1e-9, most=1e18)
    rest: float | None = number(
        "m", "length at which it is relaxed", r"\ell_0", default=None, sign="non-negative", least=1e-9, most=1e6
    )
    damping: float | None = number(
        "N·s/m", "damping along the line", "c", default=None, sign="non-negative", least=1e-12, most=1e18
    )
    slack: bool = choice("whether it hangs slack where it is shorter than its rest length, as a rope")

    @property
    def drawn(self) -> str:
        return "rope" if self.slack else "coil"

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> Wrench:
        length, pull = _pulled(t, x, keys)
        share = t.named("pull_over_length", pull / length)
        return Wrench((0.0, 0.0, 0.0), tuple(-(share * y) for y in x.d))

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        stretch = _length(t, x) - keys["rest"]
        stored = 0.5 * keys["stiffness"] * (stretch * stretch)
        return t.call("on", stretch) * stored if keys["slack"] else stored

    @staticmethod
    def outputs(t: Any, x: Relative, **keys: Any) -> Mapping[str, Value]:
        return dict(zip(("length", "pull"), _pulled(t, x, keys), strict=True))


def _pulled(t: Any, x: Relative, keys: Mapping[str, Any]) -> tuple[Value, Value]:
    """The length, and the force that pulls both ends together."""
    length = _length(t, x)
    rate = _dot(x.d, x.v) / length
    stretch = length - keys["rest"]
    pull = keys["stiffness"] * stretch + keys["damping"] * rate
    return length, t.call("on", stretch) * t.call("on", pull) * pull if keys["slack"] else pull


def _length(t: Any, x: Relative) -> Value:
    return t.named("length", t.call("sqrt", _dot(x.d, x.d) + SHORTEST))


def _dot(a: Vector, b: Vector) -> Value:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
