"""The floating base: a joint to the inertial frame that leaves its link free, with the link's twist as rates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..algebra.expression import Symbol, block, identity, stack, zeros
from .exponential import (
    Series,
    algebra_rate,
    angular_velocity,
    carried,
    exponential,
    quaternion_rate,
    rotated,
    rotation,
    turn_between,
)
from .kind import JointKind, Kinematics


@dataclass(frozen=True)
class Free(JointKind):
    """``q = [position; quaternion]`` of F_i in the inertial frame, rates ``[omega; v]`` of F_i in its own axes.

    The motion subspace is the identity. The pose moves by the exponential map of SE(3).
    """

    def kinematics(self, coordinates: Sequence[Symbol]) -> Kinematics:
        one, none = identity(3), zeros(3, 3)
        position, quaternion = stack(*coordinates[:3]), coordinates[3:]
        return Kinematics(rotation(quaternion), position, block([one, none]), block([none, one]))

    def integrate(self, q: np.ndarray, u: np.ndarray, series: Series) -> np.ndarray:
        pose = exponential(np.concatenate([q[3:], q[:3]]), u, series)
        return np.concatenate([pose[4:], pose[:4]])

    def difference(self, q: np.ndarray, other: np.ndarray, series: Series) -> np.ndarray:
        turn, back = turn_between(q[3:], other[3:]), np.append(q[3], -q[4:])
        units = np.vstack([np.zeros((3, 3)), np.eye(3)])
        start = np.array([1.0, *[0.0] * 6])
        moved = [exponential(start, np.append(turn, unit[3:]), series)[4:] for unit in units.T]
        return np.append(turn, np.linalg.solve(np.array(moved).T, rotated(back, other[:3] - q[:3])))

    def rate(self, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        return algebra_rate(u[None], v[None])[0]

    def coordinate_rates(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return np.concatenate([rotated(q[3:], v[3:]), quaternion_rate(q[3:], v[:3])])

    def rates_of(self, q: np.ndarray, change: np.ndarray) -> np.ndarray:
        return np.concatenate([angular_velocity(q[3:], change[3:]), rotated(np.append(q[3], -q[4:]), change[:3])])

    def carried(self, v: np.ndarray) -> np.ndarray:
        return carried(v)


FREE = Free(7, 6, 0, in_space=True, name="free", turn_at=3)
MOVING = replace(FREE, given=True, name="moving")
"""The same where the motion is given."""
