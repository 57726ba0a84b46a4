"""The four-bar linkage between a motor's crank and a joint: its keys in a robot file."""

from math import cos, hypot, sin
from typing import Annotated, Self

from pydantic import Field, PlainValidator, model_validator

from ..elements import FourBarLinkage
from .part import Part
from .travel_keys import Length, Turn, stated
from .values import choice, refuse, shown

FLAT = 1e-6
"""|sin| of an angle that counts as none, or as a straight one."""


class FourBar(Part):
    """A planar four-bar linkage: a crank of its own pivot on the carrier drives the link through a coupler.

    The rocker is the line on the link from the joint axis to the coupler's pin; q + `angle` is its angle from the line
    joint axis to crank pivot, about the joint axis. The crank's angle ψ is measured from the same direction in the same
    sense. The input of the axis is the torque at the crank, N·m.
    """

    ground: Length = stated(FourBarLinkage.KEYS["ground"])
    crank: Length = stated(FourBarLinkage.KEYS["crank"])
    coupler: Length = stated(FourBarLinkage.KEYS["coupler"])
    rocker: Length = stated(FourBarLinkage.KEYS["rocker"])
    angle: Turn = stated(FourBarLinkage.KEYS["angle"], ", about the joint axis")
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
    def kind(self) -> FourBarLinkage:
        """The way in which it is assembled."""
        return FourBarLinkage(1 if self.left else -1)

    @property
    def reach(self) -> tuple[float, float]:
        """The coordinates q, rad, between which crank and coupler reach the link."""
        return self.kind.reach(*(getattr(self, name) for name in FourBarLinkage.KEYS))

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
