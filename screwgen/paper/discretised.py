"""Sections 5 and 6: the discretised system of two links, and the symmetry on which its regularity rests."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..algebra.expression import Expression, Symbol, Transpose, block, hat, identity, inverse, stack, zeros
from .appendix_b import DERIVED_H_MD, DERIVED_M_D, DERIVED_M_DPSI, ONE, PARTS, TWO
from .equation import Equality, Equation, Formula
from .projection import TO_BASE, L, shown
from .quantities import LinkLetters
from .random_motion import RandomMotion

A = LinkLetters("all")
O3, O6, O66, O33 = zeros(3), zeros(6), zeros(6, 6), zeros(3, 3)
I24 = identity(24)
TWO_LINKS = "Written and judged for two links."


def equation(label: str, title: str, *printed: Equality | Formula, section: str = "5", **rest: Any) -> Equation:
    return Equation(label=label, section=section, title=title, printed=printed, **rest)


def diagonal(first: Expression, second: Expression) -> Expression:
    """``diag(first, second)``."""
    return block(
        [first, zeros(first.shape[0], second.shape[1])],
        [zeros(second.shape[0], first.shape[1]), second],
    )


# --------------------------------------------------------------------------------- stacked modal rows

STACKED = A.M_Dphi_s @ A.Psi_Z_s + A.M_Wphi_s @ A.eta_s + A.h_phi_s
INERTIA = Equality(A.M_Wphi_s, diagonal(ONE.M_Wphi, TWO.M_Wphi))
BIAS = Equality(A.h_phi_s, stack(ONE.h_phi, TWO.h_phi))
NEXT = -(ONE.J_c.T @ block([identity(6), O66]))
"""Columns of Psi_Z2 in the modal rows of link 1: the wrench W_1 at its tip."""

MODAL = (
    equation(
        "89",
        "modal rows of all links",
        Equality(STACKED, zeros(12)),
        Equality(A.M_Dphi_s, diagonal(ONE.M_Dphi, TWO.M_Dphi)),
        INERTIA,
        BIAS,
        derived=(
            Equality(STACKED, A.f_phi_s),
            Equality(A.M_Dphi_s, block([ONE.M_Dphi, NEXT], [zeros(6, 12), TWO.M_Dphi])),
            INERTIA,
            BIAS,
        ),
        errata=("E16",),
        block="link_rows.eta_V, link_rows.eta_next, link_rows.eta_eta, link_rows.eta_H, link_rows.eta_W",
        note=f"{TWO_LINKS} The wrench at the tip of a link belongs to the unknowns of the next one: "
        r"$\mathbf{M}_{D\phi}$ is not block-diagonal.",
    ),
)

# ----------------------------------------------------------------------------------- from V to Z

ALL_LEVERS = block(
    [O66, O66, O66, O66],
    [O66, ONE.T_gamma, O66, O66],
    [O66, O66, O66, O66],
    [O66, O66, O66, TWO.T_gamma],
)
LEVER = block([O33, O33], [-hat(L.r), O33])
MODES_IN = {"M_D:all": DERIVED_M_D, "M_DPsi:all": DERIVED_M_DPSI, "h_MD:all": DERIVED_H_MD} | PARTS

CHANGE = (
    equation(
        "gamma",
        "twist from its coordinates",
        Equality(L.V, L.Z + L.gamma),
        Equality(L.gamma, stack(O3, hat(L.omega) @ L.r)),
        block="z_form.gamma, z_form.V",
    ),
    equation(
        "95",
        "inertia of the deformation in the modes",
        Equality(A.D_s, A.M_D @ A.eta_s + A.M_DPsi @ A.Psi_Z_s + A.h_MD),
        where=MODES_IN,
        errata=("E8", "E9", "E24", "E28"),
        block="link.M_D, link.M_DPsi, link.h_MD",
        note=f"{TWO_LINKS} It holds with (B1) to (B3) as derived, and they are put in; with them as printed it does "
        f"not.",
    ),
    equation(
        "MsPsi",
        "from rates of twists to rates of Z",
        Equality(A.M_s @ A.Psi, A.M_s @ ((I24 + A.T_gamma_s) @ A.Psi_Z_s) + A.h_Ms),
        Equality(A.T_gamma_s, ALL_LEVERS),
        Equality(L.T_gamma, LEVER),
        block="z_form.T_gamma, z_form.Vdot, z_rows.Z_Z",
        note=TWO_LINKS,
    ),
    equation(
        "HMs",
        "bias of the change to Z",
        Equality(A.h_Ms, A.M_s @ A.Gamma_star),
        Equality(A.Gamma_star, stack(O6, ONE.gamma_star, O6, TWO.gamma_star)),
        Equality(L.gamma_star, stack(O3, hat(L.omega) @ L.rdot)),
        block="z_form.gamma_star, z_rows.V_h_Ms, z_rows.joint_h_Ms",
        note=f"{TWO_LINKS} The bias is measured as the rows of undeformed links at a motion without a rate of Z.",
    ),
)

# ------------------------------------------------------------------------------------ the system

BALANCE = Equality(A.M_dyn @ A.Psi_Z_s + A.M_D @ A.eta_s + A.h_dyn, A.W_s)
COLUMNS = Equality(A.M_dyn, A.M_s @ (I24 + A.T_gamma_s) + A.M_DPsi)
UNKNOWNS = Equality(A.q_sys, stack(A.Psi_Z_s, A.eta_s))
MATRIX = Equality(A.M_sys, block([A.M_dyn, A.M_D], [A.M_Dphi_s, A.M_Wphi_s]))
BIASES = Equality(A.H_sys, stack(A.h_dyn, A.h_phi_s))

SYSTEM = (
    equation(
        "97",
        "discretised rows of joints and links",
        BALANCE,
        COLUMNS,
        Equality(A.h_dyn, A.h_Ms + A.h_MD),
        derived=(BALANCE, COLUMNS, Equality(A.h_dyn, A.h_Ms + A.h_MD + A.h_s)),
        errata=("E25",),
        block="z_rows.V_H_Z, z_rows.joint_H_Z",
        note=f"{TWO_LINKS} Each matrix is measured on the judge's arm, unknown by unknown.",
    ),
    equation(
        "98",
        "discretised system",
        Equality(A.M_sys @ A.q_sys + A.H_sys, A.W_sys),
        block="link_rows.V_V, link_rows.V_eta, link_rows.eta_eta, joint_rows.joint_V",
        note=f"{TWO_LINKS} Its matrices are measured on the judge's arm; what (100) puts in them is judged there.",
    ),
    equation(
        "100",
        "matrices of the discretised system",
        UNKNOWNS,
        MATRIX,
        BIASES,
        Equality(A.W_sys, stack(A.W_s, zeros(12))),
        derived=(UNKNOWNS, MATRIX, BIASES, Equality(A.W_sys, stack(A.W_s, A.f_phi_s))),
        errata=("E16",),
        block="link_rows.V_V, link_rows.eta_next, link_rows.eta_W",
        note=f"{TWO_LINKS} External wrenches at the ends of a link do work on its modes; the last rows hold them, and "
        "the distributed load that an arbitrary motion needs.",
    ),
    equation(
        "jacobian",
        "rates of the coordinates",
        Equality(L.qdot, L.J_q_link @ stack(L.omega, L.rdot)),
        Equality(L.J_q_link, block([L.J_theta, O33], [O33, identity(3)])),
        derived=(
            Equality(L.qdot, L.J_q_link @ stack(L.omega, L.rdot)),
            Equality(L.J_q_link, block([inverse(L.J_theta), O33], [O33, identity(3)])),
        ),
        errata=("E18",),
        block="z_form.J_inverse, z_form.thetadot",
        note="J is the Jacobian of Section 2, from the rate of theta to the angular velocity. The judge differentiates "
        "the logarithm of the rotation.",
    ),
)

# -------------------------------------------------------------------------------------- symmetry


over = lambda integrand: L.integral(integrand, L.rhoA)  # noqa: E731
RATE = shown("Zdot", r"\boldsymbol{\Psi}_Z^{(diff)}")
SPEED = shown("etadot", r"\dot{\underline{\boldsymbol{\eta}}}")
M_D, M_DPHI = shown("M_D_link", r"\boldsymbol{M}_D"), shown("M_Dphi_diff", r"\mathbf{M}_{D\phi}")
M_WPHI = shown("M_Wphi", r"\mathbf{M}_{W\phi}")
M_DYN = shown("M_dyn_diff", r"\mathbf{M}_{dyn}^{(diff)}")
TO_V = identity(6) + L.T_gamma
VELOCITY = TO_V @ L.Z
LINK_BY_LINK = "Judged link by link; the arm's is the sum."


def coupling(left: Expression, right: Symbol) -> Equality:
    """The two cross terms of the kinetic energy and their sum."""
    second = SPEED.T @ (M_DPHI @ right)
    return Equality(left.T @ (M_D @ SPEED) + second, 2 * second)


def energy(left: Expression, right: Symbol) -> Equality:
    """The kinetic energy as a quadratic form."""
    cross = 2 * (SPEED.T @ (M_DPHI @ right))
    return Equality(2 * L.T, left.T @ (M_DYN @ right) + cross + SPEED.T @ (M_WPHI @ SPEED))


def asymmetry(seed: int) -> tuple[float, float]:
    """How far the differential-modal block of a link is from a symmetric matrix without negative eigenvalues."""
    v = RandomMotion(seed).values
    M = np.block([[v["M_dyn_diff:i"], v["M_D_link:i"]], [v["M_Dphi_diff:i"], v["M_Wphi:i"]]])
    rows = np.eye(12)
    rows[:6, :6] += v["T_gamma:i"].T
    return indefinite(M), indefinite(rows @ M)


def indefinite(M: np.ndarray) -> float:
    """The asymmetry of a matrix, or its negative eigenvalue, relative to its largest entry."""
    lowest = np.linalg.eigvalsh((M + M.T) / 2)[0]
    return float(max(np.abs(M - M.T).max(), -lowest, 0.0) / np.abs(M).max())


SYMMETRY = (
    equation(
        "103",
        "modal rows and columns",
        Equality(L.M_Dphi, block([O66, L.M_D_link.T])),
        Equality(L.integral(-(L.phi.T @ hat(L.r_ib))), Transpose(L.integral(L.phi))),
        Equality(L.integral(L.phi.T), Transpose(L.integral(hat(L.r_xi) @ L.phi))),
        derived=(
            Equality(L.M_Dphi, block([L.J_a.T @ TO_BASE, L.M_D_link.T @ TO_V])),
            Equality(over(-(L.phi.T @ hat(L.r_ib))), Transpose(over(hat(L.r_ib) @ L.phi))),
            Equality(over(L.phi.T), Transpose(over(L.phi))),
        ),
        section="6",
        errata=("E8", "E9", "E16", "E24", "E26"),
        block="link.M_Dphi, link.M_D",
        note="The first line has the measured matrices; the other two pair the columns 4k+3 and 4k+4 of (85) with the "
        "rows of (B1), where k runs from 0. In the rates of the twists one is the transpose of the other, in those of "
        "Z only with its rows taken to Z too. The wrench below has columns as well.",
    ),
    equation(
        "cross",
        "cross terms of the kinetic energy",
        coupling(RATE, RATE),
        derived=(coupling(VELOCITY, L.Z),),
        section="6",
        errata=("E26",),
        block="energy.kinetic",
        note=LINK_BY_LINK,
    ),
    equation(
        "2T",
        "kinetic energy",
        energy(RATE, RATE),
        derived=(energy(VELOCITY, L.Z),),
        section="6",
        errata=("E26", "E29"),
        block="energy.kinetic",
        note=f"{LINK_BY_LINK} It is a form in velocities, not in accelerations.",
    ),
    equation(
        "Msys_diff",
        "definiteness of the differential-modal block",
        Formula(
            r"$\mathbf{M}_{sys}^{(diff)} = [\mathbf{M}_{dyn}^{(diff)}, \boldsymbol{M}_D^{(diff)}; \mathbf{M}_{D\phi}, "
            r"\mathbf{M}_{W\phi}] \succ 0$"
        ),
        derived=(
            Formula(
                r"$\mathrm{diag}((\mathbf{I}+\mathbf{T}_\gamma)^{\top}, \mathbf{I})\,\mathbf{M}_{sys}^{(diff)}$ is "
                r"symmetric and positive semidefinite; definite where every link has inertia about its own axis"
            ),
        ),
        section="6",
        errata=("E26", "E29"),
        gap=(
            Formula(
                r"$\mathbf{M} - \mathbf{M}^{\top} = [\mathbf{M}_V\mathbf{T}_\gamma - "
                r"\mathbf{T}_\gamma^{\top}\mathbf{M}_V, -\mathbf{T}_\gamma^{\top}\boldsymbol{M}_D; "
                r"\boldsymbol{M}_D^{\top}\mathbf{T}_\gamma, \mathbf{0}]$, with $\mathbf{M}_V$ the inertia of the "
                "deformed link: zero in the derived form"
            ),
        ),
        judge=asymmetry,
        block="link.M_V, link.M_D, link.M_Dphi, link.M_Wphi",
        note="Judged by the asymmetry of the block, and by its eigenvalues.",
    ),
)

EQUATIONS = (*MODAL, *CHANGE, *SYSTEM, *SYMMETRY)
