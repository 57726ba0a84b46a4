"""The loops of random robots: their rows and multipliers beside the oracle, and bridges that close trees."""

from __future__ import annotations

from collections.abc import Container
from types import SimpleNamespace

import casadi as ca
import numpy as np
import random_robots as rr
from oracle import Oracle
from oracle_stations import named

from screwgen.spec.loops import STABILISATION

JOINTS = ([], ["y"], [[0.6, 0.0, 0.8]], ["z", "x"], ["x", "y", "z"], [{"slide": "x"}], [{"slide": "z"}, "z"])
"""What the loops of random robots let go."""


class Loops:
    """The loops of a robot beside its oracle: their rows, Jacobian, multipliers and wrenches."""

    def __init__(self, oracle: Oracle, robot: dict):
        self.oracle, n = oracle, oracle.n
        turn, shift = ca.SX.sym("turn", 3, n), ca.SX.sym("shift", 3, n)

        def section(i, cloud, s: float) -> tuple[ca.SX, ca.SX]:
            """Moved with the tip of its link by a small turn and shift, whose slopes are the wrench on that tip."""
            R, place = cloud.tip_R @ (ca.SX.eye(3) + ca.skew(turn[:, i])), cloud.tip_point + cloud.tip_R @ shift[:, i]
            if s == 1.0:
                return R, place
            R_s, r_s = oracle.section(i, cloud, s)
            return R @ cloud.tip_R.T @ R_s, place + R @ cloud.tip_R.T @ (r_s - cloud.tip_point)

        gap = ca.vertcat(*rows(SimpleNamespace(q=oracle.q, clouds=oracle.clouds, section=section), robot))
        still = lambda x: ca.substitute(x, ca.vertcat(ca.vec(turn), ca.vec(shift)), ca.SX.zeros(6 * n))  # noqa: E731
        wrenches = still(ca.jacobian(gap, ca.vertcat(ca.vec(turn), ca.vec(shift))))
        gap = still(gap)
        G = ca.jacobian(gap, oracle.q)
        rate = G @ oracle.v
        given = [oracle.q, oracle.v]
        self.rows = ca.Function("rows", given, [gap, G, rate, ca.jtimes(rate, oracle.q, oracle.v), wrenches])

    def jacobian(self, q) -> np.ndarray:
        """(rows, nv)."""
        return self.rows(q, np.zeros(self.oracle.nv))[1].full()

    def moving(self, q, v) -> np.ndarray:
        """The rates nearest to `v` that keep the loops closed."""
        G = self.jacobian(q)
        return v - np.linalg.lstsq(G, G @ v, rcond=1e-10)[0]

    def matrix(self, q) -> tuple[np.ndarray, float]:
        """The matrix of accelerations and multipliers, with rows of the loops as large as its other entries."""
        M, G = self.oracle.mass_matrix(q), self.jacobian(q)
        ends = np.linalg.eigvalsh(M)[[0, -1]]
        scale = np.sqrt(abs(ends[0] * ends[1])) / np.maximum(np.linalg.norm(G, axis=1), 1e-12)
        G = scale[:, None] * G
        return np.block([[M, -G.T], [G, np.zeros((len(G),) * 2)]]), scale

    def condition(self, q) -> float:
        """Infinite where no motion changes a row."""
        sizes = np.linalg.norm(self.jacobian(q), axis=1)
        if np.min(sizes) < 1e-9 * np.max(sizes):
            return np.inf
        return float(np.linalg.cond(self.matrix(q)[0]))

    def forward_dynamics(self, q, v, tau, w_ext) -> tuple[np.ndarray, np.ndarray]:
        """`v̇`, and the wrenches (n, 6) of the loops on the tips; with a step of refinement."""
        gap, _, rate, gamma, units = (x.full() for x in self.rows(q, v))
        K, scale = self.matrix(q)
        nv, c = self.oracle.nv, STABILISATION
        wanted = -scale * (gamma + 2 * c * rate + c * c * gap)[:, 0]
        x = np.zeros(len(K))
        for _ in range(3):
            force = self.oracle._force(tau, q) - self.oracle.inverse_dynamics(q, v, x[:nv], w_ext)
            x = x + np.linalg.solve(K, np.append(force - K[:nv, nv:] @ x[nv:], wanted - K[nv:, :nv] @ x[:nv]))
        wrenches = np.split(units.T @ (scale * x[nv:]), 2)
        return x[:nv], np.hstack([w.reshape(-1, 3) for w in wrenches])


def bridge_of(oracle: Oracle, state: dict, i: int, j: int, axes: list, s=1.0, name="bridge") -> tuple[dict, dict]:
    """A link that is welded to the tip of link i and ends at section s of link j, and the loop that joins it there."""
    (R, r), (R_end, end) = (oracle.section_pose(k, state["q"], at) for k, at in ((i, 1.0), (j, s)))
    turn, names = R.T @ R_end, [x["name"] for x in oracle.robot["links"]]
    mount = {"xyz": (R.T @ (end - r) - 0.1 * turn[:, 0]).tolist(), "rpy": [float(x) for x in roll_pitch_yaw(turn)]}
    bridge = {"name": name, "length": 0.1, "section": {"rhoA": 2.0}, "joint": {"axes": [], "mount": mount}}
    marker = "tip" if s == 1.0 else "hook"
    loop = {"between": [f"{name}.tip", f"{names[j]}.{marker}"], "joint": {"axes": axes}}
    return bridge | {"parent": names[i]}, loop


