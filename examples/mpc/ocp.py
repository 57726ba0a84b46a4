"""The problem of a sample, converged: to follow the plan; Opti, direct collocation, IPOPT. The judge and the ghost."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import casadi as ca
import numpy as np
import scipy.linalg

from screwgen import Model

from .arms import LIMIT, PAYLOAD, at_rest_there
from .attempt import attempt

DEGREE = 2
"""Radau points in an interval: third order, and what is too fast for the interval is damped."""
SUBSTEP = 1e-3
"""s: of Runge–Kutta 4 in the prediction over the delay, at most."""
TIP_WEIGHT = 300.0
"""Per second and m²: of the tip's distance from the plan's, linearised at the goal."""
JOINTS, MODES, JOINT_RATES, MODE_RATES = 1.0, 1.0, 0.02, 0.2
"""Per second: weights of the squared coordinates and rates about the plan's."""
TORQUE_WEIGHT = 0.03
"""Per second: of the squared torque about the plan's, over the limit."""
TOLERANCE = 1e-6


class Dynamics:
    """`forward_dynamics` of the model as functions of x = [q; v], the motors' torques u (3,) and `extra`.

    `extra` (kg) is the payload beyond the file's: what the controller finds out.
    """

    def __init__(self, model: Model):
        self.model, self.p, self.nx = model, np.array(model.parameter_values), 2 * model.nq
        self.at, n, modes = model.parameter_names.index(PAYLOAD), model.nq, model.nq - 3
        self.size = np.r_[np.ones(3), np.full(modes, 0.02), np.full(3, 3.0), np.full(modes, 0.3)]
        given = x, u, extra = self.symbols(ca.SX)
        p = ca.SX(self.p)
        p[self.at] += extra
        functions = model.casadi()
        vdot, _ = functions["forward_dynamics"](x[:n], x[n:], u, np.zeros((6, 2)), p)
        self.rate = ca.Function("rate", given, [ca.vertcat(x[n:], vdot)])
        self.tip = ca.Function("tip", [x, extra], [functions["tip_pose"](x[:n], p)[1]])

    def symbols(self, kind) -> list:
        return [kind.sym(*named) for named in (("x", self.nx), ("u", 3), ("extra", 1))]

    def parameters(self, extra: float) -> np.ndarray:
        p = self.p.copy()
        p[self.at] += extra
        return p

    def defects(self) -> ca.Function:
        """What must vanish in an interval of h seconds: (nx · DEGREE,) from x, inner states, u over `LIMIT`, extra, h.

        States are over `size`.
        """
        x, u, extra = self.symbols(ca.SX)
        inner, h = ca.SX.sym("inner", self.nx, DEGREE), ca.SX.sym("h")
        C, _, _ = ca.collocation_coeff(ca.collocation_points(DEGREE, "radau"))
        slopes = ca.horzcat(x, inner) @ C
        rate = lambda j: self.rate(inner[:, j] * self.size, u * LIMIT, extra) / self.size  # noqa: E731
        rows = [slopes[:, j] - h * rate(j) for j in range(DEGREE)]
        return ca.Function("defects", [x, inner, u, extra, h], [ca.vertcat(*rows)])

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

    def rest_there(self, place, extra: float) -> tuple[np.ndarray, np.ndarray]:
        """State (nx,) and torques (3,) of the model at rest with its tip at `place` (3,)."""
        q, hold = at_rest_there(self.model, place, self.parameters(extra))
        return np.append(q, np.zeros(self.model.nq)), hold

    def weights(self, place, extra: float) -> tuple[np.ndarray, np.ndarray]:
        """Q (nx, nx), per second, and the linear quadratic regulator's cost-to-go P (nx, nx) at rest at `place`."""
        n, (x, hold) = self.model.nq, self.rest_there(place, extra)
        linear = self.model.linearise(x[:n], x[n:], hold, parameters=self.parameters(extra), outputs=("tip_position",))
        own = [np.full(3, JOINTS), np.full(n - 3, MODES), np.full(3, JOINT_RATES), np.full(n - 3, MODE_RATES)]
        Q = TIP_WEIGHT * linear.C.T @ linear.C + np.diag(np.concatenate(own))
        return Q, scipy.linalg.solve_continuous_are(linear.A, linear.B, Q, np.diag(TORQUE_WEIGHT / LIMIT**2))


@dataclass(frozen=True)
class Form:
    """The horizon of the problem."""

    h: float = 0.02
    """s: interval, over which u is held, and time between two solves."""
    N: int = 6


