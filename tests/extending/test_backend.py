"""A back end that the product does not contain: programs run in Python's fractions."""

from fractions import Fraction
from math import factorial

import numpy as np
import pytest
from helpers import model_of

from screwgen.algorithms.fused import forward_dynamics, inverse_dynamics
from screwgen.ir.program import Program
from screwgen.ir.replay import run

TERMS = 14
"""Of the series: exact to 1e-25 for angles up to one."""


def primitive(op: str, x: Fraction) -> Fraction:
    """The unary primitives of a program that a rigid arm needs."""
    if op == "neg":
        return -x
    first = {"sin": 1, "cos": 0}[op]
    powers = range(first, 2 * TERMS + first, 2)
    return sum((Fraction((-1) ** (n // 2), factorial(n)) * x**n for n in powers), Fraction(0))


class Exact:
    """The functions of a robot in fractions; what the product's back ends are: an algebra that runs programs."""

    def __init__(self, model):
        self.p = [Fraction(x) for x in model.parameter_values]
        self.forward: Program = forward_dynamics(model.chain)
        self.inverse: Program = inverse_dynamics(model.chain)

    def __call__(self, program: Program, **inputs) -> dict[str, list[Fraction]]:
        given = {name: [Fraction(x) for x in values] for name, values in inputs.items()}
        outputs, guards = run(program, given | {"p": self.p}, primitive, Fraction(0), Fraction)
        assert all(guard > 0 for guard in guards)
        return outputs


@pytest.fixture(scope="module")
def model():
    link = {"length": 0.5, "section": {"rhoA": 2.0, "rhoIp": 0.01}, "bodies": [{"at": "tip", "mass": 1.5}]}
    links = [{"name": "a", "joint": {"axes": ["z", "y"]}, **link}, {"name": "b", "joint": {"axes": ["y"]}, **link}]
    return model_of({"name": "rational", "gravity": [0.0, 0.0, -9.81], "links": links})


def test_doubles_are_the_fractions_rounded(model):
    rng = np.random.default_rng(0)
    q, v, tau, w_ext = 0.5 * rng.normal(size=3), rng.normal(size=3), rng.normal(size=3), rng.normal(size=(2, 6))
    exact = Exact(model)
    found = exact(exact.forward, q=q, v=v, tau=tau, w_ext=w_ext.ravel())
    vdot, wrench = model.numpy().forward_dynamics(q, v, tau, w_ext)
    assert np.allclose([float(x) for x in found["vdot"]], vdot, rtol=1e-13)
    assert np.allclose([float(x) for x in found["wrench"]], wrench.ravel(), rtol=1e-12, atol=1e-12)


def test_forward_and_inverse_dynamics_cancel_exactly_but_for_the_series(model):
    exact = Exact(model)
    q, v, tau, w_ext = [Fraction(1, 3), Fraction(-1, 4), Fraction(2, 5)], [1, 2, -1], [Fraction(1, 7), 3, -2], [0] * 12
    vdot = exact(exact.forward, q=q, v=v, tau=tau, w_ext=w_ext)["vdot"]
    force = exact(exact.inverse, q=q, v=v, vdot=vdot, w_ext=w_ext)["force"]
    assert max(abs(float(a - b)) for a, b in zip(force, tau, strict=True)) < 1e-20
