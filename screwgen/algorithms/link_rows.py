"""The rows of the assembled system that a link contributes, (50), (83) and (97)-(100)."""

from __future__ import annotations

from ..algebra.expression import Diagonal, Expression, Symbol, stack, zeros
from ..algebra.screw import lever, twice
from ..ir.block import Block
from ..spec.link_class import LinkClass
from .joint_rows import MIXED, joint_point

LINK = "F_i"


def link_rows_block(key: LinkClass) -> Block:
    """The six rows of a link and its modal rows, and its columns in the rows of the next joint.

    ``M nudot + h - [J_B^T w_i; 0] + J_T^T (M_T (J_T nudot + b_T) + h_T + X^T w_{i+1}) = J_T^T w_ext``. The
    wrench of the next joint and the tip bodies act on the modes too, through ``J_T``.
    """
    b = Block("link_rows", "Rows of the link")
    r = key.modes
    M_V = b.input("M_V", (6, 6), r"\mathbf{M}_V", "kg, kg*m, kg*m^2", LINK, "inertia in the twist rows")
    M_D = b.input(
        "M_D", (6, r), r"\mathbf{M}_{D,i}", "kg, kg*m", LINK, "wrench that modal accelerations need", numbered=(1,)
    )
    m_eta = _modal_inertia(b, key)
    M_T = b.input("M_T", (6, 6), r"\mathbf{M}_T", "kg, kg*m, kg*m^2", "tip frame", "inertia of the bodies at the tip")
    h_V = b.input("h_V", (6, 1), r"\mathbf{h}_V", "N*m, N", LINK, "bias of the twist rows")
    h_phi = b.input("h_phi", (r, 1), r"\mathbf{h}_{\phi,i}", "N", "-", "bias of the modal rows", numbered=(0,))
    h_T = b.input("h_T", (6, 1), r"\mathbf{h}_T", "N*m, N", "tip frame", "bias of the bodies at the tip")
    b_T = b.input("b_T", (6, 1), r"\mathbf{b}_T", "rad/s^2, m/s^2", "tip frame", "acceleration bias of the tip section")
    w_ext = b.input(
        "w_ext",
        (6, 1),
        r"\boldsymbol{\mathcal{W}}_{ext,i}",
        "N*m, N",
        "tip frame",
        "external wrench on the tip section",
    )
    X = b.input("X", (6, 6), r"\mathbf{X}_{i+1}", "-, m", "F_{i+1}", "twist of the next joint point from the tip's")
    PX = b.input("PX", (6, 6), r"\mathbf{M}_{T,i+1}", MIXED, "F_{i+1}", "columns of this tip in the next joint's rows")
    J_V, J_eta = _tip_jacobian(b, key)
    b.step(
        "V_V",
        M_V + J_V.T @ M_T @ J_V,
        r"\mathbf{M}_{VV,i}",
        unit="kg, kg*m, kg*m^2",
        equation="100",
        symmetric=True,
        meaning="twist rows, twist columns",
    )
    V_eta = b.step(
        "V_eta",
        M_D + J_V.T @ M_T @ J_eta,
        r"\mathbf{M}_{V\eta,i}",
        unit="kg, kg*m",
        equation="100",
        meaning="twist rows, modal columns",
        numbered=(1,),
    )
    b.step(
        "eta_V",
        V_eta.T,
        r"\mathbf{M}_{\eta V,i}",
        unit="kg, kg*m",
        equation="100",
        numbered=(0,),
        meaning="modal rows, twist columns",
    )
    b.step(
        "eta_eta",
        m_eta + J_eta.T @ M_T @ J_eta if r else zeros(0, 0),
        r"\mathbf{M}_{\eta\eta,i}",
        unit="kg",
        equation="100",
        symmetric=True,
        meaning="modal rows, modal columns",
        numbered=(0, 1),
    )
    b.step(
        "V_next",
        J_V.T @ X.T,
        r"\mathbf{M}_{V\mathcal{W},i}",
        unit="-, m",
        equation="100",
        meaning="twist rows, columns of the next joint's wrench",
    )
    b.step(
        "eta_next",
        J_eta.T @ X.T,
        r"\mathbf{M}_{\eta\mathcal{W},i}",
        unit="-, 1/m",
        equation="100",
        numbered=(0,),
        meaning="modal rows, columns of the next joint's wrench",
    )
    b.step(
        "next_V",
        -(PX @ J_V),
        r"\mathbf{M}_{V,i+1}^{-}",
        unit=MIXED,
        equation="100",
        meaning="next joint's rows, twist columns",
    )
    b.step(
        "next_eta",
        -(PX @ J_eta),
        r"\mathbf{M}_{\eta,i+1}^{-}",
        unit=MIXED,
        equation="100",
        numbered=(1,),
        meaning="next joint's rows, modal columns",
    )
    b.step(
        "V_w",
        -lever(joint_point(b, key)).T,
        r"-\mathbf{J}_B^{\top}",
        unit="-, m",
        equation="50",
        meaning="twist rows, columns of the joint's wrench",
    )
    carried = b.step(
        "h_carried",
        M_T @ b_T + h_T,
        r"\mathbf{h}_{Tb}",
        unit="N*m, N",
        frame="tip frame",
        meaning="bias of the bodies at the tip, its acceleration bias included",
    )
    b.step(
        "V_H",
        h_V + J_V.T @ carried,
        r"\mathbf{H}_{V,i}",
        unit="N*m, N",
        equation="100",
        meaning="bias of the twist rows",
    )
    b.step(
        "eta_H",
        h_phi + J_eta.T @ carried,
        r"\mathbf{H}_{\eta,i}",
        unit="N",
        equation="100",
        meaning="bias of the modal rows",
        numbered=(0,),
    )
    b.step(
        "V_W",
        J_V.T @ w_ext,
        r"\boldsymbol{\mathcal{W}}_{V,i}",
        unit="N*m, N",
        equation="100",
        meaning="external wrench in the twist rows",
    )
    b.step(
        "eta_W",
        J_eta.T @ w_ext,
        r"\boldsymbol{\mathcal{W}}_{\eta,i}",
        unit="N",
        equation="100",
        meaning="external wrench in the modal rows",
        numbered=(0,),
    )
    return b


