"""What the columns of a log measure or drive: a table of sensors and inputs (TOML). Every fault is one line."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Annotated, Any, Self

import numpy as np
from pydantic import Field, PlainValidator, model_validator

from ..errors import UsageError
from .load import load_table
from .part import Part
from .values import boolean, non_negative, number, positive, refuse, shown

UNITS: Mapping[str, float] = {
    "SI": 1.0,
    "deg": np.pi / 180,
    "deg/s": np.pi / 180,
    "deg/s^2": np.pi / 180,
    "rpm": np.pi / 30,
    "mm": 1e-3,
    "mm/s": 1e-3,
    "mm/s^2": 1e-3,
    "g": 9.80665,
    "mN.m": 1e-3,
    "kN": 1e3,
    "microstrain": 1e-6,
}
"""What a number in a unit is in SI units."""
TIME = "t"


def _unit(value: Any) -> str:
    if value not in UNITS:
        raise refuse(f"is {shown(value)}; it must be one of {', '.join(UNITS)}")
    return str(value)


def _numbers(value: Any) -> dict[str, tuple[float, ...]]:
    """Numbers of a sensor by name, each one number or an array."""
    if not isinstance(value, dict):
        raise refuse(f"is {shown(value)}; it must be a table of numbers, as {{ fibre = 0.01 }}")
    several = {name: x if isinstance(x, list | tuple) else [x] for name, x in value.items()}
    return {name: tuple(number(x, at=(name,)) for x in entries) for name, entries in several.items()}


Number = Annotated[float, PlainValidator(number)]
Positive = Annotated[float, PlainValidator(positive)]
NonNegative = Annotated[float, PlainValidator(non_negative)]


class LowPass(Part):
    """The filter of a logger: of second order where a damping ratio is stated, else of first; Euler at its samples."""

    cutoff: Positive = Field(description="the cut-off frequency, Hz")
    damping: Positive | None = Field(None, description="the damping ratio of a filter of second order")


class Column(Part):
    """A column of a log: it `measures` something, or it `drives` an input of the robot.

    A sensor reads `scale * value + offset` in its `unit`, through its `filter`, `delay` seconds late, with the standard
    deviation `noise`, which is found from the residuals where it is not stated. An input is `gain * (column + bias)`,
    in SI units.
    """

    name: str = Field(description="the name of the column in the log")
    measures: str | None = Field(None, description="what the column measures, as arm.joint[0] or gyro@arm.tip[2]")
    drives: str | None = Field(None, description="the input that the column is, as arm.torque[0]")
    unit: Annotated[str, PlainValidator(_unit)] = Field("SI", description="the unit of the column")
    noise: Positive | None = Field(None, description="the standard deviation of the noise, in the column's unit")
    scale: Number = Field(1.0, description="the factor of the readings")
    offset: Number = Field(0.0, description="what is added to the readings, in the column's unit")
    delay: NonNegative = Field(0.0, description="how late the readings are, s")
    filter: LowPass | None = Field(None, description="the filter of the logger")
    numbers: Annotated[dict[str, tuple[float, ...]], PlainValidator(_numbers)] = Field(
        {}, description="numbers of the sensor by name, as { fibre = 0.01 }"
    )
    gain: Number | None = Field(None, description="of an input: SI units per unit of the column")
    bias: Number = Field(0.0, description="of an input: what is added to the column, in its unit")

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if (self.measures is None) == (self.drives is None):
            said = "neither measures nor drives" if self.measures is None else "both measures and drives"
            raise refuse(f"{said} something; state one of the two keys", at=("name",))
        sensor = ("noise", "scale", "offset", "delay", "filter", "numbers")
        foreign = ("gain", "bias") if self.measures is not None else sensor
        if wrong := [key for key in foreign if key in self.model_fields_set]:
            kind = "an input" if self.measures is not None else "a sensor"
            raise refuse(f"belongs to {kind}; leave it out", at=(wrong[0],))
        return self

    @property
    def in_time(self) -> str:
        """A key that is stated and says how a reading follows from those before it; empty without."""
        return "filter" if self.filter else "delay" if self.delay else ""

    @property
    def to_si(self) -> float:
        """What one unit of an input is in SI units."""
        return UNITS[self.unit] if self.gain is None else self.gain


class Columns(Part):
    """The columns of a log that are used; others are left alone."""

    time: str = Field(TIME, description="the column of the time, s")
    static: Annotated[bool, PlainValidator(boolean)] = Field(
        False, description="whether each row is the robot at rest, no sample in time; then there is no column of times"
    )
    columns: tuple[Column, ...] = Field(description="the columns, an array of tables [[columns]]")

    @model_validator(mode="after")
    def _once(self) -> Self:
        names = [column.name for column in self.columns]
        for k, name in enumerate(names):
            if name in names[:k]:
                raise refuse(f"'{name}' is stated twice; leave one out", at=("columns", k, "name"))
            if self.static and (key := self.columns[k].in_time):
                raise refuse("belongs to samples in time; leave it out of static shapes", at=("columns", k, key))
        if not any(column.measures for column in self.columns):
            raise refuse("measure nothing; state what one of them measures", at=("columns",))
        return self

    @property
    def sensors(self) -> tuple[Column, ...]:
        """Those that measure."""
        return tuple(column for column in self.columns if column.measures is not None)

    @property
    def inputs(self) -> tuple[Column, ...]:
        """Those that drive."""
        return tuple(column for column in self.columns if column.drives is not None)


def load_columns(path: str | os.PathLike[str]) -> Columns:
    """The table in the TOML file at `path`; raises UsageError, `<file>: <key>: <fault>; <remedy>`."""
    return load_table(Columns, path, UsageError, "a table of columns needs four levels")
