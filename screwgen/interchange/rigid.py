"""Poses and inertias of rigid bodies, as links of a URDF state them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import atan2, cos, hypot, sin
from typing import NamedTuple

import numpy as np

from ..reduction.invariants import hat
from ..spec.physics import some_body_has

NOTHING = 1e-15
"""What rounding leaves where there is nothing: of mounts in m and rad, of tensors relative to their largest entry."""


LAST_DIGIT = 1e-11
"""rad: what the last digit of an angle leaves, since URDFs have a right angle as 1.57079632679, 5e-12 less."""


class Pose(NamedTuple):
    """A frame in another one: rotation (3, 3) and origin (3,), m."""

    R: np.ndarray
    p: np.ndarray

    def __matmul__(self, other: Pose) -> Pose:
        return Pose(self.R @ other.R, self.p + self.R @ other.p)

    @property
    def inverse(self) -> Pose:
        """The other frame in this one."""
        return Pose(self.R.T, -self.R.T @ self.p)

    @property
    def xyz(self) -> tuple[float, float, float]:
        """The origin, without what rounding left."""
        return cleaned(self.p)

    @property
    def rpy(self) -> tuple[float, float, float]:
        """Roll, pitch and yaw with R = Rz(y) Ry(p) Rx(r); exact to rounding in every posture."""
        R = self.R
        yaw = atan2(R[1, 0], R[0, 0]) if hypot(R[0, 0], R[1, 0]) > NOTHING else 0.0
        s, c = sin(yaw), cos(yaw)
        roll = atan2(s * R[0, 2] - c * R[1, 2], c * R[1, 1] - s * R[0, 1])
        return cleaned((roll, atan2(-R[2, 0], c * R[0, 0] + s * R[1, 0]), yaw))


HERE = Pose(np.eye(3), np.zeros(3))


def cleaned(values: Iterable[float], least: float = NOTHING) -> tuple[float, float, float]:
    """Three numbers, zero where they are at most `least`, by default what rounding leaves."""
    x, y, z = (float(value) if abs(value) > least else 0.0 for value in values)
    return x, y, z


def pose(xyz: Sequence[float], rpy: Sequence[float]) -> Pose:
    """A URDF's origin."""
    (sr, cr), (sp, cp), (sy, cy) = ((sin(x), cos(x)) for x in rpy)
    R = np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )
    return Pose(R, np.array(xyz, dtype=float))


def turned(axis: Sequence[float], angle: float) -> np.ndarray:
    """The rotation (3, 3) about an axis by an angle, rad."""
    K = hat(np.array(axis) / np.linalg.norm(axis))
    return np.eye(3) + sin(angle) * K + (1 - cos(angle)) * K @ K


@dataclass(frozen=True)
class Inertial:
    """Mass (kg), centre of mass (3,) (m) and the tensor about it (3, 3) (kg·m²), in the axes of one frame."""

    mass: float
    com: np.ndarray
    tensor: np.ndarray

    @classmethod
    def of(cls, mass: float, com: Sequence[float] | None, entries: Sequence[float] | None) -> Inertial:
        """A body as a robot file states it, with the tensor's [xx, yy, zz, xy, xz, yz]."""
        xx, yy, zz, xy, xz, yz = entries or (0.0,) * 6
        return cls(mass, np.array(com or (0.0,) * 3), np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))

    @property
    def something(self) -> bool:
        """Whether there is any inertia at all."""
        return self.mass > 0 or bool(self.tensor.any())

    def matters_in(self, whole: Inertial) -> bool:
        """Whether the tensor is more than the rounding of that of a body of which this one is a part."""
        return bool(np.abs(self.tensor).max() > NOTHING * np.abs(whole.tensor).max())

    @property
    def entries(self) -> tuple[float, ...]:
        """[xx, yy, zz, xy, xz, yz], without what rounding left."""
        J = np.where(np.abs(self.tensor) > NOTHING * np.abs(self.tensor).max(), self.tensor, 0.0)
        return tuple(float(x) for x in (J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]))

    def seen(self, frame: Pose) -> Inertial:
        """The same body, stated in a frame that has this one at the pose `frame`."""
        if np.array_equal(frame.R, np.eye(3)):
            return Inertial(self.mass, self.com + frame.p, self.tensor)
        return Inertial(self.mass, frame.p + frame.R @ self.com, frame.R @ self.tensor @ frame.R.T)

    def about_origin(self) -> np.ndarray:
        """(6, 6): the inertia of twists [ω; v] of the frame's origin."""
        c = hat(self.com)
        return np.block([[self.tensor - self.mass * c @ c, self.mass * c], [-self.mass * c, self.mass * np.eye(3)]])

    def table(self, at: str = "base") -> dict:
        """The body as a robot file states it; zero entries are left out."""
        body: dict = {"at": at, "mass": self.mass}
        if self.mass and any(com := cleaned(self.com)):
            body["com"] = com
        if self.tensor.any():
            body["inertia"] = self.entries
        return body


def together(parts: Sequence[Inertial]) -> Inertial:
    """Several bodies as one; one body stays as it is, to the last digit."""
    parts = [part for part in parts if part.something]
    if len(parts) == 1:
        return _without_rounding(parts[0], parts)
    mass = sum(part.mass for part in parts)
    com = sum((part.mass * part.com for part in parts), np.zeros(3)) / (mass or 1.0)
    tensor = np.zeros((3, 3))
    for part in parts:
        d = hat(part.com - com)
        tensor += part.tensor - part.mass * d @ d
    return _without_rounding(Inertial(mass, com, (tensor + tensor.T) / 2), parts)


def _without_rounding(body: Inertial, parts: Sequence[Inertial]) -> Inertial:
    """A point mass where the tensor is less than the rounding of what it was made from."""
    size = max(part.mass * (part.com @ part.com) + np.abs(part.tensor).max() for part in parts)
    return Inertial(body.mass, body.com, np.zeros((3, 3))) if np.abs(body.tensor).max() <= NOTHING * size else body


def possible(body: Inertial) -> bool:
    """Whether some body has this inertia."""
    return not body.tensor.any() or some_body_has(body.entries)


def nearest(body: Inertial) -> Inertial:
    """The body with the nearest inertia that some body has: ∫ r rᵀ dm without what is negative of it."""
    J = body.tensor
    w, U = np.linalg.eigh(np.trace(J) / 2 * np.eye(3) - J)
    spread = (U * np.maximum(w, 0.0)) @ U.T
    tensor = np.trace(spread) * np.eye(3) - spread
    return Inertial(body.mass, body.com, (tensor + tensor.T) / 2)
