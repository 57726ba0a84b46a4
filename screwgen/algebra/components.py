"""From a matrix expression to its components."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, reduce

import numpy as np

from ..lazily import sp
from .expression import (
    BlockMatrix,
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

Array = np.ndarray


def components(e: Expression, values: Mapping[str, Array]) -> Array:
    """The entries of ``e`` as an object array of sympy scalars; ``values`` holds those of its symbols.

    Raises TypeError for what has none: an integral without a rule or over an unnamed weight, and the inverse of a
    matrix, for which the algorithms have programs.
    """
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
        case BlockMatrix():
            return np.vstack([np.hstack([inner(x) for x in row]) for row in e.rows])
        case Rotation():
            return _rodrigues(e.axis, inner(e.angle).item())
        case Stumpff():
            from .stumpff import stumpff  # a class of sympy's

            return np.array([[stumpff(e.order, inner(e.arg).item())]], dtype=object)
        case Root():
            return _each(sp.sqrt, inner(e.arg))
        case Inverse() if e.shape == (1, 1):
            return np.array([[1 / inner(e.arg).item()]], dtype=object)
        case Integral(rule=rule, weight=None | Symbol() as weight) if rule is not None:
            name = None if weight is None else weight.name
            return _each(lambda entry: rule(entry, name), inner(e.integrand))
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
        scalar, array = (a, b) if a.shape == (1, 1) else (b, a)
        return _each(lambda x: _product(scalar.item(), x), array)
    out = np.empty((a.shape[0], b.shape[1]), dtype=object)
    for i, j in np.ndindex(*out.shape):
        terms = [_product(x, y) for x, y in zip(a[i], b[:, j], strict=True) if x and y]
        out[i, j] = terms[0] if len(terms) == 1 else sp.Add(*terms)
    return out


def _each(function: Callable[[sp.Expr], sp.Expr], a: Array) -> Array:
    """A function of every entry."""
    out = np.empty(a.shape, dtype=object)
    for index, entry in np.ndenumerate(a):
        out[index] = function(entry)
    return out


@lru_cache(maxsize=20000, typed=True)
def _product(x: sp.Expr, y: sp.Expr) -> sp.Expr:
    """`x y`; four of five products of a derivation occur in the blocks of several link classes."""
    return x * y


def skew(a: Array) -> Array:
    x, y, z = np.asarray(a, dtype=object).reshape(3)
    zero = sp.S.Zero
    return np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]], dtype=object)


def diagonal(entries: Sequence[sp.Expr] | Array) -> Array:
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
