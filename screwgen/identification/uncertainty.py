"""How well numbers are known: the sandwich over clusters of residuals, and what the data do not determine.

Residuals of a model are correlated, because what it lacks acts for a while. Their plain covariance makes intervals many
times too narrow; here those of a fifth of a second count as one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import NamedTuple

import numpy as np
from scipy.special import stdtrit

from ..lazily import linalg
from .problem import MeasuredCases
from .solve import Estimate, Fit
from .start_noise import LOST, NOTHING, WindowRows, told_information

CLUSTER = 0.2
"""Seconds whose residuals count as one."""
LEVERAGE = 0.99
"""The largest share of a residual of a cluster that fits may follow: with all of it a number that follows from one
cluster alone would have no interval."""
VAGUE = 1e6
"""The deviation of that of which the data say nothing at all."""
NAMED = 0.2
"""Numbers that are named of a direction: those that change by this share of the one that changes most."""


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """How well what is sought is known, by data and priors."""

    deviation: np.ndarray
    """(k,): standard deviations of what is sought."""
    directions: list[tuple[np.ndarray, float]]
    """Those that neither determines: changes (k,) of what is sought, the largest one 1, and their deviation."""
    quantile: np.ndarray
    """(k,): half an interval over the deviation."""
    correlation: np.ndarray
    """(k, k): how the errors of two numbers go together, from -1 to 1."""


def uncertainty(fit: Fit, at: Estimate) -> Uncertainty:
    """How well the numbers of an estimate are known.

    What is sought and the starts of windows follow the noise of a cluster, so that its residuals are too small. Its
    score is that of residuals as large as they were before, (I - H)^(-1/2) r with the cluster's part H of the projector
    on what is fitted, and intervals have the degrees of freedom that this leaves (Bell and McCaffrey, 2002).
    """
    found = [g.linearised(fit.problem, at.sought, s) for g, s in zip(fit.problem.groups, at.shift, strict=True)]
    by_group = [
        [_of_window(fit, group, at, own, w, shift[w]) for w in range(len(group.compared))]
        for group, own, shift in zip(fit.problem.groups, found, at.shift, strict=True)
    ]
    windows = list(chain(*by_group))
    A = np.sum([window.sought.T @ window.sought for window in windows], axis=0)
    known = np.diag(1 / fit.priors[:, 1] ** 2)
    inverse = np.linalg.pinv(A + known, rcond=1e-14, hermitian=True)
    values, vectors = np.linalg.eigh(inverse)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    clusters = [[_of_cluster(window, c, root) for c in np.unique(window.cluster)] for window in windows]
    scores = np.array([cluster.score for own in clusters for cluster in own])
    B = scores.T @ scores
    told = told_information(fit, at, found, by_group, A) + known
    directions, inverse = lost_directions(told, B + known), np.linalg.pinv(told, rcond=1e-14, hermitian=True)
    covariance = inverse @ (B + known) @ inverse
    deviation = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    if np.isfinite(fit.stated).all():  # as many readings as numbers leave no residual, and yet have their noise
        deviation = np.maximum(deviation, np.sqrt(np.diag(inverse)))
    for direction, size in directions:
        lost = np.abs(direction) >= NAMED
        deviation[lost] = np.maximum(deviation[lost], size * np.abs(direction[lost]))
    spread = np.sqrt(np.maximum(np.diag(covariance), 1e-300))
    return Uncertainty(deviation, directions, _quantiles(clusters), covariance / np.outer(spread, spread))


class _Cluster(NamedTuple):
    """The score (k,) of a cluster, and of each number sought how its square follows from noise, (..., k).

    It is that of a vector u of the residuals: `size` u·u, `by_states` and `by_sought` what u has in common with
    orthonormal directions of the start and of what is sought, along which a fit follows the noise.
    """

    score: np.ndarray
    size: np.ndarray
    by_states: np.ndarray
    by_sought: np.ndarray


def _of_window(
    fit: Fit, group: MeasuredCases, at: Estimate, found: tuple[np.ndarray, ...], w: int, shift: np.ndarray
) -> WindowRows:
    """The rows of a window.

    What is known beforehand of its start follows from its first readings, so that it counts with the first cluster.
    """
    r, J_x, J_p = fit.rows(group, at, found, w)
    n, k = J_x.shape[1], J_p.shape[1]
    Q, R = np.linalg.qr(np.vstack([J_x, np.eye(n)]))
    rows = np.vstack([J_p, np.zeros((n, k))])
    rows -= Q @ (Q.T @ rows)
    seconds = np.arange(len(r)) // found[0].shape[-1] * group.step
    cluster = np.append((seconds // CLUSTER).astype(int), np.zeros(n, int))
    return WindowRows(rows, Q, np.append(r, shift), cluster, np.linalg.solve(R, Q[: len(r)].T))


def _of_cluster(window: WindowRows, number: int, root: np.ndarray) -> _Cluster:
    """A cluster of a window; `root` (k, k) times its transpose is the inverse of the information."""
    own = window.cluster == number
    x, Q, r = window.sought[own], window.states[own], window.r[own]
    V = np.hstack([Q, x @ root])  # H = V Vᵀ
    shares, axes = np.linalg.eigh(V.T @ V)
    shares = np.clip(shares, 0.0, LEVERAGE)
    along, some = V @ axes, np.maximum(shares, 1e-9)
    half, whole = ((1 - some) ** -0.5 - 1) / some, 1 / (1 - some)  # (I - H)^a = I + along diag along^T
    common, inverse = x.T @ along, root @ root.T
    grown = x + (along * half) @ common.T
    return _Cluster(
        x.T @ r + (common * half) @ (along.T @ r),
        np.sum(inverse * ((x.T @ x + (common * whole) @ common.T) @ inverse), axis=0),
        Q.T @ grown @ inverse,
        root.T @ (x.T @ grown) @ inverse,
    )


def _quantiles(clusters: Sequence[Sequence[_Cluster]]) -> np.ndarray:
    """Within so many deviations each number is in 95 of 100 cases, Student's of as many degrees as clusters leave.

    `clusters`: those of every window. With noise of one size the sum of squared scores has the mean tr Ω and the
    variance 2 tr Ω², Ω the products of what scores make of the noise that fits leave.
    """
    trace, square = 0.0, 0.0
    by_sought = [np.stack([c.by_sought for c in own], axis=1) for own in clusters]  # (k, clusters, k) of each window
    for own, T in zip(clusters, by_sought, strict=True):
        S = np.stack([c.by_states for c in own], axis=1)
        block = np.einsum("cj,cd->cdj", np.array([c.size for c in own]), np.eye(len(own)))
        block -= np.einsum("scj,sdj->cdj", S, S)
        trace = trace + np.einsum("ccj->j", block) - np.sum(T**2, axis=(0, 1))
        square = square + np.sum(block**2, axis=(0, 1)) - 2 * np.einsum("scj,sdj,cdj->j", T, T, block)
    T = np.concatenate(by_sought, axis=1)
    square = square + np.sum(np.einsum("scj,tcj->stj", T, T) ** 2, axis=(0, 1))
    return np.asarray(stdtrit(np.maximum(trace**2 / np.maximum(square, 1e-300), 1.0), 0.975))


def lost_directions(A: np.ndarray, B: np.ndarray) -> list[tuple[np.ndarray, float]]:
    """The directions of which the data leave more than LOST, the vaguest first, each with as few numbers as may be."""
    values, vectors = np.linalg.eigh(A)
    slopes = np.where(values > NOTHING * values.max(), values, VAGUE**-2)
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
