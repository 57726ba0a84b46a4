"""Checks of single values: each returns the validated value or raises an error.

A check never coerces silently: a string or a boolean is no number, a fraction is no count. `at` is the path
of the value below the field that is being checked, so that the message can point at one entry of an array.
"""

import datetime
import json
import math
from collections.abc import Callable
from numbers import Integral, Real
from typing import Any, TypeVar

from pydantic_core import PydanticCustomError

_T = TypeVar("_T")

Path = tuple[str | int, ...]

MAX_POINTS = 40
MAX_MODES = 32
LONGEST_SHOWN = 40


def refuse(what: str, at: Path = ()) -> PydanticCustomError:
    """The error to raise: `what` is "<what is wrong>; <what is allowed>", `at` the path below this place."""
    return PydanticCustomError("refused", "{what}", {"what": what, "at": at})


def shown(value: Any) -> str:
    """`value` in a file's own words, on one short line of printable characters."""
    match value:
        case bool():
            return str(value).lower()
        case str():
            return quoted(value)
        case Integral():
            return str(value) if abs(value) < 10**LONGEST_SHOWN else f"a whole number over 1e{LONGEST_SHOWN}"
        case Real():
            return str(value)[:LONGEST_SHOWN]
        case dict():
            return "a table"
        case list() | tuple():
            return f"an array of {len(value)}"
        case datetime.date() | datetime.time():
            return "a date or time"
    return f"a Python {type(value).__name__}"


def quoted(text: str) -> str:
    """`text` as a string on one line of ASCII, shortened if long."""
    return json.dumps(text if len(text) <= LONGEST_SHOWN else text[:LONGEST_SHOWN] + "...")


def number(value: Any, *, at: Path = ()) -> float:
    """A finite real number."""
    if not isinstance(value, Real) or isinstance(value, bool):
        raise refuse(f"is {shown(value)}; it must be a number", at)
    try:
        result = float(value)
    except OverflowError:
        result = math.inf
    if not math.isfinite(result):
        raise refuse(f"is {shown(value)}; it must be a finite number", at)
    return result


def positive(value: Any, *, at: Path = ()) -> float:
    """A finite number > 0."""
    result = number(value, at=at)
    if result <= 0:
        raise refuse(f"is {shown(value)}; it must be > 0", at)
    return result


def non_negative(value: Any, *, at: Path = ()) -> float:
    """A finite number >= 0."""
    result = number(value, at=at)
    if result < 0:
        raise refuse(f"is {shown(value)}; it must be >= 0", at)
    return result


def fraction(value: Any, *, at: Path = ()) -> float:
    """A number from 0 to 1."""
    result = number(value, at=at)
    if not 0 <= result <= 1:
        raise refuse(f"is {shown(value)}; it must be from 0 to 1", at)
    return result


SIGNS: dict[str, Callable[..., float]] = {"positive": positive, "non-negative": non_negative, "any": number}
"""The checks of signs by their names."""


def count(value: Any) -> int:
    """A number of modes in one direction."""
    if not isinstance(value, Integral) or isinstance(value, bool):
        raise refuse(f"is {shown(value)}; it must be a whole number from 0 to {MAX_MODES}")
    if not 0 <= int(value) <= MAX_MODES:
        raise refuse(f"is {shown(value)}; it must be from 0 to {MAX_MODES}")
    return int(value)


def gauss_points(value: Any) -> int:
    """A number of points of integration."""
    if not isinstance(value, Integral) or isinstance(value, bool) or not 2 <= int(value) <= MAX_POINTS:
        raise refuse(f"is {shown(value)}; it must be a whole number from 2 to {MAX_POINTS}")
    return int(value)


def shape_order(value: Any) -> int | str:
    """The order of a link's shape in its modes: 1, 2 or "exact"."""
    if isinstance(value, bool) or value not in (1, 2, "exact"):
        raise refuse(f'is {shown(value)}; it must be 1, 2 or "exact"')
    return value if isinstance(value, str) else int(value)


def boolean(value: Any) -> bool:
    """True or false."""
    if not isinstance(value, bool):
        raise refuse(f"is {shown(value)}; it must be true or false")
    return value


def array(value: Any, what: str, *, at: Path = ()) -> list | tuple:
    """An array, called `what` in the message; NumPy arrays are accepted as lists."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(value, list | tuple):
        raise refuse(f"is {shown(value)}; it must be {what}", at)
    return value


def objects(value: Any, kind: type[_T], what: str) -> tuple[_T, ...]:
    """Objects of a class, which a `Robot` of Python holds and no file can state; `what` each must be."""
    own = tuple(array(value, "an array of objects made in Python"))
    for k, one in enumerate(own):
        if not isinstance(one, kind):
            raise refuse(f"is {shown(one)}; it must be {what}; a file cannot state one", (k,))
    return own


def numbers(value: Any, size: int, *, at: Path = ()) -> tuple[float, ...]:
    """`size` finite numbers."""
    what = f"an array of {size} numbers"
    entries = array(value, what, at=at)
    if len(entries) != size:
        raise refuse(f"has length {len(entries)}; it must be {what}", at)
    return tuple(number(entry, at=(*at, i)) for i, entry in enumerate(entries))


def choice(*allowed: str) -> Callable[[Any], str]:
    """A check that a value is one of the strings `allowed`."""

    def check(value: Any) -> str:
        if not isinstance(value, str) or value not in allowed:
            raise refuse(f"is {shown(value)}; it must be {' or '.join(map(quoted, allowed))}")
        return value

    return check
