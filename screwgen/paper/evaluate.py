"""Numbers of an expression at one instant of a motion."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from typing import Protocol

import numpy as np

from ..algebra.expression import (
    BlockMatrix,
    Constant,
    Expression,
    Hat,
    Integral,
    Inverse,
    Negative,
    Product,
    Sum,
    Symbol,
    Trace,
    Transpose,
)
from .jets import skew


class Instant(Protocol):
    """What formulas are evaluated on: the values of symbols by name, and the weights of points by link index."""

    @property
    def values(self) -> Mapping[str, np.ndarray]:
        """Arrays of the symbols' shapes; fields have one more axis in front."""

    @property
    def weights(self) -> Mapping[str, np.ndarray]:
        """Of the points of a field, (points,)."""


def evaluate(e: Expression, motion: Instant) -> np.ndarray:
    """The value of ``e``, (r, c), or of a field, (points, r, c); KeyError names a quantity the motion lacks."""
    inner = lambda x: evaluate(x, motion)  # noqa: E731
    match e:
        case Symbol():
            return motion.values[e.name]
        case Constant():
            return np.array(e.rows, float).reshape(e.shape)
        case Sum():
            return reduce(np.add, map(inner, e.terms))
        case Product():
            left, right = inner(e.left), inner(e.right)
            return left * right if (1, 1) in (e.left.shape, e.right.shape) else left @ right
        case Negative():
            return -inner(e.arg)
        case Transpose():
            return np.swapaxes(inner(e.arg), -1, -2)
        case Inverse():
            return np.linalg.inv(inner(e.arg))
        case Hat():
            return skew(inner(e.arg))
        case Trace():
            return np.trace(inner(e.arg), axis1=-2, axis2=-1)[..., None, None]
        case BlockMatrix():
            return _joined(e, motion)
        case Integral():
            return _integral(e, motion)
    raise TypeError(f"no value for {type(e).__name__}")


def _joined(e: BlockMatrix, motion: Instant) -> np.ndarray:
    rows = [[evaluate(x, motion) for x in row] for row in e.rows]
    lead = max((x.shape[:-2] for row in rows for x in row), key=len)
    whole = [[np.broadcast_to(x, (*lead, *x.shape[-2:])) for x in row] for row in rows]
    return np.concatenate([np.concatenate(row, -1) for row in whole], -2)


def _integral(e: Integral, motion: Instant) -> np.ndarray:
    weights, field = motion.weights[e.index], evaluate(e.integrand, motion)
    total = np.tensordot(weights, field, 1) if field.ndim == 3 else weights.sum() * field
    return total if e.weight is None else evaluate(e.weight, motion) * total


def size(e: Expression, motion: Instant) -> float:
    """The largest entry among the terms of a sum, or of a product with one: against this a residual is small or not."""
    match e:
        case Sum():
            return max(size(t, motion) for t in e.terms)
        case Product(left, Sum() as right):
            return max(size(Product(left, t), motion) for t in right.terms)
    return float(np.abs(evaluate(e, motion)).max())
