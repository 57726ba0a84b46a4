"""A spring and a damper along the line between two points; with `slack` a rope, which pulls alone.

With the length ``l`` between the points it pulls both together with ``T = k (l - rest) + c dl/dt``. A rope of that
stiffness pulls where it is longer than its rest length, and never pushes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .interaction import Interaction, Relative, Value, Wrench, choice, number
from .vectors import dot

SHORTEST = 1e-24
"""m²: added to the square of the length, so that the direction of a line between points that coincide is no 0/0."""


@dataclass(frozen=True)
class Line(Interaction):
    """A spring with a damper between two points."""

    KIND = "line"
    WORDS = "springs and dampers along lines"
    FORMULA = r"T = k\,(\ell - \ell_0) + c\,\dot{\ell}"

    stiffness: float = number("N/m", "stiffness of the line", "k", sign="positive", least=1e-9, most=1e18)
    rest: float | None = number(
        "m", "length at which it is relaxed", r"\ell_0", default=None, sign="non-negative", least=1e-9, most=1e6
    )
    damping: float | None = number(
        "N·s/m", "damping along the line", "c", default=None, sign="non-negative", least=1e-12, most=1e18
    )
    slack: bool = choice("whether it hangs slack where it is shorter than its rest length, as a rope")

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> Wrench:
        length = _length(t, x)
        rate = dot(x.d, x.v) / length
        stretch = length - keys["rest"]
        pull = keys["stiffness"] * stretch + keys["damping"] * rate
        if keys["slack"]:
            pull = t.call("on", stretch) * t.call("on", pull) * pull
        share = t.named("pull_over_length", pull / length)
        return Wrench((0.0, 0.0, 0.0), tuple(-(share * y) for y in x.d))

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        stretch = _length(t, x) - keys["rest"]
        stored = 0.5 * keys["stiffness"] * (stretch * stretch)
        return t.call("on", stretch) * stored if keys["slack"] else stored


def _length(t: Any, x: Relative) -> Value:
    return t.named("length", t.call("sqrt", dot(x.d, x.d) + SHORTEST))
