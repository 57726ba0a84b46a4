"""Coordinates of an arm in the order in which plans have them: what drives act on and measure, then all others.

A drive behind an elastic gear acts on its rotor, where its encoder sits. Its coordinate is the rotor's angle over the
ratio, where the joint would be if the gear did not twist; its effort is that of the rotor times the ratio. By how much
the joint is ahead of it, the twist of the gear, is one of the others, as coordinates of modes are.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

if TYPE_CHECKING:
    from ..topology.chain import Chain


class DriveCoordinates:
    """Those of a robot on a fixed base at parameters, numbers or symbols: `q = map x`.

    Without elastic drives they are the coordinates of the robot themselves.
    """

    def __init__(self, chain: Chain, p: Any):
        self.joints, self.count = chain.n_joints, chain.nq
        self.places = list(chain.held_places)
        """(n_joints,): where in `q` of the robot the coordinates of its drives stand."""
        self.ratios = [1.0] * chain.n_joints
        """(n_joints,): turns of the rotors per turn of the joints, 1 of rigid drives."""
        for joint, ratio in zip(chain.added_joints, chain.ratios(p), strict=True):
            self.ratios[joint] = ratio
        self.given = list(chain.prescribed)
        """The joints whose motion is given; their effort is an acceleration, that of the rotor over the ratio."""

    @cached_property
    def map(self) -> ca.SX:
        """(nq, nq): of the robot's coordinates by these."""
        out = ca.SX(self.count, self.count)
        others = sorted(set(range(self.count)) - set(self.places))
        for column, place in enumerate([*self.places, *others]):
            out[place, column] = self.ratios[column] if column < self.joints else 1.0
        for joint, place in enumerate(self.places):
            if place != joint:
                out[joint, joint] = 1.0
        return out

    def to_robot(self, x: Any) -> Any:
        """Coordinates, rates or accelerations (nq,) of the robot, numbers or a column of symbols."""
        if isinstance(x, ca.SX):
            return self.map @ x
        return np.array(ca.DM(self.map)) @ np.asarray(x, float)

    def forces(self, f: ca.SX) -> ca.SX:
        """Forces (nq,) of the robot, symbols, as these coordinates have them: equal power."""
        return self.map.T @ f

    def driven(self, q: np.ndarray) -> np.ndarray:
        """(…, n_joints): what drives measure, of coordinates or rates (…, nq) of the robot."""
        return q[..., self.places] / np.array(self.ratios, float)

    def efforts(self, tau: np.ndarray) -> np.ndarray:
        """(…, n_joints): of efforts (…, n_tau) where drives act, times the ratios; of given accelerations over them."""
        return tau[..., : self.joints] * self.effort_ratios

    @property
    def effort_ratios(self) -> np.ndarray:
        """(n_joints,): of efforts here to those where drives act."""
        return np.array([1.0 / x if joint in self.given else x for joint, x in enumerate(self.ratios)], float)

    def with_accelerations(self, force: ca.SX, a: ca.SX) -> ca.SX:
        """Forces (nq,) of these coordinates, of joints whose motion is given the accelerations in their place."""
        out = ca.SX(force)
        for joint in self.given:
            out[joint] = a[joint]
        return out
