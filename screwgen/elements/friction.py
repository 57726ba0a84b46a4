"""Dry friction ``c w / sqrt(w² + s²)``: of the size c, and the rate s over which it changes its sign.

Implicit methods take it as a damping of the size that it has at the rates of a stage.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .law import Secant, Value


@dataclass(frozen=True)
class DryFriction:
    """The law; ``speed`` is the square of s."""

    name: str = "dry"
    words: str = "dry friction"
    constants: tuple[str, ...] = ("coulomb", "speed")
    positional: bool = False

    def force(self, t: Any, side: Value, x: Value, w: Value, coulomb: Value, speed: Value) -> Value:
        return coulomb / t.call("sqrt", w * w + speed) * w

    def secant(
        self, t: Any, side: Value, x: Value, w: Value, there: Value, h: Value, coulomb: Value, speed: Value
    ) -> Secant:
        return Secant(0.0, t.named("secant", coulomb / t.call("sqrt", there * there + speed)), 0.0)


FRICTION = DryFriction()
