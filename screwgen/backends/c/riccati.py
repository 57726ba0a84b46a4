"""The cost-to-go of the linear-quadratic regulator at a controller's goal, by a structure-preserving doubling."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...errors import UsageError
from ...spec.mpc import Mpc

if TYPE_CHECKING:
    from ...model import Model

ROUNDS = 60
"""Doublings, at most: each squares what is left of the initial error."""


def cost_to_go(model: Model, said: Mpc, weights: dict[str, list[float]], q, tau, place, rotation) -> np.ndarray:
    """``P`` (2 nq, 2 nq) of ``min sum h (x'Qx + u'Ru)`` over all time, for a plan that ends with ``x'Px / 2``.

    ``Q`` is that of a stage without the orientation's term; motion and tip are linearised at rest at the goal.
    """
    h, n = said.horizon.step, model.nq
    A, B = step_slopes(model, said, q, tau)
    Q = h * np.diag([*weights["joints"], *weights["modes"], *weights["joint_rates"], *weights["mode_rates"]])
    J = np.array(model.casadi()["tip_jacobian"](q, model.parameter_values))
    turn = -0.5 * (rotation @ rotation.T - 3 * np.eye(3))
    for name, C in (("tip_position", _over(J[3:], n, 0)), ("tip_velocity", _over(J[3:], n, n)), ("tip_orientation", _over(turn @ J[:3], n, 0))):
        if name in weights:
            Q += h * C.T @ np.diag(weights[name]) @ C
    rates = np.array(weights["torque_rates"]) / h
    R = np.diag(h * np.array(weights["torques"]) + rates)
    return riccati(A, B, Q, R) - said.cost.terminal.factor * Q


def _over(J: np.ndarray, n: int, first: int) -> np.ndarray:
    out = np.zeros((3, 2 * n))
    out[:, first : first + n] = J
    return out


def step_slopes(model: Model, said: Mpc, q, tau) -> tuple[np.ndarray, np.ndarray]:
    """Derivatives of an interval with the state (2 nq, 2 nq) and the torques (2 nq, n_tau), at rest at q."""
    import casadi as ca

    horizon, n = said.horizon, model.nq
    step = model.casadi()["step" if horizon.method == "modal_midpoint" else f"step_{horizon.method}"]
    x, u, dt = ca.SX.sym("x", 2 * n), ca.SX.sym("u", model.n_tau), horizon.step / horizon.substeps
    after = ca.vertcat(*step(x[:n], x[n:], u, ca.DM.zeros(6, model.n_links), model.parameter_values, dt))
    one = ca.Function("one", [x, u], [ca.jacobian(after, x), ca.jacobian(after, u)])
    A, B = (np.array(m) for m in one(np.r_[q, np.zeros(n)], tau))
    whole, input_ = np.eye(2 * n), np.zeros(B.shape)
    for _ in range(horizon.substeps):
        whole, input_ = A @ whole, A @ input_ + B
    return whole, input_


def riccati(A: np.ndarray, B: np.ndarray, Q: np.ndarray, R: np.ndarray) -> np.ndarray:
    """The stabilising solution of ``P = Q + A'PA − A'PB (R + B'PB)⁻¹ B'PA`` by doubling.

    Raises UsageError where it does not settle: a motion that the weights do not see or torques cannot stop.
    """
    G, P, unit = B @ np.linalg.solve(R, B.T), Q.copy(), np.eye(len(A))
    for _ in range(ROUNDS):
        W = np.linalg.solve(unit + G @ P, np.hstack([A, G]))
        V1, V2 = W[:, : len(A)], W[:, len(A) :]
        more = A.T @ P @ V1
        A, G, P = A @ V1, G + A @ V2 @ A.T, P + 0.5 * (more + more.T)
        if not np.isfinite(P).all():
            break
        if np.abs(more).max() <= 1e-13 * np.abs(P).max():
            return P
    raise UsageError("cost.terminal.riccati: the cost-to-go is not finite; weigh joints, joint_rates, modes and mode_rates")
