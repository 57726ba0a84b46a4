"""The equations of coordinates whose motion is given, among those of all others."""

from __future__ import annotations

import numpy as np

from ...topology.chain import Chain


def places(chain: Chain) -> list[int]:
    """These coordinates, as indices in `v`."""
    return list(chain.given.values())


def set_apart(
    chain: Chain, M: np.ndarray, by_q: np.ndarray, by_v: np.ndarray, by_tau: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Inertia and forces of the equations by which these coordinates have the accelerations that are given.

    The others feel what these need of them; for what is given nothing else counts.
    """
    if not (own := places(chain)):
        return M, by_q, by_v, by_tau
    by_tau = by_tau.copy()
    by_tau[:, list(chain.given)] = -M[:, own]
    M, by_q, by_v = M.copy(), by_q.copy(), by_v.copy()
    for x in (by_q, by_v, by_tau, M, M.T):
        x[own] = 0.0
    M[own, own] = by_tau[own, list(chain.given)] = 1.0
    return M, by_q, by_v, by_tau


def answers(chain: Chain, M: np.ndarray, forces: np.ndarray) -> np.ndarray:
    """The accelerations (nv, k) by generalised forces (nv, k), while nothing else acts; what is given does not move."""
    if not (own := places(chain)):
        return np.linalg.solve(M, forces)
    others = np.setdiff1d(np.arange(len(M)), own)
    out = np.zeros(forces.shape)
    out[others] = np.linalg.solve(M[np.ix_(others, others)], forces[others])
    return out
