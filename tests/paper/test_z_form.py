"""The Z-form: its coordinates, its assembled system and its Cauchy form, against the oracle."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import arm, case_of, example, example_dict, flat, link, model_of, relative
from oracle import part_error
from scipy.integrate import solve_ivp
from z_form_cases import Placed, placed, series

SEEDS = range(700, 708)
every_robot = pytest.mark.parametrize("seed", swept(SEEDS, 702, 703, 704))


def solved(at: Placed) -> np.ndarray:
    M, H, W = at.call("assemble_z")
    return np.linalg.solve(M, W - H)[:, 0]


# -------- the assembled system


@every_robot
def test_solution_equals_lagrange(seed):
    """Joint wrenches, Zdot and etaddot of the Z system against the oracle, which knows neither twist form nor Z."""
    at = placed(seed)
    errors = at.errors(solved(at))
    assert max(errors.values()) <= at.case.tolerance, errors


@every_robot
def test_solution_is_that_of_the_twist_form(seed):
    """Vdot = (I + T_gamma) Zdot + gamma* takes one solution to the other, and the joint form has the same."""
    at = placed(seed)
    T, star = at.change
    M, H, W = at.call("assemble")
    twist_form, mapped = np.linalg.solve(M, W - H)[:, 0], T @ solved(at) + star
    vdot, wrench = at.call("forward_dynamics")
    a, b = (np.hsplit(z[: 12 * at.n].reshape(at.n, 12), 4) for z in (twist_form, mapped))
    for part, companion in ((0, 1), (1, 0), (2, 3), (3, 2)):  # tau and F, angular and linear accelerations
        assert part_error(a[part], b[part], a[companion]) <= at.case.tolerance
    assert part_error(vdot[at.m :, 0], mapped[12 * at.n :], a[2]) <= at.case.tolerance
    assert part_error(wrench.T, np.hstack(b[:2]), wrench) <= at.case.tolerance


@every_robot
def test_system_in_z_is_the_twist_form_times_the_change(seed):
    """M_sys (I + T_gamma), H_sys + M_sys Gamma*, W_sys: the paper's (MsPsi) and (HMs) over all rows."""
    at = placed(seed)
    T, star = at.change
    M, H, W = at.call("assemble")
    M_z, H_z, W_z = at.call("assemble_z")
    assert relative(M_z, M @ T) <= 1e-12
    assert relative(H_z[:, 0], H[:, 0] + M @ star) <= 1e-12
    assert relative(W_z, W) <= 1e-12


@every_robot
def test_pieces_are_those_of_the_paper(seed):
    """T_gamma and Gamma* of the definitions; h_Ms = (M_s + M_DPsi) Gamma*; M_dyn and h_dyn the rows of the system."""
    at = placed(seed)
    T, star = at.change
    size = 12 * at.n
    M, H, _ = at.call("assemble")
    T_gamma, Gamma_star, h_Ms, M_dyn, h_dyn = at.call("z_form")
    assert relative(T_gamma, (T - np.eye(len(T)))[:size, :size]) <= 1e-12
    rounding = 1e-13 * max(1.0, np.abs(at.omega).max()) ** 2  # a link that turns about the origin has no Gamma*
    assert np.abs(Gamma_star[:, 0] - star[:size]).max() <= rounding
    assert np.abs(h_Ms[:, 0] - M[:size, :size] @ star[:size]).max() <= rounding * np.abs(M).max()
    assert relative(M_dyn, M[:size, :size] @ T[:size, :size]) <= 1e-12
    assert relative(h_dyn, h_Ms + H[:size]) <= 1e-12


def differential(at: Placed, M: np.ndarray) -> np.ndarray:
    """Rows and columns of the links' accelerations and of the modes, (Msys_diff)."""
    size = 12 * at.n
    keep = [k for k in range(len(M)) if k >= size or k % 12 >= 6]
    return M[np.ix_(keep, keep)]


@every_robot
def test_symmetric_only_with_the_rows_changed_too(seed):
    """E26: rows dual to V with unknowns Zdot are not symmetric where r_i is not zero; (I + T_gamma)^T M is."""
    at = placed(seed)
    T, _ = at.change
    M = at.call("assemble_z")[0]
    block = differential(at, T.T @ M)
    assert np.abs(block - block.T).max() <= 1e-12 * np.abs(block).max()
    plain = differential(at, M)
    skew = np.abs(plain - plain.T).max() / np.abs(plain).max()
    assert (skew > 1e-3) == (np.abs(at.r).max() > 1e-3), (skew, at.r)


