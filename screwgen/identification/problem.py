"""What a fit compares: readings less what a robot with given numbers reads, case by case, and how it changes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from ..robot_model import RobotModel
from .unknowns import SENSOR, Unknowns

STEP = 1e-6
"""The step of differences with what is sought."""


@dataclass(frozen=True)
class MotionMethod:
    """How motions are made."""

    integrator: str
    substeps: int
    threads: int


class MeasuredCases(Protocol):
    """Readings of one source that a fit compares, in cases: windows of a log, or shapes at rest.

    Arrays: W cases, each of as many samples and sensors.
    """

    @property
    def names(self) -> list[str]:
        """The sensors."""

    @property
    def compared(self) -> np.ndarray:
        """(W, samples, sensors): the readings."""

    @property
    def stated(self) -> np.ndarray:
        """(sensors,): the deviations of noise, NaN where none is stated."""

    @property
    def spread(self) -> np.ndarray:
        """(sensors,): how much the readings vary, which weighs those without stated noise."""

    @property
    def states(self) -> np.ndarray:
        """The entries of its start that each case may choose, in their deviations."""

    @property
    def step(self) -> float:
        """The time between samples, s."""

    @property
    def posture(self) -> np.ndarray:
        """A posture (nq,) of the robot there."""

    def near(self, other: MeasuredCases) -> bool:
        """Whether cases begin where those of another group of the source do."""

    def differences(self, problem: Problem, window: np.ndarray, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        """Readings less what the model reads (lanes, samples, sensors), of lanes of cases.

        NaN where there is no reading, inf where the model has no motion or rest. `window` (lanes,): the case of each;
        `sought` (lanes, k); `shift` (lanes, states).
        """

    def continued(self, problem: Problem, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        """Other starts (W, states) to try: of each case where the motion of the one before it ends."""

    def linearised(
        self, problem: Problem, sought: np.ndarray, shift: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Differences (W, samples, sensors), and their derivatives with what is sought and with states, (.., columns).

        `sought` (k,), `shift` (W, states).
        """


class Problem:
    """What several sources say, and the numbers that are free; if they are `fixed` the starts of cases alone are."""

    def __init__(
        self,
        model: RobotModel,
        groups: Sequence[MeasuredCases],
        unknowns: Unknowns,
        how: MotionMethod,
        fixed: bool = False,
    ):
        self.model, self.groups, self.unknowns, self.how = model, list(groups), unknowns, how
        self.rollouts, self.fixed = 0, fixed

    @cached_property
    def moving(self) -> list[int]:
        """Which unknowns move the robot."""
        return [k for k, one in enumerate(self.unknowns) if one.kind != SENSOR and not self.fixed]

    @cached_property
    def sensing(self) -> list[int]:
        """Which unknowns change what sensors make of its motion."""
        return [k for k, one in enumerate(self.unknowns) if one.kind == SENSOR and not self.fixed]

    @cached_property
    def sensor_names(self) -> list[str]:
        """The names of all sensors that are compared."""
        return list(dict.fromkeys(name for group in self.groups for name in group.names))

    def own(self, group: MeasuredCases) -> list[int]:
        """The places of a group's sensors among all."""
        return [self.sensor_names.index(name) for name in group.names]

    def of_all(self, parts: Sequence[np.ndarray]) -> np.ndarray:
        """Of every group an array (…, sensors) as rows (rows, all sensors), NaN for sensors that it has not."""
        found = []
        for group, part in zip(self.groups, parts, strict=True):
            rows = np.full((part.size // part.shape[-1], len(self.sensor_names)), np.nan)
            rows[:, self.own(group)] = part.reshape(-1, part.shape[-1])
            found.append(rows)
        return np.concatenate(found)
