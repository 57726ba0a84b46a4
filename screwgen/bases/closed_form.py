"""One closed representation for the shapes of every basis.

A `ClosedForm` is a finite sum of terms ``c s^n exp(alpha s)`` on the dimensionless abscissa ``s`` in [0, 1],
with complex ``alpha``. Polynomials, sines and hyperbolic functions are all of this kind. The kind is closed
under sums, products and derivatives, and its definite integrals are known: no basis ever needs a quadrature.

Every operation works at the mpmath precision of its caller, who sets it locally by ``mpmath.workdps``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import zip_longest
from math import comb
from typing import TypeAlias

from ..lazily import mpmath

Scalar: TypeAlias = "mpmath.mpf | mpmath.mpc"


class ClosedForm:
    """A real function of s: the sum over alpha of ``exp(alpha s) (c_0 + c_1 s + c_2 s^2 + ...)``.

    Complex exponents come in conjugate pairs with conjugate coefficients: the function itself is real.
    """

    __slots__ = ("terms",)

    def __init__(self, terms: Mapping[Scalar, Sequence[Scalar]]):
        """`terms` maps each exponent alpha to its coefficients (c_0, c_1, ...), lowest power first."""
        self.terms = {alpha: tuple(coefficients) for alpha, coefficients in terms.items()}

    def __call__(self, s: Scalar | float) -> mpmath.mpf:
        """The function's value at `s`."""
        values = (mpmath.exp(alpha * s) * mpmath.polyval(c[::-1], s) for alpha, c in self.terms.items())
        return mpmath.re(mpmath.fsum(values))

    def __add__(self, other: ClosedForm) -> ClosedForm:
        terms = dict(self.terms)
        for alpha, c in other.terms.items():
            terms[alpha] = _sum(terms.get(alpha, ()), c)
        return ClosedForm(terms)

    def __mul__(self, other: ClosedForm) -> ClosedForm:
        terms: dict[Scalar, tuple[Scalar, ...]] = {}
        for alpha, a in self.terms.items():
            for beta, b in other.terms.items():
                terms[alpha + beta] = _sum(terms.get(alpha + beta, ()), _convolution(a, b))
        return ClosedForm(terms)

    def scaled(self, factor: Scalar) -> ClosedForm:
        """The function times a number."""
        return ClosedForm({alpha: [factor * x for x in c] for alpha, c in self.terms.items()})

    def derivative(self, order: int = 1) -> ClosedForm:
        """The derivative of that order with respect to s."""
        if order == 0:
            return self
        return ClosedForm({alpha: _slope(alpha, c) for alpha, c in self.terms.items()}).derivative(order - 1)

    def within(self, start: Scalar, end: Scalar) -> ClosedForm:
        """The function of t in [0, 1] whose value is this one's at ``start + (end - start) t``."""
        length = end - start
        if (start, length) == (0, 1):
            return self
        taylor = lambda c, j: sum(comb(n, j) * c[n] * start ** (n - j) for n in range(j, len(c)))  # noqa: E731
        factors = {alpha: mpmath.exp(alpha * start) for alpha in self.terms}
        return ClosedForm(
            {
                alpha * length: [factors[alpha] * length**j * taylor(c, j) for j in range(len(c))]
                for alpha, c in self.terms.items()
            }
        )

    def integral(self) -> mpmath.mpf:
        """The definite integral over [0, 1]."""
        parts = (mpmath.fdot(c, _moments(alpha, len(c))) for alpha, c in self.terms.items())
        return mpmath.re(mpmath.fsum(parts))


def inner(f: ClosedForm, g: ClosedForm) -> mpmath.mpf:
    """The inner product: integral of f g over [0, 1]."""
    return (f * g).integral()


def polynomial_form(coefficients: Sequence[Scalar]) -> ClosedForm:
    """The polynomial c_0 + c_1 s + c_2 s^2 + ..."""
    return ClosedForm({mpmath.mpf(0): coefficients})


def _sum(a: Sequence[Scalar], b: Sequence[Scalar]) -> tuple[Scalar, ...]:
    """Coefficients of the sum of two polynomials."""
    return tuple(x + y for x, y in zip_longest(a, b, fillvalue=mpmath.mpf(0)))


def _convolution(a: Sequence[Scalar], b: Sequence[Scalar]) -> list[Scalar]:
    """Coefficients of the product of two polynomials."""
    product: list[Scalar] = [mpmath.mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            product[i + j] += x * y
    return product


def _slope(alpha: Scalar, c: Sequence[Scalar]) -> list[Scalar]:
    """Coefficients d of exp(alpha s) in the derivative: d_n = alpha c_n + (n + 1) c_(n+1)."""
    lowered = [n * x for n, x in enumerate(c)][1:]
    return list(_sum(lowered, [alpha * x for x in c])) if alpha else lowered


def _moments(alpha: Scalar, count: int) -> list[Scalar]:
    """The integrals I_n of s^n exp(alpha s) over [0, 1] for n < count.

    By parts, I_n = (exp(alpha) - n I_(n-1)) / alpha. Rounding grows by n! / |alpha|^(n+1) on the way, so the
    recursion runs with that many digits more. This covers tiny exponents too: the 32nd sine and the 32nd
    clamped-free mode differ in frequency by 2e-43.
    """
    if not alpha:
        return [1 / mpmath.mpf(n + 1) for n in range(count)]
    with mpmath.extradps(_lost_digits(mpmath.fabs(alpha), count)):
        end = mpmath.exp(alpha)
        moments = [(end - 1) / alpha]
        for n in range(1, count):
            moments.append((end - n * moments[-1]) / alpha)
    return moments


def _lost_digits(size: mpmath.mpf, count: int) -> int:
    """Decimal digits by which n! / size^(n+1) exceeds 1 for n < count (largest at one of the two ends)."""
    ends = (mpmath.loggamma(n + 1) - (n + 1) * mpmath.log(size) for n in (0, count - 1))
    return max(0, int(mpmath.ceil(max(ends) / mpmath.ln10)))
