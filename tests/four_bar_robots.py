"""Arms with four-bar linkages for tests: a boom with a bucket, and one link with its true loop beside it."""

from functools import cache

import numpy as np
from helpers import arm, link, model_of

LINKAGE = {"ground": 0.4, "crank": 0.22, "coupler": 0.47, "rocker": 0.25, "angle": 1.3, "branch": "open"}
FRICTION = {"coulomb": 4.0, "viscous": 3.0, "velocity": 0.1}


def digger(linkage=LINKAGE, friction=FRICTION, modes=None, gravity=(0.3, 0.0, -9.81), **joint) -> dict:
    """A boom on a cylinder, and a bucket on a linkage, both about y."""
    own = {"transmission": {"crank": 0.4, "base": 1.2, "angle": -1.5}, "ratio": 30.0, "rotor_inertia": 0.02}
    other = {"transmission": {"four_bar": linkage}, "ratio": 50.0, "rotor_inertia": 1e-3}
    other |= {"friction": friction} if friction else {}
    boom = link("boom", 2.0, "y", 5.0, modes, joint={"drives": [own]}, section={"EIy": 3e4})
    bucket = link("bucket", 0.8, "y", 3.0, joint={"drives": [other], **joint}, bodies=[{"at": "tip", "mass": 4.0}])
    return arm(boom, bucket, gravity=gravity)


@cache
def boom():
    return model_of(digger(modes={"bending_z": 1}))


START = np.array([0.2, 0.4, 0.0])


def looped(angle: float, branch: str) -> dict:
    """The linkage of `alone` as what it is: crank and coupler are links with mass, and a loop."""
    own = alone(angle, branch)
    drive = dict(own["links"][0]["joint"]["drives"][0])
    g = drive.pop("transmission")["four_bar"]["ground"]
    pivot = {"xyz": [float(g * np.cos(angle)), 0.0, float(g * np.sin(angle))]}
    body = own["links"][0] | {"joint": {"axes": ["y"]}}
    crank = link("crank", LINKAGE["crank"], "y", 5.0, joint={"mount": pivot, "drives": [drive]}, parent="world")
    coupler = link("coupler", LINKAGE["coupler"], "y", 3.0)
    return own | {
        "links": [body, crank, coupler],
        "loops": [{"between": ["arm.tip", "coupler.tip"], "joint": {"axes": ["x", "y", "z"]}}],
    }


def alone(angle: float, branch: str) -> dict:
    """A heavy link, whose pin is at its tip, driven through a linkage with rotor and friction."""
    linkage = LINKAGE | {"angle": angle, "branch": branch}
    drive = {"transmission": {"four_bar": linkage}, "ratio": 20.0, "rotor_inertia": 2e-3, "friction": FRICTION}
    mass = {"at": "tip", "mass": 6.0, "com": [0.3, 0.02, 0.1], "inertia": [0.2, 0.3, 0.4, 0.0, 0.0, 0.0]}
    return arm(
        link("arm", LINKAGE["rocker"], "y", 8.0, joint={"drives": [drive]}, bodies=[mass]), gravity=(2.0, 0.0, -9.0)
    )
