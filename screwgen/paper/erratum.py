"""An erratum: where the paper fails, what holds, and the numbers that show it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property

from .equation import Equation

WRONG, RIGHT = 1e-3, 1e-9
"""Relative to the figure's scale: a printed figure is wrong beyond the first, a derived one right within the second."""


@dataclass(frozen=True)
class Figure:
    """One number by which a formula is judged: what the printed formula gives, the derived one, and what must be.

    ``within``: how far the derived figure may be from the truth, relative to ``scale`` (default: the larger of truth
    and printed figure): rounding, unless the figure says otherwise, as published numbers of few digits do.
    """

    what: str
    unit: str
    printed: float
    derived: float
    truth: float = 0.0
    within: float = RIGHT
    scale: float | None = None

    @classmethod
    def of(cls, what: str, unit: str, both: Iterable[float], truth: float = 0.0, **more: float) -> Figure:
        """The figure of two numbers, the printed formula's and the derived one's."""
        printed, derived = map(float, both)
        return cls(what, unit, printed, derived, truth, **more)

    @property
    def size(self) -> float:
        return self.scale or max(abs(self.truth), abs(self.printed)) or 1.0

    @property
    def printed_fails(self) -> bool:
        return not abs(self.printed - self.truth) <= WRONG * self.size

    @property
    def derived_holds(self) -> bool:
        return abs(self.derived - self.truth) <= self.within * self.size


@dataclass(frozen=True, kw_only=True)
class Erratum:
    """``where``: labels of the equations concerned; ``printed`` and ``holds``: sentences with inline ``$LaTeX$``.

    ``evidence`` computes the figures.  Every one must have a printed figure that fails and derived figures that hold.
    """

    number: str
    where: tuple[str, ...]
    title: str
    printed: str
    holds: str
    evidence: Callable[[], tuple[Figure, ...]]

    @cached_property
    def figures(self) -> tuple[Figure, ...]:
        """The evidence, computed once."""
        return self.evidence()


def misfit(equations: Iterable[Equation], label: str, seed: int = 1) -> Figure:
    """The relative misfit of an equation, as printed and as derived: on a random motion, or by its judge."""
    e = next(e for e in equations if e.label == label)
    printed, derived = e.misfits(seed)
    what = f"relative misfit of ({label})" + ("" if e.judge else " on a random motion")
    return Figure(what, "-", printed, derived, within=1e-11, scale=1.0)
