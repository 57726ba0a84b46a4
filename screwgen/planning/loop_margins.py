"""How far each joint's loop of a stable law is from growth: gain, disk and delay margins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from .sampled_loop import Closed, rates

SLOWEST, POINTS = 1e-2, 600
"""The least frequency that is looked at, rad/s, and how many there are besides those about resonances."""
ABOUT = np.linspace(-5.0, 5.0, 41)
"""Places about a resonance, in units of its decay."""
LEAST_WIDTH = 1e-5
"""The least width of a resonance, relative to its frequency."""


class LoopMargin(NamedTuple):
    """Of the loop that is broken at the torque of one joint, all others closed."""

    lower: float
    """The factor on the torque down to which nothing grows; 0 where there is none."""
    upper: float
    """The factor up to which nothing grows; infinite where there is none."""
    disk: float
    """The largest a for which all complex factors (1 + a d / 2) / (1 − a d / 2), |d| < 1, are borne; at most 2."""
    phase: float
    """Degrees that the disk margin stands for: 2 atan(disk / 2)."""
    delay: float
    """s: what the torque may be late by, beside the hold of the clock; infinite where no frequency passes through."""

    def worse(self, other: LoopMargin) -> LoopMargin:
        """Of each figure the worse one."""
        return LoopMargin(max(self.lower, other.lower), *(min(a, b) for a, b in zip(self[1:], other[1:], strict=True)))


def worst(margins: Sequence[Sequence[LoopMargin]]) -> tuple[LoopMargin, ...]:
    """Of each joint the worst of several loops."""
    out = list(margins[0])
    for other in margins[1:]:
        out = [a.worse(b) for a, b in zip(out, other, strict=True)]
    return tuple(out)


def loop_margins(closed: Closed, step: float) -> tuple[LoopMargin, ...]:
    """The margins of the joints' loops; the closed loop has to be stable."""
    w = _frequencies(closed, step)
    inner = np.exp(1j * step * w)[:, None, None] * np.eye(len(closed.A)) - closed.transition
    moved = np.linalg.solve(inner, np.broadcast_to(closed.B, (len(w), *closed.B.shape)))
    sensitivities = 1.0 - np.einsum("jk,wkj->wj", closed.G, moved)
    return tuple(_margin(w, S) for S in sensitivities.T)


def _frequencies(closed: Closed, step: float) -> np.ndarray:
    """Frequencies up to that of Nyquist, rad/s, dense where the open or the closed loop resonates."""
    last = np.pi / step
    s = np.concatenate([rates(x, step) for x in (closed.transition, closed.A)])
    s = s[s.imag > 0]
    width = np.maximum(np.abs(s.real), LEAST_WIDTH * np.abs(s))
    near = (s.imag[:, None] + width[:, None] * ABOUT).ravel()
    every = np.concatenate([np.geomspace(SLOWEST, last, POINTS), near])
    return np.unique(every[(every >= SLOWEST) & (every <= last)])


def _margin(w: np.ndarray, S: np.ndarray) -> LoopMargin:
    """Of a sensitivity S = 1 / (1 + L) at frequencies, rad/s."""
    L = 1.0 / S - 1.0
    disk = min(2.0, float(1.0 / np.abs(S - 0.5).max()))
    cut = np.flatnonzero(np.diff(np.sign(S.imag)) != 0)
    share = S.imag[cut] / (S.imag[cut] - S.imag[cut + 1])
    real = np.concatenate([S.real[cut] + share * (S.real[cut + 1] - S.real[cut]), S.real[[0, -1]]])
    factors = [(x / (x - 1)) for x in (real[real < 0], real[real > 1])]
    lower, upper = factors[0].max(initial=0.0), factors[1].min(initial=np.inf)
    passed = np.flatnonzero(np.diff(np.sign(np.abs(L) - 1.0)) != 0)
    lag = np.angle(-L[passed]) % (2 * np.pi)
    delay = float((lag / w[passed]).min()) if len(passed) else np.inf
    return LoopMargin(float(lower), float(upper), disk, float(np.degrees(2 * np.arctan(disk / 2))), delay)
