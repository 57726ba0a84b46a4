"""Checks of a caller's arguments: numbers, arrays, names and parameter values."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from numbers import Integral, Real
from typing import Any

import numpy as np

from .errors import UnknownNameError, UsageError
from .spec.load import one_line
from .spec.modes import NEEDS
from .spec.parameters import Parameter, parameters
from .spec.physics import some_body_has
from .spec.robot import Robot

MAX_STEPS = 10**8
LONGEST_LIST = 8
"""Names that an error lists; of more it gives the nearest."""


# ------------------------------------------------------------------------------ numbers


def real_numbers(values: Any) -> np.ndarray | None:
    """`values` as an array of doubles; None if they are no real numbers or no array."""
    try:
        out = np.asarray(values)
        if out.dtype.kind == "O" and not all(isinstance(x, Real) for x in out.flat):
            return None
        return out.astype(float) if out.dtype.kind in "iufO" else None
    except (TypeError, ValueError, OverflowError):
        return None


def fits(shape: tuple[int, ...], wanted: tuple[int, ...]) -> bool:
    """Whether an array of `shape` is one of shape `wanted`: but for axes of length 1, or as one row of all entries."""
    long = [n for n in shape if n != 1]
    return math.prod(shape) == math.prod(wanted) and (len(long) <= 1 or long == [n for n in wanted if n != 1])


def array(values: Any, name: str, shape: tuple[int, ...], finite: bool = True) -> np.ndarray:
    """`values` as a new array of doubles of `shape`; None is zeros.

    Raises UsageError, which begins with `name`, where they are no numbers, not as many, in another layout, or, if
    they have to be, not finite.
    """
    size = math.prod(shape)
    out = np.zeros(shape) if values is None else real_numbers(values)
    if out is None:
        raise UsageError(f"{name} is not an array of numbers; give {size} numbers")
    if out.size != size:
        raise UsageError(f"{name} has {out.size} numbers; it must have {size}")
    if not fits(out.shape, shape):
        raise UsageError(f"{name} has the shape {out.shape}; it must be {shape}")
    if finite and not np.isfinite(out).all():
        raise UsageError(f"{name} holds a number that is not finite; give {size} finite numbers")
    return out.reshape(shape)


def whole(value: Any, name: str, least: int, most: int = MAX_STEPS) -> int:
    """A whole number from `least` to `most`."""
    if isinstance(value, bool) or not isinstance(value, Integral) or not least <= int(value) <= most:
        raise UsageError(f"{name} is {value!r}; it must be a whole number from {least} to {most:g}")
    return int(value)


def seconds(value: Any, name: str) -> float:
    """A finite time > 0."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise UsageError(f"{name} is {value!r}; it must be a finite number of seconds > 0")
    if not 0 < float(value) < math.inf:
        raise UsageError(f"{name} is {value:g} s; it must be a finite number > 0")
    return float(value)


# ------------------------------------------------------------------------------ names


def choice(given: Any, known: Iterable[str], what: str) -> str:
    """`given` if it is one of `known`; else UnknownNameError: `<what> '<given>'; choose …`, or the nearest name."""
    known = tuple(known)
    if isinstance(given, str) and given in known:
        return given
    raise UnknownNameError(f"{what} '{one_line(str(given))}'; {suggestion(str(given), known)}")


def matching(patterns: str | Sequence[str], known: Sequence[str], what: str) -> tuple[int, ...]:
    """The places of the names that names or patterns stand for, in which `*` is any text; in their order.

    Raises UsageError where one of them stands for none.
    """
    found: set[int] = set()
    for pattern in [patterns] if isinstance(patterns, str) else patterns:
        whole = re.compile(".*".join(map(re.escape, pattern.split("*"))))
        own = {k for k, name in enumerate(known) if whole.fullmatch(name)}
        if not own:
            choice(pattern, known, what)
        found |= own
    return tuple(sorted(found))


def suggestion(name: str, known: Sequence[str]) -> str:
    """What to choose in place of a name that nothing has."""
    near = nearest(name, known)
    if len(known) > LONGEST_LIST:
        return near or f"choose of {len(known)} names, such as '{known[0]}'"
    return "; ".join(filter(None, (f"choose {' or '.join(known)}", near)))


def nearest(name: str, known: Sequence[str]) -> str:
    """`did you mean '<the most similar name>'?`; empty if none is similar."""
    lowered = {k.lower(): k for k in known}
    near = get_close_matches(name.lower(), lowered, 1)
    return f"did you mean '{lowered[near[0]]}'?" if near else ""


# ------------------------------------------------------------------------------ parameters

