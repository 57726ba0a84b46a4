"""Section 4: the joints' compatibility and the links' balance, (45)-(accconst5)."""

from __future__ import annotations

from typing import Any

from ..algebra.expression import Expression, Inverse, Transpose, block, hat, identity, stack, zeros
from .equation import Equality, Equation
from .quantities import LinkLetters

L, BEFORE = LinkLetters("i"), LinkLetters("i-1")
O3, O33, I3 = zeros(3), zeros(3, 3), identity(3)
NONE = zeros(6)


def equation(label: str, title: str, *printed: Equality, **rest: Any) -> Equation:
    return Equation(label=label, section="4", title=title, printed=printed, **rest)


def wrench_before() -> Expression:
    """``Ad_io^-T Ad_o(i-1)^-T W_{i-1}``."""
    return Inverse(Transpose(L.Ad_back)) @ (Inverse(Transpose(BEFORE.Ad)) @ BEFORE.W)


def section_rate(link: LinkLetters, end: str) -> Expression:
    """The inertial derivative of the twist of an end section, ``a`` or ``c``, every term."""
    part = lambda name: getattr(link, f"{name}_{end}")  # noqa: E731
    return printed_rate(link, end) + part("Vdot_b") + link.ad @ part("V_b") + stack(O3, hat(link.omega) @ link.v)


def printed_rate(link: LinkLetters, end: str) -> Expression:
    V_xi, Vdot_xi = getattr(link, f"V_xi_{end}"), getattr(link, f"Vdot_xi_{end}")
    return link.Vdot + Vdot_xi + link.ad @ V_xi


def section_bias(link: LinkLetters, end: str) -> Expression:
    """What is left of the derivative without the rates of V and V_xi."""
    bent, straight = getattr(link, f"V_xi_{end}"), getattr(link, f"V_b_{end}")
    return link.ad @ bent + link.ad @ straight + stack(O3, hat(link.omega) @ link.v)


def gap(link: LinkLetters, before: LinkLetters | None, tip: str = "V_T", base: str = "V_B") -> Expression:
    """What the tip of the link before turns and moves faster than a link's base, inertial components; or its rate."""
    own = -(link.Ad_R @ getattr(link, base))
    return before.Ad_R @ getattr(before, tip) + own if before else own


def joint_bias(link: LinkLetters, before: LinkLetters | None = None) -> Expression:
    """(accconst5) as derived; without a link before, the base is at rest."""
    own = -(link.Ad @ section_bias(link, "a")) + link.Pdot @ gap(link, before)
    return before.Ad @ section_bias(before, "c") + own if before else own


GAP, GAP_RATE = gap(L, BEFORE), gap(L, BEFORE, "dV_T", "dV_B")

BALANCE = L.M_star @ L.Vdot + L.D_star + L.H_star
AXES = block([L.R_two.T @ L.a_one, L.a_two])

COMPATIBILITY = (
    equation(
        "46",
        "twist of a link's tip",
        Equality(BEFORE.V_T, BEFORE.V + BEFORE.V_xi_c + BEFORE.V_b_c),
        block="tip.omega_T, tip.v_T",
        note="The angular velocity and the velocity of the tip point. In the paper sections do not turn; the derived "
        "block adds the turning of the section.",
    ),
    equation(
        "47",
        "twist of a link's base",
        Equality(L.V_B, L.V + L.V_xi_a + L.V_b_a),
        block="joint_rows.J_B",
        note="The derived block has no displacement of the base, because its shapes vanish there.",
    ),
    equation(
        "45",
        "compatibility of the joint",
        Equality(L.P @ (BEFORE.Ad @ BEFORE.V_T - L.Ad @ L.V_B), NONE),
        derived=(Equality(L.P @ GAP, NONE),),
        errata=("E12",),
        block="joint.omega, joint.v",
        note=r"$\mathbf{Ad}^{R} = \mathrm{blkdiag}(\mathbf{R}, \mathbf{R})$. "
        "Both twists hold the velocity of the joint's point, which only has to be turned into inertial "
        "components. The Adjoint adds the position of the frame times the angular velocity, which differs on the two "
        "sides.",
    ),
    equation(
        "43",
        "projector on what the joint blocks",
        Equality(L.P, block([I3 - L.A @ L.A.T, O33], [O33, I3])),
        derived=(Equality(L.P, block([I3 - L.A @ L.A_plus, O33], [O33, I3])),),
        errata=("E13", "E14", "E17"),
        block="joint_rows.P, joint_rows.N",
        note=r"For perpendicular axes $\mathbf{A}^{+} = \mathbf{A}^{\top}$; the judge's are not.",
    ),
    equation(
        "oA",
        "axes of the joint",
        Equality(L.A, L.R @ L.A_body),
        Equality(L.A_body, L.A_zero),
        derived=(Equality(L.A, L.R @ L.A_body), Equality(L.A_body, AXES)),
        where={"A_zero:i": block([L.a_one, L.a_two])},
        errata=("E13",),
        block="joint.A",
        note="Without a number in the paper; the second line is its text, the axes are time-invariant in the link's "
        "frame. That holds for the last axis of a joint alone: rotations about those after it turn every other.",
    ),
)

