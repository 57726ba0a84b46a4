"""Floating bases: the oracle in other coordinates, Pinocchio, conserved momentum, in all back ends and both forms."""

from functools import cache

import numpy as np
import pytest
from conftest import swept
from helpers import casadi_forward, flat, model_of, quick, relative, rotation_of
from oracle_floating import FloatingCase, draw
from oracle_robots import pinocchio_model
from scipy.spatial.transform import Rotation

from screwgen import UsageError, equilibrium, rollout, simulate
from screwgen.backends.numpy.dae_step import space_of
from screwgen.integrators import METHODS, Method, Move, Stage
from screwgen.studies.modes import natural_frequencies

HEUN = Method("heun", 2, (Stage(), Stage([1])), Move(["1/2", "1/2"]), "Heun's method, two forward dynamics")
SECTION = {"rhoA": 1.5, "EIy": 60.0, "EIz": 80.0, "rhoIp": 1e-3}
HULL = {"at": "base", "mass": 8.0, "com": [0.1, 0.05, 0.0], "inertia": [0.5, 0.6, 0.7, 0.02, 0.0, 0.0]}


def rod(name: str, axes: list, **more) -> dict:
    joint = {"axes": axes, **({"mount": more.pop("mount")} if "mount" in more else {})}
    modes = {"bending_y": 1, "bending_z": 1}
    return {"name": name, "length": 0.7, "section": SECTION, "modes": modes, "joint": joint, **more}


SATELLITE = {
    "name": "satellite",
    "gravity": [0.0, 0.0, 0.0],
    "base": "floating",
    "links": [
        {"name": "hull", "joint": {"axes": []}, "bodies": [HULL]},
        rod("left", ["z"], parent="hull", mount={"xyz": [0.0, 0.3, 0.0]}),
        rod("left_fore", ["y"]),
        rod("right", ["z", "x"], parent="hull", mount={"xyz": [0.0, -0.3, 0.0]}),
    ],
}


@pytest.fixture(scope="module")
def satellite():
    return model_of(SATELLITE)


def start(model, rate=0.3) -> tuple[np.ndarray, np.ndarray]:
    """A posture and rates without pattern."""
    rng, chain = np.random.default_rng(3), model.chain
    q, v = np.array(chain.home), rate * rng.normal(size=chain.nv)
    q[:3], q[3:7] = rng.normal(size=3), Rotation.random(random_state=3).as_quat(scalar_first=True)
    q[7 : chain.eta_q] = rng.uniform(-1, 1, chain.n_joints)
    q[chain.eta_q :], v[chain.eta_v :] = 0.01 * rng.normal(size=chain.n_modes), 0.05 * rng.normal(size=chain.n_modes)
    return q, v


def momentum(model, q, v) -> np.ndarray:
    """Angular momentum about the inertial origin, and linear momentum, in inertial axes: of the base's rows of M v."""
    h = (model.numpy().mass_matrix(q) @ v)[:6]
    R = rotation_of(q[3:7])
    return np.concatenate([R @ h[:3] + np.cross(q[:3], R @ h[3:]), R @ h[3:]])


def drift(model, run) -> float:
    """The change of momentum over a run, relative."""
    first, last = (momentum(model, run.q[k], run.v[k]) for k in (0, -1))
    parts = ((first[s], last[s]) for s in (np.s_[:3], np.s_[3:]))
    return max(np.linalg.norm(b - a) / np.linalg.norm(a) for a, b in parts)


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
    assert numeric.energy(q, v) == pytest.approx(oracle.energy(robot.state["q"], robot.state["v"]), rel=1e-11, abs=1e-11)
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


@pytest.mark.parametrize("layout", ["fused", "modular"])
@pytest.mark.parametrize("seed", swept(range(12), 3))
def test_compiled_c_equals_the_oracle_in_both_forms(layout, seed):
    robot = random_robot(seed)
    compiled = quick(robot.model, layout=layout)
    for form in ("joint", "dae"):
        assert max(robot.errors(*compiled.forward_dynamics(*robot.given, form)).values()) < robot.tolerance
    assert relative(compiled.mass_matrix(robot.given[0]), robot.model.numpy().mass_matrix(robot.given[0])) < 1e-12


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
