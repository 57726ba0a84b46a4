"""Reduction of a finite-element model: from sparse matrices of mass and stiffness to the invariants of a body.

The base's nodes are clamped, the tip's nodes move as one rigid body. The shapes are the lowest modes of the body, its
tip ``free``, and the six static ones that forces and moments at the tip cause; or with the tip ``fixed`` the lowest
modes of the body whose tip is held too, and the same static ones (Craig and Bampton); or the ``natural`` modes alone,
the tip free. The coordinates are the modes in the span of these, each scaled to the body's mass, so that they are
metres.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
import scipy.linalg
import scipy.sparse as sparse
from scipy.sparse.linalg import ArpackError, eigsh, splu

from ..errors import RobotFileError, one_line
from ..files import open_arrays, sound
from . import INTERFACES
from .invariants import EPS, BodyNode, Invariants, hat
from .standard import MOST_MODES

PARTS = ("data", "indices", "indptr", "shape")
NOISE = 1e-11
"""Integrals below this, relative to what their factors allow, are rounding errors of zeros."""
ALIKE = 1e-6
"""Relative difference of squared frequencies that a symmetric body makes equal."""


@dataclass(frozen=True)
class Mesh:
    """A finite-element model: n nodes of 3 (displacements) or 6 (and rotations) degrees of freedom, node by node."""

    M: sparse.csc_matrix
    K: sparse.csc_matrix
    places: np.ndarray
    """(n, 3) m."""
    sets: Mapping[str, np.ndarray]
    points: Mapping[str, np.ndarray]
    """The reference point of each set, (3,) m."""

    @property
    def each(self) -> int:
        """Degrees of freedom of a node."""
        return self.M.shape[0] // len(self.places)

    def of(self, name: str) -> np.ndarray:
        """The degrees of freedom of a set, node by node."""
        return (self.sets[name][:, None] * self.each + np.arange(self.each)).ravel()

    def rigid(self, name: str) -> np.ndarray:
        """(degrees of freedom of the set, 6): its motion by unit displacements and rotations at its point."""
        arm = self.places[self.sets[name]] - self.points[name]
        out = np.zeros((len(arm), self.each, 6))
        out[:, :3, :3], out[:, :3, 3:] = np.eye(3), hat(arm).swapaxes(1, 2)
        out[:, 3:, 3:] = np.eye(3)[: self.each - 3]
        return out.reshape(-1, 6)

    def linear(self, origin: np.ndarray) -> np.ndarray:
        """(all, 12): the fields ``e_b``, then ``r_a e_b`` (a slow) with half their curl as rotation."""
        r = self.places - origin
        out = np.zeros((len(r), self.each, 4, 3))
        out[:, :3, 0] = np.eye(3)
        for b in range(3):
            out[:, b, 1:, b] = r
        if self.each == 6:
            out[:, 3:, 1:] = EPS / 2
        return out.reshape(-1, 12)


def load_npz(
    path: str | os.PathLike[str],
    modes: int | None,
    frequency: float | None = None,
    interface: str = INTERFACES[0],
    base: str = "base",
    tip: str = "tip",
) -> Invariants:
    """The reduced body of a file; see :func:`read_mesh` for its keys, :func:`reduced` for the rest."""
    return reduced(read_mesh(path), modes, frequency, interface, base, tip, os.fspath(path))


def read_mesh(path: str | os.PathLike[str]) -> Mesh:
    """A finite-element model in NumPy's format.

    Keys: ``M_data, M_indices, M_indptr, M_shape`` and ``K_…``, the parts of SciPy's ``csr`` matrices of mass and
    stiffness; ``nodes`` (n, 3), m; ``set_base``, ``set_tip`` and others, indices of nodes; and where wanted
    ``point_base`` …, the reference point (3,) m of a set, by default the mean of its nodes. Raises RobotFileError.
    """
    file, needed = os.fspath(path), [f"{m}_{part}" for m in "MK" for part in PARTS] + ["nodes"]
    try:
        with open_arrays(path) as data:
            stored = {name: data[name] for name in data if name in needed or name.startswith(("set_", "point_"))}
    except FileNotFoundError:
        raise RobotFileError(f"{file}: there is no such file; paths are relative to the robot file") from None
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or str(error)
        what = f"cannot be read as a .npz file: {one_line(why)}"
        raise RobotFileError(f"{file}: {what}; write it with numpy.savez") from None
    fault = lambda what: RobotFileError(one_line(f"{file}: {what}"))  # noqa: E731
    if missing := [name for name in needed if name not in stored]:
        raise fault(f"has no '{missing[0]}'; it needs {', '.join(needed)} and sets of nodes")
    places = stored["nodes"]
    if places.ndim != 2 or places.shape[1] != 3 or places.dtype.kind != "f" or not len(places):
        raise fault("nodes must be an array (n, 3) of coordinates in m")
    if not sound(places):
        raise fault("nodes holds numbers that are not finite; give coordinates in m")
    M, K = (_matrix(stored, name, len(places), fault) for name in "MK")
    sets = {name[4:]: _set(stored, name, len(places), fault) for name in stored if name.startswith("set_")}
    points = {name: stored.get(f"point_{name}", places[nodes].mean(axis=0)) for name, nodes in sets.items()}
    if wrong := [name for name, point in points.items() if not _is_point(point)]:
        raise fault(f"point_{wrong[0]} must be three coordinates in m")
    return Mesh(M, K, places, sets, points)


Fault = Callable[[str], RobotFileError]
"""The error that says so of a file."""


def _matrix(stored: Mapping[str, np.ndarray], name: str, n: int, fault: Fault) -> sparse.csc_matrix:
    data, *places = (stored[f"{name}_{part}"] for part in PARTS)
    try:
        if data.dtype.kind not in "iuf" or any(x.dtype.kind not in "iu" or x.ndim != 1 for x in places):
            raise TypeError
        indices, indptr, shape = places
        out = sparse.csr_matrix((data.astype(float), indices, indptr), shape=tuple(map(int, shape)))
        out.check_format(full_check=True)  # an index out of bounds would be written through
    except (ValueError, TypeError, IndexError, OverflowError):
        raise fault(f"{name} is no sparse matrix; store the parts of a scipy.sparse.csr_matrix") from None
    if out.shape not in ((3 * n, 3 * n), (6 * n, 6 * n)):
        raise fault(f"{name} is {out.shape[0]} x {out.shape[1]}; with {n} nodes it must have {3 * n} or {6 * n} rows")
    if not sound(out.data) or abs(out - out.T).max() > 1e-9 * abs(out).max():
        raise fault(f"{name} is not finite and symmetric; it must be both")
    return ((out + out.T) / 2).tocsc()


def _is_point(point: np.ndarray) -> bool:
    return point.shape == (3,) and point.dtype.kind in "iuf" and sound(point)


def _set(stored: Mapping[str, np.ndarray], name: str, n: int, fault: Fault) -> np.ndarray:
    nodes = np.unique(stored[name])
    if nodes.dtype.kind not in "iu" or not len(nodes) or nodes[0] < 0 or nodes[-1] >= n:
        raise fault(f"{name} must be indices of nodes, from 0 to {n - 1}")
    return nodes.astype(np.intp)


def reduced(
    mesh: Mesh,
    modes: int | None,
    frequency: float | None = None,
    interface: str = INTERFACES[0],
    base: str = "base",
    tip: str = "tip",
    file: str = "mesh",
) -> Invariants:
    """The body with ``modes`` modes beside the static shapes, or all up to ``frequency`` Hz.

    Raises RobotFileError where the sets, the matrices or the count do not allow it.
    """
    for key, name in (("base", base), ("tip", tip)):
        if name not in mesh.sets:
            known = ", ".join(mesh.sets) or "none"
            raise RobotFileError(f"{file}: has no 'set_{name}', which is to be the {key}; it has {known}")
    if np.intersect1d(mesh.sets[base], mesh.sets[tip]).size:
        raise RobotFileError(f"{file}: base and tip share nodes; they must not touch")
    if np.linalg.matrix_rank(mesh.rigid(tip)) < 6:
        raise RobotFileError(f"{file}: the nodes of '{tip}' lie on a line; a tip needs three that do not")
    try:
        V, omega = _shapes(mesh, modes, frequency, interface, base, tip, file)
    except (RuntimeError, np.linalg.LinAlgError, ArpackError):
        what = "cannot be solved; M must be positive definite, and K too with the base clamped"
        raise RobotFileError(f"{file}: the eigenvalue problem {what}") from None
    return _invariants(mesh, V, omega, base, tip)


def _shapes(
    mesh: Mesh, modes: int | None, frequency: float | None, interface: str, base: str, tip: str, file: str
) -> tuple[np.ndarray, np.ndarray]:
    """The modes (all degrees of freedom, r), each of the body's mass, and their angular frequencies."""
    inner = np.setdiff1d(np.arange(mesh.M.shape[0]), np.union1d(mesh.of(base), mesh.of(tip)))
    T = _rigid_tip(mesh, inner, tip)
    M, K = ((T.T @ x @ T).tocsc() for x in (mesh.M, mesh.K))
    own = len(inner) if interface == "fixed" else T.shape[1]
    V = np.zeros((T.shape[1], 0))
    if interface != "natural":
        unit = np.zeros((T.shape[1], 6))
        unit[-6:] = np.eye(6)
        V = splu(K).solve(unit)
    rigid = mesh.linear(np.zeros(3))[:, :3]
    mass = float(rigid[:, 0] @ (mesh.M @ rigid[:, 0]))
    if not mass > 0:
        raise np.linalg.LinAlgError
    seen = np.vstack([_motion(mesh, tip) @ T, rigid.T @ (mesh.M @ T) / mass])
    lowest = np.zeros((T.shape[1], 0))
    if modes != 0:
        most = MOST_MODES - V.shape[1]
        shapes = _lowest(K[:own, :own], M[:own, :own], seen[:, :own], modes, frequency, most, file)
        lowest = np.vstack([shapes, np.zeros((T.shape[1] - own, shapes.shape[1]))])
    V = V - lowest @ (lowest.T @ (M @ V))
    masses = np.sum(V * (M @ V), axis=0)
    if not np.all(masses > 0):
        raise np.linalg.LinAlgError
    V = np.hstack([V / np.sqrt(masses), lowest])
    if not V.shape[1]:
        raise RobotFileError(f"{file}: no mode is left; raise modes or frequency")
    squares, turn = scipy.linalg.eigh(V.T @ (K @ V), V.T @ (M @ V))
    if squares[0] <= 0:
        raise np.linalg.LinAlgError
    return T @ _untangled(V @ turn * np.sqrt(mass), squares, seen), np.sqrt(squares)


