"""What (77) to (79) say about shapes, computed: norms, derivatives in the weak sense, and stiffness."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import leggauss

from .random_motion import RandomMotion

POINTS = 12
HERMITE = Polynomial([0, 0, 3, -2])
"""From 0 to 1 with horizontal ends on [0, 1]."""


class Cubic:
    """The cubic of two beam elements of length ``h`` on [0, 2h]: 1 in the middle, and with slope 0 at all three nodes.

    Its second derivative jumps: it is in H², and its fourth derivative is no function.
    """

    def __init__(self, seed: int):
        self.h = float(np.random.default_rng(seed).uniform(0.3, 0.7))
        x, w = leggauss(POINTS)
        self.s, self.weights = (1 + x) / 2, w / 2 * self.h
        self.xi = np.concatenate([self.s * self.h, (1 + self.s) * self.h])

    def derivative(self, order: int) -> np.ndarray:
        """A derivative at the quadrature places of both elements, element by element."""
        rising = HERMITE.deriv(order) if order else HERMITE
        return np.concatenate([rising(self.s), (-1) ** order * rising(1 - self.s)]) / self.h**order

    def integral(self, integrand: np.ndarray) -> float:
        return float(np.tile(self.weights, 2) @ integrand)

    @property
    def stiffness(self) -> float:
        """Force over displacement of two beams between clamps, loaded in the middle, per EI: ``2 · 12 / h³``."""
        return 24 / self.h**3


def weak_stiffness(seed: int) -> tuple[float, float]:
    """Relative errors of the bending stiffness of the cubic in the strong and in the weak form."""
    f = Cubic(seed)
    strong = f.integral(f.derivative(4) * f.derivative(0))
    weak = f.integral(f.derivative(2) ** 2)
    return abs(strong / f.stiffness - 1), abs(weak / f.stiffness - 1)


def finite_norm(seed: int) -> tuple[float, float]:
    """How far the norms of the judge's shapes are from the 1 that the orthogonality condition asks for."""
    link = RandomMotion(seed).links[1]
    norms = link.sum((link.shapes(link.xi) ** 2).sum(axis=-2))
    gap = float(np.abs(norms - 1).max())
    return gap, gap


def weak_derivatives(seed: int) -> tuple[float, float]:
    """How far ``∫ f'' t - ∫ f t''`` is from 0, for the cubic f and a test function t that vanishes with its slope."""
    f = Cubic(seed)
    end = 2 * f.h
    test = Polynomial([0, 0, 1]) * Polynomial([end, -1]) ** 2 * Polynomial(np.random.default_rng(seed).normal(size=3))
    left = f.integral(f.derivative(2) * test(f.xi))
    right = f.integral(f.derivative(0) * test.deriv(2)(f.xi))
    gap = abs(left - right) / max(abs(left), abs(right))
    return gap, gap
