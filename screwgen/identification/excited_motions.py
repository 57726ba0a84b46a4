"""Motions of joints along Fourier series, with what the drives exert, as large as limits let them be.

The joints of a copy of the robot are given their motion, so that its links bend as they do on the arm and the efforts
follow; many series, and several sizes of each, are lanes of one rollout.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import UsageError
from ..planning.drive_coordinates import DriveCoordinates
from ..planning.task import MotionLimits
from ..robot_model import RobotModel
from ..simulation.feedforward import moved
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
        ("the rate ", model.v_names, drives.driven_rates(run.q, run.v), -limits.rates, limits.rates),
        ("the effort ", model.tau_names, drives.efforts(run.tau), -limits.efforts, limits.efforts),
        ("the strain ", model.strain_names, strain, -limits.strains, limits.strains),
    ):
        for name, column, least, largest in zip(names, values.T, low, high, strict=False):
            for end in (float(column.min()), float(column.max())):
                if not least <= end <= largest:
                    return f"{what}{name} reaches {end:.4g}; its limits are {least:.4g} and {largest:.4g}"
    return ""


@dataclass(frozen=True, eq=False)
class RestingArm:
    """Where a motion begins, at rest."""

    q: np.ndarray
    """(nq,): coordinates of the robot."""
    torque: np.ndarray
    """(n_joints,): the efforts that hold it, as drives have them."""
    leading: tuple[int, ...]
    """The joints that move along series: all, in loops as many as these leave free."""

    @property
    def following(self) -> list[int]:
        """The joints that follow these in loops."""
        return [joint for joint in range(len(self.torque)) if joint not in self.leading]


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
        self, model: RobotModel, series: FourierSeries, begin: RestingArm, limits: MotionLimits, parameters: np.ndarray
    ):
        self.model, self.series, self.limits, self.p = model, series, limits, parameters
        self.step, self.begin, self.drives = float(series.t[1]), begin, DriveCoordinates(model.chain, parameters)

    @property
    def start(self) -> np.ndarray:
        """(n_joints,): where joints begin, as their drives have them."""
        return self.drives.driven(self.begin.q)

    @cached_property
    def led(self) -> RobotModel:
        """The robot whose leading joints move as is given."""
        key = ("led", self.begin.leading)
        return self.model.once(key, lambda: RobotModel(moved(self.model.robot, self.begin.leading)))

    @property
    def size(self) -> int:
        """The number of factors of a motion."""
        return self.series.size * len(self.begin.leading)

    def largest(self, factors: np.ndarray) -> Motions:
        """The largest motions within limits with factors in these proportions (lanes, size); inputs at all samples."""
        own = np.zeros((len(factors), self.series.size, self.model.n_joints))
        own[..., list(self.begin.leading)] = factors.reshape(len(factors), self.series.size, -1)
        shape = np.stack(
            [basis @ own for basis in (self.series.values, self.series.rates, self.series.accelerations)], 1
        )
        size, still = self._within_ranges(shape), self.share_taken(self._run(self._sized(shape[:1], np.zeros(1))))
        for _ in range(ROUNDS):
            made = self._run(self._sized(shape, size))
            share = self.share_taken(made)
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
        limits, own = self.limits, list(self.begin.leading)
        with np.errstate(divide="ignore", invalid="ignore"):
            room = [
                (limits.upper - self.start)[own] / shape[:, 0].max(axis=1)[:, own],
                (self.start - limits.lower)[own] / -shape[:, 0].min(axis=1)[:, own],
                limits.rates[own] / np.abs(shape[:, 1]).max(axis=1)[:, own],
            ]
        room = [np.where(x >= 0, x, np.inf) for x in room]
        return HEADROOM * np.min(np.concatenate(room, axis=1), axis=1)

    def _run(self, references: np.ndarray) -> Motions:
        """Motions of joints along references (lanes, 3, samples, joints)."""
        x0 = np.concatenate([self.begin.q, np.zeros(self.model.nv)])
        given = np.diff(references[:, 1], axis=1) / self.step * np.array(self.drives.ratios)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # what is said of single motions is said of the one that is chosen
            run = rollout(self.led, x0, given, step=self.step, parameters=self.p)
        held = np.concatenate([run.drive_effort[:, :-1], run.drive_effort[:, -2:-1]], axis=1)
        held[~run.ok] = np.inf
        if following := self.begin.following:
            references, rates = references.copy(), self.drives.driven_rates(run.q, run.v)
            for k, curve in enumerate((self.drives.driven(run.q), rates, np.gradient(rates, self.step, axis=1))):
                references[:, k, :, following] = np.moveaxis(curve[..., following], 2, 0)
        return Motions(run.q, run.v, held, references)

    def _followed(self, made: Motions) -> np.ndarray:
        """The largest shares (lanes,) of ranges and rates that joints take which follow others in loops."""
        limits, (q, v) = self.limits, np.moveaxis(made.references[:, :2], 1, 0)
        way = q - self.start
        room = np.where(way > 0, limits.upper - self.start, limits.lower - self.start)
        shares = np.maximum(way / room, np.abs(v) / limits.rates)
        return np.max(shares[..., self.begin.following], axis=(1, 2), initial=0.0)

    def share_taken(self, made: Motions) -> np.ndarray:
        """The largest share (lanes,) that each motion takes of its limits: of efforts and strains, less headroom, and
        of ranges and rates of joints that follow others."""
        with np.errstate(invalid="ignore"):
            efforts = np.abs(self.drives.efforts(made.tau)) / self.limits.efforts
            share = np.max(efforts[..., list(self.begin.leading)], axis=(1, 2))
            share = np.maximum(share, self._followed(made))
        if np.isfinite(self.limits.strains).any():
            bent = np.abs(strain(self.model, made.q, self.p)).max(axis=1)
            share = np.maximum(share, (bent / self.limits.strains).max(axis=1))
        return np.where(np.isnan(share), np.inf, share) / HEADROOM
