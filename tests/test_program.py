"""Straight-line programs: value numbering, structural zeros, inlining, specialising; one meaning in every algebra."""

import math

import casadi as ca
import mpmath
import numpy as np
import pytest
from helpers import example
from hypothesis import given, settings
from hypothesis import strategies as st

from screwgen.algorithms import functions as alg
from screwgen.algorithms import fused
from screwgen.algorithms.schedule import trace
from screwgen.backends.casadi import expressions as sx
from screwgen.backends.numpy.python import compiled
from screwgen.ir.names import Label
from screwgen.ir.program import FUNCTIONS, Program, Tracer, give_label
from screwgen.ir.replay import bind, inline, run
from screwgen.ir.signs import signed


def traced(function, **sizes) -> Program:
    """The program of a function of lists of nodes."""
    tracer = Tracer()
    inputs = {name: tracer.input(name, size) for name, size in sizes.items()}
    return Program("traced", dict(sizes), {"y": list(function(tracer, **inputs))}, list(tracer.guards), tracer.sections,
                   list(tracer.origins))  # fmt: skip


def value(program: Program, **inputs) -> list[float]:
    return compiled(program)(inputs, 0.0)[0]["y"]


# -------- value numbering and structure


def test_equal_operations_are_one():
    p = traced(lambda t, x: [x[0] * x[1] + x[2], x[2] + x[1] * x[0], x[0] * x[1]], x=3)
    assert p.operation_count == 2 and p.outputs["y"][0] is p.outputs["y"][1]


def test_sums_keep_their_grouping():
    """(a + b) + c is not a + (b + c): what is written is what is computed."""
    p = traced(lambda t, x: [(x[0] + x[1]) + x[2], x[0] + (x[1] + x[2])], x=3)
    assert p.operation_count == 4


@pytest.mark.parametrize(
    "identity",
    [
        lambda t, x: x * 0.0,
        lambda t, x: 0.0 * x,
        lambda t, x: x - x,
        lambda t, x: 0.0 / x,
        lambda t, x: t.call("sin", 0.0),
        lambda t, x: (x * 0.0) * x + (x - x),
    ],
)
def test_zeros_cost_nothing(identity):
    p = traced(lambda t, x: [identity(t, x[0])], x=1)
    assert p.outputs["y"] == [0.0] and p.operation_count == 0


@pytest.mark.parametrize(
    "identity",
    [
        lambda t, x: x * 1.0,
        lambda t, x: x / 1.0,
        lambda t, x: x + 0.0,
        lambda t, x: 0.0 + x,
        lambda t, x: x - 0.0,
        lambda t, x: t.neg(t.neg(x)),
        lambda t, x: (-x) * (-1.0),
        lambda t, x: 0.0 - (-x),
    ],
)
def test_ones_and_signs_cost_nothing(identity):
    p = traced(lambda t, x: [identity(t, x[0])], x=1)
    assert p.outputs["y"][0].op == "input" and p.operation_count == 0


def test_dead_code_is_dropped():
    p = traced(lambda t, x: [(x[0] * x[1], x[0] + 1.0)[1]], x=2)
    assert p.operations == {"add": 1}


def test_guards_are_kept_and_evaluated():
    def body(t, x):
        t.guard(x[0] - 1.0, origin=3)
        return [x[0]]

    p = traced(body, x=1)
    assert p.origins == [3] and compiled(p)({"x": [0.5]}, 0.0)[1] == [-0.5]


def test_long_chains_are_recorded_in_linear_time():
    """x_(k+1) = x_k + x_k: a tree of 2^3000 leaves, 3000 operations."""

    def doubled(t, x):
        y = x[0]
        for _ in range(3000):
            y = 0.5 * (y + y)
        return [y]

    p = traced(doubled, x=1)
    assert p.operation_count == 6000 and value(p, x=[1.5]) == [1.5]


# -------- one meaning


@st.composite
def expressions(draw, depth=5):
    """A random expression as a Python function of (tracer or None, x, y)."""
    if depth == 0 or draw(st.integers(0, 5)) == 0:
        c = draw(st.sampled_from([0.0, 1.0, -1.0, 0.5, -3.0]))
        return draw(st.sampled_from([lambda u, x, y: x, lambda u, x, y: y, lambda u, x, y: c]))
    a = draw(expressions(depth=depth - 1))
    b = draw(expressions(depth=depth - 1))
    kind = draw(st.sampled_from(["add", "sub", "mul", "div", "neg", "sin", "cos", "sqrt", "atan2", "c4", "c5"]))
    return {
        "add": lambda u, x, y: a(u, x, y) + b(u, x, y),
        "sub": lambda u, x, y: a(u, x, y) - b(u, x, y),
        "mul": lambda u, x, y: a(u, x, y) * b(u, x, y),
        "div": lambda u, x, y: a(u, x, y) / (2.0 + u("cos", b(u, x, y))),
        "neg": lambda u, x, y: -a(u, x, y),
        "sin": lambda u, x, y: u("sin", a(u, x, y)),
        "cos": lambda u, x, y: u("cos", a(u, x, y)),
        "sqrt": lambda u, x, y: u("sqrt", 1.0 + a(u, x, y) * a(u, x, y)),
        "atan2": lambda u, x, y: u("atan2", a(u, x, y), 0.5 + b(u, x, y) * b(u, x, y)),
        "c4": lambda u, x, y: u("c4", a(u, x, y) * a(u, x, y)),
        "c5": lambda u, x, y: u("c5", a(u, x, y) * a(u, x, y)),
    }[kind]


