"""Files of plans: .npz with all of it, .csv with samples for other programmes."""

from __future__ import annotations

import os
from typing import Any, BinaryIO

import numpy as np

from ..spec.array_files import arrays_of, check_numbers, check_shapes
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
    with arrays_of(path, "a plan", "a .npz of plan") as arrays:
        found = {name: arrays.numbers(name) for name in ARRAYS}
        (robot,), joints = arrays.texts("robot"), arrays.texts("joints")
        t, points, m = found["t"], len(found["t"]) if found["t"].ndim else 0, len(joints)
        shapes = dict.fromkeys(("q", "v", "vdot", "tau"), (points, m)) | dict.fromkeys(("kp", "kd", "tau_max"), (m,))
        check_shapes(found, shapes)
        check_numbers(found)
        even = points > 1 and np.allclose(np.diff(t), t[-1] / (points - 1), rtol=SPACING, atol=0)
        if not even or t[0] != 0 or t[-1] <= 0:
            raise ValueError("t does not grow evenly from 0")
    arrays_found: list[Any] = [found[name] for name in ARRAYS]
    return MotionPlan(robot, joints, *arrays_found)
