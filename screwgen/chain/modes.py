"""Eliminating the modal accelerations of a link.

The modal rows read ``C^T alpha + (diag(m) + E^T Q E) etaddot + h = 0``, where ``E`` (6 x r) says how the
modes move the tip section and ``Q`` is the inertia that it carries.  Two ways give the same result:
factorise the r x r matrix, or take the tip's inertia through the modes' compliance: O(r), for many modes.
"""

from __future__ import annotations

from ..lower.program import Array
from . import matrices as mx
from .scope import Scope

DENSE_LIMIT = 8
"""Up to this many modes the r x r factor needs fewer operations than the 6 x 6 one."""


def eliminate_modes(s: Scope, Lambda: Array, p: Array) -> tuple[Array, Array]:
    """Fold the tip's reaction ``Lambda, p`` (F_i axes, tip point) in and eliminate etaddot."""
    with s.step("modes: the tip load folded in, modal accelerations eliminated (83)"):
        if s.key.modes <= DENSE_LIMIT:
            return _dense(s, Lambda, p)
        return _compliant(s, Lambda, p)


def modal_accelerations(s: Scope, alpha: Array) -> Array:
    """etaddot from the acceleration ``alpha`` of F_i."""
    if s.key.modes <= DENSE_LIMIT:
        return -mx.backward(s.kept("modes_L"), s.kept("modes_w") + mx.multiply(s.kept("modes_W"), alpha))
    return _compliant_accelerations(s, alpha)


def _dense(s: Scope, Lambda: Array, p: Array) -> tuple[Array, Array]:
    r_T, G, E, m_eta = s.kept("r_T"), s.kept("G"), s.kept("E"), s.read("m_eta", s.key.modes)
    M = s.name("M_loaded", s.kept("M_V") + mx.shift(r_T, Lambda))
    h = s.name("h_loaded", s.kept("h_V") + mx.shift_wrench(r_T, p))
    loaded = mx.multiply(Lambda, G)
    C = s.name("C", s.kept("M_D") + _columns(r_T, mx.multiply(loaded, E)))
    elastic = mx.congruence(E, mx.congruence(G, Lambda))
    inertia = mx.symmetric(s.key.modes, lambda i, j: elastic[i, j] + (m_eta[i] if i == j else 0.0))
    h_phi = s.name("h_phi", s.kept("h_eta") + s.read("f_eta", s.key.modes) + mx.chain(E.T, G.T, p))
    L, inverse = mx.factorise(s.name("modal_inertia", inertia), s.tracer)
    s.name("modes_inverse", inverse)
    Z, z = mx.forward(L, C.T), mx.forward(L, h_phi)
    W, w = mx.scale_rows(Z, inverse), mx.scale_rows(z, inverse)
    s.keep("modes_L", L)
    s.keep("modes_W", W)
    s.keep("modes_w", w)
    return s.name("M_i", mx.subtract_product(M, Z, W)), s.name("h_i", h - mx.multiply(W.T, z))


def _columns(r: Array, wrenches: Array) -> Array:
    """Wrenches at the point ``r``, one per column, about the origin."""
    out = wrenches.copy()
    for k in range(wrenches.shape[1]):
        out[:, k] = mx.shift_wrench(r, wrenches[:, k])
    return out


def _compliant(s: Scope, Lambda: Array, p: Array) -> tuple[Array, Array]:
    """With ``Y = G E diag(1/m) E^T G^T = U U^T``: ``Lambda -> Lambda - Lambda U (I + U^T Lambda U)^-1 U^T Lambda``."""
    r_T, G, E, M_D = s.kept("r_T"), s.kept("G"), s.kept("E"), s.kept("M_D")
    m_eta, h_phi = s.read("m_eta", s.key.modes), s.kept("h_eta") + s.read("f_eta", s.key.modes)
    for m in m_eta:
        s.tracer.guard(m)
    lightened = mx.divide(E.T, m_eta).T
    U = mx.multiply(G, _root(s, mx.multiply(lightened, E.T)))
    N = mx.chain(G, lightened, M_D.T)
    free = mx.chain(G, lightened, h_phi)
    LU = mx.multiply(Lambda, U)
    core = mx.symmetric(U.shape[1], lambda i, j: (1.0 if i == j else 0.0) + mx.dot(U[:, i], LU[:, j]))
    L, inverse = mx.factorise(core, s.tracer)
    Z = mx.forward(L, LU.T)
    W = mx.scale_rows(Z, inverse)
    carried = mx.subtract_product(Lambda, Z, W)
    reach = mx.identity(6)
    reach[3:, :3] = -mx.hat(r_T)
    reach = reach - N
    p_carried = p - mx.multiply(W.T, mx.forward(L, mx.multiply(U.T, p))) - mx.multiply(carried, free)
    s.keep("reach", reach)
    s.keep("carried", carried)
    s.keep("p_carried", p_carried)
    M = mx.congruence(reach, carried)
    H = mx.divide(M_D.T, m_eta).T
    rigid = s.kept("M_V")
    M = mx.symmetric(6, lambda i, j: rigid[i, j] - mx.dot(H[i], M_D[j]) + M[i, j])
    return M, s.kept("h_V") - mx.multiply(H, h_phi) + mx.multiply(reach.T, p_carried)


def _compliant_accelerations(s: Scope, alpha: Array) -> Array:
    """``etaddot = -diag(1/m) (h + M_D^T alpha + E^T G^T f)`` with the tip's load ``f``."""
    load = mx.multiply(s.kept("carried"), mx.multiply(s.kept("reach"), alpha)) + s.kept("p_carried")
    h_phi = s.kept("h_eta") + s.read("f_eta", s.key.modes)
    force = h_phi + mx.multiply(s.kept("M_D").T, alpha) + mx.chain(s.kept("E").T, s.kept("G").T, load)
    return -mx.divide(force, s.read("m_eta", s.key.modes))


def _root(s: Scope, Y: Array) -> Array:
    """``U`` with ``U U^T = Y``, by planes: a plane's slope and displacement couple, planes do not.

    A plane with one mode has rank one; its second pivot is then zero in exact arithmetic and left out.
    """
    axial, in_y, in_z, torsion = s.key.counts
    planes = [((3,), axial), ((5, 1), in_z), ((4, 2), in_y), ((0,), torsion)]
    columns = []
    for rows, modes in planes:
        if modes:
            columns += _plane(s, Y, [r for r in rows if s.key.section_rotation or r > 2], modes)
    return mx.array(columns).T if columns else mx.zeros(6, 0)


def _plane(s: Scope, Y: Array, rows: list[int], modes: int) -> list[Array]:
    if not rows:
        return []
    sub = mx.symmetric(len(rows), lambda i, j: Y[rows[i], rows[j]])
    rank = min(len(rows), modes)
    first = s.tracer.call("sqrt", sub[0, 0])
    columns = [mx.zeros(6)]
    columns[0][rows[0]] = first
    if len(rows) == 2:
        columns[0][rows[1]] = sub[1, 0] / first
    if rank == 2:
        columns.append(mx.zeros(6))
        columns[1][rows[1]] = s.tracer.call("sqrt", sub[1, 1] - columns[0][rows[1]] * columns[0][rows[1]])
    return columns
