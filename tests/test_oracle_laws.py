"""The judge is judged: laws that hold on any robot, and the random robots on which it judges."""

import tomllib

import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from oracle import Oracle
from oracle_robots import SEEDS, G, arm, regular, relative, rod
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

every_robot = pytest.mark.parametrize("seed", swept(SEEDS, *SEEDS[:4]))

# -------- laws, on random robots


def difference(function, h: float = 1e-4):
    """Fourth-order central difference of function(s) at s = 0."""
    return (function(-2 * h) - 8 * function(-h) + 8 * function(h) - function(2 * h)) / (12 * h)


@every_robot
def test_lagrange_equals_dalembert(seed):
    _, state, oracle = regular(seed)
    q, v, w = state["q"], state["v"], state["w_ext"]
    vdot = np.random.default_rng(seed).normal(size=oracle.nv)
    force = oracle.inverse_dynamics(q, v, vdot, w)
    assert relative(oracle.virtual_power_dynamics(q, v, vdot, w), force) < 1e-12


@every_robot
def test_energy_balance(seed):
    """d/dt(T + U) is the power of motors and tip wrenches less that of the dampers."""
    _, state, oracle = regular(seed)
    vdot, _ = oracle.forward_dynamics(**state)
    rate, power = oracle.energy_rate(state["q"], state["v"], vdot), oracle.power(**state)
    flow = np.abs(oracle.mass_matrix(state["q"]) @ vdot) @ np.abs(state["v"]) + abs(power)
    assert abs(rate - power) < 1e-10 * max(1.0, flow)


@every_robot
def test_mass_matrix_is_the_hessian_of_kinetic_energy(seed):
    _, state, oracle = regular(seed)
    M = oracle.mass_matrix(state["q"])
    v, w = np.array(state["v"]), np.random.default_rng(seed).normal(size=oracle.nv)
    assert np.allclose(M, M.T, rtol=0, atol=1e-14 * np.abs(M).max())
    assert np.linalg.eigvalsh(M).min() > 0
    assert np.isclose(oracle.energy(state["q"], v)[0], v @ M @ v / 2, rtol=1e-12)
    zero = np.zeros(oracle.nv)
    difference = oracle.inverse_dynamics(state["q"], zero, w) - oracle.bias(state["q"], zero)
    assert relative(difference, M @ w) < 1e-10


@every_robot
def test_joint_wrenches_fulfil_the_completed_joint_rows(seed):
    """A^T τ_w = τ - J_m q̈ - b q̇ - k q: momentum balance and Lagrange's equations meet."""
    _, state, oracle = regular(seed)
    q, v = np.array(state["q"]), np.array(state["v"])
    vdot, wrench = oracle.forward_dynamics(**state)
    axial = oracle.armature * vdot + oracle.damping * v + oracle.K @ q
    for i, joint in enumerate(oracle.joint_slices):
        expected = np.array(state["tau"])[joint] - axial[joint]
        error = oracle.joint_axes(i, q).T @ wrench[i, :3] - expected
        tolerance = max(1e-11, 5e-15 * oracle.condition(q))
        scale = max(np.abs(wrench).max(), np.abs(axial).max(initial=0))
        assert np.max(np.abs(error), initial=0) < tolerance * scale


@every_robot
def test_twists_are_rates_of_poses(seed):
    _, state, oracle = regular(seed)
    q, v = np.array(state["q"]), np.array(state["v"])
    here = oracle.poses(q)
    for frame, point, twists in (
        ("R", "origin", oracle.link_twists(q, v)),
        ("tip_R", "tip_point", oracle.tip_twists(q, v)),
    ):
        inverse = np.swapaxes(here[frame], 1, 2)
        spin = inverse @ difference(lambda s, name=frame: oracle.poses(q + s * v)[name])
        omega = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1)
        velocity = difference(lambda s, name=point: oracle.poses(q + s * v)[name])
        assert np.allclose(omega, twists[:, :3], atol=1e-6)
        assert np.allclose(np.einsum("nij,nj->ni", inverse, velocity), twists[:, 3:], atol=1e-6)


@pytest.mark.parametrize("seed", range(4))
def test_twist_rates_are_rates_of_twists(seed):
    _, state, oracle = regular(seed)
    q, v = np.array(state["q"]), np.array(state["v"])
    vdot = np.random.default_rng(seed).normal(size=oracle.nv)
    rate = difference(lambda s: oracle.link_twists(q + s * v + s * s / 2 * vdot, v + s * vdot))
    assert np.allclose(rate, oracle.link_twist_rates(q, v, vdot), atol=1e-5)


def test_energy_is_conserved_by_integration():
    """A soft, undamped two-link arm with torsion, left alone for 0.1 s."""
    rng = np.random.default_rng(3)
    limits = {"rigid": 0.0, "welded": 0.0, "soft": 1.0, "torsion": 1.0, "material": 0.0}
    _, state, oracle = rr.draw_regular(rng, 2, limit=1e6, **limits)
    oracle.damping[:] = 0.0
    n = oracle.nv

    def slope(t, x):
        return np.concatenate([x[n:], oracle.forward_dynamics(x[:n], x[n:])[0]])

    start = np.concatenate([state["q"], state["v"]])
    end = solve_ivp(slope, (0, 0.1), start, method="DOP853", rtol=1e-10, atol=1e-10).y[:, -1]
    before, after = (oracle.energy(x[:n], x[n:]) for x in (start, end))
    assert abs(before[0] - after[0]) > 1e-3 * before[0]
    assert np.isclose(sum(before), sum(after), rtol=1e-7)


