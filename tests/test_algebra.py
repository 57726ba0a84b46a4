"""Matrix expressions: their components, rates and transposes against plain numbers."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from screwgen.algebra.components import components, factors
from screwgen.algebra.expression import (
    Diagonal,
    Root,
    Rotation,
    Stumpff,
    Symbol,
    Trace,
    add,
    block,
    hat,
    identity,
    number,
    product,
    stack,
    transpose,
    unit,
    zeros,
)
from screwgen.algebra.rate import rate, turned_rate
from screwgen.algebra.stumpff import stumpff

RNG = np.random.default_rng(0)
SHAPES = {"a": (3, 1), "b": (3, 1), "s": (1, 1), "A": (3, 3), "B": (3, 3), "P": (3, 2), "t": (1, 1)}
SYMBOLS = {name: Symbol(name, shape, name) for name, shape in SHAPES.items()}
RATES = {name: Symbol(f"{name}dot", shape, f"{name}dot") for name, shape in SHAPES.items()}
AXIS = (sp.Rational(2, 3), sp.Rational(1, 3), sp.Rational(-2, 3))
a, b, s, A, B, P, t = SYMBOLS.values()


def c(order: int, x: float) -> float:
    """The Stumpff function by its series."""
    return float(mpmath.fsum((-mpmath.mpf(x)) ** j / mpmath.factorial(order + 2 * j) for j in range(40)))


def cross(x) -> np.ndarray:
    x, y, z = np.ravel(x)
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def rodrigues(angle: float) -> np.ndarray:
    K = cross([float(x) for x in AXIS])
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


EXPRESSIONS = {
    "sum": (a + b - 2 * a, lambda a, b, **_: b - a),
    "product": (A @ B @ a, lambda a, A, B, **_: A @ B @ a),
    "scaled": (s @ A @ a, lambda a, s, A, **_: s * (A @ a)),
    "squared length": ((a.T @ a) @ b, lambda a, b, **_: (a.T @ a) * b),
    "outer": (a @ b.T, lambda a, b, **_: a @ b.T),
    "hat": (hat(a) @ (hat(b) @ a), lambda a, b, **_: np.cross(a.T, np.cross(b.T, a.T)).T),
    "hat of a product": (hat(A @ a) @ b, lambda a, b, A, **_: np.cross((A @ a).T, b.T).T),
    "transpose": ((A @ P).T, lambda A, P, **_: (A @ P).T),
    "negative": (-(A @ (-a)), lambda a, A, **_: A @ a),
    "block": (
        block([A, hat(a)], [-hat(a), s @ identity(3)]),
        lambda a, s, A, **_: np.block([[A, cross(a)], [-cross(a), s * np.eye(3)]]),
    ),
    "stack": (stack(a, A @ b), lambda a, b, A, **_: np.vstack([a, A @ b])),
    "rotation": (Rotation(AXIS, t) @ a, lambda a, t, **_: rodrigues(t.item()) @ a),
    "rotation transposed": (
        Rotation(AXIS, t).T @ (A @ Rotation(AXIS, t)),
        lambda A, t, **_: rodrigues(t.item()).T @ A @ rodrigues(t.item()),
    ),
    "stumpff": (Stumpff(2, a.T @ a) @ a, lambda a, **_: c(2, (a.T @ a).item()) * a),
    "exponential": (
        identity(3) + Stumpff(1, a.T @ a) @ hat(a) + Stumpff(2, a.T @ a) @ (hat(a) @ hat(a)),
        lambda a, **_: np.eye(3) + c(1, (a.T @ a).item()) * cross(a) + c(2, (a.T @ a).item()) * cross(a) @ cross(a),
    ),
}
ONLY_VALUES = {
    "trace": (Trace(A @ B), lambda A, B, **_: np.array([[np.trace(A @ B)]])),
    "diagonal": (Diagonal(a) @ b, lambda a, b, **_: a * b),
    "root": (Root(number(4) @ (a.T @ a)), lambda a, **_: 2 * np.sqrt(a.T @ a)),
}


def draw() -> dict[str, np.ndarray]:
    return {name: RNG.normal(size=shape) for name, shape in SHAPES.items()}


def evaluate(e, numbers: dict[str, np.ndarray]) -> np.ndarray:
    """The components at numbers, by sympy."""
    values = {n: np.array([[sp.Float(x, 30) for x in row] for row in v], dtype=object) for n, v in numbers.items()}
    entries = components(e, values)
    plain = lambda x: float(sp.sympify(x).replace(stumpff, lambda k, y: sp.Float(c(int(k), float(y)))))  # noqa: E731
    return np.vectorize(plain, otypes=[float])(entries)


@pytest.mark.parametrize("name", [*EXPRESSIONS, *ONLY_VALUES])
def test_components(name):
    expression, plain = (EXPRESSIONS | ONLY_VALUES)[name]
    numbers = draw()
    expected = np.asarray(plain(**numbers))
    assert expression.shape == expected.shape
    assert np.allclose(evaluate(expression, numbers), expected, rtol=1e-12, atol=1e-13)


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_rates_are_derivatives(name):
    """The product rule against fourth-order differences along a straight line in all symbols."""
    expression, plain = EXPRESSIONS[name]
    numbers, speeds, h = draw(), draw(), 1e-3
    at = lambda k: np.asarray(plain(**{n: x + k * h * speeds[n] for n, x in numbers.items()}))  # noqa: E731
    expected = (at(-2) - 8 * at(-1) + 8 * at(1) - at(2)) / (12 * h)
    derivative = rate(expression, RATES)
    given_ = numbers | {f"{n}dot": x for n, x in speeds.items()}
    assert derivative.shape == expression.shape
    assert np.allclose(evaluate(derivative, given_), expected, rtol=1e-8, atol=1e-8)


@pytest.mark.parametrize("name", [*EXPRESSIONS, "diagonal"])
def test_transposes(name):
    expression = (EXPRESSIONS | ONLY_VALUES)[name][0]
    numbers = draw()
    assert np.allclose(
        evaluate(transpose(expression), numbers), evaluate(expression, numbers).T, rtol=1e-12, atol=1e-13
    )


def test_turned_rate():
    """(14): d/dt (R^T y) of a frame that turns with omega, both seen from y's frame."""
    angle, speed, h = 0.7, 1.3, 1e-4
    y, ydot = RNG.normal(size=(3, 1)), RNG.normal(size=(3, 1))
    omega = speed * np.array([[float(x)] for x in AXIS])
    R = Rotation(AXIS, t)
    found = turned_rate(R, SYMBOLS["b"], a, {"a": RATES["a"]})
    numbers = {"t": np.array([[angle]]), "b": omega, "a": y, "adot": ydot}
    at = lambda k: rodrigues(angle + k * h * speed).T @ (y + k * h * ydot)  # noqa: E731
    expected = (at(-2) - 8 * at(-1) + 8 * at(1) - at(2)) / (12 * h)
    assert np.allclose(evaluate(found, numbers), expected, rtol=1e-8, atol=1e-9)


