"""Stiffness of a link's modes: from its section, or from measured natural frequencies."""

from __future__ import annotations

import numpy as np

from ..algebra.expression import Diagonal, Expression, Integral, Symbol, block, stack, zeros
from ..ir.block import Block
from ..lazily import sp
from ..spec.link_class import LinkClass
from ..spec.modes import DIRECTIONS
from .fields import Fields

SECTION = ("EA", "EIz", "EIy", "GJ", "GAy", "GAz")
"""The stiffness of a section in each direction."""


class RodStiffness:
    """The stiffness K of a rod, diagonal and stored as a column."""

    form: str
    b: Block
    key: LinkClass
    fields: Fields
    strain: Symbol

    def integral(self, integrand: Expression, weight: Symbol | None) -> Integral:
        return Integral(integrand, weight, self.fields.integrate)

    def _property(self, name: str) -> Symbol:
        """A property of the section: a parameter."""
        return self.b.parameter(name, (1, 1))

    def _stiffness(self) -> Symbol:
        """``K = ∫ B^T C B dξ``, with measured frequencies ``K_kk = M_kk (2π f_k)^2``. Returns the column ``M_kk``."""
        full = self._section_stiffness()
        if self.key.measured:
            inertia = self._modal_inertia()
            self.K = self._measured_stiffness(full, inertia)
        else:
            self.K = self._column("K", full)
            inertia = self._modal_inertia()
        return inertia

    def _section_stiffness(self) -> Symbol:
        stated = zip(DIRECTIONS, SECTION, self.key.counts, strict=False)
        stiff = [self._property(s) if n and d not in self.key.measured else zeros(1) for d, s, n in stated]
        rows = range(len(stiff))
        C = block(*([stiff[i] if i == j else zeros(1) for j in rows] for i in rows))
        return self.b.step("K_full", self.integral(self.strain.T @ C @ self.strain, None), symmetric=True)

    def _modal_inertia(self) -> Symbol:
        shape = (self.key.modes,) * 2
        full = Symbol("M_Wphi", shape, r"\mathbf{M}_{W\phi,i}")
        return self._column("M_eta", full)

    def _measured_stiffness(self, full: Symbol, inertia: Symbol) -> Symbol:
        """Stiffness by the paper's wavenumber identification, ``β_n² = 2π f_n sqrt(ρA/EI)``, mode by mode.

        A clamped-free mode has the stiffness ``EI β_n⁴ l`` and the inertia ``ρA l``, so
        ``K_kk = M_kk (2π f_k)²``. Neither length nor wavenumber is needed.
        """
        f_n = self.b.step("f_n", self._frequencies())
        omega_n = self.b.step("omega_n", (2 * sp.pi) * f_n)
        squared = Diagonal(omega_n) @ Diagonal(omega_n) @ inertia
        return self.b.step("K", full @ self._ones("K") + squared, equation="wavenumber")

    def _frequencies(self) -> Expression:
        """A column for each direction that has modes: its frequencies, or zeros."""
        parts: list[Expression] = []
        for direction, n in zip(DIRECTIONS, self.key.counts, strict=False):
            if direction in self.key.measured:
                parts.append(self.b.parameter(f"frequencies_{direction}", (n, 1)))
            elif n:
                parts.append(zeros(n))
        return stack(*parts) if len(parts) > 1 else parts[0]

    @property
    def stiffness(self) -> Expression:
        """The (r, r) stiffness of the modes."""
        return Diagonal(self.K)

    def _column(self, name: str, full: Symbol) -> Symbol:
        """The diagonal of a modal matrix."""
        return self.b.step(name, full @ self._ones(name))

    def _ones(self, name: str) -> Symbol:
        ones = np.full((self.key.modes, 1), sp.S.One, dtype=object)
        return self.b.field(f"{name}_ones", ones, r"\mathbf{1}", unit="-", meaning="column of ones")
