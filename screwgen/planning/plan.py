"""A plan: references of the joints and the torques that belong to them, between two rests."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ..arguments import seconds
from .hermite import coefficients

ARRAYS = ("t", "q", "v", "vdot", "tau", "kp", "kd", "tau_max")


class PlanWarning(UserWarning):
    """A plan that is played from another state than its own, or by another robot, or whose drives may give more than
    was planned; one line meant for a user.
    """


class Samples(NamedTuple):
    """What a clock plays, a row per sample, the last one that of the rest at the goal."""

    t: np.ndarray
    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    """The means of the torques from each sample to the next."""


@dataclass(frozen=True, eq=False, repr=False)
class MotionPlan:
    """A motion of the joints from rest to rest, with the torques that leave nothing vibrating at its end.

    P points: the ends and the middles of intervals. Between two of them joints move along the polynomial of order 5
    that has their coordinates, rates and accelerations; torques are linear over intervals, so over points too.
    Before the first point and behind the last one everything rests. SI units, radians. Of a joint behind an elastic
    gear all of it is said of the rotor: its coordinate over the ratio, its torque times the ratio. Of one with a
    transmission the torque is the effort along it, of a cylinder N; gains are those of the joint.
    """

    robot: str
    joints: tuple[str, ...]
    t: np.ndarray
    """(P,), s, evenly spaced."""
    q: np.ndarray
    """(P, n_joints): joint coordinates, rad, of slides m."""
    v: np.ndarray
    """(P, n_joints): their rates."""
    vdot: np.ndarray
    """(P, n_joints): their accelerations."""
    tau: np.ndarray
    """(P, n_joints): torques, N·m, of slides N."""
    kp: np.ndarray
    """(n_joints,): the gains under which it is played."""
    kd: np.ndarray
    tau_max: np.ndarray
    """(n_joints,): what the drives have; infinite where nothing limits them."""
    said: Mapping[str, Any] = field(default_factory=dict)
    """How it was found: iterations, seconds, cost; files do not store it."""

    @property
    def time(self) -> float:
        """How long the motion takes, s."""
        return float(self.t[-1])

    @property
    def effort(self) -> np.ndarray:
        """(n_joints,): the largest torques that are planned, of either sign."""
        return np.abs(self.tau).max(axis=0)

    def __repr__(self) -> str:
        count = f"{len(self.joints)} joint{'s' * (len(self.joints) != 1)}"
        return f"<MotionPlan of '{self.robot}': {count}, {self.time:.4g} s, torques up to {self.effort.max():.4g}>"

    def reference(self, t: Any) -> tuple[np.ndarray, np.ndarray]:
        """Joint coordinates and rates (…, n_joints) at times (…), s."""
        k, s = self._place(np.asarray(t, float))
        s, c, h = s[..., None], self.coefficients[k], self.time / (len(self.t) - 1)
        q, v = c[..., 5, :], np.zeros_like(c[..., 5, :])
        for power in range(4, -1, -1):
            q, v = q * s + c[..., power, :], v * s + (power + 1) * c[..., power + 1, :]
        return q, v / h

    @property
    def coefficients(self) -> np.ndarray:
        """(P − 1, 6, n_joints): of powers of the share of a stretch between two points."""
        if "_coefficients" not in self.__dict__:
            h = self.time / (len(self.t) - 1)
            q, v, a = self.q, h * self.v, h * h * self.vdot
            rows = coefficients(q[:-1], q[1:], v[:-1], v[1:], a[:-1], a[1:])
            self.__dict__["_coefficients"] = np.stack(rows, axis=1)
        return self.__dict__["_coefficients"]

    def mean_torque(self, begin: Any, end: Any) -> np.ndarray:
        """(…, n_joints): the means of the torques from times to later ones, s, which may lie outside of the motion.

        They are sums of parts with their shares, no differences of integrals: these lose digits over short steps.
        """
        begin, end = np.broadcast_arrays(np.asarray(begin, float), np.asarray(end, float))
        h, tau, (k, s), (k1, s1) = self.time / (len(self.t) - 1), self.tau, self._place(begin), self._place(end)
        alone, after = k == k1, np.minimum(k + 1, k1)
        sums = np.vstack([np.zeros(len(self.joints)), np.cumsum((tau[1:] + tau[:-1]) / 2, axis=0)])
        until = np.where(alone, s1, 1.0)
        lengths = np.stack(
            [
                np.minimum(end, 0.0) - np.minimum(begin, 0.0),
                h * (until - s),
                np.where(alone, 0.0, h * s1),
                np.maximum(end - self.time, 0.0) - np.maximum(begin - self.time, 0.0),
                h * (k1 - after),
            ]
        )
        shares = lengths / lengths.sum(axis=0)
        at = lambda k, s: tau[k] + (tau[k + 1] - tau[k]) * s[..., None]  # noqa: E731
        between = (sums[k1] - sums[after]) / np.maximum(k1 - after, 1)[..., None]
        parts = tau[0], at(k, (s + until) / 2), at(k1, s1 / 2), tau[-1], between
        return sum(share[..., None] * part for share, part in zip(shares, parts, strict=True))

    def _place(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The stretches between two points that times are in, and the shares of these that have passed."""
        along = np.clip(t, 0.0, self.time) / (self.time / (len(self.t) - 1))
        k = np.minimum(along.astype(int), len(self.t) - 2)
        return k, along - k

    def sampled(self, step: float) -> Samples:
        """The references at every `step` seconds and the means of the torques until the next sample."""
        step = seconds(step, "the step")
        t = step * np.arange(int(np.ceil(self.time / step - 1e-9)) + 1)
        return Samples(t, *self.reference(t), self.mean_torque(t, t + step))

    def c(self) -> dict[str, str]:
        """The plan as C99, texts by names of files: `<robot>_plan.h` and `<robot>_plan.c`, which need no others.

        `<robot>_plan_sample` gives what :meth:`sampled` gives, to rounding. Raises UsageError.
        """
        from .plan_c import plan_files

        return plan_files(self)
