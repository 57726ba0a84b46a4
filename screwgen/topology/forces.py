"""Where forces between frames act in the tree: the segments of their ends, and where their numbers stand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..interactions import InteractionClass
from ..spec.forces import WorldPoint
from ..spec.loops import marked
from ..spec.robot import Robot
from ..spec.segments import Segment
from .loops import segment_at


@dataclass(frozen=True)
class PlacedForce:
    """A force between the tips of two segments, or between one and a point of the world."""

    name: str
    shape: InteractionClass
    ends: tuple[int | None, int | None]
    """The segments of its first and second end, None for the world."""
    first: int
    """Where its numbers begin among those of all forces; those of a point of the world are the last three."""
    count: int

    @property
    def tips(self) -> list[int]:
        """The segments of its ends."""
        return [i for i in self.ends if i is not None]

    @property
    def numbers(self) -> slice:
        """Those of its law among the numbers of all forces."""
        return slice(self.first, self.first + self.shape.count)

    @property
    def point(self) -> slice:
        """Those of its point of the world."""
        return slice(self.first + self.shape.count, self.first + self.count)


def placed_forces(robot: Robot, segments: Sequence[Segment]) -> tuple[PlacedForce, ...]:
    """The forces of a robot in the order of the file."""
    out: list[PlacedForce] = []
    for force in robot.forces:
        at = lambda x: None if isinstance(x, WorldPoint) else segment_at(robot, segments, *marked(robot.links, x))  # noqa: E731
        first, count = (out[-1].first + out[-1].count if out else 0), len(list(force.values))
        ends = (at(force.between[0]), at(force.between[1]))
        out.append(PlacedForce(force.name, force.law.shape, ends, first, count))
    return tuple(out)
