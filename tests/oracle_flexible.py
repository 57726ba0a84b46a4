"""The oracle's flexible bodies: points with masses, places, and displacements by each mode; no package code.

A robot's dict names one under a link's key `cloud`; such a link has neither length, section nor modes.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca
import numpy as np
from oracle_shapes import DIRECTIONS


@dataclass(frozen=True)
class Flexible:
    """N points and r modes, in F_i axes from the joint point. The tip is a frame of its own, carried by no point."""

    masses: np.ndarray  # (N,)
    places: np.ndarray  # (N, 3)
    shapes: np.ndarray  # (N, 3, r)
    stiffness: np.ndarray  # (r, r)
    tip: np.ndarray  # (3,)
    tip_shapes: np.ndarray  # (3, r)
    tip_turns: np.ndarray  # (3, r): rotation vector by each mode
    tip_axes: np.ndarray = field(default_factory=lambda: np.eye(3))
    damping: np.ndarray | None = None  # (r,)
    second: np.ndarray | None = None  # (N, 3, r, r): displacement 1/2 eta^T H eta
    tip_second: np.ndarray | None = None  # (3, r, r)
    tip_turn_second: np.ndarray | None = None  # (3, r, r)

    @property
    def modes(self) -> int:
        return len(self.stiffness)


@dataclass(frozen=True)
class FlexibleLink:
    """Numbers of a link that is such a body, by the names that the oracle asks any link for."""

    cloud: Flexible
    axes: np.ndarray
    turns: tuple[bool, ...]
    travel: np.ndarray
    mount_R: np.ndarray
    mount_xyz: np.ndarray
    armature: np.ndarray
    joint_damping: np.ndarray
    joint_stiffness: np.ndarray
    base: list
    tip: list
    damping: np.ndarray
    drives: list[dict]
    limits: list[dict]
    a: float = 0.0

    @property
    def K(self) -> np.ndarray:
        return self.cloud.stiffness

    @property
    def counts(self) -> dict[str, int]:
        """All modes under the first direction: the oracle asks for their number and where they sit."""
        return {d: self.cloud.modes * (d == DIRECTIONS[0]) for d in DIRECTIONS}

    @property
    def masses(self) -> np.ndarray:
        return self.cloud.masses

    @property
    def spin_inertia(self) -> np.ndarray:
        return np.zeros((3, len(self.masses)))

    def undeformed(self) -> np.ndarray:
        """(3, N)."""
        return self.cloud.places.T

    def shift(self, eta: ca.SX) -> ca.SX:
        """(3, N): the elements' linear displacements."""
        return ca.reshape(ca.DM(self.cloud.shapes.reshape(-1, self.cloud.modes)) @ eta, 3, -1)

    def twist(self, eta: ca.SX) -> ca.SX:
        return ca.SX.zeros(3, len(self.masses))

    def second_shift(self, eta: ca.SX) -> ca.SX | None:
        """(3, N): their second-order displacements."""
        if self.cloud.second is None:
            return None
        columns = [ca.vertcat(*[ca.dot(eta, ca.DM(h) @ eta) / 2 for h in H]) for H in self.cloud.second]
        return ca.horzcat(*columns)

    def tip_place(self, eta: ca.SX) -> ca.SX:
        return ca.DM(self.cloud.tip) + ca.DM(self.cloud.tip_shapes) @ eta + _quadratic(self.cloud.tip_second, eta)

    def tip_turn(self, eta: ca.SX) -> ca.SX:
        """The rotation vector of the tip."""
        return ca.DM(self.cloud.tip_turns) @ eta + _quadratic(self.cloud.tip_turn_second, eta)

    @property
    def tip_axes(self) -> np.ndarray:
        return self.cloud.tip_axes


def _quadratic(H: np.ndarray | None, eta: ca.SX) -> ca.SX:
    return ca.SX.zeros(3) if H is None else ca.vertcat(*[ca.dot(eta, ca.DM(h) @ eta) / 2 for h in H])
