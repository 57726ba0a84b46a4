"""Eliminating the modal accelerations of a link.

The modal rows read ``C^T alpha + (m + E^T Q E) etaddot + h = 0``, where ``m`` is the inertia of the modes, diagonal or
in blocks by direction, ``E`` (6 x r) maps modal to tip accelerations and ``Q`` is the articulated inertia at the tip.
Two methods give the same result: to factorise the r x r matrix, or to combine the tip's inertia with the modes'
compliance, which costs O(r) if ``m`` is diagonal.
For each link class the one with fewer operations is taken when its programs are traced (:func:`.schedule.trace`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..ir.program import Array, Value
from . import matrices as mx
from .scope import Scope

FACTOR, COMPLIANCE = "factor", "compliance"
WAYS = (FACTOR, COMPLIANCE)
"""The two methods: the r x r factor, or the modes' compliance."""


Rows = tuple[Array, Array, Array, Array]
"""``M_V, M_D, h_V, h_eta`` of the link alone."""
Load = tuple[Scope, Array, Array]
"""A section, and the reaction ``Lambda, p`` of what it carries, in F_i axes at its point."""


def eliminate_modes(s: Scope, own: Rows, loads: Sequence[Load]) -> tuple[Array, Array]:
    """Add the reactions at the tip and at the stations to the link's equations and eliminate etaddot."""
    with s.step("modes: the tip load folded in, modal accelerations eliminated (83)"):
        if s.way == FACTOR:
            return _dense(s, own, loads)
        ((_, Lambda, p),) = loads
        return _compliant(s, own, Lambda, p)


def modal_accelerations(s: Scope, delta: Array) -> Array:
    """etaddot from ``delta``, the part of F_i's acceleration that joint and modal accelerations cause."""
    if s.way == FACTOR:
        return -mx.backward(s.kept("modes_L"), s.kept("modes_w") + mx.multiply(s.kept("modes_W"), delta))
    return _compliant_accelerations(s, delta)


def _tip_shapes(s: Scope) -> Array:
    """``[J_l Psi_c; Phi_c]``: rotation and displacement of the tip section per unit of each mode."""
    return s.name("Theta", np.vstack([mx.multiply(s.kept("J_l"), s.kept("Psi_c")), s.kept("Phi_c")]))


def _dense(s: Scope, own: Rows, loads: Sequence[Load]) -> tuple[Array, Array]:
    M, C, h, h_phi = own
    places, inertia = [section.kept("r_T") for section, _, _ in loads], s.modal_inertia()
    for (section, Lambda, p), r_T in zip(loads, places, strict=True):
        Theta = _tip_shapes(section)
        M = s.name("M_loaded", M + mx.shift(r_T, Lambda))
        h = s.name("h_loaded", h + mx.shift_wrench(r_T, p), "h_V")
        loaded = mx.multiply(Lambda, Theta)
        C = s.name("C", C + _columns(r_T, loaded))
        inertia = _loaded(Theta, loaded, inertia)
        stress = s.read("f_eta") if section is s else mx.zeros(s.key.modes)
        h_phi = s.name("h_phi", h_phi + stress + mx.multiply(Theta.T, p))
    L, inverse = mx.factorise(s.name("modal_inertia", inertia), s.tracer)
    s.name("modes_inverse", inverse)
    Z, z = mx.forward(L, C.T), mx.forward(L, h_phi)
    W, w = mx.scale_rows(Z, inverse), mx.scale_rows(z, inverse)
    s.keep("modes_L", L)
    s.keep("modes_W", W)
    s.keep("modes_w", w)
    return s.name("M_i", mx.subtract_product(M, Z, W)), s.name("h_i", h - mx.multiply(W.T, z), "h_V")


def _loaded(Theta: Array, loaded: Array, inertia: Array) -> Array:
    """The modes' inertia with that of a load, whose wrenches per unit of each mode are given."""
    elastic: Callable[[int, int], Value] = lambda i, j: mx.dot(Theta[:, i], loaded[:, j]) + inertia[i, j]  # noqa: E731
    return mx.symmetric(len(inertia), elastic)


def _columns(r: Array, wrenches: Array) -> Array:
    """Wrenches at the point ``r``, one per column, expressed about the origin."""
    out = wrenches.copy()
    for k in range(wrenches.shape[1]):
        out[:, k] = mx.shift_wrench(r, wrenches[:, k])
    return out


