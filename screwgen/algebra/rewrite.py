"""Matrix expressions as sums of products: substitution, expansion, and the difference of two formulas."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ..lazily import sp
from .expression import (
    BlockMatrix,
    Constant,
    Expression,
    Hat,
    Integral,
    Negative,
    Product,
    Shape,
    Sum,
    Symbol,
    Transpose,
    add,
    block,
    hat,
    identity,
    is_identity,
    is_zero,
    number,
    transpose,
    zeros,
)

Rank = Callable[[Expression], int]
"""Which of two crossed vectors comes first: the one of lower rank."""

Monomial = tuple[Expression, ...]
Terms = dict[Monomial, "sp.Expr"]


def substitute(e: Expression, values: Mapping[str, Expression]) -> Expression:
    """``e`` with the named symbols replaced; ValueError if a value has another shape than its symbol."""
    if not isinstance(e, Symbol):
        return e.map(lambda x: substitute(x, values))
    value = values.get(e.name, e)
    if value.shape != e.shape:
        raise ValueError(f"{e.name} has shape {e.shape}; its value has {value.shape}")
    return value


def symbols(e: Expression) -> list[Symbol]:
    """The symbols of ``e`` in the order of their first appearance."""
    if isinstance(e, Symbol):
        return [e]
    return list(dict.fromkeys(s for part in e.children for s in symbols(part)))


def difference(a: Expression, b: Expression, rank: Rank = lambda e: 0) -> Expression:
    """``a - b`` with equal terms cancelled; of two matrices cut alike, block by block."""
    if isinstance(a, BlockMatrix) and isinstance(b, BlockMatrix) and _cuts(a) == _cuts(b):
        rows = [
            [difference(x, y, rank) for x, y in zip(p, q, strict=True)] for p, q in zip(a.rows, b.rows, strict=True)
        ]
        return zeros(*a.shape) if all(is_zero(x) for row in rows for x in row) else block(*rows)
    terms = expand(a, rank)
    for monomial, coefficient in expand(b, rank).items():
        _collect(terms, monomial, -coefficient)
    return rebuild(terms, a.shape)


def _cuts(e: BlockMatrix) -> list[list[Shape]]:
    return [[x.shape for x in row] for row in e.rows]


def expand(e: Expression, rank: Rank = lambda e: 0) -> Terms:
    """``e`` as a sum of products of symbols, crossed vectors in the order of their rank."""
    out: Terms = {}
    for monomial, coefficient in _monomials(e, rank):
        sign, canonical = _ordered(monomial, rank)
        if sign:
            _collect(out, canonical, sign * coefficient)
    return out


def _collect(terms: Terms, monomial: Monomial, coefficient: sp.Expr) -> None:
    total = terms.pop(monomial, sp.S.Zero) + coefficient
    if total != 0:
        terms[monomial] = total


def _monomials(e: Expression, rank: Rank) -> list[tuple[Monomial, sp.Expr]]:
    match e:
        case Constant() if is_zero(e):
            return []
        case Constant() if e.shape == (1, 1):
            return [((), e.rows[0][0])]
        case Constant() if is_identity(e):
            return [((), sp.S.One)]
        case Sum():
            return [m for t in e.terms for m in _monomials(t, rank)]
        case Negative():
            return [(m, -c) for m, c in _monomials(e.arg, rank)]
        case Product():
            left, right = _monomials(e.left, rank), _monomials(e.right, rank)
            return [((*m, *n), c * d) for m, c in left for n, d in right]
        case Transpose() if not isinstance(pushed := transpose(e.arg), Transpose):
            return _monomials(pushed, rank)
        case Hat():
            return [((hat(_word(m, e.arg.shape)),), c) for m, c in expand(e.arg, rank).items()]
        case Integral():
            return [
                ((Integral(_word(m, e.integrand.shape), e.weight, e.rule, e.index),), c)
                for m, c in expand(e.integrand, rank).items()
            ]
    return [((e,), sp.S.One)]


def _ordered(monomial: Monomial, rank: Rank) -> tuple[int, Monomial]:
    """The monomial with its scalars in front and its last cross product in order, and the sign that this costs."""
    scalars = sorted((f for f in monomial if f.shape == (1, 1)), key=repr)
    factors = [f for f in monomial if f.shape != (1, 1)]
    sign = 1
    if len(factors) > 1 and isinstance(factors[-2], Hat) and factors[-1].shape == (3, 1):
        a, b = factors[-2].arg, factors[-1]
        if a == b:
            return 0, ()
        if (rank(b), repr(b)) < (rank(a), repr(a)):
            factors[-2:], sign = [hat(b), a], -1
    return sign, (*scalars, *factors)


def _word(monomial: Monomial, shape: Shape) -> Expression:
    """The product of the factors, from the right if the last is a column."""
    if not monomial:
        return number(1) if shape == (1, 1) else identity(shape[0])
    out = monomial[-1]
    for factor in reversed(monomial[:-1]):
        out = Product(factor, out)
    return out


def rebuild(terms: Terms, shape: Shape) -> Expression:
    """The sum of the terms."""
    parts = []
    for monomial, coefficient in terms.items():
        word = _word(monomial, shape)
        size = abs(coefficient)
        if not monomial and shape == (1, 1):
            word = number(size)
        elif size != 1:
            word = Product(number(size), word)
        parts.append(Negative(word) if coefficient < 0 else word)
    return add(*parts) if parts else zeros(*shape)
