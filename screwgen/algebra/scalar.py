"""Scalars that calculate as numbers do: what is written for numbers and traced values then makes expressions too."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ..lazily import sp
from .expression import Expression, add, number, product


@dataclass(frozen=True)
class Scalar:
    """An expression of shape (1, 1), with the operations of arithmetic; the other operand may be a number."""

    e: Expression

    def __add__(self, other: Any) -> Scalar:
        return Scalar(add(self.e, _expression(other))) if isinstance(other, KNOWN) else NotImplemented

    def __mul__(self, other: Any) -> Scalar:
        return Scalar(product(_expression(other), self.e)) if isinstance(other, KNOWN) else NotImplemented

    def __truediv__(self, other: float) -> Scalar:
        return self * (Fraction(1, other) if isinstance(other, int) else 1 / other)

    def __neg__(self) -> Scalar:
        return Scalar(-self.e)

    def __sub__(self, other: Any) -> Scalar:
        return self + -other

    def __rsub__(self, other: Any) -> Scalar:
        return -self + other

    __radd__, __rmul__ = __add__, __mul__


KNOWN = (Scalar, int, float, Fraction)
"""What it calculates with; of arrays the entries do."""


def _expression(x: Any) -> Expression:
    """A scalar or a number as an expression; whole numbers and fractions are exact."""
    if isinstance(x, Scalar):
        return x.e
    exact = isinstance(x, Fraction) or x == int(x)
    return number(sp.Rational(Fraction(x)) if exact else sp.Float(x))
