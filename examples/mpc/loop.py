"""Closed loops against the plant in C: the receding horizon, and PD."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca
import numpy as np

from screwgen import PD

from .arms import GOAL, LIMIT, RATE_GAIN, STEP, Arms, at_rest
from .ocp import ND, SCALE, Dynamics, Form, Problem, Solution

FREE = np.zeros((2, 6))
METHOD = "modal_midpoint"
DRIFT, DOUBT = 0.1, 0.1
"""Of the estimator: how far d wanders in an interval (N·m, N), and what a measurement may be off, over `SCALE`."""


@dataclass(frozen=True)
class Motion:
    """A run of the plant, sampled every `STEP`."""

    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    """(N, 3) N·m: of the motors, held from the sample on."""
    tip: np.ndarray
    """(N, 3) m."""


def run(arms: Arms, torque: Callable, duration: float) -> Motion:
    """The plant from its rest at q = 0; `torque(k, q, v)` (3,) is limited and held over a step."""
    q, v, rows = arms.rest(np.zeros(3))[0], np.zeros(arms.plant.nq), []
    for k in range(round(duration / STEP)):
        tau = np.clip(torque(k, q, v), -LIMIT, LIMIT)
        rows.append((q, v, tau))
        q, v = arms.compiled.step(q, v, tau, FREE, STEP, METHOD)
    q, v, tau = map(np.array, zip(*rows, strict=True))
    return Motion(q, v, tau, arms.tip(q))


class Estimator:
    """d from how the measured state differs from the predicted one, a Kalman filter; its payload from the rest."""

    def __init__(self, arms: Arms, dynamics: Dynamics, h: float):
        self.dynamics, self.step = dynamics, dynamics.step(h)
        given = dynamics.symbols(ca.MX)
        self.gain = ca.Function("gain", given, [ca.jacobian(self.step(*given), given[2])])
        self.covariance = np.diag(np.r_[np.full(7, 0.3**2), 0.0])
        self.d = self.from_rest(arms)

    def from_rest(self, arms: Arms) -> np.ndarray:
        """Payload from the holding torques before the motion, by least squares; then the rest of d to balance."""
        q, hold = arms.rest(np.zeros(3))
        x = np.append(arms.projection @ q, np.zeros(7))
        d, f = np.zeros(ND), lambda d: np.array(self.dynamics.rate(x, hold, d, self.dynamics.p)).ravel()[7:]
        bias, p = self.dynamics.model.casadi()["bias"], self.dynamics.p
        at = self.dynamics.model.parameter_names.index("forearm.bodies[0].mass")
        need = lambda m: np.array(bias(x[:7], x[7:], FREE.T, p + m * np.eye(len(p))[at])).ravel()[:3]  # noqa: E731
        slope = need(1.0) - need(0.0)
        d[7] = slope @ (hold - need(0.0)) / (slope @ slope)
        d[:7] = np.linalg.solve(np.array([f(d + e) - f(d) for e in np.eye(ND)[:7]]).T, -f(d))
        return d

    def update(self, before, u, x) -> None:
        given, P = (before, u, self.d, self.dynamics.p), self.covariance
        surprise, G = x - np.array(self.step(*given)).ravel(), np.array(self.gain(*given))
        K = np.linalg.solve(G @ P @ G.T + np.diag((DOUBT * SCALE) ** 2), G @ P).T
        self.d = self.d + K @ surprise
        self.covariance = P - K @ G @ P + np.diag(np.r_[np.full(7, DRIFT**2), 0.0])


def receding_horizon(arms: Arms, form: Form, duration: float, tick) -> tuple[Motion, list[Solution], np.ndarray]:
    """The closed loop under MPC, its solutions, and d (8,) as found at rest."""
    dynamics = Dynamics(arms.model)
    estimator = Estimator(arms, dynamics, form.h)
    at_first = estimator.d
    goal, hold = dynamics.target(GOAL, at_first)
    problem = Problem(dynamics, form, dynamics.cost_to_go(form.h, goal, hold, at_first))
    every, solutions, before = round(form.h / STEP), [], []

    def torque(k: int, q, v) -> np.ndarray:
        if k % every == 0:
            x = np.concatenate([arms.projection @ q, arms.projection @ v])
            if before:
                estimator.update(before.pop(), solutions[-1].u[0], x)
            before.append(x)
            target = dynamics.target(GOAL, estimator.d)
            solutions.append(problem.solve(x, estimator.d, *target))
            tick(k * STEP)
        return solutions[-1].u[0] - RATE_GAIN * v[:3]

    return run(arms, torque, duration), solutions, at_first


@dataclass(frozen=True)
class Gains:
    """PD gains by what they would do to the joints of the rigid arm with their inertias at the goal."""

    frequency: float
    """Hz"""
    damping: float
    move: float | None
    """s: of the minimum-jerk reference; None: the set point from the start."""


GRID = [Gains(f, z, T) for f in (1.25, 1.5, 2.0, 3.0) for z in (0.7, 1.0, 1.4) for T in (None, 0.6, 0.9)]
FEW = [Gains(1.5, 1.0, None), Gains(3.0, 1.4, 0.9)]


def pd(arms: Arms, gains: Gains, payload: float, duration: float) -> Motion:
    """The closed loop under PD and gravity compensation; `payload` kg: what the MPC's estimator found, added."""
    p = np.array(arms.model.parameter_values)
    p[arms.model.parameter_names.index("forearm.bodies[0].mass")] += payload
    start, end = (at_rest(arms.model, joints, p)[1] for joints in (np.zeros(3), GOAL))
    M = np.array(arms.plant.casadi()["mass_matrix"](arms.rest(GOAL)[0], arms.p))
    omega, J = 2 * np.pi * gains.frequency, np.diag(M)[:3]
    kp, kd = (tuple(map(float, g)) for g in (J * omega**2, 2 * gains.damping * omega * J))
    law = PD(kp, kd, tuple(map(float, GOAL)), duration=gains.move, q_start=(0.0,) * 3)

    def torque(k: int, q, v) -> np.ndarray:
        share = law.reference(k * STEP)[0][0] / GOAL[0]
        return law(k * STEP, q, v) + start + share * (end - start)

    return run(arms, torque, duration)
