"""Integrals of mode shapes times a property that is stated at stations along the link.

Between its stations a property is interpolated, linearly or by one polynomial through all of them. So it is the sum of
its values at the stations times *weight functions* of s, and so is each of its integrals: sums of the values times the
constants computed here, in closed form. Two stations at one place are a step.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import mpmath
from mpmath import mpf

from .functions import ClosedForm, polynomial_form
from .shapes import Shapes, rounded, working_digits

LINEAR, POLYNOMIAL = "linear", "polynomial"
Piece = tuple[mpf, mpf, tuple[tuple[int, ClosedForm], ...]]
"""An interval of s, and the weight functions there: station and function of t in [0, 1] along the interval."""


@dataclass(frozen=True)
class Weights:
    """The weight functions of stations at ``places`` s, from 0 to 1; ``between``: ``LINEAR`` or ``POLYNOMIAL``."""

    places: tuple[float, ...]
    between: str = LINEAR

    def pieces(self) -> list[Piece]:
        """The intervals with the weight functions, at the precision of the caller."""
        s = [mpf(place) for place in self.places]
        if self.between == POLYNOMIAL:
            return [(mpf(0), mpf(1), tuple((a, _lagrange(s, a)) for a in range(len(s))))]
        falling, rising = polynomial_form([mpf(1), mpf(-1)]), polynomial_form([mpf(0), mpf(1)])
        pairs = [(a, s[a], s[a + 1]) for a in range(len(s) - 1)]
        return [(start, end, ((a, falling), (a + 1, rising))) for a, start, end in pairs if end > start]


@cache
def weighted_powers(weights: Weights, power: int) -> tuple[float, ...]:
    """The integrals of ``s^power`` times each weight function."""
    with mpmath.workdps(working_digits(0)):
        return rounded(_integrals(weights, _monomial(power)))


@cache
def weighted_shapes(weights: Weights, shapes: Shapes, power: int) -> tuple[tuple[float, ...], ...]:
    """The integrals of ``s^power psi_k`` times each weight function: count x stations."""
    with mpmath.workdps(working_digits(shapes.count)):
        return tuple(rounded(_integrals(weights, _monomial(power) * psi)) for psi in shapes.functions)


@cache
def weighted_products(weights: Weights, a: Shapes, b: Shapes, order: int = 0) -> tuple:
    """The integrals of the derivatives of that order of psi_k of ``a`` and psi_l of ``b`` times each weight function.

    a.count x b.count x stations.
    """
    with mpmath.workdps(working_digits(max(a.count, b.count))):
        first, second = ([psi.derivative(order) for psi in x.functions] for x in (a, b))
        product = lambda k, l: rounded(_integrals(weights, first[k] * second[l]))  # noqa: E731
        if a is not b:
            return tuple(tuple(product(k, l) for l in range(b.count)) for k in range(a.count))
        lower = [[product(k, l) for l in range(k + 1)] for k in range(a.count)]
        return tuple(tuple(lower[max(k, l)][min(k, l)] for l in range(b.count)) for k in range(a.count))


def _integrals(weights: Weights, form: ClosedForm) -> list[mpf]:
    out = [mpf(0)] * len(weights.places)
    for start, end, functions in weights.pieces():
        local = form.within(start, end).scaled(end - start)
        for station, function in functions:
            out[station] += (function * local).integral()
    return out


def _monomial(power: int) -> ClosedForm:
    return polynomial_form([mpf(0)] * power + [mpf(1)])


def _lagrange(places: list[mpf], a: int) -> ClosedForm:
    """The polynomial that is 1 at the place of station ``a`` and 0 at all others."""
    out = polynomial_form([mpf(1)])
    for b, place in enumerate(places):
        if b != a:
            out = out * polynomial_form([-place, mpf(1)]).scaled(1 / (places[a] - place))
    return out
