"""The markers of a robot, sections of its links at which functions measure, and the chain that has them as stations."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from ..spec.markers import TIP as END
from ..spec.markers import reached
from ..spec.robot import Robot
from ..spec.segments import Segment
from .stations import section
from .tree import TIP

if TYPE_CHECKING:
    from .chain import Chain


@dataclass(frozen=True)
class Marker:
    """The tip of a link, or a place on it that the robot file names."""

    name: str
    """``boom.tip``, ``boom.hook``."""
    segment: int
    """The segment of the chain on which it is."""
    at: float
    """The place s along this segment."""

    is_tip: bool
    """Whether every link has it."""

    def node(self, seen: Chain) -> int:
        """Its node in :func:`with_markers`."""
        if self.at == END:
            return seen.tree.tip(self.segment)
        return seen.tree.station(self.segment, seen.keys[self.segment].stations_at.index(self.at))


def markers(robot: Robot, pieces: Sequence[Segment]) -> tuple[Marker, ...]:
    """The markers of all links, in the order of the file: of each its tip, then those that it declares."""
    firsts = [place for place, segment in enumerate(pieces) if segment.first]
    out = []
    for i, link in enumerate(robot.links):
        named = [("tip", END), *((marker.name, marker.at) for marker in link.markers)]
        places = [(name, section(robot, firsts, i, reached(link, s, ()))) for name, s in named]
        out += [Marker(f"{link.name}.{name}", *place, is_tip=name == "tip") for name, place in places]
    return tuple(out)


def with_markers(chain: Chain) -> Chain:
    """The chain in which every marker is a node: a tip, or a station behind those that carry links.

    So phases that run over tips and stations run over markers, and all else is as in the chain itself.
    """
    further: list[tuple[float, ...]] = [()] * chain.n
    for marker in chain.markers:
        i, known = marker.segment, (END, *chain.keys[marker.segment].stations_at)
        if marker.at not in (*known, *further[i]):
            further[i] = (*further[i], marker.at)
    if not any(further):
        return chain
    out, tree = copy(chain), chain.tree
    pairs = zip(chain.keys, further, strict=True)
    out.keys = [replace(key, stations_at=(*key.stations_at, *more)) if more else key for key, more in pairs]
    out.classes = list(dict.fromkeys(out.keys))
    counts = tuple(len(key.stations_at) for key in out.keys)
    out.tree = replace(tree, carried_at=tree.carried_at or (TIP,) * chain.n, stations=counts)
    return out
