"""Windows of a log: readings less what the robot reads in motions that begin near them, and how that changes.

Every column of the Jacobian is a lane of one rollout: of each window one lane as it is, one for every number that
moves the robot, and one for every entry of the state in which it begins.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import UsageError
from ..simulation.rollout import Rollout, rollout
from . import smoothing
from .loop_states import closed
from .problem import STEP, MeasuredCases, Problem
from .sensing import Start, readings
from .signals import Signals
from .unknowns import input_numbers, parameter_rows, sensor_numbers
from .windows import Experiment, StartState, change_between, changed, starts

STATE_STEP = 1e-4
"""The step of differences with states, in their deviations."""
MAX_BYTES = 2**28


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
        """The changes of the state with which a motion may begin otherwise."""
        return np.flatnonzero(np.max([one.deviation for one in self.begin], axis=0) > 0)

    @cached_property
    def compared(self) -> np.ndarray:
        """(W, samples, sensors): the readings that are compared."""
        at = self.first[:, None] + np.arange(self.size)
        return self.experiment.readings[at][..., self.experiment.compared]

    @cached_property
    def stated(self) -> np.ndarray:
        """(sensors,): the deviations of noise, NaN where none is stated."""
        return self.experiment.noise[self.experiment.compared]

    @property
    def names(self) -> list[str]:
        """The sensors that are compared."""
        return [self.experiment.columns.sensors[k].name for k in self.experiment.compared]

    @cached_property
    def spread(self) -> np.ndarray:
        """(sensors,): how much the readings vary."""
        return np.nanstd(self.compared.reshape(-1, self.compared.shape[-1]), axis=0)

    @property
    def step(self) -> float:
        """The time between samples, s."""
        return self.experiment.log.step

    @property
    def posture(self) -> np.ndarray:
        """The coordinates (nq,) with which the first window begins."""
        return self.begin[0].x[: self.experiment.model.nq]

    @cached_property
    def begun(self) -> list[Start]:
        """The readings with which windows begin, of each compared sensor."""
        log, e = self.experiment.log, self.experiment
        own = e.readings[:, e.compared]
        found = [smoothing.smoothed(own, int(first), log.step, e.reach) for first in self.first]
        value, rate = np.array([x.value for x in found]), np.array([x.rate for x in found])
        return [Start(value[:, k], rate[:, k]) for k in range(own.shape[1])]

    def near(self, other: MeasuredCases) -> bool:
        """Whether windows begin where others do, within deviations."""
        assert isinstance(other, Windows)
        pairs = zip(self.begin, other.begin, strict=True)
        chain = self.experiment.model.chain
        return all((np.abs(change_between(chain, b.x, a.x)) <= b.deviation).all() for a, b in pairs)

    def x0(self, window: np.ndarray, shift: np.ndarray, p: np.ndarray) -> np.ndarray:
        """The states (lanes, nq + nvz) in which lanes begin, `shift` (lanes, states) in deviations of these.

        `p` (lanes, n): their parameters, with which loops are closed.
        """
        x, deviation = np.array([b.x for b in self.begin]), np.array([b.deviation for b in self.begin])
        change = np.zeros((len(window), deviation.shape[1]))
        change[:, self.states] = shift * deviation[window][:, self.states]
        x = changed(self.experiment.model.chain, x[window], change)
        for lane, k in enumerate(window):
            if (follow := self.begin[k].follow).size:
                x[lane] = closed(self.experiment.model, x[lane], p[lane], follow)
        return x

    def differences(self, problem: Problem, window: np.ndarray, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        """Readings less what the model reads (lanes, samples, sensors), of lanes of windows; NaN where there is none.

        `window` (lanes,), `sought` (lanes, k), `shift` (lanes, states).
        """
        values = problem.unknowns.values(sought)
        run, p, tau = self.rolled(problem, window, values, shift)
        made = self._read(problem, window, values, _Motions(run.q, run.v, p, tau))
        out = self.compared[window] - made
        out[~run.ok] = np.inf
        return out

    def continued(self, problem: Problem, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        """Other starts (W, states) to try: of each window where the motion of the one before it ends."""
        every, other = np.arange(len(self.first)), shift.copy()
        values = np.tile(problem.unknowns.values(sought), (len(every), 1))
        run, *_ = self.rolled(problem, every, values, shift, self.size)
        ends = np.hstack([run.q[:, -1], run.v[:, -1]])
        for k in every[1:][run.ok[:-1]]:
            begin, own = self.begin[k], self.begin[k].deviation[self.states]
            change = change_between(self.experiment.model.chain, begin.x, ends[k - 1])[self.states]
            other[k] = np.divide(change, own, out=np.zeros_like(own), where=own > 0)
        return other

    def rolled(
        self, problem: Problem, window: np.ndarray, values: np.ndarray, shift: np.ndarray, steps: int | None = None
    ) -> tuple[Rollout, np.ndarray, np.ndarray]:
        """The motions of lanes, their parameters, and their inputs; `steps`: if not those between their samples."""
        e, how = self.experiment, problem.how
        gains = [input_numbers(problem.unknowns, column, values) for column in e.columns.inputs]
        tau = e.tau(self.first[window], self.size, gains)
        p = parameter_rows(problem.model, problem.unknowns, values)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # what is said of single motions is said of the result
            run = rollout(
                problem.model,
                self.x0(window, shift, p),
                tau[:, : self.size - 1 if steps is None else steps],
                step=e.log.step,
                substeps=how.substeps,
                integrator=how.integrator,
                parameters=p,
                threads=how.threads,
            )
        problem.rollouts += len(window)
        return run, p, tau

    def _read(self, problem: Problem, window: np.ndarray, values: np.ndarray, made: _Motions) -> np.ndarray:
        """What sensors read of motions (lanes, samples, sensors)."""
        e = self.experiment
        found = self.signals(made.q, made.v, made.tau, made.p, e.compared)
        for k, sensor in enumerate(e.compared):
            numbers = sensor_numbers(problem.unknowns, e.columns.sensors[sensor], values)
            start = Start(*(x[window] for x in self.begun[k]))
            found[..., k] = readings(found[..., k], numbers, e.log.step, start)
        return found

    def linearised(
        self, problem: Problem, sought: np.ndarray, shift: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Differences (W, samples, sensors), and their derivatives with what is sought and with states, (.., columns).

        `sought` (k,), `shift` (W, states).
        """
        parts = [self._linearised(problem, w, sought, shift[w]) for w in self._chunks(problem)]
        found = tuple(np.concatenate(x) for x in zip(*parts, strict=True))
        return found[0], found[1], found[2]

    def _chunks(self, problem: Problem) -> list[np.ndarray]:
        """Windows that fit into the memory together."""
        lanes = 1 + len(problem.moving) + len(self.states)
        numbers = lanes * self.size * (len(self.begin[0].x) + problem.model.n_tau + 2 * len(self.experiment.compared))
        at_once = max(1, int(MAX_BYTES / (8 * numbers)))
        return np.split(np.arange(len(self.first)), range(at_once, len(self.first), at_once))

    def _linearised(
        self, problem: Problem, windows: np.ndarray, sought: np.ndarray, shift: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        k, n = len(sought), len(self.states)
        moved = np.vstack([np.zeros((1, k)), STEP * np.eye(k)[problem.moving], np.zeros((n, k))])
        begun = np.vstack([np.zeros((1 + len(problem.moving), n)), STATE_STEP * np.eye(n)])
        lanes = len(moved)
        window = np.repeat(windows, lanes)
        values = problem.unknowns.values(sought + np.tile(moved, (len(windows), 1)))
        run, p, tau = self.rolled(
            problem, window, values, np.repeat(shift, lanes, axis=0) + np.tile(begun, (len(windows), 1))
        )
        own = run.ok.reshape(-1, lanes)
        if not own[:, 0].all():
            raise UsageError(self._refusal(run, int(np.flatnonzero(~own[:, 0])[0]) * lanes))
        motions = _Motions(run.q, run.v, p, tau)
        made = self._read(problem, window, values, motions).reshape(len(windows), lanes, *self.compared.shape[1:])
        made[~own] = np.broadcast_to(made[:, :1], made.shape)[~own]
        first, others = made[:, 0], made[:, 1:]
        slopes = np.moveaxis((first[:, None] - others), 1, -1)
        by_p = np.zeros((*first.shape, k))
        by_p[..., problem.moving] = slopes[..., : len(problem.moving)] / STEP
        for j in problem.sensing:
            other = np.tile(problem.unknowns.values(sought + STEP * np.eye(k)[j]), (len(windows), 1))
            by_p[..., j] = (first - self._read(problem, windows, other, motions.every(lanes))) / STEP
        return self.compared[windows] - first, by_p, slopes[..., len(problem.moving) :] / STATE_STEP

    def _refusal(self, run: Rollout, lane: int) -> str:
        said = run._line(lane).partition(": ")[2] if lane < len(run.status) else ""
        start = self.first[0] * self.experiment.log.step
        return (
            f"{self.experiment.log.name}: with the numbers that the fit starts from a motion from t = {start:g} s on "
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