def test_a_frame_at_the_origin_needs_no_change():
    """The other half of E26: with r_1 = 0 the twist and Z form of the block are one, and symmetric as it is."""
    case = case_of(robot := arm(link("only", 0.8, ["y", "z"])), rr.random_state(np.random.default_rng(5), robot))
    at = Placed(case)
    assert np.abs(at.r).max() < 1e-15
    plain = differential(at, at.call("assemble_z")[0])
    assert np.array_equal(plain, differential(at, at.call("assemble")[0]))
    assert np.abs(plain - plain.T).max() == 0


# -------- the state


def test_angles_lie_between_zero_and_half_a_turn():
    """A joint that turns on and on: theta is its angle less whole turns, and jumps in sign at half a turn."""
    model = model_of(arm(link("only", 1.0, "z")))
    for angle in np.linspace(-10, 10, 81):
        theta = flat(model.casadi()["cauchy_state"]([angle], [0.0], model.parameter_values))[:3]
        wrapped = (angle + np.pi) % (2 * np.pi) - np.pi
        assert np.allclose(theta, [0, 0, wrapped], atol=1e-14)
    half = flat(model.casadi()["cauchy_state"]([np.pi], [0.0], model.parameter_values))[:3]
    assert np.isclose(abs(half[2]), np.pi, rtol=1e-15)


@every_robot
def test_state_is_that_of_the_motion(seed):
    """exp(theta_i), r_i, Z_i against the oracle's poses and twists; eta and etadot in their places."""
    at = placed(seed)
    x, n, r = at.x_c, at.n, len(at.q) - at.m
    poses, Z = x[: 6 * n].reshape(n, 6), x[6 * n + r : 12 * n + r].reshape(n, 6)
    for i in range(n):
        assert np.linalg.norm(poses[i, :3]) <= np.pi + 1e-12
        assert np.allclose(series(poses[i, :3])[0], at.R[i], rtol=0, atol=1e-12)
    assert relative(poses[:, 3:], at.r) <= 1e-11
    assert relative(Z, np.c_[at.omega, at.rdot]) <= 1e-11
    assert np.array_equal(x[6 * n : 6 * n + r], at.q[at.m :]) and np.array_equal(x[12 * n + r :], at.v[at.m :])


def test_names_follow_the_state():
    model = example("ella")
    names = model.cauchy_names
    pose = ("theta_x", "theta_y", "theta_z", "r_x", "r_y", "r_z")
    assert names["x_c"][:7] == [*(f"upper_arm.{c}" for c in pose), "forearm.theta_x"]
    assert names["x_c"][12:18] == model.q_names[3:] and names["x_c"][-6:] == model.v_names[3:]
    assert names["x_c"][18:24] == [
        f"upper_arm.{c}" for c in ("omega_x", "omega_y", "omega_z", "rdot_x", "rdot_y", "rdot_z")
    ]
    assert names["q_sys"][6] == "upper_arm.omega_x_rate" and names["q_sys"][21] == "forearm.rdot_x_rate"
    assert len(names["q_sys"]) == len(model.dae_names["z"]) == 30
    for name in ("x_c", "q_sys"):
        assert len(set(names[name])) == len(names[name])


# -------- the Cauchy form


@every_robot
def test_cauchy_form_is_the_rate_of_the_state(seed):
    """A_c x_c + g_c against the derivative of cauchy_state along the oracle's motion: by differentiation, which
    reaches rounding, and by Richardson's central differences, which share nothing with it.
    """
    at = placed(seed)
    A, g, qdot, wrench = at.call("cauchy")
    x_c, p = at.x_c, at.model.parameter_values
    given = A @ x_c + g[:, 0]
    state, n, r = at.model.casadi()["cauchy_state"], at.n, len(at.q) - at.m
    exact = flat(state.jacobian()(at.q, at.v, p, 0)[0] @ at.v + state.jacobian()(at.q, at.v, p, 0)[1] @ at.vdot)
    h = 1e-3 / np.sqrt(1 + np.abs(at.vdot).max())
    along = lambda t: flat(state(at.q + t * at.v + t * t / 2 * at.vdot, at.v + t * at.vdot, p))  # noqa: E731
    coarse, fine = ((along(s) - along(-s)) / (2 * s) for s in (h, h / 2))
    differences = (4 * fine - coarse) / 3
    parts = {"poses": slice(0, 6 * n), "modes": slice(6 * n, 6 * n + r), "Z": slice(6 * n + r, 12 * n + r)}
    for part in (*parts.values(), slice(12 * n + r, None)):
        assert relative(given[part], exact[part]) <= 10 * at.case.tolerance
        assert relative(given[part], differences[part]) <= 1e-5
    assert relative(qdot[:, 0], at.v[: at.m]) <= 1e-10
    assert part_error(at.wrench, wrench.T, at.wrench) <= at.case.tolerance
    assert not np.any(A[:, : 6 * n + r]) and not np.any(A[6 * n + r :]) and not np.any(g[: 6 * n + r])


