"""The rod whose modes are coupled within a plane: by shear, by rotary inertia, or by a section that varies."""

from __future__ import annotations

import itertools

from ..algebra.expression import Expression, Symbol
from ..spec.link_class import AXIS
from .rod import RodBody


class CoupledRod(RodBody):
    """A rod with entries below the diagonal of its modal inertia, at ``LinkClass.coupled``."""

    def _name_products(self) -> None:
        """Products of the shapes of one plane."""
        M, phi, axes = self.b.values["M_Wphi"], self.fields.phi, [AXIS.get(d) for d, _ in self.key.directions]
        for i, j in itertools.combinations_with_replacement(range(self.key.modes), 2):
            if axes[i] == axes[j]:
                weight, value = ("rhoIp", M[i, j]) if axes[i] is None else ("rhoA", self.by_mass[i, j])
                self.fields.name_moment(weight, value, phi[i], phi[j])

    def _column(self, name: str, full: Symbol) -> Symbol:
        """The diagonal of a modal matrix; the entries below it are a column of their own."""
        return self._split(name, full)

    @property
    def stiffness(self) -> Expression:
        """The (r, r) stiffness of the modes."""
        return self.b.symbol("K_full")
