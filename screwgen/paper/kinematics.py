"""Section 2 and Appendix A: coordinates, twists and their derivatives."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..algebra.expression import Symbol, block, hat, stack, zeros
from .equation import Equality, Equation, Formula
from .quantities import LinkLetters
from .random_motion import RandomMotion

L = LinkLetters("i")
O3, O33 = zeros(3), zeros(3, 3)
PLACE = {"r_ib:i": L.r_b + L.r_xi}
"""An element's place is its undeformed place and its displacement."""


def equation(label: str, title: str, *printed: Equality | Formula, section: str = "2", **rest: Any) -> Equation:
    return Equation(label=label, section=section, title=title, printed=printed, **rest)


def appendix(label: str, title: str, *printed: Equality, **rest: Any) -> Equation:
    return equation(label, title, *printed, section="A", **rest)


def section_turns(seed: int) -> tuple[float, float]:
    """How far a turned section is from normal to its centreline, to first order: not turned, and turned by theta_xi."""
    slope = RandomMotion(seed).values["r_xi1_c:i"][:, 0]
    turn = np.array([0.0, -slope[2], slope[1]])
    gap = lambda theta: np.abs(np.cross(theta, [1.0, 0, 0])[1:] - slope[1:]).max()  # noqa: E731
    return gap(np.zeros(3)) / np.abs(slope[1:]).max(), gap(turn) / np.abs(slope[1:]).max()


THETA_XI = Symbol("theta_xi:i", (3, 1), r"\boldsymbol{\theta}_{\xi_i}")

SECTION_2 = (
    equation("1", "generalised coordinates of a link", Equality(L.q, stack(L.theta, L.r))),
    equation("2", "generalised velocities of a link", Equality(L.qdot, stack(L.thetadot, L.rdot))),
    equation(
        "twist",
        "body-fixed twist",
        Equality(L.V, stack(L.omega, L.v)),
        Equality(L.V, stack(L.omega, L.rdot + hat(L.omega) @ L.r)),
        block="joint.omega, joint.v",
    ),
    equation(
        "Ad",
        "Adjoint of a frame",
        Equality(L.Ad, block([L.R, O33], [hat(L.r_o) @ L.R, L.R])),
        note="Written for the two frames of which it is used, the link's and the inertial one.",
    ),
    equation(
        "5",
        "reference coordinates of an element",
        Equality(L.q_b, stack(O3, L.r_b)),
        Equality(L.qdot_b, zeros(6)),
        block="link.r_b",
        note="Elements sit on the centreline: their lateral coordinates are zero.",
    ),
    equation(
        "8",
        "elastic coordinates of an element",
        Equality(L.q_xi, stack(O3, L.r_xi)),
        Equality(L.qdot_xi, stack(O3, L.rdot_xi)),
        derived=(
            Equality(L.q_xi, stack(THETA_XI, L.r_xi)),
            Equality(
                L.qdot_xi, stack(Symbol("thetadot_xi:i", (3, 1), r"\dot{\boldsymbol{\theta}}_{\xi_i}"), L.rdot_xi)
            ),
        ),
        errata=("E21",),
        judge=section_turns,
        block="tip.theta",
        note="A section stays normal to the centreline, so it turns by the slope, [torsion angle, -u_z', u_y'].",
    ),
    equation("10", "place of an element in its link", Equality(L.r_ib, L.r_xi + L.r_b), block="link.rho"),
    equation("11", "place of an element", Equality(L.r_ob, L.r + L.r_ib), block="tip.r_T"),
)

