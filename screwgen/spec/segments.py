"""The segments of a robot's links: the equal pieces, welded to each other, that a link with `segments = k` consists of.

A link that is not split is one segment. Segments are what kinematics and dynamics see as links; parameters, joints
and bodies are the link's.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from .names import distinct
from .values import quoted, refuse

if TYPE_CHECKING:
    from .robot import Robot


@dataclass(frozen=True)
class Segment:
    """One segment of a link."""

    link: int
    """The number of its link in the robot."""
    number: int
    """Its place along the link, from 0 at the base."""
    count: int
    """How many segments the link has."""
    owner: str
    """The name of its link."""

    @property
    def name(self) -> str:
        """The link's name, of one segment of several `boom[2]`."""
        return f"{self.owner}[{self.number}]" if self.count > 1 else self.owner

    @property
    def identifier(self) -> str:
        """The name in generated code, `boom_2`."""
        return f"{self.owner}_{self.number}" if self.count > 1 else self.owner

    @property
    def first(self) -> bool:
        """Whether the link's joint and the bodies at its base are on this segment."""
        return self.number == 0

    @property
    def last(self) -> bool:
        """Whether the link's tip and the bodies there are on this segment."""
        return self.number == self.count - 1

    @property
    def jointed(self) -> str:
        """The name of what is at the segment's base: the link's joint, or the weld of an inner segment."""
        return self.owner if self.first else self.name

    @property
    def tipped(self) -> str:
        """The name of what is at the segment's tip: the link's tip, or that of an inner segment."""
        return self.owner if self.last else self.name


def segments(robot: "Robot") -> tuple[Segment, ...]:
    """The segments of all links, base to tip."""
    return tuple(
        Segment(i, k, link.pieces, link.name) for i, link in enumerate(robot.links) for k in range(link.pieces)
    )


def owner(name: str) -> str:
    """The link of a segment's name, or of a name that begins with it: `boom` of `boom[2].eta.axial[0]`."""
    return name.partition(".")[0].partition("[")[0]


def distinct_names(robot: "Robot") -> None:
    """Refuse two links of one name, and a link with the name that a segment has in generated code."""
    distinct([link.name for link in robot.links])
    taken = {s.identifier.upper(): s for s in segments(robot) if s.count > 1}
    for i, link in enumerate(robot.links):
        if segment := taken.get(link.name.upper()):
            what = f"is {quoted(link.name)}, the name in generated code of segment {segment.name}; choose another name"
            raise refuse(what, at=("links", i, "name"))
