"""How well numbers are known: the sandwich over clusters of residuals, and what the data do not determine.

Residuals of a model are correlated, because what it lacks acts for a while. Their plain covariance makes intervals many
times too narrow; here those of a fifth of a second count as one.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..lazily import linalg
from .problem import Windows
from .solve import Estimate, Fit

CLUSTER = 0.2
"""Seconds whose residuals count as one."""
NORMAL = 1.96
VAGUE = 0.5
"""Of a direction with a larger deviation, in logarithms or over a scale, the data say nothing."""
LOST = 1.0
"""A direction with a larger deviation is named: numbers may change along it 2.7 times."""
NAMED = 0.2
"""Numbers that are named of a direction: those that change by this share of the one that changes most."""


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """Of what is sought, without priors' help in `directions`."""

    deviation: np.ndarray
    """(k,): standard deviations of what is sought."""
    directions: list[tuple[np.ndarray, float]]
    """Those that the data do not determine: changes (k,) of what is sought, the largest one 1, and their deviation."""


def uncertainty(fit: Fit, at: Estimate) -> Uncertainty:
    """How well the numbers of an estimate are known."""
    found = [fit.problem.linearised(g, at.sought, s) for g, s in zip(fit.problem.groups, at.shift, strict=True)]
    k = len(at.sought)
    A, B, number = np.zeros((k, k)), np.zeros((k, k)), 0
    for group, own in zip(fit.problem.groups, found, strict=True):
        for w in range(len(group.first)):
            information, scores = _of_window(fit, group, at, own, w)
            A, B, number = A + information, B + scores.T @ scores, number + len(scores)
    B *= number / max(number - k, 1)
    directions = _directions(A, B)
    known = 1 / fit.priors[:, 1] ** 2
    inverse = np.linalg.pinv(A + np.diag(known), rcond=1e-14, hermitian=True)
    covariance = inverse @ (B + np.diag(known)) @ inverse
    deviation = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    for direction, size in directions:
        lost = (np.abs(direction) >= NAMED) & np.isinf(fit.priors[:, 1])
        deviation[lost] = np.maximum(deviation[lost], size * np.abs(direction[lost]))
    return Uncertainty(deviation, directions)


def _of_window(
    fit: Fit, group: Windows, at: Estimate, found: tuple[np.ndarray, ...], w: int
) -> tuple[np.ndarray, np.ndarray]:
    """Information (k, k) of a window on what is sought, its states eliminated, and the scores (clusters, k)."""
    r, J_x, J_p = fit.rows(group, at, found, w)
    n = J_x.shape[1]
    whole = np.vstack([J_x, np.eye(n)])
    Q, _ = np.linalg.qr(whole)
    rows = np.vstack([J_p, np.zeros((n, J_p.shape[1]))])
    rows -= Q @ (Q.T @ rows)
    sensors = found[0].shape[-1]
    seconds = np.arange(len(r)) // sensors * group.experiment.log.step
    of = (seconds // CLUSTER).astype(int)
    scores = np.zeros((of[-1] + 1, J_p.shape[1]))
    np.add.at(scores, of, rows[: len(r)] * r[:, None])
    return rows.T @ rows, scores


def _directions(A: np.ndarray, B: np.ndarray) -> list[tuple[np.ndarray, float]]:
    """The directions of which the data leave more than LOST, the vaguest first, each with as few numbers as may be."""
    values, vectors = np.linalg.eigh(A)
    slopes = np.maximum(values, max(values.max(), 1e-300) * 1e-15)
    sizes = np.sqrt(np.maximum(np.sum(vectors * (B @ vectors), axis=0), slopes)) / slopes
    lost = vectors[:, sizes > LOST]
    out = []
    for direction in _sparse(lost):
        shares = lost.T @ direction
        size = np.sqrt(np.sum((shares * sizes[sizes > LOST]) ** 2)) / np.linalg.norm(shares)
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
