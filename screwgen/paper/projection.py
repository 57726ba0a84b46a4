"""Section 5, first part: separation of variables, and the deformation equation projected on the modes of a link."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from ..algebra.expression import (
    Expression,
    Negative,
    Sum,
    Symbol,
    Transpose,
    add,
    block,
    hat,
    identity,
    inverse,
    stack,
    zeros,
)
from .equation import Equality, Equation, Formula
from .function_spaces import finite_norm, weak_derivatives, weak_stiffness
from .quantities import LinkLetters, symbol

L, BELOW = LinkLetters("i"), LinkLetters("i-1")
FREE_FALL = {"g:i": -L.g}
"""The paper's g, the opposite of free fall, in the judge's letters."""
UNLOADED = Symbol("load:i", (3, 1), r"\mathbf{0}")
"""The zero of (81); the judge's motions are arbitrary, and it stands for the load per mass that they need."""

turning, gravity, rho_A = hat(L.omega), L.R.T @ L.g, L.rhoA
over = lambda integrand: L.integral(integrand, rho_A)  # noqa: E731
O33 = zeros(3, 3)


def equation(label: str, title: str, *printed: Equality | Formula, **rest: Any) -> Equation:
    return Equation(label=label, section="5", title=title, printed=printed, **rest)


def shown(name: str, display: str) -> Symbol:
    """A quantity of link i as the equation at hand writes it."""
    return replace(symbol(name), display=display)


def transposed(e: Expression) -> Expression:
    """``e^T`` as printed, of scalars too."""
    return Transpose(e)


# ---------------------------------------------------------------------------- kinematics and shapes

PHI_P = block(
    [transposed(L.phi_x), zeros(1), zeros(1)],
    [zeros(1), transposed(L.phi_y), zeros(1)],
    [zeros(1), zeros(1), transposed(L.phi_z)],
)
FIRST = "The paper writes it for all p; written and judged here for p = 1."

SHAPES = (
    equation(
        "twist_coords",
        "velocities and their rates in coordinates",
        Equality(L.v, L.rdot + turning @ L.r),
        Equality(L.v_b, turning @ L.r_b),
        Equality(L.v_xi, L.rdot_xi + turning @ L.r_xi),
        Equality(L.vdot_xi, L.rddot_xi - hat(L.r_xi) @ L.omegadot + turning @ L.rdot_xi),
        Equality(turning @ L.v_ib, turning @ L.rdot_xi + turning @ (turning @ L.r_ib)),
    ),
    equation("72", "separation of variables", Equality(L.r_xi, L.phi @ L.eta), block="tip.Phi_c"),
    equation(
        "73",
        "mode shapes of a link",
        Equality(L.phi, block([L.phi_one, L.phi_two])),
        note="Written and judged for r = 2.",
    ),
    equation(
        "74",
        "modal coordinates of a link",
        Equality(L.eta, stack(L.eta_one, L.eta_two)),
        note="Written and judged for r = 2.",
    ),
    equation("75", "shapes of one mode", Equality(L.phi_one, PHI_P), note=FIRST),
    equation("76", "coordinates of one mode", Equality(L.eta_one, stack(L.eta_x, L.eta_y, L.eta_z)), note=FIRST),
    equation(
        "77",
        "space of the shapes",
        Formula(r"$\phi_{kp}(\xi_i) \in L^2(a_i,c_i) \times H^2(a_i,c_i)$"),
        derived=(
            Formula(r"$\phi_x \in H^1(a_i,c_i)$ and $\phi_y, \phi_z \in H^2(a_i,c_i)$, with (82) in its weak form"),
        ),
        errata=("E30",),
        gap=(
            Formula(
                r"$\int(\boldsymbol{\phi}'''')^{\top}\boldsymbol{\phi}\,d\xi - "
                r"\int(\boldsymbol{\phi}'')^{\top}\boldsymbol{\phi}''\,d\xi$, which is not zero in $H^2$"
            ),
        ),
        judge=weak_stiffness,
        note="Judged by the bending stiffness of the cubic of two beam elements, which is in H²: (82) as printed asks "
        "for a fourth derivative, which is zero wherever it exists, and finds no stiffness.",
    ),
    equation(
        "78",
        "square-integrable functions",
        Formula(r"$L^2(a_i,c_i) = \{ f : \int_{a_i}^{c_i} |f(\xi_i)|^2\,d\xi_i < \infty \}$"),
        judge=finite_norm,
        note="Judged by the norm of the judge's shapes, which the orthogonality condition makes 1.",
    ),
    equation(
        "79",
        "Sobolev spaces",
        Formula(r"$H^s(a_i,c_i) = \{ f : \partial^k f / \partial\xi_i^k \in L^2(a_i,c_i),\ k = 0,\dots,s \}$"),
        judge=weak_derivatives,
        note="Judged by integrating by parts: the second derivative of the cubic of two beam elements, whose fourth is "
        "no function, is its derivative in the weak sense.",
    ),
    equation(
        "vxi_modal",
        "velocity of the displacement in the modes",
        Equality(L.v_xi, L.rdot_xi + turning @ L.r_xi),
        Equality(L.v_xi, L.phi @ L.etadot + turning @ (L.phi @ L.eta)),
        block="tip.udot_T",
    ),
    equation(
        "vxidot_modal",
        "its rate in the modes",
        Equality(L.vdot_xi, L.rddot_xi - hat(L.r_xi) @ L.omegadot + turning @ L.rdot_xi),
        Equality(
            L.vdot_xi,
            L.phi @ L.etaddot - hat(L.phi @ L.eta) @ L.omegadot + turning @ (L.phi @ L.etadot),
        ),
        block="link.M_D, link.M_DPsi, link.h_MD",
    ),
)

