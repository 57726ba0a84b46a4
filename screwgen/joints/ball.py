"""The ball joint: the link turns about the joint point in every direction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..algebra.expression import Symbol, identity, zeros
from .exponential import Series, angular_velocity, cross, quaternion_rate, rotation, turn_between, turned
from .kind import JointKind, Kinematics
from .screw import Screw


@dataclass(frozen=True)
class Ball(JointKind):
    """``q``: the quaternion of F_i in the mount's axes; rates: the angular velocity relative to it, in axes of F_i.

    A torque acts along each rate: the moment of the carrier on the link, in axes of F_i.
    """

    def kinematics(self, coordinates: Sequence[Symbol]) -> Kinematics:
        return Kinematics(rotation(coordinates), zeros(3), identity(3), zeros(3, 3))

    def integrate(self, q: np.ndarray, u: np.ndarray, series: Series) -> np.ndarray:
        return turned(q, u, series)

    def difference(self, q: np.ndarray, other: np.ndarray, series: Series) -> np.ndarray:
        return turn_between(q, other)

    def rate(self, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        first = cross(u, v)
        return v + first / 2 + cross(u, first) / 12

    def coordinate_rates(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return quaternion_rate(q, v)

    def rates_of(self, q: np.ndarray, change: np.ndarray) -> np.ndarray:
        return angular_velocity(q, change)

    def carried(self, v: np.ndarray) -> np.ndarray:
        return -cross(v[None], np.eye(3)).T


TURNS = Screw((1.0, 0.0, 0.0)), Screw((0.0, 1.0, 0.0)), Screw((0.0, 0.0, 1.0))

BALL = Ball(4, 3, 3, name="ball", along=TURNS, turn_at=0)
