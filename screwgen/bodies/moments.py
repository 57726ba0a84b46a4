"""Integrals over a body by named moments.

The fields of a body depend on the place through *generators*: the coordinates of the undeformed body and the mode
shapes. Coarser generators, the position ``rho`` and the elastic velocity ``udot`` of an element, are sums of these. An
integrand is a polynomial in generators. The integral of each monomial is a *moment* that a block has named
(``∫ρA ρ dξ = S``), or it is expanded in finer generators, down to integrals that the body states in closed form.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable

import numpy as np
import sympy as sp

XI = sp.Symbol("xi", real=True)
"""The place along the centreline of a rod, from the origin of F_i."""


class Moments:
    """The generators of a body and the rule that integrates polynomials in them."""

    def __init__(self, generators: Iterable[sp.Symbol] = ()):
        self.finest = list(generators)
        self.coarse: dict[sp.Symbol, sp.Expr] = {}
        self.moments: dict[tuple, sp.Expr] = {}

    def name_coarse(self, symbols, expressions) -> None:
        """Let each symbol stand for a sum of finer generators; what is named last is expanded first."""
        self.coarse.update(zip(np.ravel(symbols), np.ravel(expressions), strict=True))

    def name_moment(self, weight: str, value: sp.Expr, *generators: sp.Symbol) -> None:
        """Let ``value`` be the integral of ``weight`` times the product of ``generators``."""
        self.moments[(weight, _key(generators))] = value

    def integrate(self, entry: sp.Expr, weight: str | None) -> sp.Expr:
        """``∫ weight · entry dξ`` over the body; ``weight`` names a density (None: 1)."""
        free = entry.free_symbols
        generators = {g for g in self._generators() if g in free}
        if not generators:
            return sp.S.Zero if entry == 0 else entry * self._moment(weight, ())
        coefficients: dict[tuple, list[sp.Expr]] = {}
        for term in sp.Add.make_args(sp.expand(entry)):
            monomial, rest = [], []
            for factor in sp.Mul.make_args(term):
                base, power = factor.as_base_exp()
                if base in generators:
                    monomial += [base] * int(power)
                else:
                    rest.append(factor)
            coefficients.setdefault(_key(monomial), []).append(sp.Mul(*rest))
        return sp.Add(*(sp.Add(*parts) * self._moment(weight, key) for key, parts in coefficients.items()))

    def _generators(self):
        return itertools.chain(self.coarse, self.finest)

    def _moment(self, weight: str | None, key: tuple) -> sp.Expr:
        if (weight, key) in self.moments:
            return self.moments[weight, key]
        by_name = {g.name: g for g in self._generators()}
        monomial = [by_name[n] for n in key]
        for generator in reversed(self.coarse):
            if generator in monomial:
                monomial.remove(generator)
                return self.integrate(sp.expand(sp.Mul(*monomial) * self.coarse[generator]), weight)
        return self._weighted(weight, monomial)

    def _weighted(self, weight: str | None, monomial: list[sp.Symbol]) -> sp.Expr:
        """The integral of ``weight``, which is uniform, times a product of the finest generators."""
        value = self._fine(monomial)
        return value if weight is None else sp.Symbol(weight, real=True) * value

    def _fine(self, monomial: list[sp.Symbol]) -> sp.Expr:
        """The integral of a product of the finest generators; a rigid body names all of its moments."""
        raise ValueError(f"no closed form for the integral of {sp.Mul(*monomial)}")


def _key(generators) -> tuple[str, ...]:
    return tuple(sorted(g.name for g in generators))
