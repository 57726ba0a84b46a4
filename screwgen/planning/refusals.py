"""What forbids a plan, in one line: the kind of robot, an end of the motion, or a limit, found by leaving it out."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Sequence
from dataclasses import replace

import numpy as np

from ..errors import UsageError
from ..robot_model import RobotModel
from .collocation import Trajectory
from .limits import HEADROOM
from .members import AtRest, PlannedModel, Still
from .solve import Found
from .task import MotionLimits, Task

GROUPS = {
    "efforts": ("efforts",),
    "rates": ("rates",),
    "joint ranges": ("lower", "upper"),
    "rates of efforts": ("effort_rates",),
    "strains": ("strains",),
    "joint wrenches": ("wrenches",),
}
"""The limits that are left out together to see which of them forbids a motion."""
ROUNDING = 1e-9
TRANSMISSIONS, GIVEN = "transmissions", "axes whose motion is given"
PLANNED = (TRANSMISSIONS, GIVEN, "brakes", "tendons or other inputs")
"""Features of robots for which there are plans, and not every other tool for motions."""
BY_MOTION = "drives whose steps hold what their motion allows"
"""A feature for which there are other tools, and no plans: what such a drive can give is no limit that is stated."""


def refuse_robot(
    model: RobotModel,
    what: str = "plan",
    instead: str = "give references of your own",
    refused: Container[str] = (),
    loops: bool = False,
) -> None:
    """Refuse robots whose coordinates are not those of joints with a drive each, of gears that twist, and of modes.

    ``what``: there is none for them. ``refused``: of the features above those that it does not have. Inputs of other
    kinds stand at 0, so brakes are open and tendons slack. ``loops``: it takes robots with loops, whose joints follow
    others.
    """
    chain = model.chain
    chain.refuse_quaternion_joints(what, instead)
    chain.refuse_floating_base(what, instead)
    if not loops:
        chain.refuse_loops(what, instead)
    others = {
        TRANSMISSIONS: bool(chain.travels),
        GIVEN: bool(chain.prescribed),
        "inputs that load links": chain.inputs_load_links,
        "brakes": bool(chain.braked),
        "tendons or other inputs": chain.n_tau != chain.n_joints,
        "internal states": bool(chain.n_internal or chain.n_force_states),
        "no joints": not chain.n_joints,
        BY_MOTION: chain.holds_by_motion,
    }
    for feature, there in others.items():
        if there and (feature in refused or feature not in (*PLANNED, BY_MOTION)):
            raise UsageError(f"robot '{model.robot.name}' has {feature}, for which there is no {what} yet; {instead}")


def check_ends(task: Task, model: RobotModel, own: Still, fixed: bool) -> AtRest:
    """The rest at the start; refuses ends beyond limits of joints, efforts that do not hold there, a way too far."""
    limits, names = task.limits, model.q_names
    through = ((f"through[{i}]", x.joints) for i, x in enumerate(task.through))
    for end, joints in (("start", task.start), *through, ("goal", task.goal)):
        for j, (x, low, high) in enumerate(zip(joints, limits.lower, limits.upper, strict=True)):
            if not low - ROUNDING <= x <= high + ROUNDING:
                raise UsageError(f"{end}: {names[j]} is {x:g}; its limits are {low:g} and {high:g}")
    start, goal = own.held(task.start), own.held(task.goal)
    for end, rest in (("start", start), ("goal", goal)):
        for j, (effort, most) in enumerate(zip(np.abs(rest.effort), limits.efforts, strict=True)):
            if effort > most + ROUNDING * (1.0 + np.abs(rest.effort).max()):
                said = f"{end}: to rest there takes {effort:.4g} of {names[j]}"
                if not most:
                    remedy = "give the rest to all digits, as equilibrium --json prints it"
                    raise UsageError(f"{said}, which no drive moves as its limit of efforts is 0; {remedy}")
                raise UsageError(f"{said}; of its limit {most:.4g} is planned with")
        for _, sizes, most, every in _loads(
            model, own, Trajectory(rest.q[:, None], 0.0 * rest.q, 0.0 * rest.q), limits
        ):
            if (over := np.flatnonzero(sizes > most * (1.0 + ROUNDING))).size:
                j = int(over[0])
                raise UsageError(f"{end}: at rest {every[j]} is {sizes[j]:.4g}; its limit is {most[j]:.4g}")
    way, rates = np.abs(task.way), limits.rates
    if fixed and (fast := np.flatnonzero(way > rates * task.time)).size:
        j = int(fast[0])
        said = f"{names[j]} goes {way[j]:.4g} in {task.time:g} s, with a rate of {rates[j]:g} at most"
        raise UsageError(f"time: {said}; it takes more than {way[j] / rates[j]:.4g} s")
    if not way.any():
        raise UsageError("goal: is the start; give another one")
    return start


def no_plan(task: Task, model: RobotModel, own: Still, search: Callable[[Task, Found | None], Found]) -> UsageError:
    """The error of a task without a plan: which limit forbids it, found by seeking without it."""
    said = f"no plan was found in {task.time:g} s"
    there = _stated(task.limits)
    if there:
        free = search(without(task, there), None)
        if free.sound:
            passed = [what for name in there if (what := _passed(name, task, model, own, free))]
            alone = (name for name in there if search(without(task, [name]), free).sound)
            cause = f"the limits of {next(alone, ' and '.join(there))} forbid it"
            return UsageError(f"{said}: {cause}; without limits {', '.join(passed)}; take more time, or raise limits")
    remedy = "take more time, other intervals, or an order of the links that bears such bends"
    return UsageError(f"{said}: the search did not converge{', even without limits' * bool(there)}; {remedy}")


def no_fast_plan(task: Task, model: RobotModel, members: Sequence[PlannedModel], found: Found) -> UsageError | None:
    """The error of a fast search that leaves the arm vibrating, or passes a limit; None where it does neither."""
    remedy = "plan without fast, which seeks with limits, or take more time"
    if not found.sound:
        return UsageError(f"the fast search brings the arm to no rest in {task.time:g} s; {remedy}")
    first = found.motions[0].joints(len(task.start))
    for i, (member, motion) in enumerate(zip(members, found.motions, strict=True)):
        own = motion.joints(len(task.start))
        added = task.law.torques(first.q - own.q, first.v - own.v) / member.still.levers_at(motion.q)
        moved = replace(found, motions=[motion], efforts=found.efforts + added * (i > 0))
        for name in _stated(task.limits):
            if (name != "rates of efforts" or not i) and (what := _passed(name, task, model, member.still, moved)):
                of = f" of models[{i - 1}]" * (i > 0)
                return UsageError(f"the fast plan passes the limits of {name}{of}: {what}; {remedy}")
    return None


def passed_by_friction(task: Task, model: RobotModel, own: Still, found: Found) -> UsageError | None:
    """The error of a motion whose drives, with dry friction as it is, pass what they have; None where they do not."""
    whole = replace(task, limits=replace(task.limits, efforts=task.limits.efforts / HEADROOM))
    for name in _stated(task.limits):
        if name in ("efforts", "rates of efforts") and (what := _passed(name, whole, model, own, found)):
            return UsageError(f"dry friction passes the limits of {name}: {what}; take more time, or raise limits")
    return None


def _stated(limits: MotionLimits) -> list[str]:
    """The groups of limits that there are."""
    return [name for name, keys in GROUPS.items() if any(np.isfinite(getattr(limits, k)).any() for k in keys)]


def without(task: Task, groups: list[str]) -> Task:
    """The task with some limits left out; joints that no drive moves, whose effort is 0, do not get one."""
    keys = [key for name in groups for key in GROUPS[name]]
    free = {key: np.full_like(getattr(task.limits, key), -np.inf if key == "lower" else np.inf) for key in keys}
    if "efforts" in free:
        free["efforts"][task.limits.efforts == 0] = 0.0
    return replace(task, limits=replace(task.limits, **free))


def _passed(group: str, task: Task, model: RobotModel, own: Still, found: Found) -> str:
    """By how much a motion without limits passes those of a group, where it does so most."""
    m, limits, motion = len(task.start), task.limits, found.motions[0]
    pace = np.diff(found.efforts, axis=1) * (found.efforts.shape[1] - 1) / task.time
    loads = {what: (sizes, most, "", names) for what, sizes, most, names in _loads(model, own, motion, limits)}
    reached, most, unit, names = {
        "efforts": (np.abs(found.efforts).max(axis=1), limits.efforts, "", model.q_names),
        "rates": (np.abs(motion.v[:m]).max(axis=1), limits.rates, " 1/s", model.q_names),
        "joint ranges": (*_beyond(motion.q[:m], limits), model.q_names),
        "rates of efforts": (np.abs(pace).max(axis=1), limits.effort_rates, " per s", model.q_names),
        **loads,
    }[group]
    j = int(np.argmax(reached / np.maximum(most, 1e-12)))
    passed = reached[j] > most[j] * (1 + ROUNDING)
    return f"{names[j]} would take {reached[j]:.4g}{unit} of {most[j]:.4g}" if passed else ""


def _loads(
    model: RobotModel, own: Still, motion: Trajectory, limits: MotionLimits
) -> Iterator[tuple[str, np.ndarray, np.ndarray, list[str]]]:
    """Of strains and joint wrenches that are limited: the largest sizes in a motion, their limits and names."""
    if np.isfinite(limits.strains).any():
        sizes = np.abs(np.array(own.strains(motion.q))).max(axis=1)
        yield "strains", sizes, limits.strains, model.strain_names
    if np.isfinite(limits.wrenches).any():
        sizes = np.abs(np.array(own.wrenches(motion.q, motion.v, motion.a))).max(axis=1)
        yield "joint wrenches", sizes, limits.wrenches, model.wrench_names


def _beyond(q: np.ndarray, limits: MotionLimits) -> tuple[np.ndarray, np.ndarray, str]:
    """The farthest coordinates, with the limits on their sides, counted from the middle of the range."""
    with np.errstate(invalid="ignore"):
        over, under = q.max(axis=1) - limits.upper, limits.lower - q.min(axis=1)
    return 1.0 + np.maximum(over, under), np.ones(len(q)), " (1 is its limit)"