def bridged(
    rng, joint: list, tree: dict, state: dict, oracle: Oracle, s=1.0, name="bridge", among: Container[str] = ()
) -> tuple[dict, dict]:
    """The robot with one more loop, closed in this state by a welded bridge between links that are apart, if any.

    It ends at the tip of a link, or at a marker at `s`. `oracle`: its own, or that of a robot with the same links and
    motions; `among`: the names of links that may be chosen, all if there are none.
    """
    parents, names = [-1, *oracle.parents[1:]], [x["name"] for x in tree["links"]]
    ends = [i for i, x in enumerate(names) if not among or x in among]
    apart = [(i, j) for i in ends for j in ends if i != j and parents[i] != j and parents[j] != i]
    if not apart:
        return tree, state
    i, j = apart[rng.integers(len(apart))]
    bridge, loop = bridge_of(oracle, state, i, j, joint, s, name)
    if s < 1:
        tree["links"][j]["markers"] = [{"name": "hook", "at": s}]
    wrenches = [*state["w_ext"], rr.numbers(rng.normal(size=6))]
    tree = tree | {"links": [*tree["links"], bridge], "loops": [*tree.get("loops", []), loop]}
    return tree, state | {"w_ext": wrenches}


def looped(rng, joint: list, count: int, s: float = 1.0) -> tuple[dict, dict]:
    """A random tree with a loop that is closed in a random state, at the tip of a link or at a marker at `s`."""
    tree, state, oracle = rr.draw_regular(rng, count, branching=0.5, sliding=0.2, drives=0.3, max_modes=1)
    return bridged(rng, joint, tree, state, oracle, s)


def roll_pitch_yaw(R: np.ndarray) -> list[float]:
    """The angles of ``Rz(y) Ry(p) Rx(r)``."""
    return [np.arctan2(R[2, 1], R[2, 2]), -np.arcsin(R[2, 0]), np.arctan2(R[1, 0], R[0, 0])]


def rows(oracle: Oracle, robot: dict) -> list[ca.SX]:
    """The gaps of all rows, written anew from the joint's definition: what a motion of the joint leaves at zero."""
    names, out = [x["name"] for x in robot["links"]], []
    for loop in robot.get("loops", ()):
        ends = ((names.index(name), marker) for name, marker in (end.split(".") for end in loop["between"]))
        places = [(i, named(robot["links"][i], marker)) for i, marker in ends]
        (R_a, a), (R_b, b) = (oracle.section(i, oracle.clouds[i], s) for i, s in places)
        R = R_a.T @ R_b
        d = R_a.T @ (b - a)
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
    axes = [f"{x['name']}.{k}" for x in robot["links"] for k in range(len(x["joint"]["axes"]))]
    for coupling in robot.get("couplings", ()):
        follows, other = (oracle.q[axes.index(plain(coupling[key]))] for key in ("axis", "of"))
        out.append(follows - coupling["ratio"] * other - coupling["offset"])
    return out


def plain(name: str) -> str:
    """`finger.0` of `finger.joint[0]` or `finger.slide[0]`."""
    owner, _, axis = name.partition(".")
    return f"{owner}.{axis.partition('[')[2][:-1]}"


def unit(axis) -> np.ndarray:
    vector = np.eye(3)["xyz".index(axis)] if isinstance(axis, str) else np.array(axis)
    return vector / np.linalg.norm(vector)


def null(directions: list) -> list[np.ndarray]:
    """An orthonormal basis of what is at right angles to these directions."""
    if not directions:
        return list(np.eye(3))
    return list(np.linalg.svd(np.array(directions))[2][len(directions) :])


def names(robot: dict) -> list[str]:
    """The coordinates of all axes that no elastic gear and no transmission drives."""
    found = []
    for x in robot["links"]:
        axes = [] if x["joint"]["axes"] == "ball" else x["joint"]["axes"]
        drives = x["joint"].get("drives") or [{}] * len(axes)
        for k, (axis, drive) in enumerate(zip(axes, drives, strict=True)):
            kind = "slide" if isinstance(axis, dict) and "slide" in axis else "joint"
            if "stiffness" not in drive and "transmission" not in drive:
                found.append(f"{x['name']}.{kind}[{k}]")
    return found


def coupled(rng, robot: dict, state: dict, count: int = 1, among: list[str] | None = None) -> dict:
    """The robot with couplings between random axes, of all or `among` these, that the state satisfies."""
    every = [f"{x['name']}.{k}" for x in robot["links"] for k in range(len(x["joint"]["axes"]))]
    free = names(robot) if among is None else among
    order = rng.permutation(len(free))[: 2 * count]
    couplings = []
    for axis, of in zip(order[::2], order[1::2], strict=False):
        ratio = round(float(rng.uniform(-2, 2)), 3)
        q = {name: state["q"][every.index(plain(name))] for name in (free[axis], free[of])}
        offset = float(q[free[axis]] - ratio * q[free[of]])
        couplings.append({"axis": free[axis], "of": free[of], "ratio": ratio, "offset": offset})
    return robot | {"couplings": couplings}
