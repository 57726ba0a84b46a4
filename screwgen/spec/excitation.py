"""The file of a motion that is to excite what is sought (TOML). Every fault is one line."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, PlainValidator

from ..errors import UsageError
from .load import load_table
from .plan import Joints, PlanLimits
from .values import array, positive, refuse, shown

TIME, STEP = 10.0, 1e-3
Positive = Annotated[float, PlainValidator(positive)]


def _patterns(value: Any) -> tuple[str, ...]:
    found = array(value, "an array of patterns, as ['*.EIz', '*.coulomb']")
    if not found:
        raise refuse("is empty; name what is sought, as ['*.EIz', '*.coulomb']")
    for i, text in enumerate(found):
        if not isinstance(text, str):
            raise refuse(f"is {shown(text)}; it must be a pattern, as '*.EIz'", (i,))
    return tuple(found)


class ExcitationFile(PlanLimits):
    """What is sought, how it is measured, and the limits of a motion."""

    free: Annotated[tuple[str, ...], PlainValidator(_patterns)] = Field(description="what is sought, as of `identify`")
    sensors: str | None = Field(None, description="the table of the columns of a log, with their noise")
    gains: str | None = Field(None, description="the file of the joint law under which the motion is played")
    time: Positive = Field(TIME, description="how long the motion takes, s")
    step: Positive = Field(STEP, description="between samples of the clock and of the log, s")
    start: Joints | None = Field(None, description="joint coordinates at both ends, rad, of slides m")
    bandwidth: Positive | None = Field(None, description="the highest frequency of references, Hz")
    strain: Positive | None = Field(
        None, description="largest entry of `strain`, of either sign: curvatures, 1/m, and stretches"
    )


def read_excitation(path: str | os.PathLike[str]) -> ExcitationFile:
    """What a file asks for, files that it names relative to it; raises UsageError, one line."""
    found = load_table(ExcitationFile, path, UsageError, "limits of a motion need no such depth")
    beside = {key: str(Path(path).parent / name) for key in ("sensors", "gains") if (name := getattr(found, key))}
    return found.model_copy(update=beside)
