"""Products of vectors of three entries, of values of any kind."""

from __future__ import annotations

from typing import Any

Value = Any
Vector = Any


def dot(a: Vector, b: Vector) -> Value:
    """``aᵀ b``."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> list[Value]:
    """``a × b``."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
