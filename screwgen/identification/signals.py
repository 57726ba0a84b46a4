"""What sensors would read in given motions: entries of the state, and rows of measurements, on many lanes at once."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..algorithms import felt, fused
from ..algorithms.functions import PLACES
from ..algorithms.gauges import gauges
from ..algorithms.measurement import Attitude, CyclicAngle, Measurement
from ..algorithms.measurement_names import measurement
from ..arguments import choice
from ..errors import UsageError, one_line
from ..ir.program import Program
from ..ir.replay import run
from ..robot_model import RobotModel
from ..simulation.rollout_loops import ARRAYS
from ..simulation.runs import TIP_NAMES
from ..spec.columns import UNITS, Column, Columns

ENTRY = re.compile(r"(?P<row>[^\[\]]+?)(?:\[(?P<entry>\d+)\])?")


@dataclass(frozen=True)
class SensorSignal:
    """What a column measures: an entry of `q`, of `v`, of the tip's place, or of a row of measurements."""

    column: Column
    kind: str
    place: int
    row: Measurement | None = None

    @property
    def accelerates(self) -> bool:
        """Whether it follows from accelerations."""
        return self.row is not None and "vdot" in self.row.inputs

    @property
    def program_name(self) -> str:
        """The name of the program that it is an entry of, none where it is an entry of the state."""
        return self.row.name if self.row is not None else "" if self.kind in "qv" else self.kind


def signal(model: RobotModel, column: Column) -> SensorSignal:
    """What a column measures; raises UsageError where a robot has no such thing."""
    said = column.measures or ""
    for kind, names in (("q", model.q_names), ("v", model.v_names), ("tip_position", TIP_NAMES)):
        if said in names:
            if column.numbers:
                raise UsageError(f"{column.name}: numbers: '{said}' has none; leave them out")
            return SensorSignal(column, kind, names.index(said))
    bases = [f"{model.robot.links[gauge.link].name}.base_strain.{gauge.direction}" for gauge in gauges(model.chain)]
    said = f"strain[{bases.index(said)}]" if said in bases else said
    found = ENTRY.fullmatch(said)
    if not found or "." in found["row"].partition("@")[0]:
        choice(said, (*model.q_names, *model.v_names, *TIP_NAMES, *bases), f"{column.name}: nothing measures")
    assert found
    row = measurement(model.chain, found["row"])
    if isinstance(row, Attitude):
        raise UsageError(f"{column.name}: {row.name} is an attitude, which is not compared yet; leave the column out")
    if isinstance(row, CyclicAngle):
        what = "begins again after a whole turn, which is not compared yet"
        raise UsageError(f"{column.name}: {row.name} {what}; leave the column out")
    size, entry = row.size(model.chain), found["entry"]
    if entry is None and size > 1:
        raise UsageError(f"{column.name}: {said} has {size} entries; name one, as {said}[0]")
    if (place := int(entry or 0)) >= size:
        raise UsageError(f"{column.name}: {found['row']} has {size} entries, so there is no [{place}]")
    _check_numbers(model, column, row)
    return SensorSignal(column, "row", place, row)


def _check_numbers(model: RobotModel, column: Column, row: Measurement) -> None:
    known = {number.keyword: number.size(model.chain) for number in row.numbers if number.stated}
    for name, values in column.numbers.items():
        size = known[choice(name, known, f"{column.name}: numbers: there is no")]
        if len(values) not in (1, size):
            raise UsageError(f"{column.name}: numbers: {name} has {len(values)} entries; it must have 1 or {size}")
    for number in row.numbers:
        if number.zero and not number.start and not any(column.numbers.get(number.keyword, (0.0,))):
            raise UsageError(f"{column.name}: numbers: {number.keyword} {number.zero}")


