"""The time derivative of a matrix expression."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from .expression import (
    Block,
    Constant,
    Diagonal,
    Expression,
    Hat,
    Negative,
    Product,
    Rotation,
    Stumpff,
    Sum,
    Symbol,
    Trace,
    Transpose,
    add,
    hat,
    product,
    vector,
    zeros,
)
from .notation import axis_latex


def rate(e: Expression, rates: Mapping[str, Expression]) -> Expression:
    """``d/dt`` of ``e`` by the product rule; a symbol that is not in ``rates`` is constant.

    Raises TypeError for roots, inverses and integrals, which no equation differentiates.
    """
    inner = lambda x: rate(x, rates)  # noqa: E731
    match e:
        case Symbol():
            return rates.get(e.name, zeros(*e.shape))
        case Constant():
            return zeros(*e.shape)
        case Product():
            return add(product(inner(e.left), e.right), product(e.left, inner(e.right)))
        case Sum() | Negative() | Transpose() | Hat() | Trace() | Diagonal() | Block():
            return e.map(inner)
        case Rotation():
            axis = vector(e.axis, axis_latex(e.axis))
            return product(product(e, hat(axis)), inner(e.angle))
        case Stumpff():
            k, x = e.order, e.arg
            slope = add(sp.Rational(k, 2) * Stumpff(k + 2, x), -(sp.Rational(1, 2) * Stumpff(k + 1, x)))
            return product(inner(x), slope)
    raise TypeError(f"no time derivative for {type(e).__name__}")


def turned_rate(R: Expression, omega: Expression, y: Expression, rates: Mapping[str, Expression]) -> Expression:
    """``d/dt (R^T y)`` by the transport theorem, (14): ``R`` turns with ``omega``, in components of y's frame."""
    return R.T @ add(rate(y, rates), -(hat(omega) @ y))
