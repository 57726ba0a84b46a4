"""Plans of tip paths: the joint motions and torques with which the tip of a flexible arm is where a path is."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import casadi as ca
import numpy as np

from ..arguments import Given, Numbers, array, real_numbers, seconds
from ..errors import UsageError
from ..robot_model import RobotModel
from .collocation import Trajectory
from .inversion import IMMOBILE, TipEquations, Window, inverted
from .limits import motion_limits
from .make import law_of
from .members import Still
from .plan import MotionPlan
from .refusals import refuse_robot
from .solve import Progress
from .task import MotionLimits
from .tip_path import jump

Path = Callable[[np.ndarray], Any]
"""Places (…, 3), m, in inertial axes at times (…), s."""
PREVIEW, STEP = 0.1, 1e-3
MORE = 0.5
"""How much longer than what is played the window is at either end, s, so that what is left there may be seen."""
MEETS, NEWTONS, AMISS = 1e-9, 60, 1e-6
"""Of the search for joints of the arm that does not bend: the last step, rad or m; the most steps; and how far from a
place, by the arm's length, the tip is that cannot reach it.
"""
STARTS, SEED = 12, 1
"""Where no posture of the start is stated: from how many it is sought, and the seed with which these are drawn."""
FLAT = 1e-3
"""Below this ratio of the slowest to the fastest motion of the tip by joints a posture is singular."""
CUT = 2e-5
"""The share of the joints' way that may be cut off at either end of the preview."""


def track(
    model: RobotModel,
    path: Path,
    time: float,
    *,
    near: Numbers | None = None,
    preview: float = PREVIEW,
    step: float = STEP,
    gains: Any = None,
    parameters: Given = None,
    progress: Progress | None = None,
) -> MotionPlan:
    """A plan whose tip is at `path(t)` from 0 to `time`, at rest before and behind.

    `path`: a function of times (…), s, that gives places (…, 3), m, in inertial axes; it begins and ends at rest. The
    plan is longer than it by `preview` at either end: bending begins before the tip moves, so the tip is at `path(t)`
    at the time `t + preview` of the plan. `near` (n_joints,): joints from where the posture of the start is sought;
    zero and then others, if not given.
    Joints follow the tip in the directions in which they move it; where there are fewer than three it is off by what
    bending shortens in the others. Of more joints than directions those move that have the least way to go. `step`:
    between the points of the plan, s. `gains`: a law with `kp` and `kd` to play it under.

    Of a joint behind an elastic gear the plan says what its rotor does, over the ratio; the tip is where the path is
    nevertheless. The rotor moves as the tip's acceleration, so its torque is finite where the path is smooth up to its
    third derivative, or links that bend make it so.

    Raises UsageError: a path out of reach, a singular posture, a path that jumps, too short a preview.
    """
    refuse_robot(model, "tip path", "give joint references of your own")
    m, began = model.n_joints, clock.perf_counter()
    time, preview, step = (
        seconds(x, what) for x, what in ((time, "the time"), (preview, "the preview"), (step, "the step"))
    )
    p = model.chain.parameters.vector(parameters)
    points = int(np.ceil((time + 2 * preview) / step - 1e-9))
    step = (time + 2 * preview) / points
    more = int(np.ceil(MORE / step))
    window = Window(points + 1 + 2 * more, step)
    t = step * (np.arange(window.count) - more) - preview
    goal = _sampled(path, t, time, step)
    still = Still(model, p)
    tip = _tip(still)
    joints = _rigid(model, tip, goal, None if near is None else array(near, "near:", (m,)))
    equations = TipEquations(still, tip, goal, joints)
    start = np.hstack([joints, np.tile(still.held(joints[0]).q[m:], (len(t), 1))])
    q, v, a, iterations = inverted(equations, window, start, progress)
    if model.chain.n_added and (k := jump(q[:, :m], step)):
        jumps = f"its acceleration or the rate of that jumps at {t[k]:.4g} s, and with it a rotor behind its gear"
        raise UsageError(f"path: {jumps}; give a path that is smooth up to its third derivative")
    played = slice(more, more + points + 1)
    _check_cut(q[:, :m], played, preview)
    off = float(np.linalg.norm(equations.off(q)[played], axis=1).max())
    said = {"iterations": iterations, "seconds": clock.perf_counter() - began, "preview": preview, "off": off}
    return _planned(model, still, time + 2 * preview, [x[played] for x in (q, v, a)], gains, said)


def _planned(
    model: RobotModel, still: Still, time: float, motion: Sequence[np.ndarray], gains: Any, said: Mapping[str, Any]
) -> MotionPlan:
    """The plan of coordinates, rates and accelerations at its points, which rests at both ends; checks limits."""
    m, points = model.n_joints, len(motion[0])
    law, limits = law_of(gains, m), motion_limits(model, {}, gains, 1.0)
    tau = still.efforts(Trajectory(*(x.T for x in motion))).T
    q, v, a = (np.ascontiguousarray(x[:, :m]) for x in motion)
    for end in (0, -1):
        v[end] = a[end] = 0.0
        tau[end] = still.held(q[end]).effort
    names, most = tuple(model.q_names[:m]), limits.efforts
    check_limits("path", q, tau, limits, names)
    return MotionPlan(model.robot.name, names, np.linspace(0.0, time, points), q, v, a, tau, law.kp, law.kd, most, said)


