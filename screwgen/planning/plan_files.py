"""Files of plans: .npz with all of it, .csv with samples for other programmes."""

from __future__ import annotations

import os
from typing import Any, BinaryIO

import numpy as np

from ..errors import UsageError
from ..files import open_arrays, sound
from ..spec.load import one_line
from .plan import ARRAYS, MotionPlan

STEP = 1e-3
"""Between the rows of a .csv file, s, unless another is asked for."""
SPACING = 1e-9


def write_npz(plan: MotionPlan, stream: BinaryIO) -> None:
    """All of a plan but how it was found."""
    arrays = {name: getattr(plan, name) for name in ARRAYS}
    np.savez(stream, allow_pickle=False, robot=np.array(plan.robot), joints=np.array(plan.joints), **arrays)


def write_csv(plan: MotionPlan, stream: BinaryIO, step: float = STEP) -> None:
    """References and means of torques at every step: a head of names, then a row for every sample."""
    head = ["t", *(f"{name}{end}" for end in ("", ".rate", ".torque") for name in plan.joints)]
    stream.write((",".join(head) + "\n").encode())
    s = plan.sampled(step)
    for row in np.column_stack([s.t, s.q, s.v, s.tau]).tolist():
        stream.write((",".join(f"{x:.17g}" for x in row) + "\n").encode())


def read_plan(path: str | os.PathLike[str]) -> MotionPlan:
    """The plan in a .npz file; raises UsageError, one line."""
    file = one_line(os.fsdecode(path))
    wrong = lambda why: UsageError(f"{file}: cannot be read as a plan ({why}); give a .npz of plan")  # noqa: E731
    try:
        with open_arrays(path) as arrays:
            found = {name: arrays.numbers(name) for name in ARRAYS}
            (robot,), joints = arrays.texts("robot"), arrays.texts("joints")
    except (OSError, ValueError) as error:
        raise wrong(one_line(getattr(error, "strerror", None) or str(error))) from None
    points, m = len(found["t"]) if found["t"].ndim else 0, len(joints)
    shapes = dict.fromkeys(("q", "v", "vdot", "tau"), (points, m)) | dict.fromkeys(("kp", "kd", "tau_max"), (m,))
    for name, wanted in shapes.items():
        if found[name].shape != wanted:
            raise wrong(f"{name} has the shape {found[name].shape}; it must have {wanted}")
    for name, values in found.items():
        limited = values[np.isfinite(values)] if name == "tau_max" and not np.isnan(values).any() else values
        if not sound(limited):
            raise wrong(f"{name} holds something else than measured numbers")
    t = found["t"]
    if points < 2 or t[0] != 0 or not np.allclose(np.diff(t), t[-1] / (points - 1), rtol=SPACING, atol=0) or t[-1] <= 0:
        raise wrong("t does not grow evenly from 0")
    arrays_found: list[Any] = [found[name] for name in ARRAYS]
    return MotionPlan(robot, joints, *arrays_found)
