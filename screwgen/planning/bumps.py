"""Plans without a nonlinear programme: joints of least jerk plus polynomials, found by least squares.

The polynomials ("bumps") begin and end at rest, so whatever their coefficients are joints arrive. What modes do under
such joints, and further models under the joint law, follows from the residuals of inverse dynamics over intervals with
the rule of :mod:`collocation`. An iteration linearises these about the latest motions, so that all of them follow from
the coefficients, and takes the coefficients with the least cost: that of the collocation, without its limits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from ..lazily import linalg
from .collocation import INNER, OUTER, Trajectory
from .members import PlannedModel
from .solve import LEFT, Found, Progress
from .task import WEIGHT, Task

COUNT = 16
"""Polynomials of each joint: more of them bear more modes, and bend the torques more."""
FINER = 4
"""Steps in an interval of the search with limits: torques are told at their ends and middles."""
MOST, SETTLED = 40, 1e-6
"""Iterations that change coefficients, and the largest change of a coordinate at which these are good enough."""
SHORTER, LONGER, ENOUGH = 0.25, 1.5, 0.99
"""Of a step that raised the cost what is tried next, and of one that did not; of the cost what counts as no less then.

Where joints turn back friction changes with the rate, of which slopes know nothing: whole steps go too far there.
"""
HELD, CLOSE = 8, 1e-9
"""Further ones, which only balance forces, and the largest unbalanced one, by the size of torques, at their end.

