"""The rod whose modes are coupled within a plane: by shear, by rotary inertia, or by a section that varies."""

from __future__ import annotations

import itertools
from collections.abc import Iterable

import numpy as np
import sympy as sp

from ..algebra.expression import Expression, Symbol, zeros
from ..spec.link_class import AXIS
from .rod import RodBody


class CoupledRod(RodBody):
    """A rod with entries below the diagonal of its modal inertia, at ``LinkClass.coupled``.

    The damping is diagonal, ``D_kk = 2 zeta sqrt(K_kk M_kk)`` of the assumed modes: closed in the parameters, and
    positive semidefinite.
    """

    def _name_products(self) -> None:
        """Products of the shapes of one plane."""
        M, phi, axes = self.b.values["M_Wphi"], self.fields.phi, [AXIS.get(d) for d, _ in self.key.directions]
        for i, j in itertools.combinations_with_replacement(range(self.key.modes), 2):
            if axes[i] == axes[j]:
                weight, value = ("rhoIp", M[i, j]) if axes[i] is None else ("rhoA", self.by_mass[i, j])
                self.fields.name_moment(weight, value, phi[i], phi[j])

    def _column(self, name: str, full: Symbol) -> Symbol:
        """The diagonal of a modal matrix; the entries below it are a column of their own."""
        values = self.b.values[full.name]
        out = self.b.step(name, self._entries(f"{name}_entries", rf"\mathrm{{diag}}\,{full.display}", np.diag(values)))
        if self.key.coupled:
            below = [values[place] for place in self.key.coupled]
            lower = self._entries(f"{name[0]}_lower", rf"\mathrm{{low}}\,{full.display}", below)
            self.b.step(f"{name[0]}_below", lower)
        return out

    @property
    def stiffness(self) -> Expression:
        """The (r, r) stiffness of the modes."""
        return self.b.symbol("K_full")

    def _entries(self, name: str, display: str, values: Iterable[sp.Expr]) -> Symbol:
        return self.b.field(name, np.array([*values], dtype=object).reshape(-1, 1), display)

    def _damping(self, inertia: Symbol) -> None:
        super()._damping(inertia)
        if self.key.damping and self.key.coupled:
            self.b.step("D_below", zeros(len(self.key.coupled)))
