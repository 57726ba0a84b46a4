"""The angle of a point, atan2: in every algebra and in every quarter, its slopes, and what it is at the origin."""

import math

import casadi as ca
import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pytest
import sympy as sp

from screwgen.algorithms.fused import precise
from screwgen.algorithms.law_programs import on_arrays
from screwgen.backends.casadi.expressions import expressions
from screwgen.backends.equations.functions import NoClosedFormError, function
from screwgen.backends.equations.ring import Ring
from screwgen.backends.jax.programs import JaxProgram, straight
from screwgen.backends.latex.scalars import Scalars
from screwgen.backends.numpy.python import compiled
from screwgen.backends.numpy.reference import _elementwise
from screwgen.ir.derivative import columns, gradients
from screwgen.ir.lower import recipe
from screwgen.ir.program import Program, Tracer
from screwgen.ir.replay import bind, inline, run
from screwgen.ir.signs import signed

QUARTERS = [(0.3, 1.1), (0.3, -1.1), (-0.3, -1.1), (-0.3, 1.1), (2.0, 0.1), (-2.0, -0.1), (0.7, 0.0), (-0.7, 0.0)]
QUARTERS += [(0.0, 2.0), (1e-9, -1.0), (-1e-9, -1.0)]


def program(slopes=False) -> Program:
    tracer = Tracer()
    y, x = tracer.input("y", 1) + tracer.input("x", 1)
    values = [tracer.call("atan2", y, x), tracer.call("atan2", y, -2.0), tracer.call("atan2", -0.5, x)]
    outputs = {"angle": values}
    if slopes:
        outputs |= {"slope": [s for column in columns(values, [y, x]) for s in column]}
        outputs |= {"gradient": gradients(values, [1.0, 2.0, 3.0], [y, x])}
    return tracer.program("angle", {"y": 1, "x": 1}, outputs)


def judged(y, x) -> list[float]:
    return [math.atan2(y, x), math.atan2(y, -2.0), math.atan2(-0.5, x)]


@pytest.mark.parametrize(("y", "x"), QUARTERS)
def test_every_algebra_knows_the_quarters(y, x):
    found, given = program(), {"y": [y], "x": [x]}
    tracer = Tracer()
    copy = tracer.program("copy", {"y": 1, "x": 1}, inline(found, {n: tracer.input(n, 1) for n in "yx"}, tracer))
    sx = {n: ca.SX.sym(n) for n in "yx"}
    casadi = ca.Function("f", [*sx.values()], [expressions(found, sx)["angle"]])
    arrays = {n: [np.array(v * 3)] for n, v in given.items()}
    single = {n: [np.array(v, np.float32)] for n, v in given.items()}
    by_algebra = {
        "Python": compiled(found)(given, 0.0)[0]["angle"],
        "mpmath": run(found, {n: [mpmath.mpf(v[0])] for n, v in given.items()}, precise)[0]["angle"],
        "NumPy": [x[2] for x in run(found, arrays, on_arrays)[0]["angle"]],
        "copied": compiled(copy)(given, 0.0)[0]["angle"],
        "signs moved": compiled(signed(found))(given, 0.0)[0]["angle"],
        "half bound": compiled(bind(found, {"x": [x]}))({"y": [y]}, 0.0)[0]["angle"],
        "bound": bind(found, given).outputs["angle"],
        "CasADi": casadi(y, x).full().ravel(),
        "rounded": [z[0] for z in run(found, single, _elementwise(np.float32), 0.0, np.float32)[0]["angle"]],
    }
    with jax.enable_x64(True):
        in_jax = {n: jnp.array(v) for n, v in given.items()}
        by_algebra |= {
            "JAX": JaxProgram(found)(in_jax)[0]["angle"],
            "JAX, straight": straight(found)(in_jax)[0]["angle"],
        }
    for algebra, values in by_algebra.items():
        size = 2e-7 if algebra == "rounded" else 1e-15
        assert np.abs(np.array([float(v) for v in values]) - judged(y, x)).max() < size * np.pi, algebra


@pytest.mark.parametrize(("y", "x"), [at for at in QUARTERS if at[0]])
def test_its_slopes_are_differences(y, x):
    """Forwards and in reverse, with 40 digits; in JAX by the adjoint program."""
    made = program(slopes=True)
    with mpmath.workdps(40):
        at = lambda y, x: run(made, {"y": [mpmath.mpf(y)], "x": [mpmath.mpf(x)]}, precise)[0]  # noqa: E731
        h = mpmath.mpf("1e-14")
        pairs = [(at(y + h, x), at(y - h, x)), (at(y, x + h), at(y, x - h))]
        expected = [[(p - m) / (2 * h) for p, m in zip(a["angle"], b["angle"], strict=True)] for a, b in pairs]
        found = at(y, x)
        assert max(abs(s - e) for s, e in zip(found["slope"], [*expected[0], *expected[1]], strict=True)) < 1e-16
        weighed = [a + 2 * b + 3 * c for a, b, c in expected]
        assert max(abs(s - e) for s, e in zip(found["gradient"], weighed, strict=True)) < 1e-15
    total = lambda z: jnp.dot(JaxProgram(program())(z)[0]["angle"], jnp.array([1.0, 2.0, 3.0]))  # noqa: E731
    with jax.enable_x64(True):
        slopes = jax.grad(total)({"y": jnp.array([y]), "x": jnp.array([x])})
    assert [float(slopes[n][0]) for n in "yx"] == pytest.approx([float(s) for s in weighed], rel=1e-13)


def test_at_the_origin_the_angle_is_zero_and_has_no_slope():
    """Nothing is made up there: Python refuses to divide, other back ends have no number, which they say."""
    tracer = Tracer()
    y, x = tracer.input("y", 1) + tracer.input("x", 1)
    angle = tracer.call("atan2", y, x)
    plain = tracer.program("angle", {"y": 1, "x": 1}, {"angle": [angle]})
    sloped = tracer.program("slopes", {"y": 1, "x": 1}, {"slope": columns([angle], [y])[0]})
    origin, sx = {"y": [0.0], "x": [0.0]}, {n: ca.SX.sym(n) for n in "yx"}
    assert compiled(plain)(origin, 0.0)[0]["angle"] == [0.0] and Tracer().call("atan2", 0.0, 0.0) == 0.0
    zeros = {n: jnp.zeros(1) for n in "yx"}
    for made, key_ in ((plain, "angle"), (sloped, "slope")):
        in_sx = ca.Function("f", [*sx.values()], [expressions(made, sx)[key_]])(0.0, 0.0)
        both = [float(in_sx), float(JaxProgram(made)(zeros)[0][key_][0])]
        assert both == [0.0, 0.0] if made is plain else np.isnan(both).all()
    with pytest.raises(ZeroDivisionError):
        compiled(sloped)(origin, 0.0)


def test_formulas_name_it():
    a, b = sp.symbols("a b", real=True)
    written = Scalars({a: r"\alpha", b: r"\beta"}, {})(3 * sp.atan2(a, b) ** 2)
    assert written == r"3\,(\operatorname{atan2}(\alpha, \beta))^{2}"
    made = recipe(sp.atan2(a, b - 1))({"a": 0.5, "b": 0.25}, Tracer())
    assert made == math.atan2(0.5, -0.75)
    with pytest.raises(NoClosedFormError, match="asks for the angle of a point"):
        function(Ring(10), "atan2", 0.5, 0.25)
