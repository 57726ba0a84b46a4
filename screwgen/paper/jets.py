"""Arrays with their first two time derivatives: the judge differentiates motions, not formulas."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import Numbers


@dataclass(frozen=True)
class Jet:
    """A matrix of shape (..., r, c) with its first and second time derivative at one instant."""

    value: np.ndarray
    rate: np.ndarray
    second: np.ndarray

    def __add__(self, other: Jet) -> Jet:
        return Jet(self.value + other.value, self.rate + other.rate, self.second + other.second)

    def __sub__(self, other: Jet) -> Jet:
        return Jet(self.value - other.value, self.rate - other.rate, self.second - other.second)

    def __matmul__(self, other: Jet) -> Jet:
        a, b = self, other
        second = a.second @ b.value + 2 * a.rate @ b.rate + a.value @ b.second
        return Jet(a.value @ b.value, a.rate @ b.value + a.value @ b.rate, second)

    @property
    def T(self) -> Jet:
        return Jet(*(np.swapaxes(x, -1, -2) for x in (self.value, self.rate, self.second)))

    @property
    def dot(self) -> Jet:
        """The time derivative; its own second derivative is not known, and not a number."""
        return Jet(self.rate, self.second, np.full_like(self.second, np.nan))


def constant(value: ArrayLike) -> Jet:
    x = np.asarray(value, float)
    return Jet(x, np.zeros_like(x), np.zeros_like(x))


def turn(axis: Numbers, angle: float, speed: float, acceleration: float) -> Jet:
    """``exp(hat(axis) q)`` about a fixed unit axis, for ``q`` with its two derivatives."""
    K = skew(np.reshape(axis, (3, 1)))
    sin, cos = np.sin(angle), np.cos(angle)
    slope, curvature = cos * K + sin * K @ K, -sin * K + cos * K @ K
    return Jet(np.eye(3) + sin * K + (1 - cos) * K @ K, speed * slope, acceleration * slope + speed**2 * curvature)


def skew(a: np.ndarray) -> np.ndarray:
    """``hat(a)`` of columns (..., 3, 1)."""
    x, y, z = (a[..., k, 0] for k in range(3))
    o = np.zeros_like(x)
    rows = [np.stack(row, -1) for row in ([o, -z, y], [z, o, -x], [-y, x, o])]
    return np.stack(rows, -2)


def unskew(K: np.ndarray) -> np.ndarray:
    """The column whose skew matrix ``K`` is."""
    return np.array([[K[2, 1]], [K[0, 2]], [K[1, 0]]])
