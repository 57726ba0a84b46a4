"""The numbers that a fit may change: parameters of the robot, numbers of sensors, gains and biases of inputs."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..arguments import choice
from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.columns import Column, Columns
from ..spec.parameters import Parameter, parameters
from .file_numbers import FileNumber, FileNumbers, with_numbers
from .logs import Log
from .sensing import NUMBERS, numbers_of

PARAMETER, SENSOR, INPUT = "parameter", "sensor", "input"
CONSTANT = 1e-3
"""The share of its size by which a column must vary to be no constant."""
NUMBERS_SAID = ("value", "deviation", "low", "high")
FREE = re.compile(
    r"\s*(?P<pattern>\S+?)(?P<together>\s+together)?\s*(?:=\s*(?P<value>[^\s±]+)\s*(?:±|\+-)\s*(?P<deviation>\S+))?"
    r"(?:\s+in\s+(?P<low>\S+?)\s*\.\.\s*(?P<high>\S+))?\s*"
)
"""``PATTERN``, ``PATTERN = value ± deviation`` for a prior, ``PATTERN in low..high`` for bounds; ``PATTERN together``
where all that it names are one number.
"""


@dataclass(frozen=True)
class FreeNumber:
    """A number that is free: where it starts, in which scale it is sought, and between which bounds."""

    name: str
    kind: str
    value: float
    unit: str
    logarithmic: bool
    scale: float
    """Of one that is not logarithmic: the change that counts as large."""
    low: float = -math.inf
    high: float = math.inf
    prior: tuple[float, float] | None = None
    """What is known of it beforehand: a value and its standard deviation."""
    places: tuple[int, ...] = ()
    """Of a parameter its place among all; several where equal ones are one number."""
    of_file: tuple[FileNumber, ...] = ()
    """Of what is no parameter by itself, but gives some: the numbers of the robot file."""
    members: tuple[str, ...] = ()
    """The names of all that are this number."""

    @property
    def owner(self) -> tuple[str, str]:
        """Of a number of a column that column and the number's name."""
        column, _, number = self.name.rpartition(".")
        return column, number

    def sought(self, value: float) -> float:
        """The number in the scale in which it is sought."""
        return math.log(value / self.value) if self.logarithmic else (value - self.value) / self.scale

    def values(self, sought: np.ndarray) -> np.ndarray:
        """The numbers that these are."""
        with np.errstate(over="ignore"):  # an interval without an end
            return self.value * np.exp(sought) if self.logarithmic else self.value + self.scale * sought

    def slope(self, value: float) -> float:
        """How the number changes with what is sought."""
        return abs(value) if self.logarithmic else self.scale


class Unknowns(tuple[FreeNumber, ...]):
    """All that are free, in their order."""

    @property
    def names(self) -> list[str]:
        return [one.name for one in self]

    def values(self, sought: np.ndarray) -> np.ndarray:
        """The numbers (…, k) of what is sought (…, k)."""
        out = np.empty(sought.shape)
        for k, one in enumerate(self):
            out[..., k] = one.values(sought[..., k])
        return out

    @cached_property
    def bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """The least and the largest (k,) of what is sought."""
        return (
            np.array([_sought_bound(one, one.low, -math.inf) for one in self], float),
            np.array([_sought_bound(one, one.high, math.inf) for one in self], float),
        )

    @cached_property
    def priors(self) -> np.ndarray:
        """Of each the value that is known beforehand and its deviation, both as sought, (k, 2), infinite without."""
        out = np.tile([0.0, np.inf], (len(self), 1))
        for k, one in enumerate(self):
            if one.prior:
                out[k] = one.sought(one.prior[0]), one.prior[1] / one.slope(one.prior[0])
        return out


def _sought_bound(one: FreeNumber, value: float, without: float) -> float:
    return without if not math.isfinite(value) else one.sought(value)


# ------------------------------------------------------------------------------ which are free


def unknowns(
    model: RobotModel,
    columns: Columns,
    free: Sequence[str],
    sizes: Mapping[str, float],
    file: FileNumbers | None = None,
) -> Unknowns:
    """Those that patterns name, in which `*` is any text, with priors and bounds where they are stated.

    `sizes`: how much each column varies; `file`: the robot's, whose numbers are known by what they are called there,
    too. Raises UsageError where a pattern names none, or a start makes no sense.
    """
    known = _known(model, columns, sizes)
    found: dict[str, FreeNumber] = {}
    for said in [free] if isinstance(free, str) else free:
        part, own = _named(said, known)
        chosen = [known[name]() for name in own]
        if file is not None:
            chosen += [_of_file(one) for one in file.giving_several(_named(said, file.names)[1])]
        if not chosen:
            choice(part["pattern"], [*known, *(file.names if file else ())], "free: there is no")
        for one in [_united(part["pattern"], chosen)] if part["together"] else chosen:
            found[one.name] = _restricted(one, part)
    if not found:
        raise UsageError("free: nothing is free; name parameters, as free=['arm.EIz', 'arm.joint.*']")
    _once(found.values())
    order = {name: k for k, name in enumerate(known)}
    return Unknowns(sorted(found.values(), key=lambda one: order.get(one.members[0], len(order))))


