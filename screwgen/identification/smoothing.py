"""Readings without noise: a cubic through those about a sample gives value and rate, with their deviations."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

DEGREE = 3
SHARE = 0.05
"""The share of a window over which a cubic is laid, to either side."""
QUICK = 10.0
"""How many times quicker than the cubic a vibration may be."""
ALIKE = 0.3
"""The correlation of neighbours from which on what smoothing leaves is no noise."""
LEAST = 4
"""Samples to either side at least."""


class Smoothed(NamedTuple):
    """Value and rate of columns (columns,) at a time, and how far they may be off."""

    value: np.ndarray
    rate: np.ndarray
    of_value: np.ndarray
    of_rate: np.ndarray


def smoothed(readings: np.ndarray, at: int, step: float, reach: int) -> Smoothed:
    """The columns of readings (N, columns) at a sample, by cubics through those within `reach`; NaN are left out."""
    first = max(0, min(at - reach, len(readings) - 2 * reach - 1))
    part = readings[first : first + 2 * reach + 1]
    time = (np.arange(first, first + len(part)) - at) * step
    scale = reach * step
    powers = (time[:, None] / scale) ** np.arange(DEGREE + 1)
    found = [_fitted(powers, column) for column in part.T]
    value, rate, of_value, of_rate = (np.array(x) for x in zip(*found, strict=True))
    return Smoothed(value, rate / scale, of_value, of_rate / scale)


def _fitted(powers: np.ndarray, column: np.ndarray) -> tuple[float, float, float, float]:
    """Value and slope at 0, and how far they may be off: what is not cubic is a vibration as often as it is noise."""
    there = np.isfinite(column)
    if there.sum() <= DEGREE + 1:
        return 0.0, 0.0, np.inf, np.inf
    own = powers[there]
    found, *_ = np.linalg.lstsq(own, column[there], rcond=None)
    spread = np.sqrt(np.sum((column[there] - own @ found) ** 2) / (len(own) - DEGREE - 1))
    return found[0], found[1], spread, QUICK * spread


def motion(column: np.ndarray, step: float, reach: int) -> tuple[np.ndarray, np.ndarray]:
    """Values and rates (N,) of a column that moves an axis, by cubics over as many samples as leave noise alone."""
    from scipy.signal import savgol_filter

    while True:
        length = min(2 * reach + 1, len(column) - (len(column) + 1) % 2)
        value = savgol_filter(column, length, DEGREE)
        rest = column - value
        if reach <= LEAST or abs(rest[1:] @ rest[:-1]) <= ALIKE * (rest @ rest):
            return value, savgol_filter(column, length, DEGREE, deriv=1, delta=step)
        reach = max(LEAST, reach // 2)
