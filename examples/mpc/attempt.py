"""A solve of an Opti problem that says how it went."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import NamedTuple

import casadi as ca


class Attempt(NamedTuple):
    value: Callable
    """Of an expression at the solution, or where the solver gave up."""
    converged: bool
    iterations: int
    seconds: float
    """Processor time."""


def attempt(o: ca.Opti) -> Attempt:
    """Solve; a solver that gives up is no error."""
    start = time.process_time()
    try:
        value, converged = o.solve().value, True
    except RuntimeError:
        value, converged = o.debug.value, False
    seconds = time.process_time() - start
    return Attempt(value, converged, int(o.debug.stats().get("iter_count", -1)), seconds)
