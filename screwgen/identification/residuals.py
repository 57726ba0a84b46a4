"""What windows leave of logs: its spectrum, in shares of how much the sensor varies."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .identification import Explained


def spectrum(logs: Sequence[Explained], sensor: str) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies (F,), Hz, and the power of residuals at each, over the sensor's variance: the mean over windows."""
    number = 0
    total: np.ndarray = np.zeros(0)
    frequencies: np.ndarray = np.zeros(0)
    for log in logs:
        k = log.sensors.index(sensor)
        residual = np.nan_to_num(log.readings[:, k] - log.windows[:, k])
        variance = max(float(np.nanvar(log.readings[:, k])), 1e-300)
        size = int(log.first[1] - log.first[0]) if len(log.first) > 1 else len(residual)
        step = float(log.t[1] - log.t[0])
        if not len(frequencies):
            frequencies = np.fft.rfftfreq(size, step)
            total = np.zeros(len(frequencies))
        for first in log.first:
            part = residual[first : first + size]
            if len(part) == size:
                own = np.abs(np.fft.rfft(part)) ** 2 * 2 / size**2 / variance
                total = total + np.interp(frequencies, np.fft.rfftfreq(size, step), own)
                number += 1
    return frequencies, total / max(number, 1)
