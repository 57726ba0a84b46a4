"""The limits of a joint axis: a range, or stops that push the axis back into it; what every step holds of its input."""

from collections.abc import Sequence
from math import inf
from typing import Annotated, Self

from pydantic import model_validator

from ..elements import HeldLaw, Key
from ..elements.effort import EffortLimit
from ..elements.effort_rate import EffortRateLimit
from .part import Part
from .stated import Stated
from .values import refuse, shown

HELD_LAWS: tuple[type[HeldLaw], ...] = (EffortLimit, EffortRateLimit)
"""The laws of what every step holds that limits state, in the order in which they act."""
OF_LAWS: dict[str, Key] = {name: key for law in HELD_LAWS for name, key in law.table().items()}
"""Their keys."""
KEPT = ", where it acts; every step keeps it"
STOPS = Stated("stop stiffness", "stiffness of the stops at the limits", "; without it there is a range alone")


class Limit(Part):
    """The range of one axis, rad (of a slide m), with `stiffness` the compliant stops at its ends, and its `effort`.

    Beyond a limit by p a stop pushes the joint back with `max(0, stiffness p + damping dp/dt)`; it never pulls. Either
    limit may be left out; an empty table is no limit. Without `stiffness` the range is known to the model and watched
    in simulations, but nothing holds the joint in it.

    `effort` is the largest torque of the drive, N·m, or force, N, of either sign, where it acts: at the motor of an
    elastic gear, along a cylinder, at a crank. Every step holds at most that; dynamics take what they are given. So it
    is with `effort_rate`, the largest rate of the same, which is measured over `effort_time`.
    """

    lower: Annotated[float, Stated("limit", "least coordinate of the joint")] | None = None
    upper: Annotated[float, Stated("limit", "largest coordinate of the joint")] | None = None
    stiffness: Annotated[float, STOPS] | None = None
    damping: Annotated[float, Stated("damping", "damping of the stops at the limits")] | None = None
    effort: Annotated[float, Stated.of(OF_LAWS["effort"], KEPT)] | None = None
    effort_rate: Annotated[float, Stated.of(OF_LAWS["effort_rate"], KEPT)] | None = None
    effort_time: Annotated[float, Stated.of(OF_LAWS["effort_time"])] | None = None

    @property
    def laws(self) -> tuple[type[HeldLaw], ...]:
        """Those of `HELD_LAWS` that it states."""
        return tuple(law for law in HELD_LAWS if getattr(self, next(iter(law.table()))) is not None)

    def without_internal_states(self) -> Self:
        """The limits without the laws that have one."""
        gone = [name for law in HELD_LAWS if law.state is not None for name in law.table()]
        return self.model_copy(update=dict.fromkeys(gone))

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
        for law in HELD_LAWS:
            absent = [name for name in law.table() if getattr(self, name) is None]
            if beside := absent and [name for name in law.table() if name not in absent]:
                raise refuse(f"is stated without {absent[0]}; state both, or none", at=(beside[0],))
        return self


def check(limits: Sequence[Limit], axes: int) -> None:
    """Refuse another number of tables than of axes."""
    if len(limits) != axes:
        what = f"has length {len(limits)}; it must hold one table per axis, {axes}; an empty one is no limit"
        raise refuse(what, at=("limits",))
