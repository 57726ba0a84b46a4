"""A clamped beam, with or without a mass at its tip, by Ritz's method in polynomials: a judge for the beam formulas."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.linalg
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import Legendre, leggauss

DEGREES = 14
POINTS = 40


@dataclass(frozen=True)
class Beam:
    """Length in m, bending stiffness in N·m², mass per length in kg/m, mass at the tip in kg."""

    L: float
    EI: float
    rhoA: float
    tip_mass: float = 0.0

    def frequencies(self, count: int) -> np.ndarray:
        """The lowest natural frequencies in Hz."""
        return np.sqrt(self.squares[:count]) / (2 * np.pi)

    @property
    def squares(self) -> np.ndarray:
        """``omega^2`` of the bending vibrations, ascending."""
        s, weights = places()
        shapes = [Polynomial([0, 0, 1]) * Legendre.basis(k, [0, 1]).convert(kind=Polynomial) for k in range(DEGREES)]
        bent = np.array([p.deriv(2)(s) for p in shapes])
        moved, tip = np.array([p(s) for p in shapes]), np.array([p(1.0) for p in shapes])
        K = self.EI / self.L**3 * (bent * weights) @ bent.T
        M = self.rhoA * self.L * (moved * weights) @ moved.T + self.tip_mass * np.outer(tip, tip)
        return 1 / scipy.linalg.eigh(M, K, eigvals_only=True)[::-1]  # the largest of the inverse lose no digits


def places() -> tuple[np.ndarray, np.ndarray]:
    """Quadrature nodes and weights on [0, 1]."""
    x, w = leggauss(POINTS)
    return (1 + x) / 2, w / 2