LINKS = (
    equation(
        "48",
        "balance of a link between its neighbours",
        Equality(BALANCE, L.W_star + L.W - L.W_below),
        block="link_rows.V_V, link_rows.V_H, link_rows.V_w, link_rows.V_next",
    ),
    equation(
        "49",
        "wrench of the link before, moved to the link's frame",
        Equality(L.W_below, wrench_before()),
        block="joint_rows.X, link_rows.V_next",
    ),
    equation(
        "50",
        "balance of a link in the unknowns",
        Equality(BALANCE - L.W + wrench_before(), L.W_star),
        block="link_rows.V_V, link_rows.V_H, link_rows.V_w, link_rows.V_next",
    ),
)

ACCELERATIONS = (
    equation(
        "accconst1",
        "compatibility, differentiated",
        Equality(L.P @ (BEFORE.Ad @ BEFORE.dV_T - L.Ad @ L.dV_B), NONE),
        derived=(Equality(L.P @ GAP_RATE + L.Pdot @ GAP, NONE),),
        errata=("E12", "E27"),
        block="joint.beta_omega, joint.beta_v",
        note="The projector turns with the axes, so its rate times the relative twist belongs to the derivative.",
    ),
    equation(
        "accconst1b",
        "inertial derivative of the tip's twist",
        Equality(BEFORE.dV_T, printed_rate(BEFORE, "c")),
        derived=(Equality(BEFORE.dV_T, section_rate(BEFORE, "c")),),
        errata=("E3", "E23"),
        block="link_rows.J_TV, tip.b_omega, tip.b_v",
        note="(46) has three terms and the derivative printed those of two: the reference twist is lost, and the "
        "transport term of the frame's velocity.",
    ),
    equation(
        "accconst2",
        "inertial derivative of the base's twist",
        Equality(L.dV_B, printed_rate(L, "a")),
        derived=(Equality(L.dV_B, section_rate(L, "a")),),
        errata=("E3", "E23"),
        block="joint_rows.J_B",
    ),
    equation(
        "accconst4",
        "compatibility in the unknowns",
        Equality(
            L.P @ (BEFORE.Ad @ BEFORE.Vdot - L.Ad @ L.Vdot + BEFORE.Ad @ BEFORE.Vdot_xi_c - L.Ad @ L.Vdot_xi_a + L.H_p),
            NONE,
        ),
        derived=(
            Equality(
                L.P
                @ (
                    BEFORE.Ad_R @ BEFORE.J_b_c @ BEFORE.Vdot
                    - L.Ad_R @ L.J_b_a @ L.Vdot
                    + BEFORE.Ad @ BEFORE.Vdot_xi_c
                    - L.Ad @ L.Vdot_xi_a
                    + L.H_p
                ),
                NONE,
            ),
        ),
        errata=("E12", "E23"),
        block="joint_rows.joint_V, joint_rows.PX",
        note=r"$\mathbf{J}_b = [\mathbf{I}, \mathbf{0}; -\tilde{\mathbf{r}}_b, \mathbf{I}]$ takes the link's twist to "
        "a section. The Adjoint stays where the screw has no rotation part: there it only turns.",
    ),
    equation(
        "accconst5",
        "bias of the joint's rows",
        Equality(L.H_p, BEFORE.Ad @ (BEFORE.ad @ BEFORE.V_xi_c) - L.Ad @ (L.ad @ L.V_xi_a)),
        derived=(Equality(L.H_p, joint_bias(L, BEFORE)),),
        errata=("E3", "E23", "E27"),
        block="joint_rows.joint_H",
        note=r"The derived block has $\mathbf{P}_i\dot{\mathbf{A}}_i\dot{\mathbf{q}}_i$ for "
        r"$\dot{\mathbf{P}}_i[\ldots]$, which is the same.",
    ),
)

EQUATIONS = (*COMPATIBILITY, *LINKS, *ACCELERATIONS)
