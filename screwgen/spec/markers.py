"""Markers: the places of a link at which it carries others, or where a loop joins it, by name or by s."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field, PlainValidator

from .names import IDENTIFIER, link_name
from .parents import WORLD, parents
from .part import Part
from .stations import place
from .values import Path, quoted, refuse, shown

if TYPE_CHECKING:
    from .robot import Link

ENDS = {"base": 0.0, "tip": 1.0}
"""The markers that every link has."""
BASE, TIP = ENDS.values()
AT = 'it must be "tip", "base", a place as { s = 0.4 }, or the name of a marker of the parent'
NEAR = 1e-9
"""How near to the end of a segment, in lengths of it, a place is that end."""


class Marker(Part):
    """A named place on a link."""

    name: Annotated[str, PlainValidator(link_name)] = Field(description="the marker's name, a C identifier")
    at: Annotated[float, PlainValidator(place)] = Field(description="the place: s from 0 at the base to 1 at the tip")


@dataclass(frozen=True)
class Place:
    """A place s between base and tip, as `at = { s = 0.4 }` states it."""

    s: float


def marker(value: Any) -> str | Place:
    """Where on its parent a joint sits: the name of a marker, or a place."""
    if isinstance(value, Place):
        return value
    if isinstance(value, dict):
        if list(value) != ["s"]:
            raise refuse(f"has the keys {', '.join(map(quoted, value)) or 'of no place'}; {AT}")
        return Place(place(value["s"], at=("s",)))
    if not isinstance(value, str) or not IDENTIFIER.fullmatch(value):
        raise refuse(f"is {shown(value)}; {AT}")
    return value


def written(value: str | Place) -> str | dict[str, float]:
    """The marker as a robot file states it."""
    return {"s": value.s} if isinstance(value, Place) else value


def named(links: Sequence[Link], i: int, name: str, at: Path) -> float:
    """The place s of a link's marker of that name."""
    own = {marker.name: marker.at for marker in links[i].markers}
    if name in ENDS or name in own:
        return (ENDS | own)[name]
    known = " or ".join(map(quoted, [*ENDS, *own]))
    raise refuse(f"is {quoted(name)}, which is no marker of link '{links[i].name}'; choose {known}", at)


def carried_at(links: Sequence[Link]) -> list[float]:
    """The place s on its parent at which each link is carried, `TIP` on the world."""
    out = []
    for i, (link, parent) in enumerate(zip(links, parents(links), strict=True)):
        at: Path = ("links", i, "at")
        if parent < 0:
            if link.at != "tip":
                what = f"is stated for a link on the {WORLD}, which has no markers; leave it out, or use the mount"
                raise refuse(what, at)
            out.append(TIP)
            continue
        s = link.at.s if isinstance(link.at, Place) else named(links, parent, link.at, at)
        out.append(reached(links[parent], s, at))
    return out


def reached(link: Link, s: float, at: Path) -> float:
    """The place s of a link, refused where the link has only its ends."""
    if s == TIP:
        return TIP
    if link.body is not None:
        what = f"is on link '{link.name}', whose body is known at its tip alone"
        raise refuse(f'{what}; choose "tip", and a mount from there', at)
    if link.length is None:
        if s == BASE:
            return TIP
        raise refuse(f'is a place along link \'{link.name}\', which states no length; choose "tip" or "base"', at)
    return s


def check_markers(links: Sequence[Link]) -> None:
    """Refuse markers of one name, those that are called as an end, and those of links that have no place for them."""
    for i, link in enumerate(links):
        taken = set(ENDS)
        for k, marker in enumerate(link.markers):
            at: Path = ("links", i, "markers", k)
            if marker.name in taken:
                what = "which every link has" if marker.name in ENDS else "the name of an earlier one"
                raise refuse(f"is {quoted(marker.name)}, {what}; every marker needs its own name", (*at, "name"))
            taken.add(marker.name)
            reached(link, marker.at, (*at, "at"))
    carried_at(links)


def split(s: float, pieces: int) -> tuple[int, float]:
    """The segment of a link's place, and the place along it; its tip where two segments meet."""
    along = s * pieces
    if abs(along - round(along)) < NEAR and round(along) > 0:
        return round(along) - 1, TIP
    return int(along), along - int(along)
