"""Floating bases: Pinocchio, conserved momentum, limits. The oracle judges them in `conformance/`."""

import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from floating_robots import HULL, SATELLITE, TAU, momentum, start
from helpers import model_of, quick, relative, rotation_of
from oracle import Oracle
from oracle_floating import ANGLE, coordinates, floating, twin
from oracle_robots import pinocchio_model

from screwgen.backends.numpy.dae_step import space_of


@pytest.fixture(scope="module")
def satellite():
    return model_of(SATELLITE)


@pytest.mark.parametrize("n_links", swept(range(1, 9), 5))
def test_rigid_robots_equal_pinocchios_free_flyer(n_links):
    import pinocchio as pin

    rng = np.random.default_rng(7500 + n_links)
    limits = dict(rigid=1.0, material=0.0, frame_at=0.0, sliding=0.3, branching=0.5, bodies=0.8)
    robot = floating(rr.random_robot(rng, n_links, **limits))
    oracle, state = Oracle(twin(robot)), {k: np.array(x) for k, x in rr.random_state(rng, twin(robot)).items()}
    state["q"][3:6] = rng.uniform(-ANGLE, ANGLE, 3)
    (q, v), tau = coordinates(oracle, state["q"], state["v"]), state["tau"][6:]
    _, model, _ = pinocchio_model(robot)
    model.gravity.linear, model.armature = np.array(robot["gravity"]), oracle.armature
    mixed = lambda x: np.concatenate([x[3:6], x[:3], x[6:]])  # noqa: E731
    passive = oracle.damping * v + oracle.K @ np.append(np.zeros(6), q[7:])
    place = np.concatenate([q[:3], q[4:7], q[3:4], q[7:]])
    force = np.append(np.zeros(6), tau) - passive
    expected = pin.aba(model, model.createData(), place, mixed(v), mixed(force))
    found = model_of(robot).numpy().forward_dynamics(q, v, tau, np.zeros((n_links, 6)))[0]
    assert relative(found, mixed(expected)) < oracle.tolerance(state["q"])


# -------- steps


def test_momentum_is_conserved_without_forces(satellite):
    """The change of momentum falls with the order of the method; that of rk4 is rounding and its own error."""
    q0, v0 = start(satellite)
    first, compiled = momentum(satellite, q0, v0), quick(satellite)
    changes = {}
    for method, h in (("rk4", 1e-4), ("modal_midpoint", 1e-4), ("modal_midpoint", 2e-4)):
        q, v = q0, v0
        for _ in range(round(0.5 / h)):
            q, v = compiled.step(q, v, None, None, h, method)
        changes[method, h] = np.abs(momentum(satellite, q, v) - first).max() / np.abs(first).max()
        assert abs(np.linalg.norm(q[3:7]) - 1) < 1e-15
    assert changes["rk4", 1e-4] < 1e-9
    assert 3 < changes["modal_midpoint", 2e-4] / changes["modal_midpoint", 1e-4] < 5


def test_a_fast_constant_spin_keeps_the_quaternion_on_the_sphere(satellite):
    """Where every step turns by the same angle, rounding is the same too and adds up."""
    space, q, u = space_of(satellite.chain), np.array(satellite.chain.home), np.zeros(satellite.nv)
    u[:3] = (0.003, -0.001, 0.002)
    for _ in range(10_000):
        q = space.moved(q, u)
    assert abs(np.linalg.norm(q[3:7]) - 1) < 1e-12
    half = 5_000 * np.linalg.norm(u[:3])
    expected = np.append(np.cos(half), np.sin(half) * u[:3] / np.linalg.norm(u[:3]))
    assert np.allclose(q[3:7], expected, atol=1e-11)


def test_weight_alone_makes_a_floating_base_fall(satellite):
    model = model_of({**SATELLITE, "gravity": [1.0, 2.0, -9.0]})
    q, v = start(model, rate=0.0)
    v[:] = 0.0
    q[model.chain.eta_q :] = 0.0
    vdot, wrench = model.numpy().forward_dynamics(q, v, np.zeros(4), np.zeros((4, 6)))
    assert np.allclose(vdot[:3], 0.0, atol=1e-11) and np.allclose(vdot[6:], 0.0, atol=1e-9)
    assert np.allclose(rotation_of(q[3:7]) @ vdot[3:6], [1.0, 2.0, -9.0]) and np.allclose(wrench, 0.0, atol=1e-10)


def test_a_heavy_base_is_a_fixed_one(satellite):
    """The accelerations of the arms tend to those on a fixed base, as the inverse of the base's mass."""
    robot = {**SATELLITE, "links": [dict(part) for part in SATELLITE["links"]]}
    fixed = {k: x for k, x in robot.items() if k != "base"}
    q, v = start(satellite)
    q[:7], v[:6] = satellite.chain.home[:7], 0.0
    expected = model_of(fixed).numpy().forward_dynamics(q[7:], v[6:], TAU, np.zeros((4, 6)))[0]
    errors = []
    for scale in (1e4, 1e6):
        heavy = {**HULL, "mass": 8.0 * scale, "inertia": [scale * x for x in HULL["inertia"]]}
        robot["links"][0] = {**robot["links"][0], "bodies": [heavy]}
        found = model_of(robot).numpy().forward_dynamics(q, v, TAU, np.zeros((4, 6)))[0]
        errors.append(relative(found[6:], expected))
    assert errors[0] < 0.02 and errors[1] == pytest.approx(errors[0] / 100, rel=0.05)
