"""The value of a step of a document: by the right side of its equation, or by the entries of its components."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp
from latex_formula import ZERO, Value, Zero, blocks, plus, skew, times

from screwgen.algebra import expression as ex


def c(order: int, x: float) -> float:
    """The Stumpff function by its series."""
    total, term, j = 0.0, 1.0 / sp.factorial(order), 0
    while abs(term) > 1e-25 * max(abs(total), 1e-300) or j < 3:
        total, j = total + float(term), j + 1
        term = term * -x / ((order + 2 * j - 1) * (order + 2 * j))
    return total


def computed(e: ex.Expression, known) -> Value:
    """The value of a step's right side."""
    inner = lambda x: computed(x, known)  # noqa: E731
    match e:
        case ex.Symbol():
            return known(e)
        case ex.Constant():
            return np.array([[float(x) for x in row] for row in e.rows]).reshape(e.shape)
        case ex.Sum():
            total: Value = ZERO
            for term in e.terms:
                total = plus(total, inner(term))
            return total
        case ex.Product():
            return times(inner(e.left), inner(e.right))
        case ex.Negative():
            return times(np.full((1, 1), -1.0), inner(e.arg))
        case ex.Transpose():
            found = inner(e.arg)
            return found if isinstance(found, Zero) else found.T
        case ex.Hat():
            found = inner(e.arg)
            return found if isinstance(found, Zero) else skew(found)
        case ex.Trace():
            found = inner(e.arg)
            return ZERO if isinstance(found, Zero) else np.full((1, 1), np.trace(found))
        case ex.Diagonal():
            return np.diag(np.ravel(sized(inner(e.arg), e.arg.shape)))
        case ex.BlockMatrix():
            return blocks([[sized(inner(x), x.shape) for x in row] for row in e.rows])
        case ex.Root():
            return np.sqrt(sized(inner(e.arg), e.arg.shape))
        case ex.Inverse():
            return np.linalg.inv(inner(e.arg))
        case ex.Stumpff():
            return np.full((1, 1), c(e.order, float(sized(inner(e.arg), (1, 1)).item())))
        case ex.Rotation():
            axis, angle = np.array([float(x) for x in e.axis]), float(sized(inner(e.angle), (1, 1)).item())
            K = skew(axis)
            return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
    raise NotImplementedError(type(e).__name__)


def sized(x: Value, shape: tuple[int, int]) -> np.ndarray:
    return np.zeros(shape) if isinstance(x, Zero) else x


class FieldSymbol(Exception):
    """A quantity along the link."""


def integrates(e: ex.Expression) -> bool:
    """Whether a right side has integrals, or numbers of the shapes, of which its components are the content."""
    return isinstance(e, ex.Integral) or any(map(integrates, e.children))


FUNCTIONS: dict = {}


def evaluated(e: sp.Expr, at: Mapping[sp.Symbol, float]) -> float:
    e = sp.sympify(e)
    if e.is_Number:
        return float(e)
    names = tuple(sorted(e.free_symbols, key=str))
    if (e, names) not in FUNCTIONS:
        FUNCTIONS[e, names] = sp.lambdify(names, e, modules=[{"stumpff": c}, "math"])
    return float(FUNCTIONS[e, names](*(at[s] for s in names)))
