"""The Z-form: exponential coordinates, the twist in coordinates, and the rows of the system in ``Zdot``.

The paper writes the pose of a link as ``q_i = [theta_i; r_i]``, (1): ``R_oi = exp(hat(theta_i))``, and ``r_i`` are
the *body-fixed* components of the origin's position, so that ``Z_i = [omega_i; rdot_i]``, (zi_def), holds the
derivative of components.  ``V_i = Z_i + gamma_i`` and ``Vdot_i = (I + T_gamma) Zdot_i + gamma*_i``.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from ..algebra.expression import Expression, Inverse, Stumpff, Symbol, hat, identity, stack, zeros
from ..algebra.expression import block as matrix
from ..algorithms.joint_rows import MIXED
from ..bodies.rotation import angle_steps
from ..ir.block import Block
from ..spec.link_class import LinkClass

LINK = "F_i"
HALF = sp.Rational(1, 2)
RATE = "rad/s^2, m/s^2"
TURNING = "what the rate of the angular velocity adds to that of the velocity"
VELOCITIES = "what the velocities add to the twist's rate"


@cache
def z_form_block() -> Block:
    """The kinematics of the Z-form; it is the same for every link.

    Inputs ``theta``, ``r``, ``omega``, ``rdot``, ``Zdot`` (and ``Vdot_solved``, the twist's rate that the twist form
    gives).  Steps: ``R``, ``J_theta`` and ``J_inverse`` with ``omega = J(theta) thetadot``, (jacobian) and E18;
    ``gamma``, ``V``, ``T_gamma``, ``gamma_star``, ``Vdot``, (twist), (MsPsi), (HMs).  ``J_inverse`` is regular at
    ``theta = 0`` and singular at ``|theta| = 2 pi``, where exponential coordinates end.
    """
    b = Block("z_form", "Coordinates of the Z-form")
    _exponential(b, b.input("theta", (3, 1), r"\boldsymbol{\theta}_i", "rad", LINK, "rotation vector of the link"))
    omega = b.input("omega", (3, 1), r"\boldsymbol{\omega}_i", "rad/s", LINK, "angular velocity of the link")
    _position(b, b.input("r", (3, 1), r"\mathbf{r}_i", "m", LINK, "components of the origin's position"), omega)
    _rates(b, b.symbol("r"), omega, b.symbol("rdot"))
    return b


def _exponential(b: Block, theta: Symbol) -> None:
    """``R``, the body-frame (right) Jacobian of exp, and its inverse.

    ``kappa = (c_3/2 - c_4) / c_2``, written in half the angle, where it does not cancel before a full turn.
    """
    x, c1, c2, c3, square = angle_steps(b, theta, "x_i", r"\tilde{\boldsymbol{\theta}}_i^{2}", "link")
    b.step(
        "R",
        identity(3) + c1 @ hat(theta) + c2 @ square,
        r"\mathbf{R}_{oi}",
        unit="-",
        frame="inertial",
        equation="1",
        meaning="rotation of the link, exp of its rotation vector",
    )
    b.step(
        "J_theta",
        identity(3) - c2 @ hat(theta) + c3 @ square,
        r"\mathbf{J}(\boldsymbol{\theta}_i)",
        unit="-",
        frame=LINK,
        equation="jacobian",
        meaning="body-frame Jacobian of exp: the angular velocity from the rotation vector's rate",
    )
    y = b.step("y", sp.Rational(1, 4) * x, "y_i", unit="rad^2", meaning="square of half the link's angle")
    kappa = b.step(
        "kappa",
        sp.Rational(1, 4) * (Inverse(Stumpff(1, y)) @ (Stumpff(2, y) - Stumpff(3, y))),
        r"\kappa",
        unit="-",
        meaning="coefficient of the inverse Jacobian: 1/12 at rest, infinite at a full turn",
    )
    b.step(
        "J_inverse",
        identity(3) + HALF * hat(theta) + kappa @ square,
        r"\mathbf{J}(\boldsymbol{\theta}_i)^{-1}",
        unit="-",
        frame=LINK,
        equation="jacobian",
        meaning="inverse Jacobian: the rotation vector's rate from the angular velocity",
    )


def _position(b: Block, r: Symbol, omega: Symbol) -> None:
    b.step(
        "thetadot",
        b.symbol("J_inverse") @ omega,
        r"\dot{\boldsymbol{\theta}}_i",
        unit="rad/s",
        frame=LINK,
        equation="jacobian",
        meaning="rate of the rotation vector",
    )
    b.step(
        "r_o",
        b.symbol("R") @ r,
        r"\mathbf{r}_{oi}",
        unit="m",
        frame="inertial",
        equation="1",
        meaning="position of the origin of F_i",
    )
    rdot = b.input("rdot", (3, 1), r"\dot{\mathbf{r}}_i", "m/s", LINK, "derivative of the components of the position")
    Z = b.step(
        "Z",
        stack(omega, rdot),
        r"\mathbf{Z}_i",
        unit="rad/s, m/s",
        frame=LINK,
        equation="zi_def",
        meaning="angular velocity, and derivative of the components of the position",
    )
    gamma = b.step(
        "gamma",
        stack(zeros(3), hat(omega) @ r),
        r"\boldsymbol{\gamma}_i",
        unit="rad/s, m/s",
        frame=LINK,
        equation="95",
        meaning="velocity that turning the components adds",
    )
    b.step(
        "V", Z + gamma, r"\mathbf{V}_i", unit="rad/s, m/s", frame=LINK, equation="twist", meaning="twist of the link"
    )


def _rates(b: Block, r: Symbol, omega: Symbol, rdot: Symbol) -> None:
    """``Vdot`` from ``Zdot``, and back: ``T_gamma^2 = 0``."""
    T = b.step(
        "T_gamma",
        matrix([zeros(3, 3), zeros(3, 3)], [-hat(r), zeros(3, 3)]),
        r"\mathbf{T}_{\gamma_i}",
        unit="m",
        frame=LINK,
        equation="MsPsi",
        meaning=TURNING,
    )
    gamma_star = b.step(
        "gamma_star",
        stack(zeros(3), hat(omega) @ rdot),
        r"\boldsymbol{\gamma}_i^{*}",
        unit=RATE,
        frame=LINK,
        equation="HMs",
        meaning=VELOCITIES,
    )
    Zdot = b.input("Zdot", (6, 1), r"\dot{\mathbf{Z}}_i", RATE, LINK, "second derivatives", numbered=(0,))
    solved = b.input("Vdot_solved", (6, 1), r"\dot{\mathbf{V}}_i^{*}", RATE, LINK, "solution for the twist's rate")
    b.step(
        "Vdot",
        (identity(6) + T) @ Zdot + gamma_star,
        r"\dot{\mathbf{V}}_i",
        unit=RATE,
        frame=LINK,
        equation="MsPsi",
        meaning="rate of the twist",
    )
    b.step(
        "Zdot_solved",
        (identity(6) - T) @ (solved - gamma_star),
        r"\dot{\mathbf{Z}}_i^{*}",
        unit=RATE,
        frame=LINK,
        equation="DAESOL",
        meaning="solution for the rate of Z",
    )


# ------------------------------------------------------------------------------------------------ rows

INERTIA = "kg, kg*m, kg*m^2"


@dataclass(frozen=True)
class LinkRows:
    """Some rows of a link: their twist columns and bias in V and in Z, as code and paper name them."""

    whose: str
    columns: tuple[str, str, str, str]
    """Name and LaTeX in V, then in Z."""
    unit: str
    bias: tuple[str, str, str, str, str] | None = None
    """Name and LaTeX in V, name in Z, name and LaTeX of the difference; None: the bias is the next joint's."""
    bias_unit: str = MIXED
    modal: bool = False

    @property
    def numbered(self) -> tuple[int, ...]:
        return (0,) if self.modal else ()