def _compliant(s: Scope, own: Rows, Lambda: Array, p: Array) -> tuple[Array, Array]:
    """With ``Y = G E m^-1 E^T G^T = U U^T``: ``Lambda -> Lambda - Lambda U (I + U^T Lambda U)^-1 U^T Lambda``."""
    M_V, M_D, h_V, h_eta = own
    r_T, G, E = s.kept("r_T"), _turned(s), _shapes(s)
    factor, h_phi = mx.factorise(s.modal_inertia(), s.tracer), h_eta + s.read("f_eta")
    s.keep("M_D", M_D)
    s.keep("h_phi", h_phi)
    lightened = mx.solve(factor, E.T).T
    U = mx.multiply(G, _root(s, mx.multiply(lightened, E.T)))
    N = mx.chain(G, lightened, M_D.T)
    yielded = mx.chain(G, lightened, h_phi)
    LU = mx.multiply(Lambda, U)
    core = mx.symmetric(U.shape[1], lambda i, j: (1.0 if i == j else 0.0) + mx.dot(U[:, i], LU[:, j]))
    L, inverse = mx.factorise(core, s.tracer)
    Z = mx.forward(L, LU.T)
    W = mx.scale_rows(Z, inverse)
    carried = mx.subtract_product(Lambda, Z, W)
    reach = mx.identity(6)
    reach[3:, :3] = -mx.hat(r_T)
    reach = reach - N
    p_carried = p - mx.multiply(W.T, mx.forward(L, mx.multiply(U.T, p))) - mx.multiply(carried, yielded)
    s.keep("reach", reach)
    s.keep("carried", carried)
    s.keep("p_carried", p_carried)
    M = mx.congruence(reach, carried)
    H = mx.solve(factor, M_D.T).T
    M = mx.symmetric(6, lambda i, j: M_V[i, j] - mx.dot(H[i], M_D[j]) + M[i, j])
    return M, h_V - mx.multiply(H, h_phi) + mx.multiply(reach.T, p_carried)


def _turned(s: Scope) -> Array:
    """``blkdiag(J_l, I)``: the tip section's rotation and displacement from the modes' slopes and displacements."""
    G = mx.identity(6)
    G[:3, :3] = s.kept("J_l")
    return G


def _shapes(s: Scope) -> Array:
    """``[Psi_c; Phi_c]``: slope and displacement of the tip section by each mode."""
    return np.vstack([s.kept("Psi_c"), s.kept("Phi_c")])


def _compliant_accelerations(s: Scope, delta: Array) -> Array:
    """``etaddot = -m^-1 (h + M_D^T delta + E^T G^T f)`` with the tip's load ``f``."""
    load = mx.multiply(s.kept("carried"), mx.multiply(s.kept("reach"), delta)) + s.kept("p_carried")
    force = s.kept("h_phi") + mx.multiply(s.kept("M_D").T, delta) + mx.chain(_shapes(s).T, _turned(s).T, load)
    return -mx.solve(mx.factorise(s.modal_inertia()), force)


def _root(s: Scope, Y: Array) -> Array:
    """``U`` with ``U U^T = Y``, by the Cholesky factors of the blocks of rows that no mode couples to others.

    A block that fewer modes move than it has rows has their number as rank; the further pivots, zero in exact
    arithmetic, are left out.
    """
    columns = [column for rows, rank in _blocks(_shapes(s)) for column in _cholesky(s, Y, rows, rank)]
    return mx.array(columns).T if columns else mx.zeros(6, 0)


ROWS = (3, 5, 1, 4, 2, 0)
"""The rows of the tip shapes in the order of the factor: displacements go before the rotations that they cause."""


def _blocks(shapes: Array) -> list[tuple[list[int], int]]:
    """The rows that modes couple, with the rank of their block of ``Y``: for a rod, the planes of bending."""
    moved = {row: frozenset(k for k, value in enumerate(shapes[row]) if value != 0) for row in ROWS}
    blocks: list[tuple[list[int], frozenset[int]]] = []
    for row, modes in moved.items():
        if not modes:
            continue
        coupled = [block for block in blocks if block[1] & modes]
        blocks = [block for block in blocks if block not in coupled]
        blocks.append(([r for rows, _ in coupled for r in rows] + [row], modes.union(*(m for _, m in coupled))))
    return [(rows, min(len(rows), len(modes))) for rows, modes in blocks]


def _cholesky(s: Scope, Y: Array, rows: list[int], rank: int) -> list[Array]:
    """The first ``rank`` columns of the Cholesky factor of the block of ``Y`` in these rows."""
    columns: list[Array] = []
    for k in range(rank):
        rest = [Y[row, rows[k]] - sum((c[row] * c[rows[k]] for c in columns), 0.0) for row in rows[k:]]
        pivot = s.tracer.call("sqrt", rest[0])
        column = mx.zeros(6)
        column[rows[k]] = pivot
        for row, value in zip(rows[k + 1 :], rest[1:], strict=True):
            column[row] = value / pivot
        columns.append(column)
    return columns
