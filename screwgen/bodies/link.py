"""The link block: M*, D*, H* and the modal rows of one link, (26)-(34) and (72)-(89), over its body's invariants."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

import numpy as np

from ..algebra.expression import (
    Expression,
    Integral,
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
from ..ir.block import Block
from ..spec.link_class import LinkClass
from .contract import LinkBody, RigidMoments, RotaryInertia
from .coupled_rod import CoupledRod
from .lumped import lumped
from .reduced import ReducedBody
from .rigid import RigidBody
from .rod import RodBody
from .varying_rod import VaryingRod


def _moment(columns: int, *moments: Expression) -> Expression:
    """The wrenches with the sum of these moments and without force."""
    moment = add(zeros(3, columns), *moments)
    return zeros(6, columns) if is_zero(moment) else stack(moment, zeros(3, columns))


WITH_HALF = "gyroscopic wrench and weight, with half of the Coriolis wrench"
"""What H* is of a link that bends."""


class LinkBlock(Block):
    """The block of one link class, written down in the order of the derivation.

    An element at ξ has the position ``rho = r_b + Phi eta``; its velocity is ``v + omega x rho + udot``
    with ``udot = Phi etadot``, its acceleration ``vdot + omegadot x rho + Phi etaddot + a_0 + Omega rho
    + omega x udot + omega x udot``.  The rows are the virtual power of inertia, weight and stress, with the
    virtual velocity ``N nu``, ``N = [-hat(rho), I, Phi]``, integrated over the link.

    With ``turning`` the bias force includes a given angular acceleration ``alpha``, an input: ``Omega`` is then
    ``hat(alpha) + hat(omega)^2``. This is cheaper than the products of ``M_V`` and ``M_D`` with ``alpha``.
    """

    def __init__(self, key: LinkClass, turning: bool = False):
        title = "Link, its angular acceleration given" if turning else "Link"
        super().__init__("turning_link" if turning else "link", title)
        self.key, self.turning = key, turning
        self._declare()
        self.body: LinkBody = self._body()
        self.start = self._start()
        self.body.declare(self.start)
        self._constants()
        self._moments()
        self._inertia()
        self._bias()

    def _declare(self) -> None:
        r, state = self.key.modes, self.input
        self.omega = state("omega", (3, 1))
        self.vel = state("v", (3, 1))
        self.g = state("g", (3, 1))
        self.eta = state("eta", (r, 1))
        self.etadot = state("etadot", (r, 1))
        self.rho = self.generators("rho")
        self.udot = self.generators("udot")

    def _body(self) -> LinkBody:
        if self.key.elastic is not None:
            return ReducedBody(self, self.key)
        if not self.key.beam:
            return RigidBody(self)
        if self.key.stations:
            return VaryingRod(self, self.key)
        return CoupledRod(self, self.key) if self.key.coupled else RodBody(self, self.key)

    def _start(self) -> Expression:
        """The place of the joint on the centreline of F_i."""
        if not self.key.frame_at:
            return zeros(1)
        return self.step("start", -self.parameter("frame_at", (1, 1)))

    def integral(self, integrand: Expression) -> Integral:
        """``∫ρA integrand dξ`` over the body."""
        return Integral(integrand, self.body.rhoA, self.body.fields.integrate)

    def _constants(self) -> None:
        m_B, S_B, J_B = self.base = self._base_bodies()
        mu, S, J = self.body.moments()
        self.m = self.step("m", mu + m_B)
        self.S_0 = self.step("S_0", S + S_B)
        self.J_0 = self.step("J_0", J + J_B, symmetric=True)
        self.spin = self.body.spin()
        I_0 = self.step("I_0", Trace(self.J_0) @ identity(3) - self.J_0 + self.spin, symmetric=True)
        self.M_star = self.step(
            "M_star", block([I_0, hat(self.S_0)], [-hat(self.S_0), self.m @ identity(3)]), symmetric=True
        )
        self.body.fields.name_moment("rhoA", self.values["m"].item())
        self.body.modal()

    def _base_bodies(self) -> tuple[Expression, Expression, Expression]:
        """Moments of the base bodies about the origin of F_i, shifted from the joint point if the two differ."""
        m, S, J, _ = lumped(self, self.key, "base", "B")
        if self.key.body is not None:
            given = cast(RigidMoments, self.key.body)
            m, S, J = (add(*pair) for pair in zip((m, S, J), given.moments(self), strict=True))
        elif not (self.key.frame_at and self.key.bodies_at("base")):
            return m, S, J
        r_B = self.start @ unit(0)
        shifted = J + r_B @ S.T + S @ r_B.T + m @ (r_B @ r_B.T)
        return m, S + m @ r_B, shifted

    def _moments(self) -> None:
        """Moments of the deformed link, each named for the integrals that follow."""
        rho, udot, r = self.rho, self.udot, self.key.modes
        displaced, rate = self.body.displaced(self.eta, self.etadot)
        self.S = self.step("S", self.S_0 + displaced)
        self.step("Sdot", rate)
        self._name_moment("S", (rho,))
        self._name_moment("Sdot", (udot,))
        self.step("L", self.integral(rho @ self.body.phi_row) if r else zeros(3, 0))
        self.step("Ldot", self.integral(udot @ self.body.phi_row) if r else zeros(3, 0))
        if r:
            self._name_moment("L", (rho, self.body.phi_row))
            self._name_moment("Ldot", (udot, self.body.phi_row))
        J = self.J_0 + self.integral(self.body.r_b @ self.body.u.T + self.body.u @ rho.T) if r else self.J_0
        self.J = self.step("J", J, symmetric=True)
        self._name_moment("J", (rho, rho))

    def _inertia(self) -> None:
        """``M(eta)`` and its split into M*, M_DPsi and M_D."""
        inertia = Trace(self.J) @ identity(3) - self.J + self.spin
        I = self.step("I", inertia, symmetric=True)
        M_V = self.step("M_V", block([I, hat(self.S)], [-hat(self.S), self.m @ identity(3)]), symmetric=True)
        self.step("M_DPsi", M_V - self.M_star, symmetric=True)
        M_D = self.step("M_D", self._coupling())
        self.step("M_Dphi", M_D.T)
        self.step("M_bent", self._added_inertia(), symmetric=True)

    def _coupling(self) -> Expression:
        """(6, r): the wrench that modal accelerations need."""
        moved = self.body.moved
        coupling = self.integral(stack(hat(self.rho) @ moved, moved)) if self.key.modes else zeros(6, 0)
        return add(coupling, _moment(self.key.modes, *(unit(t.axis) @ t.momentum for t in self.body.turnings)))

    def _added_inertia(self) -> Expression:
        """(r, r): what bending adds to the inertia of the modes; shapes that are expanded leave it as it is."""
        return zeros(self.key.modes, self.key.modes)

    def _bias(self) -> None:
        """Gyroscopic terms, weight and stress: h_MD, H*, h_phi."""
        rho, udot, omega = self.rho, self.udot, self.omega
        a_0 = self.step("a_0", hat(omega) @ self.vel - self.g)
        Omega = self._turn_operator()
        self.step("B", self.integral(self.body.udot_modal @ rho.T) if self.key.modes else zeros(3, 3))
        self._name_moment("B", (udot, rho))
        coriolis = hat(omega) @ udot
        half = self.integral(stack(hat(rho) @ coriolis, coriolis)) if self.key.modes else zeros(6)
        h_c = self.step("h_c", half)
        bend = self.body.bend
        curved = zeros(6) if is_zero(bend) else self.integral(stack(hat(rho) @ bend, bend))
        h_MD = self.step("h_MD", add(h_c, self._turned(lambda t: t.momentum @ self.etadot), curved))
        field = a_0 + Omega @ rho
        rigid = self.integral(stack(hat(rho) @ field, field))
        omegas = self.entries(omega)
        spinning = self._turned(lambda t: t.inertia @ omegas[t.axis])
        meaning = WITH_HALF if self.key.modes and not self.turning else None
        H = self.step("H_star", add(rigid, h_c, spinning, self._spun_up()), meaning=meaning)
        self.step("h_V", H + h_MD)
        modal = self.integral(self.body.moved.T @ (field + 2 * coriolis)) if self.key.modes else zeros(0)
        alphas = self.entries(self.alpha) if self.turning else []
        turned = (t.momentum.T @ alphas[t.axis] for t in self.body.turnings if self.turning and not is_zero(t.momentum))
        self.step("h_eta", add(modal, *turned))
        if not self.turning:
            self._modal_force()

    def _turn_operator(self) -> Symbol:
        """The operator from a position to its acceleration by the link's rotation."""
        centripetal = hat(self.omega) @ hat(self.omega)
        if not self.turning:
            return self.step("Omega", centripetal, symmetric=True)
        self.alpha = self.input("alpha", (3, 1))
        return self.step("Omega", hat(self.alpha) + centripetal)

    def twice_kinetic(self) -> Expression:
        """Twice the kinetic energy of the link and its base bodies, J."""
        velocity = self.vel + hat(self.omega) @ self.rho + self.udot
        return add(self.integral(velocity.T @ velocity), self.body.own_energy(self.omega, self.etadot))

    def _spun_up(self) -> Expression:
        """The inertial wrench of the sections' own inertia at ``alpha``."""
        if not self.turning:
            return zeros(6)
        alphas = self.entries(self.alpha)
        return _moment(1, *(unit(t.axis) @ (t.inertia @ alphas[t.axis]) for t in self.body.turnings))

    def _modal_force(self) -> None:
        stress = self.body.stiffness @ self.eta
        if self.key.damping:
            stress = stress + self.body.resistance @ self.etadot
        self.step("h_phi", self.symbol("h_eta") + self.step("f_eta", stress))

    def _turned(self, momentum: Callable[[RotaryInertia], Expression]) -> Expression:
        """``omega x l`` of the sections' own angular momentum ``l``, given about each axis."""
        return _moment(1, *(momentum(t) @ (hat(self.omega) @ unit(t.axis)) for t in self.body.turnings))

    def _name_moment(self, moment: str, generators: tuple) -> None:
        """Let the entries of a step stand for the integrals of the products of its generators."""
        values, first = self.values[moment], self.values[generators[0].name][:, 0]
        if len(generators) == 1:
            for i, generator in enumerate(first):
                self.body.fields.name_moment("rhoA", values[i, 0], generator)
            return
        for (i, j), value in np.ndenumerate(values):
            second = self.values[generators[1].name].ravel()[j]
            if second != 0:
                self.body.fields.name_moment("rhoA", value, first[i], second)
