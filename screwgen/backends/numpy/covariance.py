"""Roots of covariances: a filter that works on them keeps its covariance positive semidefinite."""

from __future__ import annotations

import numpy as np

from ...errors import DivergedError, SingularError

LOST = "the filter's covariance has lost its definiteness"
KNOWN = 8
"""Rounding errors of the variance of an entry; with less left of it, the entry follows from others."""


def root(P: np.ndarray, real: type = np.float64) -> np.ndarray:
    """``S`` (n, rank) with ``S S^T = P``: Cholesky's elimination, what is left most uncertain first.

    Uncertain is relative to the variance of each entry. Variances are taken for zero where products of deviations
    lose digits as they underflow. Raises DivergedError, or SingularError where P (n, n) is indefinite by more than
    rounding errors of ``real``.
    """
    if not np.isfinite(P).all():
        raise DivergedError("the filter's covariance is not finite")
    precision, variance = np.finfo(real), np.diag(P)
    remaining = variance > precision.tiny / precision.eps
    scale = np.divide(1.0, variance, out=np.zeros(len(P)), where=remaining)
    left, S, rank = variance.copy(), np.zeros_like(P), 0
    while remaining.any():
        share = np.where(remaining, left * scale, -np.inf)
        i = int(np.argmax(share))
        if not share[i] > KNOWN * precision.eps:
            break
        pivot = np.sqrt(left[i])
        column = np.where(remaining, P[:, i] - S[:, :rank] @ S[i, :rank], 0.0) / pivot
        column[i], remaining[i] = pivot, False
        S[:, rank], left, rank = column, left - column**2, rank + 1
    if (variance < 0).any() or (left < -np.sqrt(precision.eps) * variance)[remaining].any():
        raise SingularError(LOST)
    return S[:, :rank]


def corrected(
    S: np.ndarray,
    H: np.ndarray,
    innovations: np.ndarray,
    variances: np.ndarray,
    slips: np.ndarray | float = 0.0,
    factors: np.ndarray | float = 1.0,
) -> tuple[np.ndarray, np.ndarray, float]:
    """The correction (n,) of the mean by measurements, and the root after it, of the root ``S`` before it.

    Carlson's update by one row of ``H`` after the other, which subtracts no variance from another. Before a row counts,
    what it measures moves by its slip (rows,), each part in proportion to its variance and nothing else, and all
    deviations become larger by its factor (rows,), or by what is more than rows before have made of them. The third
    result is the normalised innovation squared of all rows: the sum of squares of what each adds to those before it.
    """
    dx, squared, wider, variance = np.zeros(len(S)), 0.0, 1.0, np.sum(S * S, axis=1)
    extra = (np.broadcast_to(x, len(H)) for x in (slips, factors))
    for row, rest, R, slip, factor in zip(H, innovations, variances, *extra, strict=True):
        if slip:
            dx = dx + slip * variance * row / (row @ (variance * row) or np.inf)
        S, wider = S * max(factor / wider, 1.0), max(wider, factor)
        f = S.T @ row
        total = R + np.cumsum(f[::-1] ** 2)[::-1]
        shrink = np.sqrt(np.append(total[1:], R)[: len(f)] / total)
        sums = np.cumsum((S * f)[:, ::-1], axis=1)[:, ::-1]
        squared += float((rest - row @ dx) ** 2 / (total[0] if len(f) else R))
        if len(f):
            dx = dx + sums[:, 0] / total[0] * (rest - row @ dx)
        later = np.hstack([sums[:, 1:], np.zeros((len(S), min(len(f), 1)))])
        S = shrink * S - f / (shrink * total) * later
    return dx, S, squared


def deviations(S: np.ndarray, H: np.ndarray, variances: np.ndarray) -> np.ndarray:
    """The standard deviations of innovations: of rows of ``H``, and of the measurements themselves."""
    return np.sqrt(variances + np.sum((H @ S) ** 2, axis=1))
