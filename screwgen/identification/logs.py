"""Logs: tables of what was measured, from CSV and npz files, and what is wrong with them in one line each."""

from __future__ import annotations

import csv
import os
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import BinaryIO

import numpy as np

from ..errors import UsageError
from ..files import open_regular
from ..simulation.input_table import refuse_separators
from ..simulation.runs import ARRAYS, NAMES, TIP_NAMES, run_arrays, suffix
from ..spec.columns import Column, Columns
from ..spec.load import one_line

UNEVEN = 1e-2
"""By how much of a sample the steps of time may differ."""
GAPS = 0.2
"""The share of readings of a sensor that may be missing."""
MOST_TURNED = 12.0
"""rad: a joint that reads more may be meant in degrees."""
STAY, SUDDEN, QUANTA = 5, 0.3, 3
"""A sensor is saturated that stays so many samples at an end of its range, and comes there by steps that are more than
this share of its usual ones, and more than so many of its least ones: an encoder that stops comes there by one."""
NAMED = 12
"""Columns that are named of a log that lacks one."""
CHUNK, MOST_ROWS = 50_000, 1_000_000
"""Rows of a table that are read together, and that a log may have."""
LEAST = 20
"""Samples that a log must have."""


@dataclass(frozen=True, eq=False)
class Log:
    """A table of measurements: times `t` (N,), s, evenly spaced, and columns (N,) by name, NaN where none was made."""

    name: str
    t: np.ndarray
    columns: Mapping[str, np.ndarray]
    static: bool = False
    """Whether rows are static shapes: `t` counts them from 0, as if one were taken every second."""

    @property
    def step(self) -> float:
        """The time between samples, s."""
        return 1.0 if self.static else float((self.t[-1] - self.t[0]) / (len(self.t) - 1))

    def __len__(self) -> int:
        return len(self.t)

    def part(self, start: float, end: float) -> Log:
        """The samples from a time to another, s, the end excluded."""
        if len(self) < 2 and not self.static:
            ahead = f"{self.name}: has {len(self)} samples from {start:g} to {end:g} s"
            raise UsageError(f"{ahead}; name a part of the log, {LEAST} samples or more")
        chosen = (self.t >= start - self.step / 2) & (self.t < end - self.step / 2)
        least, unit, rows = (1, "", "rows") if self.static else (LEAST, " s", "samples")
        if (found := chosen.sum()) < least:
            raise UsageError(f"{self.name}: has {found} {rows} from {start:g} to {end:g}{unit}; {least} are needed")
        return replace(self, t=self.t[chosen], columns={name: x[chosen] for name, x in self.columns.items()})


def head_of(path: str | os.PathLike[str]) -> list[str]:
    """The names of the columns of a log."""
    if suffix(path) == ".npz":
        return list(_npz_columns(path))
    with _opened(path) as stream:
        line = stream.readline(1 << 20)
    head = [x.strip() for x in next(csv.reader([line.decode("utf-8-sig", "replace")]), [])]
    refuse_separators(one_line(os.fsdecode(path)), head)
    return head


Span = tuple[float, float]
"""From when to when a log is used, s, the end excluded."""


def read_log(path: str | os.PathLike[str], columns: Columns, span: Span | None = None) -> Log:
    """The log in a file: CSV with a head, or npz with an array for each column, or as `simulate` writes.

    Of a CSV file the rows of a `span` alone are kept.

    Raises UsageError, `<file>: <fault>; <remedy>`, where it cannot be read or a column is missing.
    """
    file = one_line(os.fsdecode(path))
    names = [column.name for column in columns.columns]
    wanted = names if columns.static else [columns.time, *names]
    if suffix(path) == ".npz":
        found = _npz_columns(path)
    else:
        found = _csv_columns(path, file, wanted, None if columns.static else span)
    _check_names(file, wanted, found)
    own = {name: found[name] for name in names}
    return counted(Log(file, np.zeros(0), own)) if columns.static else Log(file, found[columns.time], own)


def _check_names(name: str, wanted: Sequence[str], there: Iterable[str]) -> None:
    """Refuses a log without a column that is wanted."""
    there = list(there)
    for column in wanted:
        if column not in there:
            asked, some = (", ".join(map(one_line, names[:NAMED])) for names in (wanted, there))
            gone = f"has no column '{one_line(column)}'; it has {some or 'none'}"
            raise UsageError(f"{name}: {gone}; wanted are {asked}: name them so, or state other names with sensors")


