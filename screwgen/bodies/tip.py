"""The tip block: pose, twist and acceleration of the tip section, and the bodies fixed there."""

from __future__ import annotations

import sympy as sp

from ..algebra.expression import Expression, Symbol, hat, identity, unit, zeros
from ..algebra.rate import acceleration, moving_rate, rate, turned_rate
from ..ir.block import Block
from ..spec.link_class import LinkClass
from .fields import Fields
from .lumped import lumped
from .rotation import angle_steps

LINK = "F_i"
TIP = "tip frame"


def tip_block(key: LinkClass) -> Block:
    """Pose, twist and bias acceleration of the tip section, with its slope, (46) and (accconst1b).

    ``V_T = J_T nu`` and ``Vdot_T = J_T nudot + b_T`` with ``J_T = blkdiag(R_T, R_T)^T
    [[I, 0, J_l Psi_c], [-hat(r_T), I, Phi_c]]``.
    """
    b = Block("tip", "Tip section")
    omega = b.input("omega", (3, 1), r"\boldsymbol{\omega}_i", "rad/s", LINK, "angular velocity of the link")
    v = b.input("v", (3, 1), r"\mathbf{v}_i", "m/s", LINK, "velocity of the origin of F_i")
    R_T, r_T, udot, omega_s, alpha_s = _moving_tip(b, key)
    rates = {"r_T": udot, "omega_s": alpha_s}
    omega_T, v_T = omega + omega_s, v + hat(omega) @ r_T + udot
    b.step(
        "omega_T",
        R_T.T @ omega_T,
        r"\boldsymbol{\omega}_T",
        unit="rad/s",
        frame=TIP,
        equation="46",
        meaning="angular velocity of the tip section",
    )
    b.step(
        "v_T", R_T.T @ v_T, r"\mathbf{v}_T", unit="m/s", frame=TIP, equation="46", meaning="velocity of the tip point"
    )
    b.step(
        "b_omega",
        turned_rate(R_T, omega_s, omega_T, rates),
        r"\mathbf{b}_{\omega}",
        unit="rad/s^2",
        frame=TIP,
        equation="accconst1b",
        meaning="angular acceleration of the tip section that the velocities cause",
    )
    b.step(
        "b_v",
        turned_rate(R_T, omega_s, v_T, rates),
        r"\mathbf{b}_{v}",
        unit="m/s^2",
        frame=TIP,
        equation="accconst1b",
        meaning="acceleration of the tip point that the velocities cause",
    )
    return b


def tip_motion_block(key: LinkClass) -> Block:
    """The tip section's motion from that of F_i without modal accelerations, (accconst1b); all in F_i axes.

    Accelerations are those of material points in the inertial frame.
    """
    b = Block("tip_motion", "Motion of the tip section")
    omega = b.input("omega", (3, 1), r"\boldsymbol{\omega}_i", "rad/s", LINK, "angular velocity of the link")
    alpha = b.input("alpha", (3, 1), r"\boldsymbol{\alpha}_i", "rad/s^2", LINK, "angular acceleration of the link")
    v = b.input("v", (3, 1), r"\mathbf{v}_i", "m/s", LINK, "velocity of the origin of F_i")
    a = b.input("a", (3, 1), r"\mathbf{a}_i", "m/s^2", LINK, "acceleration of the origin of F_i")
    _, r_T, udot, omega_s, alpha_s = _moving_tip(b, key)
    rates = {"omega": alpha, "r_T": udot, "omega_s": alpha_s}
    b.step(
        "omega_t",
        omega + omega_s,
        r"\boldsymbol{\omega}_t",
        unit="rad/s",
        frame=LINK,
        equation="46",
        meaning="angular velocity of the tip section",
    )
    b.step(
        "v_t",
        v + moving_rate(r_T, omega, rates),
        r"\mathbf{v}_t",
        unit="m/s",
        frame=LINK,
        equation="46",
        meaning="velocity of the tip point",
    )
    b.step(
        "alpha_t",
        alpha + moving_rate(omega_s, omega, rates),
        r"\boldsymbol{\alpha}_t",
        unit="rad/s^2",
        frame=LINK,
        equation="accconst1b",
        meaning="angular acceleration of the tip section",
    )
    b.step(
        "a_t",
        a + acceleration(r_T, omega, rates),
        r"\mathbf{a}_t",
        unit="m/s^2",
        frame=LINK,
        equation="accconst1b",
        meaning="acceleration of the tip point",
    )
    return b


