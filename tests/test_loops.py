"""Closed loops: against the constrained equations of the oracle, closed forms of linkages, and conservation laws."""

import casadi as ca
import numpy as np
import pytest
import random_robots as rr
from helpers import arm, casadi_forward, link, model_of
from oracle import Oracle

from screwgen import RobotFileError, simulate
from screwgen.backends.numpy.closing import closed, jacobian, moving
from screwgen.spec.loops import STABILISATION

JOINTS = ([], ["y"], [[0.6, 0.0, 0.8]], ["z", "x"], ["x", "y", "z"], [{"slide": "x"}], [{"slide": "z"}, "z"])


def looped(rng, joint: list, count: int) -> tuple[dict, dict]:
    """A random tree with a loop that is closed in a random state: a welded bridge leads from one tip to another."""
    tree, state, oracle = rr.draw_regular(rng, count, branching=0.5, sliding=0.2, max_modes=1)
    parents = [-1, *oracle.parents[1:]]
    apart = [(i, j) for i in range(count) for j in range(count) if i != j and parents[i] != j and parents[j] != i]
    i, j = apart[rng.integers(len(apart))] if apart else (0, count - 1)
    poses = oracle.poses(state["q"])
    R, r = poses["tip_R"][i].T, poses["tip_point"]
    turn = R @ poses["tip_R"][j]
    mount = {"xyz": (R @ (r[j] - r[i]) - 0.1 * turn[:, 0]).tolist(), "rpy": roll_pitch_yaw(turn)}
    names = [x["name"] for x in tree["links"]]
    bridge = {"name": "bridge", "length": 0.1, "section": {"rhoA": 2.0}, "joint": {"axes": [], "mount": mount}}
    bridge["parent"] = names[i]
    loop = {"between": ["bridge.tip", f"{names[j]}.tip"], "joint": {"axes": joint}}
    wrenches = [*state["w_ext"], rng.normal(size=6).tolist()]
    return tree | {"links": [*tree["links"], bridge], "loops": [loop]}, state | {"w_ext": wrenches}


def roll_pitch_yaw(R: np.ndarray) -> list[float]:
    """The angles of ``Rz(y) Ry(p) Rx(r)``."""
    return [np.arctan2(R[2, 1], R[2, 2]), -np.arcsin(R[2, 0]), np.arctan2(R[1, 0], R[0, 0])]


def rows(oracle: Oracle, robot: dict) -> list[ca.SX]:
    """The gaps of all rows, written anew from the joint's definition: what a motion of the joint leaves at zero."""
    names, out = [x["name"] for x in robot["links"]], []
    for loop in robot["loops"]:
        a, b = (oracle.clouds[names.index(end.removesuffix(".tip"))] for end in loop["between"])
        R = a.tip_R.T @ b.tip_R
        d = a.tip_R.T @ (b.tip_point - a.tip_point)
        axes = loop["joint"]["axes"]
        slides = [unit(x["slide"]) for x in axes if isinstance(x, dict)]
        turns = [unit(x) for x in axes if not isinstance(x, dict)]
        out += [ca.dot(n, d) for n in null(slides)]
        match turns:
            case []:
                out += [R[1, 2], R[2, 0], R[0, 1]]
            case [x]:
                out += [ca.dot(n, R @ x) for n in null([x])]
            case [x, y]:
                out.append(ca.dot(x, R @ y) - x @ y)
    return out


def unit(axis) -> np.ndarray:
    vector = np.eye(3)["xyz".index(axis)] if isinstance(axis, str) else np.array(axis)
    return vector / np.linalg.norm(vector)


def null(directions: list) -> list[np.ndarray]:
    """An orthonormal basis of what is at right angles to these directions."""
    if not directions:
        return list(np.eye(3))
    return list(np.linalg.svd(np.array(directions))[2][len(directions) :])


def constrained(oracle: Oracle, robot: dict, state: dict) -> np.ndarray:
    """`v̇` of the oracle's mass matrix and bias with its own rows, stabilised, by Lagrange multipliers (least squares)."""
    gap = ca.vertcat(*rows(oracle, robot))
    G = ca.jacobian(gap, oracle.q)
    rate = G @ oracle.v
    f = ca.Function("rows", [oracle.q, oracle.v], [gap, G, rate, ca.jtimes(rate, oracle.q, oracle.v)])
    q, v, tau, w_ext = (np.array(state[k]) for k in ("q", "v", "tau", "w_ext"))
    gap, G, rate, gamma = (x.full() for x in f(q, v))
    M, h = oracle.mass_matrix(q), oracle.bias(q, v, w_ext)
    free = np.linalg.solve(M, np.r_[tau, np.zeros(oracle.nv - oracle.n_joint)] - h)
    c = STABILISATION
    wanted = -(gamma + 2 * c * rate + c * c * gap)[:, 0] - G @ free
    inertia = G @ np.linalg.solve(M, G.T)
    return free + np.linalg.solve(M, G.T @ np.linalg.lstsq(inertia, wanted, rcond=1e-12)[0])


@pytest.mark.parametrize("opened", [0.0, 0.02], ids=["closed", "open"])
@pytest.mark.parametrize("seed", range(len(JOINTS)))
def test_random_trees_with_a_loop(seed, opened):
    """Where a loop is open both have the same stabilisation."""
    rng = np.random.default_rng([901, seed])
    robot, state = looped(rng, JOINTS[seed], 3 + seed % 3)
    model, oracle = model_of(robot), Oracle(robot)
    judge = model.numpy()
    q = np.array(state["q"])
    assert np.max(np.abs(judge.gaps(q, None)[0])) < 1e-12
    v = np.array(state["v"]) if opened else moving(judge, q, state["v"])
    state |= {"q": q + opened * rng.normal(size=len(q)) * (np.arange(len(q)) < oracle.n_joint), "v": v}
    expected = constrained(oracle, robot, state)
    given = state["q"], state["v"], state["tau"], state["w_ext"]
    found, wrench = judge.forward_dynamics(*given)
    scale = np.max(np.abs(expected))
    assert np.max(np.abs(found - expected)) < 1e-9 * scale
    assert np.max(np.abs(casadi_forward(model, *given)[0] - expected)) < 1e-9 * scale
    loads = np.array(state["w_ext"]) + judge.loop_wrenches(*given)
    expected_wrench = oracle.wrenches(state["q"], state["v"], found, loads)
    assert np.max(np.abs(wrench - expected_wrench)) < 1e-9 * np.max(np.abs(expected_wrench))
    dae = judge.dae_forward_dynamics(*given)
    assert np.max(np.abs(dae[0] - expected)) < 1e-9 * scale
    assert np.max(np.abs(dae[1] - expected_wrench)) < 1e-9 * np.max(np.abs(expected_wrench))
