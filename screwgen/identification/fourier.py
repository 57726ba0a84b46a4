"""Motions of joints as Fourier series that begin and end at rest: zero at both ends, with rates and accelerations."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from ..lazily import linalg

MOST = 10
"""Harmonics of a series at most; they are spread evenly over the logarithm of their frequencies."""


class FourierSeries:
    """Series over `time` seconds of frequencies up to `bandwidth`, Hz, at samples of `step` seconds.

    They end at the sample that is nearest to `time`. A series is a sum of `size` functions. Each function is zero at
    both ends, with its rate and its acceleration, and independent standard normal factors give all harmonics the same
    share of the rate.
    """

    def __init__(self, time: float, step: float, bandwidth: float):
        self.t = step * np.arange(max(1, round(time / step)) + 1)
        highest = max(2, int(bandwidth * self.t[-1] + 1e-9))
        self.harmonics = np.unique(np.round(np.geomspace(1, highest, min(MOST, highest))).astype(int))
        self.base = 2 * np.pi / self.t[-1]

    @cached_property
    def _free(self) -> np.ndarray:
        """(2 harmonics, size): combinations of sines and cosines, of unit rate each, that begin and end at rest."""
        n = len(self.harmonics)
        rate, acceleration = np.append(np.ones(n), np.zeros(n)), np.append(np.zeros(n), self.harmonics)
        return np.asarray(linalg.null_space(np.vstack([rate, acceleration / np.linalg.norm(acceleration)])))

    @property
    def size(self) -> int:
        """The number of functions, which is that of the factors of a series."""
        return self._free.shape[1]

    @cached_property
    def values(self) -> np.ndarray:
        """(samples, size)"""
        w = self.base * self.harmonics
        return np.hstack([np.sin(np.outer(self.t, w)) / w, (1.0 - np.cos(np.outer(self.t, w))) / w]) @ self._free

    @cached_property
    def rates(self) -> np.ndarray:
        """(samples, size), per second."""
        phase = np.outer(self.t, self.base * self.harmonics)
        return np.hstack([np.cos(phase), np.sin(phase)]) @ self._free

    @cached_property
    def accelerations(self) -> np.ndarray:
        """(samples, size), per second squared."""
        w = self.base * self.harmonics
        phase = np.outer(self.t, w)
        return np.hstack([-w * np.sin(phase), w * np.cos(phase)]) @ self._free
