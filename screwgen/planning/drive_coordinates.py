"""Coordinates of an arm in the order in which plans have them: what drives act on and measure, then all others.

A drive behind an elastic gear acts on its rotor, where its encoder sits. Its coordinate is the rotor's angle over the
ratio, where the joint would be if the gear did not twist; its effort is that of the rotor times the ratio. The
coordinate of the joint itself is one of the others, as those of modes are.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

if TYPE_CHECKING:
    from ..topology.chain import Chain


class DriveCoordinates:
    """Those of a robot on a fixed base at parameters, numbers or symbols: `q = scale x`, in another order.

    Without elastic drives they are the coordinates of the robot themselves.
    """

    def __init__(self, chain: Chain, p: Any):
        self.joints = chain.n_joints
        driven = list(chain.held_places)
        self.places = [*driven, *sorted(set(range(chain.nq)) - set(driven))]
        """Where in `q` each stands."""
        self.ratios = [1.0] * chain.n_joints
        """(n_joints,): turns of the rotors per turn of the joints, 1 of rigid drives."""
        for joint, ratio in zip(chain.added_joints, chain.ratios(p), strict=True):
            self.ratios[joint] = ratio

    @property
    def scale(self) -> list:
        """Of each coordinate (nq,)."""
        return [*self.ratios, *([1.0] * (len(self.places) - self.joints))]

    def to_robot(self, x: Any) -> Any:
        """Coordinates, rates or accelerations (nq,) of the robot, numbers or a column of symbols."""
        order = np.argsort(self.places).tolist()
        if isinstance(x, ca.SX):
            return (x * ca.vertcat(*self.scale))[order]
        return (np.asarray(x, float) * np.array(self.scale, float))[order]

    def forces(self, f: ca.SX) -> ca.SX:
        """Forces (nq,) of the robot, symbols, as these coordinates have them: equal power."""
        return f[self.places] * ca.vertcat(*self.scale)

    def driven(self, q: np.ndarray) -> np.ndarray:
        """(…, n_joints): what drives measure, of coordinates or rates (…, nq) of the robot."""
        return q[..., self.places[: self.joints]] / np.array(self.ratios, float)

    def efforts(self, tau: np.ndarray) -> np.ndarray:
        """(…, n_joints): of efforts (…, n_tau) where drives act, times the ratios."""
        return tau[..., : self.joints] * np.array(self.ratios, float)

    @cached_property
    def rigid(self) -> np.ndarray:
        """(nq, n_joints): what the coordinates do as drives turn and nothing bends or twists."""
        out = np.eye(len(self.places), self.joints)
        for joint, place in enumerate(self.places[: self.joints]):
            if place != joint:
                out[self.places.index(joint), joint] = 1.0
        return out
