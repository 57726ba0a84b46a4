"""Every type of node: what walks expressions treats it right by its value, or says that it does not know it."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
import sympy as sp
from test_algebra import AXIS, RATES, RNG, SHAPES, SYMBOLS, evaluate

from screwgen.algebra.components import components
from screwgen.algebra.expression import (
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
    Unary,
    zeros,
)
from screwgen.algebra.notation import latex
from screwgen.algebra.rate import rate
from screwgen.algebra.rewrite import difference, substitute, symbols
from screwgen.backends.latex.tidy import has_integral, tidy
from screwgen.paper.evaluate import evaluate as evaluate_motion
from screwgen.paper.plain import plain

a, b, s, A, B, P, t = SYMBOLS.values()
squared = Product(Transpose(a), a)


def rule(entry: sp.Expr, weight: str | None) -> sp.Expr:
    """A linear rule that stands in for the integrals of a rod."""
    return 3 * entry * (sp.Float("0.7") if weight else 1)


NODES = {
    Symbol: a,
    Constant: Constant(((sp.S(2), sp.S(3)), (sp.S(5), sp.S(7))), (2, 2), "C"),
    Sum: Sum((a, b)),
    Product: Product(A, a),
    Negative: Negative(a),
    Transpose: Transpose(P),
    Hat: Hat(a),
    Trace: Trace(A),
    Diagonal: Diagonal(a),
    Root: Root(squared),
    Inverse: Inverse(s),
    BlockMatrix: BlockMatrix(((a, b), (b, a))),
    Rotation: Rotation(AXIS, t),
    Stumpff: Stumpff(2, squared),
    Integral: Integral(a, s, rule),
}
"""An instance of every type of node that has components."""

WITHOUT = {
    "rate": {Root, Integral},
    "plain": {Diagonal, Root, Rotation, Stumpff},
    "numbers of a motion": {Diagonal, Root, Rotation, Stumpff},
}
"""The types of nodes that a visitor does not know."""


def concrete(cls: type) -> set[type]:
    found = {c for sub in cls.__subclasses__() for c in concrete(sub) | {sub}}
    return {c for c in found if c.__module__.startswith("screwgen.") and c is not Unary}


def draw() -> dict[str, np.ndarray]:
    return {name: RNG.normal(size=shape) for name, shape in SHAPES.items()}


def test_every_type_of_node_is_here():
    assert set(NODES) == concrete(Expression)


every = pytest.mark.parametrize("kind", NODES, ids=lambda kind: kind.__name__)


@every
def test_children_are_found_and_kept(kind):
    e, seen = NODES[kind], []
    assert e.map(lambda x: seen.append(x) or x) == e
    assert sorted(map(repr, seen)) == sorted(map(repr, e.children))
    fields = {name: repr(value) for name, value in vars(e).items()}
    assert all(any(repr(x) in text for text in fields.values()) for x in e.children)
    mentioned = {name for name in SYMBOLS if f"Symbol(name={name!r}" in repr(e)}
    assert {x.name for x in symbols(e)} == mentioned
    assert bool(e.children) == (kind not in (Symbol, Constant))


@every
def test_substitution_reaches_every_symbol(kind):
    """By value: of the expression with other symbols, and of the expression at the others' values."""
    e, numbers, others = NODES[kind], draw(), draw()
    fresh = {name: replace(x, name=f"{name}_new") for name, x in SYMBOLS.items()}
    changed = substitute(e, fresh)
    assert not {x.name for x in symbols(changed)} & set(SYMBOLS)
    assert type(changed) is kind and changed.shape == e.shape
    if kind is Integral:
        assert changed.weight == fresh["s"]
    given = numbers | {f"{name}_new": x for name, x in others.items()}
    assert np.allclose(evaluate(changed, given), evaluate(e, others), rtol=1e-12)
    assert kind is Constant or not np.allclose(evaluate(changed, given), evaluate(e, numbers), rtol=1e-3)


@every
def test_symbols_that_are_zero(kind):
    """Simplified or not, the value is that at zero; an inverse has none, an integral none over an unnamed weight."""
    e, numbers = NODES[kind], draw()
    for x in symbols(e):
        gone = substitute(e, {x.name: zeros(*x.shape)})
        assert gone.shape == e.shape
        if kind is Inverse:
            assert isinstance(gone, Inverse)
        else:
            at_zero = evaluate(e, numbers | {x.name: np.zeros(x.shape)}) if kind is not Integral else np.zeros(e.shape)
            assert np.allclose(evaluate(gone, numbers), at_zero, rtol=1e-12, atol=1e-14)


