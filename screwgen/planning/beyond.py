"""What is said where a scheduled law is asked for beyond the range that it was made for."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arguments import Numbers

ROUNDING = 1e-9
"""By the width of a range, how far beyond it something may be without a word."""


def beyond(names: Sequence[str], place: np.ndarray, lower: Numbers, upper: Numbers) -> str | None:
    """A line about the first variable of `place` (V,) that is out of its range; None where all are within."""
    for name, x, low, high in zip(names, place, np.asarray(lower), np.asarray(upper), strict=True):
        if max(low - x, x - high) > ROUNDING * (high - low):
            return f"{name} is {x:.4g}, the law was made for {low:.4g} to {high:.4g}; the nearer end is taken"
    return None
