"""How well numbers are known: the sandwich over clusters of residuals, and what the data do not determine.

Residuals of a model are correlated, because what it lacks acts for a while. Their plain covariance makes intervals many
times too narrow; here those of a fifth of a second count as one.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.special import stdtrit

from ..lazily import linalg
from .problem import MeasuredCases
from .solve import Estimate, Fit

CLUSTER = 0.2
"""Seconds whose residuals count as one."""
LEVERAGE = 0.99
"""The share of the information of a cluster that is taken off: with all of it a number that follows from one alone
would have no interval."""
LOST = 1.0
"""Of a number or a direction with a larger deviation, in logarithms or over a scale, the data say nothing: in
a third of all cases it is more than 2.7 times as large or as small."""
NAMED = 0.2
"""Numbers that are named of a direction: those that change by this share of the one that changes most."""


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """How well what is sought is known, by data and priors."""

    deviation: np.ndarray
    """(k,): standard deviations of what is sought."""
    directions: list[tuple[np.ndarray, float]]
    """Those that neither determines: changes (k,) of what is sought, the largest one 1, and their deviation."""
    quantile: float
    """Half an interval over the deviation."""


def uncertainty(fit: Fit, at: Estimate) -> Uncertainty:
    """How well the numbers of an estimate are known.

    The score of a cluster is what it would be if the numbers had been found without it: a cluster from which a number
    follows has a residual that is too small.
    """
    found = [g.linearised(fit.problem, at.sought, s) for g, s in zip(fit.problem.groups, at.shift, strict=True)]
    windows = [
        _of_window(fit, group, at, own, w, shift[w])
        for group, own, shift in zip(fit.problem.groups, found, at.shift, strict=True)
        for w in range(len(group.compared))
    ]
    A = np.sum([information for information, _, _ in windows], axis=0)
    scores = np.concatenate([own for _, _, own in windows])
    parts = np.concatenate([own for _, own, _ in windows])
    known = np.diag(1 / fit.priors[:, 1] ** 2)
    inverse = np.linalg.pinv(A + known, rcond=1e-14, hermitian=True)
    left = np.eye(len(A)) - LEVERAGE * parts @ inverse
    scores = np.linalg.solve(left, scores[..., None])[..., 0]
    B = scores.T @ scores
    directions = lost_directions(A + known, B + known)
    covariance = inverse @ (B + known) @ inverse
    deviation = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    if np.isfinite(fit.stated).all():  # as many readings as numbers leave no residual, and yet have their noise
        deviation = np.maximum(deviation, np.sqrt(np.diag(inverse)))
    for direction, size in directions:
        lost = np.abs(direction) >= NAMED
        deviation[lost] = np.maximum(deviation[lost], size * np.abs(direction[lost]))
    return Uncertainty(deviation, directions, _quantile(len(scores) - len(A)))


def _quantile(freedom: int) -> float:
    """Within so many deviations a number is in 95 of 100 cases, Student's, when clusters leave so many degrees."""
    return float(stdtrit(max(freedom, 1), 0.975))


def _of_window(
    fit: Fit, group: MeasuredCases, at: Estimate, found: tuple[np.ndarray, ...], w: int, shift: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Information (k, k) of a window on what is sought, its states eliminated, that of clusters, and their scores.

    What is known beforehand of its start follows from its first readings, so that it counts with the first cluster.
    """
    r, J_x, J_p = fit.rows(group, at, found, w)
    n, k = J_x.shape[1], J_p.shape[1]
    Q, _ = np.linalg.qr(np.vstack([J_x, np.eye(n)]))
    rows = np.vstack([J_p, np.zeros((n, k))])
    rows -= Q @ (Q.T @ rows)
    sensors = found[0].shape[-1]
    seconds = np.arange(len(r)) // sensors * group.step
    of = (seconds // CLUSTER).astype(int)
    own = [rows[: len(r)][of == c] for c in range(of[-1] + 1)]
    scores = np.array([x.T @ r[of == c] for c, x in enumerate(own)])
    scores[0] += rows[len(r) :].T @ shift
    return rows.T @ rows, np.array([x.T @ x for x in own]), scores


def lost_directions(A: np.ndarray, B: np.ndarray) -> list[tuple[np.ndarray, float]]:
    """The directions of which the data leave more than LOST, the vaguest first, each with as few numbers as may be."""
    values, vectors = np.linalg.eigh(A)
    slopes = np.maximum(values, max(values.max(), 1e-300) * 1e-15)
    sizes = np.sqrt(np.maximum(np.sum(vectors * (B @ vectors), axis=0), slopes)) / slopes
    lost = vectors[:, sizes > LOST]
    out = []
    for direction in _sparse(lost):
        shares = lost.T @ direction
        size = sizes.max() * np.linalg.norm(shares * sizes[sizes > LOST] / sizes.max()) / np.linalg.norm(shares)
        out.append((direction, float(size / np.linalg.norm(direction))))
    return sorted(out, key=lambda x: -x[1])


def _sparse(basis: np.ndarray) -> list[np.ndarray]:
    """Other directions (k,) of the space of these (k, d): each has an entry that is 0 in all others, and is 1 at most.

    The entries are chosen by pivoting, so that directions that have nothing in common fall apart.
    """
    if not basis.shape[1]:
        return []
    _, _, order = linalg.qr(basis.T, pivoting=True)
    pivots = order[: basis.shape[1]]
    found = (basis @ np.linalg.inv(basis[pivots])).T
    return [row / row[np.argmax(np.abs(row))] for row in found]
