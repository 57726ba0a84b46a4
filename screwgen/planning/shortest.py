"""The shortest time of a motion, by bisection over fixed times: free end times hardly ever converge."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..errors import UsageError
from .members import Still
from .solve import Found
from .task import Task

CLOSE = 1.002
"""The ratio of a time with a plan and of one without at which the search ends."""
DOUBLINGS = 8
LONGER, FACTOR = 1.02, 1.15
"""Of the time of a motion nearby what is tried first, and by how much more again where that has no plan."""


def shortest(task: Task, own: Still, search: Callable[[Task, Found | None], Found], near: Found | None = None) -> Found:
    """The plan of a task in the shortest time that has one; `near`: one in less time, under wider limits."""
    if not (np.isfinite(task.limits.efforts).any() or np.isfinite(task.limits.rates).any()):
        raise UsageError("time: is 'shortest', but nothing limits efforts or rates; state limits, or a time")
    time, factor, failed = _first(task, own), 2.0, 0.0
    if near is not None:
        time, factor, failed = LONGER * near.time, FACTOR, near.time
    best: Found | None = None
    for _ in range(DOUBLINGS):
        found = search(task.within(time), near)
        if found.sound:
            best = found
            break
        failed, time = time, factor * time
    if best is None and near is not None:
        return replace(near, sound=False)
    if best is None:
        raise UsageError(f"no plan was found in {failed:.4g} s or less; state a time, or other limits")
    while best.time > CLOSE * failed:
        time = np.sqrt(best.time * failed) if failed else best.time / 1.4
        found = search(task.within(time), best)
        if found.sound:
            best = found
        else:
            failed = time
    return best


def _first(task: Task, own: Still) -> float:
    """A time in which a rigid arm would get there, joint by joint, with half of the efforts that remain.

    A joint that no drive moves, whose effort is 0, is carried along by the others.
    """
    rest = own.held(task.start)
    inertia = np.abs(np.diag(own.rigid_inertia(rest.q)))
    way, spare = np.abs(task.way), np.abs(own.levers_at(rest.q)) * (task.limits.efforts - np.abs(rest.effort))
    driven = task.limits.efforts > 0
    times = [2 * np.sqrt(2 * (inertia * way)[driven] / spare[driven]), 1.5 * way / task.limits.rates]
    return float(np.concatenate(times).max()) or 1.0
