"""A linear-quadratic law with integral and its Kalman filter about a rest, and the loop that it closes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..errors import UsageError
from ..lazily import linalg
from .sampled_loop import Closed, SampledLoop

MATERIAL = 1e-3
"""The least damping ratio of modes in the design: those that nothing damps have no steady filter."""
STATIC = 4.0
"""rad per step: modes that are faster than this are taken for static, by damping them."""
SUMMED = 4.0
"""How many times slower than the law its integral is."""


class LqgTuning(NamedTuple):
    """What is weighted: of a joint alone these are frequencies at which it would move."""

    bandwidth: float
    """rad/s: of the joints."""
    calm: float
    """The weight of the energy of the motion, over that of the joints' errors."""
    filter: float
    """The bandwidth of the filter over that of the joints."""


class RestMatrices(NamedTuple):
    """Small motions about a rest: inertia, damping and stiffness (n, n), and the rest."""

    M: np.ndarray
    D: np.ndarray
    K: np.ndarray
    modes: np.ndarray
    """(n - n_joints,): the coordinates of the modes at rest."""
    hold: np.ndarray
    """(n_joints,): the torques that hold the arm."""

    def loop(self, step: float) -> SampledLoop:
        """As a clock samples it."""
        return SampledLoop.of_matrices(self.M, self.D, self.K, len(self.hold), step)

    def damped(self, step: float) -> RestMatrices:
        """The same with damping of the modes, the joints held, no less than what materials have."""
        m = len(self.hold)
        squares, V = linalg.eigh((self.K[m:, m:] + self.K[m:, m:].T) / 2, self.M[m:, m:])
        scaled, D = self.M[m:, m:] @ V, self.D.copy()
        own = np.diag(V.T @ self.D[m:, m:] @ V)
        w = np.sqrt(np.maximum(squares, 0.0))
        wanted = 2 * w * np.clip((w * step / STATIC) ** 2, MATERIAL, 1.0)
        D[m:, m:] += scaled @ np.diag(np.maximum(0.0, wanted - own)) @ scaled.T
        return self._replace(D=D)


class LqgGains(NamedTuple):
    """The law and the filter at a point: `x` are coordinates and rates (2 n,), `z` (n_joints,) integrals of errors."""

    M: np.ndarray
    """(n, n): of the filter's model, `M + h/2 D + h²/4 S`, the inertia in a step h of the implicit midpoint rule."""
    S: np.ndarray
    """(n, n): its stiffness."""
    D: np.ndarray
    """(n, n): its damping."""
    K: np.ndarray
    """(n_joints, 2 n): torques by what coordinates and rates lack."""
    Kz: np.ndarray
    """(n_joints, n_joints): torques by integrals of what joints lack."""
    L: np.ndarray
    """(2 n, n_joints): of the filter, by what encoders measure beyond its prediction."""
    modes: np.ndarray
    hold: np.ndarray

    def model(self, step: float) -> tuple[np.ndarray, np.ndarray]:
        """The filter's model from sample to sample, `x+ = A x + B tau`."""
        return midpoint(self.M, self.S, self.D, len(self.hold), step)


def midpoint(M: np.ndarray, S: np.ndarray, D: np.ndarray, joints: int, step: float) -> tuple[np.ndarray, np.ndarray]:
    """A step of the implicit midpoint rule as matrices, of the inertia in it, stiffness and damping.

    These may be interpolated: a mean of inertias is that of an arm that there could be, and right where the arm moves
    slowly. Transition matrices, or inverses, may not: what little resists at one vertex and much at the next comes
    out as little between, and such a filter is unstable.
    """
    n = len(M)
    solved = np.linalg.solve(M, np.hstack([-S, -step / 2 * S - D, np.eye(n, joints)]))
    moves, pushes = solved[:, : 2 * n], solved[:, 2 * n :]
    A = np.eye(2 * n) + step * np.vstack([step / 2 * moves, moves])
    A[:n, n:] += step * np.eye(n)
    return A, step * np.vstack([step / 2 * pushes, pushes])


def designed(rest: RestMatrices, tuning: LqgTuning, step: float) -> LqgGains:
    """The steady law and the steady filter; weights are energies, so that one number serves joints of any kind."""
    soft, m, n = rest.damped(step), len(rest.hold), len(rest.M)
    M = soft.M + step / 2 * soft.D + step**2 / 4 * soft.K
    A, B = midpoint(M, soft.K, soft.D, m, step)
    J = rest.M[:m, :m]
    try:
        K = _law(A, B, soft, tuning, step)
        C, spread = np.eye(m, 2 * n), np.zeros((2 * n, 2 * n))
        spread[n:, n:] = (tuning.filter * tuning.bandwidth) ** 4 * np.linalg.inv(rest.M) * step
        noise = np.linalg.inv(J) / step
        P = linalg.solve_discrete_are(A.T, C.T, spread, noise)
    except np.linalg.LinAlgError:
        raise UsageError(
            "lqg: a law or a filter that settles was not found here; take another posture or load"
        ) from None
    L = P @ C.T @ np.linalg.inv(C @ P @ C.T + noise)
    return LqgGains(M, soft.K, soft.D, K[:, : 2 * n], -K[:, 2 * n :], L, rest.modes, rest.hold)


def _law(A: np.ndarray, B: np.ndarray, rest: RestMatrices, tuning: LqgTuning, step: float) -> np.ndarray:
    """Gains on coordinates, rates and integrals; weighted are errors of joints, energies and efforts."""
    m, n, w = len(rest.hold), len(rest.M), tuning.bandwidth
    J, bends = rest.M[:m, :m], np.zeros((n, n))
    bends[m:, m:] = (rest.K[m:, m:] + rest.K[m:, m:].T) / 2
    Q = linalg.block_diag(tuning.calm * w**2 * bends, tuning.calm * w**2 * rest.M, w**4 * (w / SUMMED) ** 2 * J)
    Q[:m, :m] += w**4 * J
    A_summed = np.block([[A, np.zeros((2 * n, m))], [-step * np.eye(m, 2 * n), np.eye(m)]])
    B_summed, R = np.vstack([B, np.zeros((m, m))]), np.linalg.inv(J) * step
    P = linalg.solve_discrete_are(A_summed, B_summed, Q * step, R)
    return np.linalg.solve(R + B_summed.T @ P @ B_summed, B_summed.T @ P @ A_summed)


def closed_by(plant: SampledLoop, law: LqgGains) -> Closed:
    """The loop of a plant, perhaps with other modes, under a law: states of the plant, of the filter, integrals."""
    (m, n), N = law.K.shape, len(plant.A)
    reads, C = np.eye(m, N), np.eye(m, n)
    filtered = np.hstack([law.L @ reads, np.eye(n) - law.L @ C, np.zeros((n, m))])
    torques = -law.K @ filtered + np.hstack([np.zeros((m, N + n)), law.Kz])
    summed, (A, B) = np.hstack([-plant.step * reads, np.zeros((m, n)), np.eye(m)]), law.model(plant.step)
    A = np.vstack([np.hstack([plant.A, np.zeros((N, n + m))]), A @ filtered + B @ torques, summed])
    return Closed(A, np.vstack([plant.B, np.zeros((n + m, m))]), -torques)
