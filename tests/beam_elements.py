"""Arms as chains of finite beam elements: a judge of natural frequencies that shares nothing with the derivation.

A link is a straight beam in nodes of its own: absolute displacements and rotations of its sections, in link axes.
Stretching and twisting take two-node bars, bending takes Hermite's cubic beams, with consistent mass; `bubbles` more
polynomials inside each element raise its order. A direction without modes in the robot file is rigid. Sections have
spin inertia about the centreline and no rotary inertia of bending. Joints, mounts and bodies act on the end sections.
"""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

import numpy as np
import scipy.linalg
import scipy.sparse as sparse
from numpy.polynomial import Legendre, Polynomial
from oracle_sections import intervals, property_at
from scipy.spatial.transform import Rotation

ELEMENTS, BUBBLES, LOWEST = 4, 3, 8
DIRECTIONS = {  # stiffness, density, and where displacement (and slope) stand in [u; theta] of a section, with signs
    "axial": ("EA", "rhoA", ((0, 1.0),)),
    "torsion": ("GJ", "rhoIp", ((3, 1.0),)),
    "bending_y": ("EIz", "rhoA", ((1, 1.0), (5, 1.0))),
    "bending_z": ("EIy", "rhoA", ((2, 1.0), (4, -1.0))),
}


def frequencies(robot: dict, q, joints: str, elements: int = ELEMENTS, bubbles: int = BUBBLES) -> np.ndarray:
    """The `LOWEST` natural frequencies in Hz, ascending, at rest at joint angles `q`, straight and without gravity.

    `robot`: a robot file's contents, sections by line properties. `joints`: "locked" or "free"; motions that nothing
    resists are left out.
    """
    arm = Assembly(robot, np.array(q, float), joints == "free", elements, bubbles)
    K, M = (x.toarray() for x in (arm.K, arm.M))
    shift = arm.scale()
    # Of the inverse problem these are the largest eigenvalues: rounding is relative to them.
    most = [max(0, arm.n - arm.loose - LOWEST), arm.n - 1]
    inverse = scipy.linalg.eigh(M, K + shift * M, eigvals_only=True, subset_by_index=most)
    return np.sqrt(1 / inverse[::-1][arm.loose :] - shift) / (2 * np.pi)


class Field(NamedTuple):
    """One direction of a link: stiffness and mass (n, n), of which the first `size` values are those of the base."""

    K: sparse.csr_matrix
    M: sparse.csr_matrix
    tip: sparse.csr_matrix
    """(size, n): the values of the tip section."""

    @property
    def size(self) -> int:
        return self.tip.shape[0]


def shapes(size: int, bubbles: int) -> list[Polynomial]:
    """Shape functions on [0, 1]: of the ends' values (size 1), of values and slopes (2), then those inside."""
    s = Polynomial([0, 1])
    if size == 1:
        ends = [1 - s, s]
    else:
        ends = [1 - 3 * s**2 + 2 * s**3, s - 2 * s**2 + s**3, 3 * s**2 - 2 * s**3, s**3 - s**2]
    inside = [Legendre.basis(k, domain=[0, 1]).convert(kind=Polynomial) for k in range(bubbles)]
    return ends + [(s * (1 - s)) ** size * p for p in inside]


