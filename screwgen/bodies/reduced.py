"""The body of a link from finite elements: its invariants are numbers, constants of the generated code.

Its fields are generators as those of a rod are, the coordinates of an element and its displacement along each axis by
each mode. Where a rod integrates their products in closed form, their integrals are read off a table.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar

import numpy as np

from ..algebra.expression import Expression, Symbol, matrix, number, vector, zeros
from ..ir.block import Block
from ..lazily import sp
from ..spec.link_class import LinkClass
from ..spec.reduced import FILE
from .contract import Moments6, RotaryInertia
from .elastic import Elastic
from .moments import Moments
from .second_order import AXES, entry

ROUNDING = 1e-12
"""Rotary inertia of the modes below this, over their inertia, is a rounding error."""


class ReducedMoments(Moments):
    """The generators of a body given by numbers, and the integrals of their products over its mass."""

    def __init__(self, key: LinkClass):
        body, r = key.elastic, range(key.modes)
        assert body is not None
        self.place = sp.symbols("r_x:z", real=True)
        self.phi = [[sp.Symbol(f"phi_{axis}_{k + 1}", real=True) for axis in AXES] for k in r]
        one = sp.S.One
        known = [one, *self.place, *(g for shapes in self.phi for g in shapes)]
        self.table = {
            frozenset({known[i], known[j]}): numeral(float(body.gram[i, j]))
            for i, j in np.ndindex(body.gram.shape)
            if i <= j
        }
        self.second: dict[sp.Symbol, None] = {}
        for a, k, m in np.ndindex(body.sag.shape) if body.geometric else ():
            h = entry(AXES[a], k, m)
            self.second[h] = None
            self.table[frozenset({one, h})] = numeral(float(body.sag[a, k, m]))
            for b in {0, 1, 2} - {a}:
                sign = 1 if (b, a) in ((0, 1), (1, 2), (2, 0)) else -1
                half = sign * body.swing[3 - a - b, k, m] / 2
                self.table[frozenset({self.place[b], h})] = numeral(half)
        super().__init__([*known[1:], *self.second])

    def _weighted(self, weight: str | None, monomial: list[sp.Symbol]) -> sp.Expr:
        """The integral over the mass; of products with second-order shapes those with the undeformed body are kept."""
        if len(monomial) > 2:
            raise ValueError(f"no integral of {sp.Mul(*monomial)}")
        pair = [*monomial, sp.S.One, sp.S.One][:2] if len(monomial) < 2 else monomial
        return self.table.get(frozenset(pair), sp.S.Zero)


class ReducedBody(Elastic):
    """A flexible body from a file."""

    turnings: ClassVar[list[RotaryInertia]] = []

    def __init__(self, b: Block, key: LinkClass):
        assert key.elastic is not None
        self.b, self.key, self.data = b, key, key.elastic
        density = np.array([[sp.Symbol("rhoA", real=True)]], dtype=object)
        self.rhoA = b.field("rhoA", density, r"\rho_i A_i")

    def declare(self, start: Expression) -> None:
        """The fields of the body; F_i sits at the base."""
        f = self.fields = ReducedMoments(self.key)
        field = self.b.field
        self.r_b = field("r_b", np.array([f.place], dtype=object).T)
        Phi = field("Phi", np.array(f.phi, dtype=object).T)
        self.phi_row = field("phi_row", np.array([[g for shapes in f.phi for g in shapes]], dtype=object))
        self._deform(f, f.second, Phi)

    def moments(self) -> Moments6:
        """Mass, first and second moment of the undeformed body about the origin of F_i."""
        G = self.data.gram
        mu = self.b.step("mu", number(numeral(self.data.mass)))
        S = vector(numerals(G[0, 1:4]), r"\int\mathbf{r}_b\,dm")
        return mu, S, self._matrix(G[1:4, 1:4], r"\int\mathbf{r}_b\mathbf{r}_b^{\top}dm")

    def spin(self) -> Expression:
        """Zero: the second moment has all inertia."""
        return zeros(3, 3)

    def own_energy(self, omega: Symbol, etadot: Symbol) -> Expression:
        """That of nodes which turn with the modes: what the modes' inertia has beyond ``∫ Phi^T Phi dm``."""
        rest = self.data.inertia - np.einsum("akal->kl", self.data.products)
        rest[np.abs(rest) < ROUNDING * np.abs(self.data.inertia).max()] = 0.0
        return etadot.T @ (self._matrix(rest, r"\mathbf{M}_{e,\mathrm{turn}}") @ etadot)

    def modal(self) -> None:
        """The modal invariants of the file."""
        d, step = self.data, self.b.step
        self.sigma = step("sigma", self._matrix(d.momenta, r"\mathbf{C}_t^{\top}"))
        step("M_Wphi", self._matrix(d.inertia, r"\mathbf{M}_e"), symmetric=True)
        step("K_full", self._matrix(d.stiffness, r"\mathbf{K}_e"), symmetric=True)
        self.M_eta = step("M_eta", self._column(d.inertia, r"\mathrm{diag}\,\mathbf{M}_e"))
        self.K = step("K", self._column(d.stiffness, r"\mathrm{diag}\,\mathbf{K}_e"))
        self._below("M", d.inertia)
        self._below("K", d.stiffness)
        self._damping(self.M_eta)
        if self.key.order == 2:
            self.second.momenta(self.rhoA)

    def _damping(self, inertia: Expression) -> None:
        """That of the file, or else as the link states it."""
        super()._damping(inertia)
        if FILE in self.key.damping:
            self.D = self.b.step("D", self._column(self.data.damping, r"\mathrm{diag}\,\mathbf{D}_e"))
            self._below("D", self.data.damping)

    def _below(self, name: str, full: np.ndarray) -> None:
        """The entries of a matrix below its diagonal."""
        if self.key.coupled:
            low = [full[place] for place in self.key.coupled]
            self.b.step(f"{name}_below", vector(numerals(low), rf"\mathrm{{low}}\,\mathbf{{{name}}}_e"))

    @property
    def stiffness(self) -> Expression:
        """The (r, r) stiffness of the modes."""
        return self.b.symbol("K_full")

    @property
    def resistance(self) -> Expression:
        """The (r, r) damping of the modes."""
        return self._matrix(self.data.damping, r"\mathbf{D}_e") if FILE in self.key.damping else super().resistance

    def _matrix(self, values: np.ndarray, display: str) -> Expression:
        return matrix([numerals(row) for row in values], values.shape, display)

    def _column(self, full: np.ndarray, display: str) -> Expression:
        return vector(numerals(np.diag(full)), display)


def numeral(value: float) -> sp.Expr:
    """A number of the file: exact if it is a whole number, else the nearest double."""
    return sp.Integer(int(value)) if value == int(value) else sp.Float(value)


def numerals(values: Iterable[float]) -> list[sp.Expr]:
    """Numbers of the file."""
    return [numeral(float(value)) for value in values]
