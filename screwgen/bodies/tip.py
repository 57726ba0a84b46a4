"""The tip block: pose, twist and acceleration of the tip section, and the bodies fixed there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..algebra.expression import Expression, Symbol, hat, identity, matrix, number, unit, vector, zeros
from ..algebra.rate import acceleration, moving_rate, turned_rate
from ..ir.block import Block
from ..lazily import sp
from ..spec.link_class import EXACT, LinkClass
from ..spec.markers import BASE, TIP
from .fields import Fields, length
from .lumped import lumped
from .reduced import numerals
from .rotation import angle_steps, rate_of_turning, turning
from .second_order import at_tip, forms, halves, quadratic_terms, rows


def tip_block(key: LinkClass) -> Block:
    """Pose, twist and bias acceleration of the tip section, with its slope, (46) and (accconst1b).

    ``V_T = J_T nu`` and ``Vdot_T = J_T nudot + b_T`` with ``J_T = blkdiag(R_T, R_T)^T
    [[I, 0, J_l Psi_c], [-hat(r_T), I, Phi_c]]``.
    """
    b = Block("tip", "Tip section")
    omega = b.input("omega", (3, 1))
    v = b.input("v", (3, 1))
    R_T, r_T, omega_s, rates = _moving_tip(b, key)
    omega_T, v_T = omega + omega_s, v + hat(omega) @ r_T + rates["r_T"]
    b.step("omega_T", R_T.T @ omega_T)
    b.step("v_T", R_T.T @ v_T)
    b.step("b_omega", turned_rate(R_T, omega_s, omega_T, rates))
    b.step("b_v", turned_rate(R_T, omega_s, v_T, rates))
    return b


def tip_motion_block(key: LinkClass) -> Block:
    """The tip section's motion from that of F_i without modal accelerations, (accconst1b); all in F_i axes.

    Accelerations are those of material points in the inertial frame.
    """
    b = Block("tip_motion", "Motion of the tip section")
    omega = b.input("omega", (3, 1))
    alpha = b.input("alpha", (3, 1))
    v = b.input("v", (3, 1))
    a = b.input("a", (3, 1))
    _, r_T, omega_s, rates = _moving_tip(b, key)
    rates["omega"] = alpha
    b.step("omega_t", omega + omega_s)
    b.step("v_t", v + moving_rate(r_T, omega, rates))
    b.step("alpha_t", alpha + moving_rate(omega_s, omega, rates))
    b.step("a_t", a + acceleration(r_T, omega, rates))
    return b


def _moving_tip(b: Block, key: LinkClass) -> tuple[Expression, Symbol, Expression, dict[str, Expression]]:
    """``R_T, r_T``, the section's relative angular velocity, and the rates without ``etaddot`` of what moves."""
    etadot = b.input("etadot", (key.modes, 1))
    R_T, r_T = tip_pose(b, key)
    if key.order == EXACT:
        return R_T, r_T, *_swept_tip(b, key)
    udot = b.step("udot_T", b.symbol("Phi_c") @ etadot)
    omega_s, alpha_s = _turning(b, key, etadot)
    rates: dict[str, Expression] = {"r_T": udot, "omega_s": alpha_s}
    if key.order == 2:
        rates["udot_T"] = _bent(b, "Phi2dot", "H", etadot)
    return R_T, r_T, omega_s, rates


def _swept_tip(b: Block, key: LinkClass) -> tuple[Expression, dict[str, Expression]]:
    """The same of a rod along whose sections the motion is found: it is an input, as are the shapes of the tip."""
    b.input("Phi_c", (3, key.modes))
    b.input("Psi_c", (3, key.modes))
    b.input("J_l", (3, 3))
    rates: dict[str, Expression] = {"r_T": b.input("udot_T", (3, 1)), "udot_T": b.input("bend_T", (3, 1))}
    rates["omega_s"] = b.input("alpha_s", (3, 1))
    return b.input("omega_s", (3, 1)), rates


def tip_pose_block(key: LinkClass) -> Block:
    """Rotation and position of the tip section alone (poses, energy)."""
    b = Block("tip_pose", "Pose of the tip section")
    tip_pose(b, key)
    return b


def tip_pose(b: Block, key: LinkClass) -> tuple[Expression, Symbol]:
    """``R_T = exp(hat(theta))`` and ``r_T = r_b(c) + Phi(c) eta``: the tip section in F_i."""
    eta = b.input("eta", (key.modes, 1))
    if key.order == EXACT:
        R_T = b.input("R_T", (3, 3)) if key.section_rotation else identity(3)
        return R_T, b.input("r_T", (3, 1))
    end = end_of_body(b, key) if key.elastic is not None else end_of_rod(b, key)
    moved = _with_slopes(b, key, "Phi_c", b.field("Phi_tip", end.Phi), _constants(b, "H", end.H), eta)
    r_T = b.step("r_T", end.place + moved)
    return _tip_rotation(b, key, end, eta), r_T


class End(NamedTuple):
    """The tip section of a body: its place and axes, undeformed, in F_i, and what the modes do to it."""

    place: Expression
    """(3, 1) m."""
    axes: Expression
    """(3, 3): takes tip-frame components to F_i."""
    Phi: np.ndarray
    """(3, r): displacement by each mode."""
    Psi: np.ndarray
    """(3, r): rotation vector by each mode."""
    H: Sequence[np.ndarray]
    """The (r, r) matrices of the second-order displacement along x, y, z; none at first order."""
    T: Sequence[np.ndarray]
    """Those of the second-order rotation vector."""


