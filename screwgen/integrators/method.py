"""A time step as data: its stages, and how their accelerations advance the state.

The NumPy and CasADi steps, the generated C of both forms and its batch are all made from a :class:`Method`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, Literal, Protocol

from ..errors import UsageError
from .order import StageState, unmet
from .space import FLAT, Space

Motion = tuple[Any, Any]
"""Coordinates (nq,) and rates (nq,)."""

Rates = Literal["stages", "new", "mean"]
Number = int | float | str | Fraction

RATES = ("stages", "new", "mean")
HIGHEST = 4
"""The exponential of SE(3) in the DAE form keeps its terms up to this order."""


class Accelerations(Protocol):
    """`vdot` (nq,) while torques and external wrenches are held."""

    def explicit(self, q: Any, v: Any) -> Any:
        """That at `q, v`."""

    def implicit(self, q: Any, v: Any, h: Any, there: Motion | None = None) -> Any:
        """That with the elastic forces that it leads to `h` after `q, v`; all else is that at `there`."""


@dataclass(frozen=True)
class Move:
    """A state after the step's start: rates moved by h times a weighted sum of the stages' accelerations.

    `weights`: one per stage before it, trailing zeros may be left out; whole numbers, fractions such as "1/3", or
    doubles where they are irrational. `moved`: the rates by which coordinates and poses move: those of the same
    `stages` with the same weights, or, for a single acceleration, the `new` rates or the `mean` of old and new ones.
    """

    weights: Sequence[Number] = ()
    moved: Rates = "stages"

    def __post_init__(self) -> None:
        if self.moved not in RATES:
            raise UsageError(f"moved is {self.moved!r}; it must be {', '.join(map(repr, RATES))}")
        object.__setattr__(self, "weights", self.exact)
        if self.moved != "stages" and len(self.terms) != 1:
            raise UsageError(f"coordinates moved by the {self.moved} rates need one acceleration with a weight")

    @cached_property
    def exact(self) -> tuple[Fraction, ...]:
        """The weights as fractions."""
        return tuple(map(_exact, self.weights))

    @property
    def terms(self) -> list[tuple[int, Fraction]]:
        """The stages with a weight, from 0, and their weights."""
        return [(j, w) for j, w in enumerate(self.exact) if w]

    @property
    def reach(self) -> Fraction:
        """How far into the step it is, in steps."""
        return sum(self.exact, Fraction(0))

    @property
    def kick(self) -> Fraction:
        """By how many steps of the one acceleration the moving rates are ahead of the old ones."""
        return {"new": self.reach, "mean": self.reach / 2}[self.moved]


@dataclass(frozen=True)
class Stage(Move):
    """Accelerations at a moved state, or at the step's start if all weights are zero.

    `implicit`: the fraction of h after the step's start at which the forces of modes, joint springs and dampers are
    taken, as these accelerations lead to them; 0: they are taken at the state of the stage, like all else.
    """

    implicit: Number = 0

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "implicit", self.part)
        if not 0 <= self.part <= 1:
            raise UsageError(f"implicit is {self.implicit}; it must be from 0 to 1")

    @cached_property
    def part(self) -> Fraction:
        """What is `implicit`, as a fraction."""
        return _exact(self.implicit)


@dataclass(frozen=True)
class Method:
    """A time step by name: its stages, and the `end` of the step.

    `order`: 1 to 4, which must follow from the coefficients. `meaning`: one line for the generated documents. Raises
    UsageError where the coefficients are no method of that order. A stage that takes elastic forces implicitly away
    from the start uses those of the stage before it, which must be implicit over the same fraction.
    """

    name: str
    order: int
    stages: tuple[Stage, ...]
    end: Move
    meaning: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "stages", tuple(self.stages))
        for check in (self._wrong_words, self._wrong_stages, self._wrong_order):
            if wrong := check():
                raise UsageError(f"method {self.name!r}: {wrong}")

    def __str__(self) -> str:
        return self.name

    def _wrong_words(self) -> str | None:
        if not re.fullmatch(r"[a-z][a-z0-9_]*", self.name):
            return "its name becomes part of C names; use small letters, digits and _"
        if not self.meaning or not self.meaning.isprintable() or "*/" in self.meaning:
            return "its meaning must be one line of text that can stand in a comment"
        return None

    def _wrong_stages(self) -> str | None:
        for i, stage in enumerate(self.stages):
            before = self.stages[i - 1] if i else None
            if len(stage.weights) > i:
                return f"stage {i + 1} has {len(stage.weights)} weights; only {i} stages stand before it"
            if stage.implicit and stage.terms and before and stage.implicit != before.implicit:
                return f"stage {i + 1} is implicit over another part of the step than stage {i}"
        if len(self.end.weights) > len(self.stages):
            return f"the end has {len(self.end.weights)} weights; there are {len(self.stages)} stages"
        read = {j for move in (*self.stages, self.end) for j, _ in move.terms}
        unread = [i + 1 for i in range(len(self.stages)) if i not in read]
        return f"nothing reads stage {unread[0]}" if unread else None

    def _wrong_order(self) -> str | None:
        if self.order not in range(1, HIGHEST + 1):
            return f"its order is {self.order}; it must be from 1 to {HIGHEST}"
        if abs(self.end.reach - 1) > 1e-12:
            return f"the weights of its end add up to {self.end.reach}, not to 1"
        if self.order > 2 and any(move.moved != "stages" for move in (*self.stages, self.end)):
            return f"poses move with order {self.order} by the rates of stages alone"
        *stages, end = self.places
        elastic = [self._elastic(i, place) for i, place in enumerate(stages)]
        power = unmet(self.order, stages, elastic, end)
        return f"it has the order {power - 1}, not {self.order}" if power else None

    @cached_property
    def places(self) -> list[StageState]:
        """The states of the stages and of the end, in terms of the accelerations."""
        places: list[StageState] = []
        n = len(self.stages)
        for move in (*self.stages, self.end):
            rates = move.exact + (Fraction(0),) * (n - len(move.weights))
            if move.moved == "stages":
                inner = [sum((w * places[j].rates[k] for j, w in move.terms), Fraction(0)) for k in range(n)]
            else:
                inner = [move.kick * w for w in rates]
            places.append(StageState(move.reach, tuple(inner), rates))
        return places

    def _elastic(self, i: int, place: StageState) -> StageState:
        """The state at which stage i takes the elastic forces."""
        if not (part := self.stages[i].part):
            return place
        own = [Fraction(int(k == i)) for k in range(len(self.stages))]
        return StageState(part, tuple(part**2 * x for x in own), tuple(part * x for x in own))

    @property
    def implicit(self) -> bool:
        """Whether all elastic forces are implicit."""
        return all(stage.implicit for stage in self.stages)

    def settling(self, h: float) -> float:
        """The step ``h`` if stiff rows of loops settle within it, as it takes all elastic forces at its end; else 0."""
        return h if self.implicit else 0.0

    def step(self, a: Accelerations, q: Any, v: Any, h: Any, space: Space = FLAT) -> Motion:
        """Coordinates and rates `h` seconds after `q, v`: NumPy arrays, CasADi's symbols, all that has +, − and ×.

        `space`: how coordinates move where they do not add up.
        """
        rates: list[Any] = []
        accelerations: list[Any] = []
        for stage in self.stages:
            u, there_v = _moved(stage, v, h, rates, accelerations)
            there = (q if u is None else space.moved(q, u)), there_v
            found = a.implicit(q, v, times(h, stage.part), there) if stage.part else a.explicit(*there)
            rates.append(space.rate(u, there_v))
            accelerations.append(found)
        u, v = _moved(self.end, v, h, rates, accelerations)
        return space.moved(q, u), v


def _moved(move: Move, v: Any, h: Any, rates: list, accelerations: list) -> tuple[Any, Any]:
    """The change of the coordinates by a move, None for none, and the rates."""
    if not move.terms:
        return None, v
    new = v + weighted(move, h, accelerations)
    if move.moved == "new":
        return times(h, move.reach) * new, new
    if move.moved == "mean":
        return times(h, move.reach / 2) * (v + new), new
    return weighted(move, h, rates), new


def weighted(move: Move, h: Any, values: Sequence) -> Any:
    """`h` times the weighted sum of the stages' values; those of equal weight are added first."""
    groups: dict[Fraction, Any] = {}
    for j, w in move.terms:
        groups[w] = groups[w] + values[j] if w in groups else values[j]
    parts = [times(h, w) * value for w, value in groups.items()]
    return sum(parts[1:], parts[0])


def times(h: Any, part: Fraction) -> Any:
    """`part` of the step `h`."""
    if part.denominator > LONGEST:
        return float(part) * h
    return h * part.numerator / part.denominator


LONGEST = 10_000
"""The largest denominator of a fraction; numbers with larger ones are used as doubles."""


def _exact(value: Number) -> Fraction:
    try:
        return Fraction(value)
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        raise UsageError(f"a coefficient is {value!r}; it must be a number, or a fraction such as '1/3'") from None
