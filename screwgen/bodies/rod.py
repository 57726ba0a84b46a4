"""The rod: a slender uniform beam of a link, whose invariants are integrals along its centreline.

:mod:`.varying_rod` has the rod whose sections vary.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable

import numpy as np

from ..algebra.expression import Expression, Inverse, Symbol, add, identity, is_zero, unit, zeros
from ..ir.block import Binding, Block
from ..lazily import sp
from ..spec.link_class import AXIS, EXACT, TURN, LinkClass
from .collocation import collocation
from .contract import Moments6, RotaryInertia
from .elastic import Elastic
from .fields import Fields, length, number, xi
from .rod_stiffness import RodStiffness

TURNED = (
    ("rhoIp", "I_s", "phi_t", "sigma_t"),
    ("rhoIy", "I_sy", "psi_y", "sigma_sy"),
    ("rhoIz", "I_sz", "psi_z", "sigma_sz"),
)
"""Of each axis of the sections: inertia per length, its integral, the turn by each mode, the momentum of each mode."""


class RodBody(Elastic, RodStiffness):
    """Sections along a centreline, with mode shapes in four directions, with shear in six."""

    kind: type[Fields] = Fields

    def __init__(self, b: Block, key: LinkClass):
        self.b, self.key = b, key
        self.rhoA = self._property("rhoA")
        self.length = length(b, key)

    def declare(self, start: Expression) -> None:
        """The fields along the rod; ``start`` is the place of the joint on the centreline."""
        a = sp.S.Zero if is_zero(start) else self.b.values["start"].item()
        f, field = self.kind(self.key, self.b.values[self.length.name].item(), a), self.b.field
        self.fields = f
        self.b.bindings[xi()] = Binding.CONSTANT
        self.r_b = field("r_b", column(xi(), 0, 0))
        self.Phi = field("Phi", f.Phi())
        self.phi_row = field("phi_row", f.translational())
        self.arm = field("xi_phi", xi() * f.translational())
        self.turns = {axis: field(TURNED[axis][2], f.turns(axis)) for axis in (0, *self.key.rotary)}
        sheared = "strains of each mode: u_x', u_y'', u_z'', rate of twist, shear in y and in z"
        self.strain = field("strain", f.strain(), **({"meaning": sheared} if len(self.key.counts) > 4 else {}))
        self._deform(f, f.second, self.Phi)

    def sampled(self, name: str, s: float) -> sp.Expr:
        """A property of the section at the place s in [0, 1]."""
        return self.b.values[name].item()

    def shared(self, name: str) -> list[sp.Expr]:
        """A property shared out among the Gauss points of an exact rod, per unit of its length."""
        return [number(w) * self.b.values[name].item() for w in collocation(self.key).weights]

    # what follows from the parameters ---------------------------------------------------------

    def moments(self) -> Moments6:
        """Mass, first and second moment of the straight rod about the origin of F_i."""
        rhoA, r_b = self.rhoA, self.r_b
        mu = self.b.step("mu", self.integral(identity(1), rhoA))
        return mu, self.integral(r_b, rhoA), self.integral(r_b @ r_b.T, rhoA)

    def spin(self) -> Expression:
        """The sum of ``∫ρI dξ e e^T`` over the axes about which the sections have an inertia of their own."""
        parts: list[Expression] = [zeros(3, 3)]
        self.densities: dict[int, Symbol] = {}
        for axis in self.key.turned:
            density, inertia, _, _ = TURNED[axis]
            rho = self.densities[axis] = self._property(density)
            whole = self.b.step(inertia, self.integral(identity(1), rho))
            self.fields.name_moment(density, self.b.values[inertia].item())
            parts.append(whole @ (unit(axis) @ unit(axis).T))
        return add(*parts)

    def own_energy(self, omega: Symbol, etadot: Symbol) -> Expression:
        """That of the sections' turning, ``∫ρI (n^T nu)^2 dξ`` about each axis."""
        parts = []
        for t in self.turnings:
            rate: Expression = self.b.entries(omega)[t.axis]
            if not is_zero(t.momentum):
                rate = rate + t.shapes @ etadot
            parts.append(self.integral(rate @ rate, t.density))
        return add(*parts) if parts else zeros(1)

    def modal(self) -> None:
        """The modal invariants (momenta, inertia, stiffness), and the names of their moments for later integrals."""
        phi, name = self.fields.phi, self.fields.name_moment
        self.sigma = self.b.step("sigma", self.integral(self.Phi, self.rhoA))
        self.b.step("chi", self.integral(self.arm, self.rhoA))
        by_mass: Expression = self.integral(self.Phi.T @ self.Phi, self.rhoA)
        self.turnings = [self._turning(axis) for axis in self.key.turned]
        turned = [t for t in self.turnings if not is_zero(t.momentum)]
        by_turn: list[Expression] = [self.integral(t.shapes.T @ t.shapes, t.density) for t in turned]
        if self.fields.slope:
            by_mass = self.b.step("M_phi", by_mass, symmetric=True)
            by_turn = [self.b.step("M_s", add(*by_turn), symmetric=True)]
        self.b.step("M_Wphi", add(by_mass, *by_turn), symmetric=True)
        for k in self._translational():
            axis = AXIS[self.key.directions[k][0]]
            name("rhoA", self.b.values["sigma"][axis, k], phi[k])
            name("rhoA", self.b.values["chi"][0, k], xi(), phi[k])
        self._name_turns()
        self._name_products()
        self._products_of_shapes()
        self._damping(self._stiffness())
        if self.key.tendons or self.key.order == EXACT:
            self.b.step("per_length", Inverse(self.length))
        if self.key.order == 2:
            self.second.moments(self.rhoA)

    def _turning(self, axis: int) -> RotaryInertia:
        """The sections' inertia about an axis and the modes' momenta about it."""
        _, inertia, _, name = TURNED[axis]
        rho, shapes = self.densities[axis], self.turns[axis]
        momentum: Expression = zeros(1, self.key.modes)
        if self.key.turns(axis):
            momentum = self.b.step(name, self.integral(shapes, rho))
        return RotaryInertia(axis, rho, self.b.symbol(inertia), shapes, momentum)

    def _name_turns(self) -> None:
        """``∫ρI φ_k'`` and ``∫ρI φ_k' φ_m'`` of the slopes of bending, for the kinetic energy."""
        slope, values, name = self.fields.slope, self.b.values, self.fields.name_moment
        for i, j in itertools.combinations_with_replacement(slope, 2):
            axis, sign = TURN[self.key.directions[i][0]]
            density, _, _, momentum = TURNED[axis]
            name(density, sign * values[momentum][0, i], slope[i])
            name(density, values["M_s"][i, j], slope[i], slope[j])

    @property
    def by_mass(self) -> np.ndarray:
        """``∫ρA Φ^T Φ dξ``: the modes' inertia without that of turning sections."""
        return self.b.values["M_phi" if self.fields.slope else "M_Wphi"]

    def _name_products(self) -> None:
        """``∫ρA φ_k φ_k``: the products of different shapes of one direction have no integral."""
        for k in self._translational():
            phi = self.fields.phi[k]
            self.fields.name_moment("rhoA", self.by_mass[k, k], phi, phi)

    def _products_of_shapes(self) -> None:
        """``∫ρA φ_k φ_m`` of modes in different directions.

        The products of axial and bending modes are a full matrix. Those of y and z are diagonal if both directions use
        the same functions.
        """
        x, y, z = ([k for k in self._translational() if AXIS[self.key.directions[k][0]] == axis] for axis in range(3))
        self._product("Gamma_xy", x, y)
        self._product("Gamma_xz", x, z)
        self._product("Gamma_yz", y, z)

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


def _row(entries: Iterable[sp.Symbol]) -> np.ndarray:
    return np.array([list(entries)], dtype=object)


def column(*entries: sp.Expr | int) -> np.ndarray:
    return np.array([[sp.sympify(e)] for e in entries], dtype=object)
