"""Tendons: threads along links, which pull where they are off the centreline.

A thread through a rod of 0.4 m, 10 mm beside its centreline, under 5 N bends it as a moment of 0.05 N·m would.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import Field, PlainValidator, model_validator

from .input import Input, InputLine
from .names import link_name
from .part import Part
from .ranges import within
from .stations import place
from .values import Path, array, boolean, numbers, quoted, refuse

if TYPE_CHECKING:
    from .robot import Link, Robot

Offset = tuple[float, float, float]
Offsets = tuple[Offset, Offset]
MOST_TENDONS = 64
TENSION = ".tension"
"""The end of the name of a tendon's input."""
ENDS = "two offsets from the centreline, as [[0.0, 0.01, 0.0], [0.0, 0.005, 0.0]]"


def offsets(value: Any) -> Offsets:
    """The offsets at both ends of a tendon, (x, y, z) in axes of the section, m; x is 0."""
    stated = array(value, f"an array of {ENDS}")
    if len(stated) != 2:
        raise refuse(f"has {len(stated)} entries; it must be {ENDS}")
    return _offset(stated[0], (0,)), _offset(stated[1], (1,))


def _offset(value: Any, at: Path) -> Offset:
    x, y, z = (within("position")(entry, at=(*at, i)) for i, entry in enumerate(numbers(value, 3, at=at)))
    if x != 0.0:
        raise refuse(f"is {x:g} along the link; it must be 0: from and to say where the ends are", (*at, 0))
    return x, y, z


class Tendon(Part):
    """A thread along a link, at an offset from the centreline that is linear from one end to the other.

    Both ends are fixed to the sections there. It slides in its guides without friction, so its tension is the same all
    along. Tables of one name, on one link or several, are pieces of one tendon: its length is the sum of theirs.
    """

    name: Annotated[str, PlainValidator(link_name)] = Field(
        description="the tendon's name, a C identifier; pieces of one tendon have one name"
    )
    start: Annotated[float, PlainValidator(place)] = Field(
        0.0, alias="from", description="where it begins: s from 0 at the base to 1 at the tip"
    )
    to: Annotated[float, PlainValidator(place)] = Field(1.0, description="where it ends")
    at: Annotated[Offsets, PlainValidator(offsets)] = Field(
        description="its offsets [0, y, z] from the centreline at both ends, axes of the section, m"
    )
    actuated: Annotated[bool, PlainValidator(boolean)] = Field(
        True, description="whether its tension is an input; with false it is left out of the model"
    )

    @model_validator(mode="after")
    def _ends_in_order(self) -> Self:
        if not self.start < self.to:
            raise refuse(f"is {self.to:g}, where it begins or before; it must be beyond {self.start:g}", at=("to",))
        return self

    def offset(self, end: int) -> tuple[float, float]:
        """Its offset in y and z at an end, m."""
        return self.at[end][1:]


@dataclass(frozen=True)
class TendonClass:
    """A piece of a tendon along a link, or along one of its segments, without its numbers."""

    number: int
    """Its number among the tendons of the link."""
    span: tuple[float, float]
    """Where on the link, or its segment, it begins and ends, as shares of the length."""
    mixed: tuple[float, float]
    """How far between the two stated offsets those at the ends of the span are: 0 the first, 1 the second."""


def tendon_classes(link: Link, segment: int = 0) -> tuple[TendonClass, ...]:
    """The pieces of tendons along a link, or along one of its segments."""
    out = []
    for k, own in enumerate(link.tendons):
        first, last = segment / link.pieces, (segment + 1) / link.pieces
        start, to = max(own.start, first), min(own.to, last)
        if own.actuated and start < to:
            a, b = ((x - own.start) / (own.to - own.start) for x in (start, to))
            span = (start - first) * link.pieces, (to - first) * link.pieces
            out.append(TendonClass(k, span, (a, b)))
    return tuple(out)


def offset_label(number: int, end: int, axis: str) -> str:
    """The label of an offset of a tendon: its number, the end (0, 1), the axis (y, z)."""
    return f"tendon{number}_{end}_{axis}"


def tendon_names(robot: Robot) -> list[str]:
    """The names of the tendons that something pulls, in order of appearance."""
    return list(dict.fromkeys(own.name for link in robot.links for own in link.tendons if own.actuated))


class Tensions(Input):
    """Tensions of tendons; a link reads those of the pieces along it."""

    words = "tendons"
    kinds = (TENSION[1:],)
    signal = "tension"
    chosen = True
    title = "Tensions of tendons"
    letter = "T"

    def names(self, robot: Robot) -> list[str]:
        return [f"{name}{TENSION}" for name in tendon_names(robot)]

    def units(self, robot: Robot) -> list[str]:
        return ["N"] * len(tendon_names(robot))

    def lines(self, chain: Any, first: int) -> list[InputLine]:
        count = len(tendon_names(chain.robot))
        return [InputLine(f"T_{{{k + 1}}}", "tension of the tendon, along its pieces") for k in range(count)]

    def of_links(self, chain: Any) -> list[list[int]]:
        every, links = tendon_names(chain.robot), chain.robot.links
        pairs = zip(chain.segments, chain.keys, strict=True)
        return [[every.index(links[s.link].tendons[x.number].name) for x in key.tendons] for s, key in pairs]


TENSIONS = Tensions()


def refuse_tendons(links: Sequence[Link]) -> None:
    """Refuse tendons of links that they do not bend, and pieces of one tendon of which something pulls some alone."""
    for i, link in enumerate(links):
        if len(link.tendons) > MOST_TENDONS:
            what = f"has {len(link.tendons)} tables; a link has at most {MOST_TENDONS} tendons"
            raise refuse(what, ("links", i, "tendons"))
    first: dict[str, bool] = {}
    for at, link, own in _stated(links):
        if not link.modes.total or link.body is not None:
            what = "is stated of a link without modes of a rod, which no tendon bends"
            raise refuse(f"{what}; give the link modes, or leave it out", at[:-1])
        if first.setdefault(own.name, own.actuated) != own.actuated:
            what = f"is {str(own.actuated).lower()}, and of an earlier piece of tendon {quoted(own.name)} it is not"
            raise refuse(f"{what}; pieces of one tendon have one tension", (*at, "actuated"))


def _stated(links: Sequence[Link]) -> Iterator[tuple[Path, Link, Tendon]]:
    for i, link in enumerate(links):
        for k, own in enumerate(link.tendons):
            yield ("links", i, "tendons", k), link, own
