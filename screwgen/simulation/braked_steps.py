"""Steps that are too long for brakes: what a closed brake does to a turning axis ends within some `time`."""

from __future__ import annotations

import warnings

import numpy as np

from ..robot_model import RobotModel
from ..spec.parameters import parameters

FIELD = "joint.brake.time"


class BrakeWarning(UserWarning):
    """A step that is too long for a brake; the text is one line meant for a user."""


def warn(model: RobotModel, p: np.ndarray, step: float) -> None:
    """Warn of the brake that allows the shortest steps, at parameters (n,), where a step, s, is longer."""
    found = [(p[k], x.name) for k, x in enumerate(parameters(model.robot)) if x.field == FIELD]
    if found and step >= 2 * min(found)[0]:
        time, name = min(found)
        said = f"a step of {step:g} s is too long for {name} = {time:g} s: a brake that stops its axis"
        warnings.warn(f"{said} needs steps below {2 * time:g} s", BrakeWarning, stacklevel=3)
