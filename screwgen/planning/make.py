"""Plans of a robot's motions: what a caller asks for, checked, sought, and explained where there is none."""

from __future__ import annotations

import time as clock
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..arguments import Given, Numbers, array, seconds, whole
from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.dry_friction import with_spread_friction
from ..spec.plan import INTERVALS, LARGEST, LEAST, SHORTEST
from .bumps import FINER
from .bumps import fast as fast_found
from .followed import within_efforts
from .limits import HEADROOM, motion_limits
from .members import PlannedModel, Still, member
from .plan import MotionPlan
from .refusals import BY_MOTION, check_ends, no_fast_plan, no_plan, passed_by_friction, refuse_robot
from .shortest import shortest
from .solve import Found, Progress, solve
from .task import JointLaw, Task
from .waypoints import waypoints

SPREAD = 0.2
"""Over which share of the mean rate of the joint that goes farthest dry friction changes its sign in a search."""


def plan(
    model: RobotModel,
    start: Numbers,
    goal: Numbers,
    time: float | str,
    *,
    gains: Any = None,
    through: Sequence[Mapping[str, Any]] = (),
    models: Sequence[Mapping[str, float]] = (),
    limits: Mapping[str, Any] | None = None,
    intervals: int = INTERVALS,
    fast: bool = False,
    parameters: Given = None,
    progress: Progress | None = None,
) -> MotionPlan:
    """A motion of the joints from rest to rest that leaves nothing vibrating, with its torques.

    `start`, `goal` (n_joints,), rad, of slides m, of elastic drives the rotor's angle over the ratio; `time`, s, or
    "shortest", which is fragile: nothing is left for what the model does not know. Of all such motions it is the one
    with the least integral of squared rates of torques.

    `through`: joint coordinates between start and goal, `{"q": (n_joints,), "t": s}`. Without `t` they are passed when
    the share of the time is that of the way.
    `gains`: a law with `kp`, `kd` and perhaps `tau_max`, such as a :class:`PD`, under which the plan is to be played.
    `models`: factors of parameters of further models, by names or patterns as `{"*.bodies[0].mass": 1.3}`; with them
    the same references and torques bring all models to rest, each under the law of the joints, and at its own sag.
    `limits`: `lower`, `upper`, `rates`, `efforts` and `effort_rates` of the joints, tighter ones than those of the
    robot file; a joint that no drive moves, as a rope's, has the effort 0. Efforts are those of drives, of a cylinder
    the force along it, N; ranges and rates are those of joints. `strains` and `wrenches` are tables of the largest
    sizes of `model.strain_names` and `model.wrench_names`, as `{"*.base_strain.*": 0.02}`.
    `intervals`: of the time; torques are linear over each, so they do not reach modes faster than these.
    `fast`: joints move along polynomials whose coefficients are found by least squares, within a second or so. Limits
    are not sought with but checked: a motion that passes one is refused. The time is stated; intervals are finer.

    Raises UsageError, which names the limit where one forbids the motion.
    """
    refuse_robot(model, refused=(BY_MOTION,))
    m, began = model.n_joints, clock.perf_counter()
    bounds, law = motion_limits(model, limits or {}, gains), law_of(gains, m, bool(models))
    intervals = whole(intervals, "intervals", LEAST, LARGEST)
    fixed = time != SHORTEST
    if fast and not fixed:
        raise UsageError("time: is 'shortest', which is sought with limits; plan without fast, or state a time")
    ends = array(start, "start:", (m,)), array(goal, "goal:", (m,))
    duration = seconds(time, "the time") if fixed else 1.0
    task = Task(*ends, duration, intervals, law, bounds, waypoints(through, *ends, time))
    values = model.chain.parameters.vector(parameters)
    own, others = Still(model, values), [Still(model, scaled(model, values, factors)) for factors in models]
    first = check_ends(task, model, own, fixed)
    task = task.measured_in(own.rigid_inertia(first.q), first.effort, own.levers_at(first.q))
    calm, *more = (_calm(x, task) for x in (own, *others))
    search = lambda task, near: _found(task, calm, more, near, progress)  # noqa: E731
    if fast:
        task = replace(task, intervals=FINER * intervals)
        members = _members(task, own, others)
        found = fast_found(task, members, progress)
        if why := no_fast_plan(task, model, members, found):
            raise why
    elif fixed:
        found = search(task, None)
        if not found.sound:
            raise no_plan(task, model, own, search)
    else:
        found = shortest(task, own, search)
    if not fast:
        seek = search if fixed else lambda task, near: shortest(task, own, search, near)
        found = within_efforts(task, _members(task, calm, more), found, seek)
        task = task.within(found.time)
    if calm is not own and not fast:
        found = _with_friction(own, found)
        if why := passed_by_friction(task, model, own, found):
            raise why
    took = {
        "iterations": found.iterations,
        "seconds": clock.perf_counter() - began,
        "cost": found.cost,
        "left": found.left,
    }
    return _planned(model, task, found, took | {"models": 1 + len(others)})


