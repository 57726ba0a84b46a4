"""Where forces between frames act in the tree: the segments of their ends, and where their numbers stand."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import UsageError
from ..interactions import ROWS, InteractionClass
from ..spec.forces import WorldPoint
from ..spec.loops import marked
from ..spec.robot import Robot
from ..spec.segments import Segment
from .loops import ClosingRow, segment_at


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
    first_input: int
    """Where its inputs begin among those of all forces."""
    first_state: int
    """Where its states begin among those of all forces."""

    @property
    def tips(self) -> list[int]:
        """The segments of its ends."""
        return [i for i in self.ends if i is not None]

    @property
    def numbers(self) -> slice:
        """Those of its law among the numbers of all forces."""
        return slice(self.first, self.first + self.shape.count)

    @property
    def inputs(self) -> slice:
        """Those of its law among the inputs of all forces."""
        return slice(self.first_input, self.first_input + len(self.shape.inputs))

    @property
    def states(self) -> slice:
        """Those of its law among the states of all forces."""
        return slice(self.first_state, self.first_state + len(self.shape.states))

    @property
    def point(self) -> slice:
        """Those of its point of the world."""
        return slice(self.first + self.shape.count, self.first + self.count)


def placed_forces(robot: Robot, segments: Sequence[Segment]) -> tuple[PlacedForce, ...]:
    """The forces of a robot in the order of the file."""
    out: list[PlacedForce] = []
    for force in robot.acting_forces:
        at = lambda x: None if isinstance(x, WorldPoint) else segment_at(robot, segments, *marked(robot.links, x))  # noqa: E731
        first, count = (out[-1].first + out[-1].count if out else 0), len(list(force.values))
        ends = (at(force.between[0]), at(force.between[1]))
        further = (out[-1].inputs.stop, out[-1].states.stop) if out else (0, 0)
        out.append(PlacedForce(force.name, force.law.shape, ends, first, count, *further))
    return tuple(out)


@dataclass(frozen=True)
class CompliantRow:
    """A row of a force between frames that implicit steps take at their end, as of a joint that gives way."""

    closing: ClosingRow
    force: PlacedForce


def compliant_rows(forces: Sequence[PlacedForce]) -> tuple[CompliantRow, ...]:
    """The rows of all forces that implicit steps take at their end, which have no gap to close."""
    out: list[CompliantRow] = []
    for force in forces:
        for row in dict(force.shape.structure).get(ROWS, ()):
            out.append(CompliantRow(ClosingRow(-1, force.tips[0], force.tips[-1], row, 0.0, force.name), force))
    return tuple(out)


def added_numbers(forces: Sequence[PlacedForce], entries: np.ndarray) -> Iterator[tuple[str, float]]:
    """The parameters to which inputs are added, by name, with what is added; ``entries``: those of all forces.

    Raises UsageError where an input that is added to no parameter is not zero.
    """
    for force in forces:
        for (name, one), value in zip(force.shape.inputs.items(), entries[force.inputs], strict=True):
            if one.adds_to:
                yield f"{force.name}.{one.adds_to}", value
            elif value:
                said = "a robot at rest knows inputs of forces that are added to one of their numbers alone"
                raise UsageError(f"tau: {force.name}.{name} is {value:g}, and {said}; set it to zero, or simulate it")
