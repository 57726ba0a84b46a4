"""Contact of a sphere at the first frame with a plane through the second frame's origin, or with a sphere there.

A finger tip of 10 mm presses with 2 N on a wall of 20 kN/m: it enters by 0.1 mm. The force of Hunt and Crossley,
``k p (1 + c dp/dt)``, grows with the depth ``p`` and never pulls; it takes energy as a bounce of small speed ``v`` with
a restitution of about ``1 - 2 c v/3`` does. The depth is smoothed: over ``width`` about the touching it goes from zero
to its slope by a parabola. Friction is Coulomb's, over a small velocity.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from math import log10
from typing import Any, ClassVar

from .interaction import (
    FORCE,
    POTENTIAL,
    TORQUE,
    Interaction,
    LawEquation,
    Relative,
    ReportedQuantity,
    Value,
    Vector,
    WrenchOnSecond,
    number,
)
from .vectors import cross, dot

SHORTEST = 1e-24
"""m²: added to the square of the distance of two centres."""
SLOW = 1e-3
"""m/s: the velocity over which friction sets in where a file states none."""


@dataclass(frozen=True)
class Contact(Interaction):
    """Contact of a sphere with a plane whose `normal`, in the second frame's axes, points to the sphere's side.

    Without a normal the second frame has a sphere too, of the radius `other`; without that it is a point.
    """

    KIND = "contact"
    WORDS = "contact of spheres"
    QUANTITIES: ClassVar = {
        "depth": ReportedQuantity("m", "how far the sphere is beyond the surface"),
        "press": ReportedQuantity("N", "force along the normal"),
    }

    radius: float = number(
        "m", "radius of the sphere at the first end", "r_c", sign="non-negative", least=1e-9, most=1e6
    )
    stiffness: float = number("N/m", "stiffness of the contact", "k_c", sign="positive", least=1e-9, most=1e18)
    width: float = number("m", "depth over which it sets in", "w_c", sign="positive", least=1e-12, most=1e3)
    normal: tuple[float, ...] | None = number(
        *("1", "direction of the plane's normal", r"\mathbf{n}_c"), default=None, most=1e6, entries=("x", "y", "z")
    )
    damping: float | None = number(
        "s/m", "damping over the stiffness", "c_c", default=None, sign="non-negative", least=1e-12, most=1e18
    )
    friction: float | None = number(
        "1", "coefficient of friction", r"\mu_c", default=None, sign="non-negative", least=1e-12, most=1e6
    )
    velocity: float | None = number(
        *("m/s", "sliding velocity over which friction sets in, 1 mm/s by default", "v_c"),
        default=None,
        sign="positive",
        least=1e-9,
        most=1e6,
    )
    other: float | None = number(
        *("m", "radius of a sphere at the second end, in place of a plane", "r_o"),
        default=None,
        sign="non-negative",
        least=1e-9,
        most=1e6,
    )

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> WrenchOnSecond:
        n, _, press, arm, slip = _pressed(t, x, keys)
        small = keys["velocity"] if keys["velocity"] != 0.0 else SLOW
        grip = keys["friction"] * press / t.call("sqrt", dot(slip, slip) + small * small)
        force = [-(press * n[k] + grip * slip[k]) for k in range(3)]
        return WrenchOnSecond(cross(arm, force), force)

    @property
    def fault(self) -> tuple[str, str] | None:
        if self.normal is not None and self.other is not None:
            return "other", "is stated beside a normal, of a plane; leave one of them out"
        if self.velocity is not None and self.friction is None:
            return "velocity", "is stated without friction, whose velocity it is; state friction too, or leave it out"
        return ("normal", "has no direction; state one that is not zero") if self.normal == (0.0,) * 3 else None

    @staticmethod
    def drawn(has: Collection[str]) -> str:
        return "contact"

    @staticmethod
    def outputs(t: Any, x: Relative, **keys: Any) -> Mapping[str, Value]:
        _, depth, press, *_ = _pressed(t, x, keys)
        return {"depth": depth, "press": press}

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        low, high = _beyond(t, _touching(t, x, keys)[1], keys["width"])
        return keys["stiffness"] * (low * low * low - high * high * high) / (12.0 * keys["width"])

    @staticmethod
    def equations(has: Collection[str]) -> tuple[LawEquation, ...]:
        press = rf"k_c\,\frac{{{_softened_latex(2)}}}{{4\,w_c}}"
        press += r"\,\max\left( 0,\ 1 + c_c\,\dot{p}_c \right)" * ("damping" in has)
        force, contact = r"-f_c\,\mathbf{n}_{AB}", (_PLANE if "normal" in has else _spheres(has))
        rubs = [_SLIP, *[_SLOW] * ("velocity" not in has)] if "friction" in has else []
        if rubs:
            force += r" - \frac{\mu_c\,f_c}{\sqrt{\mathbf{s}_{AB}^{\top}\,\mathbf{s}_{AB} + v_c^2}}\,\mathbf{s}_{AB}"
        return (
            *contact,
            _ARM,
            *[_TOUCHING, _RATE] * ("damping" in has or bool(rubs)),
            LawEquation("f_c", press, "N", "pressing force of the contact"),
            *rubs,
            LawEquation(FORCE, force),
            LawEquation(TORQUE, r"\mathbf{a}_{AB} \times \mathbf{F}_{AB}"),
            LawEquation(POTENTIAL, rf"k_c\,\frac{{{_softened_latex(3)}}}{{12\,w_c}}"),
        )


_PLANE = (
    LawEquation(
        r"\mathbf{n}_{AB}",
        r"\frac{1}{\sqrt{\mathbf{n}_c^{\top}\,\mathbf{n}_c}}\,\mathbf{R}_{AB}\,\mathbf{n}_c",
        "-",
        "normal of the contact towards A",
    ),
    LawEquation("p_c", r"r_c + \mathbf{n}_{AB}^{\top}\,\mathbf{d}_{AB}", "m", "depth of the contact"),
)
_SPHERES = (
    LawEquation.smallest(SHORTEST, "m^2", "the direction between centres that coincide"),
    LawEquation("d_c", r"\sqrt{\mathbf{d}_{AB}^{\top}\,\mathbf{d}_{AB} + \varepsilon}", "m", "distance of the centres"),
    LawEquation(r"\mathbf{n}_{AB}", r"-\frac{1}{d_c}\,\mathbf{d}_{AB}", "-", "normal of the contact towards A"),
)
_ARM = LawEquation(r"\mathbf{a}_{AB}", r"-r_c\,\mathbf{n}_{AB} - \mathbf{d}_{AB}", "m", "point of contact from point B")
_TOUCHING = LawEquation(
    r"\mathbf{u}_{AB}",
    r"\mathbf{v}_{AB} + \boldsymbol{\omega}_{AB} \times \mathbf{a}_{AB}",
    "m/s",
    "velocity of B at the point of contact, as seen from A",
)
_RATE = LawEquation(r"\dot{p}_c", r"\mathbf{n}_{AB}^{\top}\,\mathbf{u}_{AB}", "m/s", "rate of the depth")
_SLIP = LawEquation(
    r"\mathbf{s}_{AB}", r"\mathbf{u}_{AB} - \dot{p}_c\,\mathbf{n}_{AB}", "m/s", "its part along the plane"
)
_SLOW = LawEquation("v_c", rf"10^{{{round(log10(SLOW))}}}", "m/s", "sliding velocity over which friction sets in")


def _softened_latex(power: int) -> str:
    return " - ".join(rf"\max\left( 0,\ p_c {sign} w_c \right)^{power}" for sign in "+-")


def _spheres(has: Collection[str]) -> tuple[LawEquation, ...]:
    """The depth of two spheres, or of one and a point."""
    depth = "r_c + r_o - d_c" if "other" in has else "r_c - d_c"
    return *_SPHERES, LawEquation("p_c", depth, "m", "depth of the contact")


def _pressed(t: Any, x: Relative, keys: Mapping[str, Any]) -> tuple[Vector, Value, Value, Vector, Vector]:
    """The normal, the depth, the force along the normal, where it acts as seen from the second origin, and the slip."""
    n, depth = _touching(t, x, keys)
    arm = [-(keys["radius"] * n[k]) - x.d[k] for k in range(3)]
    u = [a + b for a, b in zip(x.v, cross(x.omega, arm), strict=True)]
    rate = dot(n, u)
    push = 1.0 + keys["damping"] * rate
    press = t.named("press", keys["stiffness"] * _softened(t, depth, keys["width"]) * t.call("on", push) * push)
    return n, depth, press, arm, [u[k] - rate * n[k] for k in range(3)]


def _touching(t: Any, x: Relative, keys: Mapping[str, Any]) -> tuple[Vector, Value]:
    """The normal towards the first frame's sphere, in that frame's axes, and how far the sphere is beyond."""
    normal = keys["normal"]
    if normal == (0.0, 0.0, 0.0):
        distance = t.named("distance", t.call("sqrt", dot(x.d, x.d) + SHORTEST))
        return [-y / distance for y in x.d], keys["radius"] + keys["other"] - distance
    size = 1.0 / t.call("sqrt", dot(normal, normal))
    n = [size * dot(row, normal) for row in x.R]
    return n, keys["radius"] + dot(n, x.d)


def _beyond(t: Any, depth: Value, width: Value) -> tuple[Value, Value]:
    """How far a depth is beyond the beginning and the end of the part where it is softened, 0 before."""
    return tuple(y * t.call("on", y) for y in (depth + width, depth - width))


def _softened(t: Any, depth: Value, width: Value) -> Value:
    low, high = _beyond(t, depth, width)
    return (low * low - high * high) / (4.0 * width)
