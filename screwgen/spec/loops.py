"""Loops: joints between the tips of two links, which close a tree of links."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

from pydantic import Field, PlainValidator

from .joint import PER_AXIS, Joint
from .part import Part
from .ranges import within
from .screw import Screw
from .values import Path, array, quoted, refuse, shown

Ends = tuple[str, str]
STABILISATION = 20.0
"""The rate, 1/s, at which a gap closes where a loop states none."""


def ends(value: Any) -> Ends:
    """Two markers, each the name of a link with `.tip`."""
    stated = array(value, 'an array of two tips, as ["rod.tip", "slider.tip"]')
    if len(stated) != 2:
        raise refuse(f'has {len(stated)} entries; it must name two tips, as ["rod.tip", "slider.tip"]')
    for i, entry in enumerate(stated):
        if not isinstance(entry, str) or not entry.endswith(".tip"):
            raise refuse(f'is {shown(entry)}; it must be the name of a link with ".tip", as "rod.tip"', at=(i,))
    return tuple(stated)


class Loop(Part):
    """A joint between two tips; its motions are those that the loop leaves free.

    It sits at the tip of the first link in `between`, its axes are those of that tip frame. Where all its coordinates
    are zero the two tip frames coincide. Slides come before turns. `stabilisation` λ (1/s): a gap g that rounding or
    the integrator has opened closes by `g̈ + 2 λ ġ + λ² g = 0`.
    """

    between: Annotated[Ends, PlainValidator(ends)] = Field(
        description='the tips that the loop joins, as ["rod.tip", "slider.tip"]'
    )
    joint: Joint = Field(description='the motions that the loop leaves free, as { axes = ["y"] }; [] welds the tips')
    stabilisation: Annotated[float, PlainValidator(within("stabilisation"))] = Field(
        STABILISATION, description="the rate at which an open gap closes, rad/s"
    )


def refuse_loops(names: Sequence[str], loops: Sequence[Loop]) -> None:
    """Refuse loops whose tips are no two links, and joints that no loop can have."""
    for i, loop in enumerate(loops):
        at: Path = ("loops", i)
        first, second = (end.removesuffix(".tip") for end in loop.between)
        for k, name in enumerate((first, second)):
            if name not in names:
                known = " or ".join(map(quoted, names[:8]))
                raise refuse(f"is the tip of {quoted(name)}, which is no link; choose {known}", (*at, "between", k))
        if first == second:
            raise refuse("joins a link with itself; name the tips of two links", (*at, "between"))
        _refuse_joint(loop.joint, (*at, "joint"))


def _refuse_joint(joint: Joint, at: Path) -> None:
    if joint.mount is not None:
        what = "is stated, but a loop's joint sits at the tip of the first link"
        raise refuse(f"{what}; leave it out, or weld a link to that tip to have the joint elsewhere", (*at, "mount"))
    for key in PER_AXIS:
        if getattr(joint, key) is not None:
            what = "is stated, but nothing drives a loop's joint; leave it out"
            raise refuse(what, (*at, key))
    turned: list[Screw] = []
    for k, screw in enumerate(joint.screws):
        if screw.turn and screw.slides:
            raise refuse("is a screw, which no loop can have; choose axes that turn or slide", (*at, "axes", k))
        if screw.slides and any(abs(abs(_dot(screw, s)) - 1) > 1e-12 for s in turned):
            raise refuse("slides after the link has turned about another axis; put it first", (*at, "axes", k))
        turned += [screw] if screw.turn else []


def _dot(a: Screw, b: Screw) -> float:
    return sum(x * y for x, y in zip(a.axis, b.axis, strict=True))
