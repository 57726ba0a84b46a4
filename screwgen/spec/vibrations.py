"""Measured vibrations, as of a hammer test: natural frequencies and damping ratios (TOML). Every fault is one line."""

from __future__ import annotations

import os
from typing import Annotated, Any, Self

from pydantic import Field, PlainValidator, model_validator

from ..errors import UsageError
from .load import load_table
from .part import Part
from .values import array, boolean, choice, number, positive, refuse, shown

JOINTS = ("locked", "free")


def _several(value: Any) -> tuple[float, ...]:
    return tuple(positive(x, at=(k,)) for k, x in enumerate(array(value, "an array of numbers > 0")))


def _modes(value: Any) -> tuple[int, ...]:
    for k, x in enumerate(array(value, "an array of whole numbers, the lowest mode is 1")):
        if not isinstance(x, int) or isinstance(x, bool) or x < 1:
            raise refuse(f"is {shown(x)}; it must be a whole number, the lowest mode is 1", at=(k,))
    return tuple(value)


def _posture(value: Any) -> dict[str, float]:
    if not isinstance(value, dict):
        raise refuse(f'is {shown(value)}; it must be a table of coordinates, as {{ "arm.joint[0]" = 0.5 }}')
    return {name: number(x, at=(name,)) for name, x in value.items()}


Several = Annotated[tuple[float, ...], PlainValidator(_several)]
Share = Annotated[float, PlainValidator(positive)]


class VibrationTest(Part):
    """What was measured in one posture with joints locked or free."""

    joints: Annotated[str, PlainValidator(choice(*JOINTS))] = Field("locked", description="locked or free")
    posture: Annotated[dict[str, float], PlainValidator(_posture)] = Field(
        {}, description="coordinates of joints by name, rad or m; others are as at home"
    )
    loaded: Annotated[bool, PlainValidator(boolean)] = Field(False, description="whether gravity bends the links")
    frequencies: Several = Field(description="natural frequencies, Hz")
    damping: Several | None = Field(None, description="damping ratios, one for each frequency")
    modes: Annotated[tuple[int, ...], PlainValidator(_modes)] | None = Field(
        None, description="which modes of the robot these are, from 1; without it the nearest ones"
    )
    noise: Share = Field(0.005, description="the standard deviation of frequencies over themselves")
    damping_noise: Share = Field(0.1, description="the standard deviation of damping ratios over themselves")

    @model_validator(mode="after")
    def _one_each(self) -> Self:
        for key in ("damping", "modes"):
            if (own := getattr(self, key)) is not None and len(own) != len(self.frequencies):
                raise refuse(f"has {len(own)} entries; it must have {len(self.frequencies)}, as frequencies", at=(key,))
        if self.modes is not None and len(set(self.modes)) < len(self.modes):
            raise refuse("names a mode twice; each frequency is one mode", at=("modes",))
        if not self.frequencies:
            raise refuse("is empty; state what was measured", at=("frequencies",))
        return self


class Vibrations(Part):
    """The tests of a file."""

    tests: tuple[VibrationTest, ...] = Field(description="the tests, an array of tables [[tests]]")


def load_vibrations(path: str | os.PathLike[str]) -> Vibrations:
    """The tests in the TOML file at `path`; raises UsageError, `<file>: <key>: <fault>; <remedy>`."""
    return load_table(Vibrations, path, UsageError, "a table of vibrations needs four levels")
