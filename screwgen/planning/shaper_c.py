"""A scheduled shaper as C: polynomials of what vibrates, and a ring of references that a clock feeds."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..backends.c.columns import rendered
from ..errors import UsageError
from ..version import __version__ as VERSION
from .plan_c import check_for_c, numbers
from .shapers import TOLERATED, VIBRATES

if TYPE_CHECKING:
    from .scheduled_shaper import ScheduledShaper

FILES = ("shaper.h", "shaper.c")
LONGEST = 100_000
"""Samples that a ring may hold."""


def shaper_files(made: ScheduledShaper, step: float) -> dict[str, str]:
    """Header and source of a shaper for a clock, by names of files; raises UsageError."""
    check_for_c("shaper", made.robot, (*made.joints, *made.variables))
    if made.vibrates not in VIBRATES:
        raise UsageError(f"the shaper's vibrates: must be one of: {', '.join(VIBRATES)}")
    length = made.sampled(step).length
    if length > LONGEST:
        raise UsageError(f"step: {step:g} s takes {length} samples of memory; take a longer one")
    values = {
        "version": VERSION,
        "name": made.robot,
        "kind": made.kind,
        "vibrates": made.vibrates,
        "joints": made.joints,
        "variables": made.variables,
        "step": repr(step),
        "length": length,
        "delay": repr(made.delay),
        "impulses": 2 if made.kind == "zv" else 3,
        "tolerated": repr(TOLERATED),
        "terms": len(made.powers),
        "powers": made.powers.tolist(),
        "bounds": np.transpose([made.lower, made.upper]).tolist(),
        "lower": numbers(made.lower),
        "upper": numbers(made.upper),
        "modes": [
            {
                "frequency": numbers(x.frequency),
                "damping": numbers(x.damping),
                "limits": [repr(y) for y in (*x.frequencies, *x.dampings)],
            }
            for x in made.modes
        ],
    }
    return {f"{made.robot}_{file}": rendered(file, **values) for file in FILES}
