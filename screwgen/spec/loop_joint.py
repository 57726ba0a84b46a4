"""The joint of a loop: what it leaves free, and how it gives way in what it blocks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, Self

from pydantic import Field, model_validator

from ..joints.compliant import ALONG, CompliantJoint, blocked, compliant
from ..joints.constraints import rows
from ..joints.screw import Screw
from .axes import screw_of
from .joint import Axes, Joint
from .part import Part
from .ranges import several, within
from .stated import Stated
from .values import refuse

Numbers = float | tuple[float, float]
"""One number, or those along the axes that a joint blocks and about them."""


def _one_or_two(quantity: str) -> Callable[[Any], Any]:
    """The check of such numbers."""
    check = lambda x: (several(quantity, 2) if isinstance(x, list | tuple) else within(quantity))(x)  # noqa: E731
    return check


STIFFNESS = Stated(
    *("stiffness of a row", "stiffness along the axes that it blocks, and about them"),
    more="; an array: along, about; without it the joint is rigid",
    check=_one_or_two("stiffness of a row"),
)
DAMPING = Stated(
    *("damping of a row", "damping along the axes that it blocks, and about them"),
    more="; an array: along, about",
    check=_one_or_two("damping of a row"),
)


class LoopJoint(Part):
    """Motions about and along `axes`, which a loop leaves free; no axes: welded.

    It is rigid in all others. With `stiffness` it gives way there: along every direction and about every axis that it
    blocks a spring of that stiffness acts (N/m, N·m/rad), and a damper of `damping` (N·s/m, N·m·s/rad). Two numbers
    are those along and about.
    """

    axes: Axes = Field(description='the axes that stay free, as ["y", { slide = "x" }]; [] welds')
    stiffness: Annotated[Numbers, STIFFNESS] | None = None
    damping: Annotated[Numbers, DAMPING] | None = None

    @model_validator(mode="before")
    @classmethod
    def _without_drive(cls, given: Any) -> Any:
        if isinstance(given, Joint):
            given = given.model_dump(exclude_none=True)
        of_links = [key for key in Joint.model_fields if key not in cls.model_fields]
        for key in of_links if isinstance(given, dict) else ():
            if given.get(key) is not None and key == "mount":
                what = "is stated, but a loop's joint sits at its first marker"
                raise refuse(f"{what}; leave it out, or weld a link there to have the joint elsewhere", (key,))
            if given.get(key) is not None:
                raise refuse("is stated, but nothing drives a loop's joint; leave it out", (key,))
        return given

    @model_validator(mode="after")
    def _damping_beside_a_spring(self) -> Self:
        if self.damping is not None and self.stiffness is None:
            said = "is stated without stiffness, and a rigid joint has none; state both, or leave it out"
            raise refuse(said, ("damping",))
        return self

    @model_validator(mode="after")
    def _two_of_both(self) -> Self:
        found = blocked(rows(self.screws))
        for key in ("stiffness", "damping"):
            if isinstance(getattr(self, key), tuple) and len(found) < 2:
                missing = "turns" if ALONG in found else "motion along an axis"
                raise refuse(f"has two entries, but the joint blocks no {missing}; state one number", (key,))
        return self

    @property
    def screws(self) -> tuple[Screw, ...]:
        """The motions that it leaves free, in order."""
        return tuple(map(screw_of, self.axes))

    @property
    def law(self) -> CompliantJoint | None:
        """The springs and dampers of a joint that gives way; None of a rigid one."""
        if self.stiffness is None:
            return None
        both = lambda x: x if isinstance(x, tuple) else (x, x)  # noqa: E731
        damping = None if self.damping is None else both(self.damping)
        return compliant(both(self.stiffness), damping, rows(self.screws))
