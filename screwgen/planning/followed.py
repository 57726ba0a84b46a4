"""The efforts of a plan with those that the joint law adds: the arm's own motion under both, on a finer grid.

A search meets the equations of motion by the rule of its intervals. What moves faster than these goes otherwise in
between, and joints that it pushes off their references are brought back by the law, whose efforts come beside.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from .between import Curve
from .bumps import CLOSE, Responding
from .limits import HEADROOM
from .members import PlannedModel
from .plan import PlanWarning
from .solve import Found
from .task import Task

FINER, STEPS = 5, 6
"""Intervals in one of the search, and steps of Newton's method."""
ROUNDS, FURTHER = 4, 1.1
"""How often efforts are looked at, and by how much more than they pass their limits these are tightened."""
SPARE = 0.003
"""The share of a limit that is left for what the finer grid lacks."""


def efforts_with_law(task: Task, member: PlannedModel, found: Found, i: int = 0) -> np.ndarray:
    """(n_joints,): the largest efforts, of either sign, of drives of the i-th model that play what was found.

    nan where Newton's method ends at no motion on the finer grid.
    """
    m, fine = len(task.start), replace(task, intervals=FINER * task.intervals)
    first, efforts = found.motions[0], found.efforts_at_points
    stretches = first.q.shape[1] - 1
    at = np.linspace(0.0, stretches, 2 * fine.intervals + 1)
    k = np.minimum(at.astype(int), stretches - 1)
    between = lambda x: np.array([np.interp(at, np.arange(stretches + 1), row) for row in x])  # noqa: E731
    references, (q, v) = (Curve(x.q, x.v, x.a, task.time / stretches).at(k, at - k) for x in (first, found.motions[i]))
    told = np.stack([*(x[:m] for x in references), between(efforts)])
    moved = np.stack([q, v, between(found.motions[i].a)])
    responding = Responding(fine, member, given=False)
    for _ in range(STEPS):
        followed = responding.follow(moved, told, np.zeros((*told.shape, 0)))
        moved = followed.motion
        if followed.off <= CLOSE:
            break
    else:
        return np.full(m, np.nan)
    added = task.law.torques(*(told[:2] - moved[:2, :m])) / member.still.levers_at(moved[0])
    return np.abs(told[2] + added).max(axis=1)


def within_efforts(
    task: Task, members: Sequence[PlannedModel], found: Found, search: Callable[[Task, Found | None], Found]
) -> Found:
    """What was found, or a plan with tighter limits that leaves the law what it takes; that which does so most.

    A search for the shortest time may give plans that take longer. A warning says where none leaves enough, and where
    the finer grid has no motion, as of a rope that goes slack; the plan is then as it was found.
    """
    most = task.limits.efforts / HEADROOM
    limited = np.isfinite(most) & (most > 0)
    if not (limited & (task.law.kp > 0)).any():
        return found
    best, least = found, np.inf
    for _ in range(ROUNDS):
        task = task.within(found.time)
        each = [efforts_with_law(task, member, found, i) for i, member in enumerate(members)]
        excess = np.max(each, axis=0)[limited] - (1.0 - SPARE) * most[limited]
        worst = float((excess / most[limited]).max())
        if worst < least:
            best, least = found, worst
        efforts = task.limits.efforts.copy()
        efforts[limited] -= FURTHER * np.maximum(excess, 0.0)
        if not worst > 0 or not (efforts[limited] > 0).all():
            break
        task = replace(task, limits=replace(task.limits, efforts=efforts))
        again = search(task, found)
        if not again.sound:
            break
        found = replace(again, iterations=again.iterations + found.iterations)
    if least > 0:
        took = f"pass the limit of a drive by {100 * least:.2g} %" if np.isfinite(least) else "could not be found"
        said = f"its {task.intervals} intervals do not resolve what the motion excites"
        remedy = "give more intervals or more time; the report says what drives give when it is played"
        warnings.warn(f"plan: {said}: efforts with those of the law {took}; {remedy}", PlanWarning, stacklevel=3)
    return best