All coefficients are motions, so the least cost need not be met to all digits; the equations of motion must be.
"""


@dataclass(frozen=True)
class Bumps:
    """Motions of the joints at points that are linear in coefficients (n_joints, K)."""

    path: Trajectory
    """(n_joints, points) each: that of all coefficients zero."""
    basis: np.ndarray
    """(3, K, points): coordinates, rates and accelerations of the polynomials."""

    def motion(self, c: np.ndarray) -> np.ndarray:
        """(3, n_joints, points): of coefficients (n_joints, K)."""
        return np.array([self.path.q, self.path.v, self.path.a]) + np.einsum("jk,dkp->djp", c, self.basis)


def bumps(task: Task) -> Bumps:
    """Paths of least jerk and polynomials of a task, through its waypoints."""
    s = np.linspace(0.0, 1.0, 2 * task.intervals + 1)
    shares = np.array([x.share for x in task.through])
    way = np.outer(task.goal - task.start, [0, 0, 0, 10, -15, 6])
    least = [np.polynomial.Polynomial(row) + x for row, x in zip(way, task.start, strict=True)]
    flat = np.polynomial.Polynomial([0, 0, 0, 1, -3, 3, -1])
    free = [
        flat * np.polynomial.Legendre.basis(k, [0, 1]).convert(kind=np.polynomial.Polynomial, domain=[-1, 1])
        for k in range(COUNT + len(shares))
    ]
    made = np.array([[x.deriv(d)(s) / task.time**d for x in free] for d in range(3)])
    path = np.array([[x.deriv(d)(s) / task.time**d for x in least] for d in range(3)])
    if len(shares):
        passed = np.array([x(shares) for x in free]).T
        off = np.array([x.joints for x in task.through]).T - np.array([x(shares) for x in least])
        path = path + np.einsum("jk,dkp->djp", off @ np.linalg.pinv(passed).T, made)
        made = np.einsum("kf,dkp->dfp", linalg.null_space(passed), made)
    return Bumps(Trajectory(*path), made)


@dataclass
class FollowedMotion:
    """The motion of a model (3, n, points), and its derivatives by all coefficients (3, n, points, n_joints K)."""

    motion: np.ndarray
    by_c: np.ndarray
    efforts: np.ndarray
    """(n_joints, points): of drives, where joints go as told."""
    efforts_by_c: np.ndarray
    off: float
    """The largest unbalanced force before the step, by the size of torques."""


class Responding:
    """One of the models of a plan as its joints, or their references and torques, are told to go."""

    def __init__(self, task: Task, member: PlannedModel, given: bool):
        """`given`: joints go as told; otherwise references and efforts are told, and the law does the rest."""
        self.task, self.member, self.given = task, member, given
        n, self.m = len(member.start.q), len(task.start)
        self.free = slice(self.m if given else 0, n)
        z, told = ([ca.SX.sym(name, size) for name in "qva"] for size in (n, self.m))
        force = self._efforts(*z) if given else self._unbalanced(z, told)
        slopes = [ca.densify(ca.jacobian(force, x)) for x in (*z, *told)]
        self.slopes = ca.Function("slopes", [*z, *told], [force, *slopes]).map(2 * task.intervals + 1)
        h = task.time / task.intervals
        self.rule = h * np.array([INNER, OUTER])

    def _efforts(self, q: ca.SX, v: ca.SX, a: ca.SX) -> ca.SX:
        """(n,): the efforts of drives, then forces that nothing bears."""
        force = self.member.still.residual(q, v, a)
        return ca.vertcat(force[: self.m] / self.member.still.levers(q), force[self.m :, :])

    def _unbalanced(self, z: Sequence[ca.SX], told: Sequence[ca.SX]) -> ca.SX:
        """(n,): forces less those of told efforts and of the law."""
        q, v, _ = z
        torques = self.task.law.torques(told[0] - q[: self.m], told[1] - v[: self.m])
        force = self.member.still.residual(*z)
        return ca.vertcat(force[: self.m] - self.member.still.levers(q) * told[2] - torques, force[self.m :, :])

    def follow(self, motion: np.ndarray, told: np.ndarray, told_by_c: np.ndarray) -> FollowedMotion:
        """A step of Newton's method from a motion (3, n, points), and how the result depends on coefficients.

        `told` (3, n_joints, points): coordinates, rates and accelerations of the joints, or of their references, then
        with the efforts in place of accelerations; `told_by_c` has one more axis, of coefficients.
        """
        n, m, free, points = motion.shape[1], self.m, self.free, motion.shape[2]
        if self.given:
            motion = motion.copy()
            motion[:, :m] = told
        force, *slopes = (np.array(x) for x in self.slopes(*motion, *told))
        F, by_told = (np.moveaxis(np.array(x).reshape(3, n, points, -1), 2, 1) for x in (slopes[:3], slopes[3:]))
        columns = np.zeros((points, n, 1 + told_by_c.shape[-1]))
        columns[:, :, 0] = -force.T
        columns[:, :, 1:] -= np.einsum("dpij,djpc->pic", F[..., :m] if self.given else by_told, told_by_c)
        change = np.zeros((3, n, points, columns.shape[2]))
        change[:, free] = self._integrated(F[:, :, free, free], columns[:, free], motion[:, free])
        if self.given:
            change[:, :m, :, 1:] = told_by_c
        by_change = np.einsum("dpij,djpc->ipc", F[:, :, :m], change)
        efforts = force[:m, :, None] * (np.arange(change.shape[-1]) == 0) + by_change
        off = float(np.abs(columns[:, free, 0]).max(initial=0.0) / self.task.force_scale)
        return FollowedMotion(motion + change[..., 0], change[..., 1:], efforts[..., 0], efforts[..., 1:], off)

    def _integrated(self, F: np.ndarray, columns: np.ndarray, motion: np.ndarray) -> np.ndarray:
        """Changes (3, f, points, C) of a motion (3, f, points), with derivatives `F` (3, points, f, f) of its forces.

        `columns` (points, f, C) are what the changes have to balance. The first column also mends what the motion
        misses of the rule.
        """
        f, points, C = F.shape[2], F.shape[1], columns.shape[2]
        out = np.zeros((3, f, points, C))
        A, first = self.rule[:, 1:], self.rule[:, 0]
        A2, size = A @ A, f * 2
        for k in range(0, points - 1, 2):
            at = slice(k + 1, k + 3)
            known = out[:, :, k]
            drift = np.empty((2, 2, f, C))  # coordinates and rates without the accelerations that are sought
            ahead = motion[:, :, at].transpose(0, 2, 1)
            gap_v, gap_q = (
                motion[d, :, k] + np.outer(first, motion[d + 1, :, k]) + A @ ahead[d + 1] - ahead[d] for d in (1, 0)
            )
            drift[1] = known[1] + first[:, None, None] * known[2]
            drift[1, ..., 0] += gap_v
            drift[0] = known[0] + first[:, None, None] * known[1] + np.einsum("ik,kfc->ifc", A, drift[1])
            drift[0, ..., 0] += gap_q
            right = columns[at] - F[0, at] @ drift[0] - F[1, at] @ drift[1]
            left = np.einsum("iab,ik->iakb", F[0, at], A2) + np.einsum("iab,ik->iakb", F[1, at], A)
            left[0, :, 0] += F[2, k + 1]
            left[1, :, 1] += F[2, k + 2]
            a = np.linalg.solve(left.reshape(size, size), right.reshape(size, C)).reshape(2, f, C) if f else right
            changed = (
                drift[0] + np.einsum("ik,kfc->ifc", A2, a),
                drift[1] + np.einsum("ik,kfc->ifc", A, a),
                a,
            )
            out[:, :, at] = np.array(changed).transpose(0, 2, 1, 3)
        return out


class LeastSquares:
    """The least squares whose unknowns are the coefficients, about the latest motions of all models."""

    def __init__(self, task: Task, members: Sequence[PlannedModel]):
        self.task, self.members = task, members
        self.shape = bumps(task)
        m, (K, points) = len(task.start), self.shape.basis.shape[1:]
        self.points, self.none = points, np.zeros((m, K))
        self.by_c = np.einsum("dkp,ij->dipjk", self.shape.basis, np.eye(m)).reshape(3, m, points, m * K)
        self.models = [Responding(task, x, not i) for i, x in enumerate(members)]
        self.roots = [_root(x.energy) / np.sqrt(task.energy_scale) for x in members]

    def begin(self) -> list[np.ndarray]:
        """Motions (3, n, points) of all models with all coefficients zero, from their rests to their rests."""
        task, s, out = self.task, np.linspace(0.0, 1.0, self.points), []
        straight = task.start[:, None] + np.outer(task.goal - task.start, s)
        for x in self.members:
            path = self.shape.motion(self.none)
            path[0] -= straight
            motion = np.concatenate([path, np.zeros((3, len(x.start.q) - len(task.start), self.points))], axis=1)
            motion[0] += x.start.q[:, None] + np.outer(x.goal.q - x.start.q, s)
            out.append(motion)
        return out

    def follow(self, motions: Sequence[np.ndarray], c: np.ndarray) -> list[FollowedMotion]:
        """The motions of coefficients (n_joints, K): of the first model, and what others make of its efforts."""
        told, by_c = self.shape.motion(c), self.by_c
        first = self.models[0].follow(motions[0], told, by_c)
        told, by_c = np.stack([*told[:2], first.efforts]), np.stack([*by_c[:2], first.efforts_by_c])
        others = zip(self.models[1:], motions[1:], strict=True)
        return [first, *(model.follow(motion, told, by_c) for model, motion in others)]

    def about(self, motions: Sequence[np.ndarray], c: np.ndarray) -> LinearCost:
        """Values whose squares are the cost, and their slopes, about motions of coefficients (n_joints, K)."""
        found = self.follow(motions, c)
        size, weight = np.sqrt(self.points - 1) / self.task.effort_scales[:, None], np.sqrt(self.task.weight)
        values = [(size * np.diff(found[0].efforts, axis=1)).ravel()]
        slopes = [(size[..., None] * np.diff(found[0].efforts_by_c, axis=1)).reshape(values[0].size, -1)]
        left = []
        for x, root, response in zip(self.members, self.roots, found, strict=True):
            end = np.append(response.motion[0, :, -1] - x.goal.q, response.motion[1, :, -1])
            left.append(root @ end)
            slopes.append(weight * root @ np.vstack([response.by_c[0, :, -1], response.by_c[1, :, -1]]))
        values += [weight * x for x in left]
        return LinearCost(c, found, np.concatenate(values), np.vstack(slopes), float(left[0] @ left[0]))


@dataclass
class LinearCost:
    """The least squares about the motions of some coefficients `c` (n_joints, K)."""

    c: np.ndarray
    found: list[FollowedMotion]
    values: np.ndarray
    slopes: np.ndarray
    left: float
    """The energy that the first model keeps."""

    @property
    def cost(self) -> float:
        return float(self.values @ self.values)

    @property
    def off(self) -> float:
        """The largest unbalanced force of all models."""
        return max(x.off for x in self.found)

    def step(self) -> tuple[np.ndarray, float]:
        """The change of coefficients (n_joints K,) to the least cost, and the most that it changes a coordinate."""
        step = np.linalg.lstsq(self.slopes, -self.values, rcond=None)[0]
        return step, max(np.abs(x.by_c[0] @ step).max() for x in self.found)

    def moved(self, step: np.ndarray) -> list[np.ndarray]:
        """The motions (3, n, points) of all models after a step."""
        return [x.motion + x.by_c @ step for x in self.found]


def fast(task: Task, members: Sequence[PlannedModel], progress: Progress | None = None) -> Found:
    """The motions of least cost of all models, with efforts (n_joints, points) at ends and middles of intervals.

    `sound` says that the search has ended and that nothing vibrates; limits are for the caller to check.
    """
    if len(members) == 1 and task.weight == WEIGHT:
        task = task.stricter()
    squares = LeastSquares(task, members)
    c, motions, efforts = squares.none, squares.begin(), np.zeros((len(task.start), squares.points))
    best, stride, far = None, np.inf, np.inf
    settled, converged, done = False, False, 0
    while done < MOST + HELD and not converged:
        moving, settled, done = not settled, settled or done >= MOST, done + 1
        if progress is not None:
            progress(done, MOST + HELD)
        now = squares.about(motions, c)
        if best and moving and not now.cost <= best.cost:
            stride = SHORTER * min(stride, far)
        else:
            if best and np.isfinite(stride) and now.left <= LEFT:
                settled = settled or now.cost > ENOUGH * best.cost
            best, stride = now, LONGER * stride
        step, far = (np.zeros(c.size), 0.0) if settled else best.step()
        step = step * min(1.0, stride / far) if far else step
        moved = best.moved(step)
        change = max(np.abs(new - old)[0].max() for new, old in zip(moved, motions, strict=True))
        if not np.isfinite(change):
            break
        c, motions = best.c + step.reshape(c.shape), moved
        efforts = best.found[0].efforts + best.found[0].efforts_by_c @ step
        converged = settled and best.off <= CLOSE
        settled = settled or change <= SETTLED
    if progress is not None:
        progress(MOST + HELD, MOST + HELD)
    cost, left = (best.cost, best.left) if best else (np.inf, np.inf)
    sound = converged and (len(members) > 1 or left <= LEFT)
    return Found([Trajectory(*x) for x in motions], efforts, task.time, done, cost, left, sound)


def _root(energy: np.ndarray) -> np.ndarray:
    """A matrix whose square is that of a nonnegative form."""
    sizes, vectors = np.linalg.eigh(energy)
    return np.sqrt(np.maximum(sizes, 0.0))[:, None] * vectors.T
