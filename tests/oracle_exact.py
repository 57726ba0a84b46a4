"""The oracle's rod with kinematics kept whole: Gauss collocation of ``R' = R hat(kappa)``, ``r' = R (e_x + gamma)``.

Positions and rotations as CasADi expressions of the modal coordinates, by the formulas of the model's text; energies
and everything else are derived from them by the oracle. No package code.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from itertools import pairwise

import casadi as ca
import numpy as np
from oracle_link import Link
from oracle_second_order import DIRECTIONS, clamped_free, polynomial, tabulate

FINE = 24


def gauss(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Places and weights on [0, 1]."""
    x, w = np.polynomial.legendre.leggauss(n)
    return (x + 1) / 2, w / 2


@dataclass(frozen=True)
class ExactLink(Link):
    """A link of order "exact": `nodes` and `weights` are those of its masses, `points` those of its sections."""

    points: np.ndarray = field(default_factory=lambda: np.zeros(0))
    section_weights: np.ndarray = field(default_factory=lambda: np.zeros(0))
    section_inertia: np.ndarray = field(default_factory=lambda: np.zeros((3, 0)))
    """(3, N) per length at the sections."""
    basis: str = "polynomial"
    rest: dict | list | None = None
    """Its curvature at rest, as the robot file states it."""

    # strains ------------------------------------------------------------------------------------------

    def _tables(self, s: float) -> dict[str, np.ndarray]:
        """Of each direction (3, r): values, slopes and second derivatives with s."""
        out = {}
        for d in DIRECTIONS:
            order, count = (2 if d.startswith("bending") else 1), self.counts[d]
            if not count:
                out[d] = np.zeros((3, 0))
                continue
            if order == 1 and self.basis == "clamped_free":
                wave = (2 * np.arange(1, count + 1) - 1) * np.pi / 2
                sine, cosine = np.sqrt(2) * np.sin(wave * s), np.sqrt(2) * np.cos(wave * s)
                out[d] = np.array([sine, wave * cosine, -(wave**2) * sine])
                continue
            out[d] = tabulated(self.basis, count, order, float(s))
        return out

    def strains(self, s: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """psi, kappa and gamma (3, r) per unit of each modal coordinate."""
        l, table, columns = self.length, self._tables(s), ([], [], [])
        for d in DIRECTIONS:
            for value, slope, second in table[d].T:
                psi, kappa, gamma = {
                    "axial": ([0, 0, 0], [0, 0, 0], [slope / l, 0, 0]),
                    "bending_y": ([0, 0, slope / l], [0, 0, second / l**2], [0, 0, 0]),
                    "bending_z": ([0, -slope / l, 0], [0, -second / l**2, 0], [0, 0, 0]),
                    "torsion": ([value, 0, 0], [slope / l, 0, 0], [0, 0, 0]),
                    "shear_y": ([0, 0, 0], [0, 0, 0], [0, slope / l, 0]),
                    "shear_z": ([0, 0, 0], [0, 0, 0], [0, 0, slope / l]),
                }[d]
                for column, x in zip(columns, (psi, kappa, gamma), strict=True):
                    column.append(x)
        return tuple(np.array(x, dtype=float).reshape(-1, 3).T for x in columns)

    # the shape ----------------------------------------------------------------------------------------

    def rotation(self, eta: ca.SX, before: ca.SX, a: float, b: float) -> ca.SX:
        """The rotation of the section at b from that at a, by the first two terms of the Magnus expansion."""
        from oracle_cloud import rotation_vector_matrix

        psi_a = self._turned(a, eta)
        theta = self._turned(b, eta) - psi_a
        for s, weight in zip(*between(self.rest, a, b, FINE), strict=True):
            kappa = ca.DM(self.strains(s)[1]) @ eta + curvature_at_rest(self.rest, s)
            theta += 0.5 * weight * self.length * ca.cross(self._turned(s, eta) - psi_a, kappa)
        return before @ rotation_vector_matrix(theta)

    def _turned(self, s: float, eta: ca.SX) -> ca.SX:
        """The integral of the curvature from the base to s."""
        nodes, weights = between(self.rest, 0.0, s, 2)
        at_rest = sum((w * curvature_at_rest(self.rest, x) for x, w in zip(nodes, weights, strict=True)), np.zeros(3))
        return ca.DM(self.strains(s)[0]) @ eta + self.length * at_rest

    def rotations(self, eta: ca.SX) -> list[ca.SX]:
        """Of the sections at the points."""
        out, before, place = [], ca.SX(np.eye(3)), 0.0
        for s in self.points:
            before, place = self.rotation(eta, before, place, s), s
            out.append(before)
        return out

    def rotation_at(self, eta: ca.SX, s: float, rotations: list[ca.SX]) -> ca.SX:
        """Of the section at s; ``rotations``: those of the sections at the points."""
        known = [(0.0, ca.SX(np.eye(3))), *zip(self.points, rotations, strict=True)]
        place, before = [x for x in known if x[0] <= s][-1]
        return self.rotation(eta, before, float(place), s)

    def places(self, eta: ca.SX, at: np.ndarray, rotations: list[ca.SX]) -> ca.SX:
        """(3, len(at)): positions of points of the centreline in F_i: interpolated tangents, integrated.

        ``rotations``: those of the sections at the points.
        """
        tangents = [
            R @ (ca.SX([1, 0, 0]) + ca.DM(self.strains(s)[2]) @ eta)
            for s, R in zip(self.points, rotations, strict=True)
        ]
        columns = []
        for s in at:
            weights = [lagrange_integral(self.points, j, s) for j in range(len(self.points))]
            columns.append(self.length * sum((w * t for w, t in zip(weights, tangents, strict=True)), ca.SX.zeros(3)))
        return ca.horzcat(*columns) + ca.repmat(ca.DM([self.a, 0, 0]), 1, len(at))


@cache
def tabulated(basis: str, count: int, order: int, s: float) -> np.ndarray:
    """(3, count): values, slopes and second derivatives at s of the functions of a direction; they are read only."""
    functions = clamped_free(count) if basis == "clamped_free" else polynomial(count, order)
    return tabulate(functions, [max(s, 1e-40)])[:, :, 0]


# the shape at rest -------------------------------------------------------------------------------------

TURNS = {"torsion": (0, 1.0), "bending_z": (1, -1.0), "bending_y": (2, 1.0)}


def curvature_at_rest(rest: dict | list | None, s: float) -> np.ndarray:
    """(3,) 1/m: as the file states it, linear between its stations; of a link that states none zero."""
    stations = rest if isinstance(rest, list) else [{"at": 0.0, **(rest or {})}, {"at": 1.0, **(rest or {})}]
    a, b = next(pair for pair in pairwise(stations) if pair[1]["at"] > pair[0]["at"] and s <= pair[1]["at"])
    share, out = (s - a["at"]) / (b["at"] - a["at"]), np.zeros(3)
    for name, (axis, sign) in TURNS.items():
        out[axis] = sign * ((1 - share) * a.get(name, 0.0) + share * b.get(name, 0.0))
    return out


def between(rest: dict | list | None, a: float, b: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights of a quadrature from a to b, so many nodes between stations of the curvature at rest."""
    kinks = sorted({x["at"] for x in rest if a < x["at"] < b}) if isinstance(rest, list) else []
    x, w = gauss(count)
    parts = [(c + (d - c) * x, (d - c) * w) for c, d in pairwise([a, *kinks, b])]
    return tuple(np.concatenate(values) for values in zip(*parts, strict=True))


def count_of_points(link: dict) -> int:
    """The Gauss points of a link: as its file states, or by its modes, and one for each quarter turn of it at rest."""
    modes = link["modes"]
    most = max(modes.get(d, 0) for d in DIRECTIONS)
    straight = most + 2 if modes.get("basis", "polynomial") == "polynomial" else 2 * most + 4
    rest = link.get("rest")
    ends = sorted({0.0, 1.0, *(x["at"] for x in rest)}) if isinstance(rest, list) else [0.0, 1.0]
    near = 1e-12
    turns = [
        (b - a) * np.linalg.norm([curvature_at_rest(rest, a + near), curvature_at_rest(rest, b - near)], axis=1).mean()
        for a, b in pairwise(ends)
    ]
    return modes.get("points", straight + int(np.ceil(2 * sum(turns) * link["length"] / np.pi - near)))


def lagrange_integral(points: np.ndarray, j: int, s: float) -> float:
    """The integral from 0 to s of the Lagrange polynomial of point j, by a quadrature that is exact for it.

    Of its products: its coefficients cancel, with 12 points to 1e-10.
    """
    others = np.delete(points, j)
    x, w = gauss(len(points))
    return float(s * w @ np.prod((s * x[:, None] - others) / (points[j] - others), axis=1))
