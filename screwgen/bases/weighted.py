"""Integrals of mode shapes times a property that is stated at stations along the link.

Between its stations a property is interpolated, linearly or by one polynomial through all of them. So it is the sum of
its values at the stations times *weight functions* of s, and so is each of its integrals: sums of the values times the
constants computed here, in closed form. Two stations at one place are a step.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TypeAlias

from ..lazily import mpmath
from .closed_form import ClosedForm, inner, polynomial_form
from .shapes import Shapes, rounded, to_the_end, working_digits

LINEAR, POLYNOMIAL = "linear", "polynomial"
Piece: TypeAlias = "tuple[mpmath.mpf, mpmath.mpf, tuple[tuple[int, ClosedForm], ...]]"
"""An interval of s, and the weight functions there: station and function of t in [0, 1] along the interval."""


@dataclass(frozen=True)
class Weights:
    """The weight functions of stations at ``places`` s, from 0 to 1; ``between``: ``LINEAR`` or ``POLYNOMIAL``.

    Of a rod that is one of ``segments`` equal parts, from 0 at the base, s is the place along this part.
    """

    places: tuple[float, ...]
    between: str = LINEAR
    segment: int = 0
    segments: int = 1

    def acting(self) -> list[int]:
        """The stations whose weight functions are not zero throughout."""
        return sorted({station for _, _, functions in self.pieces() for station, _ in functions})

    def pieces(self) -> list[Piece]:
        """The intervals with the weight functions, at the precision of the caller."""
        whole = self._whole()
        if self.segments == 1:
            return whole
        first, out = mpmath.mpf(self.segment) / self.segments, []
        last = mpmath.mpf(self.segment + 1) / self.segments
        for a, b, functions in whole:
            start, end = max(a, first), min(b, last)
            if end > start:
                part = (start - a) / (b - a), (end - a) / (b - a)
                own = tuple((station, form.within(*part)) for station, form in functions)
                out.append(((start - first) * self.segments, (end - first) * self.segments, own))
        return out

    @property
    def degree(self) -> int:
        """The degree of the weight functions between their ends."""
        return 1 if self.between == LINEAR else len(self.places) - 1

    def ends(self) -> list[tuple[float, float]]:
        """The intervals along which the weight functions are polynomials."""
        with mpmath.workdps(working_digits(0)):
            return [(float(a), float(b)) for a, b, _ in self.pieces()]

    def at(self, s: float) -> dict[int, float]:
        """The weight functions at s in [0, 1] that are not zero there, by station."""
        with mpmath.workdps(working_digits(0)):
            a, b, functions = next(p for p in self.pieces() if s <= p[1])
            return {station: float(form((mpmath.mpf(s) - a) / (b - a))) for station, form in functions}

    def corners(self) -> list[tuple[float, float, dict[int, tuple[float, float]]]]:
        """The intervals with the weight functions at their two ends, by station, which tell those that are linear."""
        with mpmath.workdps(working_digits(0)):
            at = lambda form: (float(form(mpmath.mpf(0))), float(form(mpmath.mpf(1))))  # noqa: E731
            return [(float(a), float(b), {k: at(form) for k, form in own}) for a, b, own in self.pieces()]

    def _whole(self) -> list[Piece]:
        """Those along the whole link."""
        zero, one = mpmath.mpf(0), mpmath.mpf(1)
        s = [mpmath.mpf(place) for place in self.places]
        if self.between == POLYNOMIAL:
            return [(zero, one, tuple((a, _lagrange(s, a)) for a in range(len(s))))]
        falling, rising = polynomial_form([one, -one]), polynomial_form([zero, one])
        pairs = [(a, s[a], s[a + 1]) for a in range(len(s) - 1)]
        return [(start, end, ((a, falling), (a + 1, rising))) for a, start, end in pairs if end > start]


@cache
def weighted_powers(weights: Weights, power: int) -> tuple[float, ...]:
    """The integrals of ``s^power`` times each weight function."""
    with mpmath.workdps(working_digits(0)):
        pieces = weights.pieces()
        return rounded(_integrals(weights, pieces, _local(pieces, _monomial(power))))


@cache
def weighted_shapes(weights: Weights, shapes: Shapes, power: int, order: int = 0) -> tuple[tuple[float, ...], ...]:
    """The integrals of ``s^power`` times the derivative of that order of psi_k times each weight function.

    count x stations.
    """
    with mpmath.workdps(working_digits(shapes.count)):
        pieces = weights.pieces()
        forms = (_local(pieces, _monomial(power) * psi.derivative(order)) for psi in shapes.functions)
        return tuple(rounded(_integrals(weights, pieces, local)) for local in forms)


@cache
def weighted_products(weights: Weights, a: Shapes, b: Shapes, order: int = 0) -> tuple:
    """The integrals of the derivatives of that order of psi_k of ``a`` and psi_l of ``b`` times each weight function.

    a.count x b.count x stations.
    """
    with mpmath.workdps(working_digits(max(a.count, b.count))):
        pieces = weights.pieces()
        first, second = ([_local(pieces, psi.derivative(order)) for psi in x.functions] for x in (a, b))

        def product(k: int, l: int) -> tuple[float, ...]:
            return rounded(_integrals(weights, pieces, [f * g for f, g in zip(first[k], second[l], strict=True)]))

        if a is not b:
            return tuple(tuple(product(k, l) for l in range(b.count)) for k in range(a.count))
        lower = [[product(k, l) for l in range(k + 1)] for k in range(a.count)]
        return tuple(tuple(lower[max(k, l)][min(k, l)] for l in range(b.count)) for k in range(a.count))


@cache
def weighted_integrals(
    weights: Weights, a: Shapes, b: Shapes, first: int, second: int, times: int, power: int
) -> tuple[tuple[tuple[float, ...], ...], ...]:
    """The integrals of ``s^power F`` times each weight function: a.count x b.count x stations.

    ``F`` is psi_k^(first) of ``a`` times psi_l^(second) of ``b``, integrated ``times`` from 0. So each is one integral
    of this product times a polynomial, which differs from one interval to the next.
    """
    with mpmath.workdps(working_digits(max(a.count, b.count))):
        pieces = weights.pieces()
        sizes = [end - start for start, end, _ in pieces]
        kernels = [_kernel(pieces, sizes, station, times, power) for station in range(len(weights.places))]
        left, right = ([_local(pieces, psi.derivative(n)) for psi in x.functions] for x, n in ((a, first), (b, second)))

        def constants(f: list[ClosedForm], g: list[ClosedForm]) -> tuple[float, ...]:
            strains = [x * y for x, y in zip(f, g, strict=True)]
            parts = (zip(sizes, kernel, strains, strict=True) for kernel in kernels)
            return rounded(mpmath.fsum(size * inner(p, x) for size, p, x in own) for own in parts)

        return tuple(tuple(constants(f, g) for g in right) for f in left)


def _kernel(pieces: list[Piece], sizes: list[mpmath.mpf], station: int, times: int, power: int) -> list[ClosedForm]:
    """The polynomials p with ``∫ w s^power ∫…∫ f = ∫ p f``, one in each interval, for a station's weight function w."""
    none = polynomial_form([mpmath.mpf(0)])
    forms = [_monomial(power).within(a, b) * dict(functions).get(station, none) for a, b, functions in pieces]
    kernel = [list(form.terms[mpmath.mpf(0)]) for form in forms]
    for _ in range(times):
        kernel = to_the_end(kernel, sizes)
    return [polynomial_form(piece) for piece in kernel]


def _local(pieces: list[Piece], form: ClosedForm) -> list[ClosedForm]:
    """A function of s in every interval, as a function of t in [0, 1] along it."""
    return [form.within(start, end) for start, end, _ in pieces]


def _integrals(weights: Weights, pieces: list[Piece], local: list[ClosedForm]) -> list[mpmath.mpf]:
    """The integrals of a function, given in every interval, times each weight function."""
    out = [mpmath.mpf(0)] * len(weights.places)
    for (start, end, functions), form in zip(pieces, local, strict=True):
        for station, function in functions:
            out[station] += (end - start) * (function * form).integral()
    return out


def _monomial(power: int) -> ClosedForm:
    return polynomial_form([mpmath.mpf(0)] * power + [mpmath.mpf(1)])


def _lagrange(places: list[mpmath.mpf], a: int) -> ClosedForm:
    """The polynomial that is 1 at the place of station ``a`` and 0 at all others."""
    out = polynomial_form([mpmath.mpf(1)])
    for b, place in enumerate(places):
        if b != a:
            out = out * polynomial_form([-place, mpmath.mpf(1)]).scaled(1 / (places[a] - place))
    return out
