"""Tables over time: CSV files of `t` and of numbers by their names; as inputs torques, forces and tensions."""

from __future__ import annotations

import csv
import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NoReturn

import numpy as np

from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.load import one_line
from ..spec.messages import unknown
from .state import read_text

TIME = "t"


@dataclass(frozen=True, eq=False)
class InputTable:
    """Inputs (n_tau,) as a controller: linear between the times `t` (k,), s, of `values` (k, n_tau), else held."""

    t: np.ndarray
    values: np.ndarray

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return np.array([np.interp(t, self.t, column) for column in self.values.T])


def read_inputs(path: str | os.PathLike[str], model: RobotModel) -> InputTable:
    """The inputs in the CSV file at `path`, whose head names `t`, s, and some of `model.tau_names`; others are zero.

    Raises UsageError, as :func:`read_table`.
    """
    t, columns = read_table(path, model.tau_names)
    return InputTable(t, np.transpose([columns.get(name, np.zeros(len(t))) for name in model.tau_names]))


def read_table(path: str | os.PathLike[str], names: Sequence[str]) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Times (k,), s, rising, and columns (k,) by their names in the CSV file at `path`, which has `t` and some `names`.

    Raises UsageError, `<file>: line <number>: <fault>; <what is allowed>`.
    """
    file, known = one_line(os.fsdecode(path)), (TIME, *names)
    try:
        rows = list(csv.reader(read_text(path, "a CSV file").splitlines(), strict=True))
    except csv.Error as error:
        raise UsageError(f"{file}: is no table ({error}); write numbers with commas between them") from None
    lines = [(number, [x.strip() for x in row]) for number, row in enumerate(rows, 1) if row]
    if len(lines) < 2:
        raise UsageError(f"{file}: has no rows; write a head, {','.join(known[:3])}, and a row for every time")
    (_, head), *lines = lines
    refuse_separators(file, head)
    for name in head:
        if name not in known:
            raise UsageError(f"{file}: column '{one_line(name)}' {unknown(name, known)}")
        if head.count(name) > 1:
            raise UsageError(f"{file}: column '{name}' is there {head.count(name)} times; leave one")
    if TIME not in head:
        raise UsageError(f"{file}: has no column '{TIME}'; state the times in s")
    table = np.array([_numbers(file, number, head, row) for number, row in lines])
    columns = dict(zip(head, table.T, strict=True))
    t = columns.pop(TIME)
    if (wrong := np.flatnonzero(np.diff(t) <= 0)).size:
        _refuse(file, lines[wrong[0] + 1][0], f"t is {t[wrong[0] + 1]:g} s; it must be later than in the row before")
    return t, columns


def refuse_separators(file: str, head: Sequence[str]) -> None:
    """Refuse a head whose names are not apart by commas."""
    for apart, said in ((";", "semicolons"), ("\t", "tabs")):
        if len(head) == 1 and apart in head[0]:
            raise UsageError(f"{file}: has {said} between its columns; write commas, and decimals with a point")


def _numbers(file: str, number: int, head: Sequence[str], row: Sequence[str]) -> list[float]:
    """The numbers of a row, all finite."""
    if len(row) != len(head):
        _refuse(file, number, f"has {len(row)} entries; it must have {len(head)}, as the head")
    out = []
    for name, text in zip(head, row, strict=True):
        try:
            out.append(float(text))
        except ValueError:
            out.append(math.nan)
        if not math.isfinite(out[-1]):
            _refuse(file, number, f"{name} is '{one_line(text)}'; it must be a finite number")
    return out


def _refuse(file: str, number: int, said: str) -> NoReturn:
    raise UsageError(f"{file}: line {number}: {said}")