def _modal_inertia(b: Block, key: LinkClass) -> Expression:
    """The (r, r) inertia of the modes; a diagonal one is given by its column."""
    r = key.modes
    if key.coupled:
        return b.input("m_eta", (r, r), r"\mathbf{M}_{W\phi,i}", "kg", "-", "inertia of the modes", numbered=(0, 1))
    return Diagonal(b.input("m_eta", (r, 1), r"\mathbf{m}_{\eta}", "kg", "-", "inertia of each mode", numbered=(0,)))


def _tip_jacobian(b: Block, key: LinkClass) -> tuple[Symbol, Symbol]:
    """``J_T``: the tip's twist from the link's twist and its modal rates."""
    R_T = b.input("R_T", (3, 3), r"\mathbf{R}_T", "-", LINK, "rotation of the tip section")
    r_T = b.input("r_T", (3, 1), r"\mathbf{r}_T", "m", LINK, "tip point")
    J_l = b.input("J_l", (3, 3), r"\mathbf{J}_l", "-", LINK, "left Jacobian of the exponential")
    Psi = b.input(
        "Psi_c", (3, key.modes), r"\boldsymbol{\Psi}_c", "1/m", LINK, "turn of the tip by each mode", numbered=(1,)
    )
    Phi = b.input(
        "Phi_c",
        (3, key.modes),
        r"\boldsymbol{\phi}_c",
        "-",
        LINK,
        "displacement of the tip by each mode",
        numbered=(1,),
    )
    turn = twice(R_T.T)
    J_V = b.step(
        "J_TV",
        turn @ lever(r_T),
        r"\mathbf{J}_{TV}",
        unit="-, m",
        frame="tip frame",
        equation="46",
        meaning="twist of the tip section from that of F_i",
    )
    J_eta = b.step(
        "J_Teta",
        turn @ stack(J_l @ Psi, Phi),
        r"\mathbf{J}_{T\eta}",
        unit="1/m, -",
        frame="tip frame",
        equation="46",
        meaning="twist of the tip section from the modal rates",
        numbered=(1,),
    )
    return J_V, J_eta
