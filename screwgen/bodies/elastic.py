"""The displacement of a flexible body's elements: what rods and bodies from files have in common."""

from __future__ import annotations

import numpy as np
import sympy as sp

from ..algebra.expression import Expression, Symbol, zeros
from ..ir.block import Block
from ..spec.link_class import LinkClass
from .moments import Moments
from .second_order import SecondOrder


class Elastic:
    """Displacements linear in the modal coordinates, at order 2 with their second-order part."""

    b: Block
    key: LinkClass
    sigma: Symbol
    moved: Expression
    bend: Expression

    def _deform(self, fields: Moments, known: dict, Phi: Symbol) -> None:
        """Displacement and elastic velocity, of the shapes ``Phi`` (3, r) and those of second order ``known``."""
        values, field = self.b.values, self.b.field
        u, udot = (
            values[Phi.name].dot(values[x]) if self.key.modes else np.full((3, 1), sp.S.Zero, dtype=object)
            for x in ("eta", "etadot")
        )
        self.moved, self.bend = Phi, zeros(3)
        if self.key.order == 2:
            self.second = SecondOrder(self.b, fields, known, self.key.modes)
            self.moved, self.bend = self.second.Phi, self.second.bend
            u, udot = u + values[self.second.u.name], udot + self.second.udot
        self.u, self.udot_modal = field("u", u), field("udot_modal", udot)
        fields.name_coarse(values["udot"], values["udot_modal"])
        fields.name_coarse(values["rho"], values["r_b"] + values["u"])

    def displaced(self, eta: Symbol, etadot: Symbol) -> tuple[Expression, Expression]:
        """``∫ u dm`` and its rate."""
        if self.key.order == 1:
            return self.sigma @ eta, self.sigma @ etadot
        return self.sigma @ eta + self.second.displaced, self.sigma @ etadot + self.b.symbol("sigma2") @ etadot
