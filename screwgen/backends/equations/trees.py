"""Formulas as people write them: sums of products with brackets, and how many operations they take."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from .ring import COORDINATE, RATE, Exponent, Ring


@dataclass(frozen=True, order=True)
class Atom:
    """A symbol, or the sine or cosine of a sum of angles.

    ``function``: "" for a symbol, else "sin" or "cos"; ``of``: the number of a generator with 1, or those of angles
    with what they are multiplied by.
    """

    function: str
    of: tuple[tuple[int, Exponent], ...]

    @property
    def operations(self) -> int:
        """Of the function and its argument."""
        return 0 if not self.function else len(self.of) + sum(abs(k) != 1 for _, k in self.of)


def symbol(number: int) -> Atom:
    """The atom of a generator."""
    return Atom("", ((number, 1),))


Factors = tuple[tuple[Atom, Exponent], ...]


@dataclass(frozen=True)
class FormulaProduct:
    """A number times powers of atoms, times a bracket if there is one."""

    coefficient: Fraction
    factors: Factors
    inner: FormulaSum | None = None

    @property
    def operations(self) -> int:
        """Multiplications, divisions, powers and functions, with those of the bracket."""
        above = sum(e > 0 for _, e in self.factors) + (self.inner is not None)
        below = sum(e < 0 for _, e in self.factors)
        size = abs(self.coefficient)
        parts = above + (size.numerator != 1) + (1 if not above and size.numerator == 1 else 0)
        own = parts - 1 + below + (size.denominator != 1) + sum(abs(e) != 1 for _, e in self.factors)
        functions = sum(atom.operations for atom, _ in self.factors)
        return own + functions + (0 if self.inner is None else self.inner.operations)

    def atoms(self) -> Iterator[Atom]:
        """All atoms that occur."""
        yield from (atom for atom, _ in self.factors)
        if self.inner is not None:
            yield from self.inner.atoms()


@dataclass(frozen=True)
class FormulaSum:
    """A sum; without terms it is zero."""

    terms: tuple[FormulaProduct, ...]

    @property
    def operations(self) -> int:
        """Those of the terms and the additions between them."""
        return sum(term.operations for term in self.terms) + max(len(self.terms) - 1, 0)

    @property
    def nested(self) -> int:
        """How many brackets stand in others."""
        return sum(term.inner.brackets for term in self.terms if term.inner is not None)

    @property
    def brackets(self) -> int:
        """How many brackets there are."""
        return self.nested + sum(term.inner is not None for term in self.terms)

    def atoms(self) -> Iterator[Atom]:
        """All atoms that occur."""
        for term in self.terms:
            yield from term.atoms()


def degree(ring: Ring, factors: Factors) -> Exponent:
    """The degree in coordinates that are no arguments of sines and cosines."""
    return sum(e for atom, e in factors if not atom.function and ring.generators[atom.of[0][0]].kind == COORDINATE)


def rank(ring: Ring, atom: Atom) -> int:
    """The order of factors: roots of numbers, parameters, coordinates, functions, rates."""
    if atom.function:
        return 2
    generator = ring.generators[atom.of[0][0]]
    kind = generator.kind
    if generator.square or generator is ring.pi:
        return -1
    return {COORDINATE: 1, RATE: 3}.get(kind, 0)
