"""Motions of joints along Fourier series, with what the drives exert, as large as limits let them be.

The joints of a copy of the robot are given their motion, so that its links bend as they do on the arm and the efforts
follow; many series, and several sizes of each, are lanes of one rollout.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np

from ..errors import UsageError
from ..planning.drive_coordinates import DriveCoordinates
from ..planning.members import Still
from ..planning.task import MotionLimits
from ..robot_model import RobotModel
from ..simulation.feedforward import moved_model
from ..simulation.measured import strain
from ..simulation.rollout import rollout
from ..simulation.runs import Run
from .fourier import FourierSeries

ROUNDS, LESS, LEAST = 12, 0.98, 0.02
"""How often a motion is made smaller until it keeps its limits, by how much more than a line through the efforts says,
and by how much at most."""
HEADROOM = 0.95
"""The share of all limits that a motion is made for; the rest is for the joint law and for what the model lacks."""


def broken_limit(limits: MotionLimits, model: RobotModel, run: Run, strain: np.ndarray) -> str:
    """A limit that a run breaks, in words, none where it keeps all; `strain` (samples, entries)."""
    drives = DriveCoordinates(model.chain, model.parameter_values)
    for what, names, values, low, high in (
        ("", model.q_names, drives.driven(run.q), limits.lower, limits.upper),
        ("the rate ", model.v_names, drives.driven(run.v), -limits.rates, limits.rates),
        ("the effort ", model.tau_names, drives.efforts(run.tau), -limits.efforts, limits.efforts),
        ("the strain ", model.strain_names, strain, -limits.strains, limits.strains),
    ):
        for name, column, least, largest in zip(names, values.T, low, high, strict=False):
            for end in (float(column.min()), float(column.max())):
                if not least <= end <= largest:
                    return f"{what}{name} reaches {end:.4g}; its limits are {least:.4g} and {largest:.4g}"
    return ""


@dataclass(frozen=True, eq=False)
class Motions:
    """Motions (lanes, samples, …): coordinates, rates, and inputs held from each sample to the next."""

    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    references: np.ndarray
    """(lanes, 3, samples, joints): coordinates, rates and accelerations of the joints, as their drives have them."""


class MotionMaker:
    """Makes motions of a robot from factors of series."""

    def __init__(
        self, model: RobotModel, series: FourierSeries, start: np.ndarray, limits: MotionLimits, parameters: np.ndarray
    ):
        self.model, self.series, self.start, self.limits, self.p = model, series, start, limits, parameters
        self.step = float(series.t[1])
        still = Still(model, parameters)
        self.rest, self.drives = still.held(start), still.drives

    @property
    def led(self) -> RobotModel:
        """The robot whose joints move as is given."""
        return moved_model(self.model)

    @property
    def size(self) -> int:
        """The number of factors of a motion."""
        return self.series.size * self.model.n_joints

    def largest(self, factors: np.ndarray) -> Motions:
        """The largest motions within limits with factors in these proportions (lanes, size); inputs at all samples."""
        own = factors.reshape(len(factors), self.series.size, -1)
        shape = np.stack(
            [basis @ own for basis in (self.series.values, self.series.rates, self.series.accelerations)], 1
        )
        size, still = self._within_ranges(shape), self.strained(self._run(self._sized(shape[:1], np.zeros(1))))
        for _ in range(ROUNDS):
            made = self._run(self._sized(shape, size))
            share = self.strained(made)
            if (share <= 1.0).all():
                return made
            with np.errstate(divide="ignore", invalid="ignore"):
                less = np.where(np.isfinite(share), LESS * (1.0 - still) / (share - still), LEAST)
            size = size * np.where(share <= 1.0, 1.0, np.maximum(less, LEAST))
        raise UsageError("limits: no motion about the start is within them; raise efforts or strain, or move start")

    def _sized(self, shape: np.ndarray, size: np.ndarray) -> np.ndarray:
        """References (lanes, 3, samples, joints) of motions of these sizes (lanes,)."""
        references = size[:, None, None, None] * shape
        references[:, 0] += self.start
        return references

    def _within_ranges(self, shape: np.ndarray) -> np.ndarray:
        """The largest factors (lanes,) with which ranges and rates are kept."""
        limits = self.limits
        with np.errstate(divide="ignore", invalid="ignore"):
            room = [
                (limits.upper - self.start) / shape[:, 0].max(axis=1),
                (self.start - limits.lower) / -shape[:, 0].min(axis=1),
                limits.rates / np.abs(shape[:, 1]).max(axis=1),
            ]
        room = [np.where(x >= 0, x, np.inf) for x in room]
        return HEADROOM * np.min(np.concatenate(room, axis=1), axis=1)

    def _run(self, references: np.ndarray) -> Motions:
        """Motions of joints along references (lanes, 3, samples, joints)."""
        x0 = np.concatenate([self.drives.to_robot(self.rest.q), np.zeros(self.model.nv)])
        given = np.diff(references[:, 1], axis=1) / self.step * np.array(self.drives.ratios)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # what is said of single motions is said of the one that is chosen
            run = rollout(self.led, x0, given, step=self.step, parameters=self.p)
        held = np.concatenate([run.drive_effort[:, :-1], run.drive_effort[:, -2:-1]], axis=1)
        held[~run.ok] = np.inf
        return Motions(run.q, run.v, held, references)

    def strained(self, made: Motions) -> np.ndarray:
        """The largest shares (lanes,) that motions take of what limits and headroom leave of efforts and strains."""
        with np.errstate(invalid="ignore"):
            share = np.max(np.abs(self.drives.efforts(made.tau)) / self.limits.efforts, axis=(1, 2))
        if np.isfinite(self.limits.strains).any():
            bent = np.abs(strain(self.model, made.q, self.p)).max(axis=1)
            share = np.maximum(share, (bent / self.limits.strains).max(axis=1))
        return np.where(np.isnan(share), np.inf, share) / HEADROOM
