"""Section 4: the rows of a joint and its link, and those of the whole arm, (58)-(71).

The arm is written out for two links; the pattern goes on with every further link.
"""

from __future__ import annotations

from ..algebra.expression import Expression, Inverse, Transpose, block, identity, stack, zeros
from .equation import Equality
from .quantities import LinkLetters
from .synthesis import BEFORE, NONE, L, equation, joint_bias

ONE, TWO, ARM, GROUND = LinkLetters("1"), LinkLetters("2"), LinkLetters("all"), LinkLetters("0")
O66, I6 = zeros(6, 6), identity(6)
TWO_LINKS = "Written for two links; every further link adds its joint's row and its own in the same pattern."


def down(link: LinkLetters, before: LinkLetters) -> Expression:
    """``Ad_io^-T Ad_o(i-1)^-T``."""
    return Inverse(Transpose(link.Ad_back)) @ Inverse(Transpose(before.Ad))


def elastic(link: LinkLetters, before: LinkLetters | None = None) -> Expression:
    """What the rates of the deformations put into a joint's rows."""
    own = -(link.P @ link.Ad @ link.Vdot_xi_a)
    return link.P @ before.Ad @ before.Vdot_xi_c + own if before else own


JOINT_AND_LINK = (
    equation(
        "58",
        "rows of a joint and its link",
        Equality(L.M_c @ stack(BEFORE.W, BEFORE.Vdot, L.W, L.Vdot) + L.D_c + L.H_c, L.W_c),
        note="The four parts are judged as what the rows measure on the motion, not as (59) prints them.",
    ),
    equation(
        "59",
        "columns of the unknowns",
        Equality(
            L.M_c,
            block([O66, L.P @ BEFORE.Ad, O66, -(L.P @ L.Ad)], [down(L, BEFORE), L.M_star, -I6, O66]),
        ),
        derived=(
            Equality(
                L.M_c,
                block(
                    [O66, L.P @ BEFORE.Ad_R @ BEFORE.J_b_c, O66, -(L.P @ L.Ad_R @ L.J_b_a)],
                    [down(L, BEFORE), O66, -I6, L.M_star],
                ),
            ),
        ),
        errata=("E12", "E15", "E23"),
        block="joint_rows.joint_V, joint_rows.PX, link_rows.V_V, link_rows.V_w, link_rows.V_next",
        note="The link's inertia multiplies its own acceleration, the last of the unknowns in (58).",
    ),
    equation(
        "60",
        "deformation in these rows",
        Equality(L.D_c, stack(elastic(L, BEFORE), L.D_star)),
        block="link_rows.V_eta, link_rows.next_eta",
        note="Holds with the Adjoint, which only turns a screw without rotation part.",
    ),
    equation(
        "61",
        "bias of these rows",
        Equality(L.H_c, stack(L.H_p, L.H_star)),
        where={"H_p:i": joint_bias(L, BEFORE)},
        errata=("E32",),
        block="joint_rows.joint_H, link_rows.V_H",
        note=r"(accconst4) has $\mathbf{P}_i\mathbf{H}_{pi}$. With (accconst5), printed or derived, that is "
        r"$\mathbf{H}_{pi}$ itself; with sections that turn it is not.",
    ),
    equation(
        "62",
        "external wrench in these rows",
        Equality(L.W_c, stack(NONE, L.W_star)),
        block="joint_rows.joint_W, link_rows.V_W",
        note="The paper's external wrenches include the motors'. The derived block has torques in the joint's rows.",
    ),
)