def test_momentum_about_a_free_vertical_axis_is_kept():
    rng = np.random.default_rng(11)
    robot = rr.random_robot(rng, 3, no_gravity=1.0, armature=0.0)
    robot["links"][0]["joint"] = {"axes": ["z"]}
    oracle, state = Oracle(robot), rr.random_state(rng, robot)
    q, v = np.array(state["q"]), np.array(state["v"])
    vdot, wrench = oracle.forward_dynamics(q, v, np.concatenate([[0.0], state["tau"][1:]]))
    rate = difference(lambda s: oracle.momentum(q + s * v + s * s / 2 * vdot, v + s * vdot)[1], 1e-5)
    scale = np.abs(rate).max()
    assert abs(rate[2]) < 1e-6 * scale
    assert np.allclose(rate, oracle.poses(q)["R"][0] @ wrench[0, :3], rtol=1e-4, atol=1e-6 * scale)


# -------- random robots


@pytest.mark.parametrize("seed", range(20))
def test_robot_files_read_back(seed):
    robot = rr.random_robot(np.random.default_rng(seed))
    assert tomllib.loads(rr.to_toml(robot)) == robot


def test_draws_cover_every_feature():
    rng = np.random.default_rng(0)
    robots = [rr.random_robot(rng) for _ in range(200)]
    links = [link for robot in robots for link in robot["links"]]
    assert {len(link["joint"]["axes"]) for link in links} == {0, 1, 2, 3}
    assert {len(robot["links"]) for robot in robots} == {1, 2, 3, 4, 5}
    joint_keys = {"axes", "mount", "armature", "damping", "stiffness"}
    assert {key for link in links for key in link["joint"]} == joint_keys
    assert {key for link in links for key in link} >= {"modes", "bodies", "damping", "frame_at"}
    assert {"density", "rhoA", "rhoIp", "GJ", "G"} <= {key for link in links for key in link["section"]}
    assert {robot.get("section_rotation") for robot in robots} == {True, False, None}
    bases = {None, "clamped_free", "polynomial"}
    assert {link["modes"].get("basis") for link in links if link.get("modes")} == bases
    assert {n for link in links for d, n in link.get("modes", {}).items() if d != "basis"} == {0, 1, 2, 3, 4}


def test_states_are_moderate():
    rng = np.random.default_rng(0)
    for _ in range(10):
        robot = rr.random_robot(rng)
        oracle, poses = Oracle(robot), Oracle(robot).poses(rr.random_state(rng, robot)["q"])
        for i, link in enumerate(oracle.links):
            bend = Rotation.from_matrix(poses["R"][i].T @ poses["tip_R"][i]).magnitude()
            straight = poses["origin"][i] + poses["R"][i] @ [link.a + link.length, 0, 0]
            assert bend < 0.6
            assert np.linalg.norm(poses["tip_point"][i] - straight) < 0.2 * link.length


@pytest.mark.parametrize(
    "states",
    [rr.undeformed_state, rr.tiny_state, rr.huge_angle_state, lambda rng, robot: rr.rest_state(robot)],
    ids=["undeformed", "tiny", "huge_angle", "rest"],
)
@pytest.mark.parametrize("robots", swept([rr.random_robot, rr.heavy_payload_robot, rr.slender_robot], rr.random_robot))
def test_extreme_draws_are_judged(robots, states):
    _, state, oracle = rr.draw_regular(np.random.default_rng(2), robots=robots, states=states, limit=1e12)
    vdot, wrench = oracle.forward_dynamics(**state)
    assert np.all(np.isfinite(vdot))
    assert np.all(np.isfinite(wrench))
    q, v, w = state["q"], state["v"], state["w_ext"]
    lagrange, dalembert = oracle.inverse_dynamics(q, v, vdot, w), oracle.virtual_power_dynamics(q, v, vdot, w)
    assert np.allclose(lagrange, dalembert, rtol=0, atol=1e-9 * np.abs(wrench).max() + 1e-9)


def test_welded_rigid_arm_has_no_coordinates():
    """Nothing to solve, yet the welds carry the weight."""
    robot = arm(rod(0.5, 2.0, []), rod(0.5, 2.0, []), gravity=(0, 0, -G))
    vdot, wrench = Oracle(robot).forward_dynamics([], [], [], None)
    assert vdot.shape == (0,)
    assert np.allclose(wrench, [[0, -2 * G * 0.5, 0, 0, 0, 2 * G], [0, -G * 0.25, 0, 0, 0, G]])


def test_errors_are_measured_part_by_part():
    _, state, oracle = regular(1, rigid=0.0)
    vdot, wrench = oracle.forward_dynamics(**state)
    assert set(oracle.errors(state, vdot, wrench).values()) == {0.0}
    vdot[: oracle.n_joint] *= 1 + 1e-6
    errors = oracle.errors(state, vdot, wrench)
    assert errors["etadd"] == errors["F"] == errors["tau"] == 0
    assert 0 < errors["qdd"] < 1.1e-6
