"""`Shapes`: the constants of one basis, as plain numbers, computed from its functions in closed form.

With the abscissa s = (xi - a) / l in [0, 1] every quantity here is dimensionless. The functions are
orthonormal on [0, 1] and their stiffness is diagonal, so five numbers per mode describe a basis.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache

from ..digits import telling
from ..lazily import mpmath
from .closed_form import ClosedForm, inner, polynomial_form

Matrix = tuple[tuple[float, ...], ...]

NEGLIGIBLE = 1e-30
"""Distance from an integer below which a constant is that integer: orthogonality is an exact zero."""


@dataclass(frozen=True)
class Family:
    """What the modes of a basis have in common: the words and formulas by which documents define it."""

    name: str
    """Name of the shapes: the basis, and what deflects where a basis has different ones."""
    title: str
    """Name in prose."""
    formula: str
    r"""LaTeX equation of the k-th function, \psi_k(s) = ..."""
    condition: str
    """LaTeX equation that fixes the eigenvalues."""
    order: int
    """Order of the derivative that stores energy: 2 in bending (curvature), 1 in stretching and torsion."""
    changes: bool = False
    """Whether all shapes change with their number."""
    about: str = ""
    """What the letters of the formula mean, and how shapes are ordered and signed."""


@dataclass(frozen=True, eq=False)
class Shapes:
    """The first modes of one basis; every tuple has one entry per mode, all dimensionless."""

    family: Family
    functions: tuple[ClosedForm, ...]
    """psi_k, in closed form."""
    formulas: tuple[str, ...]
    """LaTeX right-hand side of each psi_k(s) with its numbers rounded to seven digits, for documents."""
    eigenvalues: tuple[float, ...]
    """The numbers that `family.condition` fixes."""
    integral: tuple[float, ...]
    """Integral of psi_k over [0, 1]."""
    moment: tuple[float, ...]
    """Integral of s psi_k over [0, 1]."""
    stiffness: tuple[float, ...]
    """Integral of the squared derivative of order `family.order` (for k != l the mixed integral is zero)."""
    tip_value: tuple[float, ...]
    """psi_k(1)."""
    tip_slope: tuple[float, ...]
    """psi_k'(1), derivative with respect to s."""

    @property
    def count(self) -> int:
        """Number of modes."""
        return len(self.functions)

    def evaluate(self, points: Iterable[float], derivative: int = 0) -> Matrix:
        """The derivatives of that order of all modes at `points` in [0, 1]: count x len(points).

        Computed like the constants and rounded once, so right to the last bit or so for every mode.
        """
        points = tuple(points)
        with mpmath.workdps(working_digits(self.count)):
            forms = [psi.derivative(derivative) for psi in self.functions]
            return tuple(rounded(form(mpmath.mpf(float(s))) for s in points) for form in forms)


def working_digits(count: int) -> int:
    """Decimal digits that leave more than 50 right ones with `count` modes.

    Sums of monomials cancel most: coefficients of the shifted Jacobi polynomial of degree n grow as
    (3 + 2 sqrt 2)^n, their products as 10^(1.54 n).
    """
    return 70 + 2 * count


def rounded(values: Iterable[mpmath.mpf]) -> tuple[float, ...]:
    """Doubles nearest to `values`; those within `NEGLIGIBLE` of an integer become that integer."""
    return tuple(_rounded(value) for value in values)


def _rounded(value: mpmath.mpf) -> float:
    integer = mpmath.nint(value)
    return float(integer if abs(value - integer) < NEGLIGIBLE else value) + 0.0  # + 0.0: no negative zero


def tabulate(
    family: Family, functions: Sequence[ClosedForm], eigenvalues: Sequence[mpmath.mpf], formulas: Sequence[str]
) -> Shapes:
    """The constants of orthonormal `functions`, at the precision of the caller, who sets `working_digits`."""
    abscissa = ClosedForm({mpmath.mpf(0): (mpmath.mpf(0), mpmath.mpf(1))})
    strains = [psi.derivative(family.order) for psi in functions]
    return Shapes(
        family=family,
        functions=tuple(functions),
        formulas=tuple(formulas),
        eigenvalues=rounded(eigenvalues),
        integral=rounded(psi.integral() for psi in functions),
        moment=rounded(inner(abscissa, psi) for psi in functions),
        stiffness=rounded(inner(strain, strain) for strain in strains),
        tip_value=rounded(psi(1) for psi in functions),
        tip_slope=rounded(psi.derivative()(1) for psi in functions),
    )


@cache
def products(a: Shapes, b: Shapes) -> Matrix:
    """The integrals over [0, 1] of psi_k of `a` times psi_l of `b`: a.count x b.count, dimensionless.

    Within one basis this is the identity, exactly.
    """
    if a is b:
        return tuple(tuple(float(k == l) for l in range(a.count)) for k in range(a.count))
    with mpmath.workdps(working_digits(max(a.count, b.count))):
        return tuple(rounded(inner(f, g) for g in b.functions) for f in a.functions)


@cache
def integrals(
    a: Shapes, b: Shapes, first: int, second: int, times: int, weight: int | None = None, end: float = 1.0
) -> Matrix:
    """Integrals of f = psi_k^(first) of `a` times psi_l^(second) of `b`: a.count x b.count, dimensionless.

    `weight` None: f integrated `times` (1 or more) from 0, at s = `end`. Otherwise the integral over [0, 1] of s^weight
    times that repeated integral. Both are single integrals of f times a polynomial.
    """
    digits = working_digits(max(a.count, b.count))
    with mpmath.workdps(digits):
        kernel = [[mpmath.mpf(0)] * (weight or 0) + [mpmath.mpf(1)]]
        for _ in range(times - (weight is None)):
            kernel = to_the_end(kernel, [mpmath.mpf(1)])
        scale = mpmath.mpf(end) ** times  # f on [0, end] is a function on [0, 1], each integral of it times `end`
        part = lambda psi, order: psi.derivative(order).within(mpmath.mpf(0), mpmath.mpf(end))  # noqa: E731
        left = [polynomial_form(*kernel) * part(psi, first) for psi in a.functions]
        right = [part(psi, second) for psi in b.functions]
        return tuple(rounded(scale * inner(f, g) for g in right) for f in left)


def to_the_end(pieces: Sequence[Sequence[mpmath.mpf]], sizes: Sequence[mpmath.mpf]) -> list[list[mpmath.mpf]]:
    """The integral from s to 1 of a function of s that is polynomial in intervals, in the same form.

    `pieces`: for every interval the coefficients in t from 0 to 1 along it; `sizes`: their lengths. This moves an
    integral from one factor to the other, ``∫ g(s) ∫_0^s f = ∫ f(s) ∫_s^1 g``.
    """
    out, rest = [], mpmath.mpf(0)
    for piece, size in zip(reversed(pieces), reversed(sizes), strict=True):
        primitive = [size * c / (n + 1) for n, c in enumerate(piece)]
        rest += mpmath.fsum(primitive)
        out.append([rest, *(-c for c in primitive)])
    return out[::-1]


def latex_number(value: mpmath.mpf, digits: int = 7) -> str:
    """`value` in LaTeX, rounded to that many significant digits, or to as few as tell it among doubles."""
    mantissa, _, exponent = mpmath.nstr(value, telling(float(value), digits), min_fixed=-3, max_fixed=7).partition("e")
    return mantissa + (rf"\times 10^{{{int(exponent)}}}" if exponent else "")