FIRST_LINK = (
    equation(
        "63",
        "compatibility of the first joint",
        Equality(ONE.P @ (-(ONE.Ad @ ONE.Vdot) - ONE.Ad @ ONE.Vdot_xi_a + ONE.H_p), NONE),
        derived=(
            Equality(
                ONE.P @ (-(ONE.Ad_R @ ONE.J_b_a @ ONE.Vdot) - ONE.Ad @ ONE.Vdot_xi_a + ONE.H_p),
                NONE,
            ),
        ),
        errata=("E12", "E23"),
        block="joint_rows.joint_V",
    ),
    equation(
        "65",
        "balance of the first link",
        Equality(ONE.M_star @ ONE.Vdot + ONE.D_star + ONE.H_star - ONE.W + GROUND.W, ONE.W_star),
        derived=(
            Equality(
                ONE.M_star @ ONE.Vdot + ONE.D_star + ONE.H_star - ONE.W + Inverse(Transpose(ONE.Ad_back)) @ GROUND.W,
                ONE.W_star,
            ),
        ),
        errata=("E31",),
        block="link_rows.V_w",
        note=r"(50) at $i = 1$ with $\mathbf{Ad}_{00} = \mathbf{I}$ keeps its first factor: "
        r"$\boldsymbol{\mathcal{W}}_0$ is about the inertial origin, in inertial components.",
    ),
)


PRINTED_M_S = block(
    [O66, ONE.P @ ONE.Ad, O66, O66],
    [I6, ONE.M_star, -I6, O66],
    [O66, -(TWO.P @ ONE.Ad), O66, TWO.P @ TWO.Ad],
    [O66, down(TWO, ONE), TWO.M_star, -I6],
)
M_S = block(
    [O66, -(ONE.P @ ONE.Ad_R @ ONE.J_b_a), O66, O66],
    [Inverse(Transpose(ONE.Ad_back)), ONE.M_star, -I6, O66],
    [O66, TWO.P @ ONE.Ad_R @ ONE.J_b_c, O66, -(TWO.P @ TWO.Ad_R @ TWO.J_b_a)],
    [O66, O66, down(TWO, ONE), TWO.M_star],
)

WHOLE_ARM = (
    equation(
        "66",
        "rows of the whole arm",
        Equality(ARM.M_s @ ARM.Psi + ARM.D_s + ARM.h_s, ARM.W_s),
        note="The four parts are judged as what the rows measure on the motion, not as (68) prints them.",
    ),
    equation(
        "67",
        "unknowns of the arm",
        Equality(ARM.Psi, stack(GROUND.W, ONE.Vdot, ONE.W, TWO.Vdot)),
        note=TWO_LINKS,
    ),
    equation(
        "68",
        "columns of the unknowns of the arm",
        Equality(ARM.M_s, PRINTED_M_S),
        derived=(Equality(ARM.M_s, M_S),),
        errata=("E12", "E15", "E17", "E23", "E31"),
        block="joint_rows.joint_V, joint_rows.PX, link_rows.V_V, link_rows.V_w, link_rows.V_next",
        note="The four rows and columns that the paper writes out. Its fourth row stands one column to the left: "
        r"the negative identity belongs in the column of $\boldsymbol{\mathcal{W}}_2$, which a third link brings. Rows "
        "one and three have the opposite signs of (63), (59) and (69).",
    ),
    equation(
        "69",
        "deformation in the rows of the arm",
        Equality(ARM.D_s, stack(elastic(ONE), ONE.D_star, elastic(TWO, ONE), TWO.D_star)),
        block="link_rows.V_eta, link_rows.next_eta",
        note=TWO_LINKS,
    ),
    equation(
        "70",
        "bias of the rows of the arm",
        Equality(ARM.h_s, stack(ONE.H_p, ONE.H_star, TWO.H_p, TWO.H_star)),
        where={"H_p:1": joint_bias(ONE), "H_p:2": joint_bias(TWO, ONE)},
        errata=("E32",),
        block="joint_rows.joint_H, link_rows.V_H",
        note=f"As (61). {TWO_LINKS}",
    ),
    equation(
        "71",
        "external wrenches of the arm",
        Equality(ARM.W_s, stack(NONE, ONE.W_star, NONE, TWO.W_star)),
        block="joint_rows.joint_W, link_rows.V_W",
        note=TWO_LINKS,
    ),
)

EQUATIONS = (*JOINT_AND_LINK, *FIRST_LINK, *WHOLE_ARM)
