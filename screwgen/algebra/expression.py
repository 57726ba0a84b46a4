"""Matrix expressions over named symbols.

An :class:`Expression` is a small immutable tree with a shape.  From the one tree come its components, as an object
array of sympy scalars (:mod:`.components`), its time derivative (:mod:`.rate`) and its LaTeX (:mod:`.notation`), so
that a formula is written once.  The tree keeps the order and the grouping in which it was written: what a reader
sees is what was derived, and the generated code follows the same grouping.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..lazily import sp

Shape = tuple[int, int]
Rule = Callable[["sp.Expr", str | None], "sp.Expr"] | None


class Expression:
    """A matrix-valued expression; vectors are columns, scalars are 1 x 1.

    What walks a tree goes by ``children`` and ``map``, which follow from a node's fields, or names the types of
    nodes that it knows and raises TypeError for others.
    """

    if TYPE_CHECKING:

        @property
        def shape(self) -> Shape: ...

    @property
    def children(self) -> tuple[Expression, ...]:
        """The expressions directly below this one."""
        return _expressions(tuple(vars(self).values()))

    def map(self, change: Callable[[Expression], Expression]) -> Expression:
        """This node over changed children, simplified as the functions below do that build expressions."""
        if not self.children:
            return self
        return BUILDERS.get(type(self), type(self))(*(_changed(x, change) for x in vars(self).values()))

    def __add__(self, other: Expression) -> Expression:
        return add(self, other)

    def __sub__(self, other: Expression) -> Expression:
        return add(self, -other)

    def __neg__(self) -> Expression:
        return Negative(self) if not is_zero(self) else self

    def __matmul__(self, other: Expression) -> Expression:
        return product(self, other)

    def __rmul__(self, factor: int | sp.Expr) -> Expression:
        return product(number(factor), self)

    @property
    def T(self) -> Expression:
        return transpose(self)


@dataclass(frozen=True)
class Symbol(Expression):
    """A named matrix; ``display`` is its LaTeX."""

    name: str
    shape: Shape
    display: str


@dataclass(frozen=True)
class Constant(Expression):
    """A matrix of numbers, row by row, with the LaTeX by which the field knows it."""

    rows: tuple[tuple[sp.Expr, ...], ...]
    shape: Shape
    display: str


@dataclass(frozen=True)
class Sum(Expression):
    """Terms of one shape, in the order in which they were written."""

    terms: tuple[Expression, ...]

    @property
    def shape(self) -> Shape:
        return self.terms[0].shape


@dataclass(frozen=True)
class Product(Expression):
    """A product from left to right; 1 x 1 factors scale."""

    left: Expression
    right: Expression

    @property
    def shape(self) -> Shape:
        if self.left.shape == (1, 1):
            return self.right.shape
        return (self.left.shape[0], self.right.shape[1]) if self.right.shape != (1, 1) else self.left.shape


@dataclass(frozen=True)
class Unary(Expression):
    """A node over one argument, whose shape it has unless it says otherwise."""

    arg: Expression

    @property
    def shape(self) -> Shape:
        return self.arg.shape


@dataclass(frozen=True)
class Negative(Unary): ...


@dataclass(frozen=True)
class Transpose(Unary):
    @property
    def shape(self) -> Shape:
        return self.arg.shape[::-1]


@dataclass(frozen=True)
class Hat(Unary):
    """The skew-symmetric matrix of a 3-vector: ``hat(a) b = a x b``."""

    shape: Shape = (3, 3)


@dataclass(frozen=True)
class Trace(Unary):
    shape: Shape = (1, 1)


@dataclass(frozen=True)
class Diagonal(Unary):
    """The diagonal matrix of a column."""

    @property
    def shape(self) -> Shape:
        return (self.arg.shape[0],) * 2


@dataclass(frozen=True)
class BlockMatrix(Expression):
    """A matrix put together from blocks, row by row."""

    rows: tuple[tuple[Expression, ...], ...]

    @property
    def shape(self) -> Shape:
        return (sum(r[0].shape[0] for r in self.rows), sum(e.shape[1] for e in self.rows[0]))


@dataclass(frozen=True)
class Rotation(Expression):
    """``exp(hat(axis) angle)`` about a fixed unit axis; the angle is 1 x 1."""

    axis: tuple[sp.Expr, sp.Expr, sp.Expr]
    angle: Expression
    shape: Shape = (3, 3)


@dataclass(frozen=True)
class Stumpff(Expression):
    """``c_order(x)`` of a 1 x 1 argument."""

    order: int
    arg: Expression
    shape: Shape = (1, 1)


@dataclass(frozen=True)
class Root(Unary):
    """The square root, entry by entry."""


@dataclass(frozen=True)
class Inverse(Unary):
    """The inverse of a square matrix."""


@dataclass(frozen=True)
class Integral(Expression):
    """``∫ weight · integrand dξ`` along the link; ``rule`` integrates one scalar component.

    Without a rule it has no components: it is printed and evaluated on numbers alone.  A rule is given the name of
    the weight, which must then be a symbol.
    """

    integrand: Expression
    weight: Expression | None
    rule: Rule = None
    index: str = "i"

    @property
    def shape(self) -> Shape:
        return self.integrand.shape


def _expressions(value: Any) -> tuple[Expression, ...]:
    """A field of a node if it is an expression, or those that it holds."""
    if isinstance(value, tuple):
        return tuple(e for part in value for e in _expressions(part))
    return (value,) if isinstance(value, Expression) else ()


def _changed(value: Any, change: Callable[[Expression], Expression]) -> Any:
    """A field of a node with its expressions changed."""
    if isinstance(value, tuple):
        return tuple(_changed(part, change) for part in value)
    return change(value) if isinstance(value, Expression) else value


def number(value: int | sp.Expr) -> Constant:
    return Constant(((sp.sympify(value),),), (1, 1), sp.latex(value))


def zeros(rows: int, cols: int = 1) -> Constant:
    return Constant(tuple((sp.S.Zero,) * cols for _ in range(rows)), (rows, cols), r"\mathbf{0}")


def identity(n: int) -> Constant:
    rows = tuple(tuple(sp.S(int(i == j)) for j in range(n)) for i in range(n))
    return Constant(rows, (n, n), r"\mathbf{I}" if n != 1 else "1")


def unit(axis: int) -> Constant:
    """The unit 3-vector of an axis: 0, 1, 2 for x, y, z."""
    rows = tuple((sp.S(int(i == axis)),) for i in range(3))
    return Constant(rows, (3, 1), rf"\mathbf{{e}}_{'xyz'[axis]}")


def vector(values: Sequence[sp.Expr], display: str) -> Constant:
    return Constant(tuple((sp.sympify(v),) for v in values), (len(values), 1), display)


def matrix(rows: Iterable[Iterable[sp.Expr]], shape: Shape, display: str) -> Constant:
    return Constant(tuple(tuple(sp.sympify(v) for v in row) for row in rows), shape, display)


def add(*terms: Expression) -> Expression:
    """The sum of ``terms``, nested sums opened and zeros dropped."""
    opened = [t for term in terms for t in (term.terms if isinstance(term, Sum) else (term,))]
    shapes = {t.shape for t in opened}
    if len(shapes) != 1:
        raise ValueError(f"a sum of shapes {sorted(shapes)}")
    kept = [t for t in opened if not is_zero(t)]
    if not kept:
        return opened[0]
    return kept[0] if len(kept) == 1 else Sum(tuple(kept))


def product(left: Expression, right: Expression) -> Expression:
    scaled = (1, 1) in (left.shape, right.shape)
    if not scaled and left.shape[1] != right.shape[0]:
        raise ValueError(f"a product of shapes {left.shape} and {right.shape}")
    if is_zero(left) or is_zero(right) or left.shape[1] == 0:
        return zeros(*Product(left, right).shape)
    if is_identity(left) and (not scaled or left.shape == (1, 1)):
        return right
    if is_identity(right) and (not scaled or right.shape == (1, 1)):
        return left
    if isinstance(left, Product) and right.shape[1] == 1 and left.shape != (1, 1):
        return product(left.left, product(left.right, right))
    if isinstance(left, Hat):
        right = _without(right, left.arg)
        if is_zero(right):
            return right
    if isinstance(left, Negative):
        return -product(left.arg, right)
    if isinstance(right, Negative):
        return -product(left, right.arg)
    return Product(left, right)


def _without(right: Expression, a: Expression) -> Expression:
    """What ``a x right`` depends on: a term ``a`` of ``right`` drops out."""
    terms = right.terms if isinstance(right, Sum) else (right,)
    return add(*(zeros(*a.shape) if t == a else t for t in terms))


def transpose(e: Expression) -> Expression:
    """The transpose, pushed down to the symbols: ``(A B)^T = B^T A^T``, ``hat(a)^T = -hat(a)``."""
    match e:
        case Transpose():
            return e.arg
        case Negative() | Sum() | Inverse() | Integral(rule=None):
            return e.map(transpose)
        case Product():
            return product(transpose(e.right), transpose(e.left))
        case Hat():
            return -e
        case BlockMatrix():
            return block(*([transpose(x) for x in col] for col in zip(*e.rows, strict=True)))
        case Constant() if is_zero(e):
            return zeros(*e.shape[::-1])
        case Constant() if is_identity(e):
            return e
    return e if e.shape == (1, 1) else Transpose(e)


def inverse(e: Expression) -> Expression:
    return e if is_identity(e) else Inverse(e)


def integral(integrand: Expression, weight: Expression | None, rule: Rule = None, index: str = "i") -> Expression:
    vanishes = is_zero(integrand) or (weight is not None and is_zero(weight))
    return zeros(*integrand.shape) if vanishes else Integral(integrand, weight, rule, index)


def hat(a: Expression) -> Expression:
    return zeros(3, 3) if is_zero(a) else Hat(a)


def block(*rows: Sequence[Expression]) -> BlockMatrix:
    return BlockMatrix(tuple(tuple(r) for r in rows))


def stack(*parts: Expression) -> Expression:
    return block(*([p] for p in parts))


def is_zero(e: Expression) -> bool:
    return isinstance(e, Constant) and not any(v for row in e.rows for v in row)


def is_identity(e: Expression) -> bool:
    return isinstance(e, Constant) and e == identity(e.shape[0]) and e.shape[0] == e.shape[1]


BUILDERS: dict[type[Expression], Callable[..., Expression]] = {
    Sum: lambda terms: add(*terms),
    Product: product,
    Negative: lambda arg: -arg,
    Transpose: transpose,
    Hat: lambda arg, _: hat(arg),
    Trace: lambda arg, _: zeros(1) if is_zero(arg) else Trace(arg),
    Diagonal: lambda arg: zeros(*Diagonal(arg).shape) if is_zero(arg) else Diagonal(arg),
    Root: lambda arg: arg if is_zero(arg) else Root(arg),
    Inverse: inverse,
    Integral: integral,
}
"""The functions that build and simplify nodes from their fields; other nodes are built by their constructors."""
