"""The optimal control problem: Opti, direct collocation or multiple shooting, IPOPT or fatrop."""

from __future__ import annotations

import time
from dataclasses import dataclass

import casadi as ca
import numpy as np
import scipy.linalg

from screwgen import Model

from .arms import LIMIT, PAYLOAD, RATE_GAIN

SCALE = np.r_[np.ones(3), np.full(4, 0.02), np.full(3, 3.0), np.full(4, 0.3)]
"""Sizes of the state [q; v]: rad, m, rad/s, m/s. The unknowns of the problem are the state over these."""
NX, ND = 14, 8
DEGREE = 2
"""Radau points in an interval: third order, and what is too fast for the interval is damped."""
SUBSTEP = 3e-3
"""s: of Runge–Kutta 4 in shooting intervals and in the estimator, at most."""
WEIGHTS = np.r_[100.0, 100.0, 40.0, np.full(4, 100.0), np.full(3, 0.5), np.full(4, 2.0)]
"""Per second: of the squared state about the target."""
TORQUE_WEIGHT = 3.0
"""Per second: of the squared torque about the target's, over the limit."""
TOLERANCE = 1e-6


class Dynamics:
    """`forward_dynamics` of the model as functions of x = [q; v], u, d and p.

    u (3,) N·m: torque before the rate loop, the motor's is u − RATE_GAIN qdot. d (8,): what is wrong with the model,
    joint torques (3, N·m), forces on the tips along y and z (2 × 2, N) and payload (kg, added to that in p).
    """

    def __init__(self, model: Model):
        self.model, self.p = model, np.array(model.parameter_values)
        n = model.nq
        given = x, u, d, p = self.symbols(ca.SX)
        load = ca.SX.zeros(6, 2)
        load[4:6, 0], load[4:6, 1] = d[3:5], d[5:7]
        heavier, payload = ca.SX(p), model.parameter_names.index(PAYLOAD)
        heavier[payload] = p[payload] + d[7]
        vdot, _ = model.casadi()["forward_dynamics"](x[:n], x[n:], u + d[:3], load, heavier)
        self.rate = ca.Function("rate", given, [ca.vertcat(x[n:], vdot)])

    def symbols(self, kind) -> list:
        return [kind.sym(*named) for named in (("x", NX), ("u", 3), ("d", ND), ("p", len(self.p)))]

    def step(self, h: float) -> ca.Function:
        """x after h by Runge–Kutta 4."""
        count = int(np.ceil(h / SUBSTEP - 1e-9))
        given = x, *rest = self.symbols(ca.SX)
        e, f = h / count, self.rate
        k1 = f(x, *rest)
        k2 = f(x + e / 2 * k1, *rest)
        k3 = f(x + e / 2 * k2, *rest)
        one = ca.Function("one", given, [x + e / 6 * (k1 + 2 * k2 + 2 * k3 + f(x + e * k3, *rest))])
        given = x, *rest = self.symbols(ca.MX)
        for _ in range(count):
            x = one(x, *rest)
        return ca.Function("step", given, [x])

    def target(self, joints, d) -> tuple[np.ndarray, np.ndarray]:
        """State (14,) and u (3,) of the model at rest with these joint angles under d: linear in u, Newton in eta."""
        y, size = ca.SX.sym("y", 7), np.r_[np.full(4, 0.02), np.full(3, 100.0)]
        state = lambda y: ca.vertcat(ca.DM(joints), y[:4] * size[:4], ca.DM.zeros(7))  # noqa: E731
        fault = self.rate(state(y), y[4:] * size[4:], d, self.p)[7:] / 100
        found = ca.rootfinder("target", "newton", {"x": y, "g": fault}, {"max_iter": 30})(x0=np.zeros(7))["x"]
        return np.array(state(found)).ravel(), np.array(found).ravel()[4:] * 100.0

    def cost_to_go(self, h: float, x, u, d) -> np.ndarray:
        """(14, 14): the linear quadratic regulator's about the target, which ends the horizon."""
        X, U = ca.MX.sym("x", NX), ca.MX.sym("u", 3)
        end = self.step(h)(X, U, d, self.p)
        A, B = map(np.array, ca.Function("AB", [X, U], [ca.jacobian(end, X), ca.jacobian(end, U)])(x, u))
        return scipy.linalg.solve_discrete_are(A, B, *weights(h))


def weights(h: float) -> tuple[np.ndarray, np.ndarray]:
    return np.diag(WEIGHTS) * h, np.diag(TORQUE_WEIGHT / LIMIT**2) * h


@dataclass(frozen=True)
class Form:
    """How the problem is put and solved."""

    transcription: str
    """"collocation" or "shooting"."""
    solver: str
    """"ipopt" or "fatrop"."""
    h: float = 0.03
    """s: interval, over which u is held, and time between two solves."""
    N: int = 16


@dataclass(frozen=True)
class Solution:
    u: np.ndarray
    """(N, 3)"""
    x: np.ndarray
    """(N + 1, 14)"""
    converged: bool
    iterations: int
    seconds: float
    """Of one core."""
    cost: float


