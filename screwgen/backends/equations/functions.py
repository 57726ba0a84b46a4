"""Sines, cosines, roots and Stumpff functions of sums of monomials, in closed form."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from math import factorial
from typing import Any

from ...errors import UsageError
from .numbers import split
from .ring import COORDINATE, ExactSum, Exponent, Generator, Monomial, Number, Ring, inverse, part_of

HALF = Fraction(1, 2)
QUARTERS: dict[Fraction, tuple[tuple[Number, int, bool], ...]] = {
    Fraction(0): ((1, 1, False),),
    Fraction(1, 4): ((HALF, 2, False), (HALF, 2, True)),
    Fraction(1, 6): ((HALF, 3, False), (HALF, 1, True)),
    Fraction(1, 3): ((HALF, 1, False), (HALF, 3, True)),
}
"""``exp(i pi x)`` of fractions x below a half: numbers, what stands under a root beside them, whether i does too."""
STEPS = 12
"""The multiples of π over this are all angles whose sines and cosines these roots express, and some others."""


class NoClosedFormError(UsageError):
    """A function that is no finite sum of sines and cosines."""


def function(ring: Ring, op: str, x: Any, *more: Any) -> ExactSum:
    """The primitives of programs."""
    a = ring.literal(x)
    if op == "neg":
        return -a
    if op == "sqrt":
        return root(a)
    if op in ("sin", "cos"):
        return sine(a) if op == "sin" else cosine(a)
    if op.startswith("c") and op[1:].isdigit():
        return stumpff(int(op[1:]), a)
    said = {"exp": "its friction falls", "atan2": "a law asks for the angle of a point"}
    raise NoClosedFormError(said.get(op, "it has forces that begin at a limit"))


def cosine(a: ExactSum) -> ExactSum:
    """``(z + 1/z)/2``."""
    return (exponential(a) + exponential(-a)) * Fraction(1, 2)


def sine(a: ExactSum) -> ExactSum:
    """``(z - 1/z)/(2 i)``."""
    return (exponential(a) - exponential(-a)) * a.ring.i * Fraction(-1, 2)


def exponential(a: ExactSum) -> ExactSum:
    """``exp(i a)``: a power of each angle in ``a``; any other sum becomes an angle of its own."""
    ring = a.ring
    out, rest = ring.literal(1), ExactSum(ring, {})
    for m, c in a.sorted():
        generator = ring.generators[m[0][0]] if len(m) == 1 and m[0][1] == 1 else None
        if generator is not None and generator.wave is not None:
            out = out * ring.wave(generator, c if Fraction(c).denominator > 1 else int(c))
        elif generator is ring.pi and (turned := special(ring, Fraction(c))) is not None:
            out = out * turned
        else:
            rest = rest + ExactSum(ring, {m: c})
    if not rest:
        return out
    if not any(m for m in rest.terms):
        number = float(rest.terms[()])
        return out * (ring.literal(math.cos(number)) + ring.i * ring.literal(math.sin(number)))
    sign, angle = angle_of(rest)
    return out * ring.wave(angle, sign)


def special(ring: Ring, turns: Fraction) -> ExactSum | None:
    """``exp(i pi turns)`` where roots express it."""
    quarters, rest = divmod(turns, Fraction(1, 2))
    if rest not in QUARTERS:
        return None
    out = ring.literal(1)
    for _ in range(quarters % 4):
        out = out * ring.i
    found = ExactSum(ring, {})
    for c, square, imaginary in QUARTERS[rest]:
        factor = ring.of(ring.root(square), 1, c) if square > 1 else ring.literal(c)
        found = found + (factor * ring.i if imaginary else factor)
    return out * found


def angle_of(a: ExactSum) -> tuple[int, Generator]:
    """The angle that stands for a sum, and its sign; one angle for a sum and its negative."""
    for known in a.ring.generators:
        if known.wave is not None and known.part is not None:
            for sign in (1, -1):
                if known.part == a * sign:
                    return sign, known
    sign = 1 if a.sorted()[0][1] > 0 else -1
    return sign, a.ring.named(f"turn{len(a.ring.generators)}", a * sign, turns=True)


def stumpff(order: int, x: ExactSum) -> ExactSum:
    """``c_k(x)`` of the square of an angle: the rest of the series of sine or cosine over a power of the angle.

    Of a sum that is no square, where modes turn a section about several axes, a symbol that results must not have.
    """
    ring = x.ring
    if not x:
        return ring.literal(Fraction(1, factorial(order)))
    base = square_root(x)
    if base is None:
        return ring.unsolved(order, x)
    _, angle = angle_of(base)
    found = cosine(ring.of(angle)) if order % 2 == 0 else sine(ring.of(angle))
    for power in range(order % 2, order, 2):
        found = found - ring.of(angle, power, Fraction((-1) ** (power // 2), factorial(power)))
    return found * ring.of(angle, -order) * (-1) ** (order // 2)


def root(a: ExactSum) -> ExactSum:
    """The square root of what is positive."""
    ring = a.ring
    if not a:
        return a
    if (found := square_root(a)) is not None:
        return found
    if a.monomial is None:
        return ring.of(part_of(a), Fraction(1, 2))
    m, c = a.monomial
    halves = ExactSum(ring, {tuple((n, _whole(Fraction(e) / 2)) for n, e in m): 1})
    parts = split(Fraction(c)) if c > 0 else None
    if parts is None:
        return halves * ring.literal(float(c) ** 0.5)
    for prime in parts[1]:
        halves = halves * ring.of(ring.root(prime))
    return halves * parts[0]


def _whole(e: Fraction) -> int | Fraction:
    return int(e) if e.denominator == 1 else e


def square_root(x: ExactSum) -> ExactSum | None:
    """The sum whose square a sum is, up to its sign, if there is one."""
    ring = x.ring
    m, c = _leading(x)
    parts = split(Fraction(c)) if c > 0 else None
    if parts is None or any(Fraction(e) % 2 for _, e in m):
        return None
    lead = ExactSum(ring, {tuple((n, _whole(Fraction(e) / 2)) for n, e in m): parts[0]})
    for prime in parts[1]:
        lead = lead * ring.of(ring.root(prime))
    found, double = lead, inverse(lead * 2)
    for _ in range(len(x.terms)):
        left = x - found * found
        if not left:
            return found
        found = found + ExactSum(ring, dict([_leading(left)])) * double
    return found if found * found == x else None


def _leading(a: ExactSum) -> tuple[Monomial, Number]:
    """The first term in an order that products keep: by the exponents of all generators but roots in turn."""
    plain = [g.number for g in a.ring.generators if not g.square]
    return max(a.terms.items(), key=lambda term: [dict(term[0]).get(number, 0) for number in plain])


def without_parts(a: ExactSum) -> ExactSum:
    """The sum with angles of sections in sines and cosines alone: their powers are written out.

    Sines over an angle are whole sums of sines: the first coordinate of the angle is put as the angle less the rest.
    """
    ring = a.ring
    for number in sorted(a.generators()):
        generator = ring.generators[number]
        if generator.part is None or generator.wave is None:
            continue
        lowest = min((dict(m).get(number, 0) for m in a.terms), default=0)
        if lowest < 0:
            a = _first_put(a, generator)
        a = put(a, number, generator.part)
    return a


def _first_put(a: ExactSum, angle: Generator) -> ExactSum:
    """``a`` with the first coordinate of an angle expressed by the angle and the other coordinates."""
    assert angle.part is not None
    (m, c), *others = angle.part.sorted()
    number = next(n for n, _ in m if a.ring.generators[n].kind == COORDINATE)
    scale = ExactSum(a.ring, {tuple(f for f in m if f[0] != number): c})
    rest = ExactSum(a.ring, dict(others))
    return put(a, number, (a.ring.of(angle) - rest) / scale)


def put(a: ExactSum, number: int, value: ExactSum) -> ExactSum:
    """``a`` with a value for a generator, in powers that are whole; of negative ones the value has one term."""
    ring = a.ring
    groups: dict[int, dict[Monomial, Number]] = {}
    for m, c in a.terms.items():
        exponent = dict(m).get(number, 0)
        groups.setdefault(int(exponent), {})[tuple(f for f in m if f[0] != number)] = c
    out, powers, one = ExactSum(ring, {}), {0: ring.literal(1)}, ring.literal(1)
    for exponent in sorted(groups, key=abs):
        if exponent not in powers:
            base = value if exponent > 0 else inverse(value)
            powers[exponent] = one
            for _ in range(abs(exponent)):
                powers[exponent] = powers[exponent] * base
        out = out + ExactSum(ring, groups[exponent]) * powers[exponent]
    return out


def at(a: ExactSum, posture: Mapping[int, ExactSum], rounding: float) -> ExactSum:
    """``a`` with values for coordinates and angles, by the numbers of their generators.

    The angles of a term are summed first: a sum that is a multiple of 30 or 45 degrees but for ``rounding`` (rad) gives
    its roots, and no rest.
    """
    ring, out = a.ring, ExactSum(a.ring, {})
    for m, c in a.sorted():
        term, turn = ring.literal(c), 0.0
        for number, e in m:
            generator = ring.generators[number]
            symbol = generator.angle or generator
            value = posture.get(symbol.number)
            if value is None and symbol.part is not None:
                value = at(symbol.part, posture, rounding)
            if value is None:
                term = term * ring.of(generator, e)
            elif generator.angle is None:
                term = term * power(value, e)
            elif (angle := numeric(value)) is not None:
                turn += float(e) * angle
            else:
                term = term * exponential(value * e)
        out = out + term * turned(ring, turn, rounding)
    return out


def numeric(a: ExactSum) -> float | None:
    """The value of a sum of numbers, roots and powers of π; None if it has anything else."""
    values = {root.number: math.sqrt(prime) for prime, root in a.ring.roots.items()} | {a.ring.pi.number: math.pi}
    if not a.generators() <= values.keys():
        return None
    return math.fsum(float(c) * math.prod(values[n] ** float(e) for n, e in m) for m, c in a.terms.items())


def turned(ring: Ring, angle: float, rounding: float) -> ExactSum:
    """``exp(i angle)``: with roots where the angle is a multiple of 30 or 45 degrees but for ``rounding``."""
    near = Fraction(round(angle * STEPS / math.pi), STEPS)
    found = special(ring, near) if abs(angle - float(near) * math.pi) <= rounding else None
    return found if found is not None else ring.literal(math.cos(angle)) + ring.i * ring.literal(math.sin(angle))


def power(a: ExactSum, e: Exponent) -> ExactSum:
    """A power of a sum; of a negative or broken one through a part that stands for the sum."""
    if Fraction(e).denominator > 1:
        return power(root(a), _whole(Fraction(e) * 2))
    return a ** int(e) if e >= 0 else inverse(a) ** int(-e)


def exchanged(a: ExactSum, old: Generator, new: Generator, factor: Generator) -> ExactSum:
    """``a`` with ``new / factor`` in the place of ``old``, in any powers."""
    out: dict[Monomial, Number] = {}
    for m, c in a.terms.items():
        e = dict(m).get(old.number, 0)
        kept = tuple(f for f in m if f[0] != old.number)
        ratio = tuple(sorted([(new.number, e), (factor.number, -e)])) if e else ()
        out[a.ring.times(kept, ratio)[0]] = c
    return ExactSum(a.ring, out)
