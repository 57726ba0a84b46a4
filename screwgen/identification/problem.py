"""What a fit compares: readings less what a robot with given numbers reads, window by window, and how it changes.

Every column of the Jacobian is a lane of one rollout: of each window one lane as it is, one for every number that
moves the robot, and one for every entry of the state in which it begins.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import UsageError
from ..robot_model import RobotModel
from ..simulation.rollout import Rollout, rollout
from . import smoothing
from .sensing import Start, readings
from .signals import Signals
from .unknowns import SENSOR, Unknowns, input_numbers, parameter_rows, sensor_numbers
from .windows import Experiment, StartState, starts

STEP, STATE_STEP = 1e-6, 1e-4
"""Steps of differences: of what is sought, and of states in their deviations."""
MAX_BYTES = 2**28


@dataclass(frozen=True)
class How:
    """How motions are made."""

    integrator: str
    substeps: int
    threads: int


@dataclass(frozen=True, eq=False)
class Windows:
    """The windows of one experiment: first samples (W,), samples of each, and where their motions begin."""

    experiment: Experiment
    signals: Signals
    first: np.ndarray
    size: int
    begin: list[StartState]

    @cached_property
    def states(self) -> np.ndarray:
        """The entries of [q; v] in which a motion may begin otherwise."""
        return np.flatnonzero(np.max([one.deviation for one in self.begin], axis=0) > 0)

    @cached_property
    def compared(self) -> np.ndarray:
        """(W, samples, sensors): the readings that are compared."""
        at = self.first[:, None] + np.arange(self.size)
        return self.experiment.readings[at][..., self.experiment.compared]

    @cached_property
    def begun(self) -> list[Start]:
        """The readings with which windows begin, of each compared sensor."""
        log, e = self.experiment.log, self.experiment
        own = e.readings[:, e.compared]
        found = [smoothing.smoothed(own, int(first), log.step, e.reach) for first in self.first]
        value, rate = np.array([x.value for x in found]), np.array([x.rate for x in found])
        return [Start(value[:, k], rate[:, k]) for k in range(own.shape[1])]

    def near(self, other: Windows) -> bool:
        """Whether windows begin where others do, within deviations."""
        pairs = zip(self.begin, other.begin, strict=True)
        return all((np.abs(a.x - b.x) <= b.deviation).all() for a, b in pairs)

    def x0(self, window: np.ndarray, shift: np.ndarray) -> np.ndarray:
        """The states (lanes, nq + nvz) in which lanes begin, `shift` (lanes, states) in deviations of these."""
        x, deviation = np.array([b.x for b in self.begin]), np.array([b.deviation for b in self.begin])
        out = x[window].copy()
        out[:, self.states] += shift * deviation[window][:, self.states]
        return out


class Problem:
    """Windows of several logs, and the numbers that are free; if they are `fixed` the starts of windows alone are."""

    def __init__(self, model: RobotModel, groups: Sequence[Windows], unknowns: Unknowns, how: How, fixed: bool = False):
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

    @property
    def sensor_names(self) -> list[str]:
        """The names of the sensors that are compared."""
        experiment = self.groups[0].experiment
        return [experiment.columns.sensors[k].name for k in experiment.compared]

    def differences(self, group: Windows, window: np.ndarray, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        """Readings less what the model reads (lanes, samples, sensors), of lanes of windows; NaN where there is none.

        `window` (lanes,), `sought` (lanes, k), `shift` (lanes, states).
        """
        values = self.unknowns.values(sought)
        run, p, tau = self.rolled(group, window, values, shift)
        made = self._read(group, window, values, _Motions(run.q, run.v, p, tau))
        out = group.compared[window] - made
        out[~run.ok] = np.inf
        return out

    def rolled(
        self, group: Windows, window: np.ndarray, values: np.ndarray, shift: np.ndarray
    ) -> tuple[Rollout, np.ndarray, np.ndarray]:
        """The motions of lanes, their parameters, and their inputs."""
        e, how = group.experiment, self.how
        gains = [input_numbers(self.unknowns, column, values) for column in e.columns.inputs]
        tau = e.tau(group.first[window], group.size, gains)
        p = parameter_rows(self.model, self.unknowns, values)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # what is said of single motions is said of the result
            run = rollout(
                self.model,
                group.x0(window, shift),
                tau[:, : group.size - 1],
                step=e.log.step,
                substeps=how.substeps,
                integrator=how.integrator,
                parameters=p,
                threads=how.threads,
            )
        self.rollouts += len(window)
        return run, p, tau

    def _read(self, group: Windows, window: np.ndarray, values: np.ndarray, made: _Motions) -> np.ndarray:
        """What sensors read of motions (lanes, samples, sensors)."""
        e = group.experiment
        found = group.signals(made.q, made.v, made.tau, made.p, e.compared)
        for k, sensor in enumerate(e.compared):
            numbers = sensor_numbers(self.unknowns, e.columns.sensors[sensor], values)
            start = Start(*(x[window] for x in group.begun[k]))
            found[..., k] = readings(found[..., k], numbers, e.log.step, start)
        return found

    def linearised(
        self, group: Windows, sought: np.ndarray, shift: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Differences (W, samples, sensors), and their derivatives with what is sought and with states, (.., columns).

        `sought` (k,), `shift` (W, states).
        """
        parts = [self._linearised(group, w, sought, shift[w]) for w in self._chunks(group)]
        found = tuple(np.concatenate(x) for x in zip(*parts, strict=True))
        return found[0], found[1], found[2]

    def _chunks(self, group: Windows) -> list[np.ndarray]:
        """Windows that fit into the memory together."""
        lanes = 1 + len(self.moving) + len(group.states)
        numbers = lanes * group.size * (len(group.begin[0].x) + self.model.n_tau + 2 * len(group.experiment.compared))
        at_once = max(1, int(MAX_BYTES / (8 * numbers)))
        return np.split(np.arange(len(group.first)), range(at_once, len(group.first), at_once))

    def _linearised(
        self, group: Windows, windows: np.ndarray, sought: np.ndarray, shift: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        k, n = len(sought), len(group.states)
        moved = np.vstack([np.zeros((1, k)), STEP * np.eye(k)[self.moving], np.zeros((n, k))])
        begun = np.vstack([np.zeros((1 + len(self.moving), n)), STATE_STEP * np.eye(n)])
        lanes = len(moved)
        window = np.repeat(windows, lanes)
        values = self.unknowns.values(sought + np.tile(moved, (len(windows), 1)))
        run, p, tau = self.rolled(
            group, window, values, np.repeat(shift, lanes, axis=0) + np.tile(begun, (len(windows), 1))
        )
        own = run.ok.reshape(-1, lanes)
        if not own[:, 0].all():
            raise UsageError(self._refusal(group, run, int(np.flatnonzero(~own[:, 0])[0]) * lanes))
        motions = _Motions(run.q, run.v, p, tau)
        made = self._read(group, window, values, motions).reshape(len(windows), lanes, *group.compared.shape[1:])
        made[~own] = np.broadcast_to(made[:, :1], made.shape)[~own]
        first, others = made[:, 0], made[:, 1:]
        slopes = np.moveaxis((first[:, None] - others), 1, -1)
        by_p = np.zeros((*first.shape, k))
        by_p[..., self.moving] = slopes[..., : len(self.moving)] / STEP
        for j in self.sensing:
            other = np.tile(self.unknowns.values(sought + STEP * np.eye(k)[j]), (len(windows), 1))
            by_p[..., j] = (first - self._read(group, windows, other, motions.every(lanes))) / STEP
        return group.compared[windows] - first, by_p, slopes[..., len(self.moving) :] / STATE_STEP

    def _refusal(self, group: Windows, run: Rollout, lane: int) -> str:
        said = run._line(lane).partition(": ")[2] if lane < len(run.status) else ""
        start = group.first[0] * group.experiment.log.step
        return (
            f"{group.experiment.log.name}: with the numbers that the fit starts from a motion from t = {start:g} s on "
            f"cannot be made: {said or 'it diverged'}; start from other numbers, or raise substeps"
        )


@dataclass(frozen=True, eq=False)
class _Motions:
    """Motions of lanes, with their parameters and inputs."""

    q: np.ndarray
    v: np.ndarray
    p: np.ndarray
    tau: np.ndarray

    def every(self, step: int) -> _Motions:
        """Those of the lanes 0, step, 2 step …"""
        return _Motions(*(x[::step] for x in (self.q, self.v, self.p, self.tau)))


def windows_of(experiment: Experiment, signals: Signals, seconds: float, p: np.ndarray) -> Windows:
    """The windows of an experiment of about so many seconds, whose starts follow from readings at parameters (n,)."""
    cuts = experiment.cut(seconds, 2 * experiment.reach + 1)
    firsts = [first for first, _ in cuts]
    return Windows(experiment, signals, np.array(firsts), cuts[0][1], starts(experiment, signals, firsts, p))
