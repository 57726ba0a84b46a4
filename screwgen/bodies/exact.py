"""The rod whose kinematics are kept whole, ``R' = R hat(kappa)``, ``r' = R (e_x + gamma)`` (``order = "exact"``).

Strains are linear in the modal coordinates, as at any order; rotations and positions are not expanded. The rod is
collocated at Gauss points: :func:`section_block` steps from the section at one point to that at the next,
:func:`element_block` and :func:`spin_block` have the inertia there, and the equations of the link are sums over the
points. One block of each serves all points. :mod:`..algorithms.rod_sections` runs them along the rod.
"""

from __future__ import annotations

import numpy as np
import sympy as sp

from ..algebra.expression import (
    Expression,
    Inverse,
    Stumpff,
    Symbol,
    Trace,
    add,
    block,
    hat,
    identity,
    is_zero,
    stack,
    unit,
    zeros,
)
from ..algebra.rate import rate
from ..ir.block import Block
from ..spec.link_class import EXACT, LinkClass
from .collocation import collocation
from .fields import number
from .link import LinkBlock
from .rod import TURNED, RodBody
from .rotation import angle_steps


def section_block(key: LinkClass) -> Block:
    """From the section at one point to that at the next: rotation, its derivatives, and the tangent there.

    ``hat`` coordinates: modes in metres over the length. All in axes of F_i. Links of other orders have no steps.
    """
    b = Block("section", "Section of the rod")
    if key.order != EXACT:
        return b
    r = key.modes
    R_0, W_0 = b.input("R_0", (3, 3)), b.input("W_0", (3, r))
    w_0, b_0 = b.input("w_0", (3, 1)), b.input("b_0", (3, 1))
    turn, by_modes = b.input("theta", (3, 1)), b.input("theta_eta", (3, r))
    rate_of_turn, bend = b.input("thetadot", (3, 1)), b.input("theta_bend", (3, 1))
    along, stretch, stretched = b.input("tangent", (3, 1)), b.input("stretch", (3, r)), b.input("stretchdot", (3, 1))
    _, c1, c2, c3, square = angle_steps(b, turn, "x", "k", "turn from section to section")
    R = b.step("R_k", R_0 @ (identity(3) + c1 @ hat(turn) + c2 @ square))
    G = b.step("G_k", R_0 @ (identity(3) + c2 @ hat(turn) + c3 @ square))
    W = b.step("W_k", W_0 + G @ by_modes)
    turned = b.step("turn_k", G @ rate_of_turn)
    w = b.step("w_k", w_0 + turned)
    curved = _rate_of_tangent(b, turn, rate_of_turn)
    angular = b.step("b_k", b_0 + hat(w_0) @ turned + G @ bend + R_0 @ curved)
    t = b.step("t_k", R @ along)
    b.step("t_eta", R @ stretch - hat(t) @ W)
    lengthened = b.step("lengthened", R @ stretched)
    b.step("tdot", lengthened + hat(w) @ t)
    b.step("t_bend", hat(angular) @ t + hat(w) @ (hat(w) @ t + 2 * lengthened))
    return b


def _rate_of_tangent(b: Block, theta: Symbol, thetadot: Symbol) -> Expression:
    """The rate of the tangent operator ``I + c2 hat(theta) + c3 hat(theta)^2`` times ``thetadot``."""
    c2, c3 = b.symbol("c2"), b.symbol("c3")
    xdot = b.step("xdot", 2 * (theta.T @ thetadot))
    words = {"unit": "1/s", "meaning": "rate of the Stumpff function"}
    slopes = {
        f"c{k}": b.step(f"c{k}dot", rate(Stumpff(k, b.symbol("x")), {"x": xdot}), rf"\dot{{c}}_{k}", **words)
        for k in (2, 3)
    }
    operated = c2 @ (hat(theta) @ thetadot) + c3 @ (hat(theta) @ (hat(theta) @ thetadot))
    rates: dict[str, Expression] = {"theta": thetadot, **slopes}
    return b.step("G_bend", rate(operated, rates))


def element_block(key: LinkClass) -> Block:
    """A mass of the rod at a point of its centreline: what it adds to the sums of the link."""
    b = Block("element", "Mass of the rod at a point")
    if key.order != EXACT:
        return b
    r = key.modes
    dm, r_k, P = b.input("dm", (1, 1)), b.input("r_k", (3, 1)), b.input("P_k", (3, r))
    rdot, bend = b.input("rdot_k", (3, 1)), b.input("r_bend", (3, 1))
    omega, Omega = b.input("omega", (3, 1)), b.input("Omega", (3, 3))
    S = b.step("S_k", dm @ r_k)
    b.step("J_k", S @ r_k.T, symmetric=True)
    C = b.step("C_F", dm @ P)
    b.step("C_k", stack(hat(r_k) @ C, C))
    b.step("M_k", P.T @ C, symmetric=True)
    f = b.step("f_k", dm @ b.step("a_k", Omega @ r_k + 2 * (hat(omega) @ rdot) + bend))
    b.step("h_k", stack(hat(r_k) @ f, f))
    b.step("h_eta_k", P.T @ f)
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
    I, C, M, torques = [], [], [], []
    for axis in key.turned:
        words = {"unit": "kg*m^2", "meaning": f"inertia of the piece about axis {'xyz'[axis]} of its sections"}
        dI = b.input(f"dI_{axis}", (1, 1), rf"\mathrm{{d}}I_{{{'xyz'[axis]}k}}", **words)
        d = R @ unit(axis)
        j = b.step(f"j_{axis}", W.T @ d, rf"\mathbf{{j}}_{{{axis}}}", unit="-", meaning="turn about the axis by each mode")
        own = dI @ d
        I.append(own @ d.T)
        C.append(own @ j.T)
        M.append(j @ (dI @ j.T))
        torques.append(own @ (d.T @ nudot) + (d.T @ nu) @ (hat(nu) @ own))
    b.step("I_k", add(*I), symmetric=True)
    b.step("C_k", stack(add(*C), zeros(3, r)))
    b.step("M_k", add(*M), symmetric=True)
    torque = b.step("torque_k", add(*torques))
    b.step("h_k", stack(torque, zeros(3)))
    b.step("h_eta_k", W.T @ torque)
    return b


