"""Arms with drives for tests: a double pendulum with gears, and one of everything."""

from __future__ import annotations

from functools import cache

from helpers import arm, link, model_of

ARMATURE = 2.5
"""kg·m²: a rotor behind its gear, as `pendulum` has it."""
RATIO = 50.0


def pendulum(k=None, damping=None, friction=None, gravity=(0.0, 0.0, -9.81), modes=1) -> dict:
    """Two links with equal drives, elastic ones if a stiffness `k` is given, and a number of modes of bending."""
    drive = {"ratio": RATIO, "rotor_inertia": ARMATURE / RATIO**2}
    given = {"stiffness": k, "damping": damping, "friction": friction}
    drive |= {name: value for name, value in given.items() if value is not None}
    part = lambda name, length, EIy: link(  # noqa: E731
        name, length, "y", 2.0, {"bending_z": modes} if modes else None, joint={"drives": [drive]}, section={"EIy": EIy}
    )
    return arm(part("a", 0.8, 3e4), part("b", 0.6, 1e4), gravity=gravity)


SOFT = {"EA": 5e4, "EIy": 300.0, "EIz": 500.0, "GJ": 20.0}
TIP = {"at": "tip", "mass": 1.0, "com": [0.1, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.001, 0.0, 0.0]}
FRICTION = {"coulomb": 0.3, "viscous": 0.02, "velocity": 0.2}
ELASTIC = {"ratio": 30.0, "rotor_inertia": 2e-4, "stiffness": 900.0, "damping": 2.0, "friction": FRICTION}
SCREW = {"ratio": 600.0, "rotor_inertia": 1e-5, "stiffness": 4e4}
RIGID = {"ratio": 20.0, "rotor_inertia": 5e-4, "friction": {"coulomb": 1.5, "velocity": 0.1}}
BEND = {"bend": {"friction": 0.6, "velocity": 0.4}}
FALLING = RIGID | {"friction": RIGID["friction"] | {"stribeck": {"static": 2.1, "velocity": 0.5}} | BEND}


def mixed_arm(cart: dict, boom: dict, hand: dict, tool: dict) -> dict:
    """A tree with slides, axes that turn and bending links, of which each joint states what is given besides."""
    bent = {"modes": {"axial": 1, "bending_z": 2}, "section": SOFT}
    turned = {"modes": {"bending_y": 1, "torsion": 1}, "section": SOFT, "bodies": [TIP]}
    return arm(
        link("cart", axes=[{"slide": "x"}], bodies=[TIP], joint={"damping": [3.0], **cart}),
        link("boom", axes="yz", joint=boom, **bent),
        link("hand", 0.4, axes="xyz", joint={"stiffness": [20.0, 0.0, 5.0], **hand}, **turned),
        link("tool", 0.3, axes=[{"slide": "z"}], parent="boom", joint=tool, bodies=[TIP]),
        gravity=(3.0, -2.0, -9.0),
    )


MIXED = mixed_arm(
    cart={"drives": [SCREW]},
    boom={"drives": [RIGID, ELASTIC]},
    hand={"drives": [ELASTIC, {}, {"friction": {"viscous": 0.4} | BEND}]},
    tool={"drives": [FALLING]},
)
"""Elastic, rigid and no drives, on slides and on axes that turn, in a tree."""


@cache
def mixed():
    return model_of(MIXED)


@cache
def swing(k=None, modes=1):
    """The model of a `pendulum`."""
    return model_of(pendulum(k, modes=modes))
