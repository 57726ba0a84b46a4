"""Floating bases: the oracle in other coordinates, Pinocchio, conserved momentum, in all back ends and both forms."""

from functools import cache

import numpy as np
import pytest
from conftest import swept
from floating_robots import HULL, SATELLITE, TAU, momentum, start
from helpers import casadi_forward, flat, model_of, quick, relative, rotation_of
from oracle_floating import FloatingCase, draw
from oracle_robots import pinocchio_model

from screwgen import simulate
from screwgen.backends.numpy.dae_step import space_of
from screwgen.integrators import METHODS, Method, Move, Stage

HEUN = Method("heun", 2, (Stage(), Stage([1])), Move(["1/2", "1/2"]), "Heun's method, two forward dynamics")


@pytest.fixture(scope="module")
def satellite():
    return model_of(SATELLITE)


# -------- random robots against the oracle


@cache
def random_robot(seed: int) -> FloatingCase:
    """Free base, trees, slides, modes of both orders."""
    more = {"branching": 0.5, "sliding": 0.25, "second_order": 0.15, "stations": 0.1, "shear": 0.1}
    return draw(7000 + seed, 1 + seed % 6, max_modes=1 + (seed % 6 < 3), **more)


@pytest.fixture(params=swept(range(60), 1, 3, 5))
def robot(request) -> FloatingCase:
    return random_robot(request.param)


def test_numpy_and_casadi_equal_the_oracle_in_both_forms(robot):
    numeric = robot.model.numpy()
    for found in (
        numeric.forward_dynamics(*robot.given),
        numeric.dae_forward_dynamics(*robot.given),
        casadi_forward(robot.model, *robot.given),
    ):
        assert max(robot.errors(*found).values()) < robot.tolerance


def test_mass_matrix_energy_places_and_twists_are_the_oracles(robot):
    numeric, oracle, (q, v, _, w_ext) = robot.model.numpy(), robot.oracle, robot.given
    T, functions, p = robot.twist_map(), robot.model.casadi(), robot.model.parameter_values
    for M in (numeric.mass_matrix(q), np.array(functions["mass_matrix"](q, p))):
        assert relative(T.T @ M @ T, oracle.mass_matrix(robot.state["q"])) < 1e-12
    assert numeric.energy(q, v) == pytest.approx(
        oracle.energy(robot.state["q"], robot.state["v"]), rel=1e-11, abs=1e-11
    )
    poses = oracle.poses(robot.state["q"])
    R, r = numeric.link_pose(q)
    assert relative(R, poses["R"]) < 1e-12 and relative(r, poses["origin"]) < 1e-12
    vdot = robot.expected()[0]
    force = np.concatenate([np.zeros(6), robot.given[2], np.zeros(robot.model.chain.n_modes)])
    rest = np.abs(numeric.mass_matrix(q)) @ np.abs(vdot)
    assert np.all(np.abs(numeric.inverse_dynamics(q, v, vdot, w_ext) - force) <= 1e-9 * rest.max())
    twist = oracle.tip_twists(robot.state["q"], robot.state["v"])[-1].reshape(2, 3) @ poses["tip_R"][-1].T
    assert relative(np.array(functions["tip_jacobian"](q, p)) @ v, twist.ravel()) < 1e-11


def test_the_assembled_system_has_no_wrench_on_the_base(robot):
    q, v, tau, w_ext = robot.given
    numeric, n = robot.model.numpy(), robot.model.n_links
    x = numeric.dae_state(q, v)
    M, H, W = numeric.assemble(x, tau, w_ext)
    z, (vdot, wrench) = np.linalg.solve(M, W - H), robot.expected()
    assert np.all(z[:6] == 0.0)
    found = np.concatenate([z[6:12], vdot[6 : robot.model.chain.eta_v], z[12 * n :]])
    assert relative(found, vdot) < 1e3 * robot.tolerance
    assert relative(z[: 12 * n].reshape(n, 12)[1:, :6], wrench[1:]) < 1e3 * robot.tolerance or n == 1
    assert relative(numeric.project(x), x) < 1e-13
    scaled = x.copy()
    scaled[:4] *= 1.01
    assert relative(numeric.project(scaled), x) < 1e-13