class Problem:
    """The problem in stages (x_k, u_k, collocation states), as fatrop wants them; warm starts by shifting."""

    def __init__(self, dynamics: Dynamics, form: Form, P: np.ndarray):
        self.dynamics, self.form, self.opti = dynamics, form, ca.Opti()
        o, N, points = self.opti, form.N, DEGREE if form.transcription == "collocation" else 0
        self.X, self.U, self.C = [], [], []
        for _ in range(N):
            self.X.append(o.variable(NX))
            self.U.append(o.variable(3))
            self.C += [o.variable(NX, points)] if points else []
        self.X.append(o.variable(NX))
        self.given = [o.parameter(size) for size in (NX, ND, NX, 3)]
        self._constrain(points)
        self._minimise(P)
        self._solver()
        self.last = None

    def _constrain(self, points: int) -> None:
        o, N, (x0, d, _, _) = self.opti, self.form.N, self.given
        every = (ca.repmat(d, 1, N), np.tile(self.dynamics.p[:, None], N))
        X, U = ca.hcat(self.X[:-1]), ca.hcat(self.U)
        if points:
            defects = self._collocation().map(N)(X, ca.hcat(self.C), U, *every)
            ends = [c[:, -1] for c in self.C]
        else:
            sizes = [ca.repmat(ca.DM(s), 1, N) for s in (SCALE, LIMIT)]
            ends = ca.horzsplit(self.dynamics.step(self.form.h).map(N)(X * sizes[0], U * sizes[1], *every) / sizes[0])
        for k in range(N):
            o.subject_to(self.X[k + 1] == ends[k])
            if k == 0:
                o.subject_to(self.X[0] == x0 / SCALE)
            if points:
                o.subject_to(defects[:, k] == 0)
            for x in (self.X[k], *(ca.horzsplit(self.C[k]) if points else ())):
                o.subject_to(o.bounded(-1, self.U[k] - x[7:10] * SCALE[7:10] * RATE_GAIN / LIMIT, 1))

    def _collocation(self) -> ca.Function:
        """The defects (14 · DEGREE,) of one interval, in scaled states."""
        x, u, d, p = self.dynamics.symbols(ca.SX)
        inner = ca.SX.sym("inner", NX, DEGREE)
        C, _, _ = ca.collocation_coeff(ca.collocation_points(DEGREE, "radau"))
        slopes = ca.horzcat(x, inner) @ C
        rate = lambda j: self.dynamics.rate(inner[:, j] * SCALE, u * LIMIT, d, p) / SCALE  # noqa: E731
        defects = [slopes[:, j] - self.form.h * rate(j) for j in range(DEGREE)]
        return ca.Function("defects", [x, inner, u, d, p], [ca.vertcat(*defects)])

    def _minimise(self, P: np.ndarray) -> None:
        (Q, R), (_, _, goal, hold) = weights(self.form.h), self.given
        off = [x * SCALE - goal for x in self.X]
        cost = sum(ca.bilin(Q, e, e) for e in off[:-1]) + ca.bilin(P, off[-1], off[-1])
        self.opti.minimize(cost + sum(ca.bilin(R, e, e) for e in (u * LIMIT - hold for u in self.U)))

    def _solver(self) -> None:
        """IPOPT with the Hessian of the quadratic cost alone (Gauss–Newton); fatrop with the exact one."""
        o, quiet = self.opti, {"print_time": False}
        if self.form.solver == "fatrop":
            o.solver("fatrop", quiet | {"structure_detection": "auto"}, {"print_level": 0, "tol": TOLERANCE})
            return
        names = ["x", "p", "lam_f", "lam_g"]
        lam_f, lam_g = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", o.ng)
        H = ca.triu(ca.hessian(o.f, o.x)[0])
        gauss = ca.Function("nlp_hess_l", [o.x, o.p, lam_f, lam_g], [lam_f * H], names, ["triu_hess_gamma_x_x"])
        warm = {f"warm_start_{name}_push": 1e-6 for name in ("bound", "mult_bound")} | {"mu_init": 1e-3}
        tuning = {"print_level": 0, "sb": "yes", "tol": TOLERANCE, "max_iter": 100, "warm_start_init_point": "yes"}
        o.solver("ipopt", quiet | {"hess_lag": gauss}, tuning | warm)

    def solve(self, x0, d, goal, hold) -> Solution:
        """From the state x0 to the target (goal, hold) under d."""
        for parameter, value in zip(self.given, (x0, d, goal, hold), strict=True):
            self.opti.set_value(parameter, value)
        self._guess(x0, goal, hold)
        start = time.process_time()
        try:
            value = self.opti.solve().value
            converged = True
        except RuntimeError:
            value, converged = self.opti.debug.value, False
        seconds = time.process_time() - start
        self.last = [[np.array(value(v)) for v in part] for part in (self.X, self.U, self.C)]
        x, u = np.array(self.last[0]) * SCALE, np.array(self.last[1]) * LIMIT
        count = int(self.opti.debug.stats().get("iter_count", -1))
        return Solution(u, x, converged, count, seconds, float(value(self.opti.f)))

    def _guess(self, x0, goal, hold) -> None:
        """The last solution, one interval later; at first a straight line."""
        o, N = self.opti, self.form.N
        line = [(x0 + (goal - x0) * k / N) / SCALE for k in range(N + 1)]
        first = [line, [hold / LIMIT] * N, [np.tile(x[:, None], DEGREE) for x in line]]
        parts = self.last or first
        for variables, values in zip((self.X, self.U, self.C), parts, strict=True):
            late = 1 if self.last else 0
            for k, variable in enumerate(variables):
                o.set_initial(variable, values[min(k + late, len(variables) - 1)])
