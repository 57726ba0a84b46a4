"""The numbers of a rod whose kinematics are kept whole: Gauss points, integration along them, turns between them.

Everything is dimensionless, for a rod of unit length and *modal coordinates of unit length* ``z eta``: z is one over
the length for modes in metres, and 1 for torsion.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from ..bases import DEFAULT, Shapes
from ..spec.link_class import TURN, LinkClass
from ..spec.markers import TIP
from .varying_fields import weights

FINE = 20
"""Points of the quadratures: exact for polynomials up to degree 39."""
STRAINED = {"axial": 0, "shear_y": 1, "shear_z": 2}
"""The component of the stretch ``gamma`` that each direction strains."""
NEGLIGIBLE = 1e-14


@dataclass(frozen=True)
class RodTurn:
    """The turn from one section to the next, ``Omega = C eta + sum of (A eta) x (B eta)``, rad.

    The first two terms of the Magnus expansion, ``∫kappa`` and ``1/2 ∫(psi - psi_0) x kappa`` with psi the integral of
    kappa. The second has few products: as many as an antisymmetric form on the modes' shapes has planes, one with up to
    three modes in a direction.
    """

    linear: np.ndarray
    """C, (3, r)."""
    crossed: tuple[tuple[np.ndarray, np.ndarray], ...]
    """The pairs A, B, (3, r) each."""


@dataclass(frozen=True)
class Collocation:
    """The Gauss points of a link class; places as shares of the length of the link, or of its segment."""

    key: LinkClass

    @property
    def places(self) -> np.ndarray:
        """(N,) in (0, 1)."""
        return gauss(points(self.key))[0]

    @property
    def weights(self) -> np.ndarray:
        """(N,): their integration weights, of sum one."""
        return gauss(points(self.key))[1]

    @cached_property
    def masses(self) -> list[tuple[float, float]] | None:
        """Places and integration weights of the masses of a rod that varies, exact for its straight shape.

        Between two stations there are as many as there are points, or one more for every two degrees of the section, so
        both errors of a bent rod fall together. None for a uniform rod, whose masses are :attr:`uniform`.
        """
        if not self.key.stations:
            return None
        own = weights(self.key)
        x, w = gauss(points(self.key) - 1 + (own.degree + 2) // 2)
        return [(float(a + (b - a) * s), float((b - a) * v)) for a, b in own.ends() for s, v in zip(x, w, strict=True)]

    @cached_property
    def shared(self) -> list[dict[int, float]]:
        """Of each Gauss point the integrals of its Lagrange polynomial times the weight function of each station.

        They share a property out among the points: with them sums over the points are exact for polynomials of degree
        N - 1 times the property, also where it has kinks and steps between the points, which samples would miss.
        """
        own, out = weights(self.key), np.zeros((len(self.places), len(self.key.stations)))
        x, w = gauss(len(self.places) + own.degree)
        for a, b in own.ends():
            for s, v in zip((a + (b - a) * x).tolist(), ((b - a) * w).tolist(), strict=True):
                for station, value in own.at(s).items():
                    out[:, station] += v * value * self._lagrange(np.array([s]))[:, 0]
        return [{int(k): float(row[k]) for k in np.flatnonzero(row)} for row in out]

    @cached_property
    def uniform(self) -> np.ndarray:
        """(N, N): combinations of the tangents whose squares add up to the integral of the squared position.

        The transposed Cholesky factor of ``∫ a a^T ds``, a the weights of :meth:`reach`: exact, and half as many
        products as with the masses at points.
        """
        s, w = self._along
        reach = np.array([self.reach(x) for x in s])
        return np.linalg.cholesky(reach.T @ (w[:, None] * reach)).T

    @cached_property
    def centre(self) -> np.ndarray:
        """(N,): the weights of the tangents in the mean position of a uniform rod."""
        s, w = self._along
        return w @ np.array([self.reach(x) for x in s])

    @property
    def _along(self) -> tuple[np.ndarray, np.ndarray]:
        """A quadrature that is exact for the squared position, of degree 2 N."""
        return gauss(max(FINE, len(self.places) + 1))

    def reach(self, s: float) -> np.ndarray:
        """(N,): the weights of the integral from 0 to s, exact for polynomials of degree N - 1."""
        if s == TIP:
            return self.weights
        fine, own = gauss(len(self.places))
        return s * self._lagrange(s * fine) @ own

    def _lagrange(self, at: np.ndarray) -> np.ndarray:
        """(N, len(at)): the Lagrange polynomials of the points at some places."""
        n, legendre = len(self.places), np.polynomial.legendre.legvander
        return np.linalg.solve(legendre(2.0 * self.places - 1.0, n - 1).T, legendre(2.0 * at - 1.0, n - 1).T)

    def stretch(self, s: float) -> np.ndarray:
        """(3, r): the stretch ``gamma`` at the place s by each mode."""
        out = np.zeros((3, self.key.modes))
        for m, (direction, i) in enumerate(self.key.directions):
            if direction in STRAINED:
                out[STRAINED[direction], m] = self._shape(direction, i, s, 1)
        return out

    def curvature(self, s: float) -> np.ndarray:
        """(3, r): the curvature ``kappa`` at the place s by each mode, times the length."""
        return self._about(self._turned(s, 1))

    def turn(self, a: float, b: float) -> RodTurn:
        """From the section at a to that at b."""
        fine, own = gauss(FINE)
        s, psi_a = a + (b - a) * fine, self._turned(a, 0)
        psi, kappa = (np.array([self._turned(x, n) for x in s]) for n in (0, 1))
        once = 0.5 * (b - a) * (psi - psi_a).T @ (own[:, None] * kappa)
        return RodTurn(self._about(self._turned(b, 0) - psi_a), tuple(self._pairs(0.5 * (once - once.T))))

    def _pairs(self, K: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
        """The pairs a, b with ``K = 1/2 sum of (a b^T - b a^T)``, by elimination, largest pivots first."""
        out, size = [], np.max(np.abs(K), initial=0.0)
        while size and np.max(np.abs(K)) > 1e-11 * size and np.max(np.abs(K)) > NEGLIGIBLE:
            i, j = np.unravel_index(np.argmax(np.abs(K)), K.shape)
            a, b = 2.0 * K[:, i] / K[i, j], K[:, j].copy()
            K = K - 0.5 * (np.outer(a, b) - np.outer(b, a))
            out.append((self._about(a), self._about(b)))
        return [pair for pair in out if _cross(*pair)]

    def _about(self, values: np.ndarray) -> np.ndarray:
        """(3, r): a number for each mode about the axis that it turns the sections about."""
        out = np.zeros((3, self.key.modes))
        for m, (direction, _) in enumerate(self.key.directions):
            if direction in TURN and abs(values[m]) > NEGLIGIBLE:
                row, sign = TURN[direction]
                out[row, m] = sign * values[m]
        return out

    def _turned(self, s: float, derivative: int) -> np.ndarray:
        """(r,): how far each mode turns the section at s about its axis, or the derivative of that along the rod."""
        shape = lambda d, i: self._shape(d, i, s, derivative + (d != "torsion"))  # noqa: E731
        return np.array([shape(d, i) if d in TURN else 0.0 for d, i in self.key.directions])

    def _shape(self, direction: str, i: int, s: float, order: int) -> float:
        return _evaluated(self.key.shapes(direction), float(s), order)[i]


def points(key: LinkClass) -> int:
    """The number of Gauss points: as the file states, or two more than the most modes of a direction.

    Shapes that are no polynomials take more to have their inertia to eight digits.
    """
    most = max(key.counts)
    return key.points or (most + 2 if set(key.bases) <= {"", DEFAULT} else 2 * most + 4)


@cache
def collocation(key: LinkClass) -> Collocation:
    """The numbers of a link class; those of a station are the link's."""
    return Collocation(key)


def _cross(a: np.ndarray, b: np.ndarray) -> bool:
    """Whether the modes of a pair turn sections about more than one axis."""
    return len(set(np.nonzero(np.abs(a) + np.abs(b))[0].tolist())) > 1


@cache
def gauss(n: int) -> tuple[np.ndarray, np.ndarray]:
    """The places and weights of n Gauss points on [0, 1]."""
    x, w = np.polynomial.legendre.leggauss(n)
    return 0.5 * (x + 1.0), 0.5 * w


@cache
def _evaluated(shapes: Shapes, s: float, order: int) -> tuple[float, ...]:
    return tuple(row[0] for row in shapes.evaluate((s,), order))