ROWS = (
    LinkRows(
        "rows of the joint",
        ("joint_V", r"\mathbf{P}_{V,i}", "joint_Z", r"\mathbf{P}_{Z,i}"),
        MIXED,
        ("joint_H", r"\mathbf{H}_{p,i}", "joint_H_Z", "joint_h_Ms", r"\mathbf{h}_{M_s,p,i}"),
    ),
    LinkRows(
        "twist rows",
        ("V_V", r"\mathbf{M}_{VV,i}", "Z_Z", r"\mathbf{M}_{VZ,i}"),
        INERTIA,
        ("V_H", r"\mathbf{H}_{V,i}", "V_H_Z", "V_h_Ms", r"\mathbf{h}_{M_s,V,i}"),
        "N*m, N",
    ),
    LinkRows(
        "modal rows",
        ("eta_V", r"\mathbf{M}_{\eta V,i}", "eta_Z", r"\mathbf{M}_{\eta Z,i}"),
        "kg, kg*m",
        ("eta_H", r"\mathbf{H}_{\eta,i}", "eta_H_Z", "eta_h_Ms", r"\mathbf{h}_{M_s,\eta,i}"),
        "N",
        modal=True,
    ),
    LinkRows("next joint's rows", ("next_V", r"\mathbf{P}_{V,i+1}^{-}", "next_Z", r"\mathbf{P}_{Z,i+1}^{-}"), MIXED),
)


