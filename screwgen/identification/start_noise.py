"""What noise in the starts of windows seems to tell, and which directions the data tell beyond it.

A vibration that noise alone has put into the start of a window seems to tell a stiffness by its frequency. Readings of
the size of residuals are drawn, and what starts that follow them tell is held against what the starts of the fit tell.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.special import chdtri, fdtrc, gammaln

from .problem import MeasuredCases
from .solve import Estimate, Fit

LOST = 1.0
"""Of a number or a direction with a larger deviation, in logarithms or over a scale, the data say nothing: in
a third of all cases it is more than 2.7 times as large or as small."""
CHANCE = 0.01
"""How often of what the data do not tell noise may seem to tell something."""
DRAWS = (1, 8)
"""Draws of noise: the second where after the first not all directions are told beyond it."""
PHASES = 2.0
"""A vibration with which a window begins has so many numbers: how large it is, and when."""
HALVED, RARE = 40, 1e-3
"""How often such noise is halved where motions that begin with it are further from readings than noise is so often."""
NOTHING = 1e-15
"""The share of the largest information that is rounding."""


class WindowRows(NamedTuple):
    """Rows (m, ...) of a window: residuals, then what is known beforehand of its start."""

    sought: np.ndarray
    """(m, k): how they change with what is sought, its states eliminated."""
    states: np.ndarray
    """(m, n): an orthonormal basis of how they change with its start."""
    r: np.ndarray
    cluster: np.ndarray
    """The number of the cluster of each row."""
    follows: np.ndarray
    """(n, m - n): how its start follows readings, both in their deviations."""


Linearised = Sequence[tuple[np.ndarray, ...]]
"""Of every group differences and derivatives."""


def told_information(
    fit: Fit, at: Estimate, found: Linearised, windows: Sequence[Sequence[WindowRows]], A: np.ndarray
) -> np.ndarray:
    """The part (k, k) of the information of data that is not what noise in starts makes."""
    rng, noise = np.random.default_rng(0), np.zeros((0, sum(map(len, windows)), *A.shape))
    for draws in DRAWS:
        more = [_drawn(fit, at, found, windows, rng) for _ in range(draws - len(noise))]
        noise = np.concatenate([noise, np.array(more).reshape(len(more), *noise.shape[1:])])
        told, all_told = beyond_noise(A, noise)
        if all_told:
            break
    return told


def beyond_noise(A: np.ndarray, noise: np.ndarray) -> tuple[np.ndarray, bool]:
    """Of the information A (k, k) that of the directions told beyond noise, and whether these are all.

    `noise` (draws, windows, k, k): the information that draws of noise have. Directions are those in which neither has
    anything in common: x of A x = ratio N x.
    """
    N = noise.sum(axis=1).mean(axis=0)
    scale = np.sqrt(np.maximum(np.diag(A + N), 1e-300))
    both = (A + N) / np.outer(scale, scale)
    values, vectors = np.linalg.eigh(both)
    own = values > NOTHING * values.max(initial=0.0)
    white = vectors[:, own] / np.sqrt(values[own])
    shares, axes = np.linalg.eigh(white.T @ (N / np.outer(scale, scale)) @ white)
    directions = white @ axes
    dual = (both @ directions) * scale[:, None]
    told = np.array([_told(x, d / scale, noise) for x, d in zip(shares, directions.T, strict=True)], bool)
    return (dual * (np.clip(1 - shares, 0.0, 1.0) * told)) @ dual.T, bool(told.all())


def _told(share: float, direction: np.ndarray, noise: np.ndarray) -> bool:
    """Whether in a direction (k,), where noise has this share of all information, the rest is hardly more noise."""
    direction = direction / np.abs(direction).max()
    draws, of_windows = len(noise), np.einsum("i,dwij,j->w", direction, noise, direction) / len(noise)
    if not (made := of_windows.sum()) > 0 or share < NOTHING:
        return True
    alike = (1 + 1 / draws) * made**2 / np.sum(of_windows**2)  # windows, were all alike: χ² of two varies by its mean
    freedom = PHASES * min(alike, len(of_windows))
    return chance(max(1 - share, 0.0) / share, freedom, draws, float(np.sqrt(made / freedom))) < CHANCE


def chance(ratio: float, freedom: float, draws: int, speed: float) -> float:
    """How probable it is that noise tells `ratio` times what so many draws of it do, where it tells most.

    The fit looks for what explains noise best, so that the information is the largest of a process of χ², whose
    vibrations become others as the number that is sought changes by 1 / `speed`. The bound is that of Davies (1987),
    what is expected of crossings of a level over ± LOST, with draws that vary as χ² of `freedom` times `draws` does.
    """
    m, b, c = freedom * draws, (freedom - 1) / 2, freedom * ratio / 2
    level = b * np.log(2 * c / m) + gammaln(m / 2 + b) - gammaln(m / 2) - (m / 2 + b) * np.log1p(2 * c / m)
    crossings = 2 * LOST * speed / np.sqrt(np.pi) * np.exp(level - gammaln(freedom / 2))
    return float(fdtrc(freedom, m, ratio) + crossings)


def _drawn(
    fit: Fit, at: Estimate, found: Linearised, windows: Sequence[Sequence[WindowRows]], rng: np.random.Generator
) -> np.ndarray:
    """The information (windows, k, k) that one draw of noise in starts has."""
    out, differences = list[np.ndarray](), [x for x, *_ in found]
    sizes = np.nan_to_num(fit.sizes(differences) / at.noise)
    for group, own, shift, now in zip(fit.problem.groups, windows, at.shift, differences, strict=True):
        if not shift.size:
            out += [np.zeros((len(at.sought),) * 2)] * len(own)
            continue
        readings = rng.standard_normal(now.shape) * sizes[fit.problem.own(group)]
        drawn = np.array([window.follows @ x.ravel() for window, x in zip(own, readings, strict=True)])
        most = fit.costs(group, shift, now, at.noise) + chdtri(shift.shape[1], RARE) / 2
        change = _likely(fit, at, group, shift, drawn, most)
        ends = [group.linearised(fit.problem, at.sought, shift + sign * change) for sign in (1.0, -1.0)]
        for w, window in enumerate(own):
            ahead, behind = (fit.rows(group, at, end, w)[2] for end in ends)
            part = np.vstack([ahead - behind, np.zeros((shift.shape[1], len(at.sought)))]) / 2
            part -= window.states @ (window.states.T @ part)
            out.append(part.T @ part)
    return np.array(out)


def _likely(
    fit: Fit, at: Estimate, group: MeasuredCases, shift: np.ndarray, change: np.ndarray, most: np.ndarray
) -> np.ndarray:
    """The change (W, states) of starts, halved of windows whose cost either sign of it brings above the `most` (W,)."""
    lanes, left = np.arange(len(shift)), change.copy()
    for _ in range(HALVED):
        ends = [shift + sign * left for sign in (1.0, -1.0)]
        found = [group.differences(fit.problem, lanes, np.tile(at.sought, (len(lanes), 1)), end) for end in ends]
        costs = [fit.costs(group, end, own, at.noise) for end, own in zip(ends, found, strict=True)]
        if not (wrong := np.max(costs, axis=0) > most).any():
            break
        left[wrong] /= 2
    return left
