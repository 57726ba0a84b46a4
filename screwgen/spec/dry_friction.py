"""Parameters of a robot without its dry friction, whose slope at rest is no damping of motions that slip."""

from __future__ import annotations

import numpy as np

from .parameters import parameters
from .robot import Robot

TABLE = "joint.drives.friction."
DRY = tuple(TABLE + key for key in ("coulomb", "load", "stribeck.static", "memory.damping"))
"""The parameters of dry friction. Its slope at rest is no damping of motions beyond the rate that smooths it."""
BEND = f"{TABLE}bend.friction"
"""Friction that rises up to a rate and stays there: it damps slow motions alone."""
NONE = 1e-12
"""What is left of it, for numbers that must be positive."""


def without_dry_friction(robot: Robot, p: np.ndarray, bend: bool = True) -> np.ndarray:
    """Parameters (n,) whose dry friction of drives is all but nothing; viscous friction stays, and a `bend` of it."""
    gone = DRY if bend else (*DRY, BEND)
    return np.where([one.field in gone for one in parameters(robot)], NONE * p, p)
