"""The DAE form: the joint wrenches are unknowns of the problem, and one of their components is bounded."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

import screwgen
from screwgen import Modes

from .arms import GOAL, LIMIT, STEP, Arms, arm, at_rest
from .attempt import attempt
from .loop import Motion, run

COMPONENT = "forearm.tau_y"
"""The bending moment at the elbow across its axis, N·m: no motor acts there, so no torque limit bounds it."""
BOUND, PLANNED = 60.0, 35.0
"""N·m: on the plant's moment, and what the plan keeps to, as the plant's payload is heavier than the model's."""
DEGREE = 2
MOVE, N = 0.8, 12
"""s: duration of the plan, and its intervals, over which torques are held."""
KP, KD = np.array([400.0, 800.0, 150.0]), np.array([60.0, 100.0, 20.0])
"""Of the tracking in the plant, N·m/rad and N·m·s/rad."""
WRENCHES = np.tile(np.r_[np.full(6, 100.0), np.full(6, 20.0)], 2)
X_SIZE = np.r_[np.ones(14), np.full(4, 0.02), np.full(12, 2.0), np.full(4, 0.3), np.ones(3)]
Z_SIZE = np.r_[WRENCHES, np.full(4, 20.0)]
ROW_SIZE = 50.0
"""Sizes of x, z (`model.dae_names`) and of the rows of `alg`."""


@dataclass(frozen=True)
class Plan:
    """A motion from rest to rest."""

    u: np.ndarray
    """(N, 3) N·m"""
    q: np.ndarray
    """(N + 1, 3) rad: joint coordinates at the intervals' ends."""
    moment: np.ndarray
    """(N · DEGREE,) N·m: the bounded component at the Radau points."""
    converged: bool
    iterations: int
    seconds: float


class Planner:
    """Unknowns: x (37) at the ends and Radau points of the intervals, z (28) at the Radau points, torques.

    Constraints: collocation of `ode`, and the rows `alg` = M_sys z + H_sys − W_sys = 0 at every Radau point.
    """

    def __init__(self):
        self.model = screwgen.derive(arm(Modes(bending_y=1, bending_z=1)))
        self.p = np.array(self.model.parameter_values)
        self.column = self.model.dae_names["z"].index(COMPONENT)
        self.ends = [at_rest(self.model, joints, self.p) for joints in (np.zeros(3), GOAL)]

    def state(self, share: float) -> np.ndarray:
        """x (37,) at rest, on the straight line between the ends' coordinates, over `X_SIZE`."""
        (start, _), (end, _) = self.ends
        x = self.model.casadi()["dae_state"](start + share * (end - start), np.zeros(7), self.p)
        return np.array(x).ravel() / X_SIZE

    def defects(self) -> ca.Function:
        """What must vanish in an interval, scaled: collocation (37) and algebraic rows (28) for each point."""
        dae, (x, u) = self.model.casadi()["dae"], (ca.SX.sym("x", 37), ca.SX.sym("u", 3))
        f = ca.Function("f", [dae[k] for k in "xzup"], [dae["ode"], dae["alg"]])
        inner, z, rows = ca.SX.sym("inner", 37, DEGREE), ca.SX.sym("z", 28, DEGREE), []
        C, _, _ = ca.collocation_coeff(ca.collocation_points(DEGREE, "radau"))
        slopes = ca.horzcat(x, inner) @ C
        for j in range(DEGREE):
            ode, alg = f(inner[:, j] * X_SIZE, z[:, j] * Z_SIZE, ca.vertcat(u * LIMIT, ca.DM.zeros(12)), self.p)
            rows += [slopes[:, j] - MOVE / N * ode / X_SIZE, alg / ROW_SIZE]
        return ca.Function("defects", [x, inner, z, u], [ca.vertcat(*rows)])

    def plan(self, bound: float | None) -> Plan:
        """The move in `MOVE`, its vibrations and torques weighed; with a bound, |`COMPONENT`| keeps to it."""
        o = ca.Opti()
        X = [o.variable(37) for _ in range(N + 1)]
        inner, Z, U = ([o.variable(r, c) for _ in range(N)] for r, c in ((37, DEGREE), (28, DEGREE), (3, 1)))
        o.subject_to(self.defects().map(N)(*map(ca.hcat, (X[:-1], inner, Z, U))) == 0)
        o.subject_to(X[0] == self.state(0.0))
        for k in range(N):
            o.subject_to(X[k + 1] == inner[k][:, -1])
            o.subject_to(o.bounded(-1, U[k], 1))
            if bound is not None:
                size = bound / Z_SIZE[self.column]
                o.subject_to(o.bounded(-size, Z[k][self.column, :].T, size))
        o.minimize(self.cost(X, U))
        for k in range(N):
            o.set_initial(X[k], self.state(k / N))
            o.set_initial(inner[k], np.tile(self.state((k + 0.5) / N)[:, None], DEGREE))
            o.set_initial(U[k], self.hold(k / N) / LIMIT)
        o.set_initial(X[N], self.state(1.0))
        o.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes", "max_iter": 150, "tol": 1e-6})
        return self.solved(o, X, Z, U)

    def hold(self, share: float) -> np.ndarray:
        (_, start), (_, end) = self.ends
        return start + share * (end - start)

    def cost(self, X, U):
        """Squares of joint angles (34:37), modes (14:18), twists and modal rates (18:34) and torques about the goal."""
        goal, total = self.state(1.0) * X_SIZE, 0
        weights = np.r_[np.zeros(14), np.full(4, 100.0), np.full(12, 0.5), np.full(4, 2.0), np.full(3, 100.0)]
        for k, x in enumerate(X):
            e = x * X_SIZE - goal
            w = (
                weights * MOVE / N
                if k < N
                else np.r_[np.zeros(14), np.full(4, 50.0), np.full(16, 5.0), np.full(3, 50.0)]
            )
            total += ca.dot(w, e * e)
        return total + MOVE / N * sum(ca.sumsqr(u - self.hold(1.0) / LIMIT) for u in U)

    def solved(self, o: ca.Opti, X, Z, U) -> Plan:
        value, converged, count, seconds = attempt(o)
        moment = np.array([value(z)[self.column] for z in Z]).ravel() * Z_SIZE[self.column]
        u, q = np.array([value(u) for u in U]) * LIMIT, np.array([value(x)[34:37] for x in X])
        return Plan(u, q, moment, converged, count, seconds)


def follow(arms: Arms, plan: Plan, duration: float) -> tuple[Motion, np.ndarray]:
    """The plant under the plan's torques and a PD law about its joint angles, and its moment (N,), N·m.

    The moment is that of `forward_dynamics` of the generated C. The plan's torques are those of the lighter payload.
    """
    (_, hold), times = arms.rest(GOAL), np.linspace(0, MOVE, N + 1)
    slopes = np.gradient(plan.q, times, axis=0)

    def torque(k: int, q, v) -> np.ndarray:
        t = k * STEP
        at = [np.array([np.interp(t, times, column) for column in part.T]) for part in (plan.q, slopes)]
        feed = plan.u[int(t / MOVE * N)] if t < MOVE - 1e-9 else hold
        rate = at[1] if t < MOVE else 0.0
        return feed + KP * (at[0] - q[:3]) + KD * (rate - v[:3])

    motion, free = run(arms, torque, duration), np.zeros((2, 6))
    rows = zip(motion.q, motion.v, motion.tau, strict=True)
    return motion, np.array([arms.compiled.forward_dynamics(*row, free)[1][1, 1] for row in rows])
