"""Closed loops against the plant in C: the receding horizon, and PD."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from screwgen import PD
from screwgen.runtime.compiled import Compiled
from screwgen.simulation.motion import tip_position

from .arms import LIMIT, STEP, Arms, at_rest, at_rest_there
from .ocp import Dynamics, Form, Problem, Solution
from .plan import SHARE, SMOOTH, Plan, fastest

FREE = np.zeros((2, 6))
METHOD = "modal_midpoint"
RATE_GAIN = np.array([50.0, 50.0, 20.0])
"""N·m·s/rad: of the drives' rate loop under the MPC, 1 kHz, about the joint rates that the last solve predicts."""


OBSERVER_GAIN = 0.1
"""Of the MPC's observer: share of the difference from the measured state that is taken over every `STEP`.

It keeps the plant's fast modes, which nothing damps, from being seen as slow motions by solves that are seldom.
"""


@dataclass(frozen=True)
class Motion:
    """A run of the plant, sampled every `STEP`."""

    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    """(N, 3) N·m: of the motors, held from the sample on."""
    tip: np.ndarray
    """(N, 3) m."""


def run(arms: Arms, torque: Callable, duration: float, compiled: Compiled | None = None, p=None) -> Motion:
    """The plant from its rest at q = 0; `torque(k, q, v)` (3,) is limited and held over a step."""
    compiled, p = compiled or arms.compiled, arms.p if p is None else p
    q, v, rows = at_rest(arms.plant, np.zeros(3), p)[0], np.zeros(arms.plant.nq), []
    for k in range(round(duration / STEP)):
        tau = np.clip(torque(k, q, v), -LIMIT, LIMIT)
        rows.append((q, v, tau))
        q, v = compiled.step(q, v, tau, FREE, STEP, METHOD)
    q, v, tau = map(np.array, zip(*rows, strict=True))
    return Motion(q, v, tau, tip_position(arms.plant, q, p))


def found_payload(arms: Arms, dynamics: Dynamics) -> float:
    """Payload beyond the file's, kg: that which explains best the torques that hold the plant before it moves."""
    q, hold = arms.rest(np.zeros(3))
    bias, x = dynamics.model.casadi()["bias"], arms.projection @ q
    need = lambda extra: np.array(bias(x, 0 * x, FREE.T, dynamics.parameters(extra))).ravel()[:3]  # noqa: E731
    slope = need(1.0) - need(0.0)
    return float(slope @ (hold - need(0.0)) / (slope @ slope))


class Controller:
    """An MPC: finds the payload, plans the fastest motion, and follows it by a receding horizon; here with IPOPT.

    A solve takes an interval: it starts from where the model will be at its end, and acts from then on.  The plan is
    made in so many `intervals`, or it is one that is there.
    """

    def __init__(self, arms: Arms, form: Form, intervals: int, plan: Plan | None = None):
        self.arms, self.form, self.dynamics = arms, form, Dynamics(arms.model)
        self.extra = found_payload(arms, self.dynamics)
        start = at_rest(arms.model, np.zeros(3), self.dynamics.parameters(self.extra))
        start = np.append(start[0], np.zeros(arms.model.nq)), start[1]
        self.ends = [start, self.dynamics.rest_there(arms.goal, self.extra)]
        given = self.dynamics, self.ends, self.extra, intervals, SHARE, SMOOTH
        self.plan = fastest(*given) if intervals else plan
        self.problem = self.stated(form)
        self.ahead, self.soon = self.dynamics.step(form.h), self.dynamics.step(STEP)

    def stated(self, form: Form) -> Problem:
        return Problem(self.dynamics, form, *self.dynamics.weights(self.arms.goal, self.extra))

    def solve(self, problem: Problem, x, t: float) -> Solution:
        h, N = problem.form.h, problem.form.N
        t = t + h * np.arange(N + 1)
        return problem.solve(x, self.extra, self.plan.states(t), self.plan.torques(t[:-1], h))

    def sample(self, x, acting: Solution, t: float) -> Solution:
        """What acts from an interval after t on, from the state x (nx,) at t, where `acting` acts now."""
        h = self.form.h
        return self.solve(self.problem, np.array(self.ahead(x, acting.u[0], self.extra)).ravel(), t + h)

    def run(self, duration: float, tick: Callable[[float], None]) -> tuple[Motion, list]:
        n, every, T = self.arms.model.nq, round(self.form.h / STEP), self.arms.projection
        x, tau = self.ends[0]
        solutions = [self.solve(self.problem, x, 0.0)]
        acting = solutions[0]

        def torque(k: int, q, v) -> np.ndarray:
            nonlocal acting, x, tau
            x = np.array(self.soon(x, tau, self.extra)).ravel() if k else x
            x = x + OBSERVER_GAIN * (np.append(T @ q, T @ v) - x)
            if k % 200 == 0:
                tick(k * STEP)
            if k % every == 0:
                acting = solutions[-1]
                solutions.append(self.sample(x, acting, k * STEP))
            share = k % every / every
            rates = (1 - share) * acting.x[0, n : n + 3] + share * acting.x[1, n : n + 3]
            tau = np.clip(acting.u[0] - RATE_GAIN * (v[:3] - rates), -LIMIT, LIMIT)
            return tau

        return run(self.arms, torque, duration), solutions


