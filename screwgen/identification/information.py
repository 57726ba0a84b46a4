"""How well a motion will tell what is sought: the intervals that a fit of its log is to have."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..robot_model import RobotModel
from ..spec.columns import Columns
from .excited_motions import Motions
from .log_windows import Windows
from .logs import Log
from .problem import MotionMethod, Problem
from .sensing import Start, numbers_of, readings
from .signals import Signals
from .solve import Fit
from .unknowns import Unknowns
from .windows import Experiment, StartState

NOISE = 1e-2
"""The noise of a sensor that states none, over how much it varies in the reference motion."""


@dataclass(frozen=True, eq=False)
class Bench:
    """What measures a robot, and what is sought of it."""

    model: RobotModel
    columns: Columns
    unknowns: Unknowns
    noise: np.ndarray
    """(sensors,): standard deviations, in units of columns."""
    deviation: np.ndarray
    """(nv + nvz,): how well readings say where windows begin."""
    follow: np.ndarray
    """The coordinates that follow from others in loops where windows begin."""
    reach: int
    window: float
    how: MotionMethod

    @cached_property
    def signals(self) -> Signals:
        return Signals(self.model, self.columns.sensors)

    def information(self, made: Motions, lane: int, step: float) -> np.ndarray:
        """(k, k): of what is sought in a log of a motion, starts of windows eliminated."""
        log = log_of_motion(self.signals, self.columns, made, lane, step, self.model.chain.parameters.values)
        experiment = Experiment(self.model, log, self.columns, self.reach)
        cuts = experiment.cut(self.window, 2 * self.reach + 1)
        x = np.hstack([made.q[lane], made.v[lane]])
        begin = [StartState(x[first], self.deviation, self.follow) for first, _ in cuts]
        windows = Windows(experiment, self.signals, np.array([first for first, _ in cuts]), cuts[0][1], begin)
        fit = Fit(Problem(self.model, [windows], self.unknowns, self.how), robust=False)
        at = fit.start(np.zeros(len(self.unknowns)))
        at.noise = self.noise
        R = fit.reduced(at, [windows.linearised(fit.problem, at.sought, at.shift[0])]).R
        return np.asarray(R.T @ R)


def log_of_motion(signals: Signals, columns: Columns, made: Motions, lane: int, step: float, p: np.ndarray) -> Log:
    """What would be logged of a motion without noise."""
    q, v, tau = (x[lane : lane + 1] for x in (made.q, made.v, made.tau))
    found = signals(q, v, tau, p[None])[0]
    table = {}
    for k, column in enumerate(columns.sensors):
        numbers = {name: np.array([x]) for name, x in numbers_of(column).items()}
        first = numbers["scale"] * found[:1, k] + numbers["offset"]
        table[column.name] = np.nan_to_num(
            readings(found[None, :, k], numbers, step, Start(first, 0.0 * first))[0], nan=first[0]
        )
    for column in columns.inputs:
        place = signals.model.tau_names.index(str(column.drives))
        table[column.name] = made.tau[lane][:, place] / column.to_si - column.bias
    return Log("motion", step * np.arange(len(found)), table)
