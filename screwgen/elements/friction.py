"""Dry friction ``c w / sqrt(w² + s²)``: of the size c, and the rate s over which it changes its sign.

Its size may fall with the rate by Stribeck's curve, ``F_c + (F_s - F_c) exp(-(w/w_s)²)``. Behind an elastic gear it
may grow with the load, by a share of the torque with which the gear's stretch loads the rotor. The *bend* of
strain-wave gears, whose viscous friction is steeper at low rates, has the first formula with numbers of its own, and is
added.

Implicit methods take all of them as a damping of the size that they have at the rates of a stage, ``D = F / w``. It is
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
class Size:
    """What the size of dry friction is besides its number c: whether it falls with the rate, and grows with the load.

    The load is the torque with which an elastic gear's stretch loads its rotor, ``k/N² |theta - N q|``.
    """

    falls: bool = False
    loaded: bool = False

    @property
    def suffix(self) -> str:
        """What the names of laws end with."""
        return "_of_" * (self.falls or self.loaded) + "_and_".join(["stribeck"] * self.falls + ["load"] * self.loaded)

    @property
    def keys(self) -> Mapping[str, Key]:
        """Its numbers besides c."""
        return (FALLING_KEYS if self.falls else {}) | (LOAD_KEYS if self.loaded else {})

    def prepared(self, *numbers: Value) -> tuple[Value, ...]:
        """Those out of the numbers of a robot file: F_s and w_s, then the share, stiffness and ratio of the gear."""
        falling, load = numbers[: 2 * self.falls], numbers[2 * self.falls :]
        if not self.loaded:
            return falling
        share, stiffness, ratio = load if len(load) == 3 else (*load, 1.0)
        return *falling, share * stiffness / (ratio * ratio), ratio

    def at(self, t: Any, x: Value, w: Value, *numbers: Value) -> Value:
        """The size at a coordinate and its rate; of one that grows with the load the axis stands before the numbers."""
        axis, numbers = (numbers[0], numbers[1:]) if self.loaded else (0.0, numbers)
        size, *more = numbers
        if self.falls:
            part = w / more[1]
            size = size + (more[0] - size) * t.call("exp", -(part * part))
        if self.loaded:
            stretch = x - more[-1] * axis
            size = size + more[-2] * t.named("stretch", stretch * (t.call("on", stretch) - t.call("on", -stretch)))
        return t.named("size", size) if more else size


PLAIN = Size()


@dataclass(frozen=True)
class DryFriction:
    """The law; its numbers are c and the square of s, then those of ``size``.

    ``about``: the meaning of c; ``over``: that of s.
    """

    name: str = "dry"
    words: str = "dry friction"
    about: str = "dry friction of the coordinates that have it"
    over: str = "over which it changes its sign"
    constants: tuple[str, ...] = ("coulomb", "speed")
    size: Size = PLAIN

    positional: ClassVar[bool] = False
    bristle: ClassVar[None] = None
    state: ClassVar[None] = None
    state_name: ClassVar[str] = ""

    @property
    def beside(self) -> bool:
        return self.size.loaded

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
        return dict(zip(self.constants, (size, speed, *self.size.keys.values()), strict=True))

    def prepared(self, coulomb: Value, velocity: Value, *more: Value) -> tuple[Value, ...]:
        return coulomb, velocity * velocity, *self.size.prepared(*more)

    def _damping(self, t: Any, x: Value, w: Value, *constants: Value) -> Value:
        """The force over its rate."""
        first = 1 + self.beside
        speed, own = constants[first], (*constants[:first], *constants[first + 1 :])
        return self.size.at(t, x, w, *own) / t.call("sqrt", w * w + speed)

    def force(self, t: Any, side: Value, x: Value, w: Value, *constants: Value) -> Value:
        return self._damping(t, x, w, *constants) * w

    def energy(self, t: Any, side: Value, x: Value, *constants: Value) -> Value:
        return 0.0

    def secant(self, t: Any, side: Value, x: Value, w: Value, there: Value, h: Value, *constants: Value) -> Secant:
        return Secant(0.0, t.named("secant", self._damping(t, x, there, *constants)), 0.0)


FALLING_KEYS = {
    "static": Key("N·m", "N", "dry friction where slip begins", "F_s", "positive"),
    "speed": Key("rad/s", "m/s", "rate over which that falls", "w_s", "positive"),
}
"""The numbers of dry friction that falls with the rate, besides its size at high rates."""
LOAD_KEYS = {
    "load": Key(
        "N·m/rad", "N/m", "dry friction by the rotor's angle that stretches its gear", r"\mu_J", "non-negative"
    ),
    "ratio": Key("1", "rad/m", "turns of the rotor per turn of the joint", "N", "positive"),
}
"""The numbers of dry friction that grows with the load of an elastic gear, on its rotor."""

FRICTION = DryFriction()


def _changing(size: Size, words: str, about: str) -> DryFriction:
    """Dry friction whose size changes, with columns of its own."""
    name = f"dry{size.suffix}"
    constants = tuple(f"{name}_{key}" for key in ("coulomb", "smooth", *size.keys))
    return DryFriction(name, words, about, constants=constants, size=size)


FALLING = _changing(Size(falls=True), "dry friction that falls with the rate", "dry friction at high rates")
LOADED = _changing(Size(loaded=True), "dry friction that grows with the load", "dry friction without load")
FALLING_LOADED = _changing(
    Size(falls=True, loaded=True),
    "dry friction that falls with the rate and grows with the load",
    "dry friction at high rates without load",
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
    "load": r"\mu_J",
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
LOAD_SYMBOLS = (
    SIZE_SYMBOL,
    (r"\mu_J", "share of the torque on the rotor, by the stretch of its gear, that dry friction grows by", "1", False),
)
BEND_SYMBOLS = (
    (r"c_b", "friction that the bend adds at high rates, of slides a force", "N*m", False),
    (r"v_b", "rate over which the bend sets in", "rad/s", False),
)
"""Symbol, meaning, unit of what documents name, and whether it is a state; of friction that falls, grows, bends."""

FALLING_SIZE = r" + \left( F_s - c \right)\,\exp\left( -\frac{w^2}{w_s^2} \right)"
LOAD = r" + \frac{\mu_J\,k}{N}\,\left| \frac{\vartheta}{N} - q \right|"


def written_size(size: Size) -> str:
    """F_w in documents of robots some of whose friction has this size, and none more."""
    return "c" + FALLING_SIZE * size.falls + LOAD * size.loaded


def unstated(size: Size) -> str:
    """What documents say of F_w of friction that states no F_s, where some does."""
    if not size.falls:
        return ""
    return (
        " and $F_w$ lacks its term where it states no $F_s$"
        if size.loaded
        else " and $F_w = c$ where it states no $F_s$"
    )


def formula(size: Size, bends: bool) -> str:
    """That of friction in documents; ``size``: of what has no bristles; ``bends``: whether any of all does."""
    changes = size.falls or size.loaded
    dry = rf"\frac{{{'F_w' if changes else 'c'}}}{{\sqrt{{w^2 + v_f^2}}}}"
    bend = r" + \frac{c_b}{\sqrt{w^2 + v_b^2}}" * bends
    size_of = rf", & \quad F_w &= {written_size(size)}" * changes
    return rf"\left( b + {dry}{bend} \right)\,w{size_of}"
