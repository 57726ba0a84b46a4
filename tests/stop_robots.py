"""Arms whose joints have limits and stops for tests: a pendulum, a slide, and one of everything."""

from __future__ import annotations

from functools import cache

from drive_robots import ELASTIC, RIGID, mixed_arm
from helpers import model_of

BOTH = {"lower": -0.4, "upper": 0.3, "stiffness": 2000.0, "damping": 8.0}
UPPER = {"upper": 0.2, "stiffness": 900.0}
LOWER = {"lower": -0.25, "stiffness": 1500.0, "damping": 30.0}
MIXED = mixed_arm(
    cart={"limits": [BOTH]},
    boom={"drives": [RIGID, ELASTIC], "limits": [UPPER, LOWER]},
    hand={"limits": [{"lower": -1.0}, {}, BOTH]},
    tool={"limits": [UPPER]},
)
"""Stops on slides, on axes that turn, beside gears and friction, in a tree; one range without stops."""


@cache
def mixed():
    return model_of(MIXED)
