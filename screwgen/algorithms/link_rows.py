"""The rows of the assembled system that a link contributes, (50), (83) and (97)-(100)."""

from __future__ import annotations

from ..algebra.expression import Diagonal, Expression, Symbol, stack, zeros
from ..algebra.screw import shift, twice
from ..ir.block import Block
from ..spec.link_class import EXACT, LinkClass
from .joint_rows import joint_point


def link_rows_block(key: LinkClass) -> Block:
    """The six rows of a link and its modal rows, and its columns in the rows of the next joint.

    ``M nudot + h - [J_B^T w_i; 0] + J_T^T (M_T (J_T nudot + b_T) + h_T + X^T w_{i+1}) = J_T^T w_ext``. The
    wrench of the next joint and the tip bodies act on the modes too, through ``J_T``.
    """
    b = Block("link_rows", "Rows of the link")
    r = key.modes
    M_V = b.input("M_V", (6, 6))
    M_D = b.input("M_D", (6, r))
    m_eta = _modal_inertia(b, key)
    M_T = b.input("M_T", (6, 6))
    h_V = b.input("h_V", (6, 1))
    h_phi = b.input("h_phi", (r, 1))
    h_T = b.input("h_T", (6, 1))
    b_T = b.input("b_T", (6, 1))
    w_ext = b.input("w_ext", (6, 1))
    X = b.input("X", (6, 6))
    PX = b.input("PX", (6, 6))
    J_V, J_eta = _tip_jacobian(b, key)
    b.step("V_V", M_V + J_V.T @ M_T @ J_V, symmetric=True)
    V_eta = b.step("V_eta", M_D + J_V.T @ M_T @ J_eta)
    b.step("eta_V", V_eta.T)
    b.step("eta_eta", m_eta + J_eta.T @ M_T @ J_eta if r else zeros(0, 0), symmetric=True)
    b.step("V_next", J_V.T @ X.T)
    b.step("eta_next", J_eta.T @ X.T)
    b.step("next_V", -(PX @ J_V))
    b.step("next_eta", -(PX @ J_eta))
    b.step("V_w", -shift(joint_point(b, key)).T)
    carried = b.step("h_carried", M_T @ b_T + h_T)
    b.step("V_H", h_V + J_V.T @ carried)
    b.step("eta_H", h_phi + J_eta.T @ carried)
    b.step("V_W", J_V.T @ w_ext)
    b.step("eta_W", J_eta.T @ w_ext)
    return b


def _modal_inertia(b: Block, key: LinkClass) -> Expression:
    """The (r, r) inertia of the modes; a diagonal one is given by its column."""
    r = key.modes
    if key.full_inertia:
        display = r"\mathbf{M}_{\eta,i}" if key.order == EXACT else r"\mathbf{M}_{W\phi,i}"
        return b.input("m_eta", (r, r), display, meaning="inertia of the modes", numbered=(0, 1))
    return Diagonal(b.input("m_eta", (r, 1)))


def _tip_jacobian(b: Block, key: LinkClass) -> tuple[Symbol, Symbol]:
    """``J_T``: the tip's twist from the link's twist and its modal rates."""
    R_T = b.input("R_T", (3, 3))
    r_T = b.input("r_T", (3, 1))
    J_l = b.input("J_l", (3, 3))
    Psi = b.input("Psi_c", (3, key.modes))
    Phi = b.input("Phi_c", (3, key.modes))
    turn = twice(R_T.T)
    J_V = b.step("J_TV", turn @ shift(r_T))
    J_eta = b.step("J_Teta", turn @ stack(J_l @ Psi, Phi))
    return J_V, J_eta