SUMS = {
    "element": {"S_k": "S_rod", "J_k": "J_rod", "C_k": "C_rod", "M_k": "M_rod", "h_k": "h_rod", "h_eta_k": "h_rod_eta"},
    "section_spin": {"I_k": "I_rod", "C_k": "C_rod", "M_k": "M_rod", "h_k": "h_rod", "h_eta_k": "h_rod_eta"},
}
"""What a mass and a section contribute, and the sum that takes it: the inputs of the link's equations."""


class ExactLinkBlock(LinkBlock):
    """The equations of a link over the sums of its masses and sections, which are inputs."""

    def _constants(self) -> None:
        super()._constants()
        masses(self, self.key, self.body)

    def _moments(self) -> None:
        r = self.key.modes
        self.S = self.step("S", self.input("S_rod", (3, 1)) + self.base[1])
        self.J = self.step("J", self.input("J_rod", (3, 3)) + self.base[2], symmetric=True)
        self.turned = self.input("I_rod", (3, 3)) if self.key.turned else zeros(3, 3)
        self.C, self.M = self.input("C_rod", (6, r)), self.input("M_rod", (r, r))
        self.h, self.h_modes = self.input("h_rod", (6, 1)), self.input("h_rod_eta", (r, 1))

    def _inertia(self) -> None:
        inertia = Trace(self.J) @ identity(3) - self.J + self.turned
        I = self.step("I", inertia, symmetric=True)
        M_V = self.step("M_V", block([I, hat(self.S)], [-hat(self.S), self.m @ identity(3)]), symmetric=True)
        self.step("M_DPsi", M_V - self.M_star, symmetric=True)
        self.step("M_D", self.C)
        self.step("M_Dphi", self.symbol("M_D").T)
        self.step("M_bent", self.M - self.symbol("M_Wphi"), symmetric=True)

    def _bias(self) -> None:
        omega, (m_B, S_B, J_B) = self.omega, self.base
        a_0 = self.step("a_0", hat(omega) @ self.vel - self.g)
        Omega = self._turn_operator()
        I_B = Trace(J_B) @ identity(3) - J_B
        spun = hat(omega) @ (I_B @ omega)
        rigid = add(spun, I_B @ self.alpha) if self.turning else spun
        own = zeros(6) if is_zero(J_B) and is_zero(S_B) else stack(rigid, Omega @ S_B)
        self.step("h_V", add(self.h, own, stack(hat(self.S) @ a_0, self.m @ a_0)))
        self.step("h_eta", self.h_modes + self.C.T @ stack(zeros(3), a_0))
        if not self.turning:
            self._modal_force()


    def twice_kinetic(self) -> Expression:
        """Twice the kinetic energy of the link and its base bodies, J."""
        V = stack(self.omega, self.vel)
        return add(V.T @ (self.symbol("M_V") @ V + 2 * (self.C @ self.etadot)), self.etadot.T @ (self.M @ self.etadot))


def masses(b: Block, key: LinkClass, body: RodBody) -> None:
    """The masses at points, and the inertia of the sections at the Gauss points, as steps of the link's block."""
    c, l = collocation(key), b.values[body.length.name].item()
    b.step("per_length", Inverse(body.length))
    at_points = lambda name, points: [l * number(w) * body.sampled(name, s) for s, w in points]  # noqa: E731
    b.step("dm", _at_points(b, "dm", at_points("rhoA", c.masses)))
    for axis in key.turned:
        words = {"unit": "kg*m^2", "meaning": f"inertia of the pieces about axis {'xyz'[axis]} of their sections"}
        values = at_points(TURNED[axis][0], c.sections)
        b.step(f"dI_{axis}", _at_points(b, f"dI_{axis}", values), rf"\mathrm{{d}}\mathbf{{I}}_{{{'xyz'[axis]}}}", **words)


def _at_points(b: Block, name: str, values: list[sp.Expr]) -> Symbol:
    return b.field(f"{name}_points", np.array([[x] for x in values], dtype=object), rf"\mathrm{{{name}}}(s_k)")


def link_block(key: LinkClass, turning: bool = False) -> LinkBlock:
    """The equations of a link, by its order."""
    return (ExactLinkBlock if key.order == EXACT else LinkBlock)(key, turning)