def exact(op: str, *x):
    """The primitives in mpmath."""
    return fused.precise(op, *map(mpmath.mpf, x))


@settings(max_examples=60)
@given(expressions(), st.floats(-2, 2), st.floats(-2, 2))
def test_every_algebra_gives_the_same_number(f, x, y):
    """Python, mpmath, casadi.SX, an inlined copy and a specialised one: all equal the expression itself."""
    program = traced(lambda t, x, y: [f(t.call, x[0], y[0])], x=1, y=1)
    with mpmath.workdps(30):
        direct = f(exact, mpmath.mpf(x), mpmath.mpf(y))
        in_mpmath = run(program, {"x": [mpmath.mpf(x)], "y": [mpmath.mpf(y)]}, fused.precise)[0]["y"][0]
    expected = float(direct)
    a, b = ca.SX.sym("a"), ca.SX.sym("b")
    in_sx = ca.Function("f", [a, b], [sx.expressions(program, {"x": a, "y": b})["y"]])(x, y)
    tracer = Tracer()
    copy = inline(program, {"x": tracer.input("x", 1), "y": tracer.input("y", 1)}, tracer)
    copied = Program("copy", dict(program.inputs), copy, [], tracer.sections)
    known = bind(program, {"y": [y]})
    assert "y" not in known.inputs and copied.operation_count == program.operation_count
    found = [
        float(in_mpmath),
        value(program, x=[x], y=[y])[0],
        float(in_sx),
        value(copied, x=[x], y=[y])[0],
        value(known, x=[x])[0],
    ]
    size = 1 + abs(expected)
    assert all(math.isclose(z, expected, rel_tol=1e-9, abs_tol=1e-11 * size) for z in found), (found, expected)


def test_functions_of_numbers_run_in_every_algebra():
    """A baked constant may end up inside a sine: mounts of the DAE form's quaternions."""
    program = traced(lambda t, x: [x[0] * t.call("cos", 1.0)], x=1)
    assert value(program, x=[2.0]) == [2 * math.cos(1.0)]
    assert float(run(program, {"x": [mpmath.mpf(2)]}, fused.precise)[0]["y"][0]) == pytest.approx(2 * math.cos(1.0))


def test_specialising_folds_everything_that_is_known():
    p = traced(lambda t, a, x: [a[0] * x[0] + a[1] * x[1]], a=2, x=2)
    assert bind(p, {"a": [0.0, 1.0]}).operation_count == 0
    assert value(bind(p, {"a": [2.0, 3.0]}), x=[5.0, 7.0]) == [31.0]


def test_primitives_are_known_everywhere():
    for op in FUNCTIONS:
        given = [0.3, 0.7][: 1 + (op == "atan2")]
        made = traced(lambda t, x, op=op: [t.call(op, *x)], x=len(given))
        assert np.isclose(float(exact(op, *given)), value(made, x=given)[0])


# -------- programs of robots


def test_fused_program_is_no_longer_than_its_phases():
    """Inlining folds zeros of base and tip: less work than the phases one by one, the same numbers."""
    chain = example("ella").chain
    phases = sum(sum(p.operation_count for p in trace(key, alg.FORWARD)) for key in chain.keys)
    assert fused.modal_dynamics(chain, "constants").operation_count < phases


def test_baked_program_is_shorter():
    chain = example("ella").chain
    assert (
        fused.complete_dynamics(chain, "baked").operation_count
        < fused.complete_dynamics(chain, "constants").operation_count
    )


def test_programs_are_the_same_every_time():
    chain = example("ella").chain
    first, second = fused.forward_dynamics(chain), fused.forward_dynamics(chain)
    text = lambda p: [(n.op, [getattr(a, "id", a) for a in n.args], n.label) for n in p.nodes]  # noqa: E731
    assert text(first) == text(second)


def test_signs_move_to_uses_where_that_takes_no_operation():
    tracer = Tracer()
    a, b, c = tracer.input("x", 3)
    difference, product = a - b, a * c
    give_label(-difference, Label("d", "x"))
    give_label(-product, Label("p"))
    outputs = {"y": [c - difference * b, difference * c + b], "z": [product + c]}
    before = tracer.program("f", {"x": 3}, outputs)
    after = signed(before)
    names = {str(node.label) for node in after.nodes if node.label}
    assert names == {"d_x", "minus_p"}  # -(a * c) would take an operation more
    assert after.operations == before.operations
    numbers = {"x": [0.3, -1.7, 2.9]}
    assert run(after, numbers, lambda _, x: -x) == run(before, numbers, lambda _, x: -x)
