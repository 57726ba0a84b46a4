"""Undamped vibrations: of mass and stiffness matrices, and of each link of a robot clamped at its base."""

from __future__ import annotations

import numpy as np

from ...lazily import linalg
from ...spec.base import FIXED
from ...spec.joint import Joint
from ...spec.parameters import parameters
from ...spec.robot import OF_SEVERAL, Robot
from ...topology.chain import Chain
from .numeric import Numeric


def held_frequencies(robot: Robot, link: int) -> np.ndarray:
    """The natural frequencies (modes,) in Hz, ascending, of one link of a robot held at its base, without gravity.

    The link is straight and carries its own bodies, and no other link. They are those of `natural_frequencies` of a
    robot that has this link alone. A link without bodies has the frequencies of its bare modes.
    """
    alone = robot.links[link].model_copy(update={"joint": Joint(axes=()), "parent": None, "at": "tip"})
    update = {"links": (alone,), **dict.fromkeys(OF_SEVERAL, ()), "base": FIXED, "gravity": (0.0, 0.0, 0.0)}
    chain = Chain(robot.model_copy(update=update))
    if not chain.n_modes:
        return np.zeros(0)
    rest = np.zeros(chain.nq)
    M, K, _ = Numeric(chain, [p.value for p in parameters(chain.robot)]).slopes(rest, rest, None, None)
    basis, k = uncoupled((K + K.T) / 2)
    return vibrations(basis.T @ ((M + M.T) / 2) @ basis, k)[0] / (2 * np.pi)


def vibrations(M: np.ndarray, k: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Angular frequencies, ascending, and columns of unit modal mass of `M ẍ + k x = 0`; all `k` > 0.

    With `M = L Lᵀ` the columns of `Lᵀ k^(-1/2)` have the singular values 1/ω. Springs that differ by many orders of
    magnitude scale its columns, which a Jacobi method bears: every frequency keeps its digits. An eigenvalue solver
    for `k` and `M` leaves an error of the stiffest spring's size in the softest mode.
    """
    if not len(k):
        return np.zeros(0), np.zeros((0, 0))
    L = linalg.cholesky(M, lower=True)
    periods, vectors, _, scale, _, failed = linalg.lapack.dgejsv(L.T / np.sqrt(k), joba=0, jobv=3, jobp=0)
    if failed:
        raise np.linalg.LinAlgError("the Jacobi method does not converge")
    return scale[1] / scale[0] / periods, linalg.solve_triangular(L.T, vectors)


def uncoupled(K: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Columns ``T`` (n, n) with ``T^T K T = diag(k)``, and ``k`` (n,); rows of ``K`` without a spring are zero.

    ``K = L diag(k) L^T`` and ``T = L^-T``, so that small stiffnesses keep their digits beside large ones.
    """
    k, held = np.diag(K).copy(), np.flatnonzero(np.diag(K))
    T = np.eye(len(K))
    if not np.array_equal(K, np.diag(k)):
        C = linalg.cholesky(K[np.ix_(held, held)], lower=True)
        k[held] = np.diag(C) ** 2
        T[np.ix_(held, held)] = linalg.solve_triangular(C / np.diag(C), np.eye(len(held)), lower=True).T
    return T, k


def without_rigid_motion(M: np.ndarray, k: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """Mass and stiffness with the coordinates that no spring holds eliminated, and how many they are.

    Such a coordinate follows the others without force: `M <- M_ee − M_er M_rr⁻¹ M_re`.
    """
    free, held = np.flatnonzero(k == 0), np.flatnonzero(k)
    factor = linalg.cho_factor(M[np.ix_(free, free)]) if len(free) else None
    rest = M[np.ix_(held, held)]
    if factor is not None and len(held):
        coupling = M[np.ix_(free, held)]
        rest = rest - coupling.T @ linalg.cho_solve(factor, coupling)
    return rest, k[held], len(free)
