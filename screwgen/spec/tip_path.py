"""The file of a path of the tip by its shape (TOML). Every fault is one line."""

from __future__ import annotations

import math
import os
from typing import Annotated, Any

from pydantic import Field, PlainValidator

from ..errors import RobotFileError
from .load import load_table, one_line
from .part import Part
from .values import number, numbers, positive, refuse

OFF = 1e-6
"""By the radius: how far the start of a circle may be out of its plane."""


def _place(value: Any) -> tuple[float, ...]:
    return numbers(value, 3)


def _direction(value: Any) -> tuple[float, ...]:
    axis = numbers(value, 3)
    if not any(axis):
        raise refuse("is zero; it must be the direction of an axis")
    return axis


def _angle(value: Any) -> float:
    angle = number(value)
    if not angle:
        raise refuse("is 0; it must be the angle that the tip goes, rad")
    return angle


Place = Annotated[tuple[float, ...], PlainValidator(_place)]


class CircularPath(Part):
    """An arc about an axis, or a whole circle."""

    start: Place = Field(description="where the tip begins, m, in inertial axes")
    centre: Place = Field(description="the centre of the circle, m")
    axis: Annotated[tuple[float, ...], PlainValidator(_direction)] = Field(
        (0.0, 0.0, 1.0), description="the direction about which the tip goes; z, if not given"
    )
    angle: Annotated[float, PlainValidator(_angle)] = Field(
        2 * math.pi, description="how far it goes, rad; one turn, if not given"
    )


class StraightPath(Part):
    """A straight line."""

    start: Place = Field(description="where the tip begins, m, in inertial axes")
    goal: Place = Field(description="where it ends, m")


class TipPathFile(Part):
    """A path of the tip from rest to rest, of one shape."""

    time: Annotated[float, PlainValidator(positive)] = Field(description="the time that the tip takes, s")
    circle: CircularPath | None = Field(None, description="an arc about an axis")
    line: StraightPath | None = Field(None, description="in its place a straight line")


def read_shape(path: str | os.PathLike[str]) -> TipPathFile:
    """The shape that a file states; raises RobotFileError, one line."""
    file, found = one_line(os.fsdecode(path)), load_table(TipPathFile, path, RobotFileError)
    if (found.circle is None) == (found.line is None):
        raise RobotFileError(f"{file}: circle, line: state one of them")
    if found.line is not None and found.line.start == found.line.goal:
        raise RobotFileError(f"{file}: line: goal is the start; give another one")
    if (circle := found.circle) is not None:
        arm = [x - y for x, y in zip(circle.start, circle.centre, strict=True)]
        along = sum(x * y for x, y in zip(arm, circle.axis, strict=True)) / math.hypot(*circle.axis)
        if not (radius := math.hypot(*arm)):
            raise RobotFileError(f"{file}: circle: start is the centre; give another one")
        if abs(along) > OFF * radius:
            said = f"start is {along:.3g} m along the axis from the centre"
            raise RobotFileError(f"{file}: circle: {said}; give a centre, or an axis, square to which it lies")
    return found
