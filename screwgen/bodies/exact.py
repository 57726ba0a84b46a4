"""The rod whose kinematics are kept whole, ``R' = R hat(kappa)``, ``r' = R (e_x + gamma)`` (``order = "exact"``).

Strains are linear in the modal coordinates, as at any order; rotations and positions are not expanded. The rod is
collocated at Gauss points: :func:`section_block` steps from the section at one point to that at the next,
:func:`element_block` and :func:`spin_block` have the inertia there, :func:`load_block` what acts on the modes, and the
equations of the link are sums over the points. One block of each serves all points.
:mod:`..algorithms.rod_sections` runs them along the rod.
"""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from ..algebra.expression import (
    Expression,
    Inverse,
    Symbol,
    Trace,
    add,
    hat,
    identity,
    is_zero,
    matrix,
    stack,
    unit,
    zeros,
)
from ..ir.block import Block
from ..lazily import sp
from ..spec.link_class import EXACT, LinkClass
from .collocation import collocation
from .fields import number
from .link import LinkBlock
from .rod import TURNED, RodBody
from .rotation import angle_steps, rate_of_turning, turning


def section_block(key: LinkClass) -> Block:
    """From the section at one point to that at the next: rotation, its derivatives, and the tangent there.

    In axes of F_i; derivatives are those with modal coordinates of unit length, modes in metres over the length.
    Links of other orders have no steps.
    """
    b = Block("section", "Section of the rod")
    if key.order != EXACT:
        return b
    r = key.modes
    R_0, W_0 = b.input("R_0", (3, 3)), b.input("W_0", (3, r))
    w_0, b_0 = b.input("w_0", (3, 1)), b.input("b_0", (3, 1))
    turn, by_modes = b.input("theta", (3, 1)), b.input("theta_eta", (3, r))
    rate_of_turn, bend = b.input("thetadot", (3, 1)), b.input("theta_bend", (3, 1))
    along, stretch = b.input("tangent", (3, 1)), b.input("stretch", (3, r))
    stretched, restretched = b.input("stretchdot", (3, 1)), b.input("stretchddot", (3, 1))
    _, c2, c3, square = angle_steps(b, turn, "x", r"\mathbf{Q}_k", "turn from section to section", (2, 3))
    G = b.step("G_k", R_0 @ (identity(3) + c2 @ hat(turn) + c3 @ square))
    R = b.step("R_k", R_0 + G @ hat(turn))  # exp(hat(a)) = I + J_l(a) hat(a)
    W = b.step("W_k", W_0 + G @ by_modes)
    turned = b.step("turn_k", G @ rate_of_turn)
    w = b.step("w_k", w_0 + turned)
    curved = b.step("G_bend", rate_of_turning(b, turn, rate_of_turn, turning(b, turn, rate_of_turn)))
    angular = b.step("b_k", b_0 + hat(w_0) @ turned + G @ bend + R_0 @ curved)
    t = b.step("t_k", R @ along)
    b.step("t_eta", R @ stretch - hat(t) @ W)
    lengthened = b.step("lengthened", R @ stretched)
    b.step("tdot", lengthened + hat(w) @ t)
    b.step("t_bend", hat(angular) @ t + hat(w) @ (hat(w) @ t + 2 * lengthened) + R @ restretched)
    return b


def element_block(key: LinkClass) -> Block:
    """A mass of the rod: what it adds to the sums of the link, about the base of the rod and per mass of the rod."""
    b = Block("element", "Mass of the rod")
    if key.order != EXACT:
        return b
    r = key.modes
    share, r_k, P = b.input("share", (1, 1)), b.input("r_k", (3, 1)), b.input("P_k", (3, r))
    a, u = b.input("a_k", (3, 1)), b.input("u_k", (3, 1))
    S, C = b.step("S_k", share @ r_k), b.step("C_F", share @ P)
    b.step("J_k", S @ r_k.T, symmetric=True)
    b.step("C_k", hat(r_k) @ C)
    b.step("M_k", P.T @ C, symmetric=True)
    b.step("tau_k", hat(S) @ a)
    b.step("K_k", share @ (u.T @ u))
    return b


