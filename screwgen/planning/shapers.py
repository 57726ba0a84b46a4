"""Input shapers: trains of impulses that leave a vibration at rest, whose convolution with a reference does so too."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import Numbers, choice, real_numbers
from ..errors import UsageError

KINDS = ("zv", "zvd", "ei")
LOOP, LOCKED = VIBRATES = ("poles of the closed loop", "the arm with joints locked")
"""In words: what vibrates."""
TOLERATED = 0.05
"""The residual vibration that an EI shaper has at its frequency, so that it bears more error of it."""


@dataclass(frozen=True, eq=False)
class Shaper:
    """Impulses at `times`, s, with `amplitudes` that add up to one."""

    times: np.ndarray
    amplitudes: np.ndarray

    @property
    def delay(self) -> float:
        """How much later a reference ends, s."""
        return float(self.times[-1])

    def residual(self, frequency: Any, damping: float = 0.0) -> np.ndarray:
        """What it leaves of the vibration of one impulse, at frequencies, Hz, of damped modes."""
        w = 2 * np.pi * np.asarray(frequency, float)[..., None]
        decay, turn = damping * w, w * np.sqrt(1 - damping**2)
        left = self.amplitudes * np.exp(-decay * (self.delay - self.times) + 1j * turn * self.times)
        return np.abs(left.sum(axis=-1))

    def __call__(self, reference: Any, t: float) -> Any:
        """The shaped reference at a time: a function of time, asked at every impulse's distance."""
        return sum(a * np.asarray(reference(t - s)) for s, a in zip(self.times, self.amplitudes, strict=True))

    def __matmul__(self, other: Shaper) -> Shaper:
        """The convolution of two."""
        times = (self.times[:, None] + other.times).ravel()
        amplitudes = np.outer(self.amplitudes, other.amplitudes).ravel()
        order = np.argsort(times, kind="stable")
        return Shaper(times[order], amplitudes[order])


def shaper(frequencies: Numbers | float, damping: Numbers | float = 0.0, kind: str = "zv") -> Shaper:
    """The shaper of modes with natural `frequencies`, Hz, and `damping` ratios, one for all or one for each.

    `kind`: "zv" leaves no vibration; "zvd" bears errors of the frequency to first order and takes twice as long;
    "ei" leaves 5 % at the frequency, and bears larger errors than that in the same time. Several modes: a convolution.
    What vibrates are the poles of the closed loop under a joint law, and the arm with joints held where these are so.
    Raises UsageError.
    """
    kind = choice(kind, KINDS, "kind: there is no")
    f, z = (real_numbers(x) for x in (frequencies, damping))
    if f is None or z is None or f.ndim > 1 or z.size not in (1, f.size) or not f.size:
        raise UsageError("frequencies, damping: give numbers, as many ratios as frequencies, or one for all")
    f, z = np.atleast_1d(f), np.broadcast_to(np.atleast_1d(z), np.atleast_1d(f).shape)
    if not (np.isfinite(f).all() and (f > 0).all()):
        raise UsageError("frequencies: must be finite numbers > 0, Hz")
    if not ((z >= 0) & (z < 1)).all():
        raise UsageError("damping: ratios must be from 0 to less than 1")
    out = Shaper(np.zeros(1), np.ones(1))
    for own, ratio in zip(f, z, strict=True):
        out = out @ _single(float(own), float(ratio), kind)
    return out


def _single(f: float, damping: float, kind: str) -> Shaper:
    """The shaper of one mode, impulses half a damped period apart."""
    half = 0.5 / (f * np.sqrt(1 - damping**2))
    K = float(np.exp(-np.pi * damping / np.sqrt(1 - damping**2)))
    if kind == "zv":
        a = np.array([1.0, K])
    elif kind == "zvd":
        a = np.array([1.0, 2 * K, K * K])
    else:
        v = TOLERATED * (1 + K) ** 2 / (4 * K * K - TOLERATED * (1 - K) ** 2)
        if not 0 < v < 1:
            raise UsageError(f"damping: a ratio of {damping:g} is too large for an EI shaper; take zv or zvd")
        a = np.array([1 + v, 2 * (1 - v) * K, (1 + v) * K * K])
    return Shaper(half * np.arange(len(a)), a / a.sum())