@dataclass(frozen=True)
class Gains:
    """PD gains by what they would do to the joints of the rigid arm with their inertias at the goal."""

    frequency: float
    """Hz"""
    damping: float
    move: float | None
    """s: of the minimum-jerk reference; None: the set point from the start."""


GRID = [
    Gains(f, z, T)
    for f in (1.25, 1.5, 2.0, 2.5, 3.0, 4.0)
    for z in (0.7, 1.0, 1.4)
    for T in (None, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
]
SOFT = [Gains(f, z, None) for f in (0.5, 0.8, 1.25, 2.0, 3.0) for z in (0.7, 1.0, 1.4)]
"""For PD along the MPC's plan, whose torques do most of the work."""
FEW = [Gains(1.5, 1.0, None), Gains(3.0, 1.4, 0.9)]


class Baseline:
    """PD with gravity compensation, designed for an arm with `extra` kg of payload beyond the file's."""

    def __init__(self, arms: Arms, extra: float):
        self.arms, p = arms, arms.parameters(extra)
        q, self.hold = at_rest_there(arms.plant, arms.goal, p)
        self.start, self.joints = at_rest(arms.plant, np.zeros(3), p)[1], q[:3]
        self.inertia = np.diag(np.array(arms.plant.casadi()["mass_matrix"](q, p)))[:3]

    def gains(self, gains: Gains) -> tuple[np.ndarray, np.ndarray]:
        omega = 2 * np.pi * gains.frequency
        return self.inertia * omega**2, 2 * gains.damping * omega * self.inertia

    def run(self, gains: Gains, duration: float, rehearse: bool = False) -> Motion:
        """On the plant, or where `rehearse`, on the arm of the file."""
        kp, kd = (tuple(map(float, g)) for g in self.gains(gains))
        law = PD(kp, kd, tuple(map(float, self.joints)), duration=gains.move, q_start=(0.0,) * 3)

        def torque(k: int, q, v) -> np.ndarray:
            share = law.reference(k * STEP)[0][0] / self.joints[0]
            return law(k * STEP, q, v) + self.start + share * (self.hold - self.start)

        arms = self.arms
        return run(arms, torque, duration, *((arms.rehearsal, arms.nominal) if rehearse else ()))

    def follow(self, gains: Gains, plan: Plan, duration: float) -> Motion:
        """The MPC's plan, its torques fed forward, and PD about its joint coordinates."""
        (kp, kd), n = self.gains(gains), self.arms.model.nq
        t = STEP * np.arange(round(duration / STEP))
        x, u = plan.states(t), plan.torques(t, STEP)
        law = lambda k, q, v: u[k] + kp * (x[k, :3] - q[:3]) + kd * (x[k, n : n + 3] - v[:3])  # noqa: E731
        return run(self.arms, law, duration)
