"""What the matrices of standard input data mean: from a SID to the invariants of a body, and back.

With the displacement ``u = sum_k phi_k q_k`` of the element at r the matrices of order 1 are

    mdCM  ∫ (r + u) dm                        Ct  row k: ∫ phi_k dm, m1: second order, ∫ h_kl dm
    J     ∫ -hat(r)^2 dm, m1: its slope       Cr  row k: ∫ (r + u) x phi_k dm, m1 also ∫ r x h_kl dm
    Gr    block k: -2 ∫ phi_k r^T - r.phi_k 1 dm      Ge  block l, row k: 2 ∫ phi_l x phi_k dm
    Oe    row k: ∫ phi_k.(omega x (omega x (r + u))) dm, columns xx yy zz xy yz xz of omega omega^T

These are the coefficients of the kinetic energy, each of them several times. What is read is ``mdCM`` and ``J`` of
order 0, ``Ct``, ``Cr``, ``Me``, ``Ke``, ``De``, the slope of J (``J`` of order 1, else ``Gr``) and ``Oe`` of order 1.
So the inertia is kept to second order in q, with what the geometric stiffness by rotation adds: this conserves energy.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

import numpy as np

from ..errors import RobotFileError
from .invariants import EPS, BodyNode, Invariants, hat
from .sid import PARTS, SYMMETRIC, ZERO, Sid, SidNode, Taylor, read_sid

NEEDED = ("mdCM", "J", "Ct", "Cr", "Me", "Ke")
PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))
"""The columns of Oe."""
MOST_MODES = 64
ROUNDING = 1e-4
"""Asymmetry of what must be symmetric, over its largest entry, that printed digits may leave."""


def load_sid(path: str | os.PathLike[str], base: str | None = None, tip: str | None = None) -> Invariants:
    """The body of a SID file, in the axes of its base node; the nodes are named, else the first and the last.

    Raises RobotFileError, one line.
    """
    return Standard(read_sid(path), os.fspath(path)).invariants(base, tip).from_base()


class Standard:
    """The matrices of a SID with their shapes checked."""

    def __init__(self, sid: Sid, file: str):
        self.sid, self.file, self.modes = sid, file, len(sid.names)
        if not 1 <= self.modes <= MOST_MODES:
            raise RobotFileError(f"{file}: has {self.modes} modes; a reduced body has from 1 to {MOST_MODES}")
        if missing := [name for name in NEEDED if name not in sid.parts]:
            raise RobotFileError(f"{file}: there is no '{missing[0]}'; a body needs {', '.join(NEEDED)}")

    def part(self, name: str, rows: int, columns: int) -> tuple[np.ndarray, np.ndarray]:
        """``m0`` (rows, columns) and ``m1`` (modes, rows, columns); zeros where the file has none."""
        return self._checked(name, self.sid.parts.get(name), (rows, columns))

    def _checked(self, name: str, x: Taylor | None, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
        if x is None:
            return np.zeros(shape), np.zeros((self.modes, *shape))
        if x.m0.shape != shape or (x.m1 is not None and x.m1.shape[1] != self.modes):
            stated = f"{x.m0.shape[0]} x {x.m0.shape[1]}" + ("" if x.m1 is None else f" with nq = {x.m1.shape[1]}")
            wanted = f"{shape[0]} x {shape[1]} with nq = {self.modes}"
            raise RobotFileError(f"{self.file}: line {x.line}: {name} is {stated}; it must be {wanted}")
        return x.m0, np.zeros((self.modes, *shape)) if x.m1 is None else x.m1.swapaxes(0, 1)

    def order(self, name: str) -> int:
        return self.sid.parts[name].order if name in self.sid.parts else -1

    def symmetric(self, name: str, x: np.ndarray, parts: dict[str, Taylor] | None = None) -> np.ndarray:
        """``x``, symmetric in its last two axes; refused where the file's is not."""
        other = np.swapaxes(x, -1, -2)
        if np.abs(x - other).max(initial=0.0) > ROUNDING * np.abs(x).max(initial=0.0):
            line = (parts or self.sid.parts)[name].line
            what = f"{name} is not symmetric in its modes; it derives from an energy, so it must be"
            raise RobotFileError(f"{self.file}: line {line}: {what}")
        return (x + other) / 2

    def invariants(self, base: str | None, tip: str | None) -> Invariants:
        """The body; nodes that are not named stay between base and tip."""
        r = self.modes
        full = lambda name: self.symmetric(name, self.part(name, r, r)[0])  # noqa: E731
        sag = self.symmetric("Ct", self.part("Ct", r, 3)[1].transpose(2, 1, 0))
        swing = self.part("Cr", r, 3)[1].transpose(2, 1, 0)
        return Invariants(
            gram=self.gram(),
            inertia=full("Me"),
            stiffness=full("Ke"),
            damping=full("De"),
            sag=sag,
            swing=(swing + swing.swapaxes(1, 2)) / 2,
            names=tuple(self.sid.names),
            nodes=tuple(self.nodes(base, tip)),
        )

    def gram(self) -> np.ndarray:
        """The integrals of products of the generators."""
        r, s = self.modes, 4 + 3 * self.modes
        G = np.zeros((s, s))
        G[0, 0], G[0, 1:4] = self.sid.mass, self.part("mdCM", 3, 1)[0][:, 0]
        inertia = self.part("J", 3, 3)[0]
        G[1:4, 1:4] = np.trace(inertia) / 2 * np.eye(3) - inertia
        G[0, 4:] = self.part("Ct", r, 3)[0].ravel()
        G[1:4, 4:] = self._arms().transpose(1, 0, 2).reshape(3, -1)
        G[4:, 4:] = self._products().transpose(1, 0, 3, 2).reshape(3 * r, 3 * r)
        return np.triu(G) + np.triu(G, 1).T

    def _arms(self) -> np.ndarray:
        """(r, 3, 3): ``∫ r_a phi_bk dm``, its antisymmetric part by Cr, the other by the slope of J."""
        r = self.modes
        slope = self.part("J", 3, 3)[1]
        if self.order("J") < 1:
            blocks = self.part("Gr", 3, 3 * r)[0].reshape(3, r, 3).swapaxes(0, 1)
            slope = (blocks + blocks.swapaxes(1, 2)) / 2
        trace = np.trace(slope, axis1=1, axis2=2)[:, None, None] / 4
        return trace * np.eye(3) - slope / 2 + hat(self.part("Cr", r, 3)[0]).swapaxes(1, 2) / 2

    def _products(self) -> np.ndarray:
        """(3, r, 3, r): ``∫ phi_ak phi_bl dm``, the part symmetric in a and b by Oe, the other by Cr or Ge."""
        r = self.modes
        bent = self.symmetric("Oe", self.part("Oe", r, 6)[1].transpose(2, 1, 0))
        S = np.zeros((3, 3, r, r))
        for (a, b), x in zip(PAIRS, bent, strict=True):
            S[a, b] = S[b, a] = x / 2 if a != b else x - bent[:3].sum(axis=0) / 2
        crossed = -self.part("Cr", r, 3)[1].transpose(2, 1, 0)
        if self.order("Cr") < 1:
            crossed = -self.part("Ge", r, 3 * r)[0].reshape(r, r, 3).transpose(2, 0, 1) / 2
        crossed = (crossed - crossed.swapaxes(1, 2)) / 2
        return (S + np.einsum("abc,ckl->abkl", EPS, crossed) / 2).transpose(0, 2, 1, 3)

    def nodes(self, base: str | None, tip: str | None) -> Iterator[BodyNode]:
        """The base, the others, the tip."""
        named = {node.name: node for node in self.sid.nodes}
        if len(named) < 2:
            raise RobotFileError(f"{self.file}: has {len(named)} nodes; a link needs two, its base and its tip")
        first, last = (base or self.sid.nodes[0].name), (tip or self.sid.nodes[-1].name)
        for key, name in (("base", first), ("tip", last)):
            if name not in named:
                known = ", ".join([*named][:20])
                what = f"there is no node '{name}', which is to be the {key}"
                raise RobotFileError(f"{self.file}: {what}; it has {known}")
        if first == last:
            raise RobotFileError(f"{self.file}: node '{first}' is to be both base and tip; name two")
        between = [node for name, node in named.items() if name not in (first, last)]
        yield from map(self._node, (named[first], *between, named[last]))

    def _node(self, node: SidNode) -> BodyNode:
        r = self.modes
        part = lambda name, rows, columns: self._checked(name, node.parts.get(name), (rows, columns))  # noqa: E731
        (phi, phi1), (psi, psi1) = part("phi", 3, r), part("psi", 3, r)
        axes = part("AP", 3, 3)[0] if "AP" in node.parts else np.eye(3)
        if np.abs(axes.T @ axes - np.eye(3)).max() > 1e-6:
            raise RobotFileError(f"{self.file}: line {node.parts['AP'].line}: AP is no rotation; it must be orthogonal")
        slopes = {"phi": phi1, "psi": psi1}
        second = [self.symmetric(name, x.transpose(1, 2, 0), node.parts) for name, x in slopes.items()]
        return BodyNode(node.name, part("origin", 3, 1)[0][:, 0], phi, psi, axes, *second)