@pytest.mark.parametrize("n_links", swept(range(1, 9), 5))
def test_rigid_robots_equal_pinocchios_free_flyer(n_links):
    import pinocchio as pin

    robot = draw(7500 + n_links, n_links, rigid=1.0, material=0.0, frame_at=0.0, sliding=0.3, branching=0.5, bodies=0.8)
    _, model, _ = pinocchio_model(robot.robot)
    model.gravity.linear, model.armature = np.array(robot.robot["gravity"]), robot.oracle.armature
    q, v, tau, _ = robot.given
    still = np.zeros((robot.model.n_links, 6))
    mixed = lambda x: np.concatenate([x[3:6], x[:3], x[6:]])  # noqa: E731
    passive = robot.oracle.damping * v + robot.oracle.K @ np.append(np.zeros(6), q[7:])
    place = np.concatenate([q[:3], q[4:7], q[3:4], q[7:]])
    force = np.append(np.zeros(6), tau) - passive
    expected = pin.aba(model, model.createData(), place, mixed(v), mixed(force))
    assert relative(robot.model.numpy().forward_dynamics(q, v, tau, still)[0], mixed(expected)) < robot.tolerance


# -------- steps


@pytest.fixture(scope="module")
def compiled(satellite):
    return quick(satellite, methods=(HEUN,))


@cache
def _reference(satellite, compiled):
    """The motion of 0.04 s by short steps."""
    q, v = start(satellite)
    for _ in range(400):
        q, v = compiled.step(q, v, TAU, None, 1e-4, "rk4")
    return np.append(q, v)


SPAN = 0.04
EVERY = [*METHODS.values(), HEUN]


@pytest.mark.parametrize("method", EVERY, ids=str)
def test_every_method_keeps_its_order_and_the_length_of_the_quaternion(satellite, compiled, method):
    reference, errors = _reference(satellite, compiled), []
    for count in (80, 160):
        q, v = start(satellite)
        for _ in range(count):
            q, v = compiled.step(q, v, TAU, None, SPAN / count, method)
        errors.append(np.abs(np.append(q, v) - reference).max())
    assert np.log2(errors[0] / errors[1]) > method.order - 0.35
    assert abs(np.linalg.norm(q[3:7]) - 1) < 1e-15


@pytest.mark.parametrize("method", swept(EVERY, *EVERY[3:]), ids=str)
def test_steps_of_all_back_ends_and_forms_agree(satellite, compiled, method):
    q0, v0 = start(satellite)
    joint, dae = (simulate(satellite, 2e-3, 1e-4, q0, v0, TAU, None, method, form) for form in ("joint", "dae"))
    q, v = q0, v0
    step = satellite.casadi(methods=(HEUN,))[f"step_{method}"]
    a, b = q0, v0
    for _ in range(20):
        q, v = compiled.step(q, v, TAU, None, 1e-4, method)
        a, b = map(flat, step(a, b, TAU, np.zeros((6, 4)), satellite.parameter_values, 1e-4))
    assert relative(np.append(q, v), np.append(joint.q[-1], joint.v[-1])) < 1e-12
    assert relative(np.append(a, b), np.append(joint.q[-1], joint.v[-1])) < 1e-12
    assert relative(dae.q[-1], joint.q[-1]) < {1: 1e-5, 2: 1e-7, 4: 1e-10}[method.order]
    assert abs(np.linalg.norm(a[3:7]) - 1) < 1e-14  # a product of unit quaternions: nothing scales it


def test_momentum_is_conserved_without_forces(satellite, compiled):
    """The change of momentum falls with the order of the method; that of rk4 is rounding and its own error."""
    q0, v0 = start(satellite)
    first = momentum(satellite, q0, v0)
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
