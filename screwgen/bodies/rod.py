"""The rod: a slender uniform beam of a link, whose invariants are integrals along its centreline.

:mod:`.varying_rod` has the rod whose sections vary.
"""

from __future__ import annotations

import numpy as np
import sympy as sp

from ..algebra.expression import Expression, Symbol, identity, is_zero, unit, zeros
from ..ir.block import Binding, Block
from ..spec.link_class import LinkClass
from .contract import Moments6
from .fields import AXIS, XI, Fields
from .rod_stiffness import RodStiffness
from .second_order import SecondOrder


class Rod(RodStiffness):
    """Sections along a centreline, with mode shapes in four directions."""

    kind: type[Fields] = Fields

    def __init__(self, b: Block, key: LinkClass):
        self.b, self.key = b, key
        self.rhoA = self._property("rhoA")
        self.length = b.parameter("length", (1, 1))

    def declare(self, start: Expression) -> None:
        """The fields along the rod; ``start`` is the place of the joint on the centreline."""
        a = sp.S.Zero if is_zero(start) else self.b.values["start"].item()
        f, field = self.kind(self.key, self.b.values["length"].item(), a), self.b.field
        self.fields = f
        self.b.bindings[XI] = Binding.CONSTANT
        self.r_b = field("r_b", column(XI, 0, 0))
        self.Phi = field("Phi", f.Phi())
        self.phi_row = field("phi_row", f.translational())
        self.lever = field("xi_phi", XI * f.translational())
        self.phi_t = field("phi_t", f.twist_row())
        self.strain = field("strain", f.strain())
        self.moved: Symbol = self.Phi
        self.bend: Expression = zeros(3)
        u, udot = self._field_of("eta"), self._field_of("etadot")
        if self.key.order == 2:
            self.second = SecondOrder(self.b, f, f.second, self.key.modes)
            self.moved, self.bend = self.second.Phi, self.second.bend
            u, udot = u + self.second.u, udot + self.second.udot
        self.u = field("u", u)
        self.udot_modal = field("udot_modal", udot)
        f.name_coarse(self.b.values["udot"], self.b.values["udot_modal"])
        f.name_coarse(self.b.values["rho"], self.b.values["r_b"] + self.b.values["u"])

    def _field_of(self, coordinates: str) -> np.ndarray:
        """``Phi`` times modal coordinates, in the finest generators."""
        return self.b.values["Phi"].dot(self.b.values[coordinates]) if self.key.modes else column(0, 0, 0)

    # what follows from the parameters ---------------------------------------------------------

    def moments(self) -> Moments6:
        """Mass, first and second moment of the straight rod about the origin of F_i."""
        rhoA, r_b = self.rhoA, self.r_b
        mu = self.b.step("mu", self.integral(identity(1), rhoA))
        return mu, self.integral(r_b, rhoA), self.integral(r_b @ r_b.T, rhoA)

    def spin(self) -> Expression:
        """``∫ rho I_p dξ e_x e_x^T``: spin about the centreline."""
        if not self.key.spin:
            return zeros(3, 3)
        self.rhoIp = self._property("rhoIp")
        self.I_s = self.b.step("I_s", self.integral(identity(1), self.rhoIp))
        self.fields.name_moment("rhoIp", self.b.values["I_s"].item())
        return self.I_s @ (unit(0) @ unit(0).T)

    def displaced(self, eta: Symbol, etadot: Symbol) -> tuple[Expression, Expression]:
        """``∫ρA u dξ`` and its rate."""
        if self.key.order == 1:
            return self.sigma @ eta, self.sigma @ etadot
        sigma2 = self.b.symbol("sigma2")
        return self.sigma @ eta + sp.Rational(1, 2) * (sigma2 @ eta), self.sigma @ etadot + sigma2 @ etadot

    def own_energy(self, omega: Symbol, etadot: Symbol) -> Expression:
        """That of the sections' spin, ``∫ρI_p (n^T nu)^2 dξ``."""
        if not self.key.spin:
            return zeros(1)
        spin: Expression = self.b.entries(omega)[0]
        if self.key.counts[3]:
            spin = spin + self.phi_t @ etadot
        return self.integral(spin @ spin, self.rhoIp)

    def modal(self) -> None:
        """The modal invariants (momenta, inertia, stiffness), and the names of their moments for later integrals."""
        phi, name = self.fields.phi, self.fields.name_moment
        self.sigma = self.b.step("sigma", self.integral(self.Phi, self.rhoA))
        self.b.step("chi", self.integral(self.lever, self.rhoA))
        M_eta = self.integral(self.Phi.T @ self.Phi, self.rhoA)
        if self.key.spin and self.key.counts[3]:
            self.sigma_t = self.b.step("sigma_t", self.integral(self.phi_t, self.rhoIp))
            M_eta = M_eta + self.integral(self.phi_t.T @ self.phi_t, self.rhoIp)
        self.b.step("M_Wphi", M_eta, symmetric=True)
        for k in self._translational():
            axis = AXIS[self.key.directions[k][0]]
            name("rhoA", self.b.values["sigma"][axis, k], phi[k])
            name("rhoA", self.b.values["chi"][0, k], XI, phi[k])
        self._name_products()
        self._products_of_shapes()
        self._stiffness()
        if self.key.order == 2:
            self.second.moments(self.rhoA)

    def _name_products(self) -> None:
        """``∫ρA φ_k φ_k``: the products of different shapes of one direction have no integral."""
        for k in self._translational():
            phi = self.fields.phi[k]
            self.fields.name_moment("rhoA", self.b.values["M_Wphi"][k, k], phi, phi)

    def _products_of_shapes(self) -> None:
        """``∫ρA φ_k φ_m`` of modes in different directions.

        The products of axial and bending modes are a full matrix. Those of y and z are diagonal if both directions use
        the same functions.
        """
        groups = {d: [k for k in self._translational() if self.key.directions[k][0] == d] for d in AXIS}
        self._product("Gamma_xy", groups["axial"], groups["bending_y"])
        self._product("Gamma_xz", groups["axial"], groups["bending_z"])
        self._product("Gamma_yz", groups["bending_y"], groups["bending_z"])

    def _product(self, name: str, first: list[int], second: list[int]) -> None:
        if not (first and second):
            return
        phi = self.fields.phi
        rows = zip(name[-2:], (first, second), strict=True)
        left, right = (self.b.field(f"phi_{axis}", _row(phi[k] for k in modes)) for axis, modes in rows)
        self.b.step(name, self.integral(left.T @ right, self.rhoA))
        mu = self.b.values["mu"].item()
        for (i, j), value in np.ndenumerate(self.b.values[name]):
            same = not self.key.stations and self.fields.gram(first[i], second[j]) == 1
            self.fields.name_moment("rhoA", mu if same else value, phi[first[i]], phi[second[j]])

    def _translational(self) -> list[int]:
        return [k for k, (d, _) in enumerate(self.key.directions) if d in AXIS]


def _row(entries) -> np.ndarray:
    return np.array([list(entries)], dtype=object)


def column(*entries) -> np.ndarray:
    return np.array([[sp.sympify(e)] for e in entries], dtype=object)