# ------------------------------------------------------------------------------------ from a body


def sid_of(body: Invariants) -> Sid:
    """The standard input data of a body, all matrices of order 1 that have one."""
    r, Q, P, sigma = body.modes, body.products, body.arms, body.momenta
    trace = np.einsum("akal->kl", Q)
    arm = np.einsum("aak->k", P)
    C4 = P.transpose(2, 1, 0) - arm[:, None, None] * np.eye(3)
    C6 = Q.transpose(1, 3, 0, 2) - trace[:, :, None, None] * np.eye(3)
    second = body.gram[1:4, 1:4]
    crossed = np.einsum("cab,albk->ckl", EPS, Q)
    spin = np.stack([C6[..., a, b] + (C6[..., b, a] if a != b else 0) for a, b in PAIRS])
    spin0 = np.stack([C4[:, a, b] + (C4[:, b, a] if a != b else 0) for a, b in PAIRS], axis=1)
    blocks = lambda x: x.transpose(1, 0, 2).reshape(3, 3 * r)  # noqa: E731
    parts = {
        "mdCM": Taylor(body.gram[0, 1:4, None], sigma[:, :, None]),
        "J": Taylor(np.trace(second) * np.eye(3) - second, -(C4 + C4.swapaxes(1, 2)).swapaxes(0, 1), SYMMETRIC),
        "Ct": Taylor(sigma.T, body.sag.transpose(1, 2, 0) if body.geometric else None),
        "Cr": Taylor(np.einsum("cab,abk->kc", EPS, P), (crossed + body.swing).transpose(1, 2, 0)),
        "Me": Taylor(body.inertia, None, SYMMETRIC),
        "Gr": Taylor(-2 * blocks(C4), -2 * C6.transpose(2, 1, 0, 3).reshape(3, r, 3 * r)),
        "Ge": Taylor(2 * crossed.transpose(1, 2, 0).reshape(r, 3 * r)),
        "Oe": Taylor(spin0, spin.transpose(1, 2, 0)),
        "ksigma": Taylor(np.zeros((r, 1)), None, ZERO),
        "Ke": Taylor(body.stiffness, None, SYMMETRIC),
        "De": Taylor(body.damping, None, SYMMETRIC),
    }
    assert tuple(parts) == PARTS
    return Sid(body.mass, list(body.names), [_sid_node(n) for n in body.nodes], parts)


def _sid_node(n: BodyNode) -> SidNode:
    slope = lambda x: x.swapaxes(1, 2) if x.any() else None  # noqa: E731
    turned = np.einsum("kab,bc->akc", hat(n.psi.T), n.axes)
    parts = {
        "origin": Taylor(n.origin[:, None], n.phi[:, :, None]),
        "phi": Taylor(n.phi, slope(n.phi2)),
        "psi": Taylor(n.psi, slope(n.psi2)),
        "AP": Taylor(n.axes, turned),
        "sigma": Taylor(np.zeros((6, 1)), None, ZERO),
    }
    return SidNode(n.name, parts)
