"""The file of a motion that is to be planned (TOML). Every fault is one line."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, PlainValidator

from ..errors import RobotFileError
from .load import load_table, one_line
from .mpc import whole
from .part import Part
from .values import array, non_negative, number, positive, refuse, shown

INTERVALS, LEAST, LARGEST = 24, 4, 200
"""Of the time of a plan: as many as are taken, the fewest and the most."""
SHORTEST = "shortest"


def _numbers(value: Any) -> tuple[float, ...]:
    return tuple(number(x, at=(i,)) for i, x in enumerate(array(value, "an array of numbers, one per joint")))


def _positives(value: Any) -> tuple[float, ...]:
    return tuple(positive(x, at=(i,)) for i, x in enumerate(array(value, "an array of numbers > 0, one per joint")))


def _efforts(value: Any) -> tuple[float, ...]:
    return tuple(
        non_negative(x, at=(i,)) for i, x in enumerate(array(value, "an array of numbers >= 0, one per joint"))
    )


def _time(value: Any) -> float | str:
    if isinstance(value, str) and value != SHORTEST:
        raise refuse(f'is {shown(value)}; it must be a number of s, or "{SHORTEST}"')
    return SHORTEST if value == SHORTEST else positive(value)


def _models(value: Any) -> tuple[dict[str, float], ...]:
    return tuple(_factors(x, i) for i, x in enumerate(array(value, "an array of tables of factors")))


def _factors(value: Any, i: int) -> dict[str, float]:
    if not isinstance(value, dict):
        raise refuse(f'is {shown(value)}; it must be a table of factors, as {{ "*.bodies[0].mass" = 1.3 }}', (i,))
    return {name: number(x, at=(i, name)) for name, x in value.items()}


def _named(value: Any) -> dict[str, float]:
    if not isinstance(value, dict):
        raise refuse(f'is {shown(value)}; it must be a table of names and numbers, as {{ "*.base_strain.*" = 0.02 }}')
    return {name: positive(x, at=(name,)) for name, x in value.items()}


def _tip(value: Any) -> tuple[float, ...]:
    place = _numbers(value)
    if len(place) != 3:
        raise refuse(f"has {len(place)} numbers; a place in the world has 3, m")
    return place


def _through(value: Any) -> tuple[dict[str, Any], ...]:
    for i, point in enumerate(array(value, "an array of tables { q = [...] }")):
        if not (isinstance(point, dict) and "q" in point and set(point) <= {"q", "t"}):
            raise refuse(f"is {shown(point)}; it must be a table as {{ q = [0.3], t = 0.5 }}, t may be left out", (i,))
    return tuple(
        {"q": _numbers(x["q"])} | ({"t": positive(x["t"], at=(i, "t"))} if "t" in x else {})
        for i, x in enumerate(value)
    )


Joints = Annotated[tuple[float, ...], PlainValidator(_numbers)]
Efforts = Annotated[tuple[float, ...], PlainValidator(_efforts)]
Sizes = Annotated[tuple[float, ...], PlainValidator(_positives)]

Named = Annotated[dict[str, float], PlainValidator(_named)]


class PlanLimits(Part):
    """Limits of a motion beside those of the robot file."""

    lower: Joints | None = Field(None, description="least joint coordinates, rad, of slides m")
    upper: Joints | None = Field(None, description="largest joint coordinates, rad, of slides m")
    rates: Sizes | None = Field(None, description="largest joint rates, rad/s, of slides m/s, of either sign")
    efforts: Efforts | None = Field(
        None, description="largest efforts of drives, N·m, of slides and cylinders N; 0 where there is no drive"
    )
    effort_rates: Sizes | None = Field(None, description="largest rates of efforts, N·m/s, of slides and cylinders N/s")
    strains: Named | None = Field(
        None, description="largest strains by names or patterns, in 1/m; of stretch without unit"
    )
    wrenches: Named | None = Field(None, description="largest joint wrenches by names or patterns, in N·m or N")


class PlanFile(Part):
    """A motion from rest to rest."""

    start: Joints = Field(description="joint coordinates at the start, rad, of slides m")
    goal: Joints | None = Field(None, description="joint coordinates at the goal, rad, of slides m")
    goal_tip: Annotated[tuple[float, ...] | None, PlainValidator(_tip)] = Field(
        None, description="in place of goal: where the last tip rests there, m, in the world"
    )
    through: Annotated[tuple[dict[str, Any], ...], PlainValidator(_through)] = Field(
        (), description="joint coordinates q that are passed between; where the time is stated also t in s"
    )
    time: Annotated[float | str, PlainValidator(_time)] = Field(
        description='the time that the motion takes, s, or "shortest"'
    )
    gains: str | None = Field(None, description="the file of the joint law under which the plan is played")
    intervals: Annotated[int, PlainValidator(whole(LEAST, LARGEST))] = Field(
        INTERVALS, description="into how many intervals the search divides the time"
    )
    limits: PlanLimits = Field(PlanLimits(), description="limits of the motion")
    models: Annotated[tuple[dict[str, float], ...], PlainValidator(_models)] = Field(
        (), description="factors of parameters, by names or patterns, of further models that are to rest too"
    )


def read_task(path: str | os.PathLike[str]) -> tuple[PlanFile, str | None]:
    """What a file asks for, and where its law is, relative to the file; raises RobotFileError, one line."""
    found = load_table(PlanFile, path, RobotFileError)
    if (found.goal is None) == (found.goal_tip is None):
        raise RobotFileError(f"{one_line(os.fsdecode(path))}: goal, goal_tip: state one of them")
    return found, None if found.gains is None else str(Path(path).parent / found.gains)