# ------------------------------------------------------------------------------------- projection

PLACES = {"r_ob:i": L.r + L.r_ib, "rdot_ob:i": L.rdot + L.rdot_ib}
"""By which printed and derived are compared."""


def rates(place: Expression, speed: Expression) -> Expression:
    """Coriolis and centripetal acceleration, and the paper's gravity."""
    return 2 * (turning @ speed) + turning @ (turning @ place)


def field(place: Symbol, speed: Symbol, g: Expression) -> Expression:
    """The deformation equation with the modes put in, on its left."""
    stress = inverse(rho_A) @ (L.I_v2 @ (L.phi4 @ L.eta)) - inverse(rho_A) @ (L.I_v1 @ (L.phi2 @ L.eta))
    return L.rddot + L.phi @ L.etaddot - hat(place) @ L.omegadot + rates(place, speed) + g + stress


P = shown("phi_one", r"\boldsymbol{\phi}_{ip}")
P1 = shown("phi1_one", r"\boldsymbol{\phi}_{ip}'")
P2 = shown("phi2_one", r"\boldsymbol{\phi}_{ip}''")
P4 = shown("phi4_one", r"\boldsymbol{\phi}_{ip}''''")
ETA_P, ETADDOT_P = shown("eta_one", r"\boldsymbol{\eta}_i"), shown("etaddot_one", r"\ddot{\boldsymbol{\eta}}_i")
UNLOADED_P = shown("load_one", r"\mathbf{0}")
"""The zero of (82), for the judge the load on the mode."""
H_P = shown("h_phi_one", r"\mathbf{h}_{i\phi}")
ENDS = {
    (order, end): shown(f"phi{order or ''}_one_{end}", rf"\boldsymbol{{\phi}}_{{ip}}{order * chr(39)}({end}_i)")
    for order in (0, 1)
    for end in "ac"
}

STRONG = inverse(rho_A) @ (L.I_v2 @ (L.integral(P4.T @ P) @ ETA_P)) - inverse(rho_A) @ (
    L.I_v1 @ (L.integral(P2.T @ P) @ ETA_P)
)
"""The stiffness as (82) and (88) print it."""
WEAK = L.integral(P2.T @ (L.I_v2 @ L.phi2)) @ L.eta + L.integral(P1.T @ (L.I_v1 @ L.phi1)) @ L.eta
"""The stiffness in its weak form, of all pairs of modes, in newtons."""


def boundary(end: str, sign: int) -> Expression:
    """What integration by parts leaves at an end, in newtons, times a sign."""
    third, second, first = (getattr(L, f"r_xi{n}_{end}") for n in (3, 2, 1))
    force, moment = ENDS[0, end].T @ (L.I_v2 @ third - L.I_v1 @ first), ENDS[1, end].T @ (L.I_v2 @ second)
    return force - moment if sign > 0 else moment - force


def per_mass(force: Expression) -> Expression:
    """Every term of a sum over the mass per length."""
    assert isinstance(force, Sum)
    return add(*(inverse(rho_A) @ term for term in force.terms))


PROJECTED = (
    equation(
        "81",
        "deformation of the link in the modes",
        Equality(field(L.r_ib, L.rdot_ib, gravity), UNLOADED),
        derived=(Equality(field(L.r_ob, L.rdot_ob, -gravity), UNLOADED),),
        reading=FREE_FALL,
        where=PLACES,
        errata=("E4", "E22"),
        block="link.a_0, link.Omega",
        note="The judge's motions are arbitrary: the distributed load that they need stands on the right, where the "
        "paper prints 0.",
    ),
    equation(
        "82",
        "deformation projected on a mode",
        Equality(
            L.integral(P.T) @ L.rddot
            + L.integral(P.T @ P) @ ETADDOT_P
            + L.integral(Negative(P.T @ hat(L.r_ib))) @ L.omegadot
            + STRONG
            + L.integral(P.T @ (rates(L.r_ib, L.rdot_ib) + gravity)),
            UNLOADED_P,
        ),
        derived=(
            Equality(
                L.integral(P.T) @ L.rddot
                + L.integral(P.T @ L.phi) @ L.etaddot
                + L.integral(Negative(P.T @ hat(L.r_ob))) @ L.omegadot
                + per_mass(WEAK + boundary("c", 1) + boundary("a", -1))
                + L.integral(P.T @ (rates(L.r_ob, L.rdot_ob) - gravity)),
                UNLOADED_P,
            ),
        ),
        reading=FREE_FALL,
        where=PLACES,
        errata=("E4", "E9", "E16", "E22", "E30"),
        block="link.M_Dphi, link.M_Wphi, link.h_phi",
        note="Judged for p = 1; for the shapes to fit, its printed modal coordinates are those of mode p. The terms at "
        "the ends are what (35) to (38) set equal to the wrenches there: without them no wrench reaches the modes.",
    ),
)

