"""A law of the joints with the gains that were found as C: a function that a clock calls."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..backends.c.columns import rendered
from ..backends.templates import FEATURES
from ..version import __version__ as VERSION
from .lqg_c import UNLIMITED
from .plan_c import check_for_c, numbers

if TYPE_CHECKING:
    from .joint_gains import JointGains

FILES = ("law.h", "law.c")
"""The files without the robot's name; their templates have the same names."""


def law_files(law: JointGains) -> dict[str, str]:
    """Header and source of a law, by names of files; raises UsageError where C cannot have it."""
    gains = {"kp": law.kp, "kd": law.kd, "ki": np.zeros_like(law.kp) if law.ki is None else law.ki}
    check_for_c("law", law.robot, law.joints, gains.values())
    values = {
        "version": VERSION,
        "name": law.robot,
        "joints": law.joints,
        "step": repr(law.step),
        FEATURES: ("integral_law",) * (law.ki is not None) + ("law_with_levers",) * law.levers,
        "summed": law.ki is not None,
        "levers": law.levers,
        "limits": numbers(np.minimum(law.tau_max, UNLIMITED)),
        **{name: numbers(x) for name, x in gains.items()},
    }
    return {f"{law.robot}_{file}": rendered(file, **values) for file in FILES}
