"""Appendix B: the matrices of the modal projection (B1) to (B3), written for two links."""

from __future__ import annotations

from typing import Any

from ..algebra.expression import Expression, block, hat, zeros
from .equation import Equality, Equation
from .quantities import LinkLetters

ONE, TWO, ALL = LinkLetters("1"), LinkLetters("2"), LinkLetters("all")
O33, O3, O36 = zeros(3, 3), zeros(3), zeros(3, 6)
PARTS = {name: link.r_b + link.r_xi for name, link in (("r_ib:1", ONE), ("r_ib:2", TWO))}


def equation(label: str, title: str, printed: Equality, derived: Equality, **rest: Any) -> Equation:
    return Equation(label=label, section="B", title=title, printed=(printed,), derived=(derived,), where=PARTS, **rest)


def bent(link: LinkLetters, end: str) -> Expression:
    """The skew matrix of an end's displacement."""
    return hat(getattr(link, f"phi_{end}") @ link.eta)


def over(link: LinkLetters, integrand: Expression) -> Expression:
    return link.integral(integrand, link.rhoA)


# --------------------------------------------------------------------------------------------- M_D

PRINTED_M_D = block(
    [-(ONE.R @ ONE.phi_a), O36],
    [O36, O36],
    [ONE.integral(ONE.phi), O36],
    [ONE.integral(hat(ONE.r_xi) @ ONE.phi), O36],
    [ONE.R @ ONE.phi_c, -(TWO.R @ TWO.phi_a)],
    [O36, O36],
    [O36, TWO.integral(TWO.phi)],
    [O36, TWO.integral(hat(TWO.r_xi) @ TWO.phi)],
)
DERIVED_M_D = block(
    [O36, O36],
    [-(ONE.R @ ONE.phi_a), O36],
    [over(ONE, hat(ONE.r_ib) @ ONE.phi), O36],
    [over(ONE, ONE.phi), O36],
    [O36, O36],
    [ONE.R @ ONE.phi_c, -(TWO.R @ TWO.phi_a)],
    [O36, over(TWO, hat(TWO.r_ib) @ TWO.phi)],
    [O36, over(TWO, TWO.phi)],
)

# ------------------------------------------------------------------------------------------ M_DPsi


def columns(
    omegadot_1: Expression = O33,
    rddot_1: Expression = O33,
    omegadot_2: Expression = O33,
    torque_1: Expression = O33,
    rddot_2: Expression = O33,
) -> list[Expression]:
    """A row: columns of W_0 (torque, force), of Zdot_1 (omegadot, rddot), and the same of W_1 and Zdot_2."""
    return [O33, O33, omegadot_1, rddot_1, torque_1, O33, omegadot_2, rddot_2]


def pulled(link: LinkLetters) -> Expression:
    """``∫ phi eta`` as a skew matrix."""
    return link.integral(hat(link.phi @ link.eta))


def turned(link: LinkLetters) -> Expression:
    return link.integral(hat(link.r_xi) @ hat(link.phi @ link.eta))


def moment_of_turning(link: LinkLetters) -> Expression:
    """What the angular acceleration adds to the moment through the deformation, in the unknowns of (84)."""
    carried = hat(link.r_ib) @ hat(link.r_xi) + hat(link.r_xi) @ hat(link.r_b) + hat(link.r_xi) @ hat(link.r)
    return -over(link, carried)


PRINTED_M_DPSI = block(
    columns(omegadot_1=-ONE.R),
    columns(),
    columns(omegadot_1=-pulled(ONE)),
    columns(omegadot_1=-turned(ONE)),
    columns(omegadot_1=ONE.R, omegadot_2=-TWO.R),
    columns(),
    columns(torque_1=-pulled(TWO)),
    columns(torque_1=-turned(TWO)),
)
DERIVED_M_DPSI = block(
    columns(),
    columns(omegadot_1=ONE.R @ bent(ONE, "a")),
    columns(omegadot_1=moment_of_turning(ONE), rddot_1=over(ONE, hat(ONE.r_xi))),
    columns(omegadot_1=-over(ONE, hat(ONE.r_xi))),
    columns(),
    columns(omegadot_1=-(ONE.R @ bent(ONE, "c")), omegadot_2=TWO.R @ bent(TWO, "a")),
    columns(omegadot_2=moment_of_turning(TWO), rddot_2=over(TWO, hat(TWO.r_xi))),
    columns(omegadot_2=-over(TWO, hat(TWO.r_xi))),
)

# -------------------------------------------------------------------------------------------- h_MD


def swung(link: LinkLetters, end: str) -> Expression:
    """``R omega x phi etadot`` at an end."""
    return link.R @ (hat(link.omega) @ (getattr(link, f"phi_{end}") @ link.etadot))


def printed_momentum(link: LinkLetters) -> list[list[Expression]]:
    turning = hat(link.omega)
    return [
        [turning @ (link.integral(link.phi) @ link.etadot)],
        [link.integral(hat(link.r_xi) @ (turning @ link.phi)) @ link.etadot],
    ]


def derived_momentum(link: LinkLetters) -> list[list[Expression]]:
    turning = hat(link.omega)
    coriolis = over(link, hat(link.r_ib) @ (turning @ link.phi)) @ link.etadot
    carried = over(link, hat(link.r_xi)) @ (turning @ link.rdot)
    return [[coriolis + carried], [turning @ (over(link, link.phi) @ link.etadot)]]


PRINTED_H_MD = block(
    [-swung(ONE, "a")],
    [O3],
    *printed_momentum(ONE),
    [swung(ONE, "c") - swung(TWO, "a")],
    [O3],
    *printed_momentum(TWO),
)
DERIVED_H_MD = block(
    [O3],
    [-swung(ONE, "a")],
    *derived_momentum(ONE),
    [O3],
    [swung(ONE, "c") - swung(TWO, "a")],
    *derived_momentum(TWO),
)

ORDER = (
    "Rows as in (66), the angular part first: rotation and translation of joint 1, moment and force of link 1, then "
    "those of joint 2 and link 2."
)

EQUATIONS = (
    equation(
        "B1",
        "columns of the modal accelerations",
        Equality(ALL.M_D, PRINTED_M_D),
        Equality(ALL.M_D, DERIVED_M_D),
        errata=("E8", "E9", "E24"),
        block="link.M_D, link_rows.V_eta, link_rows.next_eta",
        note=ORDER,
    ),
    equation(
        "B2",
        "columns that the deformation adds",
        Equality(ALL.M_DPsi, PRINTED_M_DPSI),
        Equality(ALL.M_DPsi, DERIVED_M_DPSI),
        errata=("E8", "E9", "E24", "E28", "E36"),
        block="link.M_DPsi, joint_rows.joint_V, link_rows.next_V, z_rows.Z_Z",
        note=f"{ORDER} In the unknowns of (84), so the columns of "
        r"$\ddot{\mathbf{r}}_i$ are not zero, as the text has them: $\mathbf{D}^*_i$ depends on the acceleration of "
        r"the frame.",
    ),
    equation(
        "B3",
        "bias of the deformation's inertia",
        Equality(ALL.h_MD, PRINTED_H_MD),
        Equality(ALL.h_MD, DERIVED_H_MD),
        errata=("E8", "E9", "E24", "E36"),
        block="link.h_MD, z_rows.V_h_Ms",
        note=f"{ORDER} In the unknowns of (84), so it does not vanish with the modal rates, as the text has it; in "
        f"those of (67) it does.",
    ),
)
