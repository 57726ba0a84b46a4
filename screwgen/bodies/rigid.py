"""The rigid link: no modes; its mass is that of the bodies mounted on it."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from ..algebra.expression import Expression, Symbol, zeros
from ..ir.block import Block
from ..lazily import sp
from .contract import Moments6, RotaryInertia
from .moments import Moments


class RigidBody:
    """A link without a section. Its integrals are the moments that the link's block has named."""

    def __init__(self, b: Block):
        self.b = b
        density = np.array([[sp.Symbol("rhoA", real=True)]], dtype=object)
        self.rhoA = b.field("rhoA", density, r"\rho_i A_i")

    def declare(self, start: Expression) -> None:
        """There are no fields along a rigid link."""
        self.fields = Moments(self.b.values["rho"].flat)
        self.fields.name_coarse(self.b.values["udot"], np.full(3, sp.S.Zero))
        self.sigma, self.K, self.D = zeros(3, 0), zeros(0), zeros(0)
        self.moved, self.bend, self.phi_row = zeros(3, 0), zeros(3), zeros(1, 0)
        self.r_b = self.u = self.udot_modal = zeros(3)

    stiffness = resistance = zeros(0, 0)
    turnings: ClassVar[list[RotaryInertia]] = []

    def moments(self) -> Moments6:
        """Zero: the link itself has no mass."""
        return zeros(1), zeros(3), zeros(3, 3)

    def spin(self) -> Expression:
        """Zero: the link itself has no inertia."""
        return zeros(3, 3)

    def displaced(self, eta: Symbol, etadot: Symbol) -> tuple[Expression, Expression]:
        """Zero: nothing bends."""
        return self.sigma @ eta, self.sigma @ etadot

    def own_energy(self, omega: Symbol, etadot: Symbol) -> Expression:
        """Zero: the link itself has none."""
        return zeros(1)

    def modal(self) -> None:
        """No modes."""
        step = self.b.step
        step("sigma", self.sigma)
        step("M_Wphi", zeros(0, 0))
        step("M_eta", zeros(0))
        step("K", self.K)