def spin_block(key: LinkClass) -> Block:
    """The inertia of a section about axes of its own, at a Gauss point: what it adds to the sums of the link."""
    b = Block("section_spin", "Inertia of a section")
    if key.order != EXACT or not key.turned:
        return b
    r = key.modes
    R, W = b.input("R_k", (3, 3)), b.input("W_k", (3, r))
    w, bend = b.input("w_k", (3, 1)), b.input("b_k", (3, 1))
    omega, alpha = b.input("omega", (3, 1)), b.input("alpha", (3, 1))
    nu = b.step("nu_k", omega + w)
    nudot = b.step("nudot_k", alpha + hat(omega) @ w + bend)
    I, C, M, torques, energies = [], [], [], [], []
    for axis in key.turned:
        words: dict[str, Any] = {
            "unit": "kg*m^2",
            "meaning": f"inertia of the piece about axis {'xyz'[axis]} of its sections",
        }
        dI = b.input(f"dI_{axis}", (1, 1), rf"\mathrm{{d}}I_{{{'xyz'[axis]}k}}", **words)
        d = R @ unit(axis)
        words = {"unit": "-", "meaning": f"turn about axis {'xyz'[axis]} of the section by each mode"}
        j = b.step(f"j_{axis}", W.T @ d, rf"\mathbf{{j}}_{{{'xyz'[axis]},k}}", **words)
        own = dI @ d
        I.append(own @ d.T)
        C.append(own @ j.T)
        M.append(j @ (dI @ j.T))
        along = d.T @ nu
        torques.append(own @ (d.T @ nudot) + along @ (hat(nu) @ own))
        energies.append(dI @ (along @ along))
    b.step("I_k", add(*I), symmetric=True)
    b.step("C_s_k", add(*C))
    b.step("M_s_k", add(*M), symmetric=True)
    b.step("tau_s_k", add(*torques))
    b.step("K_s_k", add(*energies))
    return b


def load_block(key: LinkClass) -> Block:
    """What forces on the tangents and moments on the sections do to the modes, from the tip to the base.

    The power of a force ``f`` on a tangent and of a moment ``tau`` on a section: each turn carries the moments of all
    sections behind it.
    """
    b = Block("section_load", "Load of a section on the modes")
    if key.order != EXACT:
        return b
    r = key.modes
    R, G, t = b.input("R_k", (3, 3)), b.input("G_k", (3, 3)), b.input("t_k", (3, 1))
    by_modes, stretch = b.input("theta_eta", (3, r)), b.input("stretch", (3, r))
    behind, tau, f = b.input("m_1", (3, 1)), b.input("tau_s_k", (3, 1)), b.input("f_k", (3, 1))
    m = b.step("m_k", behind + tau + hat(t) @ f)
    b.step("h_eta_k", by_modes.T @ (G.T @ m) + stretch.T @ (R.T @ f))
    return b


SUMS = {
    "element": {"J_k": "J_rod", "C_k": "C_rod", "M_k": "M_rod", "tau_k": "tau_rod", "K_k": "K_rod"},
    "section_spin": {"I_k": "I_spin", "C_s_k": "C_spin", "M_s_k": "M_spin", "tau_s_k": "tau_spin", "K_s_k": "K_spin"},
    "section_load": {"h_eta_k": "h_rod"},
}
"""What a mass and a section contribute, and the sum that takes it: the inputs of the link's equations."""