def _planned(model: RobotModel, task: Task, found: Found, said: Mapping[str, Any]) -> MotionPlan:
    """What a search has found, as a plan."""
    m, motion = model.n_joints, found.motions[0]
    q, v, a = (np.ascontiguousarray(x[:m].T) for x in (motion.q, motion.v, motion.a))
    efforts = np.ascontiguousarray(found.efforts_at_points.T)
    t, names = np.linspace(0.0, task.time, len(q)), tuple(model.q_names[:m])
    limits, law = task.limits.efforts / HEADROOM, task.law
    return MotionPlan(model.robot.name, names, t, q, v, a, efforts, law.kp, law.kd, limits, said)


def _calm(still: Still, task: Task) -> Still:
    """The model with dry friction whose change of sign a search bears; itself where there is none."""
    p = with_spread_friction(still.model.robot, still.p, SPREAD * float(np.abs(task.way).max()) / task.time)
    return still if np.array_equal(p, still.p) else Still(still.model, p)


def _with_friction(own: Still, found: Found) -> Found:
    """The same motion with the efforts, at all points, of friction as it is: drives bear it where they cause it."""
    return replace(found, efforts=own.efforts(found.motions[0]))


def _found(task: Task, own: Still, others: Sequence[Still], near: Found | None, progress: Progress | None) -> Found:
    """The plan for the first model, then for all, from it on."""
    members = _members(task, own, others)
    exact = bool(own.model.chain.n_added)  # the springs of gears bend the constraints too much to do without
    alone = near or solve(task, members[:1], None, progress, exact)
    if near is None and not (alone.sound and others):
        return alone
    return solve(task, members, alone, progress, exact)


def _members(task: Task, own: Still, others: Sequence[Still]) -> list[PlannedModel]:
    """All models of a task, the one that is planned for first."""
    first = member(own, task, None)
    return [first, *(member(x, task, first) for x in others)]


def scaled(model: RobotModel, values: np.ndarray, factors: Mapping[str, float]) -> np.ndarray:
    """Parameters of a further model."""
    if not isinstance(factors, Mapping):
        raise UsageError("models: each is a table of factors of parameters, as {'*.bodies[0].mass': 1.3}")
    out = values.copy()
    for pattern, factor in factors.items():
        out[list(model.chain.parameters.chosen(pattern))] *= array(factor, f"models: {pattern}", ()).item()
    return model.chain.parameters.vector(out)


def law_of(gains: Any, m: int, needed: bool = False) -> JointLaw:
    """The law that `gains` are; zero without them. Refuses laws that are more than proportional-derivative ones."""
    if gains is None:
        if needed:
            raise UsageError("models: several share a motion under the law of the joints alone; give gains")
        return JointLaw(np.zeros(m), np.zeros(m))
    ki = getattr(gains, "ki", None)
    if ki is not None and np.any(ki):
        raise UsageError("gains: the law has an integral, which would be left out; give a law with kp and kd alone")
    if not all(hasattr(gains, name) for name in ("kp", "kd")) or hasattr(gains, "lqg"):
        raise UsageError("gains: the law has no gains kp and kd of its own; give a PD law")
    return JointLaw(*(array(getattr(gains, name), f"gains: {name}:", (m,)) for name in ("kp", "kd")))
