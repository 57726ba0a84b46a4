"""The numbers of a rod whose kinematics are kept whole: Gauss points, integration along them, turns between them.

Everything is dimensionless, for a rod of unit length and *strains per unit of each mode*: with ``z = 1/l`` for modes in
metres and 1 for torsion, ``eta_hat = z eta``, the curvature times the length of a piece is ``kappa(s) eta_hat ds``.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from ..spec.link_class import TURN, LinkClass
from ..spec.markers import TIP
from .varying_fields import weights

FINE = 16
"""Points of the quadrature between two sections: exact for polynomials up to 15 modes."""
STRAINED = {"axial": 0, "shear_y": 1, "shear_z": 2}
"""The component of the stretch ``gamma`` that each direction strains."""


@dataclass(frozen=True)
class Turn:
    """The turn from one section to the next, ``Omega = linear eta_hat + [eta_hat^T bilinear_c eta_hat]``, in rad.

    The first two terms of the Magnus expansion: ``∫kappa`` and ``1/2 ∫(psi - psi_0) x kappa``, psi the integral of
    kappa.
    """

    linear: np.ndarray
    """(3, r)."""
    bilinear: np.ndarray
    """(3, r, r), symmetric in the last two."""


@dataclass(frozen=True)
class Collocation:
    """The Gauss points of a link class; places as shares of the length of the link, or of its segment."""

    key: LinkClass

    @property
    def places(self) -> np.ndarray:
        """(N,) in (0, 1)."""
        return _gauss(points(self.key))[0]

    @property
    def weights(self) -> np.ndarray:
        """(N,): their integration weights, of sum one."""
        return _gauss(points(self.key))[1]

    @property
    def sections(self) -> list[tuple[float, float]]:
        """Places and weights of the Gauss points."""
        return list(zip(self.places.tolist(), self.weights.tolist(), strict=True))

    @cached_property
    def masses(self) -> list[tuple[float, float]]:
        """Places and integration weights of the rod's masses, exact for its straight shape.

        The Gauss points where the section is uniform or varies along one polynomial, else points in each piece.
        """
        n = max(self.key.counts) + 2
        pieces, degree = [(0.0, 1.0)], 0
        if self.key.stations:
            w = weights(self.key)
            pieces, degree = w.ends(), w.degree
        n = max(n, max(self.key.counts) + 1 + (degree + 2) // 2)
        if len(pieces) == 1 and n <= len(self.places):
            return self.sections
        x, w_x = _gauss(n)
        return [(float(a + (b - a) * s), float((b - a) * w)) for a, b in pieces for s, w in zip(x, w_x, strict=True)]

    def reach(self, s: float) -> np.ndarray:
        """(N,): the weights of the integral from 0 to s, exact for polynomials of degree N - 1."""
        if s == TIP:
            return self.weights
        x, n = self.places, len(self.places)
        fine, weights = _gauss(n)
        powers = np.vander(2.0 * x - 1.0, increasing=True)
        lagrange = np.linalg.solve(powers.T, np.vander(2.0 * s * fine - 1.0, n, increasing=True).T)
        return s * lagrange @ weights

    def stretch(self, k: int) -> np.ndarray:
        """(3, r): the stretch ``gamma`` at point k per unit of each mode."""
        out = np.zeros((3, self.key.modes))
        for m, (direction, i) in enumerate(self.key.directions):
            if direction in STRAINED:
                out[STRAINED[direction], m] = self._shape(direction, i, self.places[k], 1)
        return out

    def turn(self, a: float, b: float) -> Turn:
        """From the section at a to that at b."""
        fine, weights = _gauss(FINE)
        psi_a, s = self._psi(a), a + (b - a) * fine
        psi, kappa = (np.array([f(x) for x in s]) for f in (self._psi, self._kappa))
        crossed = np.cross((psi - psi_a)[:, :, :, None], kappa[:, :, None, :], axis=1)
        whole = 0.5 * (b - a) * np.tensordot(weights, crossed, 1)
        both = 0.5 * (whole + whole.transpose(0, 2, 1))
        return Turn(self._psi(b) - psi_a, np.where(np.abs(both) < 1e-15, 0.0, both))

    def _psi(self, s: float) -> np.ndarray:
        return self._turned(s, 0)

    def _kappa(self, s: float) -> np.ndarray:
        return self._turned(s, 1)

    def _turned(self, s: float, derivative: int) -> np.ndarray:
        """(3, r): turn of the section at s, or its derivative along the rod, per unit of each mode."""
        out = np.zeros((3, self.key.modes))
        for m, (direction, i) in enumerate(self.key.directions):
            if direction in TURN:
                row, sign = TURN[direction]
                order = derivative + (direction != "torsion")
                out[row, m] = sign * self._shape(direction, i, s, order)
        return out

    def _shape(self, direction: str, i: int, s: float, order: int) -> float:
        return _evaluated(self.key.shapes(direction), float(s), order)[i]


def points(key: LinkClass) -> int:
    """The number of Gauss points: two more than the most modes of a direction."""
    return max(key.counts) + 2


@cache
def collocation(key: LinkClass) -> Collocation:
    """The numbers of a link class; those of a station are the link's."""
    return Collocation(key)


@cache
def _gauss(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Places and weights on [0, 1]."""
    x, w = np.polynomial.legendre.leggauss(n)
    return 0.5 * (x + 1.0), 0.5 * w


@cache
def _evaluated(shapes, s: float, order: int) -> tuple[float, ...]:  # type: ignore[no-untyped-def]
    return tuple(row[0] for row in shapes.evaluate((s,), order))
