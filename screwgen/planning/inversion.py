"""Joint motions whose tip is where a path is: equations of all samples at once, solved by Newton's method.

Bending answers to a tip that is told where to be before the tip moves and after it has stopped: seen from the tip the
arm is not minimum-phase, so no integration forward in time is stable. Here a window of time is taken as a whole. At
its ends everything rests, so it goes on evenly to either side, and derivatives are those of its cosine series. The
linear equations of an iteration are solved by GMRES, with what solves them where the posture does not change: for each
cosine by itself.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca
import numpy as np

from ..errors import UsageError
from .members import Still

CLOSE, STALLED, ROUNDS = 1e-10, 1e-6, 15
"""The largest residual, by how far the joints go, at which the search ends; that at which it also ends if the last step
has not halved it, as where modes have no damping; and the most steps. An example: joints that go 0.4 rad end with
residuals of 4e-11, or of 4e-7 where no step makes them less.
"""
IMMOBILE = 1e-4
"""Joints do not move the tip in a direction where they do so by less than this share of that in which they move it
most."""
FORCING, RESTART, CYCLES = 1e-8, 80, 6
"""How well the linear equations are solved."""


@dataclass(frozen=True)
class Window:
    """Samples of a time in which everything rests at both ends."""

    count: int
    step: float

    def derivatives(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """First and second derivatives of rows at samples (count, …)."""
        series = np.fft.rfft(np.concatenate([x, x[-2:0:-1]]), axis=0)
        w = self.rates.reshape(-1, *[1] * (x.ndim - 1))
        size = 2 * self.count - 2
        first, second = (np.fft.irfft(part, size, axis=0)[: self.count] for part in (1j * w * series, -(w**2) * series))
        return first, second

    @property
    def rates(self) -> np.ndarray:
        """Angular frequencies of the cosines, rad/s."""
        return np.pi * np.arange(self.count) / ((self.count - 1) * self.step)

    def by_cosine(self, x: np.ndarray, inverse: np.ndarray) -> np.ndarray:
        """Rows (count, n), of which each cosine is multiplied by a matrix of its own (count, n, n)."""
        series = np.fft.rfft(np.concatenate([x, x[-2:0:-1]]), axis=0)
        return np.fft.irfft(np.einsum("wij,wj->wi", inverse, series), 2 * self.count - 2, axis=0)[: self.count]


@dataclass(frozen=True)
class SampleSlopes:
    """Derivatives of the equations of every sample by coordinates, rates and accelerations, (count, n, n) each."""

    q: np.ndarray
    v: np.ndarray
    a: np.ndarray


class TipEquations:
    """What has to vanish at every sample: unbalanced forces of modes, and how far the tip is from a path.

    The distance is that in the directions in which joints move the tip of an arm that does not bend, in terms of the
    joints; forces are in terms of the modes that they would hold. `goal` (count, 3), m: the path; `joints`
    (count, m): those of the arm that does not bend, which those of the bent arm are in directions that leave the tip.
    """

    def __init__(self, still: Still, tip: ca.Function, goal: np.ndarray, joints: np.ndarray):
        self.still, self.tip, self.goal, self.m = still, tip, goal, still.joints
        self.count, n = len(goal), still.residual.size1_in(0)
        at_rest = np.hstack([joints, np.zeros((self.count, n - self.m))])
        J = self._slopes_of(_slope(tip, self.m), at_rest)
        self.joints, self.to_joints = joints, np.linalg.pinv(J, rcond=IMMOBILE)
        self.redundant = np.eye(self.m) - self.to_joints @ J
        q, v, a = (ca.SX.sym(name, n) for name in "qva")
        force = still.residual(q, v, a)[self.m :]
        parts = [ca.jacobian(force, x) for x in (q, v, a)]
        self.force_slopes = ca.Function("slopes", [q, v, a], parts)
        self.tip_slope = _slope(tip, n)
        stiffness = np.abs(np.diag(np.array(still.statics(at_rest[0])[1])))[self.m :]
        self.scale = 1.0 / np.append(np.ones(self.m), stiffness)

    def residual(self, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> np.ndarray:
        """(count, n): first the tip's, then the modes'."""
        force = self._mapped(self.still.residual, q.T, v.T, a.T).T[:, self.m :]
        tips = np.einsum("kij,kj->ki", self.to_joints, self.off(q))
        others = np.einsum("kij,kj->ki", self.redundant, q[:, : self.m] - self.joints)
        return self.scale * np.hstack([tips + others, force])

    def off(self, q: np.ndarray) -> np.ndarray:
        """(count, 3), m: from the path to the tip."""
        return self._mapped(self.tip, q.T).T - self.goal

    def slopes(self, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> SampleSlopes:
        """The derivatives of the residual."""
        n, modes = q.shape[1], q.shape[1] - self.m
        forces = self.force_slopes.map(self.count)(q.T, v.T, a.T)
        by = [np.array(x).reshape(modes, self.count, n).transpose(1, 0, 2) for x in forces]
        J = self._slopes_of(self.tip_slope, q)
        tips = self.to_joints @ J
        tips[:, :, : self.m] += self.redundant
        rows = [tips, *[np.zeros((self.count, self.m, n))] * 2]
        return SampleSlopes(*(self.scale[:, None] * np.concatenate(x, axis=1) for x in zip(rows, by, strict=True)))

    def _mapped(self, function: ca.Function, *columns: np.ndarray) -> np.ndarray:
        """A function of columns at every sample, (rows, count)."""
        return np.array(function.map(self.count)(*columns))

    def _slopes_of(self, slope: ca.Function, q: np.ndarray) -> np.ndarray:
        """Derivatives of the tip's place at every sample, (count, 3, columns)."""
        return self._mapped(slope, q.T).T.reshape(self.count, -1, 3).transpose(0, 2, 1)


