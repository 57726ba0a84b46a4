"""The derivatives of a step by another than the generated C: CasADi's jacobian."""

from __future__ import annotations

import casadi as ca
import numpy as np
from helpers import relative

from screwgen.backends.casadi.functions import expressions
from screwgen.backends.casadi.steps import step
from screwgen.integrators import METHODS
from screwgen.integrators.space import replayed


def blocks(A, B, nv: int) -> list:
    """The blocks of coordinates and rates: they differ in size by the step."""
    halves = slice(0, nv), slice(nv, 2 * nv)
    return [A[a, b] for a in halves for b in halves] + [B[a] for a in halves]


def worst(found, expected, nv: int) -> float:
    """The largest error of A and B, relative to the largest entry of the block."""
    return max(relative(a, b) for a, b in zip(blocks(*found, nv), blocks(*expected, nv), strict=True))


def point(model, seed=3, angle=0.8, modal=0.01, rate=1.0):
    """q, v, tau, w_ext in these sizes; the rotors of elastic drives stand with their joints."""
    rng, chain = np.random.default_rng(seed), model.chain
    q, v = np.array(chain.home), rate * rng.uniform(-1, 1, chain.nv)
    joints = rng.uniform(-angle, angle, chain.n_joints)
    q[chain.base_q :] = np.r_[
        chain.with_added(joints, model.parameter_values), rng.uniform(-modal, modal, chain.n_modes)
    ]
    v[chain.eta_v :] *= 0.1
    if chain.floating:
        q[:7] = rng.normal(size=7)
        q[3:7] /= np.linalg.norm(q[3:7])
    return q, v, rng.uniform(-3, 3, chain.n_tau), rng.uniform(-2, 2, (chain.n, 6))


def by_casadi(model, method, q, v, tau, w_ext, h):
    """``A, B`` by the jacobian of ``step_<method>``; of a floating base in changes of the pose."""
    chain = model.chain
    nq, nv, f = chain.nq, chain.nv, step(chain, METHODS.get(method, method), "step")
    x, u, given = ca.SX.sym("x", 2 * nv), ca.SX.sym("u", chain.n_tau), ca.SX.sym("q", nq)
    moved = replayed(chain, expressions).moved(given, x[:nv])
    after, rates = f(moved, v + x[nv:], u, np.reshape(w_ext, (-1, 6)).T, model.parameter_values, h)
    middle = ca.SX.sym("middle", nq)
    change = ca.vertcat(_pose_change(middle, after), after[7:]) if chain.floating else after
    y = ca.vertcat(change, rates)
    J = ca.Function("J", [given, x, u, middle], [after, ca.jacobian(y, x), ca.jacobian(y, u)])
    at = J(q, np.zeros(2 * nv), tau, np.zeros(nq))[0]
    return [m.full() for m in J(q, np.zeros(2 * nv), tau, at)[1:]]


def _pose_change(before, after):
    """[turn; shift] of a small change of a pose, in its own axes."""
    w, b = before[3], before[4:7]
    turn = 2 * (w * after[4:7] - after[3] * b - ca.cross(b, after[4:7]))
    R = ca.SX.eye(3) + 2 * (w * ca.skew(b) + ca.skew(b) @ ca.skew(b))
    return ca.vertcat(turn, R.T @ (after[:3] - before[:3]))
