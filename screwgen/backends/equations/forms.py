"""The form of equations, chosen by its size: angles in sums or in products, brackets about what occurs most often.

Every choice is made by counting, and equal counts by a fixed order, so one robot has one form.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial

from .ring import COORDINATE, ExactSum, Exponent, Monomial, Ring
from .trees import Atom, Factors, FormulaProduct, FormulaSum, degree, rank, symbol

Flat = tuple[Fraction, Factors]
"""A number and powers of atoms."""
Waves = dict[tuple[tuple[int, Exponent], ...], tuple[Fraction, Fraction]]
"""What the cosine and the sine of each sum of angles are multiplied by."""

TINY = Fraction(1, 10**13)
"""A coefficient below this times the largest is what rounding left of floats that cancel."""


def flat(a: ExactSum, products: bool) -> list[Flat]:
    """The terms in sines and cosines of sums of angles, or, with ``products``, in products where two terms make one."""
    out: list[Flat] = []
    largest = max((abs(Fraction(c)) for c in a.terms.values()), default=Fraction(0))
    for rest, waves in _waves(a).items():
        own = tuple((symbol(number), e) for number, e in rest)
        for c, atoms in _merged(waves) if products else _harmonics(waves):
            if abs(c) > TINY * largest:
                out.append((c, _times(own, atoms)))
    return sorted(out, key=lambda term: term[1])


def _times(*groups: Factors) -> Factors:
    powers: dict[Atom, Exponent] = {}
    for atom, e in (f for group in groups for f in group):
        powers[atom] = powers.get(atom, 0) + e
    return tuple(sorted((atom, e) for atom, e in powers.items() if e))


def _waves(a: ExactSum) -> dict[Monomial, Waves]:
    """By what is no exponential of an angle: the coefficients of cosines and sines."""
    ring, i = a.ring, a.ring.imaginary.number
    groups: dict[Monomial, Waves] = {}
    for m, c in a.sorted():
        angles = tuple((g.angle.number, e) for n, e in m if (g := ring.generators[n]).angle is not None)
        rest = tuple((n, e) for n, e in m if n != i and ring.generators[n].angle is None)
        imaginary, sign = any(n == i for n, _ in m), 1
        if angles and angles[0][1] < 0:
            angles, sign = tuple((n, -e) for n, e in angles), -1
        cosine, sine = groups.setdefault(rest, {}).get(angles, (Fraction(0), Fraction(0)))
        groups[rest][angles] = (cosine, sine - sign * c) if imaginary else (cosine + c, sine)
    return groups


def _harmonics(waves: Waves) -> list[Flat]:
    out: list[Flat] = []
    for angles, (cosine, sine) in waves.items():
        for function, c in (("cos", cosine), ("sin", sine)):
            if c:
                out.append((Fraction(c), ((Atom(function, angles), 1),) if angles else ()))
    return out


def _merged(waves: Waves) -> list[Flat]:
    """Two harmonics of equal size as one product, such as ``1/2 - cos(2 q)/2`` as ``sin(q)^2``; ``sin(2 q)`` too."""
    out: list[Flat] = []
    for part, function in ((0, "cos"), (1, "sin")):
        left = {angles: Fraction(pair[part]) for angles, pair in sorted(waves.items()) if pair[part]}
        while left:
            angles, c = left.popitem()
            pairs = ((other, _halves(angles, other)) for other in left if abs(left[other]) == abs(c))
            other, halves = next(((o, h) for o, h in pairs if h is not None), (None, None))
            if other is not None and halves is not None:
                out.append(_product(function, c, c == left.pop(other), *halves))
            elif function == "sin" and (halves := _halves(angles, ())) is not None:
                out.append((2 * c, _times(*(_function(f, halves[0])[1] for f in ("sin", "cos")))))
            else:
                out += _harmonics({angles: (c, Fraction(0)) if part == 0 else (Fraction(0), c)})
    return out


def _halves(a: Monomial, b: Monomial) -> tuple[Monomial, Monomial] | None:
    """Half the sum and half the difference of two sums of angles, if both are whole."""
    first, second = dict(a), dict(b)
    both = sorted({*first, *second})
    sums = [(n, (first.get(n, 0) + second.get(n, 0)) / Fraction(2)) for n in both]
    differences = [(n, (first.get(n, 0) - second.get(n, 0)) / Fraction(2)) for n in both]
    if any(e.denominator > 1 for _, e in (*sums, *differences)):
        return None
    whole = lambda values: tuple((n, int(e)) for n, e in values if e)  # noqa: E731
    return whole(sums), whole(differences)


def _product(function: str, c: Fraction, plus: bool, half: Monomial, rest: Monomial) -> Flat:
    """``c`` times the sum or difference of the functions of ``half + rest`` and ``half - rest``."""
    if function == "cos":
        names, sign = (("cos", "cos"), 2) if plus else (("sin", "sin"), -2)
    else:
        names, sign = (("sin", "cos"), 2) if plus else (("cos", "sin"), 2)
    pairs = [_function(name, angles) for name, angles in zip(names, (half, rest), strict=True)]
    for own, _ in pairs:
        sign *= own
    return sign * c, _times(*(factors for _, factors in pairs))


def _function(name: str, angles: Monomial) -> tuple[int, Factors]:
    """Sine or cosine with the first angle positive, and its sign."""
    if not angles:
        return 1, ()
    if angles[0][1] < 0:
        return (-1 if name == "sin" else 1), ((Atom(name, tuple((n, -e) for n, e in angles)), 1),)
    return 1, ((Atom(name, angles), 1),)


# ------------------------------------------------------------------------------------------ brackets

Choice = Callable[[Ring, Atom, int], tuple]
"""Ranks an atom that occurs in so many terms: the smallest is put before a bracket."""
ORDERS: tuple[Choice, ...] = (
    lambda ring, atom, times: (-times, -rank(ring, atom)),
    lambda ring, atom, times: (-times, rank(ring, atom)),
    lambda ring, atom, times: (rank(ring, atom) != 2, -times, rank(ring, atom)),
    lambda ring, atom, times: (rank(ring, atom) != 3, -times, rank(ring, atom)),
    lambda ring, atom, times: (rank(ring, atom), -times),
)


DEPTHS = (1, 2, 9)
"""How deep brackets may stand in each other."""
NESTED = 2
"""What a bracket in a bracket costs a reader, in operations."""


def written(ring: Ring, terms: Sequence[Flat]) -> FormulaSum:
    """The smallest of a few forms with brackets; polynomials in the elastic coordinates by rising degree."""
    if not terms:
        return FormulaSum(())
    forms = (by_degree(ring, terms, order, depth) for depth in DEPTHS for order in ORDERS)
    return min(forms, key=lambda form: form.operations + NESTED * form.nested)


def by_degree(ring: Ring, terms: Sequence[Flat], order: Choice, depth: int) -> FormulaSum:
    """The powers of elastic coordinates, each with its coefficient in brackets."""
    groups: dict[Factors, list[Flat]] = {}
    for c, factors in terms:
        own = tuple(f for f in factors if _is_elastic(ring, f[0]))
        groups.setdefault(own, []).append((c, tuple(f for f in factors if f not in own)))
    out: list[FormulaProduct] = []
    for own in sorted(groups, key=lambda own: (degree(ring, own), own)):
        inner = bracketed(ring, groups[own], order, depth)
        if not own:
            out += inner.terms
        elif len(inner.terms) == 1:
            (only,) = inner.terms
            out.append(FormulaProduct(only.coefficient, _ordered(ring, _times(only.factors, own)), only.inner))
        else:
            out.append(FormulaProduct(Fraction(1), own, inner))
    return _common(ring, out)


def _common(ring: Ring, terms: list[FormulaProduct]) -> FormulaSum:
    """A sum of which all terms have a factor: the factor before a bracket."""
    if len(terms) < 2:
        return FormulaSum(tuple(terms))
    shared = _shared([term.factors for term in terms])
    if not shared:
        return FormulaSum(_sorted(ring, terms))
    inner: list[FormulaProduct] = []
    for term in terms:
        left = _ordered(ring, _without(term.factors, shared))
        inner += _opened(FormulaProduct(term.coefficient, left, term.inner))
    return FormulaSum((FormulaProduct(Fraction(1), _ordered(ring, shared), FormulaSum(_sorted(ring, inner))),))


def _opened(term: FormulaProduct) -> list[FormulaProduct]:
    """A bracket without a factor, as its terms."""
    if term.factors or term.inner is None or abs(term.coefficient) != 1:
        return [term]
    return [FormulaProduct(term.coefficient * t.coefficient, t.factors, t.inner) for t in term.inner.terms]


def bracketed(ring: Ring, terms: Sequence[Flat], order: Choice, depth: int) -> FormulaSum:
    """What all terms share goes before a bracket, then what the order prefers of what occurs in several terms."""
    if len(terms) == 1:
        c, factors = terms[0]
        return FormulaSum((FormulaProduct(c, _ordered(ring, factors)),))
    shared, number = _shared([factors for _, factors in terms]), _content([c for c, _ in terms])
    if shared or number != 1:
        inner = bracketed(ring, [(c / number, _without(factors, shared)) for c, factors in terms], order, depth)
        return FormulaSum((_before(ring, number, shared, inner),))
    counts: dict[Atom, int] = {}
    for _, factors in terms:
        for atom, e in factors:
            counts[atom] = counts.get(atom, 0) + (e > 0)
    several = [atom for atom, times in counts.items() if times > 1 and depth > 0]
    if not several:
        return FormulaSum(_sorted(ring, [FormulaProduct(c, _ordered(ring, factors)) for c, factors in terms]))
    chosen = min(several, key=lambda atom: (*order(ring, atom, counts[atom]), atom))
    held = [term for term in terms if any(atom == chosen and e > 0 for atom, e in term[1])]
    others = [term for term in terms if term not in held]
    parts = [*bracketed(ring, held, order, depth - 1).terms, *bracketed(ring, others, order, depth).terms]
    return FormulaSum(_sorted(ring, parts))


def _before(ring: Ring, number: Fraction, factors: Factors, inner: FormulaSum) -> FormulaProduct:
    if len(inner.terms) > 1:
        return FormulaProduct(number, _ordered(ring, factors), inner)
    (only,) = inner.terms
    return FormulaProduct(number * only.coefficient, _ordered(ring, _times(factors, only.factors)), only.inner)


def _shared(all_factors: Sequence[Factors]) -> Factors:
    """The powers that divide all terms; of what stands below all, the least power."""
    first, *others = (dict(factors) for factors in all_factors)
    out = []
    for atom, e in first.items():
        powers = [e, *(other.get(atom, 0) for other in others)]
        if all(p > 0 for p in powers) or all(p < 0 for p in powers):
            out.append((atom, min(powers, key=lambda power: abs(Fraction(power)))))
    return tuple(sorted(out))


def _without(factors: Factors, shared: Factors) -> Factors:
    return _times(factors, tuple((atom, -e) for atom, e in shared))


def _content(coefficients: Sequence[Fraction]) -> Fraction:
    """The number that is taken before a bracket: one that two terms have and that divides all, or a minus sign."""
    sizes = [abs(c) for c in coefficients]
    size = min(sizes)
    if len(set(sizes)) > 1 and (size < 1 or sizes.count(size) == 1 or any((c / size).denominator != 1 for c in sizes)):
        size = Fraction(1)
    return -size if all(c < 0 for c in coefficients) else size


def _ordered(ring: Ring, factors: Factors) -> Factors:
    return tuple(sorted(factors, key=lambda f: (rank(ring, f[0]), f[0])))


def _sorted(ring: Ring, terms: Sequence[FormulaProduct]) -> tuple[FormulaProduct, ...]:
    """By degree, then constants before what moves; of those of least degree a positive term comes first."""
    ordered = sorted(terms, key=partial(_place, ring))
    lowest = degree(ring, ordered[0].factors)
    alike = (k for k, t in enumerate(ordered) if t.coefficient > 0 and degree(ring, t.factors) == lowest)
    first = next(alike, 0)
    return (ordered[first], *ordered[:first], *ordered[first + 1 :])


def _place(ring: Ring, term: FormulaProduct) -> tuple:
    moving = max((rank(ring, atom) for atom in term.atoms()), default=0)
    powers = tuple((atom, -e) for atom, e in term.factors)
    angles = max((len(atom.of) for atom in term.atoms() if atom.function), default=0)
    return degree(ring, term.factors), moving, angles, term.inner is not None, powers, -term.coefficient


def _is_elastic(ring: Ring, atom: Atom) -> bool:
    generator = ring.generators[atom.of[0][0]]
    return not atom.function and generator.kind == COORDINATE and generator.wave is None