def test_a_value_of_another_shape_is_refused():
    with pytest.raises(ValueError, match=r"a has shape \(3, 1\); its value has \(3, 3\)"):
        substitute(Root(a), {"a": A})


@every
def test_rates(kind):
    e, numbers, speeds, h = NODES[kind], draw(), draw(), 1e-3
    if kind in WITHOUT["rate"]:
        with pytest.raises(TypeError, match=f"no time derivative for {kind.__name__}"):
            rate(e, RATES)
        return
    at = lambda k: evaluate(e, {n: x + k * h * speeds[n] for n, x in numbers.items()})  # noqa: E731
    expected = (at(-2) - 8 * at(-1) + 8 * at(1) - at(2)) / (12 * h)
    found = evaluate(rate(e, RATES), numbers | {f"{n}dot": x for n, x in speeds.items()})
    assert np.allclose(found, expected, rtol=1e-8, atol=1e-8)


@every
def test_transposes(kind):
    e, numbers = NODES[kind], draw()
    if kind is Integral:
        e = replace(e, integrand=A)
    assert np.allclose(evaluate(e.T, numbers), evaluate(e, numbers).T, rtol=1e-12)


@every
def test_latex_names_every_symbol(kind):
    e = NODES[kind]
    shown = latex(substitute(e, {x.name: replace(x, display=rf"\mathbf{{x}}_{{7{x.name}}}") for x in symbols(e)}))
    assert shown and all(f"_{{7{x.name}}}" in shown for x in symbols(e))


@every
def test_tidy_keeps_the_value(kind):
    """What a document shows of an expression whose symbols are zero or not."""
    e, numbers = NODES[kind], draw()
    values = {n: np.array([[sp.Float(x) for x in row] for row in v], dtype=object) for n, v in numbers.items()}
    assert np.allclose(evaluate(tidy(e, values, str), numbers), evaluate(e, numbers), rtol=1e-12)
    if kind not in (Inverse, Constant):
        none = {x.name: np.full(x.shape, sp.S.Zero) for x in symbols(e)}
        zero = {n: np.zeros_like(x) for n, x in numbers.items()}
        assert np.allclose(evaluate(tidy(e, none, str), zero), evaluate(e, zero), rtol=1e-12, atol=1e-14)
    assert has_integral(e) == (kind is Integral) and has_integral(Negative(Sum((e, Integral(e, None)))))


@every
def test_terminal_text_and_numbers_of_a_motion(kind):
    """Both know what the paper's equations consist of."""
    e, numbers = NODES[kind], draw()
    motion = _Motion(numbers, {"i": np.array([1.0, 2.0])})
    if kind in WITHOUT["plain"]:
        with pytest.raises(TypeError, match=f"no text for {kind.__name__}"):
            plain(e)
    else:
        assert plain(e)
    if kind in WITHOUT["numbers of a motion"]:
        with pytest.raises(TypeError, match=f"no value for {kind.__name__}"):
            evaluate_motion(e, motion)
    else:
        expected = 3 * numbers["s"] * numbers["a"] if kind is Integral else evaluate(e, numbers)
        assert np.allclose(evaluate_motion(e, motion), expected, rtol=1e-12)


@dataclass
class _Motion:
    values: dict[str, np.ndarray]
    weights: dict[str, np.ndarray]


@every
def test_differences(kind):
    e = NODES[kind]
    assert difference(e, e) == zeros(*e.shape)
    numbers = draw()
    assert np.allclose(evaluate(difference(Sum((e, e)), e), numbers), evaluate(e, numbers), rtol=1e-12)


# -------- what is not known


@dataclass(frozen=True)
class Exotic(Unary):
    """A node that no visitor knows."""


def test_an_unknown_node_is_named():
    """Children and substitution follow from its fields; what needs its meaning says that it lacks it."""
    e = Exotic(a)
    assert e.children == (a,) and symbols(e) == [a] and substitute(e, {"a": b}) == Exotic(b)
    visitors = (
        lambda: components(e, {"a": np.zeros((3, 1))}),
        lambda: rate(e, RATES),
        lambda: latex(e),
        lambda: plain(e),
        lambda: evaluate_motion(e, _Motion({}, {})),
    )
    for visit in visitors:
        with pytest.raises(TypeError, match="Exotic"):
            visit()


def test_integrals_that_have_no_components():
    for e in (Integral(a, None), Integral(a, Negative(s), rule)):
        with pytest.raises(TypeError, match="no components for Integral"):
            components(e, {"a": np.zeros((3, 1)), "s": np.zeros((1, 1))})
