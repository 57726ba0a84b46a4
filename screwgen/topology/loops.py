"""Loops of a robot: which segments they join, and the rows that close them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..joints.constraints import Demand, Distance, Row, demands, rows
from ..spec.loops import joined
from ..spec.robot import Robot
from ..spec.segments import Segment
from .stations import section


@dataclass(frozen=True)
class Closure:
    """One scalar condition of a loop between the tips of two segments."""

    loop: int
    first: int
    second: int
    row: Row
    stabilisation: float
    """1/s: the rate at which a gap closes."""

    @property
    def name(self) -> str:
        return f"loop[{self.loop}]"

    @property
    def text(self) -> str:
        """The row in words, with directions in the axes of the tips."""
        if isinstance(self.row, Distance):
            return f"{self.name}, distance along {_shown(self.row.normal)}"
        return f"{self.name}, angle between {_shown(self.row.first)} and {_shown(self.row.second)}"


@dataclass(frozen=True)
class Junction:
    """All that a loop demands of the tips of two segments, whichever of its rows bear forces."""

    loop: int
    first: int
    second: int
    demands: tuple[Demand, ...]

    @property
    def name(self) -> str:
        return f"loop[{self.loop}]"


def _shown(direction: Sequence[float]) -> str:
    letter = next((x for k, x in enumerate("xyz") if direction[k] == 1.0), None)
    return letter or f"[{', '.join(f'{x:g}' for x in direction)}]"


def _segment(robot: Robot, segments: Sequence[Segment], link: int, s: float) -> int:
    """The segment whose tip is at a place of a link: one that ends there, or the marker."""
    for i, segment in enumerate(segments):
        if segment.link == link and segment.marker == s:
            return i
    return section(robot, [i for i, segment in enumerate(segments) if segment.first], link, s)[0]


def junctions(robot: Robot, segments: Sequence[Segment]) -> tuple[Junction, ...]:
    """The loops in the order of the file."""
    out = []
    for k, loop in enumerate(robot.loops):
        first, second = (_segment(robot, segments, *joined(robot.links, loop, end)) for end in range(2))
        out.append(Junction(k, first, second, demands(loop.joint.screws)))
    return tuple(out)


def closures(robot: Robot, junctions: Sequence[Junction]) -> tuple[Closure, ...]:
    """All rows of all loops, in the order of the file."""
    return tuple(
        Closure(j.loop, j.first, j.second, row, loop.stabilisation)
        for j, loop in zip(junctions, robot.loops, strict=True)
        for row in rows(loop.joint.screws)
    )
