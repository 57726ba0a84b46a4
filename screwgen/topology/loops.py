"""What closes the tree of a robot: the segments that loops join, and their rows; a coupling is a loop of one row."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..joints.constraints import Angle, Demand, Distance, Ratio, Row, demands, rows
from ..spec.couplings import coupled_axis
from ..spec.loops import joined
from ..spec.robot import Robot
from ..spec.segments import Segment
from .stations import section


@dataclass(frozen=True)
class ClosingRow:
    """One scalar condition of a loop between the tips of two segments, or of the axes of their joints."""

    loop: int
    first: int
    second: int
    row: Row
    stabilisation: float
    """1/s: the rate at which a gap closes."""
    name: str
    """`loop[0]` or `coupling[0]`, with its number in the robot file."""

    @property
    def text(self) -> str:
        """The row in words, with directions in the axes of the tips."""
        if isinstance(self.row, Distance):
            return f"{self.name}, distance along {_shown(self.row.normal)}"
        if isinstance(self.row, Angle):
            return f"{self.name}, angle between {_shown(self.row.first)} and {_shown(self.row.second)}"
        axis, of = self.row.names
        shift = f" {'-' if self.row.offset < 0 else '+'} {abs(self.row.offset):g}" if self.row.offset else ""
        of = f"{self.row.relation.words}({of})" if self.row.relation else of
        return f"{self.name}, {axis} = {self.row.ratio:g} {of}{shift}"


@dataclass(frozen=True)
class Junction:
    """All that a loop demands of the tips of two segments, whichever of its rows bear forces."""

    loop: int
    first: int
    second: int
    demands: tuple[Demand, ...]
    name: str


@dataclass(frozen=True)
class Closing:
    """What closes the tree of a robot; of one without loops and couplings all is empty."""

    junctions: tuple[Junction, ...]
    stated: tuple[ClosingRow, ...]
    """All rows, in the order of the file."""
    rows: tuple[ClosingRow, ...]
    """Those that bear forces."""
    idle: tuple[ClosingRow, ...] = ()
    """Those that no motion changes: parameters alone can open them."""
    overconstrained: bool = False
    """Whether rows depend on each other wherever the loops are closed, so that they share what they bear."""

    @classmethod
    def of(cls, robot: Robot, segments: Sequence[Segment]) -> Closing:
        """With all rows that the file states."""
        joined = junctions(robot, segments)
        rows = closing_rows(robot, joined)
        return cls(joined, rows, rows)

    @property
    def couplings(self) -> list[ClosingRow]:
        """The rows of couplings, which act on axes."""
        return [row for row in self.rows if isinstance(row.row, Ratio)]

    @property
    def related(self) -> list[tuple[int, Ratio]]:
        """The rows of couplings that have a relation, each with the link whose joint follows."""
        pairs = [(c.second, row) for c in self.couplings if isinstance(row := c.row, Ratio)]
        return [(second, row) for second, row in pairs if row.relation is not None]


def _shown(direction: Sequence[float]) -> str:
    letter = next((x for k, x in enumerate("xyz") if direction[k] == 1.0), None)
    return letter or f"[{', '.join(f'{x:g}' for x in direction)}]"


def segment_at(robot: Robot, segments: Sequence[Segment], link: int, s: float) -> int:
    """The segment whose tip is at a place of a link: one that ends there, or the marker."""
    for i, segment in enumerate(segments):
        if segment.link == link and segment.marker == s and not segment.pushed:
            return i
    return section(robot, [i for i, segment in enumerate(segments) if segment.first], link, s)[0]


def junctions(robot: Robot, segments: Sequence[Segment]) -> tuple[Junction, ...]:
    """The loops in the order of the file, then the couplings."""
    out = []
    for k, loop in robot.rigid_loops.items():
        first, second = (segment_at(robot, segments, *joined(robot.links, loop, end)) for end in range(2))
        out.append(Junction(k, first, second, demands(loop.joint.screws), f"loop[{k}]"))
    firsts = [i for i, segment in enumerate(segments) if segment.first]
    for k, coupling in enumerate(robot.couplings):
        axes = [coupled_axis(robot.links, name) for name in (coupling.of, coupling.axis)]
        of, axis = (sum(len(link.joint.axes) for link in robot.links[: a.link]) + a.number for a in axes)
        unit = "rad" if robot.links[axes[1].link].joint.screws[axes[1].number].turn else "m"
        ratio = Ratio(axis, of, coupling.ratio, coupling.offset, unit, (coupling.axis, coupling.of), coupling.relation)
        ends = (firsts[a.link] for a in axes)
        first, second = ends
        out.append(Junction(len(robot.loops) + k, first, second, (ratio,), f"coupling[{k}]"))
    return tuple(out)


def closing_rows(robot: Robot, junctions: Sequence[Junction]) -> tuple[ClosingRow, ...]:
    """All rows of all loops, in the order of the file, then those of couplings."""
    loops = (
        ClosingRow(j.loop, j.first, j.second, row, loop.stabilisation, j.name)
        for j, loop in zip(junctions, robot.rigid_loops.values(), strict=False)
        for row in rows(loop.joint.screws)
    )
    couplings = (
        ClosingRow(j.loop, j.first, j.second, row, coupling.stabilisation, j.name)
        for j, coupling in zip(junctions[len(robot.rigid_loops) :], robot.couplings, strict=True)
        for row in j.demands
        if isinstance(row, Ratio)
    )
    return (*loops, *couplings)
