"""The time derivative of a matrix expression."""

from __future__ import annotations

from collections.abc import Mapping

from ..lazily import sp
from .expression import (
    BlockMatrix,
    Constant,
    Diagonal,
    Expression,
    Hat,
    Inverse,
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

    Raises TypeError for roots and integrals, which no equation differentiates.
    """
    inner = lambda x: rate(x, rates)  # noqa: E731
    match e:
        case Symbol():
            return rates.get(e.name, zeros(*e.shape))
        case Constant():
            return zeros(*e.shape)
        case Product():
            return add(product(inner(e.left), e.right), product(e.left, inner(e.right)))
        case Inverse():
            return -product(product(e, inner(e.arg)), e)
        case Sum() | Negative() | Transpose() | Hat() | Trace() | Diagonal() | BlockMatrix():
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


def moving_rate(x: Expression, omega: Expression, rates: Mapping[str, Expression]) -> Expression:
    """The rate of a vector, given by its components ``x`` in a frame that turns with ``omega``, in that frame.

    Terms that are crossed with one vector are collected, so that it is crossed once.
    """
    total = add(rate(x, rates), hat(omega) @ x)
    crossed: list[tuple[Expression, list[Expression]]] = []
    others = []
    for term in total.terms if isinstance(total, Sum) else (total,):
        if not (isinstance(term, Product) and isinstance(term.left, Hat)):
            others.append(term)
        elif found := next((rights for left, rights in crossed if left == term.left), None):
            found.append(term.right)
        else:
            crossed.append((term.left, [term.right]))
    return add(*others, *(product(left, _sum(rights)) for left, rights in crossed)) if others or crossed else total


def _sum(terms: list[Expression]) -> Expression:
    """The sum of ``terms``, equal ones as a multiple."""
    opened = [t for term in terms for t in (term.terms if isinstance(term, Sum) else (term,))]
    distinct = [t for i, t in enumerate(opened) if t not in opened[:i]]
    counts = [opened.count(t) for t in distinct]
    return add(*(t if n == 1 else n * t for t, n in zip(distinct, counts, strict=True)))


def acceleration(r: Expression, omega: Expression, rates: Mapping[str, Expression]) -> Expression:
    """The second rate of a place ``r`` in a frame that turns with ``omega``: how its point accelerates."""
    return moving_rate(moving_rate(r, omega, rates), omega, rates)
