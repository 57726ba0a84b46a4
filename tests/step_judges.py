"""The derivatives of a step by others than the generated C: CasADi's jacobian, and differences in 50 digits."""

from __future__ import annotations

import casadi as ca
import mpmath
import numpy as np
from helpers import relative

from screwgen.algorithms import fused
from screwgen.backends.casadi.functions import expressions
from screwgen.backends.casadi.steps import step
from screwgen.elements import FRICTION, STOP
from screwgen.integrators import METHODS
from screwgen.integrators.space import FLAT, Curved, replayed
from screwgen.ir.replay import run
from screwgen.joints.exponential import Series

DIGITS = 50
SHIFT = "1e-16"
"""The step of the differences, whose error is its square."""


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


# -------- CasADi


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


# -------- 50 digits


class Precise:
    """Accelerations in mpmath at held torques and wrenches, with the program that CasADi's step replays."""

    def __init__(self, model, tau, w_ext):
        self.chain, number = model.chain, np.vectorize(mpmath.mpf, otypes=[object])
        p = [mpmath.mpf(x) for x in model.parameter_values]
        self.program = fused.modal_dynamics(self.chain)
        self.given = {"tau": list(number(tau)), "w_ext": list(number(np.ravel(w_ext))), "p": p}
        found = run(fused.modal_properties(self.chain), {"p": p}, fused.precise)[0]
        self.own = {name: np.array(values, dtype=object) for name, values in found.items()}

    def explicit(self, q, v):
        return self.implicit(q, v, mpmath.mpf(0), (q, v))

    def implicit(self, q, v, h, there=None):
        chain = self.chain
        n, (q_there, v_there) = chain.n_given, there or (q, v)
        M, K, D = (self.own[name].copy() for name in ("M_eta", "K", "D"))
        x, rate, later = q[len(q) - n :], v[len(v) - n :], v_there[len(v) - n :]
        for k, i in enumerate(x.coordinate for x in chain.acted(FRICTION)):
            D[i] += self.own["coulomb"][k] / mpmath.sqrt(later[i] ** 2 + self.own["speed"][k])
        m, f = M + h * (D + h * K), chain.modal_product(K, x + h * rate) + chain.modal_product(D, rate)
        for k, (_, i, side) in enumerate(chain.acted(STOP)):
            columns = (self.own[name][k] for name in ("stop_at", "stop_K", "stop_D"))
            stiffness, damping, rest = stop_secants(side, x[i], rate[i], later[i], h, *columns)
            m[i] += h * (damping + h * stiffness)
            f[i] += stiffness * (x[i] - rest + h * rate[i]) + damping * rate[i]
        given = self.given | {"q": list(q_there), "v": list(v_there), "m_eta": list(m), "f_eta": list(f)}
        return np.array(run(self.program, given, fused.precise)[0]["vdot"], dtype=object)


def stop_secants(side, x, w, there, h, at, k, d):
    """Stiffness, damping and rest of a stop over a step, branch by branch."""
    start, rate = side * (x - at), max(side * w, side * there)
    end = start + 2 * h * rate
    low, high = min(start, end), max(start, end)
    if high <= 0:
        return 0, 0, at
    outside = min(low, 0)
    share = high / (high - outside)
    if k * (start + h * rate - outside / 2) + d * rate <= 0:
        share = 0
    return k * share, d * share, at + side * outside / 2


def by_differences(model, method, q, v, tau, w_ext, h):
    """``A, B`` by central differences of the method's step; of a floating base in changes of the pose."""
    with mpmath.workdps(DIGITS):
        chain, shift, nv = model.chain, mpmath.mpf(SHIFT), model.chain.nv
        number = np.vectorize(mpmath.mpf, otypes=[object])
        series = Series(lambda x: fused.precise("c4", x), lambda x: fused.precise("c5", x))
        space = Curved(chain, series) if chain.curved else FLAT
        q, v, tau, h = number(q), number(v), number(tau), mpmath.mpf(h)

        def moved(k: int, by) -> tuple:
            d = np.full(2 * nv + chain.n_tau, mpmath.mpf(0), dtype=object)
            d[k] = by
            held = Precise(model, tau + d[2 * nv :], w_ext)
            return METHODS.get(method, method).step(held, space.moved(q, d[:nv]), v + d[nv : 2 * nv], h, space)

        columns = []
        for k in range(2 * nv + chain.n_tau):
            (q_1, v_1), (q_0, v_0) = moved(k, shift), moved(k, -shift)
            change = _precise_change(q_0, q_1) if chain.floating else q_1 - q_0
            columns.append(np.concatenate([change, v_1 - v_0]) / (2 * shift))
        J = np.array(columns).T.astype(float)
        return J[:, : 2 * nv], J[:, 2 * nv :]


def _precise_change(before, after):
    """The change of coordinates behind a pose: [turn; shift] in the axes between both, up to the square of it."""
    w, b = before[3], before[4:7]
    size = sum(before[3:7] ** 2)
    turn = 2 * (w * after[4:7] - after[3] * b - np.cross(b, after[4:7])) / size
    d = after[:3] - before[:3]
    back = d + 2 * (np.cross(b, np.cross(b, d)) - w * np.cross(b, d)) / size
    return np.concatenate([turn, back + np.cross(back, turn) / 2, after[7:] - before[7:]])
