"""A posture in an option: numbers, multiples of pi, and decimals that are rounded from one.

An example: `1.5708,pi/6,0.2` of two joints that turn and one that slides is pi/2, pi/6 and 0.2 m. An angle of four
decimals or more that is a multiple of 15 degrees to these decimals is meant to be this multiple.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from ..backends.equations.equations import ROUNDING
from ..errors import UsageError, one_line

FACTOR = r"(?:pi|\d{1,15}(?:\.\d{0,15})?|\.\d{1,15})"
PRODUCT = re.compile(rf"([+-]?)({FACTOR}(?:[*/]{FACTOR})*)")
DECIMAL = re.compile(r"[+-]?\d*\.(\d+)")
PARTS = 12
"""Angles that are rounded multiples of π over this are meant to be these."""
DIGITS = 4
"""With fewer digits behind the point a number is what it is."""
NEAR = 1e-6
"""An angle this near to such a multiple is one, with however many digits, rad."""


@dataclass(frozen=True)
class StatedPosture:
    """Coordinates as they are meant. ``rounding``: how far rounded decimals leave a sum of angles open, rad.

    ``taken``: sentences on what stands for what was stated.
    """

    q: tuple[float, ...]
    rounding: float
    taken: tuple[str, ...]


def posture(option: str, given: str, turning: Sequence[bool]) -> StatedPosture:
    """The joint coordinates in an option, by commas or blanks; ``turning``: which of them are angles.

    Raises UsageError for a word that is no number, for another count, and for pi where a joint slides.
    """
    words = given.replace(",", " ").split()
    if len(words) != len(turning):
        raise UsageError(f"{option}: states {len(words)} of {len(turning)} joint coordinates; give all, as 0.1,-pi/2")
    q, rounding, taken = [], 0.0, []
    for k, (word, turns) in enumerate(zip(words, turning, strict=True), 1):
        value, multiple = _value(option, word)
        if multiple and not turns:
            raise UsageError(f"{option}: '{one_line(word)}' is an angle, and q_{k} a distance; give it in m, as 0.1")
        digits = len(found[1]) if turns and (found := DECIMAL.fullmatch(word)) else 0
        if digits >= DIGITS and (near := _near(value, digits)):
            value = float(near) * math.pi
            taken.append(f"{word} is taken as {_multiple(near)}.")
        elif digits >= DIGITS:
            rounding += 0.5 * 10.0**-digits
        q.append(value)
    rounding = max(rounding, ROUNDING)
    if rounding > ROUNDING and sum(turning) > 1:
        taken.append(f"A sum of angles within {rounding:.1g} rad of a multiple of 30 or 45 degrees is taken as it.")
    return StatedPosture(tuple(q), rounding, tuple(taken))


def _value(option: str, word: str) -> tuple[float, bool]:
    """The value of a word, and whether it is a multiple of pi."""
    wrong = f"{option}: '{one_line(word)}' is no number; give joint coordinates, as 0.1,-pi/2"
    if found := PRODUCT.fullmatch(re.sub(r"(?<=[\d.])pi", "*pi", word)):
        factor, power = Fraction(1 if found[1] != "-" else -1), 0
        for sign, part in re.findall(rf"([*/]?)({FACTOR})", found[2]):
            below = -1 if sign == "/" else 1
            power += below * (part == "pi")
            number = Fraction(1 if part == "pi" else part)
            if not number and below < 0:
                raise UsageError(wrong)
            factor *= number**below
        if power in (0, 1):
            return float(factor) * (math.pi if power else 1.0), power == 1
    try:
        value = float(word)
    except ValueError:
        raise UsageError(wrong) from None
    if not math.isfinite(value):
        raise UsageError(wrong)
    return value, False


def _near(value: float, digits: int) -> Fraction | None:
    """The multiple of π, other than zero, that an angle with so many decimals is rounded from."""
    near = Fraction(round(value * PARTS / math.pi), PARTS)
    close = abs(float(near) * math.pi - value) <= max(10.0**-digits, NEAR)
    return near if near and close else None


def _multiple(turns: Fraction) -> str:
    """A multiple of pi as one writes it."""
    above = {1: "", -1: "-"}.get(turns.numerator, f"{turns.numerator}*")
    return f"{above}pi" + (f"/{turns.denominator}" if turns.denominator != 1 else "")
