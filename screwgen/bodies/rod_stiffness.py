"""Stiffness and damping of a link's modes: from its section, or from measured natural frequencies."""

from __future__ import annotations

import numpy as np
import sympy as sp

from ..algebra.expression import Diagonal, Expression, Integral, Root, Symbol, block, stack, zeros
from ..ir.block import Block
from ..spec.link_class import DIRECTIONS, LinkClass
from .fields import Fields

SECTION = (
    ("EA", (1, 1), "E_iA_i", "N", "-", "axial stiffness"),
    ("EIz", (1, 1), "E_iI_{z_i}", "N*m^2", "-", "bending stiffness for displacement in y"),
    ("EIy", (1, 1), "E_iI_{y_i}", "N*m^2", "-", "bending stiffness for displacement in z"),
    ("GJ", (1, 1), "G_iJ_i", "N*m^2", "-", "torsion stiffness"),
)
"""The stiffness parameters of a section for each direction."""

MEASURED = (
    ("x", "natural frequencies of the axial modes"),
    ("y", "natural frequencies of the modes in y, clamped-free"),
    ("z", "natural frequencies of the modes in z, clamped-free"),
    ("t", "natural frequencies of the torsion modes"),
)
"""The measured frequencies of each direction: subscript and meaning."""


class RodStiffness:
    """The stiffness K and damping D of a rod, both diagonal and stored as columns."""

    form: str
    b: Block
    key: LinkClass
    fields: Fields
    strain: Symbol

    def integral(self, integrand: Expression, weight: Symbol | None) -> Integral:
        return Integral(integrand, weight, self.fields.integrate)

    def _property(self, name: str, shape: tuple[int, int], display: str, unit: str, frame: str, meaning: str) -> Symbol:
        """A property of the section: a parameter."""
        return self.b.parameter(name, shape, display, unit, frame, meaning)

    def _stiffness(self) -> None:
        """``K = ∫ B^T C B dξ``, with measured frequencies ``K_kk = M_kk (2π f_k)^2``, and ``D``."""
        full = self._section_stiffness()
        if self.key.measured:
            inertia = self._modal_inertia()
            self.K = self._measured_stiffness(full, inertia)
        else:
            meaning = "stiffness of each mode (torsion: N*m/rad)"
            self.K = self._column("K", full, r"\mathbf{k}_i", "N/m", meaning)
            inertia = self._modal_inertia()
        self._damping(inertia)

    def _section_stiffness(self) -> Symbol:
        rows = zip(DIRECTIONS, SECTION, self.key.counts, strict=True)
        stiff = [self._property(*row) if n and d not in self.key.measured else zeros(1) for d, row, n in rows]
        C = block(*([stiff[i] if i == j else zeros(1) for j in range(4)] for i in range(4)))
        return self._full_stiffness(self.integral(self.strain.T @ C @ self.strain, None))

    def _full_stiffness(self, expression: Expression) -> Symbol:
        return self.b.step(
            "K_full",
            expression,
            r"\mathbf{K}_i",
            unit="N/m",
            equation="88",
            symmetric=True,
            meaning="stiffness of the modes (torsion: N*m), " + self.form,
        )

    def _modal_inertia(self) -> Symbol:
        shape = (self.key.modes,) * 2
        full = Symbol("M_Wphi", shape, r"\mathbf{M}_{W\phi,i}")
        return self._column("M_eta", full, r"\mathbf{m}_{\eta}", "kg", "inertia of each mode (torsion: kg*m^2)")

    def _measured_stiffness(self, full: Symbol, inertia: Symbol) -> Symbol:
        """Stiffness by the paper's wavenumber identification, ``β_n² = 2π f_n sqrt(ρA/EI)``, mode by mode.

        A clamped-free mode has the stiffness ``EI β_n⁴ l`` and the inertia ``ρA l``, so
        ``K_kk = M_kk (2π f_k)²``. Neither length nor wavenumber is needed.
        """
        f_n = self.b.step(
            "f_n",
            self._frequencies(),
            r"\mathbf{f}_n",
            unit="Hz",
            meaning="natural frequency of each mode that is measured, of the bare clamped link",
            numbered=(0,),
        )
        omega_n = self.b.step(
            "omega_n",
            (2 * sp.pi) * f_n,
            r"\boldsymbol{\omega}_n",
            unit="rad/s",
            meaning="natural angular frequency of each mode that is measured",
            numbered=(0,),
        )
        squared = Diagonal(omega_n) @ Diagonal(omega_n) @ inertia
        return self.b.step(
            "K",
            full @ self._ones("K") + squared,
            r"\mathbf{k}_i",
            unit="N/m",
            equation="wavenumber",
            meaning="stiffness of each mode (torsion: N*m/rad)",
            numbered=(0,),
        )

    def _frequencies(self) -> Expression:
        """A column for each direction that has modes: its frequencies, or zeros."""
        parts: list[Expression] = []
        for direction, n, (letter, meaning) in zip(DIRECTIONS, self.key.counts, MEASURED, strict=True):
            if direction in self.key.measured:
                name, display = f"frequencies_{direction}", rf"\mathbf{{f}}_{{{letter},i}}"
                parts.append(self.b.parameter(name, (n, 1), display, "Hz", "-", meaning, numbered=(0,)))
            elif n:
                parts.append(zeros(n))
        return stack(*parts) if len(parts) > 1 else parts[0]

    def _damping(self, inertia: Symbol) -> None:
        if not self.key.damping:
            self.D: Expression = zeros(self.key.modes)
            return
        ratio = self.b.parameter("damping_ratio", (1, 1), r"\zeta_i", "-", "-", "damping ratio of each mode")
        self.D = self.b.step(
            "D",
            (2 * ratio) @ Root(Diagonal(self.K) @ inertia),
            r"\mathbf{d}_i",
            unit="N*s/m",
            meaning="damping of each mode (torsion: N*m*s/rad)",
        )

    def _column(self, name: str, full: Symbol, display: str, unit_: str, meaning: str) -> Symbol:
        return self.b.step(name, full @ self._ones(name), display, unit=unit_, meaning=meaning)

    @property
    def stiffness(self) -> Expression:
        """The (r, r) stiffness of the modes."""
        return Diagonal(self.K)

    def _ones(self, name: str) -> Symbol:
        ones = np.full((self.key.modes, 1), sp.S.One, dtype=object)
        return self.b.field(f"{name}_ones", ones, r"\mathbf{1}")
