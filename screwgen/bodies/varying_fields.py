"""Integrals along a rod whose sections vary: its properties are stated at stations."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..bases import ORDER
from ..bases.weighted import Weights, weighted_integrals, weighted_powers, weighted_products, weighted_shapes
from ..lazily import sp
from ..spec.link_class import LinkClass
from .fields import Fields, number, xi


def weights(key: LinkClass) -> Weights:
    """The weight functions of the stations along a link or a segment of it."""
    return Weights(key.stations, key.between, key.segment, key.segments)


class VaryingFields(Fields):
    """Fields along a rod of varying section: every integral is linear in the values of a property at the stations."""

    def __init__(self, key: LinkClass, length: sp.Expr, start: sp.Expr):
        super().__init__(key, length, start)
        self.weights = weights(key)
        self.properties: dict[str, Sequence[sp.Symbol]] = {}
        """The values at the stations of each property that is a weight."""

    def _weighted(self, weight: str | None, monomial: list[sp.Symbol]) -> sp.Expr:
        if weight not in self.properties:
            return super()._weighted(weight, monomial)
        l, values = self.length, self.properties[weight]
        mean = lambda constants: sp.Add(*(number(c) * v for c, v in zip(constants, values, strict=True)))  # noqa: E731
        return sp.Add(*(l**n * factor * mean(constants) for n, factor, constants in self._terms(monomial)))

    def _terms(self, monomial: list[sp.Symbol]) -> Iterator[tuple[int, sp.Expr | int, Sequence[float]]]:
        """The integral of a product of ξ, φ_k, slopes and strain shapes: power of l, factor, a constant per station."""
        shapes = [self._shape(self.phi.index(g)) for g in monomial if g in self.phi]
        strains = [self.strain_shape.index(g) for g in monomial if g in self.strain_shape]
        power = sum(g == xi() for g in monomial)
        if second := [g for g in monomial if g in self.second]:
            if len(monomial) == 1 + power:
                for n, factor, part, k in self._arms(second[0], power):
                    yield n, factor, weighted_integrals(self.weights, *part.strains, k)[part.i][part.j]
        elif slopes := [self._shape(k) for k in self._slopes(monomial)]:
            (a, i), (_, j) = slopes[0], slopes[-1]
            if len(slopes) == 1:
                yield 0, 1, weighted_shapes(self.weights, a, 0, 1)[i]
            else:
                yield -1, 1, weighted_products(self.weights, a, a, 1)[i][j]
        elif len(strains) == 2:
            yield self._strain_term(*strains)
        elif len(shapes) == 2 and not power:
            (a, i), (b, j) = shapes
            yield 1, 1, weighted_products(self.weights, a, b)[i][j]
        elif len(shapes) < 2 and not strains:
            for n in range(power + 1):
                factor = sp.binomial(power, n) * self.start ** (power - n)
                constants = [weighted_shapes(self.weights, a, n)[i] for a, i in shapes]
                yield n + 1, factor, constants[0] if constants else weighted_powers(self.weights, n)
        else:
            raise ValueError(f"no closed form for the integral of {sp.Mul(*monomial)}")

    def _strain_term(self, k: int, m: int) -> tuple[int, int, Sequence[float]]:
        (direction, i), (other, j), (shape, _) = self.key.directions[k], self.key.directions[m], self._shape(k)
        if direction != other:
            return 0, 0, [0.0] * len(self.weights.places)
        order = ORDER[direction]
        return 1 - 2 * order, 1, weighted_products(self.weights, shape, shape, order)[i][j]
