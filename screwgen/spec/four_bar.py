"""The four-bar linkage between a motor's crank and a joint: its geometry, and how far it reaches."""

from math import acos, cos, hypot, inf, pi, remainder, sin
from typing import Annotated, Self

from pydantic import Field, PlainValidator, model_validator

from .part import Part
from .ranges import within
from .values import choice, refuse, shown

LENGTHS = ("ground", "crank", "coupler", "rocker")
NUMBERS = (*LENGTHS, "angle")
"""The keys that are runtime parameters."""
FLAT = 1e-6
"""|sin| of an angle that counts as none, or as a straight one."""
ROUND = 1e-9
"""A cosine so near to ±1 counts as that: the linkage folds flat there."""


def reach(ground: float, crank: float, coupler: float, rocker: float, angle: float) -> tuple[float, float]:
    """The coordinates q, rad, between which crank and coupler reach the link from its posture at q = 0.

    Ends are dead centres, in which crank and coupler are in line; infinite where the link can go round. Empty, with the
    upper end below the lower, where they do not reach it at q = 0.
    """
    start = remainder(angle, 2 * pi)
    cosine = lambda apart: (ground**2 + rocker**2 - apart**2) / (2 * ground * rocker)  # noqa: E731
    near, far = cosine(abs(crank - coupler)), cosine(crank + coupler)
    least = acos(min(max(near, -1.0), 1.0)) if near < 1 + ROUND else -inf
    most = acos(max(min(far, 1.0), -1.0)) if far > -1 - ROUND else inf
    if not least < abs(start) < most:
        return inf, -inf
    if least < 0:
        return -most - start, most - start
    outer = 2 * pi - least if most == inf else most
    return (least - start, outer - start) if start > 0 else (-outer - start, -least - start)


class FourBar(Part):
    """A planar four-bar linkage: a crank of its own pivot on the carrier drives the link through a coupler.

    The rocker is the line on the link from the joint axis to the coupler's pin; q + `angle` is its angle from the line
    joint axis to crank pivot, about the joint axis. The crank's angle ψ is measured from the same direction in the same
    sense. The input of the axis is the torque at the crank, N·m.
    """

    ground: Annotated[float, PlainValidator(within("length"))] = Field(
        description="distance of the crank's pivot on the carrier from the joint axis, m, > 0"
    )
    crank: Annotated[float, PlainValidator(within("length"))] = Field(
        description="length of the crank, which the motor turns about its pivot, m, > 0"
    )
    coupler: Annotated[float, PlainValidator(within("length"))] = Field(
        description="length of the rod between the pins of crank and link, m, > 0"
    )
    rocker: Annotated[float, PlainValidator(within("length"))] = Field(
        description="distance of the coupler's pin on the link from the joint axis, m, > 0"
    )
    angle: Annotated[float, PlainValidator(within("turn"))] = Field(
        description="angle from the ground line to the rocker at q = 0, rad, about the joint axis"
    )
    branch: Annotated[str, PlainValidator(choice("open", "crossed"))] = Field(
        description='how the linkage is assembled, "open" or "crossed"'
    )

    @property
    def left(self) -> bool:
        """Whether the crank's pin is on the left of the line from its pivot to the rocker's pin, about the joint axis.

        It stays there in every posture. The linkage is open at q = 0 if the crank's pin and the joint axis are on
        different sides of that line.
        """
        return (self.branch == "crossed") == (sin(self.angle) > 0.0)

    @property
    def reach(self) -> tuple[float, float]:
        """The coordinates q, rad, between which crank and coupler reach the link; see :func:`reach`."""
        return reach(self.ground, self.crank, self.coupler, self.rocker, self.angle)

    @model_validator(mode="after")
    def _assembled(self) -> Self:
        if abs(sin(self.angle)) < FLAT:
            what = f"is {shown(self.angle)}, so that the rocker lies along the ground line at q = 0"
            raise refuse(f"{what}, where open and crossed are the same; count q from elsewhere", at=("angle",))
        lower, upper = self.reach
        if not lower < 0 < upper:
            apart = hypot(self.rocker * cos(self.angle) - self.ground, self.rocker * sin(self.angle))
            least, most = abs(self.crank - self.coupler), self.crank + self.coupler
            what = f"cannot be assembled at q = 0: coupler and crank join points {least:.4g} m to {most:.4g} m apart"
            raise refuse(f"{what}, and these are {apart:.4g} m; change angle or lengths")
        return self