def products(functions: list[Polynomial], weight, start: float, end: float) -> np.ndarray:
    """The integrals over [0, 1] of all products, weighted by a property of the element from s = start to s = end."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    s = (1 + nodes) / 2
    values = np.array([f(s) for f in functions])
    return (values * (weights / 2 * weight(start + (end - start) * s))) @ values.T


def boundaries(section, elements: int) -> np.ndarray:
    """Where the elements of a link end: as many in every part in which its section is smooth."""
    parts = [np.linspace(a, b, elements + 1)[1:] for a, b in intervals(section)]
    return np.concatenate([[0.0], *parts])


def flexible(size: int, stiffness, density, length: float, places: np.ndarray, bubbles: int) -> Field:
    """A chain of elements; per element: the values at its start, then those inside, last the values at the tip.

    `stiffness` and `density`: functions of s; `places`: where the elements end.
    """
    each = size + bubbles
    functions, elements = shapes(size, bubbles), len(places) - 1
    n = elements * each + size
    K, M = np.zeros((n, n)), np.zeros((n, n))
    for e in range(elements):
        ends, h = places[e : e + 2], (places[e + 1] - places[e]) * length
        scale = np.array([1.0, h][:size] * 2 + [1.0] * bubbles)
        k = h ** (1 - 2 * size) * products([f.deriv(size) for f in functions], stiffness, *ends)
        m = h * products(functions, density, *ends)
        start, end = e * each, (e + 1) * each
        at = np.ix_(*2 * [[*range(start, start + size), *range(end, end + size), *range(start + size, end)]])
        K[at] += k * np.outer(scale, scale)
        M[at] += m * np.outer(scale, scale)
    return Field(sparse.csr_matrix(K), sparse.csr_matrix(M), sparse.eye(size, n, n - size, format="csr"))


def rigid(size: int, density, length: float, places: np.ndarray) -> Field:
    """A direction that cannot deform: displacement and slope of the base tell those of all sections."""
    moved = [np.array([[1.0, s * length], [0.0, 1.0]])[:size, :size] for s in places]
    elements = flexible(size, lambda s: 0 * s, density, length, places, 0).M
    every = sparse.csr_matrix(np.vstack(moved))
    return Field(sparse.csr_matrix((size, size)), every.T @ elements @ every, sparse.csr_matrix(moved[-1]))


class Assembly:
    """Stiffness and mass of an arm over joint angles (where free) and the free values of all links."""

    def __init__(self, robot: dict, q: np.ndarray, free: bool, elements: int, bubbles: int):
        self.robot, self.q, self.free = robot, q, free
        fields = [link_fields(link, elements, bubbles) for link in robot["links"]]
        axes = sum(len(link["joint"]["axes"]) for link in robot["links"]) if free else 0
        self.n = axes + sum(f.M.shape[0] - f.size for group in fields for f in group)
        self.K, self.M = (sparse.csr_matrix((self.n, self.n)) for _ in "KM")
        self.next, self.turned, self.loose = axes, 0, 0
        section = sparse.csr_matrix((6, self.n))
        for link, group in zip(robot["links"], fields, strict=True):
            section = self._link(link, group, self._joint(link["joint"], section))

    def scale(self) -> float:
        """A square of an angular frequency of the order of the lowest one, from stiffness, mass and reach."""
        links = self.robot["links"]
        s = np.linspace(0.01, 0.99, 25)
        along = lambda link, name: property_at(link["section"], name, s)  # noqa: E731
        stiff = [float(np.min(along(link, name))) for link in links for name in ("EIy", "EIz")]
        EI = min((x for x in stiff if x), default=1.0)
        mass = sum(float(np.mean(along(link, "rhoA"))) * link["length"] for link in links)
        mass += sum(body["mass"] for link in links for body in link.get("bodies", []))
        return EI / (mass * sum(link["length"] for link in links) ** 3)

    def _joint(self, joint: dict, section: sparse.csr_matrix) -> sparse.csr_matrix:
        """[u; theta] (6, n) of the section behind a joint, in its link's axes."""
        axes = [axis_of(a) for a in joint["axes"]]
        angles, mount = self.q[self.turned :][: len(axes)], joint.get("mount", {})
        turn, columns = Rotation.identity(), []
        for axis, angle in zip(axes[::-1], angles[::-1], strict=True):
            columns.insert(0, turn.apply(axis, inverse=True))
            turn = Rotation.from_rotvec(angle * axis) * turn
        turn = Rotation.from_euler("xyz", mount.get("rpy", [0.0] * 3)) * turn
        lever = np.block([[np.eye(3), -cross(mount.get("xyz", [0.0] * 3))], [np.zeros((3, 3)), np.eye(3)]])
        base = sparse.csr_matrix(np.kron(np.eye(2), turn.as_matrix().T) @ lever) @ section
        if self.free:
            for k, column in enumerate(columns):
                unit = sparse.csr_matrix(([1.0], ([0], [self.turned + k])), (1, self.n))
                base = base + sparse.csr_matrix(np.append(np.zeros(3), column)[:, None]) @ unit
                self._add("K", unit, [[joint.get("stiffness", [0.0] * 3)[k]]])
                self._add("M", unit, [[joint.get("armature", [0.0] * 3)[k]]])
            self.loose += sum(not k for k in joint.get("stiffness", [0.0] * len(axes)))
        self.turned += len(axes)
        return base

    def _link(self, link: dict, fields: list[Field], base: sparse.csr_matrix) -> sparse.csr_matrix:
        """Add a link and its bodies; [u; theta] (6, n) of its tip section."""
        tip = sparse.lil_matrix((6, self.n))
        for field, (_, _, places) in zip(fields, DIRECTIONS.values(), strict=True):
            own = field.M.shape[0] - field.size
            ends = sparse.vstack([sign * base[row] for row, sign in places])
            values = sparse.vstack([ends, sparse.eye(own, self.n, self.next)], format="csr")
            self.next += own
            self._add("K", values, field.K)
            self._add("M", values, field.M)
            reached = field.tip @ values
            for k, (row, sign) in enumerate(places):
                tip[row] = sign * reached[k]
        for body in link.get("bodies", []):
            self._add("M", base if body["at"] == "base" else tip.tocsr(), body_inertia(body))
        return tip.tocsr()

    def _add(self, name: str, values: sparse.csr_matrix, matrix) -> None:
        setattr(self, name, getattr(self, name) + values.T @ sparse.csr_matrix(matrix) @ values)


def link_fields(link: dict, elements: int, bubbles: int) -> list[Field]:
    """The link's directions, in the order of `DIRECTIONS`."""
    out = []
    for name, (stiffness, density, places) in DIRECTIONS.items():
        size, length, ends = len(places), link["length"], boundaries(link["section"], elements)
        k, rho = (partial(property_at, link["section"], key) for key in (stiffness, density))
        if link.get("modes", {}).get(name, 0):
            out.append(flexible(size, k, rho, length, ends, bubbles))
        else:
            out.append(rigid(size, rho, length, ends))
    return out


def body_inertia(body: dict) -> np.ndarray:
    """(6, 6) over [u; theta] of the section that carries the body."""
    xx, yy, zz, xy, xz, yz = body.get("inertia", [0.0] * 6)
    arm = np.hstack([np.eye(3), -cross(body.get("com", [0.0] * 3))])
    out = body["mass"] * arm.T @ arm
    out[3:, 3:] += [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    return out


def cross(a) -> np.ndarray:
    """The matrix of `a x`."""
    return np.cross(np.eye(3), np.array(a, float))


def axis_of(axis) -> np.ndarray:
    a = np.eye(3)["xyz".index(axis)] if isinstance(axis, str) else np.array(axis, float)
    return a / np.linalg.norm(a)
