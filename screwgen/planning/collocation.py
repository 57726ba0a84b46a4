"""A motion between two rests as a nonlinear programme: direct collocation on the residuals of inverse dynamics.

Every interval has three points, its ends and its middle. Rates and coordinates follow from the accelerations at these
by the Lobatto rule of order 4 (IIIA), which bears oscillations much faster than an interval. Efforts of drives are
linear over an interval. Several models share the motion of the first: what another one's joints lag behind, the joint
law corrects.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from .between import Curve, place
from .members import PlannedModel
from .task import Task

INNER, OUTER = np.array([5, 8, -1]) / 24, np.array([1, 4, 1]) / 6
"""Weights of the Lobatto rule: the integral over the first half of an interval and over the whole, in intervals."""
Vector = Any
"""A column of CasADi expressions."""


@dataclass
class Programme:
    """Unknowns with bounds and first guesses, and constraints with bounds, as they are added."""

    unknowns: list[Vector] = field(default_factory=list)
    constraints: list[Vector] = field(default_factory=list)
    cost: Vector = 0.0
    start: list[np.ndarray] = field(default_factory=list)
    bounds: list[tuple[np.ndarray, np.ndarray]] = field(default_factory=list)
    ranges: list[tuple[np.ndarray, np.ndarray]] = field(default_factory=list)

    def unknown(self, name: str, guess: np.ndarray, most: np.ndarray, least: np.ndarray) -> Vector:
        """A matrix of unknowns with the shape of its first guess."""
        made = ca.MX.sym(name, *guess.shape)
        self.unknowns.append(ca.vec(made))
        self.start.append(guess.ravel(order="F"))
        wide = [np.broadcast_to(x, guess.shape).ravel(order="F") for x in (least, most)]
        self.bounds.append((wide[0], wide[1]))
        return made

    def zero(self, expression: Vector) -> None:
        """Ask that an expression is zero."""
        self.within(expression, np.zeros(expression.shape), np.zeros(expression.shape))

    def within(self, expression: Vector, least: np.ndarray, most: np.ndarray) -> None:
        """Ask that an expression keeps bounds of its shape."""
        self.constraints.append(ca.vec(expression))
        wide = [np.broadcast_to(x, expression.shape).ravel(order="F") for x in (least, most)]
        self.ranges.append((wide[0], wide[1]))

    def problem(self) -> dict[str, Vector]:
        """What `casadi.nlpsol` takes."""
        return {"x": ca.vertcat(*self.unknowns), "f": self.cost, "g": ca.vertcat(*self.constraints)}

    def numbers(self) -> dict[str, np.ndarray]:
        """What the solver is called with."""
        lower, upper = (np.concatenate([b[i] for b in self.bounds]) for i in (0, 1))
        least, most = (np.concatenate([b[i] for b in self.ranges]) for i in (0, 1))
        return {"x0": np.concatenate(self.start), "lbx": lower, "ubx": upper, "lbg": least, "ubg": most}


@dataclass(frozen=True)
class Trajectory:
    """Coordinates, rates and accelerations (n, points) of one model, at ends and middles of intervals in turn."""

    q: Any
    v: Any
    a: Any

    def joints(self, count: int) -> Trajectory:
        """The part of the joints."""
        return Trajectory(self.q[:count, :], self.v[:count, :], self.a[:count, :])


@dataclass
class Transcription:
    """The programme of a task over models, and where in its unknowns the motions and the efforts are."""

    programme: Programme
    motions: list[Trajectory]
    efforts: Any
    unpack: ca.Function

    def values(self, x: np.ndarray) -> tuple[list[Trajectory], np.ndarray]:
        """The motions and the efforts (n_joints, intervals + 1) of a solution."""
        found = [np.array(part) for part in self.unpack(x)]
        return [Trajectory(*found[i : i + 3]) for i in range(0, len(found) - 1, 3)], found[-1]


def transcribed(
    task: Task, members: Sequence[PlannedModel], guesses: Sequence[Trajectory], guessed: np.ndarray
) -> Transcription:
    """The programme of a task for models of which the first one is the one that is planned for."""
    made, N, m = Programme(), task.intervals, len(task.start)
    limits = task.limits.efforts
    ends = [members[0].start.effort, members[0].goal.effort]
    most, least = (np.repeat(s * limits[:, None], N + 1, axis=1) for s in (1.0, -1.0))
    for bound in (most, least):
        bound[:, 0], bound[:, -1] = ends
    efforts = made.unknown("efforts", guessed, most, least)
    everywhere = at_points(efforts, N)
    motions = [
        _motion(made, task, member, guess, i) for i, (member, guess) in enumerate(zip(members, guesses, strict=True))
    ]
    first = motions[0].joints(m)
    for point in task.through:
        made.zero(_passed(first, point.share, task.time)[0] - ca.DM(point.joints))
    for i, (member, motion) in enumerate(zip(members, motions, strict=True)):
        levers = member.still.levers.map(2 * N + 1)(motion.q)
        torques = levers * everywhere
        if i:
            own = motion.joints(m)
            added = task.law.torques(first.q - own.q, first.v - own.v)
            torques += added
            if np.isfinite(limits).any():
                limited = np.flatnonzero(np.isfinite(limits)).tolist()
                applied = everywhere + added / levers
                made.within(applied[limited, 1:-1], -limits[limited, None], limits[limited, None])
        residual = member.still.residual.map(2 * N + 1)(motion.q, motion.v, motion.a)
        made.zero((residual[:m, :] - torques) / member.force_scale)
        made.zero(residual[m:, :] / member.force_scale)
        _bounded_loads(made, task, member, motion)
        _bounded_between(made, task, member, motion)
    steps = efforts[:, 1:] - efforts[:, :-1]
    _each_within(made, steps * (N / task.time), task.limits.effort_rates)
    made.cost += ca.sumsqr(steps / ca.DM(task.effort_scales)) * N
    parts = [x for motion in motions for x in (motion.q, motion.v, motion.a)]
    unpack = ca.Function("unpack", [ca.vertcat(*made.unknowns)], _sorted(made, parts, efforts))
    return Transcription(made, motions, efforts, unpack)


def _passed(motion: Trajectory, share: float, time: float) -> tuple[Vector, Vector]:
    """Coordinates and rates at a share of the time, on the polynomials of order 5 between points."""
    points = motion.q.shape[1]
    return Curve(motion.q, motion.v, motion.a, time / (points - 1)).at(*place(share, points))


def _bounded_between(made: Programme, task: Task, member: PlannedModel, motion: Trajectory) -> None:
    """Ask that joints and strains keep their limits at the shares of the time that are named, too."""
    limits, m = task.limits, len(task.start)
    if not task.between:
        return
    q, v = (ca.horzcat(*x) for x in zip(*(_passed(motion, share, task.time) for share in task.between), strict=True))
    _each_within(made, v[:m, :], limits.rates)
    for sign, most in ((1.0, limits.upper), (-1.0, -limits.lower)):
        limited = np.flatnonzero(np.isfinite(most)).tolist()
        if limited:
            most = most[limited, None]
            made.within(sign * q[limited, :], np.full_like(most, -np.inf), most)
    if np.isfinite(limits.strains).any():
        _each_within(made, member.still.strains.map(len(task.between))(q), limits.strains)


def _bounded_loads(made: Programme, task: Task, member: PlannedModel, motion: Trajectory) -> None:
    """Ask that strains and joint wrenches keep their limits at all points."""
    points, limits = motion.q.shape[1], task.limits
    if np.isfinite(limits.strains).any():
        _each_within(made, member.still.strains.map(points)(motion.q), limits.strains)
    if np.isfinite(limits.wrenches).any():
        _each_within(made, member.still.wrenches.map(points)(motion.q, motion.v, motion.a), limits.wrenches)


def _each_within(made: Programme, rows: Vector, most: np.ndarray) -> None:
    """Ask that rows stay within their bounds of either sign, those that have one."""
    limited = np.flatnonzero(np.isfinite(most)).tolist()
    if limited:
        ones = np.ones((len(limited), 1))
        made.within(rows[limited, :] / ca.DM(most[limited]), -ones, ones)


def _sorted(made: Programme, parts: Sequence[Vector], efforts: Vector) -> list[Vector]:
    """Motions and efforts as functions of all unknowns in one column."""
    return [*parts, efforts]


def at_points(efforts: Any, N: int) -> Any:
    """Efforts at the ends and middles of intervals, of those at the ends."""
    spread = np.zeros((N + 1, 2 * N + 1))
    for k in range(N + 1):
        spread[k, 2 * k] = 1.0
    for k in range(N):
        spread[k : k + 2, 2 * k + 1] = 0.5
    return efforts @ ca.DM(spread) if isinstance(efforts, ca.MX) else efforts @ spread


def _motion(made: Programme, task: Task, member: PlannedModel, guess: Trajectory, i: int) -> Trajectory:
    """The unknown motion of a model, from its rest at the start to what counts as rest at the goal."""
    m, N, h = len(task.start), task.intervals, task.time / task.intervals
    n, limits = len(member.start.q), task.limits
    free = np.full((n, 2 * N + 1), np.inf)
    q_most, q_least, v_most = free.copy(), -free, free.copy()
    q_most[:m, 1:-1], q_least[:m, 1:-1] = limits.upper[:, None], limits.lower[:, None]
    if not i:
        q_most[:m, -1] = q_least[:m, -1] = member.goal.q[:m]
        v_most[:m, -1] = 0.0
    v_most[:m, 1:-1] = limits.rates[:, None]
    v_least = -v_most
    q_most[:, 0] = q_least[:, 0] = member.start.q
    v_most[:, 0] = v_least[:, 0] = 0.0
    q = made.unknown(f"q{i}", guess.q, q_most, q_least)
    v = made.unknown(f"v{i}", guess.v, v_most, v_least)
    a = made.unknown(f"a{i}", guess.a, free, -free)
    for whole, slope in ((q, v), (v, a)):
        before, middle, after = (slope[:, s] for s in (slice(0, -2, 2), slice(1, None, 2), slice(2, None, 2)))
        for weights, columns in ((INNER, slice(1, None, 2)), (OUTER, slice(2, None, 2))):
            share = weights[0] * before + weights[1] * middle + weights[2] * after
            made.zero(whole[:, columns] - whole[:, slice(0, -2, 2)] - h * share)
    left = ca.vertcat(q[:, -1] - ca.DM(member.goal.q), v[:, -1])
    made.cost += task.weight / task.energy_scale * ca.bilin(ca.DM(member.energy), left, left)
    return Trajectory(q, v, a)