Numbers = Sequence[float] | np.ndarray
Loads = Numbers | Sequence[Numbers] | None
"""Torques (n_tau,), or wrenches (n, 6) in rows or flat; None: all are zero."""
Given = Numbers | Mapping[str, Any] | None
"""Values of all parameters, or of some by name; None: the robot file's."""


class Parameters:
    """The parameters of a robot as a caller may set them: by the rules of the robot file."""

    def __init__(self, robot: Robot):
        own = parameters(robot)
        self.names, self.values = [x.name for x in own], np.array([x.value for x in own])
        self.least = np.array([-np.inf if x.sign == "any" else 0.0 for x in own])
        self.positive = np.array([_must_be_positive(robot, x) for x in own], bool)
        self.tensors, self.ranges = _tensors(own), _ranges(own)

    def vector(self, given: Given = None) -> np.ndarray:
        """All values (n,), those that a mapping names in place of the file's.

        Raises UsageError on names that there are not, and on values that a robot file may not state either.
        """
        values = self.values.copy()
        if isinstance(given, Mapping):
            for name, value in given.items():
                values[self.place(name)] = array(value, f"parameters: {name}", ()).item()
        elif given is not None:
            values = array(given, "parameters:", values.shape)
        self.check(values[None])
        return values

    def place(self, name: str) -> int:
        """Where a parameter stands among all."""
        return self.names.index(choice(name, self.names, "parameters: there is no"))

    def chosen(self, patterns: str | Sequence[str]) -> tuple[int, ...]:
        """The places of the parameters that names or patterns stand for, in which `*` is any text; in their order.

        Raises UsageError where one of them stands for none.
        """
        return matching(patterns, self.names, "parameters: there is no")

    def refused(self, rows: np.ndarray) -> dict[int, str]:
        """What :meth:`check` says of each of the rows (k, n) that it refuses."""
        out: dict[int, str] = {}
        try:
            self.check(rows)
        except UsageError:
            for k, row in enumerate(rows):
                try:
                    self.check(row[None])
                except UsageError as error:
                    out[k] = str(error)
        return out

    def check(self, rows: np.ndarray) -> None:
        """Refuse values (k, n) that a robot file may not state: raises UsageError that names the first of them."""
        bad = ~np.isfinite(rows) | (rows < self.least) | ((rows == self.least) & self.positive)
        if bad.any():
            row, k = map(int, np.argwhere(bad)[0])
            allowed = "finite" if not np.isfinite(rows[row, k]) else "> 0" if self.positive[k] else ">= 0"
            raise UsageError(f"{_title(rows, row)}: {self.names[k]} is {rows[row, k]:g}; it must be {allowed}")
        for lower, upper in self.ranges:
            if (wrong := ~(rows[:, lower] < rows[:, upper])).any():
                row = int(wrong.argmax())
                what = f"{self.names[lower]} is {rows[row, lower]:g}; it must be less than {self.names[upper]}"
                raise UsageError(f"{_title(rows, row)}: {what}, {rows[row, upper]:g}")
        for places in self.tensors:
            for row in map(int, np.flatnonzero((rows[:, places] != self.values[places]).any(axis=1))):
                if not some_body_has(tuple(rows[row, places])):
                    name = self.names[places[0]].rpartition("[")[0]
                    raise UsageError(
                        f"{_title(rows, row)}: {name} is an inertia that no body has; no principal moment may be "
                        "negative, nor exceed the sum of the other two"
                    )


def _title(rows: np.ndarray, row: int) -> str:
    return "parameters" if len(rows) == 1 else f"parameters of scenario {row}"


def _must_be_positive(robot: Robot, x: Parameter) -> bool:
    """Whether the value must be positive: by its range, or as a stiffness or inertia of a direction with modes."""
    if x.sign == "positive" or x.link is None:
        return x.sign == "positive"
    field, modes = x.field.removeprefix("section."), robot.links[x.link].modes
    return any(field in needed and getattr(modes, direction) for direction, needed in NEEDS.items())


def _ranges(own: Sequence[Parameter]) -> list[tuple[int, int]]:
    """The places of both limits of every axis that has two."""
    lower = {(x.link, x.index): k for k, x in enumerate(own) if x.field == "joint.limits.lower"}
    upper = [(x.link, x.index, k) for k, x in enumerate(own) if x.field == "joint.limits.upper"]
    return [(lower[link, index], k) for link, index, k in upper if (link, index) in lower]


def _tensors(own: Sequence[Parameter]) -> list[np.ndarray]:
    """Where the entries of every body's inertia stand."""
    places: dict[tuple, list[int]] = {}
    for k, x in enumerate(own):
        if x.field == "bodies.inertia":
            places.setdefault((x.link, x.index[0]), []).append(k)
    return [np.array(p) for p in places.values()]
