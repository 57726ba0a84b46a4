"""The base of a robot: fixed to the world, floating, or moving as is given: then the first link's pose is state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

from .input import Input, InputLine
from .joint import Joint
from .parents import Named, parents
from .values import refuse

if TYPE_CHECKING:
    from .robot import Robot

FIXED, FLOATING, MOVING = "fixed", "floating", "moving"

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

EFFORT_UNITS = ("N·m",) * 3 + ("N",) * 3
"""What moves a base whose motion is given: moment and force at the origin of F_1, in its axes."""
GIVEN_RATE = r"\dot{\mathbf{V}}_g"
"""What documents call the rate of its twist."""


class BaseMotion(Input):
    """The accelerations of a base whose motion is given: the rates of its twist, in axes of F_1."""

    words = "a base whose motion is given"
    kinds = ("twist_rate",)
    own = "twist_"
    signal = "base_rate"
    title = "Given rates of the base's twist"
    letter = "a"

    def names(self, robot: Robot) -> list[str]:
        return [f"base.twist_rate[{k}]" for k in range(6)] if robot.base == MOVING else []

    def units(self, robot: Robot) -> list[str]:
        return ["rad/s²"] * 3 + ["m/s²"] * 3 if robot.base == MOVING else []

    def efforts(self, robot: Robot) -> list[tuple[str, str]]:
        count = len(self.names(robot))
        return [(f"base.twist_effort[{k}]", unit) for k, unit in enumerate(EFFORT_UNITS[:count])]

    def lines(self, chain: Any, first: int) -> list[InputLine]:
        about = r"the base, whose motion is given: the rate of its twist, in axes of $\mathcal{F}_1$"
        return [InputLine(GIVEN_RATE, about, 6)]

    def of_links(self, chain: Any) -> list[list[int]]:
        return [list(range(6)), *([] for _ in range(1, chain.n))]


BASE_MOTION = BaseMotion()


class BaseAcceleration(Input):
    """The acceleration of a base that carries the robot, m/s², inertial axes; its passenger sees free fall without it.

    Coordinates, energies and power are those that the passenger sees.
    """

    words = "an accelerated base"
    kinds = ("acceleration_x", "acceleration_y", "acceleration_z")
    apart = True
    quantity = "gravity"
    title = "Acceleration of the base"
    letter = "a"

    def names(self, robot: Robot) -> list[str]:
        return [f"base.{kind}" for kind in self.kinds] if robot.base_acceleration else []

    def units(self, robot: Robot) -> list[str]:
        return ["m/s²"] * len(self.names(robot))

    def lines(self, chain: Any, first: int) -> list[InputLine]:
        about = "the base, which accelerates along the inertial ${}$ axis"
        return [InputLine(f"u_{{{k}}}", about.format(axis)) for k, axis in enumerate("xyz", first)]

    def free_fall(self, entries: Sequence) -> list:
        return [-a for a in entries]


BASE_ACCELERATION = BaseAcceleration()


class Jointed(Named, Protocol):
    """What this module reads of a link."""

    @property
    def joint(self) -> Joint: ...


def check_in_space(links: Sequence[Jointed], base: str) -> None:
    """Refuses a first link that is jointed to the world, and further links on the world."""
    joint = links[0].joint
    if joint.axes:
        what = f"is stated for the first link, which a {base} base leaves without a joint; write axes = []"
        raise refuse(what, at=("links", 0, "joint", "axes"))
    if joint.mount is not None:
        what = f'is stated for the first link, but base = "{base}" makes its place a part of the state; leave it out'
        raise refuse(what, at=("links", 0, "joint", "mount"))
    carriers = parents(links)
    for i in range(1, len(links)):
        if carriers[i] < 0:
            what = f"is the world, but of a robot with base = \"{base}\" only the first link, '{links[0].name}'"
            raise refuse(f"{what}, may be on it; name the link that carries this one", at=("links", i, "parent"))


def check_accelerated(accelerates: bool, base: str) -> None:
    """Refuses an accelerated base of a robot whose base is no carrier: its own motion is state, or given already."""
    if accelerates and base != FIXED:
        what = f'is stated of a robot with base = "{base}", but only a fixed base is carried by what accelerates'
        raise refuse(f'{what}; leave it out, or write base = "{FIXED}"', at=("base_acceleration",))
