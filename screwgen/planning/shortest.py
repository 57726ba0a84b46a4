"""The shortest time of a motion, by bisection over fixed times: free end times hardly ever converge."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..errors import UsageError
from ..robot_model import RobotModel
from .members import Still
from .solve import Found
from .task import Task

CLOSE = 1.002
"""The ratio of a time with a plan and of one without at which the search ends."""
DOUBLINGS = 8


def shortest(
    task: Task, model: RobotModel, own: Still, search: Callable[[Task, Found | None], Found]
) -> tuple[Task, Found]:
    """The task in the shortest time that has a plan, and this plan."""
    if not (np.isfinite(task.limits.efforts).any() or np.isfinite(task.limits.rates).any()):
        raise UsageError("time: is 'shortest', but nothing limits efforts or rates; state limits, or a time")
    time = _first(task, own)
    best: Found | None = None
    failed = 0.0
    for _ in range(DOUBLINGS):
        found = search(task.within(time), best)
        if found.sound:
            best = found
            break
        failed, time = time, 2 * time
    if best is None:
        raise UsageError(f"no plan was found in {time / 2:.4g} s or less; state a time, or other limits")
    while best.time > CLOSE * failed:
        time = np.sqrt(best.time * failed) if failed else best.time / 1.4
        found = search(task.within(time), best)
        if found.sound:
            best = found
        else:
            failed = time
    return task.within(best.time), best


def _first(task: Task, own: Still) -> float:
    """A time in which a rigid arm would get there, joint by joint, with half of the efforts that remain."""
    rest = own.held(task.start)
    inertia = np.abs(np.diag(own.rigid_inertia(rest.q)))
    way, spare = np.abs(task.way), task.limits.efforts - np.abs(rest.torque)
    times = [2 * np.sqrt(2 * inertia * way / spare), 1.5 * way / task.limits.rates]
    return float(np.max(times))
