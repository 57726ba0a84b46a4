"""Limits between the points of a programme: where the polynomials of a motion leave them.

A programme asks at its points alone. Where a motion passes a limit between them, the next search asks there too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from .hermite import hermite, slope
from .members import PlannedModel
from .task import Task

PARTS = np.arange(64) / 64
"""Where stretches between neighbouring points are looked at, in shares of them."""
TOUCHED, LEAST = 1e-4, 1e-6
"""How far a limit may be passed between points without a word: by its size, of a range by the way of its joint; and, in
units of the limit, as far as the search itself is exact."""


class Curve(NamedTuple):
    """Coordinates, rates and accelerations (n, points) at points that are equally far apart, `h` seconds."""

    q: Any
    v: Any
    a: Any
    h: float

    def at(self, k: Any, s: Any) -> tuple[Any, Any]:
        """Coordinates and rates between points `k` and those after them, at a share of the way."""
        (q0, q1), (v0, v1), (a0, a1) = ((x[:, k], x[:, k + 1]) for x in (self.q, self.h * self.v, self.h**2 * self.a))
        return hermite(q0, q1, v0, v1, a0, a1, s), slope(q0, q1, v0, v1, a0, a1, s) / self.h


def place(share: float, points: int) -> tuple[int, float]:
    """The stretch in which a share of the time is, and the share of that."""
    stretches = points - 1
    k = min(int(share * stretches), stretches - 1)
    return k, share * stretches - k


def broken(task: Task, members: Sequence[PlannedModel], motions: Sequence[Any]) -> tuple[float, ...]:
    """The shares of the time, between points, at which a motion passes a limit of joints or strains the most."""
    found: set[float] = set()
    for member, motion in zip(members, motions, strict=True):
        stretches = motion.q.shape[1] - 1
        curve = Curve(motion.q[..., None], motion.v[..., None], motion.a[..., None], task.time / stretches)
        q, v = (x.reshape(len(x), -1) for x in curve.at(np.arange(stretches), PARTS))
        for excess, size in _excesses(task, member, q, v):
            most = (excess[:, 1:-1] >= excess[:, :-2]) & (excess[:, 1:-1] >= excess[:, 2:])
            passed = (most & (excess[:, 1:-1] > TOUCHED * size[:, None] + LEAST)).any(axis=0)
            found |= {float(k / (stretches * len(PARTS))) for k in 1 + np.flatnonzero(passed)}
    return tuple(sorted(found - set(task.between)))


def _excesses(
    task: Task, member: PlannedModel, q: np.ndarray, v: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """By how much each row (rows, places) passes its limit, and its size (rows,); of rows that have one."""
    limits, m = task.limits, len(task.start)
    bound = np.isfinite(limits.rates)
    yield np.abs(v[:m][bound]) - limits.rates[bound, None], limits.rates[bound]
    for sign, most in ((1.0, limits.upper), (-1.0, -limits.lower)):
        bound = np.isfinite(most)
        yield sign * q[:m][bound] - most[bound, None], np.abs(task.way[bound])
    if (bound := np.isfinite(limits.strains)).any():
        sizes = np.abs(np.array(member.still.strains(q)))[bound]
        yield sizes - limits.strains[bound, None], limits.strains[bound]
