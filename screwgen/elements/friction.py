"""Dry friction ``c w / sqrt(w² + s²)``: of the size c, and the rate s over which it changes its sign.

Its size may fall with the rate by Stribeck's curve, ``F_c + (F_s - F_c) exp(-(w/w_s)²)``. The *bend* of strain-wave
gears, whose viscous friction is steeper at low rates, has the first formula with numbers of its own, and is added.

Implicit methods take all three as a damping of the size that they have at the rates of a stage, ``D = F / w``. It is
positive also where friction falls with the rate, so a step of any length takes energy; the tangent there would give
some. An example is a mass m at a steady rate under a constant force. A rate that is off by a hair is off by
``1 - h F' / (m + h D)`` times as much after a step of length h: it grows where the slope F' is negative, as it does in
fact and no faster, and it decays without changing its sign where F' is positive, for ``F' <= D`` wherever F_s >= F_c.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from .law import Key, Secant, Value


@dataclass(frozen=True)
class DryFriction:
    """The law; its numbers are c and the square of s, and of one that falls with the rate F_s and w_s besides.

    ``about``: the meaning of c; ``over``: that of s.
    """

    name: str = "dry"
    words: str = "dry friction"
    about: str = "dry friction of the coordinates that have it"
    over: str = "over which it changes its sign"
    constants: tuple[str, ...] = ("coulomb", "speed")

    positional: ClassVar[bool] = False
    bristle: ClassVar[None] = None
    state: ClassVar[None] = None
    state_name: ClassVar[str] = ""

    @property
    def notes(self) -> tuple[str, str]:
        words = self.words[0].upper() + self.words[1:]
        return (
            f'{words} is a damping of the size that it has at the rates "there".',
            f'{words} is that at the rates "there".',
        )

    @property
    def table(self) -> Mapping[str, Key]:
        size = Key("N·m", "N", self.about, "c", "non-negative")
        speed = Key("rad²/s²", "m²/s²", f"the squares of the velocities {self.over}", "v_f^2", "positive")
        return dict(zip(self.constants, (size, speed, *FALLING_KEYS.values()), strict=False))

    def prepared(self, coulomb: Value, velocity: Value, *falling: Value) -> tuple[Value, ...]:
        return coulomb, velocity * velocity, *falling

    def _damping(self, t: Any, w: Value, coulomb: Value, speed: Value, *falling: Value) -> Value:
        """The force over its rate."""
        return size(t, w, coulomb, *falling) / t.call("sqrt", w * w + speed)

    def force(self, t: Any, side: Value, x: Value, w: Value, *constants: Value) -> Value:
        return self._damping(t, w, *constants) * w

    def energy(self, t: Any, side: Value, x: Value, *constants: Value) -> Value:
        return 0.0

    def secant(self, t: Any, side: Value, x: Value, w: Value, there: Value, h: Value, *constants: Value) -> Secant:
        return Secant(0.0, t.named("secant", self._damping(t, there, *constants)), 0.0)


def size(t: Any, w: Value, coulomb: Value, *falling: Value) -> Value:
    """The size of dry friction at a rate; ``falling``: F_s and w_s of one that falls with it."""
    if not falling:
        return coulomb
    static, speed = falling
    part = w / speed
    return t.named("size", coulomb + (static - coulomb) * t.call("exp", -(part * part)))


FALLING_KEYS = {
    "static": Key("N·m", "N", "dry friction where slip begins", "F_s", "positive"),
    "speed": Key("rad/s", "m/s", "rate over which that falls", "w_s", "positive"),
}
"""The numbers of dry friction that falls with the rate, besides its size at high rates."""

FRICTION = DryFriction()
FALLING = DryFriction(
    *("dry_of_stribeck", "dry friction that falls with the rate", "dry friction at high rates"),
    constants=tuple(f"dry_of_stribeck_{key}" for key in ("coulomb", "smooth", "static", "speed")),
)
BEND = DryFriction(
    *("bend", "the bend of friction", "friction that is added at high rates", "over which it sets in"),
    constants=("bend_friction", "bend_speed"),
)

LETTERS = {
    "coulomb": "c",
    "viscous": "b",
    "velocity": "v_f",
    "stribeck.static": "F_s",
    "stribeck.velocity": "w_s",
    "bend.friction": "c_b",
    "bend.velocity": "v_b",
}
"""The letters of the keys of friction in formulas."""

SYMBOLS = (
    (r"b, c", "viscous and dry friction", "N*m*s/rad, N*m", False),
    (r"v_f", "rate over which dry friction changes its sign", "rad/s", False),
    (r"\tau_f", "friction at the rate w of what the torque acts on", "N*m", True),
)
SIZE_SYMBOL = (r"F_w", "dry friction while it slips at the rate w, of slides a force", "N*m", True)
FALLING_SYMBOLS = (
    SIZE_SYMBOL,
    (r"F_s", "dry friction where it begins to slip, of slides a force", "N*m", False),
    (r"w_s", "rate over which it falls", "rad/s", False),
)
BEND_SYMBOLS = (
    (r"c_b", "friction that the bend adds at high rates, of slides a force", "N*m", False),
    (r"v_b", "rate over which the bend sets in", "rad/s", False),
)
"""Symbol, meaning, unit of what documents name, and whether it is a state; then of friction that falls, and bends."""

FALLING_SIZE = r"c + \left( F_s - c \right)\,\exp\left( -\frac{w^2}{w_s^2} \right)"
"""F_w of friction that falls."""


def formula(falls: bool, bends: bool) -> str:
    """That of friction in documents; ``falls``, ``bends``: whether any does of what has no bristles, and of all."""
    dry = rf"\frac{{{'F_w' if falls else 'c'}}}{{\sqrt{{w^2 + v_f^2}}}}"
    bend = r" + \frac{c_b}{\sqrt{w^2 + v_b^2}}" * bends
    size = rf", & \quad F_w &= {FALLING_SIZE}" * falls
    return rf"\left( b + {dry}{bend} \right)\,w{size}"