APPENDIX = (
    appendix("14", "transport theorem", Equality(L.d_r, L.rdot + hat(L.omega) @ L.r)),
    appendix("15", "velocity of the link's frame", Equality(L.d_r, L.rdot + hat(L.omega) @ L.r)),
    appendix("16", "velocity of the displacement", Equality(L.d_r_xi, L.rdot_xi + hat(L.omega) @ L.r_xi)),
    appendix("17", "velocity of the reference geometry", Equality(L.d_r_b, hat(L.omega) @ L.r_b)),
    appendix("18", "velocity of an element", Equality(L.d_r_ob, L.rdot + L.rdot_xi + hat(L.omega) @ L.r_ob)),
    appendix(
        "19",
        "acceleration of the link's frame",
        Equality(
            L.dd_r,
            L.rddot - hat(L.r) @ L.omegadot + 2 * (hat(L.omega) @ L.rdot) + hat(L.omega) @ (hat(L.omega) @ L.r),
        ),
    ),
    appendix(
        "20",
        "acceleration of an element against the frame's origin",
        Equality(
            L.dd_r_ib,
            L.rddot_xi
            - (hat(L.r_xi) + hat(L.r_b)) @ L.omegadot
            + 2 * (hat(L.omega) @ L.rdot_xi)
            + hat(L.omega) @ (hat(L.omega) @ (L.r_xi + L.r_b)),
        ),
    ),
    appendix(
        "21",
        "acceleration of an element",
        Equality(
            L.dd_r_ob,
            L.rddot
            + L.rddot_xi
            - hat(L.r_ob) @ L.omegadot
            + 2 * (hat(L.omega) @ L.rdot_ob)
            + hat(L.omega) @ (hat(L.omega) @ L.r_ob),
        ),
        block="link.a_0",
    ),
    appendix(
        "22",
        "twist of the link",
        Equality(L.V, stack(L.omega, L.v)),
        Equality(L.V, stack(L.omega, L.rdot + hat(L.omega) @ L.r)),
        block="joint.omega, joint.v",
    ),
    appendix(
        "23",
        "twist of the deformation",
        Equality(L.V_xi, stack(O3, L.v_xi)),
        Equality(L.V_xi, stack(O3, L.rdot_xi + hat(L.omega) @ L.r_xi)),
        block="tip.udot_T",
    ),
    appendix(
        "24",
        "twist of the reference geometry",
        Equality(L.V_b, stack(O3, L.v_b)),
        Equality(L.V_b, stack(O3, hat(L.omega) @ L.r_b)),
    ),
    appendix("25", "small adjoint", Equality(L.bracket, block([hat(L.omega), O33], [hat(L.v), hat(L.omega)]) @ L.u)),
    appendix(
        "Vdot_coord",
        "body-fixed derivative of the twist",
        Equality(L.Vdot, stack(L.omegadot, L.rddot - hat(L.r) @ L.omegadot + hat(L.omega) @ L.rdot)),
    ),
    appendix(
        "dvi",
        "inertial derivative of the link's twist",
        Equality(L.dV, L.Vdot + L.ad @ L.V),
        Equality(L.dV, stack(L.omegadot, L.vdot)),
        derived=(
            Equality(L.dV, L.Vdot + stack(O3, hat(L.omega) @ L.v)),
            Equality(L.dV, stack(L.omegadot, L.vdot + hat(L.omega) @ L.v)),
        ),
        errata=("E3",),
        note="The bracket of a screw with itself vanishes; the frame still turns, and the transport theorem (14) "
        "gives the velocity's components their second term.",
    ),
    appendix(
        "dvxi",
        "inertial derivative of the deformation's twist",
        Equality(L.dV_xi, L.Vdot_xi + L.ad @ L.V_xi),
        Equality(L.dV_xi, stack(O3, L.vdot_xi + hat(L.omega) @ L.v_xi)),
    ),
    appendix(
        "dvb",
        "inertial derivative of the reference twist",
        Equality(L.dV_b, L.Vdot_b + L.ad @ L.V_b),
        Equality(L.dV_b, stack(O3, L.vdot_b + hat(L.omega) @ L.v_b)),
    ),
)

EQUATIONS = (*SECTION_2, *APPENDIX)