def _rigid_tip(mesh: Mesh, inner: np.ndarray, tip: str) -> sparse.csr_matrix:
    """(all, inner + 6): the degrees of freedom by those of inner nodes and of the tip, the base's at rest."""
    own, rigid = mesh.of(tip), mesh.rigid(tip)
    rows, columns = np.repeat(own, 6), np.tile(len(inner) + np.arange(6), len(own))
    entries = np.append(np.ones(len(inner)), rigid.ravel())
    places = np.append(inner, rows), np.append(np.arange(len(inner)), columns)
    return sparse.csr_matrix((entries, places), shape=(mesh.M.shape[0], len(inner) + 6))


def _lowest(
    K: sparse.csc_matrix,
    M: sparse.csc_matrix,
    seen: np.ndarray,
    modes: int | None,
    frequency: float | None,
    most: int,
    file: str,
) -> np.ndarray:
    """The lowest modes (n, count), mass-normalised: ``modes`` of them, or those up to ``frequency`` Hz.

    One more is computed, so that the last is not any combination of two of equal frequency.
    """
    most, count = min(most, K.shape[0] - 2), modes or 8
    while count <= most:
        squares, shapes = eigsh(K, k=count + 1, M=M, sigma=0, v0=np.ones(K.shape[0]))
        order = np.argsort(squares)
        shapes = _untangled(shapes[:, order], squares[order], seen)
        kept = count if frequency is None else int(np.sum(squares <= (2 * np.pi * frequency) ** 2))
        if kept <= count:
            return shapes[:, :kept]
        count *= 2
    wanted = f"modes = {modes}" if modes else f"more than {most} modes up to {frequency:g} Hz"
    raise RobotFileError(f"{file}: {wanted}; a reduced body has at most {most} beside its static shapes")