def _moving_tip(b: Block, key: LinkClass) -> tuple[Expression, Symbol, Symbol, Expression, Expression]:
    """``R_T, r_T``, the rate of the tip's displacement, the section's relative angular velocity and its rate."""
    etadot = b.input("etadot", (key.modes, 1), r"\dot{\boldsymbol{\eta}}_i", "m/s", "-", "modal rates")
    R_T, r_T = tip_pose(b, key)
    udot = b.step(
        "udot_T",
        b.symbol("Phi_c") @ etadot,
        r"\dot{\mathbf{u}}_T",
        unit="m/s",
        frame=LINK,
        equation="23",
        meaning="rate of the tip's elastic displacement",
    )
    return R_T, r_T, udot, *_turning(b, key, etadot)


def tip_pose_block(key: LinkClass) -> Block:
    """Rotation and position of the tip section alone (poses, energy)."""
    b = Block("tip_pose", "Pose of the tip section")
    tip_pose(b, key)
    return b


def tip_pose(b: Block, key: LinkClass) -> tuple[Expression, Symbol]:
    """``R_T = exp(hat(theta))`` and ``r_T = r_b(c) + Phi(c) eta``: the tip section in F_i."""
    eta = b.input("eta", (key.modes, 1), r"\boldsymbol{\eta}_i", "m", "-", "modal coordinates (torsion: rad)")
    length: Expression = zeros(1)
    if key.length:
        length = b.parameter("length", (1, 1), "l_i", "m", "-", "length of the link")
    fields = Fields(key, b.values["length"].item() if key.length else sp.S.Zero, sp.S.Zero)
    Phi = b.step(
        "Phi_c",
        b.field("Phi_tip", fields.tip(), r"\boldsymbol{\phi}_i(c_i)"),
        r"\boldsymbol{\phi}_c",
        unit="-",
        frame=LINK,
        equation="72",
        meaning="displacement of the tip by each mode",
        numbered=(1,),
    )
    reach: Expression = length
    if key.frame_at:
        frame_at = b.parameter("frame_at", (1, 1), "f_i", "m", LINK, "place of F_i on the centreline, from the joint")
        reach = b.step("reach", length - frame_at, "c_i", unit="m", meaning="place of the tip on the centreline of F_i")
    r_T = b.step(
        "r_T", reach @ unit(0) + Phi @ eta, r"\mathbf{r}_T", unit="m", frame=LINK, equation="11", meaning="tip point"
    )
    return _tip_rotation(b, key, fields, eta), r_T


def _tip_rotation(b: Block, key: LinkClass, fields: Fields, eta: Symbol) -> Expression:
    if not key.section_rotation:
        return identity(3)
    Psi = b.step(
        "Psi_c",
        b.field("Psi_tip", fields.rotation(), r"\boldsymbol{\Psi}_i(c_i)"),
        r"\boldsymbol{\Psi}_c",
        unit="1/m",
        frame=LINK,
        meaning="turn of the tip section by each mode",
        numbered=(1,),
    )
    theta = b.step(
        "theta",
        Psi @ eta,
        r"\boldsymbol{\theta}_c",
        unit="rad",
        frame=LINK,
        meaning="rotation vector of the tip section, [torsion, -u_z', u_y']",
    )
    _, c1, c2, c3, square = angle_steps(b, theta, "x", "c", "tip section")
    b.step(
        "J_l",
        identity(3) + c2 @ hat(theta) + c3 @ square,
        r"\mathbf{J}_l",
        unit="-",
        frame=LINK,
        meaning="left Jacobian of the exponential",
    )
    return b.step(
        "R_T",
        identity(3) + c1 @ hat(theta) + c2 @ square,
        r"\mathbf{R}_T",
        unit="-",
        frame=LINK,
        meaning="rotation of the tip section, exp of theta",
    )


