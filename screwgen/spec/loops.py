"""Loops: joints between markers of two links, which close a tree of links."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field, PlainValidator

from ..joints.screw import Screw
from .loop_joint import LoopJoint
from .markers import TIP, named, reached, split
from .parents import WORLD
from .part import Part
from .ranges import within
from .values import Path, array, quoted, refuse, shown

if TYPE_CHECKING:
    from .robot import Link

Ends = tuple[str, str]
STABILISATION = 20.0
"""The rate, 1/s, at which a gap closes where a loop states none."""


def ends(value: Any) -> Ends:
    """Two markers, each the name of a link with that of its marker, as `rod.tip`."""
    stated = array(value, 'an array of two markers, as ["rod.tip", "slider.tip"]')
    if len(stated) != 2:
        raise refuse(f'has {len(stated)} entries; it must name two markers, as ["rod.tip", "slider.tip"]')
    for i, entry in enumerate(stated):
        if not isinstance(entry, str) or entry.count(".") != 1 or not all(entry.split(".")):
            what = 'it must be the name of a link with that of its marker, as "rod.tip"'
            raise refuse(f"is {shown(entry)}; {what}", at=(i,))
    return tuple(stated)


class Loop(Part):
    """A joint between markers of two links; its motions are those that the loop leaves free.

    It sits at the first marker in `between`, its axes are those of the frame of the section there. Where all its
    coordinates are zero the two frames coincide. Slides come before turns. `stabilisation` λ (1/s): a gap g that
    rounding or the integrator has opened closes by `g̈ + 2 λ ġ + λ² g = 0`.
    """

    between: Annotated[Ends, PlainValidator(ends)] = Field(
        description='the markers that the loop joins, as ["rod.tip", "casting.hook"]'
    )
    joint: LoopJoint = Field(
        description='the motions that the loop leaves free, as { axes = ["y"] }; [] welds them; and how it gives way'
    )
    stabilisation: Annotated[float, PlainValidator(within("stabilisation"))] = Field(
        STABILISATION, description="the rate at which an open gap closes, rad/s"
    )

    @property
    def rigid(self) -> bool:
        """Whether it closes the tree; one that gives way is a force between its markers."""
        return self.joint.stiffness is None


def refuse_loops(links: Sequence[Link], loops: Sequence[Loop]) -> None:
    """Refuse loops that join no two links at markers of theirs, and joints that no loop can have."""
    for i, loop in enumerate(loops):
        at: Path = ("loops", i)
        (first, _), (second, _) = (joined(links, loop, k, (*at, "between", k)) for k in range(2))
        if first == second:
            raise refuse("joins a link with itself; name markers of two links", (*at, "between"))
        if not loop.rigid and "stabilisation" in loop.model_fields_set:
            said = "is stated of a loop whose joint gives way, which has no gap to close; leave it out"
            raise refuse(said, (*at, "stabilisation"))
        _refuse_joint(loop.joint, (*at, "joint"))


def joined(links: Sequence[Link], loop: Loop, end: int, at: Path = ()) -> tuple[int, float]:
    """The link that an end of a loop joins, and the place s along it."""
    return marked(links, loop.between[end], at, "; anchor the loop by a link")


def marked(links: Sequence[Link], marker: str, at: Path = (), remedy: str = "") -> tuple[int, float]:
    """The link of a marker, as `rod.tip`, and the place s along it; refuses markers of none."""
    name, own = marker.split(".")
    names = [link.name for link in links]
    if name not in names:
        if name == WORLD and remedy:
            raise refuse(f'is a place of the {WORLD}{remedy} with axes = [] whose parent is "{WORLD}"', at)
        known = " or ".join(map(quoted, names[:8]))
        raise refuse(f"is a marker of {quoted(name)}, which is no link; choose {known}", at)
    i = names.index(name)
    return i, reached(links[i], named(links, i, own, at), at)


def places_between(links: Sequence[Link], markers: Iterable[str]) -> dict[int, dict[float, str]]:
    """The places s of markers that are between the ends of their links' segments, with their names, by link."""
    out: dict[int, dict[float, str]] = {}
    for marker in markers:
        i, s = marked(links, marker)
        if split(s, links[i].pieces)[1] != TIP:
            out.setdefault(i, {}).setdefault(s, marker.partition(".")[2])
    return out


def _refuse_joint(joint: LoopJoint, at: Path) -> None:
    turned: list[Screw] = []
    for k, screw in enumerate(joint.screws):
        if screw.turn and screw.slides:
            raise refuse("is a screw, which no loop can have; choose axes that turn or slide", (*at, "axes", k))
        if screw.slides and any(abs(abs(_dot(screw, s)) - 1) > 1e-12 for s in turned):
            raise refuse("slides after the link has turned about another axis; put it first", (*at, "axes", k))
        turned += [screw] if screw.turn else []


def _dot(a: Screw, b: Screw) -> float:
    return sum(x * y for x, y in zip(a.axis, b.axis, strict=True))
