"""Exact sums of monomials: the algebra on which the programs of a robot are run for its equations in scalars.

An example: ``cos(q) cos(q)``. With ``z = exp(i q)`` the cosine is ``z/2 + 1/(2 z)``, and its square
``z²/4 + 1/2 + 1/(4 z²)``, which is ``1/2 + cos(2 q)/2``. So sines and cosines of sums are powers of such ``z``, beside
parameters, coordinates and rates; equal values are equal sums, whatever way they were computed. Nothing is guessed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ...errors import UsageError
from .numbers import recognised

Exponent = int | Fraction
Monomial = tuple[tuple[int, Exponent], ...]
"""Numbers of generators with their exponents, rising; the empty one is 1."""
Number = int | Fraction


PARAMETER, COORDINATE, RATE = "parameter", "coordinate", "rate"


class TooLargeError(UsageError):
    """Sums of more terms than anyone reads."""


@dataclass(eq=False)
class Generator:
    """What monomials are made of: a symbol, the exponential of an angle, or a named part of other sums.

    ``square``: its square, of a root or of i; ``angle``: the generator whose exponential it is; ``part``: what it
    stands for; ``kind``: of a symbol.
    """

    ring: Ring
    number: int
    name: str
    square: int = 0
    angle: Generator | None = None
    wave: Generator | None = None
    part: ExactSum | None = None
    kind: str = ""


class Ring:
    """Generators, and the products of their monomials; ``budget`` is the number of products of terms it may take."""

    def __init__(self, budget: int):
        self.budget, self.spent = budget, 0
        self.generators: list[Generator] = []
        self._products: dict[tuple[Monomial, Monomial], tuple[Monomial, int]] = {}
        self.imaginary = self.generator("i", square=-1)
        self.i = self.of(self.imaginary)
        self.roots: dict[int, Generator] = {}
        self.pi = self.generator("pi")
        self.open: dict[tuple[int, ExactSum], Generator] = {}

    def generator(self, name: str, kind: str = "", square: int = 0, angle: Generator | None = None) -> Generator:
        """A new one."""
        made = Generator(self, len(self.generators), name, square, angle, kind=kind)
        self.generators.append(made)
        return made

    def turning(self, name: str, kind: str = "") -> Generator:
        """A new angle: it has sines and cosines."""
        angle = self.generator(name, kind)
        angle.wave = self.generator(f"exp(i {name})", angle=angle)
        return angle

    def named(self, name: str, part: ExactSum, turns: bool = False) -> Generator:
        """The generator that stands for a sum."""
        made = self.turning(name) if turns else self.generator(name)
        made.part = part
        return made

    def of(self, generator: Generator, exponent: Exponent = 1, factor: Number = 1) -> ExactSum:
        """A power of a generator."""
        return ExactSum(self, {((generator.number, exponent),): factor})

    def literal(self, x: Any) -> ExactSum:
        """A number; roots and π in it are recognised."""
        if isinstance(x, ExactSum):
            return x
        fraction, roots, power = recognised(x)
        if not fraction:
            return ExactSum(self, {})
        factors = [(self.root(prime).number, 1) for prime in roots]
        return ExactSum(self, {tuple(sorted(factors + [(self.pi.number, power)] * (power > 0))): fraction})

    def root(self, prime: int) -> Generator:
        """The square root of a prime number."""
        if prime not in self.roots:
            self.roots[prime] = self.generator(f"sqrt({prime})", square=prime)
        return self.roots[prime]

    def times(self, a: Monomial, b: Monomial) -> tuple[Monomial, int]:
        """The product of two monomials, with the number that squares of roots give."""
        if not a or not b:
            return a or b, 1
        found = self._products.get((a, b))
        if found is None:
            powers = dict(a)
            for number, exponent in b:
                powers[number] = powers.get(number, 0) + exponent
            factor = 1
            for root in (self.imaginary, *self.roots.values()):
                if powers.get(root.number) == 2:
                    factor *= root.square
                    powers[root.number] = 0
            found = tuple(sorted((n, e) for n, e in powers.items() if e)), factor
            self._products[a, b] = found
        return found

    def spend(self, products: int) -> None:
        """Count products of terms.  Raises TooLargeError when there are more than the budget."""
        self.spent += products
        if self.spent > self.budget:
            raise TooLargeError(f"more than {self.budget} products of terms to write them out")

    def unsolved(self, order: int, x: ExactSum) -> ExactSum:
        """What stands for a Stumpff function that has no closed form here; results must not have it."""
        if (order, x) not in self.open:
            self.open[order, x] = self.generator(f"c{order}")
        return self.of(self.open[order, x])

    def wave(self, angle: Generator, turns: Exponent) -> ExactSum:
        """``exp(i turns angle)``."""
        assert angle.wave is not None
        return self.of(angle.wave, turns)


class ExactSum:
    """A sum of monomials with rational coefficients."""

    __slots__ = ("ring", "terms")

    def __init__(self, ring: Ring, terms: dict[Monomial, Number]):
        self.ring, self.terms = ring, terms

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ExactSum) and self.terms == other.terms

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    def _plus(self, other: Any, sign: int) -> ExactSum:
        out = dict(self.terms)
        for monomial, c in self.ring.literal(other).terms.items():
            total = out.get(monomial, 0) + sign * c
            if total:
                out[monomial] = total
            else:
                del out[monomial]
        return ExactSum(self.ring, out)

    def __add__(self, other: Any) -> ExactSum:
        return self._plus(other, 1)

    __radd__ = __add__

    def __sub__(self, other: Any) -> ExactSum:
        return self._plus(other, -1)

    def __rsub__(self, other: Any) -> ExactSum:
        return -self + other

    def __neg__(self) -> ExactSum:
        return ExactSum(self.ring, {m: -c for m, c in self.terms.items()})

    def __mul__(self, other: Any) -> ExactSum:
        ring, b = self.ring, self.ring.literal(other)
        ring.spend(len(self.terms) * len(b.terms))
        out: dict[Monomial, Number] = {}
        for m, c in self.terms.items():
            for n, d in b.terms.items():
                monomial, factor = ring.times(m, n)
                out[monomial] = out.get(monomial, 0) + factor * c * d
        return ExactSum(ring, {m: c for m, c in out.items() if c})

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> ExactSum:
        return self * inverse(self.ring.literal(other))

    def __rtruediv__(self, other: Any) -> ExactSum:
        return self.ring.literal(other) * inverse(self)

    def __pow__(self, n: int) -> ExactSum:
        out = self.ring.literal(1)
        for _ in range(n):
            out = out * self
        return out

    @property
    def monomial(self) -> tuple[Monomial, Number] | None:
        """Its only term, if it has one."""
        return next(iter(self.terms.items())) if len(self.terms) == 1 else None

    def sorted(self) -> list[tuple[Monomial, Number]]:
        """The terms in a fixed order."""
        return sorted(self.terms.items(), key=lambda t: t[0])

    def generators(self) -> set[int]:
        """The numbers of the generators that occur."""
        return {number for m in self.terms for number, _ in m}


def inverse(a: ExactSum) -> ExactSum:
    """``1 / a``; of a sum of several terms it is a power of a part that stands for the sum."""
    ring = a.ring
    if not a:
        raise ZeroDivisionError
    if a.monomial is None:
        return ring.of(part_of(a), -1)
    m, c = a.monomial
    factor, powers = Fraction(1) / c, []
    for number, exponent in m:
        square = ring.generators[number].square
        factor = factor / square if square else factor
        powers.append((number, exponent if square else -exponent))
    return ExactSum(ring, {tuple(powers): factor})


def part_of(a: ExactSum) -> Generator:
    """The part that stands for a sum; one for equal sums."""
    for known in a.ring.generators:
        if known.part == a:
            return known
    return a.ring.named(f"part{len(a.ring.generators)}", a)


def coefficients(a: ExactSum, generators: Mapping[int, int]) -> list[ExactSum]:
    """What each of some generators is multiplied by, in a sum that is linear in all; ``generators``: number -> place.

    Raises ValueError for a term that has none of them, or a power of one.
    """
    out: list[dict[Monomial, Number]] = [{} for _ in generators]
    for m, c in a.terms.items():
        held = [(n, e) for n, e in m if n in generators]
        if len(held) != 1 or held[0][1] != 1:
            raise ValueError("not linear")
        out[generators[held[0][0]]][tuple(f for f in m if f[0] != held[0][0])] = c
    return [ExactSum(a.ring, terms) for terms in out]


def derivative(a: ExactSum, x: Generator) -> ExactSum:
    """The derivative with respect to a symbol, through the angles and parts that depend on it."""
    ring = a.ring
    out = ExactSum(ring, {})
    for number in sorted(a.generators()):
        inner = _inner(ring.generators[number], x)
        if not inner:
            continue
        own: dict[Monomial, Number] = {}
        for m, c in a.terms.items():
            exponent = dict(m).get(number, 0)
            if exponent:
                wave = ring.generators[number].angle is not None
                lower = (f if f[0] != number or wave else (number, exponent - 1) for f in m)
                own[tuple(f for f in lower if f[1])] = c * exponent
        out = out + ExactSum(ring, own) * inner
    return out


def _inner(generator: Generator, x: Generator) -> ExactSum:
    """The derivative of a generator; of the exponential of an angle that over the exponential itself."""
    symbol = generator.angle or generator
    own = x.ring.literal(int(symbol is x)) if symbol.part is None else derivative(symbol.part, x)
    return x.ring.i * own if generator.angle is not None else own
