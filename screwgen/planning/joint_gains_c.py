"""A law of the joints with the gains that were found as C: a function that a clock calls."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..backends.c.columns import rendered
from ..errors import UsageError
from ..files import sound
from ..spec.names import robot_name
from ..version import __version__ as VERSION
from .lqg_c import UNLIMITED
from .plan_c import JOINT, numbers

if TYPE_CHECKING:
    from .joint_gains import JointGains

FILES = ("law.h", "law.c")
"""The files without the robot's name; their templates have the same names."""


def law_files(law: JointGains) -> dict[str, str]:
    """Header and source of a law, by names of files; raises UsageError where C cannot have it."""
    try:
        robot_name(law.robot)
    except ValueError as error:
        raise UsageError(f"the law's robot: {error}") from None
    if not law.joints or not all(map(JOINT.fullmatch, law.joints)):
        raise UsageError("the law's joints: C needs one at least, with names of letters, digits and _ . [ ] alone")
    gains = {"kp": law.kp, "kd": law.kd, "ki": np.zeros_like(law.kp) if law.ki is None else law.ki}
    if not all(map(sound, gains.values())):
        raise UsageError("the law's gains hold something else than measured numbers; C is made of finite ones alone")
    values = {
        "version": VERSION,
        "name": law.robot,
        "joints": law.joints,
        "step": repr(law.step),
        "summed": law.ki is not None,
        "limits": numbers(np.minimum(law.tau_max, UNLIMITED)),
        **{name: numbers(x) for name, x in gains.items()},
    }
    return {f"{law.robot}_{file}": rendered(file, **values) for file in FILES}