def _sampled(path: Path, t: np.ndarray, time: float, step: float) -> np.ndarray:
    """The path at times (count, 3), at rest outside of it."""
    if not callable(path):
        raise UsageError("path: is no function of t; give one of times (…), s, to places (…, 3), m")
    goal = real_numbers(path(np.clip(t, 0.0, time)))
    if goal is None or goal.shape != (len(t), 3):
        said = "something else than numbers" if goal is None else f"an array of shape {goal.shape}"
        raise UsageError(f"path: gives {said} at {len(t)} times; it must give ({len(t)}, 3), m")
    if not np.isfinite(goal).all():
        raise UsageError("path: gives a NaN or an infinity; it must give finite numbers")
    if k := jump(goal, step):
        raise UsageError(f"path: it or its rate jumps at {t[k]:.4g} s; begin and end at rest, and give a smooth one")
    return goal


def _tip(still: Still) -> ca.Function:
    """The place of the tip (3,) as a function of coordinates, those of drives first."""
    q = ca.SX.sym("q", still.model.nq)
    return ca.Function("tip", [q], [still.model.casadi()["tip_pose"](still.drives.to_robot(q), still.p)[1]])


def _rigid(model: RobotModel, tip: ca.Function, goal: np.ndarray, near: np.ndarray | None) -> np.ndarray:
    """(count, n_joints): joints with which the tip of the arm that does not bend is on the path."""
    arm = _UnbentArm(model, tip)
    x, out = arm.begin(goal[0], near), []
    for k, place in enumerate(goal):
        if not (k and np.array_equal(place, goal[k - 1])):
            x = arm.posture(place, x)
            if why := arm.fault(place, x):
                raise UsageError(f"path: {why}")
        out.append(x)
    return np.array(out)


class _UnbentArm:
    """Where joints (n_joints,) bring the tip of an arm that does not bend."""

    def __init__(self, model: RobotModel, tip: ca.Function):
        m, joints = model.n_joints, ca.SX.sym("q", model.n_joints)
        place = tip(ca.vertcat(joints, ca.DM.zeros(model.nq - m)))
        self.both = ca.Function("both", [joints], [place, ca.densify(ca.jacobian(place, joints))])
        self.limits = model.chain.limits
        low, high = np.clip(self.limits.T, -np.pi, np.pi)
        self.drawn = np.random.default_rng(SEED).uniform(low, high, (STARTS, len(low)))
        sizes = [np.linalg.svd(self.at(x)[1], compute_uv=False) for x in self.drawn]
        self.directions = max(1, max(int((x > IMMOBILE * x[0]).sum()) for x in sizes))
        """In how many directions joints move the tip in most postures."""
        self.length = sum(link.length or 0.0 for link in model.robot.links) or 1.0

    def at(self, joints: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The tip (3,), m, and its derivatives (3, n_joints)."""
        place, J = (np.array(found) for found in self.both(joints))
        return place.ravel(), J

    def posture(self, place: np.ndarray, near: np.ndarray) -> np.ndarray:
        """The joints that bring the tip to a place, or as near to it as a search comes."""
        x = near.copy()
        for _ in range(NEWTONS):
            there, J = self.at(x)
            step = np.linalg.lstsq(J, place - there, rcond=IMMOBILE)[0]
            x += step * min(1.0, 0.3 / max(np.abs(step).max(), 1e-12))
            if np.abs(step).max() < MEETS:
                break
        return x

    def begin(self, place: np.ndarray, near: np.ndarray | None) -> np.ndarray:
        """Joints near those of the start; without a stated posture those least turned, within their limits if any."""
        if near is not None:
            return near
        found = [self.posture(place, x) for x in (np.zeros(len(self.limits)), *self.drawn)]
        sound = [x for x in found if not self.fault(place, x)]
        within = [x for x in sound if (self.limits.T[0] <= x).all() and (x <= self.limits.T[1]).all()]
        nearest = min(found, key=lambda x: float(np.linalg.norm(self.at(x)[0] - place)))
        return min(within or sound, key=lambda x: float(np.linalg.norm(x)), default=nearest)

    def fault(self, place: np.ndarray, joints: np.ndarray) -> str:
        """Why the tip cannot be moved along from a place at which the joints should have it; empty if it can."""
        there, J = self.at(joints)
        at, sizes = f"({', '.join(f'{c:.4g}' for c in place)}) m", np.linalg.svd(J, compute_uv=False)
        off = float(np.linalg.norm(there - place))
        if off > AMISS * self.length:
            return f"{at} is out of reach, by {off:.3g} m; give a path that the joints can follow"
        if sizes[self.directions - 1] < FLAT * max(sizes[0], self.length):
            return f"at {at} the joints cannot move the tip in {self.directions} directions; keep away from there"
        return ""


def _check_cut(joints: np.ndarray, played: slice, preview: float) -> None:
    """Refuse a preview that leaves out more than `CUT` of the motion."""
    way = np.ptp(joints, axis=0).max()
    for outside, what in ((joints[: played.start + 1], "begins"), (joints[played.stop - 1 :], "ends")):
        left = np.ptp(outside, axis=0).max()
        if left > CUT * way:
            said = f"preview: {preview:g} s leaves out {left:.2g} rad of the motion, which {what} earlier or later"
            raise UsageError(f"{said}; take a longer one, or a path that begins and ends more smoothly")


def check_limits(what: str, q: np.ndarray, tau: np.ndarray, limits: MotionLimits, names: Sequence[str]) -> None:
    """Refuse a motion that leaves the ranges of joints, or takes more than their drives have."""
    for j, name in enumerate(names):
        low, high, effort = q[:, j].min(), q[:, j].max(), np.abs(tau[:, j]).max()
        if low < limits.lower[j] or high > limits.upper[j]:
            said = (
                f"{name} goes from {low:.4g} to {high:.4g}; its limits are {limits.lower[j]:g} and {limits.upper[j]:g}"
            )
            raise UsageError(f"{what}: {said}; give another motion")
        if effort > limits.efforts[j]:
            raise UsageError(
                f"{what}: it takes {effort:.4g} of {name}, whose limit is {limits.efforts[j]:.4g}; take more time"
            )
