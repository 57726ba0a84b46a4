"""Where the segments of a robot are carried: the tree, and the stations of its segments."""

from __future__ import annotations

from collections.abc import Sequence

from ..spec.markers import TIP as END
from ..spec.markers import carried_at, split
from ..spec.parents import parents
from ..spec.robot import Robot
from ..spec.segments import Segment
from .tree import BASE, TIP, Tree

Mount = tuple[int, float]
"""The segment that carries another one, or ``BASE``, and the place s along it."""


def mounted(robot: Robot, pieces: Sequence[Segment]) -> tuple[Tree, list[tuple[float, ...]]]:
    """The tree of the segments, and the places along each at which it carries others, besides its tip."""
    mounts = _mounts(robot, pieces)
    stations = [tuple(sorted({s for parent, s in mounts if parent == i and s != END})) for i in range(len(pieces))]
    carriers = tuple(parent for parent, _ in mounts)
    if not any(stations):
        return Tree(carriers), stations
    at = tuple(TIP if s == END else stations[parent].index(s) for parent, s in mounts)
    return Tree(carriers, at, tuple(map(len, stations))), stations


def _mounts(robot: Robot, pieces: Sequence[Segment]) -> list[Mount]:
    """What carries each segment: the one before it, or the parent of its link."""
    firsts = [place for place, segment in enumerate(pieces) if segment.first]
    carriers, places = parents(robot.links), carried_at(robot.links)
    out: list[Mount] = []
    for place, segment in enumerate(pieces):
        parent = carriers[segment.link]
        if segment.marker is not None:
            out.append(section(robot, firsts, segment.link, segment.marker))
        elif not segment.first:
            out.append((place - 1, END))
        elif parent < 0:
            out.append((BASE, END))
        else:
            out.append(section(robot, firsts, parent, places[segment.link]))
    return out


def section(robot: Robot, firsts: Sequence[int], link: int, s: float) -> Mount:
    """The segment of a place s along a link, and the place along it."""
    number, local = split(s, robot.links[link].pieces)
    return firsts[link] + number, local
