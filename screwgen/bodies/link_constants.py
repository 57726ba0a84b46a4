"""What of a link follows from its parameters alone: mass, moments, stiffness, damping, M*."""

from __future__ import annotations

import numpy as np
import sympy as sp

from ..algebra.expression import Expression, Trace, block, hat, identity, unit, zeros
from .fields import AXIS, XI, Fields
from .link_stiffness import LinkStiffness
from .lumped import lumped

FRAME = "F_i"


class LinkConstants(LinkStiffness):
    """Declarations and parameter-level steps of the link block, and the integrator that knows them."""

    def _declare(self) -> None:
        r, state = self.key.modes, self.input
        self.omega = state("omega", (3, 1), r"\boldsymbol{\omega}_i", "rad/s", FRAME, "angular velocity of the link")
        self.vel = state("v", (3, 1), r"\mathbf{v}_i", "m/s", FRAME, "velocity of the origin of F_i")
        self.g = state("g", (3, 1), r"\mathbf{g}_i", "m/s^2", FRAME, "free fall in F_i, R_oi^T g")
        self.eta = state("eta", (r, 1), r"\boldsymbol{\eta}_i", "m", "-", "modal coordinates (torsion: rad)")
        self.etadot = state("etadot", (r, 1), r"\dot{\boldsymbol{\eta}}_i", "m/s", "-", "modal rates")
        self.rhoA = self.parameter("rhoA", (1, 1), r"\rho_i A_i", "kg/m", "-", "mass per length")
        length = self.parameter("length", (1, 1), "l_i", "m", "-", "length of the link")
        start: Expression = zeros(1)
        if self.key.frame_at:
            frame_at = self.parameter(
                "frame_at", (1, 1), "f_i", "m", FRAME, "place of F_i on the centreline, from the joint"
            )
            start = self.step(
                "start", -frame_at, "a_i", unit="m", equation="5", meaning="place of the joint on the centreline"
            )
        self.length, self.start = length, start
        a = self.values["start"].item() if self.key.frame_at else sp.S.Zero
        self.fields = Fields(self.key, self.values["length"].item(), a)
        self._declare_fields()

    def _declare_fields(self) -> None:
        f, field = self.fields, self.field
        self.r_b = field("r_b", column(XI, 0, 0), r"\mathbf{r}_b")
        self.Phi = field("Phi", f.Phi(), r"\boldsymbol{\phi}")
        self.phi_row = field("phi_row", f.translational(), r"\boldsymbol{\varphi}^{\top}")
        self.lever = field("lever", XI * f.translational(), r"\xi\boldsymbol{\varphi}^{\top}")
        self.phi_t = field("phi_t", f.twist_row(), r"\boldsymbol{\phi}_t")
        self.strain = field("strain", f.strain(), r"\boldsymbol{\phi}_{\varepsilon}")
        self.rho = field("rho", column(*sp.symbols("rho_x:z", real=True)), r"\mathbf{r}_{ib}")
        self.udot = field("udot", column(*sp.symbols("udot_x:z", real=True)), r"\dot{\mathbf{r}}_{\xi}")
        self.u = field("u", self._field_of("eta"), r"\mathbf{r}_{\xi}")
        self.udot_modal = field("udot_modal", self._field_of("etadot"), r"\dot{\mathbf{r}}_{\xi}")
        f.name_coarse(self.values["rho"], self.values["r_b"] + self.values["u"])
        f.name_coarse(self.values["udot"], self.values["udot_modal"])

    def _field_of(self, coordinates: str) -> np.ndarray:
        """``Phi`` times modal coordinates, in the finest generators."""
        return self.values["Phi"].dot(self.values[coordinates]) if self.key.modes else column(0, 0, 0)

    # what follows from the parameters ---------------------------------------------------------

    def _constants(self) -> None:
        rhoA, r_b = self.rhoA, self.r_b
        m_B, S_B, J_B = self._base_bodies()
        mu = self.step("mu", self.integral(identity(1), rhoA), r"\mu_i", unit="kg", meaning="mass of the beam")
        self.m = self.step("m", mu + m_B, "m_i", unit="kg", equation="27", meaning="mass, base bodies included")
        self.S_0 = self.step(
            "S_0",
            self.integral(r_b, rhoA) + S_B,
            r"\mathbf{S}_0",
            unit="kg*m",
            frame=FRAME,
            equation="27",
            meaning="first moment, undeformed",
        )
        self.J_0 = self.step(
            "J_0",
            self.integral(r_b @ r_b.T, rhoA) + J_B,
            r"\mathbf{J}_0",
            unit="kg*m^2",
            frame=FRAME,
            meaning="second moment, undeformed",
            symmetric=True,
        )
        self.spin = self._spin()
        I_0 = self.step(
            "I_0",
            Trace(self.J_0) @ identity(3) - self.J_0 + self.spin,
            r"\mathbf{I}_{b}",
            unit="kg*m^2",
            frame=FRAME,
            equation="Iibi",
            symmetric=True,
            meaning="inertia about the origin, undeformed",
        )
        self.M_star = self.step(
            "M_star",
            block([I_0, hat(self.S_0)], [-hat(self.S_0), self.m @ identity(3)]),
            r"\mathbf{M}^*_i",
            unit="kg, kg*m, kg*m^2",
            frame=FRAME,
            equation="27",
            meaning="inertia of the undeformed link",
            symmetric=True,
        )
        self.fields.name_moment("rhoA", self.values["m"].item())
        self._modal_constants()

    def _base_bodies(self) -> tuple[Expression, Expression, Expression]:
        """Base bodies about the origin of F_i: moved there from the joint point where the two differ."""
        m, S, J, _ = lumped(self, self.key, "base", "B")
        if not (self.key.frame_at and self.key.bodies_at("base")):
            return m, S, J
        r_B = self.start @ unit(0)
        shifted = J + r_B @ S.T + S @ r_B.T + m @ (r_B @ r_B.T)
        return m, S + m @ r_B, shifted

    def _spin(self) -> Expression:
        """``∫ rho I_p dξ e_x e_x^T``: spin about the centreline."""
        if not self.key.spin:
            return zeros(3, 3)
        self.rhoIp = self.parameter("rhoIp", (1, 1), r"\rho_i I_{p,i}", "kg*m", "-", "polar inertia per length")
        self.I_s = self.step(
            "I_s", self.integral(identity(1), self.rhoIp), "I_s", unit="kg*m^2", meaning="spin inertia of the beam"
        )
        self.fields.name_moment("rhoIp", self.values["I_s"].item())
        return self.I_s @ (unit(0) @ unit(0).T)

    def _modal_constants(self) -> None:
        """Momentum, lever, product, inertia and stiffness of the modes; named for the integrals to come."""
        phi, name = self.fields.phi, self.fields.name_moment
        self.sigma = self.step(
            "sigma",
            self.integral(self.Phi, self.rhoA),
            r"\boldsymbol{\Sigma}",
            unit="kg",
            frame=FRAME,
            equation="B1",
            meaning="momentum of each mode",
            numbered=(1,),
        )
        self.step(
            "chi",
            self.integral(self.lever, self.rhoA),
            r"\boldsymbol{\chi}",
            unit="kg*m",
            frame=FRAME,
            meaning="first moment of each mode shape",
            numbered=(1,),
        )
        M_eta = self.integral(self.Phi.T @ self.Phi, self.rhoA)
        if self.key.spin and self.key.counts[3]:
            self.sigma_t = self.step(
                "sigma_t",
                self.integral(self.phi_t, self.rhoIp),
                r"\boldsymbol{\Sigma}_t",
                unit="kg*m^2",
                meaning="spin momentum of each torsion mode",
            )
            M_eta = M_eta + self.integral(self.phi_t.T @ self.phi_t, self.rhoIp)
        self.step(
            "M_Wphi",
            M_eta,
            r"\mathbf{M}_{W\phi,i}",
            unit="kg",
            equation="86",
            symmetric=True,
            meaning="inertia of the modes (torsion: kg*m^2), diagonal",
        )
        for k in self._translational():
            axis = AXIS[self.key.directions[k][0]]
            name("rhoA", self.values["sigma"][axis, k], phi[k])
            name("rhoA", self.values["chi"][0, k], XI, phi[k])
            name("rhoA", self.values["M_Wphi"][k, k], phi[k], phi[k])
        self._products_of_shapes()
        self._stiffness()

    def _products_of_shapes(self) -> None:
        """``∫ρA φ_k φ_m`` of modes in different directions.

        Axial against bending is a full matrix; y against z is diagonal where both draw on the same functions.
        """
        groups = {d: [k for k in self._translational() if self.key.directions[k][0] == d] for d in AXIS}
        self._product("Gamma_xy", groups["axial"], groups["bending_y"])
        self._product("Gamma_xz", groups["axial"], groups["bending_z"])
        self._product("Gamma_yz", groups["bending_y"], groups["bending_z"])

    def _product(self, name: str, first: list[int], second: list[int]) -> None:
        if not (first and second):
            return
        phi = self.fields.phi
        left = self.field(
            f"phi_{name[-2]}_of_{name}", _row(phi[k] for k in first), rf"\boldsymbol{{\varphi}}_{name[-2]}^{{\top}}"
        )
        right = self.field(
            f"phi_{name[-1]}_of_{name}", _row(phi[k] for k in second), rf"\boldsymbol{{\varphi}}_{name[-1]}^{{\top}}"
        )
        self.step(
            name,
            self.integral(left.T @ right, self.rhoA),
            rf"\boldsymbol{{\Gamma}}_{{{name[-2:]}}}",
            unit="kg",
            meaning=f"products of the shapes in {name[-2]} with those in {name[-1]}",
            numbered=(0, 1),
        )
        mu = self.values["mu"].item()
        for (i, j), value in np.ndenumerate(self.values[name]):
            same = self.fields.gram(first[i], second[j]) == 1
            self.fields.name_moment("rhoA", mu if same else value, phi[first[i]], phi[second[j]])

    def _translational(self) -> list[int]:
        return [k for k, (d, _) in enumerate(self.key.directions) if d in AXIS]


def _row(entries) -> np.ndarray:
    return np.array([list(entries)], dtype=object)


def column(*entries) -> np.ndarray:
    return np.array([[sp.sympify(e)] for e in entries], dtype=object)
