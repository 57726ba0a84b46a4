"""Logs beside a model: what it reads in their motions, in one run and window by window."""

from __future__ import annotations

import os
from collections.abc import Sequence

import numpy as np

from ..arguments import seconds, whole
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from ..runtime.differentiated import NO_METHOD
from ..spec.columns import Columns
from .identification import Explained
from .log_windows import Windows, windows_of
from .logged_motion import moved_places
from .logs import Log, checked
from .problem import MeasuredCases, MotionMethod, Problem
from .signals import Signals
from .smoothing import LEAST, SHARE
from .solve import Fit
from .sources import Source, columns_of, log_of, some, varying
from .static_shapes import beside_rest, shapes_of
from .unknowns import Unknowns, parameter_rows
from .windows import Experiment


def compare(
    model: RobotModel,
    logs: Source | Sequence[Source],
    *,
    sensors: str | os.PathLike[str] | Columns | None = None,
    window: float = 1.0,
    integrator: str = "modal_midpoint",
    substeps: int = 1,
    threads: int = 1,
) -> tuple[Explained, ...]:
    """Logs beside a model as it is; arguments as of :func:`screwgen.identify`, of which nothing is free."""
    sources = some(logs)
    how, nothing = how_of(integrator, substeps, threads), Unknowns()
    columns = columns_of(model, sensors, sources[0])
    settings = seconds(window, "window"), False
    read = [log_of(x, columns) for x in sources]
    if sensors is None:
        columns = varying(model, columns, read)
    for log in read:
        checked(log, columns, moved_places(model, columns).names(columns))
    return tuple(explained(model, log, columns, nothing, np.zeros(0), how, settings, True) for log in read)


def how_of(integrator: str, substeps: int, threads: int) -> MotionMethod:
    """How motions are made; raises UsageError where there is no such way."""
    method_of(integrator, missing=NO_METHOD)
    return MotionMethod(integrator, whole(substeps, "substeps", 1), whole(threads, "threads", 1))


def _experiment(model: RobotModel, log: Log, columns: Columns, window: float) -> Experiment:
    return Experiment(model, log, columns, max(LEAST, round(SHARE * min(window, log.t[-1] - log.t[0]) / log.step)))


def cases_of(model: RobotModel, log: Log, columns: Columns, window: float, p: np.ndarray) -> MeasuredCases:
    """The cases of a log: its shapes, or windows whose starts follow from its readings at parameters (n,)."""
    if columns.static:
        return shapes_of(model, log, columns)
    return windows_of_log(model, log, columns, window, p)


def windows_of_log(model: RobotModel, log: Log, columns: Columns, window: float, p: np.ndarray) -> Windows:
    """The windows of a log, whose starts follow from its readings at parameters (n,)."""
    return windows_of(_experiment(model, log, columns, window), Signals(model, columns.sensors), window, p)


def vector(model: RobotModel, asked: Unknowns, values: np.ndarray) -> np.ndarray:
    """All parameters (n,) with the identified ones (k,) in place."""
    return parameter_rows(model, asked, values[None])[0]


def explained(
    model: RobotModel,
    log: Log,
    own: Columns,
    asked: Unknowns,
    sought: np.ndarray,
    how: MotionMethod,
    settings: tuple[float, bool],
    held_out: bool,
) -> Explained:
    """A log beside the model of what was found, in one run and over windows, and beside the model of the start.

    The run begins as the first window does.
    """
    p, (window, robust) = vector(model, asked, asked.values(sought)), settings
    if own.static:
        return beside_rest(model, log, own, asked, sought, how, held_out)
    experiment, signals = _experiment(model, log, own, window), Signals(model, own.sensors)
    cut, run = (windows_of(experiment, signals, x, p) for x in (window, log.t[-1] - log.t[0]))
    found = Fit(Problem(model, [cut], asked, how, fixed=True), robust).begun(sought)
    problem = Problem(model, [run], asked, how)
    both = np.vstack([sought, np.zeros_like(sought)])
    change, size = np.zeros(len(run.begin[0].deviation)), run.begin[0].deviation[run.states]
    change[cut.states] = found.shift[0][0] * cut.begin[0].deviation[cut.states]
    begun = np.tile(change[run.states] / size, (2, 1))
    whole, before = run.differences(problem, np.zeros(2, int), both, begun)
    readings = run.compared[0]
    windows = np.full_like(readings, np.nan)
    for first, part in zip(cut.first, found.differences[0], strict=True):
        windows[first : first + cut.size] = readings[first : first + cut.size] - part
    t = log.t[: len(readings)]
    return Explained(
        log.name, held_out, t, tuple(run.names), readings, readings - whole, readings - before, windows, cut.first
    )
