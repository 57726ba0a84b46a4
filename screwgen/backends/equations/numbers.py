"""Exact numbers for the floats of programs: fractions, roots of 2 and 3, multiples of π."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

DENOMINATOR, CLOSE = 5000, 4e-16
"""A float that is a fraction of no larger denominator, but for rounding, is that fraction."""
LARGEST = 100
"""The largest prime under a root that is recognised."""


class Value(NamedTuple):
    """A fraction times the roots of some primes times a power of π."""

    fraction: Fraction
    roots: tuple[int, ...] = ()
    pi: int = 0


@lru_cache(maxsize=4096)
def recognised(x: float | int | Fraction) -> Value:
    """What a number is exactly: a fraction, a root of one, or this times π or π²; a float that is none, as it stands.

    Programs have floats for numbers of the derivation such as 1/3 and the root of 5; these are rounded once.
    """
    if isinstance(x, int | Fraction):
        return Value(Fraction(x))
    for power in (0, 1, 2):
        scale = math.pi**power
        found = Fraction(x / scale).limit_denominator(DENOMINATOR)
        if abs(float(found) * scale - x) <= CLOSE * abs(x):
            return Value(found, (), power)
        square = Fraction((x / scale) ** 2).limit_denominator(DENOMINATOR)
        if abs(math.sqrt(square) * scale - abs(x)) <= CLOSE * abs(x) and (parts := split(square)) is not None:
            return Value(-parts[0] if x < 0 else parts[0], parts[1], power)
    return Value(Fraction(x))


def split(square: Fraction) -> tuple[Fraction, tuple[int, ...]] | None:
    """The root of a positive fraction as a fraction times roots of primes, unless these are large."""
    whole, out, roots = square.numerator * square.denominator, 1, []
    for prime in range(2, LARGEST):
        while whole % prime**2 == 0:
            whole, out = whole // prime**2, out * prime
        if whole % prime == 0:
            whole //= prime
            roots.append(prime)
    rest = math.isqrt(whole)
    return (Fraction(out * rest, square.denominator), tuple(roots)) if rest * rest == whole else None


def exactly(value: Fraction) -> bool:
    """Whether a coefficient is one that people write as a fraction."""
    return value.denominator <= DENOMINATOR**2
