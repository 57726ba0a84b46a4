"""A law with its filter as C: tables over the grid, and the functions that a clock calls."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..backends.c.columns import rendered
from ..errors import UsageError
from ..version import __version__ as VERSION
from .plan_c import check_for_c, numbers

if TYPE_CHECKING:
    from .lqg import Lqg

FILES = ("lqg.h", "lqg.c")
"""The files without the robot's name; their templates have the same names."""
UNLIMITED = 1e30
"""In place of a limit that there is not: within the range of float."""


def lqg_files(law: Lqg) -> dict[str, str]:
    """Header and source of a law, by names of files; raises UsageError where C cannot have it."""
    check_for_c("law", law.robot, law.joints)
    if law.tables.M.shape[-1] == len(law.joints):
        raise UsageError("the law's robot: has no modes, whose laws have no C yet; take joint gains")
    grid = law.grid
    for name, x in zip(grid.names, grid.values, strict=True):
        if not (np.diff(x.astype(np.float32)) > 0).all():
            raise UsageError(f"the law's grid: values of {name} are one number in single precision; take them apart")
    values = {
        "version": VERSION,
        "name": law.robot,
        "joints": law.joints,
        "coordinates": law.tables.M.shape[-1],
        "step": repr(law.step),
        "variables": [
            (name.replace("*/", "* /"), j, len(x))
            for name, j, x in zip(grid.names, grid.joints, grid.values, strict=True)
        ],
        "vertices": len(grid.vertices),
        "loads": len(grid.loads),
        "grid": [numbers(x) for x in grid.values],
        "limits": numbers(np.minimum(law.tau_max, UNLIMITED)),
        "tables": {name: numbers(x.reshape(len(x), -1)) for name, x in law.tables._asdict().items()},
    }
    return {f"{law.robot}_{file}": rendered(file, **values) for file in FILES}
