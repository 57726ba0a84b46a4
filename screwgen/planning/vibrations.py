"""What vibrates about a rest: frequencies and damping ratios, joints locked or under the law."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..errors import UsageError
from .members import Still
from .sampled_loop import LoopGains

SWINGING = 0.5
"""Damping ratios above this die away within a period: they need no shaper."""
SLOWEST = 1e-3
"""Hz: below this a motion counts as one that no spring resists."""
GROWTH = 1e-6
"""The ratio to the largest pole at which growth is rounding."""


class DampedModes(NamedTuple):
    """Motions that swing: natural frequencies, Hz, and damping ratios (modes,) each."""

    frequencies: np.ndarray
    damping: np.ndarray


def poles(still: Still, joints: np.ndarray, loop: LoopGains) -> np.ndarray:
    """Rates of growth and angular frequencies, 1/s, of what swings about the rest with the joints at `joints`."""
    m, rest = still.joints, still.held(joints)
    M, D, K = still.matrices(rest)
    K[range(m), range(m)] += np.where(loop.locked, 0.0, loop.kp)
    D[range(m), range(m)] += np.where(loop.locked, 0.0, loop.kd)
    free = np.append(~loop.locked, np.ones(len(rest.q) - m, bool))
    n, (M, D, K) = int(free.sum()), (x[np.ix_(free, free)] for x in (M, D, K))
    found = np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, np.hstack([K, D]))]]))
    if n and found.real.max() > GROWTH * np.abs(found).max():
        raise UsageError(f"shaper: at joints {_listed(joints)} a motion grows; give other gains, or another range")
    return found[found.imag > 2 * np.pi * SLOWEST]


def slowest(found: np.ndarray, modes: int, joints: np.ndarray) -> np.ndarray:
    """The slowest poles that swing for more than a period, ascending."""
    swinging = found[-found.real < SWINGING * np.abs(found)]
    if len(swinging) < modes:
        said = f"{len(swinging)} with a damping ratio below {SWINGING:g} at joints {_listed(joints)}"
        raise UsageError(f"shaper: {modes} motions are asked for, there are {said}; ask for fewer modes")
    return swinging[np.argsort(np.abs(swinging))][:modes]


def followed(before: np.ndarray, found: np.ndarray, joints: np.ndarray) -> np.ndarray:
    """Poles in the order of those of a posture nearby."""
    from scipy.optimize import linear_sum_assignment

    if len(found) < len(before):
        raise UsageError(f"shaper: at joints {_listed(joints)} a motion stops swinging; give a smaller range, or gains")
    return found[linear_sum_assignment(np.abs(before[:, None] - found) / np.abs(before)[:, None])[1]]


def vibrations(found: np.ndarray) -> DampedModes:
    """Poles as frequencies and damping ratios."""
    size = np.abs(found)
    return DampedModes(size / (2 * np.pi), np.maximum(-found.real / size, 0.0))


def _listed(joints: np.ndarray) -> str:
    return ", ".join(f"{x:.4g}" for x in joints)