# -------- building


@pytest.mark.parametrize(
    "expression",
    [
        zeros(3, 3) @ a,
        hat(zeros(3)) @ a,
        hat(a) @ a,
        A @ zeros(3),
        zeros(3) + zeros(3),
        hat(a) @ (s @ zeros(3)),
        hat(a) @ (a + zeros(3)),
    ],
)
def test_structural_zeros(expression):
    assert expression == zeros(3)


def test_identities_disappear():
    assert identity(3) @ a == a and A @ identity(3) == A and number(1) @ A == A and A + zeros(3, 3) == A
    assert transpose(transpose(A)) == A and transpose(identity(3)) == identity(3)


def test_a_cross_product_keeps_only_what_it_depends_on():
    assert hat(a) @ (b + a) == hat(a) @ b


def test_wrong_shapes_are_refused():
    for wrong in (lambda: a + A, lambda: P @ A, lambda: add(a, s)):
        with pytest.raises(ValueError, match="shapes"):
            wrong()


def test_columns_are_multiplied_from_the_right():
    """Matrix times vector, never matrix times matrix: that is what the code will do."""
    assert factors(product(product(A, B), a))[0] == A
    assert product(product(A, B), a) == A @ (B @ a)


def test_unit_vectors():
    assert [evaluate(unit(i), {}).ravel().tolist() for i in range(3)] == np.eye(3).tolist()


# -------- Stumpff functions


@given(st.integers(0, 6), st.floats(0.01, 30))
def test_stumpff_derivative(k, x):
    """c_k' = (k c_(k+2) - c_(k+1)) / 2: the series, differentiated term by term."""
    y = sp.Symbol("y")
    slope = sp.diff(stumpff(k, y), y).replace(stumpff, lambda n, z: sp.Float(c(int(n), x)))
    with mpmath.workdps(30):
        exact = mpmath.fsum(-j * (-mpmath.mpf(x)) ** (j - 1) / mpmath.factorial(k + 2 * j) for j in range(1, 60))
    assert np.isclose(float(slope), float(exact), rtol=1e-9, atol=1e-12)


def test_stumpff_at_zero():
    assert [stumpff(k, 0) for k in range(4)] == [1, 1, sp.Rational(1, 2), sp.Rational(1, 6)]