# ---------------------------------------------------------------------------------- rows of a link


def at_link_1(name: str) -> Symbol:
    """A quantity of link 1, which has a neighbour on either side, written for link i."""
    s = symbol(name, "1")
    return replace(s, display=symbol(name).display)


W_NEXT = replace(symbol("W", "1"), display=symbol("W").display)
ROWS = at_link_1("M_Dphi") @ at_link_1("Psi_Z") + at_link_1("M_Wphi") @ at_link_1("etaddot") + at_link_1("h_phi")
TO_BASE = inverse(L.Ad_back.T) @ inverse(BELOW.Ad.T)
"""A wrench in F_(i-1) as one in F_i, (49)."""
TORQUE, FORCE = stack(identity(3), O33), stack(O33, identity(3))


def wrench_columns(shape: Symbol) -> list[Expression]:
    """The columns of the torque and of the force of W_(i-1) in the rows of a mode."""
    return [shape.T @ (TO_BASE @ TORQUE), shape.T @ (TO_BASE @ FORCE)]


def printed_row(phi: Symbol) -> list[Expression]:
    return [O33, O33, L.integral(Negative(phi.T @ hat(L.r_ib))), L.integral(phi.T)]


def derived_row(phi: Symbol, shape: Symbol) -> list[Expression]:
    return [*wrench_columns(shape), over(Negative(phi.T @ hat(L.r_ob))), over(phi.T)]


PRINTED_M_DPHI = block(printed_row(L.phi_one), printed_row(L.phi_two))
PRINTED_M_WPHI = block(
    [L.integral(L.phi_one.T @ L.phi_one), O33],
    [O33, L.integral(L.phi_two.T @ L.phi_two)],
)
PER_MASS: Mapping[str, Expression] = {"M_Wphi:i": inverse(rho_A) @ L.M_Wphi}

LINK_ROWS = (
    equation(
        "83",
        "modal rows of a link",
        Equality(ROWS, zeros(6)),
        derived=(Equality(ROWS - at_link_1("J_c").T @ W_NEXT, at_link_1("f_phi")),),
        errata=("E16",),
        block="link_rows.eta_V, link_rows.eta_eta, link_rows.eta_next, link_rows.eta_H, link_rows.eta_W",
        note=r"Judged on link 1, with $\mathbf{M}_{D\phi}$, $\mathbf{M}_{W\phi}$ and $\mathbf{h}_\phi$ as derived: the "
        r"wrench at the tip does work on the modes, and so do the external loads, which in the paper are the wrenches "
        r"at the ends and here hold the distributed load that an arbitrary motion needs.",
    ),
    equation(
        "84",
        "unknowns of a link",
        Equality(L.Psi_Z, stack(BELOW.W, L.Zdot)),
        note=r"$\boldsymbol{\mathcal{W}}_{i-1}$ is the wrench of link i on link i-1, in $\mathcal{F}_{i-1}$.",
    ),
    equation("zi_def", "coordinates of the twist", Equality(L.Z, stack(L.omega, L.rdot)), block="z_form.Z"),
    equation(
        "85",
        "columns of wrench and acceleration in the modal rows",
        Equality(L.M_Dphi, PRINTED_M_DPHI),
        derived=(Equality(L.M_Dphi, block(derived_row(L.phi_one, L.J_a_one), derived_row(L.phi_two, L.J_a_two))),),
        where=PLACES,
        errata=("E4", "E9", "E16"),
        block="link.M_Dphi, link_rows.eta_V, link_rows.eta_next, z_rows.eta_Z",
        note="Written for r = 2 and judged by accelerating the link by one unknown at a time. The wrench below does "
        "work on shapes that move the base, and the wrench above (83) on all.",
    ),
    equation(
        "86",
        "inertia of the modes",
        Equality(L.M_Wphi, PRINTED_M_WPHI),
        reading=PER_MASS,
        errata=("E9",),
        block="link.M_Wphi",
        note="Written for r = 2. It is symmetric and definite with or without the mass per length; symmetry of the "
        "whole needs it, (103).",
    ),
    equation(
        "88",
        "bias of the modal rows",
        Equality(H_P, STRONG + L.integral(P.T @ (rates(L.r_ib, L.rdot_ib) + gravity))),
        derived=(Equality(H_P, WEAK + over(P.T @ (rates(L.r_ob, L.rdot_ob) - gravity))),),
        reading=FREE_FALL,
        where=PLACES,
        errata=("E4", "E9", "E22", "E30"),
        block="link.h_eta, link.f_eta, link.h_phi",
        note="Judged for p = 1 in the unknowns of (84).",
    ),
)

EQUATIONS = (*SHAPES, *PROJECTED, *LINK_ROWS)
