"""Turns and poses: quaternions (w, x, y, z), the exponential maps of SO(3) and SE(3), poses (w, x, y, z, px, py, pz).

Entries are numbers or symbols; products are summed in order, not by BLAS, whose rounding depends on the machine.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..algebra.expression import Expression, Symbol, hat, identity, inverse, number, stack
from ..lazily import sp

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
    a, b = pose[0], pose[1:4]
    t = 2 * cross(b, moved)
    return np.concatenate([turned(pose[:4], turn, series, x), pose[4:] + moved + a * t + cross(b, t)])


def turned(Q: np.ndarray, turn: np.ndarray, series: Series, square: Any = None) -> np.ndarray:
    """The quaternion ``Q`` times ``exp(turn)``, turn in the body's axes; ``square``: that of its length, if known."""
    c4, c5 = series
    quarter = (sum(turn * turn) if square is None else square) / 4
    w, v = 1 - quarter * (0.5 - quarter * c4(quarter)), (1 - quarter * (1 / 6 - quarter * c5(quarter))) / 2 * turn
    a, b = Q[0], Q[1:]
    return np.concatenate([[a * w - sum(b * v)], a * v + w * b + cross(b, v)])


def turn_between(Q: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The turn (3,), rad, at most half a turn, that takes the quaternion ``Q`` to the ``other``; of numbers."""
    w, v = sum(Q * other), between(Q, other)
    sine = float(np.sqrt(sum(v * v)))
    w, v = (-w, -v) if w < 0 else (w, v)
    return 2.0 * v * (np.arctan2(sine, w) / sine if sine > 0 else 1.0)


def between(Q: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The vector (3,) of the conjugate of a quaternion times another."""
    return Q[0] * other[1:] - other[0] * Q[1:] - cross(Q[1:], other[1:])


def angular_velocity(Q: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """The angular velocity (3,) in the body's axes at which a unit quaternion has a rate."""
    return 2.0 * between(Q, rate)


def quaternion_rate(Q: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """The rate of a quaternion at an angular velocity in the body's axes, half the product with ``[0, omega]``."""
    half = omega / 2
    return np.concatenate([[-sum(Q[1:] * half)], Q[0] * half + cross(Q[1:], half)])


def rotated(Q: np.ndarray, x: np.ndarray) -> np.ndarray:
    """A vector of the body in the axes from which a quaternion of any length turns it."""
    t = (2.0 / sum(Q * Q)) * cross(Q[1:], x)
    return x + Q[0] * t + cross(Q[1:], t)


def rotation(entries: Sequence[Symbol]) -> Expression:
    """(3, 3): the rotation of a quaternion of any length, whose entries are given."""
    w, *vector = entries
    cross_w = hat(stack(*vector))
    Q = stack(*entries)
    scale: Expression = number(2) @ inverse(Q.T @ Q)
    return identity(3) + scale @ (w @ cross_w + cross_w @ cross_w)


def rate_expressions(entries: Sequence[Symbol], omega: Expression) -> Expression:
    """(4, 1): the rate of a quaternion, as :func:`quaternion_rate`."""
    u = stack(*entries[1:])
    turning = stack(-(u.T @ omega), entries[0] @ omega + hat(u) @ omega)
    return number(sp.Rational(1, 2)) @ turning


def algebra_rate(u: np.ndarray, V: np.ndarray) -> np.ndarray:
    """The rate of ``u`` in ``pose = start exp(u)`` at the twist ``V``, row by row, with terms up to order four."""
    first = bracket(u, V)
    return V + first / 2 + bracket(u, first) / 12


def bracket(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The Lie bracket of se(3), row by row, (25)."""
    return np.hstack([cross(a[:, :3], b[:, :3]), cross(a[:, 3:], b[:, :3]) + cross(a[:, :3], b[:, 3:])])


def carried(V: np.ndarray) -> np.ndarray:
    """(6, 6): by a change ``delta`` of a pose, ``pose exp(delta)``, its rate at the twist V (6,), ``-[V, delta]``."""
    return -bracket(np.broadcast_to(V, (6, 6)), np.eye(6)).T


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The cross products along the last axis. On single vectors `np.cross` takes six times as long."""
    ax, ay, az = a.T
    bx, by, bz = b.T
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]).T