def counted(log: Log) -> Log:
    """The rows of a table as static shapes."""
    return replace(log, t=np.arange(float(max((len(x) for x in log.columns.values()), default=0))), static=True)


def checked(log: Log, columns: Columns, moving: Collection[str] = ()) -> Log:
    """The log, if its times are even and its columns can be used; raises UsageError.

    A sensor that always reads the same says nothing, but those that are `moving` the robot say that it stands still.
    """
    if not len(log):
        raise UsageError(f"{log.name}: has no rows; give one at least")
    if not log.static:
        _check_times(log, columns.time)
    _check_names(log.name, [column.name for column in columns.columns], log.columns)
    for column in columns.columns:
        if len(values := log.columns[column.name]) != len(log):
            raise UsageError(f"{log.name}: {column.name} has {len(values)} entries; it must have {len(log)}, as t")
        (_check_sensor if column.measures else _check_input)(log, column, values)
        if column.measures and not log.static and column.name not in moving and constant(values):
            said = f"{column.name} is {np.nanmin(values):g} throughout and says nothing"
            raise UsageError(f"{log.name}: {said}; leave it out")
    return log


def _check_times(log: Log, name: str) -> None:
    if len(log) < LEAST:
        raise UsageError(f"{log.name}: has {len(log)} rows; {LEAST} at least are needed")
    if (bad := np.flatnonzero(~np.isfinite(log.t))).size:
        raise UsageError(f"{log.name}: row {bad[0] + 1}: {name} is no finite number; give every row its time")
    steps = np.diff(log.t)
    if (back := np.flatnonzero(steps <= 0)).size:
        at = f"row {back[0] + 2}: {name} is {log.t[back[0] + 1]:g} s"
        raise UsageError(f"{log.name}: {at}; it must be later than in the row before, cut the log there")
    usual = float(np.median(steps))
    if (uneven := np.flatnonzero(np.abs(steps - usual) > UNEVEN * usual)).size:
        at = f"row {uneven[0] + 2}: the step is {steps[uneven[0]]:g} s, others are {usual:g} s"
        raise UsageError(f"{log.name}: {at}; resample the log to even steps, or cut it at gaps")


def _check_input(log: Log, column: Column, values: np.ndarray) -> None:
    if (bad := np.flatnonzero(~np.isfinite(values))).size:
        said = f"row {bad[0] + 1}: {column.name} is no finite number"
        raise UsageError(f"{log.name}: {said}; an input must be known at every sample, cut the log there")


def _check_sensor(log: Log, column: Column, values: np.ndarray) -> None:
    gone = np.count_nonzero(~np.isfinite(values))
    if len(values) - gone < max(1, (1 - GAPS) * len(values)):
        missing = f"{gone} of {len(values)} readings"
        raise UsageError(f"{log.name}: {column.name} lacks {missing}; leave the column out, or cut the log")


def constant(values: np.ndarray) -> bool:
    """Whether the readings (N,) that were made are one; a column without rows is refused elsewhere."""
    there = values[np.isfinite(values)]
    return bool(there.size and there.min() == there.max())


def faults(log: Log, columns: Columns) -> list[str]:
    """What is odd of a log that can be used all the same, a line each."""
    out = []
    for column in columns.sensors:
        values = log.columns[column.name]
        there = values[np.isfinite(values)]
        far, turns = np.abs(there).max(), column.unit in ("SI", "rad") and ".joint[" in str(column.measures)
        if turns and far > MOST_TURNED:
            out.append(f"{log.name}: {column.name} reads up to {far:.4g} rad: degrees? state its unit")
        if gone := len(values) - len(there):
            out.append(f"{log.name}: {column.name} lacks {gone} of {len(values)} readings; the others are used")
        out += [
            f"{log.name}: {column.name} seems saturated at {end:g}, where it stops suddenly; cut these samples out"
            for end in (there.min(), there.max())
            if not log.static and _saturated(there, end)
        ]
    return out


def _saturated(values: np.ndarray, end: float) -> bool:
    """Whether readings stay at an end of their range and come there suddenly; what comes to rest comes slowly."""
    stays = np.convolve(values == end, np.ones(STAY), "valid") == STAY
    begins = np.flatnonzero(stays[1:] & ~stays[:-1])
    steps = np.abs(np.diff(values))
    usual = max(SUDDEN * np.sqrt(np.mean(steps**2)), QUANTA * np.min(steps[steps > 0], initial=np.inf))
    return bool(len(begins)) and bool(np.median(steps[begins]) > usual)


