"""The numbers of a rod whose kinematics are kept whole: Gauss points, integration along them, turns between them.

Everything is dimensionless, for a rod of unit length and *modal coordinates of unit length* ``z eta``: z is one over
the length for modes in metres, and 1 for torsion.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property
from itertools import pairwise

import numpy as np

from ..bases import Shapes
from ..bases.weighted import Weights
from ..spec.link_class import TURN, LinkClass
from ..spec.markers import TIP
from ..spec.modes import points_for
from .varying_fields import weights

FINE = 20
"""Points of the quadratures: exact for polynomials up to degree 39."""
STRAINED = {"axial": 0, "shear_y": 1, "shear_z": 2}
"""The component of the stretch ``gamma`` that each direction strains."""
NEGLIGIBLE = 1e-14


@dataclass(frozen=True)
class RodTurn:
    """The turn from one section to the next, ``Omega = C zeta + sum of (A zeta) x (B zeta)``, rad.

    ``zeta`` is the r modal coordinates, then the p numbers of the curvature at rest.

    The first two terms of the Magnus expansion, ``∫kappa`` and ``1/2 ∫(psi - psi_0) x kappa`` with psi the integral of
    kappa. The second has few products: as many as an antisymmetric form on the modes' shapes has planes, one with up to
    three modes in a direction.
    """

    linear: np.ndarray
    """C, (3, r + p)."""
    crossed: tuple[tuple[np.ndarray, np.ndarray], ...]
    """The pairs A, B, (3, r + p) each."""


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
        """(3, r + p): the curvature ``kappa`` at s by each mode and each number at rest, times the length."""
        return self._about(self._turned(s, 1))

    def turn(self, a: float, b: float) -> RodTurn:
        """From the section at a to that at b."""
        psi_a, once = self._turned(a, 0), np.zeros((1, 1))
        for share, weight in self.within(a, b, FINE):
            s = a + (b - a) * share
            psi, kappa = (np.array([self._turned(x, n) for x in s]) for n in (0, 1))
            once = once + 0.5 * (b - a) * (psi - psi_a).T @ (weight[:, None] * kappa)
        return RodTurn(self._about(self._turned(b, 0) - psi_a), tuple(self._pairs(0.5 * (once - once.T))))

    def within(self, a: float, b: float, count: int) -> list[tuple[np.ndarray, np.ndarray]]:
        """Gauss points from a to b, as shares of the way, and their weights; so many between kinks of the curvature."""
        x, w = gauss(count)
        kinks = [(s - a) / (b - a) for s, _, _ in self._resting[1:] if a < s < b]
        return [(u + (v - u) * x, (v - u) * w) for u, v in pairwise([0.0, *kinks, 1.0])]

    @cached_property
    def _resting(self) -> list[tuple[float, float, dict[int, tuple[float, float]]]]:
        """The pieces along which the curvature at rest is linear: ends, and its values there by each station."""
        if not self.key.rest_at:
            return [(0.0, 1.0, {0: (1.0, 1.0)})]
        return Weights(self.key.rest_at, segment=self.key.segment, segments=self.key.segments).corners()

    def _at_rest(self, station: int, s: float, derivative: int) -> float:
        """The turn of the section at s by a unit of curvature at rest at a station, or that curvature itself."""
        total = 0.0
        for start, end, values in self._resting:
            (near, far), way = values.get(station, (0.0, 0.0)), min(s, end) - start
            here = near + (far - near) * way / (end - start)
            if derivative and start <= s <= end:
                return here
            total += max(way, 0.0) * 0.5 * (near + here)
        return total

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
        """(3, r + p): a number for each mode, and each number at rest, about the axis that it turns sections about."""
        out = np.zeros((3, len(values)))
        for m, (direction, _) in enumerate((*self.key.directions, *self.key.rest_shapes)):
            if direction in TURN and abs(values[m]) > NEGLIGIBLE:
                row, sign = TURN[direction]
                out[row, m] = sign * values[m]
        return out

    def _turned(self, s: float, derivative: int) -> np.ndarray:
        """(r + p,): how far each mode, then each number at rest, turns the section at s, or the derivative of that."""
        shape = lambda d, i: self._shape(d, i, s, derivative + (d != "torsion"))  # noqa: E731
        resting = [self._at_rest(station, s, derivative) for _, station in self.key.rest_shapes]
        return np.array([shape(d, i) if d in TURN else 0.0 for d, i in self.key.directions] + resting)

    def _shape(self, direction: str, i: int, s: float, order: int) -> float:
        return _evaluated(self.key.shapes(direction), float(s), order)[i]


def points(key: LinkClass) -> int:
    """The number of Gauss points: as the file asks for, or by the number of modes."""
    return key.points or points_for(key.counts, key.bases)


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
