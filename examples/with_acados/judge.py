"""IPOPT on the problem that acados solves: the same unknowns, the same step, slacks and weights."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from .solver import Problem


@dataclass(frozen=True)
class Found:
    x: np.ndarray
    """(N + 1, nx)"""
    u: np.ndarray
    """(N, nu)"""
    converged: bool
    iterations: int


class Judge:
    """A problem with discrete dynamics and without parameters, converged by IPOPT to `tolerance`."""

    def __init__(self, problem: Problem, y, y_end, tolerance: float = 1e-8):
        e, N, h = problem.export, problem.N, problem.h
        nx, nu, nb = e.x.numel(), e.u.numel(), len(problem.bounded)
        self.problem = problem
        step = ca.Function("step", [e.x, e.u], [problem.after]).map(N)
        weighed = [ca.Function("y", [e.x, e.u], [problem.y]), ca.Function("y_end", [e.x], [problem.y_end])]
        x0, X, U = ca.MX.sym("x0", nx), ca.MX.sym("X", nx, N + 1), ca.MX.sym("U", nu, N)
        over, under = (ca.MX.sym(name, nb, N) for name in ("over", "under"))
        roots = [np.linalg.cholesky(W).T for W in (problem.W * h, problem.W_end)]
        residual = ca.vertcat(
            ca.vec(roots[0] @ (weighed[0].map(N)(X[:, :-1], U) - y)), roots[1] @ (weighed[1](X[:, -1]) - y_end)
        )
        quadratic, linear = problem.slack
        times = ca.DM(np.r_[np.full(N - 1, h), 1.0])
        slacks = [ca.sum1(quadratic / 2 * s**2 + linear * s) @ times for s in (over, under)]
        rates = X[problem.bounded.tolist(), 1:]
        rows = ca.vertcat(
            X[:, 0] - x0, ca.vec(X[:, 1:] - step(X[:, :-1], U)), ca.vec(rates - over), ca.vec(rates + under)
        )
        unknowns = ca.veccat(X, U, over, under)
        names = ["x", "p", "lam_f", "lam_g"]
        lam_f, lam_g = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", rows.numel())
        J = ca.jacobian(residual, unknowns)
        of_slacks = ca.diag(
            ca.vertcat(ca.MX(nx * (N + 1) + nu * N, 1), *[quadratic * ca.kron(times, ca.MX.ones(nb))] * 2)
        )
        H = ca.triu(lam_f * (J.T @ J + of_slacks))
        gauss = ca.Function("nlp_hess_l", [unknowns, x0, lam_f, lam_g], [H], names, ["triu_hess_gamma_x_x"])
        nlp = {"x": unknowns, "p": x0, "f": ca.sumsqr(residual) / 2 + sum(slacks), "g": rows}
        tuning = {"print_level": 0, "sb": "yes", "tol": tolerance, "max_iter": 300}
        self.solver = ca.nlpsol("judge", "ipopt", nlp, {"hess_lag": gauss, "ipopt": tuning, "print_time": False})
        free, bound = np.full(nx * (N + 1), np.inf), np.tile(problem.bound, N)
        limit = np.tile(problem.limit, N)
        self.bounds = {
            "lbx": np.r_[-free, -limit, np.zeros(2 * nb * N)],
            "ubx": np.r_[free, limit, np.full(2 * nb * N, np.inf)],
            "lbg": np.r_[np.zeros(nx * (N + 1)), np.full(nb * N, -np.inf), -bound],
            "ubg": np.r_[np.zeros(nx * (N + 1)), bound, np.full(nb * N, np.inf)],
        }

    def solve(self, x0, x, u) -> Found:
        """From the state x0, with the guess x (N + 1, nx) and u (N, nu)."""
        N, nx = self.problem.N, x.shape[1]
        slacks = np.zeros(2 * len(self.problem.bounded) * N)
        found = self.solver(x0=np.r_[x.ravel(), u.ravel(), slacks], p=x0, **self.bounds)["x"].full().ravel()
        stats, split = self.solver.stats(), nx * (N + 1)
        states, inputs = found[:split].reshape(N + 1, nx), found[split : split + u.size].reshape(u.shape)
        return Found(states, inputs, stats["success"], stats["iter_count"])