# ------------------------------------------------------------------------------ files


def _opened(path: str | os.PathLike[str]) -> BinaryIO:
    try:
        return open_regular(path)
    except (OSError, ValueError) as error:
        file, why = one_line(os.fsdecode(path)), getattr(error, "strerror", None) or str(error)
        raise UsageError(f"{file}: cannot be read ({one_line(why)}); check path and permissions") from None


def _csv_columns(
    path: str | os.PathLike[str], file: str, wanted: Sequence[str], span: Span | None
) -> dict[str, np.ndarray]:
    """The columns of a CSV file that are wanted, the first one the time; what is no number is NaN."""
    head = head_of(path)
    for name in wanted:
        if head.count(name) > 1:
            raise UsageError(f"{file}: column '{one_line(name)}' is there {head.count(name)} times; leave one")
    there = [name for name in dict.fromkeys(wanted) if name in head]
    if not there:
        return {name: np.empty(0) for name in head}
    with _opened(path) as stream:
        try:
            stream.readline()
            places = [head.index(x) for x in there]
            table = _rows(stream, places, len(head), file, span if wanted[0] in head else None)
        except (ValueError, UnicodeDecodeError) as error:
            why = one_line(" ".join(str(error).split())[:120])
            raise UsageError(
                f"{file}: is no table ({why}); write a head, and numbers with commas between them"
            ) from None
    return dict(zip(there, table.reshape(-1, len(there)).T, strict=True)) | {
        name: np.empty(0) for name in head if name not in there
    }


def _rows(stream: BinaryIO, places: list[int], width: int, file: str, span: Span | None) -> np.ndarray:
    """The rows (N, columns) of a table, of which few are in memory as text; those of a span in the first column.

    `width`: columns of the head.
    """
    parts, number, read = [np.empty((0, len(places)))], 0, 0
    while lines := [x for x in islice(stream, CHUNK) if x.strip()]:
        if sum(line.count(b",") for line in lines) != len(lines) * (width - 1):
            _check_width(lines, width, file, read)
        read += len(lines)
        rows = _numbers(lines, places)
        if span is not None:
            t, margin = rows[:, 0], 1e-6 * (span[1] - span[0])
            over = bool(t[0] > span[1] + margin)
            rows = rows[~(t < span[0] - margin) & ~(t > span[1] + margin)]  # a time that is no number stays and is told
            if over and number:
                break
        number += len(rows)
        if number > MOST_ROWS:
            remedy = f"name a part, as {file}@0:10, or keep every tenth sample"
            raise UsageError(f"{file}: has more than {MOST_ROWS} rows, which no fit needs; {remedy}")
        parts.append(rows)
    return np.concatenate(parts)


def _numbers(lines: list[bytes], places: list[int]) -> np.ndarray:
    """The cells (N, columns) of rows, NaN where there is no number; quicker where all are."""
    try:
        return np.loadtxt(lines, delimiter=",", usecols=places, ndmin=2, encoding="utf-8")
    except ValueError:
        found = np.genfromtxt(lines, delimiter=",", usecols=places, ndmin=2, encoding="utf-8")
        return np.asarray(found.reshape(-1, len(places)))


def _check_width(lines: Sequence[bytes], width: int, file: str, read: int) -> None:
    """Refuses a row with fewer columns than the head, or with more that are not empty; `read`: rows before these."""
    for k, line in enumerate(lines):
        if line.lstrip().startswith(b"#"):
            continue
        least, most = line.rstrip(b", \r\n").count(b",") + 1, line.count(b",") + 1
        if not least <= width <= most:
            said = f"row {read + k + 1} has {most} columns, the head {width}"
            raise UsageError(f"{file}: {said}; give every row as many, and write decimals with points")


def _npz_columns(path: str | os.PathLike[str]) -> dict[str, np.ndarray]:
    """The columns of an npz file: arrays (N,) by name, and the columns of arrays of a run by their names."""
    out: dict[str, np.ndarray] = {}
    with run_arrays(path) as arrays:
        for key in arrays:
            if key in NAMES or key in ("robot", "parameters", "ended", "quantity_names", "quantity_units"):
                continue
            values = arrays.numbers(key)
            names = f"{key}_names"
            if values.ndim == 1:
                out[key] = values
            elif names in arrays and key in ARRAYS:
                out |= dict(zip(arrays.texts(names), values.reshape(len(values), -1).T, strict=False))
            elif key == "tip_position":
                out |= dict(zip(TIP_NAMES, values.T, strict=True))
    return out
