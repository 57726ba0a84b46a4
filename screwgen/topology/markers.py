"""The markers of a robot: sections of its links at which functions measure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..spec.markers import TIP, reached
from ..spec.robot import Robot
from ..spec.segments import Segment
from .stations import section


@dataclass(frozen=True)
class PlacedMarker:
    """The tip of a link, or a place on it that the robot file names."""

    name: str
    """``boom.tip``, ``boom.hook``."""
    segment: int
    """The segment of the chain on which it is."""
    at: float
    """The place s along this segment."""
    is_tip: bool
    """Whether every link has it."""


def markers(robot: Robot, pieces: Sequence[Segment]) -> tuple[PlacedMarker, ...]:
    """The markers of all links, in the order of the file: of each its tip, then those that it declares."""
    firsts = [place for place, segment in enumerate(pieces) if segment.first]
    out = []
    for i, link in enumerate(robot.links):
        named = [("tip", TIP), *((marker.name, marker.at) for marker in link.markers)]
        places = [(name, section(robot, firsts, i, reached(link, s, ()))) for name, s in named]
        out += [PlacedMarker(f"{link.name}.{name}", *place, is_tip=name == "tip") for name, place in places]
    return tuple(out)
