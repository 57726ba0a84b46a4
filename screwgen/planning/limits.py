"""The limits of a plan: the tightest of those of the robot file, of those that are given, and of the law's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fnmatch import fnmatchcase
from typing import Any

import numpy as np

from ..arguments import Numbers, array
from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.load import one_line
from .drive_coordinates import DriveCoordinates
from .task import MotionLimits

HEADROOM = 0.97
"""The share of the limits of efforts that is planned with; the rest is for the joint law."""
LEAST = {"lower": -np.inf, "upper": -np.inf, "rates": 0.0, "efforts": 0.0, "effort_rates": 0.0}
"""What a limit of the joints has to be more than, of efforts at least."""
NAMED = ("strains", "wrenches")
"""Limits of what is not one number per joint: tables of names or patterns and numbers."""


def motion_limits(
    model: RobotModel, given: Mapping[str, Any], gains: Any = None, headroom: float = HEADROOM
) -> MotionLimits:
    """All limits of a motion, of efforts a share; raises UsageError, which names the key."""
    m = model.n_joints
    for name in given:
        if name not in (*LEAST, *NAMED):
            raise UsageError(f"limits: there is no '{name}'; choose of {', '.join((*LEAST, *NAMED))}")
    own = {key: array(x, f"limits: {key}:", (m,), finite=False) for key, x in given.items() if key in LEAST}
    for key, values in own.items():
        if np.isnan(values).any():
            raise UsageError(f"limits: {key}: holds nan; give numbers, or inf where there is no limit")
        if key in ("rates", "effort_rates") and not (values > 0).all():
            raise UsageError(f"limits: {key}: must be positive")
        if key == "efforts" and not (values >= 0).all():
            raise UsageError("limits: efforts: must be positive, of joints without a drive zero")
    drives = DriveCoordinates(model.chain, model.parameter_values)
    efforts = np.minimum(drives.efforts(model.chain.most("effort")), own.get("efforts", np.inf))
    if gains is not None and getattr(gains, "tau_max", None) is not None:
        efforts = np.minimum(efforts, np.asarray(gains.tau_max, float))
    none = np.full(m, np.inf)
    lower = np.maximum(model.chain.limits[:, 0], own.get("lower", -none))
    upper = np.minimum(model.chain.limits[:, 1], own.get("upper", none))
    if (crossed := lower > upper).any():
        j = int(crossed.argmax())
        said = f"lower {lower[j]:g} of {model.q_names[j]} is above upper {upper[j]:g}"
        raise UsageError(f"limits: {said}, those of the robot file counted; leave a range between")
    return MotionLimits(
        lower,
        upper,
        own.get("rates", none),
        headroom * efforts,
        own.get("effort_rates", none),
        _named(given.get("strains") or {}, model.strain_names, "strains"),
        _named(given.get("wrenches") or {}, model.wrench_names, "wrenches"),
    )


def _named(given: Mapping[str, Numbers], names: Sequence[str], key: str) -> np.ndarray:
    """The limits (n,) of quantities by names or patterns, the tightest where several are meant."""
    if not isinstance(given, Mapping):
        raise UsageError(f"limits: {key}: must be a table of names and numbers, as {{'{(*names, 'name')[0]}': 0.1}}")
    out = np.full(len(names), np.inf)
    for pattern, most in given.items():
        chosen = [i for i, name in enumerate(names) if fnmatchcase(name, pattern)]
        if not chosen:
            known = f"choose of {', '.join(names)}" if names else "this robot has none"
            raise UsageError(f"limits: {key}: there is no '{one_line(pattern)}'; {known}")
        value = array(most, f"limits: {key}: {one_line(pattern)}", ()).item()
        if not value > 0:
            raise UsageError(f"limits: {key}: {one_line(pattern)}: must be > 0")
        out[chosen] = np.minimum(out[chosen], value)
    return out
