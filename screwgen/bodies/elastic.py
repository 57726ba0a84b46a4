"""The displacement of a flexible body's elements: what rods and bodies from files have in common."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from ..algebra.expression import Diagonal, Expression, Root, Symbol, add, zeros
from ..ir.block import Block
from ..lazily import sp
from ..spec.link_class import LinkClass
from .moments import Moments
from .second_order import SecondOrder


class Elastic:
    """Displacements linear in the modal coordinates, at order 2 with their second-order part; damping of the modes."""

    b: Block
    key: LinkClass
    sigma: Symbol
    moved: Expression
    bend: Expression
    K: Symbol

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

    def _damping(self, inertia: Expression) -> None:
        """Of what is stated ``D_kk = 2 zeta sqrt(K_kk M_kk)`` of the assumed modes, and ``time K``; M, K as columns."""
        terms, own = self.key.damping, []
        self.D: Expression = zeros(self.key.modes)
        if "ratio" in terms:
            ratio = self.b.parameter("damping_ratio", (1, 1))
            own.append((2 * ratio) @ Root(Diagonal(self.K) @ inertia))
        if "time" in terms:
            time = self.b.parameter("damping_time", (1, 1))
            if self.key.coupled:
                diagonal = [Diagonal(x) for x in own]
                full = self.b.step("D_full", add(*diagonal, time @ self.b.symbol("K_full")), symmetric=True)
                self.D = self._split("D", full)
                return
            own.append(time @ self.K)
        if own:
            self.D = self.b.step("D", add(*own))
            if self.key.coupled:
                self.b.step("D_below", zeros(len(self.key.coupled)))

    @property
    def resistance(self) -> Expression:
        """The (r, r) damping of the modes."""
        full = "time" in self.key.damping and self.key.coupled
        return self.b.symbol("D_full") if full else Diagonal(self.D)

    def _split(self, name: str, full: Symbol) -> Symbol:
        """The diagonal of a modal matrix, and where modes are coupled the column of the entries below it."""
        values = self.b.values[full.name]
        out = self.b.step(name, self._entries(f"{name}_entries", rf"\mathrm{{diag}}\,{full.display}", np.diag(values)))
        if self.key.coupled:
            below = [values[place] for place in self.key.coupled]
            lower = self._entries(f"{name[0]}_lower", rf"\mathrm{{low}}\,{full.display}", below)
            self.b.step(f"{name[0]}_below", lower)
        return out

    def _entries(self, name: str, display: str, values: Iterable[sp.Expr]) -> Symbol:
        return self.b.field(name, np.array([*values], dtype=object).reshape(-1, 1), display)