def unknowns_of_logs(
    model: RobotModel,
    columns: Columns,
    free: str | Sequence[str],
    logs: Sequence[Log],
    file: FileNumbers | None = None,
) -> Unknowns:
    """Those that patterns name, with scales by how much the columns of logs vary; `file` as for :func:`unknowns`.

    Of inputs that are constant, or nearly so, it is how large they are.
    """

    def size(column: Column) -> float:
        values = np.concatenate([log.columns[column.name] for log in logs])
        varies, large = float(np.nanstd(values)), float(np.sqrt(np.nanmean(values**2)))
        return varies if varies > CONSTANT * large else large or 1.0

    sizes = {column.name: size(column) for column in columns.columns}
    return unknowns(model, columns, [free] if isinstance(free, str) else free, sizes, file)


def free_parameters(model: RobotModel, free: Sequence[str], file: FileNumbers) -> list[str]:
    """The numbers of the robot among those that patterns name; see :func:`unknowns`."""
    known = [one.name for one in parameters(model.robot)]
    of_file = [one.name for said in free for one in file.giving_several(_named(said, file.names)[1])]
    return list(dict.fromkeys([name for said in free for name in _named(said, known)[1]] + of_file))


def _united(name: str, several: Sequence[FreeNumber]) -> FreeNumber:
    """One number in place of equal ones."""
    first = several[0]
    for one in several:
        if one.kind != PARAMETER or one.value != first.value:
            what = f"{one.name} is {one.value:g} and {first.name} {first.value:g}"
            said = what if one.kind == PARAMETER else f"{one.name} is no number of the robot"
            raise UsageError(f"free: '{name} together': {said}; together are numbers of the robot that start equal")
    places, members = (tuple(x for one in several for x in getattr(one, key)) for key in ("places", "members"))
    return replace(first, name=name, places=places, members=members, of_file=sum((x.of_file for x in several), ()))


def _once(found: Iterable[FreeNumber]) -> None:
    """Refuses a number that is free twice, by itself and together with others."""
    owner: dict[str, str] = {}
    for one in found:
        for member in one.members:
            if member in owner:
                raise UsageError(f"free: {member} is free twice, as {owner[member]} and as {one.name}; name it once")
            owner[member] = one.name


def _named(said: str, known: Iterable[str]) -> tuple[re.Match[str], list[str]]:
    """What is said of free numbers, in parts, and their names."""
    part = FREE.fullmatch(said)
    if not part:
        ways = "write PATTERN, 'PATTERN = 2.0 ± 0.3' or 'PATTERN in 1..3'"
        raise UsageError(f"free: '{said}' is not understood; {ways}")
    whole = re.compile(".*".join(map(re.escape, part["pattern"].split("*"))))
    return part, [name for name in known if whole.fullmatch(name)]


def _restricted(one: FreeNumber, said: re.Match[str]) -> FreeNumber:
    """The unknown with the prior and the bounds that are stated."""
    try:
        got = {key: float(x) for key in NUMBERS_SAID if (x := said[key]) is not None}
    except ValueError:
        raise UsageError(f"free: '{said[0].strip()}' states no number where one is due") from None
    prior = (got["value"], got["deviation"]) if "value" in got else one.prior
    low, high = max(got.get("low", one.low), one.low), min(got.get("high", one.high), one.high)
    if prior and (prior[1] <= 0 or (one.logarithmic and prior[0] * one.value <= 0)):
        wrong = f"{prior[0]:g} ± {prior[1]:g} is no prior"
        raise UsageError(f"free: {one.name}: {wrong}; state its sign and a deviation > 0")
    if one.logarithmic and math.isfinite(low) and low <= 0 < one.value:
        low = -math.inf
    if not (low <= one.value <= high and low < high):
        raise UsageError(f"free: {one.name} starts at {one.value:g}; it must be within its bounds, {low:g} to {high:g}")
    return replace(one, low=low, high=high, prior=prior)


