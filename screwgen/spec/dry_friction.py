"""Parameters of a robot without its dry friction, or with one that changes its sign less suddenly."""

from __future__ import annotations

import numpy as np

from .parameters import parameters
from .robot import Robot

TABLE = "joint.drives.friction."
DRY = tuple(TABLE + key for key in ("coulomb", "load", "stribeck.static", "memory.damping"))
"""The parameters of dry friction. Its slope at rest is no damping of motions beyond the rate that smooths it."""
BEND = f"{TABLE}bend.friction"
"""Friction that rises up to a rate and stays there: it damps slow motions alone."""
VELOCITY, RATIO, GEAR = f"{TABLE}velocity", "joint.drives.ratio", "joint.drives.stiffness"
"""The rate over which friction changes its sign, of the axis or, behind an elastic gear, of the rotor; the gear's."""
NONE = 1e-12
"""What is left of it, for numbers that must be positive."""


def without_dry_friction(robot: Robot, p: np.ndarray, bend: bool = True) -> np.ndarray:
    """Parameters (n,) whose dry friction of drives is all but nothing; viscous friction stays, and a `bend` of it."""
    gone = DRY if bend else (*DRY, BEND)
    return np.where([one.field in gone for one in parameters(robot)], NONE * p, p)


def with_spread_friction(robot: Robot, p: np.ndarray, rate: float) -> np.ndarray:
    """Parameters (n,) whose dry friction of drives changes its sign over a rate of the axis, rad/s or m/s, or more."""
    own = {(one.link, one.field, one.index): value for one, value in zip(parameters(robot), p, strict=True)}
    out = p.copy()
    for k, one in enumerate(parameters(robot)):
        if one.field == VELOCITY:
            elastic = (one.link, GEAR, one.index) in own
            out[k] = max(p[k], rate * (own.get((one.link, RATIO, one.index), 1.0) if elastic else 1.0))
    return out
