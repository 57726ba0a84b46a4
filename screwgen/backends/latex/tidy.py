"""Expressions simplified for display: zeros, ones and formal factors of the derivation left out."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import sympy as sp

from ...algebra import expression as ex
from ...algebra.components import Array
from ...algebra.expression import Expression


def tidy(e: Expression, values: Mapping[str, Array], scalar: Callable[[sp.Expr], str]) -> Expression:
    """``e`` rebuilt with the zeros and identities among ``values``, and with named entries."""
    inner = lambda x: tidy(x, values, scalar)  # noqa: E731
    match e:
        case ex.Symbol():
            return _symbol(e, values[e.name], scalar)
        case ex.Product():
            return _product(inner(e.left), inner(e.right))
        case ex.Negative():
            return _negative(inner(e.arg))
        case ex.Hat():
            return _hat(inner(e.arg))
        case ex.BlockMatrix():
            return _block([[inner(x) for x in row] for row in e.rows])
    return e.map(inner)


def _symbol(e: ex.Symbol, values: Array, scalar: Callable[[sp.Expr], str]) -> Expression:
    if not any(value != 0 for value in values.flat):
        return ex.zeros(*e.shape)
    square = e.shape[0] == e.shape[1] != 1
    if square and all(value == int(i == j) for (i, j), value in np.ndenumerate(values)):
        return ex.identity(e.shape[0])
    return ex.Symbol(e.name, e.shape, scalar(values.item())) if e.name.endswith("]") else e


def _product(left: Expression, right: Expression) -> Expression:
    """A row of blocks times a column of blocks is written out."""
    if isinstance(left, ex.BlockMatrix) and isinstance(right, ex.BlockMatrix) and len(left.rows) == 1:
        row, column = left.rows[0], [r[0] for r in right.rows if len(r) == 1]
        if [x.shape[1] for x in row] == [y.shape[0] for y in column]:
            return ex.add(*(_pair(x, y) for x, y in zip(row, column, strict=True)))
    return ex.product(left, right)


def _pair(x: Expression, y: Expression) -> Expression:
    """A block times a block; a scalar goes to every term of a sum."""
    if y.shape != (1, 1):
        return ex.product(x, y)
    return ex.add(*(ex.product(y, term) for term in (x.terms if isinstance(x, ex.Sum) else (x,))))


def _negative(e: Expression) -> Expression:
    return e.arg if isinstance(e, ex.Negative) else -e


def _hat(e: Expression) -> Expression:
    """Signs and scalars go before the skew-symmetric matrix."""
    if isinstance(e, ex.Negative):
        return _negative(_hat(e.arg))
    if isinstance(e, ex.Product) and e.left.shape == (1, 1):
        return ex.product(e.left, _hat(e.right))
    return ex.hat(e)


def _block(rows: list[list[Expression]]) -> Expression:
    if all(ex.is_zero(x) for row in rows for x in row):
        return ex.zeros(*ex.block(*rows).shape)
    if all(ex.is_identity(x) if i == j else ex.is_zero(x) for i, row in enumerate(rows) for j, x in enumerate(row)):
        return ex.identity(ex.block(*rows).shape[0])
    column = [row[0] for row in rows]
    filled = [i for i, x in enumerate(column) if not ex.is_zero(x)]
    if len(filled) == 1 and all(len(row) == 1 and row[0].shape == (1, 1) for row in rows) and len(rows) == 3:
        return ex.product(column[filled[0]], ex.unit(filled[0]))
    return ex.block(*rows) if len(rows) > 1 or len(rows[0]) > 1 else rows[0][0]


def has_integral(e: Expression) -> bool:
    """Whether an integral along the link occurs in an expression."""
    return isinstance(e, ex.Integral) or any(map(has_integral, e.children))


def is_elementwise(e: Expression) -> bool:
    """Whether every entry of ``e`` is an entry of one of its symbols, or a sum of such."""
    match e:
        case ex.Sum() | ex.BlockMatrix() | ex.Negative() | ex.Transpose() | ex.Hat():
            return all(map(is_elementwise, e.children))
        case ex.Product():
            return (1, 1) in (e.left.shape, e.right.shape) and all(map(is_elementwise, e.children))
    return isinstance(e, ex.Symbol | ex.Constant)


def is_symbols_product(e: Expression) -> bool:
    """Whether ``e`` is a matrix that is the product of two named matrices."""
    named = ex.Symbol | ex.Transpose
    return isinstance(e, ex.Product) and e.shape[1] > 1 and isinstance(e.left, named) and isinstance(e.right, named)
