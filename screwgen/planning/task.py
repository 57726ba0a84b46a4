"""What is asked of a plan: from where to where, in which time, within which limits."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import casadi as ca
import numpy as np

from .waypoints import Waypoint

WEIGHT, STRICTER = 1e5, 100.0
"""Of the energy that is left at the end, over that of the motion: a hundred-thousandth costs one. By a factor more
where that does not bring it to rest.

As a cost it may be left where torques barely reach it; as a condition, nearly dependent ones would not let the search
converge.
"""


@dataclass(frozen=True)
class JointLaw:
    """The gains under which a plan is played, N·m/rad and N·m·s/rad, one per joint."""

    kp: np.ndarray
    kd: np.ndarray

    def torques(self, lag: Any, late: Any) -> Any:
        """What the law adds at joints that are behind their references, arrays or expressions (n_joints, …).

        Where a drive has a transmission its effort is this over the lever of the posture.
        """
        kp, kd = self.kp[:, None], self.kd[:, None]
        return kp * lag + kd * late if isinstance(lag, np.ndarray) else ca.DM(kp) * lag + ca.DM(kd) * late


@dataclass(frozen=True)
class MotionLimits:
    """Bounds of a motion, infinite where there is none; of the joints (n_joints,) each."""

    lower: np.ndarray
    upper: np.ndarray
    rates: np.ndarray
    efforts: np.ndarray
    effort_rates: np.ndarray
    """N·m/s, of slides and cylinders N/s: how fast efforts of drives may change."""
    strains: np.ndarray
    """(n_strains,): of the centrelines, in the order of `model.strain_names`, of either sign."""
    wrenches: np.ndarray
    """(6 n_links,): of the joint wrenches, in the order of `model.wrench_names`, of either sign."""


@dataclass(frozen=True)
class Task:
    """A motion of the joints from rest to rest, perhaps through waypoints."""

    start: np.ndarray
    goal: np.ndarray
    time: float
    intervals: int
    law: JointLaw
    limits: MotionLimits
    through: tuple[Waypoint, ...] = ()
    force_scale: float = 1.0
    """What torques are measured in, N·m."""
    levers: np.ndarray | float = 1.0
    """(n_joints,): sizes of the levers of drives, by which their efforts are measured as torques."""
    weight: float = WEIGHT
    """Of the energy that is left at the end, over that of the motion."""
    energy_scale: float = 1.0
    """What energies are measured in, J."""
    between: tuple[float, ...] = ()
    """Shares of the time, between the points of the programme, at which limits of joints and strains are asked too."""
    rounds: int = 0
    """How often such shares were added."""

    @property
    def way(self) -> np.ndarray:
        """(n_joints,): how far each joint goes; there and back are added up."""
        legs = np.diff([self.start, *(x.joints for x in self.through), self.goal], axis=0)
        return np.copysign(np.abs(legs).sum(axis=0), self.goal - self.start)

    def within(self, time: float) -> Task:
        """The same motion in another time."""
        return replace(self, time=time, energy_scale=self.energy_scale * (self.time / time) ** 2)

    def stricter(self) -> Task:
        """The same where what is left at the end costs more."""
        return replace(self, weight=STRICTER * self.weight)

    def also_at(self, shares: tuple[float, ...]) -> Task:
        """The same with limits at further shares of the time."""
        return replace(self, between=self.between + shares, rounds=self.rounds + 1)

    @property
    def effort_scales(self) -> np.ndarray:
        """(n_joints,): what efforts of drives are measured in."""
        return self.force_scale / (self.levers * np.ones(len(self.start)))

    def measured_in(self, inertia: np.ndarray, holding: np.ndarray, levers: np.ndarray) -> Task:
        """The same with the sizes of its torques and energies, of an arm with an inertia (n_joints, n_joints).

        `holding` (n_joints,): the efforts that hold it; `levers` (n_joints,): of its drives.
        """
        rate, levers = self.way / self.time, np.abs(levers)
        force = np.abs(np.append(inertia @ rate * 6 / self.time, levers * holding)).max()
        return replace(self, force_scale=float(force), levers=levers, energy_scale=float(rate @ inertia @ rate))