class Signals:
    """The signals of a log's columns, as functions of motions; arrays (lanes, samples, …)."""

    def __init__(self, model: RobotModel, columns: Sequence[Column]):
        self.model, self.signals = model, [signal(model, column) for column in columns]

    def __call__(
        self, q: np.ndarray, v: np.ndarray, tau: np.ndarray, p: np.ndarray, fields: Sequence[int] | None = None
    ) -> np.ndarray:
        """The values (lanes, samples, columns) in the units of the columns, or those of some of them.

        `tau`: inputs as steps hold them (lanes, samples, n_tau); `p`: parameters (lanes, n).
        """
        chosen = range(len(self.signals)) if fields is None else fields
        found: dict[Any, list[np.ndarray]] = {}
        out = np.empty((*q.shape[:2], len(chosen)))
        for k, j in enumerate(chosen):
            one = self.signals[j]
            if one.kind in ("q", "v"):
                values = (q if one.kind == "q" else v)[..., one.place]
            else:
                key = (one.program_name, tuple(sorted(one.column.numbers.items())))
                if key not in found:
                    found[key] = self._program_values(one, {"q": q, "v": v, "tau": tau}, p)
                values = found[key][one.place]
            out[..., k] = values / UNITS[one.column.unit]
        return out

    def _program_values(self, one: SensorSignal, state: Mapping[str, np.ndarray], p: np.ndarray) -> list[np.ndarray]:
        """The entries of a row, (lanes, samples) each."""
        program = self.model.once(("signal", one.row or one.kind), lambda: self._traced(one.row))
        given: dict[str, list[Any]] = {name: list(np.moveaxis(x, 2, 0)) for name, x in state.items()}
        given |= {"p": list(p.T[..., None]), "w_ext": [0.0] * (6 * self.model.n_links)}
        if "vdot" in program.inputs:
            given["vdot"] = _replayed(self._accelerations, given)["vdot"]
        for number in one.row.numbers if one.row else ():
            size = number.size(self.model.chain)
            if callable(number.start):
                given[number.keyword] = list(number.start(self.model.chain, list(p.T[..., None])))
            else:
                own = one.column.numbers.get(number.keyword, number.starts(self.model.chain))
                given[number.keyword] = list(np.broadcast_to(own, size))
        return [np.broadcast_to(x, state["q"].shape[:2]) for x in _replayed(program, given)["value"]]

    def _traced(self, row: Measurement | None) -> Program:
        """The program of a row, or of the tip's place."""
        chain = self.model.chain
        if row is None:
            body = lambda f, x: {"value": list(f.poses(x["q"])[1][chain.last][1])}  # noqa: E731
            return fused.fuse(chain, "tip", fused.inputs(chain, "q"), body, algorithms=[PLACES])
        sizes = fused.inputs(chain, felt.reads(row, chain)) | {x.keyword: x.size(chain) for x in row.numbers}
        body = lambda f, x: {"value": list(felt.expected(row, f, {name: x[name] for name in sizes}))}  # noqa: E731
        return fused.fuse(chain, row.name, sizes, body, algorithms=row.algorithms)

    @cached_property
    def _accelerations(self) -> Program:
        return fused.forward_dynamics(self.model.chain)


def _replayed(program: Program, given: Mapping[str, list[Any]]) -> dict[str, list[np.ndarray]]:
    with np.errstate(all="ignore"):  # lanes of trials may have left all bounds
        return run(program, {name: given[name] for name in program.inputs}, lambda op, *x: ARRAYS[op](*x))[0]


def of_run(model: RobotModel, head: Sequence[str], log: str) -> Columns:
    """The columns of a log that are named as in runs of `simulate`: coordinates, rates, the tip's place, and inputs."""
    measured = [name for name in (*model.q_names, *model.v_names, *TIP_NAMES) if name in head]
    if not measured:
        known = ", ".join(model.q_names[:3])
        there = f"it has {', '.join(map(one_line, head[:4]))}" if head else "it is empty"
        said = f"{log}: has no column that the robot names, as {known}; {there}"
        raise UsageError(f"{said}; say with sensors what it measures")
    driven = [name for name in model.tau_names if name in head]
    return Columns(
        columns=(*(Column(name=x, measures=x) for x in measured), *(Column(name=x, drives=x) for x in driven))
    )
