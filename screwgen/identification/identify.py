"""From logs to a model: the numbers of a robot, of its sensors and inputs, that explain what was measured."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from time import perf_counter
from typing import Any

import numpy as np

from ..arguments import seconds, whole
from ..errors import UsageError
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from ..runtime.differentiated import NO_METHOD
from ..simulation.runs import Run
from ..spec.columns import Column, Columns, load_columns
from ..spec.load import one_line
from . import odd
from .identification import Estimated, Explained, Identification
from .logs import Log, checked, faults, head_of, read_log
from .problem import How, Problem, Windows, windows_of
from .signals import Signals, of_run
from .smoothing import LEAST, SHARE
from .solve import Estimate, Fit
from .uncertainty import NORMAL, VAGUE, Uncertainty, uncertainty
from .unknowns import INPUT, SENSOR, Unknowns, unknowns
from .windows import Experiment
from .words import direction_in_words

PART = re.compile(r"(?P<path>.+)@(?P<start>[-+.\deE]+):(?P<end>[-+.\deE]+)")
"""``log.csv@0:10``: the samples from 0 s to 10 s."""
ROUNDS = 2
"""How often windows are begun anew, from readings that identified numbers of sensors make right."""
Source = str | os.PathLike[str] | Log | Run


def identify(
    model: RobotModel,
    logs: Source | Sequence[Source],
    *,
    free: str | Sequence[str],
    sensors: str | os.PathLike[str] | Columns | None = None,
    held_out: Source | Sequence[Source] = (),
    window: float = 1.0,
    integrator: str = "modal_midpoint",
    substeps: int = 1,
    robust: bool = False,
    iterations: int = 40,
    threads: int = 1,
    progress: Callable[[str], None] | None = None,
) -> Identification:
    """Identify numbers of a robot, its sensors and its inputs from logs.

    `logs`: CSV or npz files, ``log.csv@0:10`` for a part in seconds, runs of :func:`screwgen.simulate`, or
    :class:`.logs.Log`. `free`: names, or patterns in which ``*`` is any text: of parameters as ``arm.EIz``, of columns
    as ``gauge.offset``, ``scale``, ``delay``, ``cutoff``, of inputs ``current.gain``, ``bias``; ``"arm.EIz = 2 ± 0.3"``
    states a prior, ``"arm.EIz in 1..3"`` bounds. `sensors`: a TOML table of what columns are, or :class:`.Columns`;
    without it columns are named as in runs. `held_out`: logs that are not fitted but compared.

    The logs are cut into windows of about `window` seconds, which begin near smoothed readings. `integrator` and
    `substeps` as :func:`screwgen.rollout` has them, by the step of the log. `robust`: outliers count by their size.
    `progress` is told a line after each iteration. An interruption ends the fit with the best so far.
    Raises UsageError, a line that says what is wrong with a log, a name or a start.
    """
    began = perf_counter()
    sources, others = _several(logs), _several(held_out)
    if not sources:
        raise UsageError("identify: there is no log; give one at least")
    method_of(integrator, missing=NO_METHOD)
    how = How(integrator, whole(substeps, "substeps", 1), whole(threads, "threads", 1))
    whole(iterations, "iterations", 1)
    columns = _columns(model, sensors, sources[0])
    read, compared = ([_log(x, columns) for x in some] for some in (sources, others))
    if sensors is None:
        columns = _varying(columns, read)
    for log in (*read, *compared):
        checked(log, columns)
    window = seconds(window, "window")
    asked = _unknowns(model, columns, free, read)
    fit, at = _fitted(model, read, columns, asked, (window, robust, iterations, how), progress)
    values = asked.values(at.sought)
    known = uncertainty(fit, at)
    own, p = with_numbers(columns, asked, values), vector(model, asked, values)
    explained = [
        _explained(model, log, own, asked, at, fit.problem.how, (window, robust), k >= len(read))
        for k, log in enumerate([*read, *compared])
    ]
    told = [line for log in (*read, *compared) for line in faults(log, columns)]
    told += odd.of_fit(fit, at) + odd.of_bounds(asked, at, fit) + odd.of_units(fit, at)
    told += odd.of_filters(model, columns, asked, p, fit.problem.groups[0].begin[0].x[: model.nq])
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
        tuple(_estimated(asked, at, known, fit)),
        {one.name: float(x) for one, x in zip(asked, values, strict=True) if one.place >= 0},
        own,
        tuple(explained),
        tuple(direction_in_words(asked, *direction) for direction in known.directions),
        tuple(told),
        odd.whiteness(fit, at),
        tried,
    )


def _several(given: Source | Sequence[Source]) -> list[Source]:
    return [given] if isinstance(given, str | os.PathLike | Log | Run) else list(given)


# ------------------------------------------------------------------------------ what is given


def _columns(model: RobotModel, sensors: Any, first: Source) -> Columns:
    """The columns of the logs, checked against the robot."""
    if isinstance(sensors, Columns):
        columns = sensors
    elif sensors is not None:
        columns = load_columns(sensors)
    else:
        columns = of_run(model, _head(first))
    for column in columns.inputs:
        if column.drives not in model.tau_names:
            known = ", ".join(model.tau_names[:4])
            raise UsageError(f"{column.name}: drives '{column.drives}', which is no input of the robot; it has {known}")
    Signals(model, columns.sensors)
    return columns


def _head(source: Source) -> Sequence[str]:
    if isinstance(source, Log):
        return ["t", *source.columns]
    return source.columns if isinstance(source, Run) else head_of(_part(source)[0])


def _part(source: str | os.PathLike[str]) -> tuple[str, float | None, float | None]:
    """The file of a log, and from when to when it is used."""
    said = os.fsdecode(source)
    found = PART.fullmatch(said)
    if not found or os.path.exists(said):
        return said, None, None
    try:
        return found["path"], float(found["start"]), float(found["end"])
    except ValueError:
        raise UsageError(f"{said}: the part is not understood; write FILE@START:END in seconds") from None


def _log(source: Source, columns: Columns) -> Log:
    if isinstance(source, Run):
        table = dict(zip(source.columns, source.table.T, strict=True))
        return Log(source.name, source.t, table)
    if isinstance(source, Log):
        return source
    path, start, end = _part(source)
    log = read_log(path, columns)
    return log if start is None or end is None else replace(log.part(start, end), name=one_line(os.fsdecode(source)))


def _varying(columns: Columns, logs: Sequence[Log]) -> Columns:
    """The columns without sensors that say nothing, as what a planar arm has across its plane."""
    silent = {c.name for c in columns.sensors if all(np.ptp(log.columns[c.name]) == 0 for log in logs)}
    left = tuple(column for column in columns.columns if column.name not in silent)
    return Columns(time=columns.time, columns=left)


def _unknowns(model: RobotModel, columns: Columns, free: str | Sequence[str], logs: Sequence[Log]) -> Unknowns:
    of = lambda name: float(np.nanstd(np.concatenate([log.columns[name] for log in logs])))  # noqa: E731
    sizes = {column.name: max(of(column.name), 1e-12) for column in columns.columns}
    return unknowns(model, columns, [free] if isinstance(free, str) else free, sizes)


# ------------------------------------------------------------------------------ the fit


def _experiment(model: RobotModel, log: Log, columns: Columns, window: float) -> Experiment:
    return Experiment(model, log, columns, max(LEAST, round(SHARE * min(window, log.t[-1] - log.t[0]) / log.step)))


def _group(model: RobotModel, log: Log, columns: Columns, window: float, p: np.ndarray) -> Windows:
    return windows_of(_experiment(model, log, columns, window), Signals(model, columns.sensors), window, p)


def _fitted(
    model: RobotModel,
    logs: Sequence[Log],
    columns: Columns,
    asked: Unknowns,
    settings: tuple[float, bool, int, How],
    progress: Callable[[str], None] | None,
) -> tuple[Fit, Estimate]:
    """The fit and its estimate; where numbers of sensors changed, windows begin anew."""
    window, robust, iterations, how = settings
    noise = np.array([np.nan if c.noise is None else c.noise for c in columns.sensors])
    sought, history, rollouts, groups = np.zeros(len(asked)), list[float](), 0, list[Windows]()
    for _ in range(ROUNDS):
        values = asked.values(sought)
        own, p = with_numbers(columns, asked, values), vector(model, asked, values)
        before, groups = groups, [_group(model, log, own, window, p) for log in logs]
        if before and all(x.near(y) for x, y in zip(groups, before, strict=True)):
            break
        problem = Problem(model, groups, asked, how)
        problem.rollouts = rollouts
        fit = Fit(problem, noise[groups[0].experiment.compared], robust, progress)
        at = fit.run(iterations - len(history), sought)
        history += at.history
        sought, rollouts = at.sought, problem.rollouts
        if at.stopped:
            break
    at.history = history
    return fit, at


def vector(model: RobotModel, asked: Unknowns, values: np.ndarray) -> np.ndarray:
    """All parameters (n,) with the identified ones (k,) in place."""
    out = model.chain.parameters.values.copy()
    for one, x in zip(asked, values, strict=True):
        if one.place >= 0:
            out[one.place] = x
    return out


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


def _estimated(asked: Unknowns, at: Estimate, known: Uncertainty, fit: Fit) -> list[Estimated]:
    values, out = asked.values(at.sought), []
    for k, one in enumerate(asked):
        wide = NORMAL * known.deviation[k]
        low, high = sorted(float(one.values(at.sought[k] + sign * wide)) for sign in (-1, 1))
        bound = "low" if at.sought[k] <= fit.low[k] else "high" if at.sought[k] >= fit.high[k] else ""
        sure = bool(known.deviation[k] <= VAGUE)
        out.append(Estimated(one.name, one.unit, one.kind, one.value, float(values[k]), low, high, sure, bound))
    return out


def _explained(
    model: RobotModel,
    log: Log,
    own: Columns,
    asked: Unknowns,
    at: Estimate,
    how: How,
    settings: tuple[float, bool],
    held_out: bool,
) -> Explained:
    """A log beside the identified model, in one run and over windows, and beside the model of the start."""
    p, (window, robust) = vector(model, asked, asked.values(at.sought)), settings
    experiment, signals = _experiment(model, log, own, window), Signals(model, own.sensors)
    run = windows_of(experiment, signals, log.t[-1] - log.t[0], p)
    problem = Problem(model, [run], asked, how)
    both = np.vstack([at.sought, np.zeros_like(at.sought)])
    lanes = np.zeros(2, int)
    whole, before = problem.differences(run, lanes, both, np.zeros((2, len(run.states))))
    cut = windows_of(experiment, signals, window, p)
    nothing = np.full(len(experiment.compared), np.nan)
    found = Fit(Problem(model, [cut], asked, how, fixed=True), nothing, robust).begun(at.sought).differences[0]
    readings = run.compared[0]
    windows = np.full_like(readings, np.nan)
    for first, part in zip(cut.first, found, strict=True):
        windows[first : first + cut.size] = readings[first : first + cut.size] - part
    names = tuple(own.sensors[k].name for k in run.experiment.compared)
    t = log.t[: len(readings)]
    return Explained(log.name, held_out, t, names, readings, readings - whole, readings - before, windows, cut.first)