def _slope(tip: ca.Function, count: int) -> ca.Function:
    """The derivatives of the tip's place by the first coordinates."""
    q = ca.SX.sym("q", tip.size1_in(0))
    return ca.Function("slope", [q], [ca.densify(ca.jacobian(tip(q), q)[:, :count])])


def inverted(
    equations: TipEquations, window: Window, start: np.ndarray, progress: Callable[[int, int], None] | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
    """Coordinates, rates and accelerations (count, n) at samples, and iterations, from a first guess of coordinates.

    Raises UsageError where the iteration does not converge.
    """
    from scipy.sparse.linalg import LinearOperator, gmres

    q, shape = start, start.shape
    size, before = 1e-3 + np.ptp(start, axis=0).max(), np.inf
    for done in range(ROUNDS + 1):
        v, a = window.derivatives(q)
        off = equations.residual(q, v, a)
        worst = np.abs(off).max()
        if progress is not None:
            progress(done, ROUNDS)
        if worst <= CLOSE * size or before / 2 < worst <= STALLED * size:
            return q, v, a, done
        before = worst
        if not worst < 1e3 * size:
            break
        slopes = equations.slopes(q, v, a)
        inverse = _inverse(slopes, window)

        def change(x: np.ndarray, inverse: np.ndarray = inverse) -> np.ndarray:
            return window.by_cosine(x.reshape(shape), inverse)

        def product(x: np.ndarray, slopes: SampleSlopes = slopes) -> np.ndarray:
            dq = change(x)
            dv, da = window.derivatives(dq)
            parts = ((slopes.q, dq), (slopes.v, dv), (slopes.a, da))
            return sum(np.einsum("kij,kj->ki", S, d) for S, d in parts).ravel()

        operator = LinearOperator((q.size, q.size), matvec=product, dtype=float)
        step, _ = gmres(operator, -off.ravel(), rtol=FORCING, atol=0.0, restart=RESTART, maxiter=CYCLES)
        q = q + change(step)
    raise UsageError("no motion was found whose tip is on the path; take a slower or smoother one, or fewer modes")


def _inverse(slopes: SampleSlopes, window: Window) -> np.ndarray:
    """(count, n, n): of every cosine what solves the equations with slopes that are the same at all samples."""
    q, a = slopes.q.mean(axis=0), slopes.a.mean(axis=0)
    return np.linalg.inv(q - window.rates[:, None, None] ** 2 * a)
