"""Tendons: threads along links whose tensions are inputs, against their definition and from back end to back end."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from conftest import package

import screwgen
from screwgen.spec.load import loads

jax = package("jax")
ARM = """
name = "pulled"
gravity = [0.0, 0.0, -9.81]
order = {order}

[[links]]
name = "arm"
length = 0.5
section = {{ rhoA = 1.0, EIy = 5.0, EIz = 4.0, EA = 2e3, GJ = 3.0, rhoIp = 0.001 }}
modes = {{ {modes} }}
{more}
joint = {{ axes = ["z"], damping = [0.1] }}
tendons = [
    {{ name = "left", at = [[0.0, 0.02, 0.01], [0.0, 0.01, 0.0]] }},
    {{ name = "right", from = 0.2, at = [[0.0, -0.02, 0.01], [0.0, 0.01, 0.0]] }},
    {{ name = "slack", actuated = false, at = [[0.0, 0.01, 0.0], [0.0, 0.01, 0.0]] }},
]

[[links]]
name = "fore"
length = 0.4
section = {{ rhoA = 1.0, EIy = 2.0, EIz = 2.5 }}
modes = {{ bending_y = 1 }}
joint = {{ axes = ["y"] }}
tendons = [{{ name = "left", from = 0.1, to = 0.8, at = [[0.0, -0.01, 0.005], [0.0, 0.02, 0.0]] }}]
"""
MODES = "bending_y = 1, bending_z = 1, torsion = 1"
ORDERS = ("1", "2", '"exact"')
TAU = np.array([0.3, -0.2, 4.0, 2.5])


def pulled(order: str, more: str = "", modes: str = MODES) -> screwgen.Model:
    return screwgen.derive(loads(ARM.format(order=order, more=more, modes=modes), "pulled.toml"))


def state(model: screwgen.Model, size: float = 0.02) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(3)
    return size * rng.normal(size=model.nq), rng.normal(size=model.nv)


@pytest.mark.parametrize("order", ORDERS)
def test_tensions_do_their_work_along_the_lengths(order):
    """M (vdot - vdot without) is minus the tension times the derivative of the length; power is what it does."""
    model = pulled(order)
    q, v = state(model)
    f, slack = model.numpy(), TAU * [1, 1, 0, 0]
    done = f.mass_matrix(q) @ (f.forward_dynamics(q, v, TAU, None)[0] - f.forward_dynamics(q, v, slack, None)[0])
    x = ca.SX.sym("q", model.nq)
    length = model.casadi()["tendon_length"](x, model.parameter_values)
    J = ca.Function("J", [x], [ca.jacobian(length, x)])(q).full()
    assert done == pytest.approx(-J.T @ TAU[2:], abs=1e-10)
    assert f.drive_power(q, v, TAU)[2:] == pytest.approx(-TAU[2:] * (J @ v), rel=1e-10)
    assert model.tau_names[2:] == ["left.tension", "right.tension"]


@pytest.mark.parametrize("order", ORDERS)
def test_every_back_end_has_them(order):
    model = pulled(order)
    q, v = state(model)
    expected, _ = model.numpy().forward_dynamics(q, v, TAU, None)
    found = model.casadi()["forward_dynamics"](q, v, TAU, np.zeros((6, 2)), model.parameter_values)
    assert found[0].full().ravel() == pytest.approx(expected, rel=1e-9, abs=1e-9)
    with jax.enable_x64(True):
        there = model.jax()["forward_dynamics"](q, v, TAU, np.zeros((2, 6)), np.array(model.parameter_values))
        assert np.asarray(there[0]) == pytest.approx(expected, rel=1e-9, abs=1e-9)
    for layout in ("fused", "modular"):
        c = model.compile(layout=layout, flags=["-O0"])
        assert c.forward_dynamics(q, v, TAU)[0] == pytest.approx(expected, rel=1e-9, abs=1e-9)
    x = c.dae_step(c.dae_state(q, 0 * v), TAU, None, 1e-4)
    there = c.step(q, 0 * v, TAU, None, 1e-4)
    assert x == pytest.approx(c.dae_state(*there), rel=1e-9, abs=1e-9)


def slopes_of(f, q: np.ndarray, v: np.ndarray, step: float = 1e-6) -> tuple[np.ndarray, ...]:
    """Central differences of the accelerations with q, v, and with the inputs, in which they are linear."""

    def by(change):
        return np.array([change(step * e) - change(-step * e) for e in np.eye(len(q))]).T / (2 * step)

    of_tau = [f(q, v, TAU + e) - f(q, v, TAU) for e in np.eye(len(TAU))]
    return by(lambda e: f(q + e, v, TAU)), by(lambda e: f(q, v + e, TAU)), np.array(of_tau).T


@pytest.mark.parametrize("order", ORDERS)
def test_derivatives(order):
    model = pulled(order)
    q, v = state(model)
    c = model.compile(flags=["-O0"], derivatives=True)
    expected = slopes_of(lambda *x: model.numpy().forward_dynamics(*x, None)[0], q, v)
    _, *found = c.linearise(q, v, TAU)
    for a, b in zip(found, expected, strict=True):
        assert a == pytest.approx(b, rel=2e-6, abs=2e-6 * np.abs(b).max())
    dt, h = 1e-3, 1e-5
    *_, B = c.step_derivatives(q, v, TAU, None, dt, "modal_midpoint")

    def after(tau):
        return np.concatenate(c.step(q, v, tau, None, dt, "modal_midpoint"))

    by = np.array([(after(TAU + h * e) - after(TAU - h * e)) / (2 * h) for e in np.eye(4)]).T
    assert B == pytest.approx(by, rel=1e-6, abs=1e-7 * np.abs(by).max())
