"""The fastest motions under the torque limits: the plan that the MPC follows, and what no controller can beat."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np
from scipy.interpolate import CubicSpline

from .arms import LIMIT
from .attempt import attempt
from .ocp import DEGREE, Dynamics

SHARE = 0.97
"""Of the torque limits, for the plan: the rest is what the feedback has to work with."""
SMOOTH = 0.05
"""s: weight of the squared steps of torque over the limit, beside ten times the duration, in the plan."""
BARELY = 1e-3
"""The same in the bounds, where it only makes the solution unique."""
AFTER, LATER = 0.3, 15
"""s, intervals: of the bound's motion inside the band, until it rests."""


@dataclass(frozen=True)
class Plan:
    """A motion from rest to rest."""

    duration: float
    """s"""
    x: np.ndarray
    """(N + 1, nx): at the intervals' ends."""
    u: np.ndarray
    """(N, 3) N·m: held over the intervals."""
    hold: np.ndarray
    """(3,) N·m: at the end, and from then on."""
    converged: bool
    iterations: int
    seconds: float
    """Of one core."""

    @cached_property
    def spline(self) -> CubicSpline:
        return CubicSpline(np.linspace(0, self.duration, len(self.x)), self.x)

    @cached_property
    def impulse(self) -> tuple[np.ndarray, np.ndarray]:
        """Times and integrals of the torques (…, 3), the rest after the end included."""
        t = np.append(np.linspace(0, self.duration, len(self.x)), self.duration + 100.0)
        return t, np.cumsum(np.vstack([np.zeros(3), np.diff(t)[:, None] * np.vstack([self.u, self.hold])]), axis=0)

    def states(self, t) -> np.ndarray:
        """(…, nx) at these times; after the end the rest."""
        return self.spline(np.minimum(t, self.duration))

    def torques(self, t, h: float) -> np.ndarray:
        """(…, 3) N·m: mean from t to t + h."""
        at, total = self.impulse
        there = lambda t: np.stack([np.interp(t, at, column) for column in total.T], axis=-1)  # noqa: E731
        return (there(np.asarray(t) + h) - there(t)) / h


def fastest(
    dynamics: Dynamics,
    ends: list[tuple[np.ndarray, np.ndarray]],
    extra: float,
    N: int,
    share: float = 1.0,
    smooth: float = BARELY,
    band: float | None = None,
) -> Plan:
    """The motion that takes least time between two rests (state, torques), its torques within `share` of the limits.

    With a `band` (m): that enters it first, for good, and rests `AFTER` seconds later; the duration is that until it
    enters. Free end time, collocation, IPOPT with exact derivatives.
    """
    (start, first), (end, last) = ends
    later, size, o = LATER if band else 0, dynamics.size, ca.Opti()
    M = N + later
    T, X, U = o.variable(), [o.variable(dynamics.nx) for _ in range(M + 1)], [o.variable(3) for _ in range(M)]
    inner = [o.variable(dynamics.nx, DEGREE) for _ in range(M)]
    lengths = ca.horzcat(*[T / N] * N, *[AFTER / LATER] * later)
    defects = dynamics.defects().map(M)(ca.hcat(X[:-1]), ca.hcat(inner), ca.hcat(U), np.full((1, M), extra), lengths)
    o.subject_to(ca.vec(defects) == 0)
    o.subject_to(X[0] == start / size)
    o.subject_to(X[M] == end / size)
    o.subject_to(o.bounded(0.2, T, 2.0))
    goal = dynamics.tip(end, extra)
    for k in range(M):
        o.subject_to(X[k + 1] == inner[k][:, -1])
        o.subject_to(o.bounded(-share, U[k], share))
        for x in (X[k], inner[k][:, 0]) if k >= N else ():
            o.subject_to(ca.sumsqr((dynamics.tip(x * size, extra) - goal) / band) <= 1)
    steps = [b - a for a, b in zip((first / LIMIT, *U), (*U, last / LIMIT), strict=True)]
    o.minimize(10 * T + smooth * sum(map(ca.sumsqr, steps)))
    line = lambda k, a, b: a + min(k / N, 1.0) * (b - a)  # noqa: E731
    o.set_initial(T, 0.65)
    for k in range(M + 1):
        o.set_initial(X[k], line(k, start, end) / size)
    for k in range(M):
        o.set_initial(inner[k], np.tile((line(k, start, end) / size)[:, None], DEGREE))
        o.set_initial(U[k], line(k, first, last) / LIMIT)
    return _solved(o, T, X, U, size, last)


def _solved(o: ca.Opti, T, X, U, size, hold) -> Plan:
    o.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes", "max_iter": 400, "tol": 1e-6})
    value, converged, count, seconds = attempt(o)
    x, u = (np.array([value(a) for a in part]) for part in (X, U))
    return Plan(float(value(T)), x * size, u * LIMIT, hold, converged, count, seconds)