def end_of_rod(b: Block, key: LinkClass) -> End:
    """The tip section of a rod, or the tip of a rigid link."""
    whole: Expression = zeros(1)
    l: sp.Expr = sp.S.Zero
    if key.length:
        whole = symbol = length(b, key)
        l = b.values[symbol.name].item()
    fields = Fields(key, l, sp.S.Zero)
    second = [[at_tip(key, t, fields.length) for t in terms] if key.order == 2 else () for terms in quadratic_terms()]
    reach = whole if key.section_at == TIP else _place(b, key.section_at, whole)
    if key.frame_at:
        frame_at = b.parameter("frame_at", (1, 1))
        reach = b.step("reach", reach - frame_at)
    return End(reach @ unit(0), identity(3), fields.tip(), fields.rotation(), *second)


def _place(b: Block, s: float, whole: Expression) -> Expression:
    """The distance of a station from the base."""
    return zeros(1) if s == BASE else b.step("place", number(s) @ whole)


def end_of_body(b: Block, key: LinkClass) -> End:
    """The tip node of a body from a file."""
    assert key.elastic is not None
    tip, entries = key.elastic.tip, lambda x: np.array([numerals(row) for row in x], dtype=object)
    place = vector(numerals(tip.origin), r"\mathbf{r}_{b}(c_i)")
    axes = identity(3) if np.array_equal(tip.axes, np.eye(3)) else matrix(entries(tip.axes), (3, 3), r"\mathbf{A}_P")
    second = [[entries(part) for part in x] if key.order == 2 else () for x in (tip.phi2, tip.psi2)]
    return End(place, axes, entries(tip.phi), entries(tip.psi), *second)


def _with_slopes(b: Block, key: LinkClass, name: str, linear: Expression, H: list[Symbol], eta: Symbol) -> Expression:
    """Define the derivative with ``eta`` of a quantity of the tip, ``linear`` plus rows ``eta^T H_c``; returns it."""
    if key.order == 1:
        return b.step(name, linear) @ eta
    Gamma = b.step({"Phi_c": "Phi2", "Psi_c": "Psi2"}[name], rows(eta, H))
    b.step(name, linear + Gamma)
    return linear @ eta + halves(b, Gamma, H, eta)


def _constants(b: Block, letter: str, parts: Sequence[np.ndarray]) -> list[Symbol]:
    """The matrices ``H_c`` of the second-order shape at the tip, as steps; none at first order."""
    named = zip("xyz", parts, strict=False)
    return [b.step(f"{letter}_{c}", b.field(f"{letter}_{c}_tip", H), symmetric=True) for c, H in named]


def _bent(b: Block, name: str, letter: str, etadot: Symbol) -> Expression:
    """Define the rate of a second-order shape; returns its product with the modal rates."""
    parts = [b.symbol(f"{letter}_{c}") for c in "xyz"]
    b.step(name, rows(etadot, parts))
    return forms(b, f"forms {name}", parts, etadot)


def _tip_rotation(b: Block, key: LinkClass, end: End, eta: Symbol) -> Expression:
    if not key.section_rotation:
        return identity(3)
    Psi = b.field("Psi_tip", end.Psi)
    theta = b.step("theta", _with_slopes(b, key, "Psi_c", Psi, _constants(b, "T", end.T), eta))
    _, c1, c2, c3, square = angle_steps(b, theta, "x", r"\tilde{\boldsymbol{\theta}}_c^{2}", "tip section")
    b.step("J_l", identity(3) + c2 @ hat(theta) + c3 @ square)
    return b.step("R_T", (identity(3) + c1 @ hat(theta) + c2 @ square) @ end.axes)


def _turning(b: Block, key: LinkClass, etadot: Symbol) -> tuple[Expression, Expression]:
    """The section's angular velocity ``J_l thetadot`` relative to F_i, and its rate without ``etaddot``."""
    if not key.section_rotation:
        return zeros(3), zeros(3)
    theta = b.symbol("theta")
    thetadot = b.step("thetadot", b.symbol("Psi_c") @ etadot)
    turned = turning(b, theta, thetadot)
    omega_s = b.step("omega_s", turned)
    alpha_s = rate_of_turning(b, theta, thetadot, turned)
    if key.order == 2:
        alpha_s = alpha_s + b.symbol("J_l") @ _bent(b, "Psi2dot", "T", etadot)
    return omega_s, b.step("alpha_s", alpha_s)


def tip_body_block(key: LinkClass) -> Block:
    """The rigid bodies fixed to the tip section: their inertia and Newton-Euler bias at the tip twist."""
    b = Block("tip_body", "Bodies at the tip")
    omega = b.input("omega_T", (3, 1))
    v = b.input("v_T", (3, 1))
    g = b.input("g_T", (3, 1))
    m, S, _, I = lumped(b, key, "tip", "T")
    a_0 = b.step("a_T", hat(omega) @ v - g)
    b.step("h_T_tau", hat(S) @ a_0 + hat(omega) @ (I @ omega))
    b.step("h_T_F", m @ a_0 + hat(omega) @ (hat(omega) @ S))
    return b
