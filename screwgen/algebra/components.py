"""From a matrix expression to its components."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce

import numpy as np
import sympy as sp

from .expression import (
    Block,
    Constant,
    Diagonal,
    Expression,
    Hat,
    Integral,
    Inverse,
    Negative,
    Product,
    Root,
    Rotation,
    Stumpff,
    Sum,
    Symbol,
    Trace,
    Transpose,
)
from .functions import stumpff

Array = np.ndarray


def components(e: Expression, values: Mapping[str, Array]) -> Array:
    """The entries of ``e`` as an object array of sympy scalars; ``values`` holds those of its symbols."""
    inner = lambda x: components(x, values)  # noqa: E731
    match e:
        case Symbol():
            return values[e.name]
        case Constant():
            return np.array(e.rows, dtype=object).reshape(e.shape)
        case Sum():
            return reduce(np.add, (inner(t) for t in e.terms))
        case Product():
            return _chain([inner(factor) for factor in factors(e)])
        case Negative():
            return -inner(e.arg)
        case Transpose():
            return inner(e.arg).T
        case Hat():
            return skew(inner(e.arg))
        case Trace():
            return np.array([[sp.Add(*np.diagonal(inner(e.arg)))]], dtype=object)
        case Diagonal():
            return diagonal(inner(e.arg)[:, 0])
        case Block():
            return np.vstack([np.hstack([inner(x) for x in row]) for row in e.rows])
        case Rotation():
            return _rodrigues(e.axis, values[e.angle.name].item())
        case Stumpff():
            return np.array([[stumpff(e.order, inner(e.arg).item())]], dtype=object)
        case Root():
            return np.vectorize(sp.sqrt, otypes=[object])(inner(e.arg))
        case Inverse() if e.shape == (1, 1):
            return np.array([[1 / inner(e.arg).item()]], dtype=object)
        case Integral():
            weight = None if e.weight is None else e.weight.name
            integrate = lambda entry: e.rule(entry, weight)  # noqa: E731
            return np.vectorize(integrate, otypes=[object])(inner(e.integrand))
    raise TypeError(f"no components for {type(e).__name__}")


def factors(e: Expression) -> list[Expression]:
    """The factors of a product, from left to right; a product that is itself a scalar is one factor."""
    if not isinstance(e, Product):
        return [e]
    return [f for p in (e.left, e.right) for f in ([p] if p.shape == (1, 1) else factors(p))]


def _chain(arrays: list[Array]) -> Array:
    """A product, from the right if it ends in a column: matrix times vector, never matrix times matrix."""
    if arrays[-1].shape[1] == 1:
        return reduce(lambda right, left: _multiply(left, right), reversed(arrays))
    return reduce(_multiply, arrays)


def _multiply(a: Array, b: Array) -> Array:
    if a.shape == (1, 1) or b.shape == (1, 1):
        return (a.item() * b) if a.shape == (1, 1) else (a * b.item())
    out = np.empty((a.shape[0], b.shape[1]), dtype=object)
    for i, j in np.ndindex(*out.shape):
        out[i, j] = sp.Add(*(x * y for x, y in zip(a[i], b[:, j], strict=True) if x and y))
    return out


def skew(a: Array) -> Array:
    x, y, z = np.asarray(a, dtype=object).reshape(3)
    zero = sp.S.Zero
    return np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]], dtype=object)


def diagonal(entries: Sequence[sp.Expr]) -> Array:
    out = np.full((len(entries),) * 2, sp.S.Zero, dtype=object)
    for i, entry in enumerate(entries):
        out[i, i] = entry
    return out


def _rodrigues(axis: Sequence[sp.Expr], angle: sp.Expr) -> Array:
    """``I + sin hat(a) + (1 - cos) hat(a)^2``; for a coordinate axis the classical sparse matrix."""
    c, s = sp.cos(angle), sp.sin(angle)
    a = np.array(axis, dtype=object)
    outer = np.outer(a, a)
    eye = diagonal([sp.S.One] * 3)
    return outer + c * (eye - outer) + s * skew(a)