@cache
def z_rows_block(key: LinkClass) -> Block:
    """The rows of the assembled system in ``Zdot``: twist columns times ``I + T_gamma``, biases plus those columns
    times ``gamma*``, (MsPsi), (HMs), (97) with E25.

    A twist column of joint i + 1 belongs to link i: its bias ``h_next`` is handed on and comes in as ``h_base``.
    """
    b = Block("z_rows", "Rows of the Z-form")
    T = b.input("T_gamma", (6, 6), r"\mathbf{T}_{\gamma_i}", "m", LINK, TURNING)
    gamma_star = b.input("gamma_star", (6, 1), r"\boldsymbol{\gamma}_i^{*}", RATE, LINK, VELOCITIES)
    meaning = "bias of the change to Z from the parent's twist"
    h_base = b.input("h_base", (6, 1), r"\mathbf{h}_{M_s,p,i}^{-}", MIXED, "-", meaning)
    columns = [_columns(b, rows, T, key.modes) for rows in ROWS]
    for rows, M in zip(ROWS, columns, strict=True):
        if rows.bias is not None:
            change = M @ gamma_star
            _bias(b, rows, rows.bias, change + h_base if rows.whose == "rows of the joint" else change)
    b.step(
        "h_next",
        columns[-1] @ gamma_star,
        r"\mathbf{h}_{M_s,p,i+1}^{-}",
        unit=MIXED,
        equation="HMs",
        meaning="next joint's rows: bias of the change to Z from this twist",
    )
    return b


def _columns(b: Block, rows: LinkRows, T: Symbol, modes: int) -> Symbol:
    """The twist columns of some rows, which become those of Zdot."""
    name, display, in_z, display_z = rows.columns
    size, meaning = modes if rows.modal else 6, f"{rows.whose}, twist columns"
    M = b.input(name, (size, 6), display, rows.unit, "-", meaning, numbered=rows.numbered)
    meaning = f"{rows.whose}, columns of the rate of Z"
    b.step(
        in_z,
        M @ (identity(6) + T),
        display_z,
        unit=rows.unit,
        equation="MsPsi",
        meaning=meaning,
        numbered=rows.numbered,
    )
    return M


def _bias(b: Block, rows: LinkRows, names: tuple[str, str, str, str, str], change: Expression) -> None:
    """``h_Ms`` of some rows, and their bias in Z: ``h_dyn = h_Ms + h_MD + h_s``."""
    name, display, in_z, difference, display_difference = names
    shared: dict[str, Any] = {"unit": rows.bias_unit, "numbered": rows.numbered}
    meaning = f"{rows.whose}: bias of the change to Z"
    h = b.step(difference, change, display_difference, equation="HMs", meaning=meaning, **shared)
    meaning = f"{rows.whose}: bias with the twist's rate as unknown"
    H = b.input(name, change.shape, display, rows.bias_unit, "-", meaning, numbered=rows.numbered)
    meaning = f"{rows.whose}: bias with the rate of Z as unknown"
    b.step(in_z, H + h, f"{display}^{{Z}}", equation="97", meaning=meaning, **shared)
