"""The Stumpff functions of higher order that derivatives bring into programs: their slopes lead two orders up."""

from __future__ import annotations

from collections.abc import Iterable
from math import factorial
from typing import NamedTuple

from ...ir.program import Program

LEAST, MOST = 6, 9
"""The orders that the C of the dynamics does not have; the runtime has those of order 4 and 5."""


class Slope(NamedTuple):
    """``c_k(x)``, from ``c_(k-2)`` where x is large: ``(1/(k-2)! - c_(k-2)) / x``."""

    order: int

    @property
    def first(self) -> int:
        """Its value at 0, inverted."""
        return factorial(self.order)

    @property
    def below(self) -> int:
        """That of the function two orders below."""
        return factorial(self.order - 2)


def slopes(programs: Iterable[Program], curved: bool = False) -> list[Slope]:
    """What programs call, with what that needs; those of joints that turn in space (``curved``) are always there."""
    called = {op for program in programs for op in program.operations}
    most = max((k for k in range(LEAST, MOST + 1) if f"c{k}" in called), default=0)
    return [Slope(k) for k in range(LEAST, max(most | 1, LEAST + 1 if curved else 0) + 1)]