def _turning(b: Block, key: LinkClass, etadot: Symbol) -> tuple[Expression, Expression]:
    """The section's angular velocity ``J_l thetadot`` relative to F_i, and its rate without ``etaddot``."""
    if not key.section_rotation:
        return zeros(3), zeros(3)
    theta, c2, c3 = (b.symbol(n) for n in ("theta", "c2", "c3"))
    thetadot = b.step(
        "thetadot",
        b.symbol("Psi_c") @ etadot,
        r"\dot{\boldsymbol{\theta}}_c",
        unit="rad/s",
        frame=LINK,
        meaning="rate of the tip's rotation vector",
    )
    turning = thetadot + c2 @ (hat(theta) @ thetadot) + c3 @ (hat(theta) @ (hat(theta) @ thetadot))
    omega_s = b.step(
        "omega_s",
        turning,
        r"\boldsymbol{\omega}_s",
        unit="rad/s",
        frame=LINK,
        meaning="angular velocity of the tip section relative to F_i",
    )
    xdot = b.step("xdot", 2 * (theta.T @ thetadot), r"\dot{x}", unit="rad^2/s", meaning="rate of the squared angle")
    slopes = {f"c{k}": _step_rate(b, f"c{k}", {"x": xdot}) for k in (2, 3)}
    alpha_s = b.step(
        "alpha_s",
        rate(turning, {"theta": thetadot, **slopes}),
        r"\boldsymbol{\alpha}_s",
        unit="rad/s^2",
        frame=LINK,
        meaning="rate of the section's angular velocity without etaddot",
    )
    return omega_s, alpha_s


def _step_rate(b: Block, name: str, rates: dict) -> Symbol:
    """The time derivative of an earlier step, as a step of its own."""
    step = b.steps[name]
    return b.step(
        f"{name}dot",
        rate(step.expression, rates),
        rf"\dot{{{step.signal.display}}}",
        unit="1/s",
        meaning=f"rate of {name}",
    )


def tip_body_block(key: LinkClass) -> Block:
    """The rigid bodies fixed to the tip section: their inertia and Newton-Euler bias at the tip twist."""
    b = Block("tip_body", "Bodies at the tip")
    omega = b.input("omega_T", (3, 1), r"\boldsymbol{\omega}_T", "rad/s", TIP, "angular velocity of the tip section")
    v = b.input("v_T", (3, 1), r"\mathbf{v}_T", "m/s", TIP, "velocity of the tip point")
    g = b.input("g_T", (3, 1), r"\mathbf{g}_T", "m/s^2", TIP, "free fall in the tip frame, R_oT^T g")
    m, S, _, I = lumped(b, key, "tip", "T")
    a_0 = b.step(
        "a_T",
        hat(omega) @ v - g,
        r"\mathbf{a}_T",
        unit="m/s^2",
        frame=TIP,
        meaning="acceleration of the tip point at rest rates, against free fall",
    )
    b.step(
        "h_T_tau",
        hat(S) @ a_0 + hat(omega) @ (I @ omega),
        r"\mathbf{h}_{T\tau}",
        unit="N*m",
        frame=TIP,
        meaning="bias moment of the tip bodies, weight included",
    )
    b.step(
        "h_T_F",
        m @ a_0 + hat(omega) @ (hat(omega) @ S),
        r"\mathbf{h}_{TF}",
        unit="N",
        frame=TIP,
        meaning="bias force of the tip bodies, weight included",
    )
    return b
