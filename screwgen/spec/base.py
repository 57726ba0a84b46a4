"""The base of a robot: fixed to the world, or floating, in which case the first link's pose is part of the state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from .joint import Joint
from .parents import Named, parents
from .values import refuse

FIXED, FLOATING = "fixed", "floating"

POSE = ("x", "y", "z", "qw", "qx", "qy", "qz")
"""The coordinates of a floating base: the origin of F_1 in the inertial frame, and its unit quaternion."""
POSE_UNITS = ("m", "m", "m", "1", "1", "1", "1")
CHANGE = tuple(f"{what}_{axis}" for what in ("rotation", "displacement") for axis in "xyz")
"""Changes of the pose along the twist, rad and m: the rotation vector and the displacement, in axes of F_1."""
CHANGE_UNITS = ("rad", "rad", "rad", "m", "m", "m")
TWIST = ("omega_x", "omega_y", "omega_z", "v_x", "v_y", "v_z")
"""Its rates: the twist of F_1 in axes of F_1."""
HOME = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
"""The pose in which F_1 is the inertial frame."""


class Jointed(Named, Protocol):
    """What this module reads of a link."""

    @property
    def joint(self) -> Joint: ...


def check_floating(links: Sequence[Jointed]) -> None:
    """Refuses a first link that is jointed to the world, and further links on the world."""
    joint = links[0].joint
    if joint.axes:
        what = "is stated for the first link, which a floating base leaves free in space; write axes = []"
        raise refuse(what, at=("links", 0, "joint", "axes"))
    if joint.mount is not None:
        what = 'is stated for the first link, but base = "floating" makes its place a part of the state; leave it out'
        raise refuse(what, at=("links", 0, "joint", "mount"))
    carriers = parents(links)
    for i in range(1, len(links)):
        if carriers[i] < 0:
            what = f"is the world, but of a robot with base = \"floating\" only the first link, '{links[0].name}'"
            raise refuse(f"{what}, may be on it; name the link that carries this one", at=("links", i, "parent"))