def _untangled(V: np.ndarray, squares: np.ndarray, seen: np.ndarray) -> np.ndarray:
    """Modes of equal frequency combined so that as much as possible of ``seen @ V`` vanishes; signs fixed.

    ``seen`` has the motion of the tip and the momentum: the modes of a symmetric body keep to its planes.
    """
    V, first = V.copy(), 0
    for last in range(1, len(squares) + 1):
        if last == len(squares) or squares[last] > squares[first] * (1 + ALIKE):
            part = V[:, first:last]
            V[:, first:last] = part @ scipy.linalg.qr((seen @ part).T, pivoting=True)[0]
            first = last
    motion = seen @ V
    largest = np.argmax(abs(motion) > 0.9 * abs(motion).max(axis=0), axis=0)
    return V * np.where(motion[largest, np.arange(len(squares))] < 0, -1.0, 1.0)


def _motion(mesh: Mesh, name: str) -> np.ndarray:
    """(6, all): displacement and rotation of a set's point, the rigid motion nearest to that of its nodes."""
    own, rigid = mesh.of(name), mesh.rigid(name)
    out = np.zeros((6, mesh.M.shape[0]))
    out[:, own] = np.linalg.pinv(rigid)
    return out


def _invariants(mesh: Mesh, V: np.ndarray, omega: np.ndarray, base: str, tip: str) -> Invariants:
    r, origin = V.shape[1], mesh.points[base]
    fields = mesh.linear(origin)
    parts = np.zeros((len(V), r, 3))
    for a in range(3):
        parts[a :: mesh.each, :, a] = V[a :: mesh.each]
    rigid = fields.T @ (mesh.M @ fields)
    coupled = fields.T @ (mesh.M @ V)
    G = np.zeros((4 + 3 * r,) * 2)
    G[:4, :4] = np.einsum("aibi->ab", rigid.reshape(4, 3, 4, 3)) / 3
    spins = fields[:, 3:].reshape(-1, 3, 3)
    turn = np.einsum("cab,nab->nc", EPS, spins)
    inertia = turn.T @ (mesh.M @ turn)
    G[1:4, 1:4] = np.trace(inertia) / 2 * np.eye(3) - inertia
    G[:4, 4:] = coupled.reshape(4, 3, r).swapaxes(1, 2).reshape(4, 3 * r)
    flat = parts.reshape(len(V), 3 * r)
    G[4:, 4:] = flat.T @ (mesh.M @ flat)
    G = np.triu(G) + np.triu(G, 1).T
    scale = np.sqrt(np.abs(np.diag(G)))
    scale[1:4] = scale[1:4].max()
    scale[4:] = np.sqrt(G[0, 0])
    G[np.abs(G) < NOISE * np.outer(scale, scale)] = 0.0
    none, mass = np.zeros((3, r, r)), G[0, 0]
    names = tuple(f"{w / (2 * np.pi):.6g} Hz" for w in omega)
    others = [name for name in mesh.sets if name not in (base, tip)]
    nodes = tuple(_node(mesh, name, V, origin, name == base) for name in (base, *others, tip))
    return Invariants(G, mass * np.eye(r), np.diag(mass * omega**2), np.zeros((r, r)), none, none, names, nodes)


def _node(mesh: Mesh, name: str, V: np.ndarray, origin: np.ndarray, clamped: bool) -> BodyNode:
    r = V.shape[1]
    motion = np.zeros((6, r)) if clamped else _motion(mesh, name) @ V
    for part in (motion[:3], motion[3:]):
        part[np.abs(part) < NOISE * np.abs(part).max(initial=0.0)] = 0.0
    none = np.zeros((3, r, r))
    return BodyNode(name, mesh.points[name] - origin, motion[:3], motion[3:], np.eye(3), none, none)
