"""The exponential map of SE(3) on poses (w, x, y, z, px, py, pz).

Entries are numbers or symbols; products are summed in order, not by BLAS, whose rounding depends on the machine.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

Stumpff = Callable[[Any], Any]


class Series(NamedTuple):
    """The Stumpff functions of the entries' algebra."""

    c4: Stumpff
    c5: Stumpff


def exponential(pose: np.ndarray, u: np.ndarray, series: Series) -> np.ndarray:
    """The pose times ``exp`` of ``u = [turn; shift]`` in the body's axes."""
    c4, c5 = series
    turn, shift = u[:3], u[3:]
    x = sum(turn * turn)
    across = cross(turn, shift)
    moved = shift + (0.5 - x * c4(x)) * across + (1 / 6 - x * c5(x)) * cross(turn, across)
    quarter = x / 4
    w, v = 1 - quarter * (0.5 - quarter * c4(quarter)), (1 - quarter * (1 / 6 - quarter * c5(quarter))) / 2 * turn
    a, b = pose[0], pose[1:4]
    t = 2 * cross(b, moved)
    return np.concatenate([[a * w - sum(b * v)], a * v + w * b + cross(b, v), pose[4:] + moved + a * t + cross(b, t)])


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The cross products along the last axis. On single vectors `np.cross` takes six times as long."""
    ax, ay, az = a.T
    bx, by, bz = b.T
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]).T
