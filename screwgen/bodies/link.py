"""The link block: M*, D*, H* and the modal rows of one flexible link, (26)-(34) and (72)-(89)."""

from __future__ import annotations

import numpy as np

from ..algebra.expression import Diagonal, Trace, add, block, hat, identity, stack, unit, zeros
from ..spec.link_class import LinkClass
from .link_constants import FRAME, LinkConstants


class LinkBlock(LinkConstants):
    """The block of one link class, written down in the order of the derivation.

    Field: an element at ξ sits at ``rho = r_b + Phi eta``; its velocity is ``v + omega x rho + udot``
    with ``udot = Phi etadot``, its acceleration ``vdot + omegadot x rho + Phi etaddot + a_0 + Omega rho
    + omega x udot + omega x udot``.  Inertia, weight and stress, paired with the element's own virtual
    velocity ``N nu`` with ``N = [-hat(rho), I, Phi]`` and integrated over the link, give the rows.

    With ``turning`` the bias is that of a link with an angular acceleration ``alpha``, which is an input: ``Omega`` is
    then ``hat(alpha) + hat(omega)^2``, and what ``M_V`` and ``M_D`` would add for ``alpha`` need not be formed.
    """

    def __init__(self, key: LinkClass, turning: bool = False):
        title = "Link, its angular acceleration given" if turning else "Link"
        super().__init__("turning_link" if turning else "link", title)
        self.key, self.turning = key, turning
        self._declare()
        self._constants()
        self._moments()
        self._inertia()
        self._bias()

    def _moments(self) -> None:
        """Moments of the deformed link, each named for the integrals that follow."""
        rhoA, rho, udot = self.rhoA, self.rho, self.udot
        self.S = self.step(
            "S", self.S_0 + self.sigma @ self.eta, r"\mathbf{S}", unit="kg*m", frame=FRAME, meaning="first moment"
        )
        self.Sdot = self.step(
            "Sdot",
            self.sigma @ self.etadot,
            r"\dot{\mathbf{S}}",
            unit="kg*m/s",
            frame=FRAME,
            meaning="rate of the first moment",
        )
        self._name_moment("S", (rho,))
        self._name_moment("Sdot", (udot,))
        self.step(
            "L",
            self.integral(rho @ self.phi_row, rhoA),
            r"\mathbf{L}",
            unit="kg*m",
            frame=FRAME,
            equation="85",
            meaning="first moment weighted by each mode shape",
            numbered=(1,),
        )
        self.step(
            "Ldot",
            self.integral(udot @ self.phi_row, rhoA),
            r"\dot{\mathbf{L}}",
            unit="kg*m/s",
            frame=FRAME,
            meaning="rate of L",
            numbered=(1,),
        )
        self._name_moment("L", (rho, self.phi_row))
        self._name_moment("Ldot", (udot, self.phi_row))
        J = self.integral(self.r_b @ self.u.T + self.u @ rho.T, rhoA)
        self.J = self.step(
            "J", self.J_0 + J, r"\mathbf{J}", unit="kg*m^2", frame=FRAME, symmetric=True, meaning="second moment"
        )
        self._name_moment("J", (rho, rho))

    def _inertia(self) -> None:
        """``M(eta)`` and its split into M*, M_DPsi and M_D."""
        inertia = Trace(self.J) @ identity(3) - self.J + self.spin
        I = self.step(
            "I",
            inertia,
            r"\mathbf{I}_{ib}",
            unit="kg*m^2",
            frame=FRAME,
            symmetric=True,
            meaning="inertia about the origin, deformed",
        )
        M_V = self.step(
            "M_V",
            block([I, hat(self.S)], [-hat(self.S), self.m @ identity(3)]),
            r"\mathbf{M}_V",
            unit="kg, kg*m, kg*m^2",
            frame=FRAME,
            symmetric=True,
            meaning="inertia in the twist rows",
        )
        self.step(
            "M_DPsi",
            M_V - self.M_star,
            r"\mathbf{M}_{D\Psi,i}",
            unit="kg, kg*m, kg*m^2",
            frame=FRAME,
            equation="B2",
            symmetric=True,
            meaning="what the deformation adds to M*",
        )
        coupling = (
            self.integral(stack(hat(self.rho) @ self.Phi, self.Phi), self.rhoA) if self.key.modes else zeros(6, 0)
        )
        M_D = self.step(
            "M_D",
            add(coupling, self._spin_coupling()),
            r"\mathbf{M}_{D,i}",
            unit="kg, kg*m",
            frame=FRAME,
            equation="B1",
            meaning="wrench that modal accelerations need",
            numbered=(1,),
        )
        self.step(
            "M_Dphi",
            M_D.T,
            r"\mathbf{M}_{D\phi,i}",
            unit="kg, kg*m",
            equation="85",
            meaning="modal force that the twist's rate needs",
            numbered=(0,),
        )

    def _spin_coupling(self):
        if not (self.key.spin and self.key.counts[3]):
            return zeros(6, self.key.modes)
        return stack(unit(0) @ self.sigma_t, zeros(3, self.key.modes))

    def _bias(self) -> None:
        """Gyroscopic terms, weight and stress: h_MD, H*, h_phi."""
        rho, udot, omega, rhoA = self.rho, self.udot, self.omega, self.rhoA
        a_0 = self.step(
            "a_0",
            hat(omega) @ self.vel - self.g,
            r"\mathbf{a}_0",
            unit="m/s^2",
            frame=FRAME,
            meaning="acceleration of the origin at rest rates, against free fall",
        )
        Omega, faster = self._turn_operator(), ", angular acceleration included" if self.turning else ""
        self.step(
            "B",
            self.integral(self.udot_modal @ rho.T, rhoA),
            r"\mathbf{B}",
            unit="kg*m^2/s",
            frame=FRAME,
            meaning="moment of the elastic velocity",
        )
        self._name_moment("B", (udot, rho))
        coriolis = hat(omega) @ udot
        half = self.integral(stack(hat(rho) @ coriolis, coriolis), rhoA) if self.key.modes else zeros(6)
        h_c = self.step("h_c", half, r"\mathbf{h}_c", unit="N*m, N", frame=FRAME, meaning="half of the Coriolis wrench")
        h_MD = self.step(
            "h_MD",
            add(h_c, self._spin_bias("sigma_t")),
            r"\mathbf{h}_{M_D,i}",
            unit="N*m, N",
            frame=FRAME,
            equation="B3",
            meaning="Coriolis wrench of the deformation's inertia",
        )
        field = a_0 + Omega @ rho
        rigid = self.integral(stack(hat(rho) @ field, field), rhoA)
        H = self.step(
            "H_star",
            add(rigid, h_c, self._spin_bias("I_s"), self._spun_up()),
            r"\mathbf{H}^*_{\alpha,i}" if self.turning else r"\mathbf{H}^*_i",
            unit="N*m, N",
            frame=FRAME,
            equation="" if self.turning else "29",
            meaning="gyroscopic wrench and weight" + faster,
        )
        display = r"\mathbf{h}_{V\alpha}" if self.turning else r"\mathbf{h}_{V}"
        self.step("h_V", H + h_MD, display, unit="N*m, N", frame=FRAME, meaning=f"bias of the twist rows{faster}")
        modal = self.Phi.T @ (field + 2 * coriolis)
        twisted = self.key.spin and self.key.counts[3] and self.turning
        self.step(
            "h_eta",
            add(
                self.integral(modal, rhoA) if self.key.modes else zeros(0),
                self.sigma_t.T @ self.entries(self.alpha)[0] if twisted else zeros(self.key.modes),
            ),
            r"\mathbf{h}_{\eta\alpha}" if self.turning else r"\mathbf{h}_{\eta}",
            unit="N",
            equation="" if self.turning else "88",
            meaning="gyroscopic force and weight on the modes" + faster,
        )
        if not self.turning:
            self._modal_force()

    def _turn_operator(self):
        """What takes a place to the acceleration that the link's turning gives it."""
        if not self.turning:
            return self.step(
                "Omega",
                hat(self.omega) @ hat(self.omega),
                r"\tilde{\boldsymbol{\omega}}_i^{2}",
                unit="1/s^2",
                frame=FRAME,
                symmetric=True,
                meaning="centripetal operator",
            )
        meaning = "angular acceleration of the link"
        self.alpha = self.input("alpha", (3, 1), r"\boldsymbol{\alpha}_i", "rad/s^2", FRAME, meaning)
        return self.step(
            "Omega",
            hat(self.alpha) + hat(self.omega) @ hat(self.omega),
            r"\boldsymbol{\Omega}_i",
            unit="1/s^2",
            frame=FRAME,
            meaning="acceleration of a place by the link's turning",
        )

    def _spun_up(self):
        """The wrench that the spin inertia of the sections needs for ``alpha``."""
        if not (self.key.spin and self.turning):
            return zeros(6)
        return stack(unit(0) @ (self.I_s @ self.entries(self.alpha)[0]), zeros(3))

    def _modal_force(self) -> None:
        stress = Diagonal(self.K) @ self.eta
        if self.key.damping:
            stress = stress + Diagonal(self.D) @ self.etadot
        f = self.step("f_eta", stress, r"\mathbf{f}_{\eta}", unit="N", equation="88", meaning="stress and damping")
        h_eta = self.symbol("h_eta")
        self.step("h_phi", h_eta + f, r"\mathbf{h}_{\phi,i}", unit="N", equation="88", meaning="bias of the modal rows")

    def _spin_bias(self, which: str):
        """``rho I_p ∫(n^T nu) dξ (omega x e_x)``: of the link's own turn (I_s) or of its torsion (sigma_t)."""
        omega_x = self.entries(self.omega)[0]
        axis = hat(self.omega) @ unit(0)
        if not self.key.spin or (which == "sigma_t" and not self.key.counts[3]):
            return zeros(6)
        momentum = self.I_s @ omega_x if which == "I_s" else self.sigma_t @ self.etadot
        return stack(momentum @ axis, zeros(3))

    def _name_moment(self, moment: str, generators: tuple) -> None:
        """Let the entries of a step stand for the integrals of the products of its generators."""
        values, first = self.values[moment], self.values[generators[0].name][:, 0]
        if len(generators) == 1:
            for i, generator in enumerate(first):
                self.fields.name_moment("rhoA", values[i, 0], generator)
            return
        for (i, j), value in np.ndenumerate(values):
            second = self.values[generators[1].name].ravel()[j]
            if second != 0:
                self.fields.name_moment("rhoA", value, first[i], second)