class ExactLinkBlock(LinkBlock):
    """The equations of a link over the sums along its rod, which are inputs: those per mass, about the rod's base."""

    def _constants(self) -> None:
        super()._constants()
        if self.key.rest:
            self.step("kappa_0", cast(RodBody, self.body).length @ rest_curvature(self, self.key))
        masses(self, self.key, cast(RodBody, self.body))

    def _moments(self) -> None:
        r, mu = self.key.modes, self.symbol("mu")
        self.a_B = self._acceleration_of_base()
        s: Expression = self.step("S_rod", mu @ self.input("r_rod", (3, 1)))
        C_F = self.step("F_rod", mu @ self.input("P_rod", (3, r)))
        J, C = mu @ self.input("J_rod", (3, 3)), mu @ self.input("C_rod", (3, r))
        f = self.step("f_rod", mu @ (self.a_B + self.input("a_rod", (3, 1))))
        tau = hat(s) @ self.a_B + mu @ self.input("tau_rod", (3, 1))
        M = mu @ self.input("M_rod", (r, r))
        if not is_zero(self.start):
            offset = self.start @ unit(0)
            s, first = s + mu @ offset, s
            J = J + offset @ first.T + first @ offset.T + mu @ (offset @ offset.T)
            C, tau = C + hat(offset) @ C_F, tau + hat(offset) @ f
        self.spin = zeros(3, 3)
        if self.key.turned:
            self.spin = self.input("I_spin", (3, 3))
            C, tau = C + self.input("C_spin", (3, r)), tau + self.input("tau_spin", (3, 1))
            M = M + self.input("M_spin", (r, r))
        _, S_B, J_B = self.base
        self.S = self.step("S", s + S_B)
        self.J = self.step("J", J + J_B, symmetric=True)
        self.coupling, self.modal_inertia, self.wrench = stack(C, C_F), M, stack(tau, f)

    def _acceleration_of_base(self) -> Expression:
        """That of the rod's base at constant rates, less free fall."""
        self.step("a_0", hat(self.omega) @ self.vel - self.g)
        self._turn_operator()
        if is_zero(self.start):
            return self.symbol("a_0")
        return self.step("a_start", self.symbol("a_0") + self.symbol("Omega") @ (self.start @ unit(0)))

    def _coupling(self) -> Expression:
        return self.coupling

    def _added_inertia(self) -> Expression:
        return self.step("M_rod_eta", self.modal_inertia, symmetric=True) - self.symbol("M_Wphi")

    def _bias(self) -> None:
        (m_B, S_B, _), omega, a_0, Omega = self.base, self.omega, self.symbol("a_0"), self.symbol("Omega")
        turned = hat(omega) @ (self._base_inertia @ omega)
        if self.turning:
            turned = turned + self._base_inertia @ self.alpha
        bodies = stack(add(hat(S_B) @ a_0, turned), add(m_B @ a_0, Omega @ S_B))
        self.step("h_V", add(self.wrench, bodies) if self._carries_at_base() else self.wrench)
        self.step("h_eta", self.input("h_rod", (self.key.modes, 1)))
        if not self.turning:
            self._modal_force()

    def twice_kinetic(self) -> Expression:
        """Twice the kinetic energy of the link and its base bodies, J."""
        omega, v, (m_B, S_B, _) = self.omega, self.vel, self.base
        start = v if is_zero(self.start) else v + hat(omega) @ (self.start @ unit(0))
        rod = start.T @ (start + 2 * self.input("u_rod", (3, 1))) + self.input("K_rod", (1, 1))
        spun = self.input("K_spin", (1, 1)) if self.key.turned else zeros(1)
        bodies = v.T @ (m_B @ v + 2 * (hat(omega) @ S_B)) + omega.T @ (self._base_inertia @ omega)
        return add(self.symbol("mu") @ rod, spun, bodies if self._carries_at_base() else zeros(1))

    @property
    def _base_inertia(self) -> Expression:
        """(3, 3): that of the base bodies about the origin."""
        J_B = self.base[2]
        return Trace(J_B) @ identity(3) - J_B

    def _carries_at_base(self) -> bool:
        return bool(self.key.bodies_at("base") or self.key.body)


def rest_curvature(b: Block, key: LinkClass) -> Expression:
    """(p, 1): the numbers of the curvature at rest, direction by direction, which are parameters."""
    parts: list[Expression] = []
    for direction in key.rest:
        if key.rest_at:
            parts.append(b.parameter(f"rest_at_{direction}", (len(key.rest_at), 1), numbered=(0,)))
        else:
            parts.append(b.parameter(f"rest_{direction}", (1, 1)))
    return stack(*parts) if len(parts) > 1 else parts[0]


def masses(b: Block, key: LinkClass, body: RodBody) -> None:
    """The masses at points, and the inertia of the sections at the Gauss points, as steps of the link's block.

    Of a uniform rod the masses are known.
    """
    c, l = collocation(key), b.values[body.length.name].item()
    if c.masses is not None:
        dm = b.step("dm", _at_points(b, "dm", [l * number(w) * body.sampled("rhoA", s) for s, w in c.masses]))
        b.step("shares", dm @ Inverse(b.symbol("mu")))
        centre = matrix_of(np.array([c.reach(s) for s, _ in c.masses]).T, r"[c_{km}]")
        b.step("centre", centre @ b.symbol("shares"))
    for axis in key.turned:
        words: dict[str, Any] = {
            "unit": "kg*m^2",
            "meaning": f"inertia of the pieces about axis {'xyz'[axis]} of their sections",
        }
        values = [l * x for x in body.shared(TURNED[axis][0])]
        display = rf"\mathrm{{d}}\mathbf{{I}}_{{{'xyz'[axis]}}}"
        b.step(f"dI_{axis}", _at_points(b, f"dI_{axis}", values), display, **words)


def matrix_of(values: np.ndarray, display: str) -> Expression:
    """A matrix of numbers."""
    return matrix([[number(x) for x in row] for row in values], values.shape, display)


def _at_points(b: Block, name: str, values: list[sp.Expr]) -> Symbol:
    return b.field(f"{name}_points", np.array([[x] for x in values], dtype=object), rf"\mathrm{{{name}}}(s_k)")


def link_block(key: LinkClass, turning: bool = False) -> LinkBlock:
    """The equations of a link, by its order."""
    return (ExactLinkBlock if key.order == EXACT else LinkBlock)(key, turning)
