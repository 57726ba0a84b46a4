"""Where logs come from: files, parts of files, runs; and the columns that say what stands in them."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from ..errors import UsageError
from ..robot_model import RobotModel
from ..simulation.runs import Run
from ..spec.columns import Columns, load_columns
from ..spec.load import one_line
from .logged_motion import moved_places
from .logs import Log, constant, counted, head_of, read_log
from .signals import Signals, of_run

PART = re.compile(r"(?P<path>.+)@(?P<start>[-+.\deE]+):(?P<end>[-+.\deE]+)")
"""``log.csv@0:10``: the samples from 0 s to 10 s."""
Source = str | os.PathLike[str] | Log | Run


def several(given: Source | Sequence[Source]) -> list[Source]:
    """The sources, of one or of several."""
    return [given] if isinstance(given, str | os.PathLike | Log | Run) else list(given)


def some(given: Source | Sequence[Source]) -> list[Source]:
    """The sources, of which there is one at least."""
    if not (found := several(given)):
        raise UsageError("there is no log; give one at least")
    return found


def columns_of(model: RobotModel, sensors: Any, first: Source) -> Columns:
    """The columns of the logs, checked against the robot."""
    if isinstance(sensors, Columns):
        columns = sensors
    elif sensors is not None:
        columns = load_columns(sensors)
    else:
        name = first.name if isinstance(first, Log | Run) else one_line(_part(first)[0])
        columns = of_run(model, _head(first), name)
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


def log_of(source: Source, columns: Columns) -> Log:
    if isinstance(source, Run):
        table = dict(zip(source.columns, source.table.T, strict=True))
        return Log(source.name, source.t, table)
    if isinstance(source, Log):
        return counted(source) if columns.static and not source.static else source
    path, start, end = _part(source)
    log = read_log(path, columns, None if start is None or end is None else (start, end))
    return log if start is None or end is None else replace(log.part(start, end), name=one_line(os.fsdecode(source)))


def varying(model: RobotModel, columns: Columns, logs: Sequence[Log]) -> Columns:
    """The columns without sensors that say nothing, as what a planar arm has across its plane."""
    moving = moved_places(model, columns).names(columns)
    silent = {c.name for c in columns.sensors if all(constant(log.columns[c.name]) for log in logs)} - moving
    left = tuple(column for column in columns.columns if column.name not in silent)
    return columns.model_copy(update={"columns": left})
