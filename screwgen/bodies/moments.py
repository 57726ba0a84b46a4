"""Integrals over a body by named moments.

The fields of a body depend on the place through *generators*: the coordinates of the undeformed body and the mode
shapes. Coarser generators, the position ``rho`` and the elastic velocity ``udot`` of an element, are sums of these. An
integrand is a polynomial in generators. The integral of each monomial is a *moment* that a block has named
(``∫ρA ρ dξ = S``), or it is expanded in finer generators, down to integrals that the body states in closed form.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache

import numpy as np

from ..lazily import sp

Key = tuple[str, ...]
"""A monomial: the names of its generators in order, each as often as its power."""


@cache
def xi() -> sp.Symbol:
    """The place along the centreline of a rod, from the origin of F_i."""
    return sp.Symbol("xi", real=True)


class Moments:
    """The generators of a body and the rule that integrates polynomials in them."""

    def __init__(self, generators: Iterable[sp.Symbol] = ()):
        self.finest = list(generators)
        self.coarse: dict[str, sp.Expr] = {}
        self.moments: dict[tuple[str | None, Key], sp.Expr] = {}
        self._generators = {g.name: g for g in self.finest}
        self._found: dict[tuple[str | None, Key], sp.Expr] = {}
        """The integrals of monomials so far, which hold until more is named."""
        self._finer: dict[str, dict[Key, sp.Expr]] = {}
        """What coarse generators stand for, as polynomials."""

    def name_coarse(
        self, symbols: Sequence[sp.Symbol] | np.ndarray, expressions: Sequence[sp.Expr] | np.ndarray
    ) -> None:
        """Let each symbol stand for a sum of finer generators; what is named last is expanded first."""
        for symbol, expression in zip(np.ravel(symbols), np.ravel(expressions), strict=True):
            self._generators[symbol.name], self.coarse[symbol.name] = symbol, expression
        self._found.clear()
        self._finer.clear()

    def name_moment(self, weight: str, value: sp.Expr, *generators: sp.Symbol) -> None:
        """Let ``value`` be the integral of ``weight`` times the product of ``generators``."""
        self.moments[weight, tuple(sorted(g.name for g in generators))] = value
        self._found.clear()

    def integrate(self, entry: sp.Expr, weight: str | None) -> sp.Expr:
        """``∫ weight · entry dξ`` over the body; ``weight`` names a density (None: 1)."""
        if entry.free_symbols.isdisjoint(self._generators.values()):
            return sp.S.Zero if entry == 0 else entry * self._moment(weight, ())
        return self._integrated(self._polynomial(entry), weight, ())

    def _polynomial(self, entry: sp.Expr) -> dict[Key, sp.Expr]:
        """The coefficients of an expression in the generators, by monomial."""
        coefficients: dict[Key, list[sp.Expr]] = {}
        for term in sp.Add.make_args(sp.expand(entry)):
            monomial: list[str] = []
            rest = []
            for factor in sp.Mul.make_args(term):
                base, power = factor.as_base_exp()
                if base.is_Symbol and self._generators.get(base.name) == base:
                    monomial += [base.name] * int(power)
                else:
                    rest.append(factor)
            coefficients.setdefault(tuple(sorted(monomial)), []).append(sp.Mul(*rest))
        return {key: sp.Add(*parts) for key, parts in coefficients.items()}

    def _integrated(self, polynomial: dict[Key, sp.Expr], weight: str | None, factor: Key) -> sp.Expr:
        """The integral of a polynomial times the monomial ``factor``."""
        moment = lambda key: self._moment(weight, tuple(sorted(factor + key)))  # noqa: E731
        return sp.Add(*(value * moment(key) for key, value in polynomial.items() if value != 0))

    def _moment(self, weight: str | None, key: Key) -> sp.Expr:
        if (weight, key) in self.moments:
            return self.moments[weight, key]
        if (weight, key) not in self._found:
            self._found[weight, key] = self._refined(weight, key)
        return self._found[weight, key]

    def _refined(self, weight: str | None, key: Key) -> sp.Expr:
        """The integral of a monomial that has no name, by that of finer generators."""
        for name in reversed(self.coarse):
            if name in key:
                if name not in self._finer:
                    self._finer[name] = self._polynomial(self.coarse[name])
                place = key.index(name)
                return self._integrated(self._finer[name], weight, key[:place] + key[place + 1 :])
        return self._weighted(weight, [self._generators[name] for name in key])

    def _weighted(self, weight: str | None, monomial: list[sp.Symbol]) -> sp.Expr:
        """The integral of ``weight``, which is uniform, times a product of the finest generators."""
        value = self._fine(monomial)
        return value if weight is None else sp.Symbol(weight, real=True) * value

    def _fine(self, monomial: list[sp.Symbol]) -> sp.Expr:
        """The integral of a product of the finest generators; a rigid body names all of its moments."""
        raise ValueError(f"no closed form for the integral of {sp.Mul(*monomial)}")
