"""The task of `make mpc` in real time: its controller with acados in place of IPOPT."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np
from mpc.arms import LIMIT, PAYLOAD, Arms
from mpc.loop import Controller
from mpc.ocp import TORQUE_WEIGHT, Form, Solution
from scipy.linalg import block_diag

from screwgen import Model
from screwgen.backends.casadi.acados import AcadosExport

from .solver import Options, Problem, Solver

RADAU = Options(integrator="IRK", stages=2, steps=1, collocation="GAUSS_RADAU_IIA", hpipm="BALANCE")
"""The collocation of `mpc.ocp`, so that IPOPT solves the same problem."""
FIRST = 10
"""Iterations before the motion; from then on one for each sample."""


def narrowed(model: Model, parameter: str) -> AcadosExport:
    """The export with one parameter; the others are the numbers of the robot file."""
    e, at = model.acados(), model.parameter_names.index(parameter)
    one, p = ca.SX.sym("p", 1), ca.SX(ca.DM(model.parameter_values))
    p[at] = one
    given = [e.x, e.xdot, e.u, e.z]
    both = ca.Function("both", [*given, e.p], [e.f_expl_expr, e.f_impl_expr])
    explicit, implicit = both(*given, p)
    value = (e.parameter_values[at],)
    return replace(e, p=one, f_expl_expr=explicit, f_impl_expr=implicit, p_labels=(parameter,), parameter_values=value)


def problem(model: Model, form: Form, Q: np.ndarray, P: np.ndarray) -> Problem:
    """`mpc.ocp.Problem` for acados, which halves squares."""
    e = narrowed(model, PAYLOAD)
    return Problem(
        name="ella",
        export=e,
        N=form.N,
        h=form.h,
        y=ca.vertcat(e.x, e.u),
        W=2 * block_diag(Q, np.diag(TORQUE_WEIGHT / LIMIT**2)),
        y_end=e.x,
        W_end=2 * P,
        limit=LIMIT,
    )


@dataclass(frozen=True)
class Timed(Solution):
    """`seconds` is the whole sample, Python's share included; `references` is the part that hands over the plan."""

    references: float = 0.0
    preparation: float = 0.0
    feedback: float = 0.0


class RealTime(Controller):
    """One iteration of sequential quadratic programming for each sample, along the plan.

    The first solution comes from `FIRST` iterations at rest, with the plan as reference and as guess.
    """

    def __init__(self, arms: Arms, form: Form, intervals: int, options: Options = RADAU):
        self.options = options
        super().__init__(arms, form, intervals)

    def stated(self, form: Form) -> Solver:
        model = self.arms.model
        solver = Solver(problem(model, form, *self.dynamics.weights(self.arms.goal, self.extra)), self.options)
        at = self.dynamics.at
        solver.p = np.array([self.dynamics.parameters(self.extra)[at]])
        self.begun = False
        return solver

    def solve(self, problem: Solver, x, t: float) -> Timed:
        form, start = problem.problem, time.thread_time()
        t = t + form.h * np.arange(form.N + 1)
        states, torques = self.plan.states(t), self.plan.torques(t[:-1], form.h)
        problem.refer(np.hstack([states[:-1], torques]), states[-1])
        if self.begun:
            problem.guess(*shifted(problem.x, problem.u, states[-1], torques[-1]))
        else:
            problem.guess(states, torques)
            problem.settle(x, FIRST)
            self.begun = True
        references = time.thread_time() - start
        preparation = problem.prepare()
        _, feedback, status = problem.feedback(x)
        parts = references, preparation, feedback
        found, count = (problem.u, problem.x), int(problem.acados.get_stats("qp_iter")[-1])
        return Timed(*found, status == 0, count, sum(parts), float("nan"), *parts)


def shifted(x, u, x_end, u_end) -> tuple[np.ndarray, np.ndarray]:
    """The last solution an interval later; at its end the reference."""
    return np.vstack([x[1:], x_end]), np.vstack([u[1:], u_end])