def _known(model: RobotModel, columns: Columns, sizes: Mapping[str, float]) -> dict[str, Callable[[], FreeNumber]]:
    """What may be free, by name, made when it is asked for."""
    out: dict[str, Callable[[], FreeNumber]] = {}
    for k, one in enumerate(parameters(model.robot)):
        out[one.name] = lambda k=k, one=one: _parameter(k, one)  # type: ignore[misc]
    for column in columns.sensors:
        for name, value in numbers_of(column).items():
            out[f"{column.name}.{name}"] = lambda c=column, n=name, x=value: _of_sensor(c, n, x, sizes[c.name])  # type: ignore[misc]
    for column in columns.inputs:
        size = sizes[column.name]
        out[f"{column.name}.gain"] = lambda c=column: _logarithmic(f"{c.name}.gain", INPUT, c.to_si, "")  # type: ignore[misc]
        out[f"{column.name}.bias"] = lambda c=column, s=size: _linear(f"{c.name}.bias", INPUT, c.bias, c.unit, s)  # type: ignore[misc]
    return out


def _parameter(place: int, one: Parameter) -> FreeNumber:
    """A parameter: by its logarithm, unless it may have either sign."""
    diagonal = one.field == "bodies.inertia" and one.index[-1] < 3
    unit = "" if one.unit == "1" else one.unit
    if one.sign != "any" or (diagonal and one.value > 0):
        return _logarithmic(one.name, PARAMETER, one.value, unit, place)
    scale = max(abs(one.value), SCALES.get(unit, 1.0))
    return FreeNumber(one.name, PARAMETER, one.value, unit, False, scale, places=(place,), members=(one.name,))


def _of_file(one: FileNumber) -> FreeNumber:
    """A number of the robot file that gives several parameters, within the range that it has there."""
    if one.value <= 0:
        raise UsageError(f"free: {one.name} is {one.value:g}, and its logarithm is sought; start from a number > 0")
    low, high = one.range
    return FreeNumber(
        *(one.name, PARAMETER, one.value, one.unit, True, 1.0, low, high), of_file=(one,), members=(one.name,)
    )


SCALES: Mapping[str, float] = {"m": 0.1, "m/s²": 1.0, "kg·m²": 0.01, "rad": 0.1}
"""By unit, changes that count as large of numbers of either sign."""


def _logarithmic(name: str, kind: str, value: float, unit: str, *place: int) -> FreeNumber:
    if value == 0:
        raise UsageError(f"free: {name} is 0, and its logarithm is sought; start from a number that is not")
    return FreeNumber(name, kind, value, unit, True, 1.0, places=place, members=(name,))


def _linear(name: str, kind: str, value: float, unit: str, scale: float, low: float = -math.inf) -> FreeNumber:
    return FreeNumber(name, kind, value, unit, False, scale, low, members=(name,))


def _of_sensor(column: Column, number: str, value: float, size: float) -> FreeNumber:
    name = f"{column.name}.{number}"
    if number == "offset":
        return _linear(name, SENSOR, value, column.unit, size)
    if number == "delay":
        return _linear(name, SENSOR, value, "s", 1e-2, 0.0)
    return _logarithmic(name, SENSOR, value, {"cutoff": "Hz"}.get(number, ""))


def sensor_numbers(unknowns: Unknowns, column: Column, values: np.ndarray) -> dict[str, np.ndarray]:
    """The numbers of a sensor (lanes,) each, of which values (lanes, k) may be free."""
    out = {name: np.full(len(values), x) for name, x in numbers_of(column).items()}
    for k, one in enumerate(unknowns):
        if one.kind == SENSOR and one.owner[0] == column.name and one.owner[1] in NUMBERS:
            out[one.owner[1]] = values[:, k]
    return out


def input_numbers(unknowns: Unknowns, column: Column, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gain and bias of an input (lanes,) each."""
    out = {"gain": np.full(len(values), column.to_si), "bias": np.full(len(values), column.bias)}
    for k, one in enumerate(unknowns):
        if one.kind == INPUT and one.owner[0] == column.name:
            out[one.owner[1]] = values[:, k]
    return out["gain"], out["bias"]


def parameter_rows(model: RobotModel, unknowns: Unknowns, values: np.ndarray) -> np.ndarray:
    """The parameter vectors (lanes, n) with free numbers (lanes, k)."""
    out = np.tile(model.chain.parameters.values, (len(values), 1))
    if of_file := [k for k, one in enumerate(unknowns) if one.of_file]:
        different, lane = np.unique(values[:, of_file], axis=0, return_inverse=True)
        changed = [x for k in of_file for x in unknowns[k].of_file]
        counts = [len(unknowns[k].of_file) for k in of_file]
        rows = [with_numbers(changed, np.repeat(row, counts)) for row in different]
        out = np.array(rows)[lane.ravel()]
    for k, one in enumerate(unknowns):
        for place in one.places:
            out[:, place] = values[:, k]
    return out
