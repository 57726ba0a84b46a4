"""The search for a plan: the programme of a task, first guesses, and the solver."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import casadi as ca
import numpy as np

from .between import broken
from .collocation import Trajectory, at_points, transcribed
from .members import PlannedModel
from .task import Task

MOST = 80
"""Iterations; a plan that there is takes a dozen or two."""
PRECISION, PIVOTS, ORDERING = 1e-6, 1e-2, 4
"""The solver's tolerance, and the least pivots of its factors: smaller ones leave wrong signs of curvature. The
ordering of MUMPS is that by PORD: a plan for three models takes a quarter of the time of that which it chooses itself.
"""
LEFT, MOST_STRICT = 2e-5, 1e9
"""What may be left of the energy of a motion, and the largest weight of it."""
ROUNDS = 5
"""How often a motion is sought again for limits that it passes between its points; it is unsound if it still does."""
INTERRUPTED = ("User_Requested_Stop", "NonIpopt_Exception_Thrown")
"""What the solver says where a signal has ended it, in a callback or between; it keeps the exception to itself."""
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class Found:
    """The motions of all models and the efforts (n_joints, intervals + 1 or points), and how the search went."""

    motions: list[Trajectory]
    efforts: np.ndarray
    time: float
    iterations: int
    cost: float
    left: float
    """What the first model has left to vibrate with at the end, over the energy of the motion."""
    sound: bool
    """Whether everything that was asked for holds."""

    @property
    def efforts_at_points(self) -> np.ndarray:
        """(n_joints, points): efforts at the ends and middles of intervals."""
        points = self.motions[0].q.shape[1]
        return self.efforts if self.efforts.shape[1] == points else at_points(self.efforts, points // 2)

    def within(self, time: float) -> Found:
        """The same motions in another time, as a first guess."""
        s = self.time / time
        motions = [Trajectory(x.q, s * x.v, s * s * x.a) for x in self.motions]
        return Found(motions, self.efforts, time, 0, self.cost, np.inf, False)


def solve(
    task: Task,
    members: Sequence[PlannedModel],
    near: Found | None = None,
    progress: Progress | None = None,
    exact: bool = False,
) -> Found:
    """The plan of a task, sought from one nearby on, or from joints of least jerk.

    `exact`: with the curvature of constraints too, which takes longer; it is what ends where much remains at the end.
    """
    near = (near or guess(task, members[0])).within(task.time)
    motions = [*near.motions, *(_beside(near, members[0], x) for x in members[len(near.motions) :])]
    made = transcribed(task, members, motions[: len(members)], near.efforts)
    options: dict[str, Any] = {
        "print_time": False,
        "ipopt": {"print_level": 0, "sb": "yes", "max_iter": MOST, "tol": PRECISION}
        | {"mumps_pivtol": PIVOTS, "mumps_pivot_order": ORDERING},
    }
    problem, numbers = made.programme.problem(), made.programme.numbers()
    if not exact:
        options["hess_lag"] = curvature(problem)
    if progress is not None:
        options["iteration_callback"] = counter = Counter(problem, progress)
    solver = ca.nlpsol("plan", "ipopt", problem, options)
    result = solver(**numbers)
    stats = solver.stats()
    if stats["return_status"] in INTERRUPTED:
        raise KeyboardInterrupt
    if progress is not None:
        counter.end()
    found, efforts = made.values(result["x"])
    converged = stats["return_status"] in ("Solve_Succeeded", "Solved_To_Acceptable_Level")
    end = np.append(found[0].q[:, -1] - members[0].goal.q, found[0].v[:, -1])
    left = float(end @ members[0].energy @ end / task.energy_scale)
    there = Found(found, efforts, task.time, int(stats["iter_count"]), float(result["f"]), left, False)
    if not (converged or exact):
        again = solve(task, members, there, progress, exact=True)
        return replace(again, iterations=again.iterations + there.iterations)
    sound = converged and (len(members) > 1 or left <= LEFT)
    if converged and not sound and task.weight < MOST_STRICT:
        again = solve(task.stricter(), members, there, progress, exact)
        return replace(again, iterations=again.iterations + there.iterations)
    if sound and (shares := broken(task, members, found)):
        if task.rounds == ROUNDS:
            return there
        again = solve(task.also_at(shares), members, there, progress, exact)
        return replace(again, iterations=again.iterations + there.iterations)
    return replace(there, sound=sound)


def curvature(problem: dict[str, ca.MX]) -> ca.Function:
    """The second derivatives of the cost, without those of constraints, so that no step ever has to be damped."""
    x, p, weight, multipliers = (
        ca.MX.sym(name, size)
        for name, size in zip("xpwm", (problem["x"].numel(), 0, 1, problem["g"].numel()), strict=True)
    )
    cost = ca.Function("cost", [problem["x"]], [problem["f"]])
    upper = ca.triu(weight * ca.hessian(cost(x), x)[0])
    names = ["x", "p", "lam_f", "lam_g"], ["triu_hess_gamma_x_x"]
    return ca.Function("curvature", [x, p, weight, multipliers], [upper], *names)


def guess(task: Task, member: PlannedModel) -> Found:
    """Coordinates that go from rest to rest along paths of least jerk, and efforts that go evenly."""
    s, N, T = np.linspace(0.0, 1.0, 2 * task.intervals + 1), task.intervals, task.time
    motion = _spline(task, member, s) if task.through else _least_jerk(member.start.q, member.goal.q, s, T)
    ends = (member.goal.effort - member.start.effort)[:, None]
    efforts = member.start.effort[:, None] + ends * np.linspace(0.0, 1.0, N + 1)
    return Found([motion], efforts, T, 0, np.inf, np.inf, False)


def _least_jerk(start: np.ndarray, goal: np.ndarray, s: np.ndarray, T: float) -> Trajectory:
    """From rest to rest at shares of the time."""
    way = (goal - start)[:, None]
    place, rate = s**3 * (10 - 15 * s + 6 * s**2), 30 * (s * (1 - s)) ** 2 / T
    return Trajectory(start[:, None] + way * place, way * rate, way * (60 * s - 180 * s**2 + 120 * s**3) / T**2)


def _spline(task: Task, member: PlannedModel, s: np.ndarray) -> Trajectory:
    """Joints on a cubic spline through the waypoints, the others evenly from rest to rest."""
    from scipy.interpolate import CubicSpline

    when = [0.0, *(x.share for x in task.through), 1.0]
    q = np.array([member.start.q + share * (member.goal.q - member.start.q) for share in when])
    for row, point in zip(q[1:-1], task.through, strict=True):
        row[: len(task.start)] = point.joints
    path, T = CubicSpline(when, q, bc_type="clamped"), task.time
    return Trajectory(path(s).T, path(s, 1).T / T, path(s, 2).T / T**2)


def _beside(near: Found, first: PlannedModel, other: PlannedModel) -> Trajectory:
    """The motion of the first model, moved to the rests of another one."""
    motion = near.motions[0]
    s = np.linspace(0.0, 1.0, motion.q.shape[1])
    before, after = (x - y for x, y in ((other.start.q, first.start.q), (other.goal.q, first.goal.q)))
    return Trajectory(motion.q + before[:, None] * (1 - s) + after[:, None] * s, motion.v, motion.a)


class Counter(ca.Callback):
    """Tells of every iteration."""

    def __init__(self, problem: dict[str, ca.MX], progress: Progress):
        super().__init__()
        self.sizes = [problem["x"].numel(), 1, problem["g"].numel(), problem["x"].numel(), problem["g"].numel(), 0]
        self.progress, self.count = progress, 0
        self.construct("counter", {})

    def get_n_in(self) -> int:
        return ca.nlpsol_n_out()

    def get_n_out(self) -> int:
        return 1

    def get_name_in(self, i: int) -> str:
        return ca.nlpsol_out(i)

    def get_sparsity_in(self, i: int) -> ca.Sparsity:
        return ca.Sparsity.dense(self.sizes[i], 1) if self.sizes[i] else ca.Sparsity(0, 0)

    def eval(self, arguments: Sequence[ca.DM]) -> list[int]:
        self.count += 1
        self.progress(min(self.count, MOST - 1), MOST)
        return [0]

    def end(self) -> None:
        """The search is over."""
        self.progress(MOST, MOST)
