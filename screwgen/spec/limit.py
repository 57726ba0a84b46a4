"""The limits of a joint axis: a range, or stops that push the axis back into it."""

from collections.abc import Sequence
from math import inf
from typing import Annotated, Self

from pydantic import Field, PlainValidator, model_validator

from .part import Part
from .ranges import within
from .values import refuse, shown


class Limit(Part):
    """The range of one axis, rad (of a slide m), and with `stiffness` the compliant stops at its ends.

    Beyond a limit by p a stop pushes the joint back with `max(0, stiffness p + damping dp/dt)`; it never pulls. Either
    limit may be left out; an empty table is no limit. Without `stiffness` the range is known to the model and watched
    in simulations, but nothing holds the joint in it.
    """

    lower: Annotated[float, PlainValidator(within("limit"))] | None = Field(
        None, description="the least coordinate, rad (of a slide m)"
    )
    upper: Annotated[float, PlainValidator(within("limit"))] | None = Field(
        None, description="the largest coordinate, rad (of a slide m)"
    )
    stiffness: Annotated[float, PlainValidator(within("stop stiffness"))] | None = Field(
        None, description="stiffness of the stops, N·m/rad (of a slide N/m), > 0; without it there is a range alone"
    )
    damping: Annotated[float, PlainValidator(within("damping"))] | None = Field(
        None, description="damping of the stops, N·m·s/rad (of a slide N·s/m); they never pull"
    )

    @property
    def bounds(self) -> tuple[float, float]:
        """The least and the largest coordinate, infinite where none is stated."""
        return -inf if self.lower is None else self.lower, inf if self.upper is None else self.upper

    @model_validator(mode="after")
    def _complete(self) -> Self:
        lower, upper = self.bounds
        if not lower < upper:
            raise refuse(f"is {shown(lower)}; it must be less than upper, {shown(upper)}", at=("lower",))
        if self.damping is not None and self.stiffness is None:
            raise refuse("is stated without stiffness; state both, or none for a range without stops", at=("damping",))
        if self.stiffness is not None and self.lower is None and self.upper is None:
            raise refuse("is stated without a limit to act at; state lower, upper, or both", at=("stiffness",))
        return self


def check(limits: Sequence[Limit], axes: int) -> None:
    """Refuse another number of tables than of axes."""
    if len(limits) != axes:
        what = f"has length {len(limits)}; it must hold one table per axis, {axes}; an empty one is no limit"
        raise refuse(what, at=("limits",))
