"""The loops of random robots: their rows and multipliers beside the oracle, and bridges that close trees."""

from __future__ import annotations

from types import SimpleNamespace

import casadi as ca
import numpy as np
import random_robots as rr
from oracle import Oracle
from test_loops import roll_pitch_yaw, rows

from screwgen.spec.loops import STABILISATION


class Loops:
    """The loops of a robot beside its oracle: their rows, Jacobian, multipliers and wrenches."""

    def __init__(self, oracle: Oracle, robot: dict):
        self.oracle, n = oracle, oracle.n
        turn, shift = ca.SX.sym("turn", 3, n), ca.SX.sym("shift", 3, n)
        tips = [
            SimpleNamespace(
                tip_R=c.tip_R @ (ca.SX.eye(3) + ca.skew(turn[:, i])), tip_point=c.tip_point + c.tip_R @ shift[:, i]
            )
            for i, c in enumerate(oracle.clouds)
        ]
        ends = SimpleNamespace(q=oracle.q, clouds=tips, section=lambda i, cloud, s: (cloud.tip_R, cloud.tip_point))
        gap = ca.vertcat(*rows(ends, robot))
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


def bridged(rng, robot: dict, state: dict, oracle: Oracle, joint: list, number: int) -> tuple[dict, dict]:
    """The robot with one more loop, closed in this state by a welded bridge between tips that are apart, if any."""
    parents, ends = [-1, *oracle.parents[1:]], [i for i, x in enumerate(robot["links"]) if "_part" not in x["name"]]
    apart = [(i, j) for i in ends for j in ends if i != j and parents[i] != j and parents[j] != i]
    if not apart:
        return robot, state
    i, j = apart[rng.integers(len(apart))]
    poses, names = oracle.poses(state["q"]), [x["name"] for x in robot["links"]]
    R, r = poses["tip_R"][i].T, poses["tip_point"]
    turn = R @ poses["tip_R"][j]
    mount = {"xyz": (R @ (r[j] - r[i]) - 0.1 * turn[:, 0]).tolist(), "rpy": [float(x) for x in roll_pitch_yaw(turn)]}
    bridge = {"name": f"bridge{number}", "length": 0.1, "section": {"rhoA": 2.0}, "parent": names[i]}
    bridge["joint"] = {"axes": [], "mount": mount}
    loop = {"between": [f"bridge{number}.tip", f"{names[j]}.tip"], "joint": {"axes": joint}}
    wrenches = [*state["w_ext"], rr.numbers(rng.normal(size=6))]
    robot = robot | {"links": [*robot["links"], bridge], "loops": [*robot.get("loops", []), loop]}
    return robot, state | {"w_ext": wrenches}
