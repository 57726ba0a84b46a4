"""Section 3: one flexible link, its dynamic equation and its deformation."""

from __future__ import annotations

from typing import Any

from ..algebra.expression import Symbol, block, hat, identity, inverse, stack
from .equation import Equality, Equation
from .link_ends import ENDS, SECTIONS
from .quantities import LinkLetters

L = LinkLetters("i")
FREE_FALL = {"g:i": -L.g}
"""The paper's g, the opposite of free fall, in the judge's letters."""
PARTS = {"r_ib:i": L.r_b + L.r_xi, "v_ob:i": L.v + L.v_ib}
UNLOADED = Symbol("load:i", (3, 1), r"\mathbf{0}")
"""The zero of (34); the judge's motions are arbitrary, and it stands for the load that they need."""
D_STAR = Symbol("D_star:i", (6, 1), r"\mathbf{D}^*_i(\dot{\mathbf{V}}_{\xi_i})")

turning, gravity, rho_A = hat(L.omega), L.R.T @ L.g, L.rhoA
over = lambda integrand: L.integral(integrand, rho_A)  # noqa: E731
to_tip, to_base = hat(L.r_b_c) + hat(L.r_xi_c), hat(L.r_b_a) + hat(L.r_xi_a)


def equation(label: str, title: str, *printed: Equality, **rest: Any) -> Equation:
    return Equation(label=label, section="3", title=title, printed=printed, isolated=True, **rest)


M_STAR = block([L.I_b, over(hat(L.r_b))], [-over(hat(L.r_b)), L.m @ identity(3)])

PRINTED_D = stack(over(hat(L.r_b) @ L.vdot_xi), over(L.vdot_xi))
DERIVED_D = stack(
    over(hat(L.r_ib) @ L.vdot_xi) + over(hat(L.r_xi) @ (L.vdot - hat(L.r_b) @ L.omegadot)),
    over(L.vdot_xi),
)

PRINTED_H_STAR = stack(
    over(hat(L.r_b) @ (turning @ L.v_ib))
    + over(hat(L.v_ib) @ L.v_ob)
    + L.m @ (hat(L.r) @ gravity)
    + over(hat(L.r_b) @ gravity)
    + over(hat(L.r_xi) @ gravity)
    + L.integral(hat(L.r_xi1) @ (L.I_v1 @ L.r_xi1))
    + L.integral(hat(L.r_xi2) @ (L.I_v2 @ L.r_xi2)),
    over(turning @ L.v_ib) + L.m @ gravity,
)
DERIVED_H_STAR = stack(
    over(hat(L.r_ib) @ (turning @ L.v_ob)) - over(hat(L.r_ib) @ gravity),
    over(turning @ L.v_ib) + L.m @ (turning @ L.v) - L.m @ gravity,
)

STRESS = inverse(rho_A) @ (L.I_v2 @ L.r_xi4) - inverse(rho_A) @ (L.I_v1 @ L.r_xi2)

WRENCHES = (
    equation(
        "26",
        "dynamic equation of the link",
        Equality(L.M_star @ L.Vdot + D_STAR + L.H_star, L.W_star),
        where={"M_star:i": M_STAR, "D_star:i": DERIVED_D, "H_star:i": DERIVED_H_STAR} | PARTS,
        errata=("E34", "E35"),
        block="link.M_star, link.M_DPsi, link.M_D, link.H_star",
        note="Judged with the derived (28) and (29) put in, against the wrench that the balance of momentum asks for; "
        "what its printed parts miss is said at (28), (29) and (30).",
    ),
    equation(
        "27",
        "inertia of the undeformed link",
        Equality(L.M_star, M_STAR),
        errata=("E29", "E34"),
        block="link.M_star",
        note="Holds for the beam alone; of rank 5, where the text has it positive definite.",
    ),
    equation(
        "28",
        "inertia of the deformation",
        Equality(D_STAR, PRINTED_D),
        derived=(Equality(D_STAR, DERIVED_D),),
        where=PARTS,
        errata=("E8",),
        block="link.M_DPsi, link.M_D",
        note="The displacement is part of the lever, and it is carried along by the acceleration of the frame: "
        r"$\mathbf{D}^*_i$ depends on $\dot{\mathbf{V}}_i$ too.",
    ),
    equation(
        "29",
        "gyroscopic wrench and weight",
        Equality(L.H_star, PRINTED_H_STAR),
        derived=(Equality(L.H_star, DERIVED_H_STAR),),
        reading=FREE_FALL,
        where=PARTS,
        errata=("E3", "E5", "E6", "E7", "E8", "E22"),
        block="link.H_star, link.h_c",
        note="Moment and force of the accelerations that the rates cause, about the origin of the link's frame.",
    ),
    equation(
        "30",
        "external wrench",
        Equality(
            L.W_star,
            stack(L.tau_B - L.tau_T - hat(L.r_xi_a) @ L.F_B + hat(L.r_xi_c) @ L.F_T, L.F_B - L.F_T),
        ),
        derived=(Equality(L.W_star, stack(L.tau_B - L.tau_T + to_base @ L.F_B - to_tip @ L.F_T, L.F_B - L.F_T)),),
        errata=("E10",),
        note="The lever of an end force is the place of the end, and its sign that of the force in the second row.",
    ),
    equation("vib", "velocity of an element against the frame's origin", Equality(L.v_ib, L.v_xi + L.v_b)),
    equation("mass", "mass of the beam", Equality(L.m, rho_A @ L.l), block="link.mu"),
    equation(
        "Iibi",
        "moment of inertia of the undeformed beam",
        Equality(L.I_b, -over(hat(L.r_b) @ hat(L.r_b))),
        errata=("E29",),
        block="link.I_0",
        note="Holds; but a straight centreline has no inertia about itself.",
    ),
)

DEFORMATION = equation(
    "34",
    "deformation of the link",
    Equality(L.vdot + L.vdot_xi - hat(L.r_ib) @ L.omegadot + turning @ L.v_ib + gravity + STRESS, UNLOADED),
    derived=(
        Equality(
            L.vdot + L.vdot_xi - hat(L.r_b) @ L.omegadot + turning @ L.v_ib + turning @ L.v - gravity + STRESS,
            UNLOADED,
        ),
    ),
    reading=FREE_FALL,
    where=PARTS,
    errata=("E2", "E3", "E22"),
    block="link.h_eta, link.f_eta",
    note="The judge's motions are arbitrary: the distributed load that they need stands on the right, where the paper, "
    "which has no such load, prints 0.",
)

EQUATIONS = (*WRENCHES, *SECTIONS, DEFORMATION, *ENDS)