def test_printed_jacobian_fails():
    """E18 in numbers: with J in place of its inverse A_c misses the rate of theta by a good part of it."""
    at = placed(703)
    last, r = at.n - 1, len(at.q) - at.m
    A = at.call("cauchy")[0]
    theta, omega = at.x_c[6 * last : 6 * last + 3], at.omega[last]
    J = series(theta)[1]
    thetadot = (A @ at.x_c)[6 * last : 6 * last + 3]
    assert np.allclose(J @ thetadot, omega, atol=1e-11)
    assert np.linalg.norm(theta) > 0.3 and np.linalg.norm(J @ omega - thetadot) > 0.1 * np.linalg.norm(thetadot)
    assert np.array_equal(A[3:6, 6 * at.n + r + 3 : 6 * at.n + r + 6], np.eye(3))


SOFT = {"EIy": 80.0, "EIz": 60.0, "GJ": 40.0}
SKEW = arm(
    link("shoulder", 0.7, [[0.2, 0.9, 0.3], "z"], frame_at=0.3, modes={"bending_y": 1, "bending_z": 1}, section=SOFT),
    link("elbow", 0.5, ["y", [0.1, 0.3, 1.0]], modes={"torsion": 1, "bending_z": 1}, section=SOFT),
)


@pytest.mark.parametrize("name", swept(["ella", "skew"], "skew"))
def test_cauchy_form_integrates_to_the_joint_forms_state(name):
    """0.2 s by one adaptive integrator of order eight: both forms end in one state."""
    model = example("ella") if name == "ella" else model_of(SKEW)
    functions, p, m = model.casadi(), model.parameter_values, model.n_joints
    rng = np.random.default_rng(7)
    robot = example_dict("ella") if name == "ella" else SKEW
    state = rr.random_state(rng, robot, angle=0.8, rate=1.0, modal=0.1)
    q, v, tau = (np.array(state[k]) for k in ("q", "v", "tau"))
    w_ext, size = np.array(state["w_ext"]).T, len(model.cauchy_names["x_c"])

    x, y = ca.MX.sym("x", size + m), ca.MX.sym("y", 2 * len(q))
    A, g, qdot, _ = functions["cauchy"](x[:size], x[size:], tau, w_ext, p)
    vdot, _ = functions["forward_dynamics"](*ca.vertsplit(y, len(q)), tau, w_ext, p)
    cauchy = ca.Function("cauchy", [x], [ca.vertcat(A @ x[:size] + g, qdot)])
    joint = ca.Function("joint", [y], [ca.vertcat(y[len(q) :], vdot)])

    def run(rates, begin):
        options = {"method": "DOP853", "rtol": 1e-9, "atol": 1e-11}
        return solve_ivp(lambda _, state: rates(state).full()[:, 0], (0, 0.2), begin, **options).y[:, -1]

    start = np.r_[flat(functions["cauchy_state"](q, v, p)), q[:m]]
    end, reached = np.split(run(joint, np.r_[q, v]), 2), run(cauchy, start)
    expected = flat(functions["cauchy_state"](*end, p))
    assert np.abs(end[0] - q).max() > 0.05
    scale = np.maximum(1.0, np.abs(expected))
    assert np.max(np.abs(reached[:size] - expected) / scale) <= 1e-6
    assert np.allclose(reached[size:], end[0][:m], atol=1e-6)


def test_tendons_pull_in_it():
    """Their tensions are inputs behind the torques; modes accelerate as the joint form says."""
    tendon = {"name": "flexor", "at": [[0.0, 0.02, 0.01], [0.0, 0.01, 0.0]]}
    bends = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}, "tendons": [tendon]}
    model = model_of(arm(link("upper", axes="z", **bends), link("fore", 0.4, "y")))
    f, p, w_ext = model.casadi(), model.parameter_values, np.ones((6, 2))
    q, v = [0.3, -0.4, 0.01, 0.02], [0.1, 0.2, 0.3, -0.1]
    for tension in (0.0, 50.0):
        tau = [0.5, 0.2, tension]
        M, H, W = (x.full() for x in f["assemble_z"](f["cauchy_state"](q, v, p), q[:2], tau, w_ext, p))
        modal = np.linalg.solve(M, W - H).ravel()[-2:]
        expected = model.numpy().forward_dynamics(q, v, tau, w_ext.T)[0][2:]
        assert modal == pytest.approx(expected, rel=1e-10)
