"""A plan as C: tables of its polynomials and torques, and the functions that a clock calls."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..backends.c.code import literal
from ..backends.c.columns import rendered
from ..errors import UsageError
from ..files import sound
from ..spec.names import robot_name
from ..version import __version__ as VERSION

if TYPE_CHECKING:
    from .plan import MotionPlan

FILES = ("plan.h", "plan.c")
"""The files without the robot's name; their templates have the same names."""
JOINT = re.compile(r"[\w.\[\]]+", re.ASCII)
"""What a comment may hold of a name."""
LEAST = float(np.finfo(np.float32).tiny)
"""What float does not hold is zero in tables of either precision."""


def plan_files(plan: MotionPlan) -> dict[str, str]:
    """Header and source of a plan, by names of files; raises UsageError where C cannot have the plan."""
    check_for_c("plan", plan.robot, plan.joints, (plan.coefficients, plan.tau, plan.kp, plan.kd))
    path = plan.coefficients.transpose(0, 2, 1)
    values = {
        "version": VERSION,
        "name": plan.robot,
        "joints": plan.joints,
        "points": len(plan.t),
        "stretches": len(path),
        "time": repr(plan.time),
        "stretch": repr(plan.time / len(path)),
        "path": numbers(path),
        "torques": numbers(plan.tau),
        "kp": numbers(plan.kp),
        "kd": numbers(plan.kd),
    }
    return {f"{plan.robot}_{file}": rendered(file, **values) for file in FILES}


def numbers(values: np.ndarray) -> Any:
    """Nested lists of literals, in the precision that the source is compiled in."""
    if values.ndim:
        return [numbers(x) for x in values]
    number = float(values)
    return literal(number if abs(number) >= LEAST else 0.0)


def check_for_c(what: str, robot: str, joints: Sequence[str], values: Iterable[np.ndarray] = ()) -> None:
    """Refuse what a plan, or a law, out of a file or made by hand may have that is no C; ``what``: its name."""
    try:
        robot_name(robot)
    except ValueError as error:
        raise UsageError(f"the {what}'s robot: {error}") from None
    if not joints or not all(map(JOINT.fullmatch, joints)):
        raise UsageError(f"the {what}'s joints: C needs one at least, with names of letters, digits and _ . [ ] alone")
    if not all(map(sound, values)):
        raise UsageError(f"the {what} holds something else than measured numbers; C is made of finite ones alone")
