"""The transmission of a drive whose ratio depends on the posture: the geometry of a cylinder."""

from typing import Annotated, Self

from pydantic import Field, PlainValidator, model_validator

from .part import Part
from .ranges import within
from .values import refuse, shown


class Transmission(Part):
    """A cylinder between the link and what carries it: `l² = base² + crank² − 2 base crank cos(q + angle)`.

    Its ends are the eye on the carrier, at the distance `base` from the joint axis, and the eye on the link, at the
    distance `crank`; q + `angle` is the angle between both. The input of the axis is then the force of the cylinder, N,
    positive where it extends it.
    """

    crank: Annotated[float, PlainValidator(within("length"))] = Field(
        description="distance of the rod's eye on the link from the joint axis, m, > 0"
    )
    base: Annotated[float, PlainValidator(within("length"))] = Field(
        description="distance of the cylinder's eye on the carrier from the joint axis, m, > 0, other than crank"
    )
    angle: Annotated[float, PlainValidator(within("turn"))] = Field(
        description="angle from the eye on the carrier to the eye on the link at q = 0, rad, about the joint axis"
    )

    @property
    def kind(self) -> str:
        """The name of the relation, a key of `algorithms.transmissions.KINDS`."""
        return "cylinder"

    @model_validator(mode="after")
    def _long(self) -> Self:
        if abs(self.crank - self.base) < 1e-6 * self.base:
            what = f"is {shown(self.crank)}, as long as base, so that the cylinder's length may be zero"
            raise refuse(f"{what}; state two different distances", at=("crank",))
        return self
