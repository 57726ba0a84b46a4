"""How the tip section turns with the modes: its shapes and their rates, and a held load on shapes that change."""

from __future__ import annotations

from dataclasses import dataclass

from ..ir.derivative import stumpff_slope, tangents
from ..ir.program import Array, Node
from ..spec.link_class import EXACT
from . import matrices as mx
from .phases import tip_state
from .rod_sections import held
from .scope import Scope


@dataclass
class Turning:
    """The tip section's turn relative to F_i: ``J_l`` and its rates, times ``Psi_c``; its angular velocity."""

    phi: Array
    phidot: Array
    phiddot: Array
    omega_s: Array


def turning(s: Scope) -> Turning:
    """The rotation's columns ``phi_k = J_l Psi_k`` with two time derivatives, and the relative motion."""
    r = s.key.modes
    if not s.key.section_rotation:
        return Turning(mx.zeros(3, r), mx.zeros(3, r), mx.zeros(3, r), mx.zeros(3))
    if s.key.order == EXACT:  # rates are found where the tip's motion is differentiated
        Psi, omega_s = s.lower("tip", tip_state(s, mx.zeros(6)), "Psi_c", "omega_s")
        return Turning(Psi, mx.zeros(3, r), mx.zeros(3, r), omega_s)
    names = "theta thetadot x xdot c2 c3 c2dot c3dot J_l Psi_c omega_s".split()
    values = dict(zip(names, s.lower("tip", tip_state(s, mx.zeros(6)), *names), strict=True))
    Psi, J = values["Psi_c"], values["J_l"]
    with s.step("turn of the section: J_l and its two rates on every mode, relative acceleration"):
        Psidot, Psiddot = shape_rates(s, "Psi2dot")
        thetaddot = mx.multiply(Psi, s.read("etaddot")) + mx.multiply(Psidot, s.read("etadot"))
        Jdot, Jddot = _rates_of_J(s, values, thetaddot)
        phidot = mx.multiply(Jdot, Psi) + mx.multiply(J, Psidot)
        phiddot = mx.multiply(Jddot, Psi) + 2.0 * mx.multiply(Jdot, Psidot) + mx.multiply(J, Psiddot)
        return Turning(mx.multiply(J, Psi), phidot, phiddot, values["omega_s"])


def shape_rates(s: Scope, name: str) -> tuple[Array, Array]:
    """The first and second time derivative of the tip's shapes ``Phi_c`` or ``Psi_c`` at second order.

    They are linear in the modal coordinates, so the second has the modal accelerations where the first has the rates.
    """
    if s.key.order != 2:
        return mx.zeros(3, s.key.modes), mx.zeros(3, s.key.modes)
    state = tip_state(s, mx.zeros(6))
    first, second = (s.lower("tip", state | {"etadot": s.read(rate)}, name)[0] for rate in ("etadot", "etaddot"))
    return first, second


def held_load(s: Scope, moment: Array, force: Array) -> Array:
    """How a moment and a force, held at the tip, change the modal forces by the change of the shapes: (r, r)."""
    if s.key.order == 1:
        return mx.zeros(s.key.modes, s.key.modes)
    state = tip_state(s, mx.zeros(6))
    if s.key.order == EXACT:
        with s.step("shapes of the tip: a held load on their change with the modes"):
            forces, still = held(s, state, moment, force), {x: 0.0 for x in (*moment, *force) if isinstance(x, Node)}
            slopes = [tangents(forces, {**still, x: 1.0}) for x in s.read("eta")]
            return mx.array(slopes, (s.key.modes,) * 2).T
    parts = [(force, s.lower("tip", state, "H_x", "H_y", "H_z"))]
    if s.key.section_rotation:
        J, *turned = s.lower("tip", state, "J_l", "T_x", "T_y", "T_z")
        parts.append((mx.multiply(J.T, moment), turned))
    with s.step("shapes of the tip: a held load on their change with the modes"):
        loaded = (H * x for load, rows in parts for H, x in zip(rows, load, strict=True))
        return sum(loaded, mx.zeros(s.key.modes, s.key.modes))


def _rates_of_J(s: Scope, t: dict[str, Array], thetaddot: Array) -> tuple[Array, Array]:
    """First and second time derivative of ``J_l = 1 + c2 hat(theta) + c3 hat(theta)^2``."""
    c3, c4, c5, c6, c7 = _stumpff(s, t)
    d2, d3 = c4 - 0.5 * c3, 1.5 * c5 - 0.5 * c4
    d4, d5 = stumpff_slope(4, c5, c6), stumpff_slope(5, c6, c7)
    theta, thetadot, xdot = t["theta"], t["thetadot"], t["xdot"].item()
    c2, c2dot, c3dot = t["c2"].item(), t["c2dot"].item(), t["c3dot"].item()
    xddot = 2.0 * (mx.dot(thetadot, thetadot) + mx.dot(theta, thetaddot))
    c2ddot = xdot * xdot * (d4 - 0.5 * d3) + xddot * d2
    c3ddot = xdot * xdot * (1.5 * d5 - 0.5 * d4) + xddot * d3
    h, hdot, hddot = mx.hat(theta), mx.hat(thetadot), mx.hat(thetaddot)
    square, mixed = mx.multiply(h, h), mx.multiply(h, hdot)
    squaredot = mixed + mixed.T
    last = mx.multiply(h, hddot)
    squareddot = last + last.T + 2.0 * mx.multiply(hdot, hdot)
    Jdot = c2dot * h + c2 * hdot + c3dot * square + c3 * squaredot
    Jddot = c2ddot * h + 2.0 * c2dot * hdot + c2 * hddot + c3ddot * square + 2.0 * c3dot * squaredot + c3 * squareddot
    return Jdot, Jddot


def _stumpff(s: Scope, t: dict[str, Array]) -> list:
    x = t["x"].item()
    return [t["c3"].item(), *(s.tracer.call(f"c{k}", x) for k in (4, 5, 6, 7))]


def turned_moment(s: Scope, moment: Array) -> Array:
    """``d(phi_l . moment)/d eta_k`` for a constant moment: (r, r), row l, column k."""
    if not s.key.section_rotation or s.key.order == EXACT:
        return mx.zeros(s.key.modes, s.key.modes)
    names = ("theta", "x", "c2", "c3", "Psi_c")
    t = dict(zip(names, s.lower("tip", tip_state(s, mx.zeros(6)), *names), strict=True))
    x, c2, c3, theta = t["x"].item(), t["c2"].item(), t["c3"].item(), t["theta"]
    with s.step("turn of the section: a held moment on the turning axes of the modes"):
        c4, c5 = s.tracer.call("c4", x), s.tracer.call("c5", x)
        once = mx.cross(theta, moment)
        slope = (3.0 * c5 - c4) * mx.cross(theta, once) - (2.0 * c4 - c3) * once
        H = mx.multiply(slope[:, None], theta[None, :]) + c2 * mx.hat(moment)
        H = H - c3 * (mx.hat(once) + mx.multiply(mx.hat(theta), mx.hat(moment)))
        return mx.chain(t["Psi_c"].T, H, t["Psi_c"])
