"""A method as a list of operations on few states, in the order in which a program runs them.

Every stage adds its rates to the states that are still to come; a state whose last rates are in is complete. So a
program needs no list of all stages' rates: its states are the step's start, the next state and some `registers`.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from .method import Method, Move

NEXT = "next"
FIRST = "stage"


@dataclass(frozen=True)
class Evaluate:
    """The accelerations of a stage at a state (None: the start); `renewed`: the elastic forces are not those before."""

    kind: ClassVar[str] = "evaluate"
    number: int
    at: str | None
    implicit: Fraction
    renewed: bool


@dataclass(frozen=True)
class Turn:
    """The rates by which poses move, from the twists of a stage that has moved on a curve."""

    kind: ClassVar[str] = "turn"
    at: str


@dataclass(frozen=True)
class Advance:
    """Add `by` steps of the last rates, those at a state (None: the start), to `to`, the `first` to the start's."""

    kind: ClassVar[str] = "advance"
    by: Fraction
    at: str | None
    to: str
    first: bool
    complete: bool


@dataclass(frozen=True)
class Leap:
    """`to` from the start by `by` steps of the rates after a `kick` of the last accelerations.

    The last joint rates are to be moved by `lead` steps of them.
    """

    kind: ClassVar[str] = "leap"
    by: Fraction
    kick: Fraction
    lead: Fraction
    to: str


Operation = Evaluate | Turn | Advance | Leap


class Plan:
    """The operations of a method."""

    def __init__(self, method: Method):
        self.method = method
        self.registers: list[str] = []
        self.operations: list[Operation] = []
        self._moves: tuple[Move, ...] = (*method.stages, method.end)
        self._places: dict[int, str] = {len(method.stages): NEXT}
        self._free: list[str] = []
        for i in range(len(method.stages)):
            self._stage(i)

    @property
    def lengths(self) -> list[Fraction]:
        """The parts of a step that occur, without sign, largest first; 0 and 1 left out."""
        parts = {abs(getattr(op, x, Fraction(0))) for op in self.operations for x in ("implicit", "by", "kick", "lead")}
        return sorted(parts - {0, 1}, reverse=True)

    def _stage(self, i: int) -> None:
        stage, at = self.method.stages[i], self._places.get(i)
        renewed = not (stage.implicit and stage.terms)
        self.operations.append(Evaluate(i + 1, at, stage.part, renewed))
        later = [t for t in range(i + 1, len(self._moves)) if i in dict(self._moves[t].terms)]
        if at and any(self._moves[t].moved == "stages" for t in later):
            self.operations.append(Turn(at))
        for t in self._order(later, at):
            self._add(i, t, at)

    def _order(self, later: list[int], at: str | None) -> list[int]:
        """The moves that stage i adds to; the last of the new ones takes the place of the stage itself, which ends."""
        new = [t for t in later if t not in self._places]
        for t in new[:-1] if at else new:
            self._places[t] = self._register()
        if at and new:
            self._places[new[-1]] = at
        elif at:
            self._free.append(at)
        known = [t for t in reversed(later) if t not in new]
        return known + new

    def _register(self) -> str:
        if self._free:
            return self._free.pop()
        count = len(self.registers)
        self.registers.append(f"{FIRST}_{count + 1}" if count else FIRST)
        return self.registers[-1]

    def _add(self, i: int, t: int, at: str | None) -> None:
        move, to = self._moves[t], self._places[t]
        terms = [j for j, _ in move.terms]
        if move.moved == "stages":
            weight = dict(move.terms)[i]
            self.operations.append(Advance(weight, at, to, i == terms[0], i == terms[-1]))
        else:
            lead = move.kick - self.method.stages[i].reach
            self.operations.append(Leap(move.reach, move.kick, lead, to))
