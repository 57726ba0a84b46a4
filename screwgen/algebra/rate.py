"""The time derivative of a matrix expression."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from .expression import (
    Block,
    Constant,
    Expression,
    Hat,
    Negative,
    Product,
    Rotation,
    Stumpff,
    Sum,
    Symbol,
    Transpose,
    add,
    block,
    hat,
    product,
    transpose,
    vector,
    zeros,
)
from .notation import axis_latex


def rate(e: Expression, rates: Mapping[str, Expression]) -> Expression:
    """``d/dt`` of ``e`` by the product rule; a symbol that is not in ``rates`` is constant."""
    inner = lambda x: rate(x, rates)  # noqa: E731
    match e:
        case Symbol():
            return rates.get(e.name, zeros(*e.shape))
        case Constant():
            return zeros(*e.shape)
        case Sum():
            return add(*(inner(t) for t in e.terms))
        case Product():
            return add(product(inner(e.left), e.right), product(e.left, inner(e.right)))
        case Negative():
            return -inner(e.arg)
        case Transpose():
            return transpose(inner(e.arg))
        case Hat():
            return hat(inner(e.arg))
        case Block():
            return block(*([inner(x) for x in row] for row in e.rows))
        case Rotation():
            axis = vector(e.axis, axis_latex(e.axis))
            return product(product(e, hat(axis)), rates.get(e.angle.name, zeros(1)))
        case Stumpff():
            k, x = e.order, e.arg
            slope = add(sp.Rational(k, 2) * Stumpff(k + 2, x), -(sp.Rational(1, 2) * Stumpff(k + 1, x)))
            return product(inner(x), slope)
    raise TypeError(f"no time derivative for {type(e).__name__}")


def turned_rate(R: Expression, omega: Expression, y: Expression, rates: Mapping[str, Expression]) -> Expression:
    """``d/dt (R^T y)`` by the transport theorem, (14): ``R`` turns with ``omega``, in components of y's frame."""
    return R.T @ add(rate(y, rates), -(hat(omega) @ y))
