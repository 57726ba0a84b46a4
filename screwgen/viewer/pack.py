"""Numbers for the page: samples thinned and rounded within stated bounds, as base64."""

from __future__ import annotations

from base64 import b64encode
from typing import Any

import numpy as np

from ..plotting.curves import thin

STRIDES = (64, 48, 32, 24, 16, 12, 8, 6, 5, 4, 3, 2, 1)
"""Of how many samples one is kept, tried in this order."""
MOST_BYTES = 1_000_000
"""What the samples of a motion may take before they are written as text."""
POINTS = 1200
"""At most so many points of a curve are written."""


def floats(values: np.ndarray) -> str:
    """Numbers in single precision, little endian."""
    return b64(np.ascontiguousarray(values, "<f4"))


def b64(values: np.ndarray) -> str:
    """The bytes of an array."""
    return b64encode(values.tobytes()).decode()


def rounded(values: np.ndarray, tolerance: np.ndarray) -> dict[str, Any]:
    """The columns (N, c), each as multiples of a step above its least value, off by half a step at most.

    A column takes 16 bits where its step is then no larger than its `tolerance` (c,), else 32.
    """
    low, span = values.min(axis=0), np.ptp(values, axis=0)
    wide = span / (2**16 - 1) > tolerance
    step = np.where(span > 0, span / np.where(wide, 2**32 - 1, 2**16 - 1), 1.0)
    counts = np.rint((values - low) / step).T
    data = [b64(row.astype("<u4" if w else "<u2")) for row, w in zip(counts, wide, strict=True)]
    return {"low": low.tolist(), "step": step.tolist(), "wide": wide.tolist(), "data": data}


def kept(t: np.ndarray, values: np.ndarray, tolerance: np.ndarray, width: int) -> tuple[np.ndarray, float]:
    """The rows of samples to keep, and how far the others are at most from straight lines between these.

    Few enough that straight lines stay within `tolerance` (c,) of `values` (N, c), or that `width` bytes for each
    sample are at most `MOST_BYTES`. The distance is in tolerances.
    """
    least = max(1, -(-len(t) * width // MOST_BYTES))
    for stride in [s for s in STRIDES if s > least] + [least]:
        rows = np.unique(np.append(np.arange(0, len(t), stride), len(t) - 1))
        error = _error(t, values, rows, tolerance)
        if error <= 1:
            break
    return rows, error


def _error(t: np.ndarray, values: np.ndarray, rows: np.ndarray, tolerance: np.ndarray) -> float:
    lines = np.array([np.interp(t, t[rows], x) for x in values[rows].T]).T
    return float((np.abs(lines - values) / tolerance).max(initial=0.0))


def curve(
    label: str, t: np.ndarray, values: np.ndarray, color: str, dash: int = 0, goal: bool = False
) -> dict[str, Any]:
    """A curve over time, thinned without losing its peaks; `color`: its name on the page, `goal`: of set points."""
    x, y = thin(t, values, POINTS)
    return {"label": label, "color": color, "dash": dash, "goal": goal, "x": floats(x), "y": floats(y)}
