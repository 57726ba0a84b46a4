"""The invariants of a flexible body given by numbers: mass integrals of its displacement field, and its nodes.

The field is linear in the modal coordinates, ``u = Phi eta``, and to second order ``1/2 eta^T H_c eta`` more along each
axis c where the body has geometric stiffness. Its kinetic energy needs the integrals of products of two of the
*generators* 1, x, y, z and ``phi_ak``, the displacement along axis a by mode k; they are the ``gram`` matrix.

Sections or nodes with rotary inertia fit in: in rows of the equations of motion the integrals occur in the combinations
inertia, momentum of a mode and so on, and the entries of ``gram`` are those that give the body's combinations. The
inertia of the modes has rotary parts too, so it stands beside.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, fields, replace
from functools import cached_property

import numpy as np

from ..errors import RobotFileError

EPS = np.zeros((3, 3, 3))
"""The permutation symbol: ``(a x b)_c = EPS[c, i, j] a_i b_j``."""
for _i, _j, _k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
    EPS[_i, _j, _k], EPS[_i, _k, _j] = 1.0, -1.0


def hat(a: np.ndarray) -> np.ndarray:
    """``hat(a) b = a x b``, for vectors in the last axis of ``a``."""
    return np.einsum("ijk,...j->...ik", EPS, a)


DEFINITE, ROUNDING = 1e-12, 1e-4
"""The smallest eigenvalue of a matrix scaled to a diagonal of ones; what printed digits may miss."""


@dataclass(frozen=True, eq=False)
class BodyNode:
    """A node of the body: what the modes do to it, in the body's axes."""

    name: str
    origin: np.ndarray
    """(3,) m, undeformed."""
    phi: np.ndarray
    """(3, r): displacement by each mode."""
    psi: np.ndarray
    """(3, r) rad/m: rotation vector by each mode."""
    axes: np.ndarray
    """(3, 3): takes components in the node's axes to the body's, undeformed."""
    phi2: np.ndarray
    """(3, r, r): the second-order displacement along axis c is ``1/2 eta^T phi2[c] eta``, m."""
    psi2: np.ndarray
    """(3, r, r): the second-order rotation vector, likewise, rad."""


