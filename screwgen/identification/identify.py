"""From logs to a model: the numbers of a robot, of its sensors and inputs, that explain what was measured."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import numpy as np

from ..arguments import seconds, whole
from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.columns import Column, Columns
from ..spec.vibrations import Vibrations, VibrationTest
from . import odd
from .beside import cases_of, explained, how_of, vector
from .file_numbers import file_numbers
from .identification import Estimated, Identification
from .logged_motion import moved_places
from .logs import Log, checked, faults
from .problem import MeasuredCases, MotionMethod, Problem
from .solve import INTERRUPTED, Estimate, Fit
from .sources import Source, columns_of, log_of, several, some, varying
from .suspected import check_steps, frequencies, of_gains
from .uncertainty import LOST, Uncertainty, uncertainty
from .unknowns import INPUT, SENSOR, Unknowns, unknowns_of_logs
from .vibration_tests import TestedVibrations, of_frequencies, tested, tests_of
from .words import direction_in_words, pairs

SHORTER, OFF = (10.0, 3.0, 1.0), 0.3
"""How many times shorter windows are, one after the other, where the first fit leaves more than this share of the
variation of a sensor, or does not converge: over a second a fast vibration with wrong numbers may be a period off."""
NOTHING = Columns.model_construct(columns=())
"""The columns where there is no log."""
ROUNDS = 2
"""How often windows are begun anew, from readings that identified numbers of sensors make right."""


def identify(
    model: RobotModel,
    logs: Source | Sequence[Source] = (),
    *,
    free: str | Sequence[str],
    sensors: str | os.PathLike[str] | Columns | None = None,
    held_out: Source | Sequence[Source] = (),
    vibrations: str | os.PathLike[str] | Vibrations | None = None,
    window: float = 1.0,
    integrator: str = "modal_midpoint",
    substeps: int = 1,
    robust: bool = False,
    iterations: int = 40,
    threads: int = 1,
    robot_file: str | os.PathLike[str] | None = None,
    progress: Callable[[str], None] | None = None,
) -> Identification:
    """Identify numbers of a robot, its sensors and its inputs from logs.

    `logs`: CSV or npz files, ``log.csv@0:10`` for a part in seconds, runs of :func:`screwgen.simulate`, or
    :class:`.logs.Log`. `free`: names, or patterns in which ``*`` is any text: of parameters as ``arm.EIz``, of columns
    as ``gauge.offset``, ``scale``, ``delay``, ``cutoff``, of inputs ``current.gain``, ``bias``; ``"arm.EIz = 2 ± 0.3"``
    states a prior, ``"arm.EIz in 1..3"`` bounds; ``"*.EIz together"`` is one number in place of equal ones. With the
    `robot_file` that the model was loaded from, also numbers of the file that give several parameters, as
    ``arm.profile.E``. `sensors`: a TOML table of what columns are, or :class:`.Columns`; without it columns are named
    as in runs; with ``static = true`` rows are the robot at rest, and ``shapes.csv@0:10`` are the first ten.
    `held_out`: logs that are not fitted but compared. `vibrations`: a TOML table of measured natural frequencies and
    damping ratios, or :class:`.Vibrations`, beside logs or alone.

    The logs are cut into windows of about `window` seconds, which begin near smoothed readings. `integrator` and
    `substeps` as :func:`screwgen.rollout` has them, by the step of the log. `robust`: outliers count by their size.
    `progress` is told a line after each iteration. An interruption ends the fit with the best so far.
    Raises UsageError, a line that says what is wrong with a log, a name or a start.
    """
    began = perf_counter()
    hammered = tests_of(vibrations)
    sources, others = several(logs) if hammered[1] else some(logs), several(held_out)
    how = how_of(integrator, substeps, threads)
    whole(iterations, "iterations", 1)
    columns = columns_of(model, sensors, sources[0]) if sources else NOTHING
    read, compared = ([log_of(x, columns) for x in some] for some in (sources, others))
    if sensors is None:
        columns = varying(model, columns, read)
    moving = moved_places(model, columns).names(columns)
    for log in (*read, *compared):
        checked(log, columns, moving)
    window = seconds(window, "window")
    check_steps(model, (*read, *compared))
    file = None if robot_file is None else file_numbers(robot_file, model)
    asked = unknowns_of_logs(model, columns, free, read, file)
    start = [cases_of(model, log, columns, window, model.chain.parameters.values) for log in read]
    suspected = of_frequencies(model, *hammered) + of_gains(model, start, how)
    search = NumberSearch(model, read, hammered, columns, asked, window, robust, iterations, how, progress)
    try:
        fit, at = search.best()
    except UsageError as error:  # under an input a thousand times too large no motion lasts
        raise UsageError("; ".join([str(error), *suspected])) from None
    values, sampled = asked.values(at.sought), [column.name for column in columns.sensors]
    known = uncertainty(fit, at)
    own, p = with_numbers(columns, asked, values), vector(model, asked, values)
    beside = [
        explained(model, log, own, asked, at.sought, how, (window, robust), k >= len(read))
        for k, log in enumerate([*read, *compared])
    ]
    told = (
        suspected
        + (odd.of_inputs(model, columns) if read else [])
        + [line for log in (*read, *compared) for line in faults(log, columns)]
    )
    white = {name: x for name, x in odd.whiteness(fit, at).items() if name in sampled and not columns.static}
    told += (
        odd.of_fit(fit, at)
        + odd.of_whiteness(white)
        + odd.of_shares(beside)
        + odd.of_bounds(asked, at, fit)
        + odd.of_units(beside)
    )
    posture = fit.problem.groups[0].posture
    found = frequencies(model, p, posture)
    if read and not columns.static:
        told += odd.of_filters(model, columns, asked, p, min(found, default=0.0))
        told += odd.of_repetition(read, compared, columns)
    tried: dict[str, float | int | str] = {
        "iterations": len(at.history),
        "rollouts": fit.problem.rollouts,
        "seconds": round(perf_counter() - began, 2),
        "stopped": at.stopped or "converged",
        "weights": "stated" if all(column.noise for column in columns.sensors) else "by the variation of each sensor",
    }
    return Identification(
        model.robot.name,
        tuple(_estimated(asked, at, known, fit, bool(odd.coloured(white)))),
        _parameters(model, asked, p),
        own,
        tuple(beside),
        tuple(direction_in_words(asked, *direction) for direction in known.directions),
        tuple(told),
        white,
        found,
        tried,
        tuple(
            vibration
            for group in fit.problem.groups
            if isinstance(group, TestedVibrations)
            for vibration in group.beside(model.chain.parameters.values, p)
        ),
        pairs(asked, known),
    )


# ------------------------------------------------------------------------------ the fit


@dataclass(frozen=True)
class NumberSearch:
    """What is fitted to which logs, and how."""

    model: RobotModel
    logs: Sequence[Log]
    hammered: tuple[str, tuple[VibrationTest, ...]]
    columns: Columns
    asked: Unknowns
    window: float
    robust: bool
    iterations: int
    how: MotionMethod
    progress: Callable[[str], None] | None

    def best(self) -> tuple[Fit, Estimate]:
        """The fit and its estimate; where it is off or does not converge, that to which shorter windows lead."""
        sought, tried, refused = np.zeros(len(self.asked)), list[tuple[Fit, Estimate]](), UsageError("")
        try:
            tried.append(self.begun_anew(self.window, sought))
            if self._sound(*tried[0]):
                return tried[0]
        except UsageError as error:  # with the numbers of the start no motion lasts so long
            if not self.logs or self.columns.static:
                raise
            refused = error
        history = tried[0][1].history if tried else []
        try:
            for shorter in SHORTER:
                other = self.begun_anew(self.window / shorter, sought)
                sought, history = other[1].sought, history + other[1].history
        except UsageError:  # so few samples are no window, or what they lead to diverges
            if not tried:
                raise refused from None
            return tried[0]
        best = min(*tried, other, key=lambda x: x[0].worst(x[1])) if tried else other
        best[1].history = history
        return best

    def _sound(self, fit: Fit, at: Estimate) -> bool:
        """Whether shorter windows can help no more: a fit that converged and leaves little, or that was interrupted."""
        if not self.logs or self.columns.static or at.stopped == INTERRUPTED:
            return True
        return not at.stopped and fit.worst(at) < OFF

    def begun_anew(self, window: float, sought: np.ndarray) -> tuple[Fit, Estimate]:
        """The fit from some numbers on; where numbers of sensors changed, windows begin anew."""
        model, asked = self.model, self.asked
        history, rollouts, groups = list[float](), 0, list[MeasuredCases]()
        for _ in range(ROUNDS):
            values = asked.values(sought)
            own, p = with_numbers(self.columns, asked, values), vector(model, asked, values)
            before, groups = groups, [cases_of(model, log, own, window, p) for log in self.logs]
            groups += tested(model, *self.hammered, p)
            if before and all(x.near(y) for x, y in zip(groups, before, strict=True)):
                break
            problem = Problem(model, groups, asked, self.how)
            problem.rollouts = rollouts
            fit = Fit(problem, self.robust, self.progress)
            at = fit.run(self.iterations - len(history), sought)
            history += at.history
            sought, rollouts = at.sought, problem.rollouts
            if at.stopped:
                break
        at.history = history
        return fit, at


def with_numbers(columns: Columns, asked: Unknowns, values: np.ndarray) -> Columns:
    """The columns with identified numbers (k,) of sensors and inputs."""
    own: dict[str, dict[str, float]] = {}
    for one, x in zip(asked, values, strict=True):
        if one.kind in (SENSOR, INPUT):
            column, number = one.owner
            own.setdefault(column, {})[number] = float(x)
    return columns.model_copy(update={"columns": tuple(_with(c, own.get(c.name, {})) for c in columns.columns)})


def _with(column: Column, numbers: dict[str, float]) -> Column:
    of_filter: dict[str, Any] = {name: numbers.pop(name) for name in ("cutoff", "damping") if name in numbers}
    update: dict[str, Any] = dict(numbers)
    if of_filter and column.filter is not None:
        update["filter"] = column.filter.model_copy(update=of_filter)
    return column.model_copy(update=update)


# ------------------------------------------------------------------------------ the result


def _parameters(model: RobotModel, asked: Unknowns, p: np.ndarray) -> dict[str, float]:
    """The parameters that were free by name, of all parameters (n,) that were found."""
    places = {place for one in asked for place in one.places}
    if any(one.of_file for one in asked):
        places |= set(np.flatnonzero(p != model.chain.parameters.values).tolist())
    return {model.parameter_names[k]: float(p[k]) for k in sorted(places)}


def _estimated(asked: Unknowns, at: Estimate, known: Uncertainty, fit: Fit, lacking: bool) -> list[Estimated]:
    values, out = asked.values(at.sought), []
    for k, one in enumerate(asked):
        wide = known.quantile[k] * known.deviation[k]
        low, high = sorted(float(one.values(at.sought[k] + sign * wide)) for sign in (-1, 1))
        bound = "low" if at.sought[k] <= fit.low[k] else "high" if at.sought[k] >= fit.high[k] else ""
        sure = bool(known.deviation[k] <= LOST)
        out.append(
            Estimated(
                one.name, one.unit, one.kind, one.value, float(values[k]), low, high, sure, bound, one.members, lacking
            )
        )
    return out
