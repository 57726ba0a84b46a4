"""Arms whose joints have limits and stops for tests: a pendulum, a slide, and one of everything."""

from __future__ import annotations

from functools import cache

from drive_robots import ELASTIC, RIGID, SOFT, TIP
from helpers import arm, link, model_of

BOTH = {"lower": -0.4, "upper": 0.3, "stiffness": 2000.0, "damping": 8.0}
UPPER = {"upper": 0.2, "stiffness": 900.0}
LOWER = {"lower": -0.25, "stiffness": 1500.0, "damping": 30.0}
MIXED = arm(
    link("cart", axes=[{"slide": "x"}], bodies=[TIP], joint={"limits": [BOTH], "damping": [3.0]}),
    link(
        "boom",
        axes="yz",
        modes={"axial": 1, "bending_z": 2},
        section=SOFT,
        joint={"drives": [RIGID, ELASTIC], "limits": [UPPER, LOWER]},
    ),
    link(
        "hand",
        0.4,
        axes="xyz",
        modes={"bending_y": 1, "torsion": 1},
        section=SOFT,
        bodies=[TIP],
        joint={"limits": [{"lower": -1.0}, {}, BOTH], "stiffness": [20.0, 0.0, 5.0]},
    ),
    link("tool", 0.3, axes=[{"slide": "z"}], parent="boom", joint={"limits": [UPPER]}, bodies=[TIP]),
    gravity=(3.0, -2.0, -9.0),
)
"""Stops on slides, on axes that turn, beside gears and friction, in a tree; one range without stops."""


@cache
def mixed():
    return model_of(MIXED)
