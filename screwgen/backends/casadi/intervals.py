"""The derivatives of an interval of a predictive controller: several steps with the torques held."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from ...arguments import Numbers
from ...spec.mpc import Horizon


def interval_slopes(
    step: ca.Function, horizon: Horizon, p: Numbers, x: Numbers, nq: int, tau: Numbers, free: Sequence[int]
) -> tuple[np.ndarray, np.ndarray]:
    """The slopes of the ``free`` entries of the state ``x``, [q; v], with these and with the inputs, at rest there.

    Those of one step are chained: the other entries follow none of these.
    ``step (q, v, tau, w_ext, p, dt) -> (q_next, v_next)`` is the function of the horizon's method.
    """
    dt, at, free = horizon.step / horizon.substeps, ca.SX(ca.DM(x)), list(free)
    y, u = ca.SX.sym("x", len(free)), ca.SX.sym("u", len(tau))
    at[free] = y
    after = ca.SX(ca.vertcat(*step(at[:nq], at[nq:], u, ca.DM.zeros(*step.size_in(3)), p, dt)))[free]
    one = ca.Function("one", [y, u], [ca.jacobian(after, y), ca.jacobian(after, u)])
    A, B = (np.array(m) for m in one(np.asarray(x)[free], tau))
    whole, held = np.eye(len(free)), np.zeros(B.shape)
    for _ in range(horizon.substeps):
        whole, held = A @ whole, A @ held + B
    return whole, held
