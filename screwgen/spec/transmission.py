"""The transmission of a drive whose ratio depends on the posture: the geometry of a cylinder, or a four-bar linkage."""

from collections.abc import Iterator
from typing import Self

from pydantic import Field, model_validator

from ..elements import CYLINDER, Travel
from .four_bar import FourBar
from .part import Part
from .travel_keys import Length, Turn, stated
from .values import refuse, shown


class Transmission(Part):
    """A cylinder between the link and what carries it: `l² = base² + crank² − 2 base crank cos(q + angle)`.

    Its ends are the eye on the carrier, at the distance `base` from the joint axis, and the eye on the link, at the
    distance `crank`; q + `angle` is the angle between both. The input of the axis is then the force of the cylinder, N,
    positive where it extends it. With `four_bar` in place of these keys a linkage drives the link.
    """

    crank: Length | None = stated(CYLINDER.KEYS["crank"], default=None)
    base: Length | None = stated(CYLINDER.KEYS["base"], ", other than crank", default=None)
    angle: Turn | None = stated(CYLINDER.KEYS["angle"], ", about the joint axis", default=None)
    four_bar: FourBar | None = Field(
        None,
        description="of a four-bar linkage in place of a cylinder, as { ground = …, crank = …, …, branch = … }",
    )

    @property
    def kind(self) -> Travel:
        """What it is."""
        return CYLINDER if self.four_bar is None else self.four_bar.kind

    @property
    def numbers(self) -> Iterator[tuple[str, float]]:
        """Its runtime parameters, by their keys below this table."""
        part = self if self.four_bar is None else self.four_bar
        return ((f"{self.kind.TABLE}{name}", getattr(part, name)) for name in self.kind.KEYS)

    @model_validator(mode="after")
    def _one_kind(self) -> Self:
        if self.four_bar is not None:
            if other := next((name for name in CYLINDER.KEYS if getattr(self, name) is not None), None):
                raise refuse("is stated beside four_bar, which drives the joint by itself; leave one out", at=(other,))
            return self
        if missing := next((name for name in CYLINDER.KEYS if getattr(self, name) is None), None):
            what = type(self).model_fields[missing].description
            raise refuse(f"is missing; state {what}, or four_bar alone", at=(missing,))
        assert self.crank is not None and self.base is not None
        if abs(self.crank - self.base) < 1e-6 * self.base:
            what = f"is {shown(self.crank)}, as long as base, so that the cylinder's length may be zero"
            raise refuse(f"{what}; state two different distances", at=("crank",))
        return self