@dataclass(frozen=True, eq=False)
class Invariants:
    """A flexible body of r modes; bodies of the same numbers compare and hash equal."""

    gram: np.ndarray
    """(4 + 3 r, 4 + 3 r): integrals over the mass of products of 1, x, y, z, then ``phi_ak`` mode by mode; kg, m.

    With each product of two modes stands what the second-order displacement adds to the second moment of mass.
    """
    inertia: np.ndarray
    """(r, r) kg, of the modes."""
    stiffness: np.ndarray
    """(r, r) N/m."""
    damping: np.ndarray
    """(r, r) N·s/m."""
    sag: np.ndarray
    """(3, r, r) kg/m: integral of the second-order displacement, ``∫ H_c dm``."""
    swing: np.ndarray
    """(3, r, r) kg: its moment, ``∫ r x H dm``."""
    names: tuple[str, ...]
    """What the modes are, for documents."""
    nodes: tuple[BodyNode, ...]
    """The base first, the tip last."""

    @cached_property
    def digest(self) -> str:
        """A hash of all numbers and names."""
        return _digest(self)

    def __hash__(self) -> int:
        return hash(self.digest)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Invariants) and self.digest == other.digest

    def __repr__(self) -> str:
        return f"Invariants({self.modes} modes, {self.digest[:8]})"

    @property
    def modes(self) -> int:
        """The number of modes r."""
        return len(self.inertia)

    @property
    def mass(self) -> float:
        """kg."""
        return float(self.gram[0, 0])

    @property
    def momenta(self) -> np.ndarray:
        """(3, r) kg: the momentum of each mode, ``∫ Phi dm``."""
        return self.gram[0, 4:].reshape(-1, 3).T

    @property
    def arms(self) -> np.ndarray:
        """(3, 3, r) kg·m: ``∫ r_a phi_bk dm``."""
        return self.gram[1:4, 4:].reshape(3, -1, 3).swapaxes(1, 2)

    @property
    def products(self) -> np.ndarray:
        """(3, r, 3, r) kg: ``∫ phi_ak phi_bl dm``."""
        r = self.modes
        return self.gram[4:, 4:].reshape(r, 3, r, 3).transpose(1, 0, 3, 2)

    @property
    def geometric(self) -> bool:
        """Whether the body has a second-order displacement, and with it geometric stiffness."""
        arrays = [self.sag, self.swing, *(x for n in (self.base, self.tip) for x in (n.phi2, n.psi2))]
        return any(bool(x.any()) for x in arrays)

    @property
    def base(self) -> BodyNode:
        """Where the joint holds the body."""
        return self.nodes[0]

    @property
    def tip(self) -> BodyNode:
        """Where the next link is mounted."""
        return self.nodes[-1]

    @property
    def reach(self) -> float:
        """The distance of the tip from the base, m."""
        return float(np.linalg.norm(self.tip.origin - self.base.origin))

    @property
    def coupled(self) -> tuple[tuple[int, int], ...]:
        """Row and column of the entries below the diagonal of inertia, stiffness and damping that are not zero."""
        full = abs(self.inertia) + abs(self.stiffness) + abs(self.damping)
        return tuple((int(i), int(j)) for i, j in np.argwhere(np.tril(full, -1)))

    def check(self) -> None:
        """Raises RobotFileError where no body has these numbers, or a mode moves without strain."""
        r, P = self.modes, self.arms
        if not all(np.isfinite(x).all() for x in (self.gram, self.inertia, self.stiffness, self.damping)):
            raise RobotFileError("the body's numbers are not finite; check the file")
        if not self.mass > 0:
            raise RobotFileError(f"the mass of the body is {self.mass:g} kg; it must be > 0")
        for what, matrix in (("inertia Me", self.inertia), ("stiffness Ke", self.stiffness)):
            scale = np.sqrt(np.abs(np.diag(matrix)))
            if not scale.all() or np.linalg.eigvalsh(matrix / np.outer(scale, scale))[0] < DEFINITE:
                remedy = "leave out modes of rigid motion"
                raise RobotFileError(f"the {what} of the modes is not positive definite; {remedy}")
        first, J = hat(self.gram[0, 1:4]), self.gram[1:4, 1:4]
        inertia = np.trace(J) * np.eye(3) - J
        spins = np.einsum("cab,abk->ck", EPS, P)
        rigid = np.block([[inertia, first], [-first, self.mass * np.eye(3)]])
        coupling = np.vstack([spins, self.momenta])
        whole = np.block([[rigid, coupling], [coupling.T, self.inertia]])
        scale = np.sqrt(np.maximum(np.diag(whole), 1e-12 * np.diag(whole)[: 6 + r].max()))
        if np.linalg.eigvalsh(whole / np.outer(scale, scale))[0] < -ROUNDING:
            what = "mass, mdCM, J, Ct, Cr and Me contradict each other"
            raise RobotFileError(f"the kinetic energy of the body is not positive: {what}; check units and signs")

    def linear(self) -> Invariants:
        """The same body without its second-order displacement."""
        nodes = tuple(replace(n, phi2=np.zeros_like(n.phi2), psi2=np.zeros_like(n.psi2)) for n in self.nodes)
        return replace(self, sag=np.zeros_like(self.sag), swing=np.zeros_like(self.swing), nodes=nodes)

    def from_base(self) -> Invariants:
        """The same body in the axes of its base node, whose point is the origin and which then rests.

        Displacements are those relative to the base: to first order each mode loses the rigid motion that it gives the
        base. Raises RobotFileError where that would change a geometric stiffness.
        """
        b = self.base
        turn = b.axes.T
        if not (b.origin.any() or b.phi.any() or b.psi.any()) and np.array_equal(turn, np.eye(3)):
            return self
        if self.geometric and (b.phi.any() or b.psi.any()):
            what = f"node {b.name} is the base, but its modes move it, and the body has geometric stiffness"
            raise RobotFileError(f"{what}; clamp the base in the modes, or take order = 1")
        T, lowered = self._change(turn), np.einsum("a,bkl->akbl", b.origin, self.sag) / 2
        shifted = self.gram.copy()
        shifted[4:, 4:] -= (
            (lowered + lowered.transpose(2, 1, 0, 3)).transpose(1, 0, 3, 2).reshape(shifted[4:, 4:].shape)
        )
        gram = T @ shifted @ T.T
        trace = lambda G: np.einsum("akal->kl", replace(self, gram=G).products)  # noqa: E731
        inertia = self.inertia + trace(gram) - trace(shifted)
        swing = self.swing - np.einsum("cab,a,bkl->ckl", EPS, b.origin, self.sag)
        rotated = lambda x: np.einsum("ab,bkl->akl", turn, x)  # noqa: E731
        nodes = tuple(self._seen(n, turn) for n in self.nodes)
        return replace(self, gram=gram, inertia=inertia, sag=rotated(self.sag), swing=rotated(swing), nodes=nodes)

    def _change(self, turn: np.ndarray) -> np.ndarray:
        """The new generators as sums of the old."""
        T, b = np.eye(len(self.gram)), self.base
        T[1:4, 1:4], T[1:4, 0] = turn, -turn @ b.origin
        for k in range(self.modes):
            own = slice(4 + 3 * k, 7 + 3 * k)
            spin = turn @ hat(b.psi[:, k])
            T[own, own], T[own, 1:4] = turn, -spin
            T[own, 0] = spin @ b.origin - turn @ b.phi[:, k]
        return T

    def _seen(self, n: BodyNode, turn: np.ndarray) -> BodyNode:
        """A node as the base sees it."""
        b = self.base
        arm = n.origin - b.origin
        moved = n.phi - b.phi - np.cross(b.psi, arm, axisa=0).T
        second = {name: np.einsum("ab,bkl->akl", turn, getattr(n, name)) for name in ("phi2", "psi2")}
        rest = replace(n, origin=turn @ arm, phi=turn @ moved, psi=turn @ (n.psi - b.psi), **second)
        return replace(rest, axes=turn @ n.axes)


def _digest(x: object) -> str:
    """A hash of the fields of a dataclass, arrays by their bytes."""
    text = hashlib.sha256()
    for f in fields(x):  # type: ignore[arg-type]
        value = getattr(x, f.name)
        if isinstance(value, np.ndarray):
            text.update(repr(value.shape).encode() + np.ascontiguousarray(value + 0.0).tobytes())
        elif isinstance(value, tuple) and value and isinstance(value[0], BodyNode):
            text.update("".join(map(_digest, value)).encode())
        else:
            text.update(repr(value).encode())
    return text.hexdigest()
