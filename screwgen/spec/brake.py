"""Brakes of joint axes: keys of a robot file, and the inputs that close them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise
from typing import TYPE_CHECKING, Annotated, Any

from ..elements.brake import INPUT as LETTER
from ..joints.screw import Screw
from .input import Input, InputLine
from .part import Part
from .stated import Stated
from .values import array, refuse, shown

if TYPE_CHECKING:
    from .drive import Drive
    from .robot import Link, Robot

INERTIA = Stated(
    *("brake inertia", "inertia that a brake adds to its axis where it is closed by 0.29"),
    sliding="mass that a brake adds to its axis where it is closed by 0.29",
)
TIME = Stated("brake time", "time in which a closed brake takes 63 % of the rate of its axis")


class Brake(Part):
    """The brake of an axis; its input b is 0 where it is open and 1 where it is closed.

    A closed one leaves the axis no acceleration but `-rate / time`: from rest it is locked as if welded, and from a
    motion it comes to rest over some `time`. In between the axis bears a flywheel of `inertia b (2 - b) / (1 - b)²`
    besides, which has that acceleration by a share b. It acts where the drive does: on the rotor of an elastic gear.
    """

    inertia: Annotated[float, INERTIA] = 1.0
    time: Annotated[float, TIME] = 0.02

    @property
    def numbers(self) -> Iterator[tuple[str, float]]:
        """Its runtime parameters."""
        yield from (("inertia", self.inertia), ("time", self.time))


Brakes = tuple[Brake | None, ...]
SAID = "an array of true, false or tables as { time = 0.05 }, one for each axis"


def brakes(value: Any) -> Brakes:
    """The brake of each axis, None for one that has none."""
    return tuple(_brake(one, (k,)) for k, one in enumerate(array(value, SAID)))


def _brake(value: Any, at: tuple) -> Brake | None:
    if value is False or value is None:
        return None
    if value is True:
        return Brake()
    if isinstance(value, dict):
        return Brake.model_validate(value)
    if not isinstance(value, Brake):
        raise refuse(f"is {shown(value)}; it must be true, false or a table as {{ time = 0.05 }}", at)
    return value


def stated(value: Brakes) -> list:
    """The same as a file has it."""
    return [(one.model_dump(exclude_defaults=True) or True) if one else False for one in value]


def check(own: Sequence[Brake | None], screws: Sequence[Screw], drives: Sequence[Drive], given: Sequence[int]) -> None:
    """Refuse another number of brakes than of axes, and brakes where nothing is left to brake, or not known."""
    if len(own) != len(screws):
        what = f"has length {len(own)}; it must hold one entry per axis, {len(screws)}; false is no brake"
        raise refuse(what, at=("brake",))
    for axis, one in enumerate(own):
        if one and axis in given:
            said = 'is stated of an axis with actuation "motion", which no brake changes; leave out one of them'
            raise refuse(said, at=("brake", axis))
        if one and (travel := drives[axis].travel) and drives[axis].elastic:
            said = f"is stated of an axis that a {travel.SHORT} with an elastic gear drives, where it is not known"
            raise refuse(f"{said}; leave out the stiffness of the gear, or the brake", at=("brake", axis))


class BrakesOfAxes(Input):
    """How far the brakes of axes are closed, from 0 to 1."""

    words = "brakes"
    kinds = ("brake",)
    own = "brake_"
    signal = "brake"
    quantity = "brake"

    def names(self, robot: Robot) -> list[str]:
        return [f"{link.name}.brake[{axis}]" for link, axis in braked(robot)]

    def units(self, robot: Robot) -> list[str]:
        return ["1"] * len(list(braked(robot)))

    def efforts(self, robot: Robot) -> list[tuple[str, str]]:
        out = []
        for link, axis in braked(robot):
            turns = link.joint.driven[axis].elastic or link.joint.screws[axis].turn
            out.append((f"{link.name}.brake_effort[{axis}]", "N·m" if turns else "N"))
        return out

    def lines(self, chain: Any, first: int) -> list[InputLine]:
        said = "the brake of axis {} of `{}`, from 0, open, to 1, closed"
        return [InputLine(LETTER, said.format(axis + 1, link.name)) for link, axis in braked(chain.robot)]

    def of_links(self, chain: Any) -> list[list[int]]:
        ends = list(accumulate((len(key.brakes) for key in chain.keys), initial=0))
        return [list(range(a, b)) for a, b in pairwise(ends)]


BRAKES = BrakesOfAxes()


def braked(robot: Robot) -> Iterator[tuple[Link, int]]:
    """The links that have brakes, each with the number of the axis."""
    return ((link, axis) for link in robot.links for axis, one in enumerate(link.joint.brake or ()) if one)