@dataclass(frozen=True)
class Solution:
    u: np.ndarray
    """(N, 3) N·m"""
    x: np.ndarray
    """(N + 1, nx)"""
    converged: bool
    iterations: int
    seconds: float
    """Of one core."""
    cost: float


class Problem:
    """The problem in stages (x_k, u_k, collocation states); warm starts by shifting."""

    def __init__(self, dynamics: Dynamics, form: Form, Q: np.ndarray, P: np.ndarray):
        self.dynamics, self.form, self.opti = dynamics, form, ca.Opti()
        o, N, nx = self.opti, form.N, dynamics.nx
        self.X, self.U, self.C = [], [], []
        for _ in range(N):
            self.X.append(o.variable(nx))
            self.U.append(o.variable(3))
            self.C.append(o.variable(nx, DEGREE))
        self.X.append(o.variable(nx))
        self.given = [o.parameter(*size) for size in ((nx, 1), (1, 1), (nx, N + 1), (3, N))]
        self._constrain()
        self._minimise(Q, P)
        self._solver()
        self.last = None

    def _constrain(self) -> None:
        o, N, h, size, (x0, extra, _, _) = self.opti, self.form.N, self.form.h, self.dynamics.size, self.given
        X, U, extras = ca.hcat(self.X[:-1]), ca.hcat(self.U), ca.repmat(extra, 1, N)
        o.subject_to(self.X[0] == x0 / size)
        o.subject_to(ca.vec(self.dynamics.defects().map(N)(X, ca.hcat(self.C), U, extras, np.full((1, N), h))) == 0)
        for k in range(N):
            o.subject_to(self.X[k + 1] == self.C[k][:, -1])
            o.subject_to(o.bounded(-1, self.U[k], 1))

    def _minimise(self, Q: np.ndarray, P: np.ndarray) -> None:
        h, (_, _, x, u), size = self.form.h, self.given, self.dynamics.size
        off = [a * size - x[:, k] for k, a in enumerate(self.X)]
        cost = sum(ca.bilin(Q * h, e, e) for e in off[:-1]) + ca.bilin(P, off[-1], off[-1])
        extra = [a - u[:, k] / LIMIT for k, a in enumerate(self.U)]
        self.opti.minimize(cost + TORQUE_WEIGHT * h * sum(map(ca.sumsqr, extra)))

    def _solver(self) -> None:
        """IPOPT with the Hessian of the quadratic cost alone (Gauss–Newton)."""
        o, quiet = self.opti, {"print_time": False}
        names = ["x", "p", "lam_f", "lam_g"]
        lam_f, lam_g = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", o.ng)
        H = ca.triu(ca.hessian(o.f, o.x)[0])
        gauss = ca.Function("nlp_hess_l", [o.x, o.p, lam_f, lam_g], [lam_f * H], names, ["triu_hess_gamma_x_x"])
        warm = {f"warm_start_{name}_push": 1e-6 for name in ("bound", "mult_bound")} | {"mu_init": 1e-4}
        warm["mu_strategy"] = "adaptive"
        tuning = {"print_level": 0, "sb": "yes", "tol": TOLERANCE, "max_iter": 100, "warm_start_init_point": "yes"}
        o.solver("ipopt", quiet | {"hess_lag": gauss}, tuning | warm)

    def solve(self, x0, extra: float, x, u) -> Solution:
        """From the state x0 (nx,) along the states x (N + 1, nx) and torques u (N, 3) of the plan."""
        for parameter, value in zip(self.given, (x0, extra, x.T, u.T), strict=True):
            self.opti.set_value(parameter, value)
        self._guess(x / self.dynamics.size, u / LIMIT)
        value, converged, count, seconds = attempt(self.opti)
        self.last = [[np.array(value(v)) for v in part] for part in (self.X, self.U, self.C)]
        found = np.array(self.last[0]) * self.dynamics.size, np.array(self.last[1]) * LIMIT
        return Solution(found[1], found[0], converged, count, seconds, float(value(self.opti.f)))

    def _guess(self, x, u) -> None:
        """The last solution, one interval later; at first, and where it ends, the plan."""
        points = ca.collocation_points(DEGREE, "radau")
        inner = [np.array([a + c * (b - a) for c in points]).T for a, b in pairwise(x)]
        plan = [list(x), list(u), inner]
        shifted = self.last and [[*old[1:], new[-1]] for old, new in zip(self.last, plan, strict=True)]
        for variables, values in zip((self.X, self.U, self.C), shifted or plan, strict=True):
            for variable, value in zip(variables, values, strict=True):
                self.opti.set_initial(variable, value)
