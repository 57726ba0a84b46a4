"""Dry friction ``c w / sqrt(w² + s²)``: of the size c, and the rate s over which it changes its sign.

Implicit methods take it as a damping of the size that it has at the rates of a stage.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from .law import Key, Secant, Value


@dataclass(frozen=True)
class DryFriction:
    """The law; ``speed`` is the square of s."""

    name: str = "dry"
    words: str = "dry friction"
    constants: tuple[str, ...] = ("coulomb", "speed")
    notes: tuple[str, str] = (
        'Dry friction is a damping of the size that it has at the rates "there".',
        'Dry friction is that at the rates "there".',
    )
    positional: bool = False
    bristle: ClassVar[None] = None
    state: ClassVar[None] = None
    state_name: ClassVar[str] = ""

    @property
    def table(self) -> Mapping[str, Key]:
        changes = "the squares of the velocities over which it changes its sign"
        return {
            "coulomb": Key("N·m", "N", "dry friction of the coordinates that have it", "c", "non-negative"),
            "speed": Key("rad²/s²", "m²/s²", changes, "v_f^2", "positive"),
        }

    def prepared(self, coulomb: Value, velocity: Value) -> tuple[Value, ...]:
        return coulomb, velocity * velocity

    def force(self, t: Any, side: Value, x: Value, w: Value, coulomb: Value, speed: Value) -> Value:
        return coulomb / t.call("sqrt", w * w + speed) * w

    def energy(self, t: Any, side: Value, x: Value, *constants: Value) -> Value:
        return 0.0

    def secant(
        self, t: Any, side: Value, x: Value, w: Value, there: Value, h: Value, coulomb: Value, speed: Value
    ) -> Secant:
        return Secant(0.0, t.named("secant", coulomb / t.call("sqrt", there * there + speed)), 0.0)


FRICTION = DryFriction()

LETTERS = {"coulomb": "c", "viscous": "b", "velocity": "v_f"}
"""The letters of the keys of friction in formulas."""

SYMBOLS = (
    (r"b, c", "viscous and dry friction", "N*m*s/rad, N*m", False),
    (r"v_f", "rate over which dry friction changes its sign", "rad/s", False),
    (r"\tau_f", "friction at the rate w of what the torque acts on", "N*m", True),
)
"""Symbol, meaning, unit of what documents name, and whether it is a state."""
