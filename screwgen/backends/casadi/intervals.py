"""The derivatives of an interval of a predictive controller: several steps with the torques held."""

from __future__ import annotations

import casadi as ca
import numpy as np

from ...arguments import Numbers
from ...spec.mpc import Horizon


def interval_slopes(
    step: ca.Function, horizon: Horizon, p: Numbers, q: Numbers, tau: Numbers
) -> tuple[np.ndarray, np.ndarray]:
    """With the state (2 nq, 2 nq) and with the torques (2 nq, n_tau), at rest at ``q`` in equilibrium.

    ``step (q, v, tau, w_ext, p, dt) -> (q_next, v_next)`` is the function of the horizon's method.
    """
    n, dt = len(q), horizon.step / horizon.substeps
    x, u = ca.SX.sym("x", 2 * n), ca.SX.sym("u", len(tau))
    after = ca.vertcat(*step(x[:n], x[n:], u, ca.DM.zeros(*step.size_in(3)), p, dt))
    one = ca.Function("one", [x, u], [ca.jacobian(after, x), ca.jacobian(after, u)])
    A, B = (np.array(m) for m in one(np.r_[q, np.zeros(n)], tau))
    whole, held = np.eye(2 * n), np.zeros(B.shape)
    for _ in range(horizon.substeps):
        whole, held = A @ whole, A @ held + B
    return whole, held
