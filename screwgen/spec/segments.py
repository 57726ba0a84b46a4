"""The segments of a robot's links: the equal pieces, welded to each other, that a link with `segments = k` consists of.

A link that is not split is one segment. Segments are what kinematics and dynamics see as links; parameters, joints
and bodies are the link's. A place between base and tip at which a loop joins a link, or a force acts on it, is one of
them too: it has neither mass nor length, follows the link's own segments, and is welded to the section there.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from .forces import marked_ends
from .loops import marked, places_between
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
    marker: float | None = None
    """The place s on its link, if it is a marker at which something acts."""
    label: str = ""
    """The marker's name, or that of the push that acts there."""
    pushed: str = ""
    """The axes in which a wrench from outside is stated there, if one is."""

    @property
    def name(self) -> str:
        """The link's name, of one segment of several `boom[2]`, of a marker `boom.hook`."""
        if self.marker is not None:
            return f"{self.owner}.{self.label}"
        return f"{self.owner}[{self.number}]" if self.count > 1 else self.owner

    @property
    def identifier(self) -> str:
        """The name in generated code, `boom_2`, `boom_hook`."""
        if self.marker is not None:
            return f"{self.owner}_{self.label}"
        return f"{self.owner}_{self.number}" if self.count > 1 else self.owner

    @property
    def first(self) -> bool:
        """Whether the link's joint and the bodies at its base are on this segment."""
        return self.number == 0 and self.marker is None

    @property
    def last(self) -> bool:
        """Whether the link's tip and the bodies there are on this segment."""
        return self.number == self.count - 1 and self.marker is None

    @property
    def jointed(self) -> str:
        """The name of what is at the segment's base: the link's joint, or the weld of an inner segment."""
        return self.owner if self.first else self.name

    @property
    def tipped(self) -> str:
        """The name of what is at the segment's tip: the link's tip, or that of an inner segment."""
        return self.owner if self.last else self.name


def segments(robot: "Robot") -> tuple[Segment, ...]:
    """The segments of all links, base to tip, each link's followed by its markers at which something acts."""
    loops = (end for loop in robot.loops for end in loop.between)
    joined = places_between(robot.links, (*loops, *marked_ends(robot)))
    pushed = [(push, *marked(robot.links, push.at)) for push in robot.pushes]
    out: list[Segment] = []
    for i, link in enumerate(robot.links):
        out += [Segment(i, k, link.pieces, link.name) for k in range(link.pieces)]
        out += [Segment(i, 0, 1, link.name, s, label) for s, label in joined.get(i, {}).items()]
        out += [Segment(i, 0, 1, link.name, s, push.name, push.axes) for push, own, s in pushed if own == i]
    return tuple(out)


def owner(name: str) -> str:
    """The link of a segment's name, or of a name that begins with it: `boom` of `boom[2].eta.axial[0]`."""
    return name.partition(".")[0].partition("[")[0]


def is_marker(name: str) -> bool:
    """Whether a segment's name is that of a marker at which something acts, `boom.hook`."""
    return "." in name


def distinct_names(robot: "Robot") -> None:
    """Refuse a link with the name that a segment or a marker has in generated code."""
    taken = {s.identifier.upper(): s for s in segments(robot) if s.identifier != s.owner}
    for i, link in enumerate(robot.links):
        if segment := taken.get(link.name.upper()):
            kind = "segment" if segment.marker is None else "marker"
            what = f"is {quoted(link.name)}, the name in generated code of {kind} {segment.name}; choose another name"
            raise refuse(what, at=("links", i, "name"))
