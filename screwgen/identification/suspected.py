"""Units that look wrong before anything is fitted: of times, by the robot's vibrations; of inputs, by trying others."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..errors import ScrewgenError, UsageError
from ..robot_model import RobotModel
from ..spec.columns import Column
from ..studies.modes import natural_frequencies
from .log_windows import Windows
from .logs import Log
from .odd import FACTORS, POOR
from .problem import MeasuredCases, MotionMethod, Problem
from .unknowns import Unknowns

SAMPLES = 4
"""Samples that the slowest vibration of a robot must have in a log."""
BETTER = 4.0
"""How many times less another unit must leave of the readings to be suspected."""
LOST = 10.0
"""What counts for a window whose motion diverges: so many times the variance of its readings."""


def frequencies(model: RobotModel, p: np.ndarray, q: np.ndarray | None = None) -> tuple[float, ...]:
    """The natural frequencies at parameters (n,) in a posture, Hz; none where there are none to speak of."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return tuple(x for x in natural_frequencies(model, q, parameters=p).tolist() if x > 0)
        except ScrewgenError:  # loads that change with the motion, or a rigid robot
            return ()


def check_steps(model: RobotModel, logs: Sequence[Log]) -> None:
    """Refuses logs whose samples are too far apart to see the robot vibrate, as where times in ms are taken for s."""
    if all(log.static for log in logs):
        return
    slowest = min(frequencies(model, model.chain.parameters.values), default=0.0)
    for log in logs:
        if log.step * slowest > 1 / SAMPLES:
            period = f"the slowest vibration of the robot takes {1 / slowest:.3g} s"
            said = f"samples are {log.step:g} s apart, and {period}: are times in ms?"
            raise UsageError(f"{log.name}: {said} state them in s, or log faster")


def of_gains(model: RobotModel, groups: Sequence[MeasuredCases], how: MotionMethod) -> list[str]:
    """Inputs with which the model of the start explains its log only if they are some 57.3 or 1000 times as large."""
    out = []
    for group in groups:
        if not isinstance(group, Windows) or (left := _left(model, group, how)) < POOR:
            continue
        log = group.experiment.log
        for column in group.experiment.columns.inputs:
            tried = {way: _left(model, _scaled(group, column, way), how) for x in FACTORS for way in (x, 1 / x)}
            best = min(tried, key=lambda way: tried[way])
            if tried[best] < left / BETTER:
                said = f"{best:.3g} times {column.name} explains the readings much better than {column.name}"
                out.append(f"{log.name}: {said}: is its unit or its gain right?")
    return out


def _scaled(group: Windows, column: Column, factor: float) -> Windows:
    """The windows with an input so many times as large."""
    columns = group.experiment.columns
    own = tuple(
        c.model_copy(update={"gain": factor * c.to_si}) if c.name == column.name else c for c in columns.columns
    )
    return replace(group, experiment=replace(group.experiment, columns=columns.model_copy(update={"columns": own})))


def _left(model: RobotModel, group: Windows, how: MotionMethod) -> float:
    """The share of the variance of readings that the model leaves over windows, as the mean over sensors."""
    lanes = np.arange(len(group.first))
    problem, nothing = Problem(model, [group], Unknowns(), how), np.zeros((len(lanes), 0))
    found = group.differences(problem, lanes, nothing, np.zeros((len(lanes), len(group.states))))
    lost = np.isinf(found).any(axis=(1, 2))
    shares = np.full(found.shape[::2], LOST)
    shares[~lost] = np.nanmean(found[~lost] ** 2, axis=1) / group.spread**2
    return float(np.nanmean(np.minimum(shares, LOST)))
