"""Section 3, stiffness and boundary rows (32), (33), (35)-(39): judged on a beam at rest."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..algebra.expression import Expression, block, hat, number, unit
from .beam_at_rest import BeamAtRest, moments_to_bending
from .equation import Equality, Equation, Judge
from .evaluate import evaluate
from .quantities import LinkLetters

L = LinkLetters("i")
o, one = number(0), number(1)
PRINTED_H = block([o, o, o], [o, o, one], [o, one, o])
DERIVED_H = block([o, o, o], [o, o, one], [o, -one, o])
FORCE_LAW = "What the link exerts at its tip, as its minus sign in (30) says; the text calls it applied."
BENDING_LAW = (
    r"$EI_y u_z'' = -M_y$: a torque about $+y$ bends the beam towards $-z$, "
    r"so $\mathbf{H} = -\tilde{\mathbf{e}}_x$."
)


def at_rest(printed: Equality, derived: Equality | None, where: Mapping[str, Expression]) -> Judge:
    """The misfits of both on a clamped beam under end loads and its own weight."""

    def judge(seed: int) -> tuple[float, float]:
        beam = BeamAtRest(seed)
        as_printed = printed.read(where).misfit(beam)
        return as_printed, derived.misfit(beam) if derived else as_printed

    return judge


def static(label: str, title: str, printed: Equality, derived: Equality | None = None, **rest: Any) -> Equation:
    """An equation that a beam at rest judges."""
    rest = {"judge": at_rest(printed, derived, rest.get("where", {}))} | rest
    holds = (derived,) if derived else ()
    return Equation(label=label, section="3", title=title, printed=(printed,), derived=holds, **rest)


def moment_matrix(seed: int) -> tuple[float, float]:
    """How far the printed and the derived H are from the bending that unit torques at the tip give."""
    truth = moments_to_bending(seed)
    printed, derived = (float(np.abs(evaluate(H, BeamAtRest(seed)) - truth).max()) for H in (PRINTED_H, DERIVED_H))
    return printed, derived


def shear(end: str) -> Expression:
    """The force in the beam at an end."""
    return L.I_v2 @ getattr(L, f"r_xi3_{end}") - L.I_v1 @ getattr(L, f"r_xi1_{end}")


def moment(label: str, title: str, bent: Expression, torque: Expression, *more: str) -> Equation:
    """A moment row, with H as (39) prints it and as the cross product that it must be."""
    return static(
        label,
        title,
        Equality(-(L.I_v2 @ bent), L.H @ torque),
        Equality(-(L.I_v2 @ bent), -(hat(unit(0)) @ torque)),
        where={"H:i": PRINTED_H},
        errata=("E11", *more),
        note=BENDING_LAW,
    )


SECTIONS = (
    static(
        "32",
        "axial section stiffness",
        Equality(L.I_v1, block([L.EA, o, o], [o, o, o], [o, o, o])),
        block="link.K",
        note="Judged by the strain energy of a section.",
    ),
    static(
        "33",
        "bending section stiffness",
        Equality(L.I_v2, block([o, o, o], [o, L.EIz, o], [o, o, L.EIy])),
        block="link.K",
        note=r"Judged by the strain energy of a section; $I_z = \int y^2\,dA$ belongs to the displacement in y.",
    ),
)

ENDS = (
    static(
        "35",
        "force at the base",
        Equality(shear("a"), L.F_B),
        errata=("E35",),
        note="Here the force is applied to the link, by what holds its base.",
    ),
    static("36", "force at the tip", Equality(shear("c"), L.F_T), errata=("E10",), note=FORCE_LAW),
    moment("37", "moment at the base", L.r_xi2_a, L.tau_B, "E35"),
    moment("38", "moment at the tip", L.r_xi2_c, L.tau_T),
    static(
        "39",
        "bending moments from torques",
        Equality(L.H, PRINTED_H),
        Equality(L.H, DERIVED_H),
        judge=moment_matrix,
        errata=("E11",),
        note=BENDING_LAW,
    ),
)
