"""The robot of a sketch in space: where its links are in a posture, bent so that one sees how, and where to look from.

Links of very different lengths are drawn with more equal ones, unless loops or forces join them. The shapes are those
of the first mode of each direction.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ...bodies.markers import displacement
from ...spec.link_class import AXIS, LinkClass
from ...spec.parameters import Parameter, parameters
from ...spec.reduced import end, reach
from ...topology.chain import Chain
from ...topology.tree import TIP
from ..numpy.closing import CLOSED, modes, nearest, unwound
from ..numpy.numeric import Numeric
from ..numpy.rest_shape import bent_line, line_at_rest

MOST_LINKS = 12
"""Of a robot with more links only the first are drawn."""
SHORTEST = 0.3
"""The least length of a link as it is drawn, over the largest."""
SAG = 0.19
"""How far the modes of a direction displace the tip of a link, over its length."""
MOST_BENT, LEAST_BENT = 5, 0.4
"""Of a robot with more parts that bend each is bent less, down to that part of it: they would curl up."""
STRETCH = 0.08
"""The same of axial modes."""
PLACES = tuple(float(s) for s in np.linspace(0.0, 1.0, 17))
"""Along a link, at which its centreline is known."""
TURNS = (0.5, 0.9)
"""rad: how far joints turn in the postures that are tried."""
SLIDE = 0.3
"""How far they slide, over the size of the robot."""
SIGNS = ((1.0,), (-1.0,), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0, -1.0))
"""The senses in which joints turn, again and again along the chain."""
BENDING = (0.0, 1.0)
"""The parts of the deflections by which links are bent one after the other, while loops stay closed."""
COARSE, DIGITS = 2, 9
"""The decimals, rad or m, of where the last search of a posture begins, and of where it ends."""
ALONG = 0.9
"""A link that turns about an axis that has more than this part along it stays where it is."""


@dataclass(frozen=True)
class LinkShape:
    """A link, or one of its segments, in inertial axes, m."""

    number: int
    """Its place in the chain."""
    turn: np.ndarray
    """(3, 3): the axes of its frame, as columns."""
    origin: np.ndarray
    """(3,): that frame's origin."""
    line: np.ndarray
    """(places, 3): its centreline from the joint point to the tip."""
    straight: np.ndarray
    """(2, 3): the ends of the undeformed centreline; of one that is curved at rest those of the line along its base."""
    rest: np.ndarray
    """(2, 3), or (places, 3) of a curved one: the undeformed centreline."""
    mount: np.ndarray
    """(3,): where its joint sits, from which slides move it away."""
    carrier: np.ndarray
    """(3,): the point of the section that carries it, or of its foot on the world."""
    axes: tuple[np.ndarray, ...]
    """The directions of the axes of its joint."""
    slides: bool
    """Whether its joint moves it away from the mount."""
    bends: tuple[np.ndarray, ...]
    """Those across the link in which modes displace it."""

    @property
    def joint(self) -> np.ndarray:
        """The joint point."""
        return self.line[0]

    @property
    def tip(self) -> np.ndarray:
        """The tip point."""
        return self.line[-1]

    @property
    def long(self) -> float:
        """The length of the undeformed centreline."""
        return float(np.linalg.norm(self.straight[1] - self.straight[0]))

    def at(self, s: float) -> np.ndarray:
        """A point of the centreline."""
        return np.array([np.interp(s, PLACES, column) for column in self.line.T])


@dataclass(frozen=True)
class SketchPose:
    """A robot in a posture."""

    q: np.ndarray
    neutral: bool
    """Whether all joints are at zero."""
    closed: bool
    """Whether all loops are closed, and all linkages reach their links."""
    parts: tuple[LinkShape, ...]
    ends: np.ndarray
    """(n, 3): the tip points of all segments, of markers that loops join their places."""

    def part(self, segment: int) -> LinkShape | None:
        """The part that is a segment of the chain, if it is drawn."""
        return next((part for part in self.parts if part.number == segment), None)


class SketchView(NamedTuple):
    """The directions to the right, upwards and towards the reader, unit vectors in inertial axes."""

    right: np.ndarray
    up: np.ndarray
    towards: np.ndarray

    def flat(self, points: np.ndarray) -> np.ndarray:
        """(..., 2): points as the reader sees them."""
        return np.asarray(points @ np.array([self.right, self.up]).T)


# ------------------------------------------------------------------------------------------ lengths


def true_lengths(chain: Chain) -> dict[int, float]:
    """The lengths of the links, by their numbers, m."""
    return {k: reach(link) for k, link in enumerate(chain.robot.links)}


def drawn_lengths(chain: Chain) -> dict[int, float]:
    """The same as they are drawn."""
    true = true_lengths(chain)
    if chain.robot.loops or chain.forces:
        return true
    least = SHORTEST * max(true.values())
    rods = [k for k, link in enumerate(chain.robot.links) if link.length is not None]
    return true | {k: max(true[k], least) for k in rods}


def drawn(chain: Chain, lengths: dict[int, float]) -> Numeric:
    """The functions of the robot with links of these lengths, which turn as far at rest as they do."""
    true = true_lengths(chain)

    def value(p: Parameter) -> float:
        if p.link is None or p.field.partition(".")[0] not in ("length", "rest", "rest_at"):
            return p.value
        return lengths[p.link] if p.field == "length" else p.value * true[p.link] / lengths[p.link]

    return Numeric(chain, [value(p) for p in parameters(chain.robot)])


def size(chain: Chain, lengths: dict[int, float]) -> float:
    """The length of the longest link, m, or of the largest offset of a joint where links have none."""
    mounts = [np.linalg.norm(link.joint.mount.xyz or 0.0) for link in chain.robot.links if link.joint.mount]
    return float(max(lengths.values()) or max(mounts, default=0.0) or 1.0)


# ----------------------------------------------------------------------------------------- postures


def poses(chain: Chain) -> list[SketchPose]:
    """The postures that may be drawn, the neutral one first."""
    lengths = drawn_lengths(chain)
    numeric, bent = drawn(chain, lengths), _bent(chain, lengths)
    found = [_closed(numeric, q, bent) for q in _postures(chain, size(chain, lengths))]
    kept = [q for q in found if q is not None and _reached(chain, q)]
    return [_pose(numeric, q, lengths, bool(kept)) for q in kept or [np.array(chain.home) + bent]]


def _postures(chain: Chain, far: float) -> Iterator[np.ndarray]:
    """Coordinates (nq,) of the joints alone."""
    home = np.array(chain.home, float)
    yield home
    screws = [screw for link in chain.robot.links for screw in link.joint.screws]
    moved = [k for k, screw in enumerate(screws) if not screw.turn or abs(screw.axis[0]) < ALONG]
    patterns = [(a, signs) for a in TURNS for signs in SIGNS]
    patterns = patterns[:1] if chain.closing.junctions else patterns
    for angle, signs in patterns if moved else ():
        q = home.copy()
        for place, k in enumerate(moved):
            wanted = angle * signs[place % len(signs)] if screws[k].turn else SLIDE * far
            q[chain.axis_places[k]] += np.clip(wanted, *_range(chain, k))
        yield chain.unit(q)


def _range(chain: Chain, axis: int) -> np.ndarray:
    """The coordinates of an axis within its limits and, well within, the reach of its linkage."""
    lower, upper = np.array([chain.limits[axis], 0.7 * chain.reach[axis]]).T
    return np.array([max(lower), max(min(upper), max(lower))])


def _reached(chain: Chain, q: np.ndarray) -> bool:
    """Whether all linkages reach their links."""
    x = q[list(chain.axis_places)]
    return bool(np.all((chain.reach[:, 0] < x) & (x < chain.reach[:, 1])))


def _closed(numeric: Numeric, q: np.ndarray, bent: np.ndarray) -> np.ndarray | None:
    """The posture with bent links in which loops are closed, or with links as bent as they can be then; None: open."""
    chain, found = numeric.chain, None
    if not chain.closing.junctions:
        return q + bent
    movable = ~modes(chain)
    movable[: chain.base_q] = False
    for share in BENDING:
        start = np.where(movable, q if found is None else found, q + share * bent)
        end = _searched(numeric, start, movable)
        if end is None:
            break
        found = end
    return found


def _searched(numeric: Numeric, start: np.ndarray, movable: np.ndarray) -> np.ndarray | None:
    """A posture near a start in which loops are closed, the same on all machines; None where none is found.

    Where loops leave joints free, rounding errors lead a search elsewhere. So it ends with a short one from coordinates
    of few decimals.
    """
    for decimals in (COARSE, DIGITS):
        end = nearest(numeric, start, movable, hasty=True)
        if np.max(np.abs(numeric.offsets(end))) > CLOSED:
            return None
        start = np.where(movable, np.round(unwound(numeric.chain, end, start), decimals), start)
    return start


def _bent(chain: Chain, lengths: dict[int, float]) -> np.ndarray:
    """(nq,): coordinates of the first mode of each direction, of a deflection that can be seen."""
    q = np.zeros(chain.nq)
    less = max(LEAST_BENT, min(1.0, MOST_BENT / max(1, sum(bool(key.modes) for key in chain.keys))))
    for i, (segment, key) in enumerate(zip(chain.segments, chain.keys, strict=True)):
        own = chain.robot.links[segment.link]
        long, seen = lengths[segment.link] / own.pieces, set()
        for k, (direction, _) in enumerate(key.directions):
            group = AXIS.get(direction, -1)
            if group not in seen and direction != "torsion":
                seen.add(group)
                share = (STRETCH if direction == "axial" else less * SAG) / own.pieces
                q[chain.eta_q + chain.eta_offset[i] + k] = share * long / _largest(key, k)
    return q


def _largest(key: LinkClass, mode: int) -> float:
    """The largest displacement of the centreline by a unit of a mode."""
    return float(np.max(np.linalg.norm(displacement(key, PLACES)[:, :, mode], axis=1))) or 1.0


# ---------------------------------------------------------------------------------------- in space


def _pose(numeric: Numeric, q: np.ndarray, lengths: dict[int, float], closed: bool) -> SketchPose:
    R, r = numeric.link_pose(q)
    _, tips = numeric.tip_poses(q)
    chain, parts = numeric.chain, list[LinkShape]()
    for i, segment in enumerate(chain.segments):
        if segment.marker is None and segment.link < MOST_LINKS:
            parts.append(_part(chain, q, i, (R[i], r[i], tips[i]), lengths, parts))
    neutral = bool(np.allclose(q[: chain.eta_q], chain.home[: chain.eta_q], atol=1e-6))
    return SketchPose(q, neutral, closed, tuple(parts), tips)


def _part(
    chain: Chain,
    q: np.ndarray,
    i: int,
    placed: tuple[np.ndarray, np.ndarray, np.ndarray],
    lengths: dict[int, float],
    before: Sequence[LinkShape],
) -> LinkShape:
    (R, r, tip), segment, key = placed, chain.segments[i], chain.keys[i]
    link = chain.robot.links[segment.link]
    ahead = np.array([(link.frame_at or 0.0) if segment.first else 0.0, 0.0, 0.0])
    base = r - R @ ahead
    way = end(link)
    way = R @ (way if key.elastic is not None else np.array([lengths[segment.link] / link.pieces, 0.0, 0.0]))
    rest = np.array([base, base + way])
    line = base + np.outer(PLACES, way) + _displaced(chain, q, i) @ R.T
    if key.rest and link.rest:
        turns = [x * (link.length or 0.0) / lengths[segment.link] for x in link.rest.numbers]
        rod = key, lengths[segment.link] / link.pieces, turns
        rest = base + line_at_rest(*rod, PLACES) @ R.T
        line = base + bent_line(*rod, _modal(chain, q, i), PLACES) @ R.T
    line += np.outer(np.square(PLACES), tip - line[-1])
    mount, axes = _joint(chain, q, i, R, base)
    across = {AXIS[direction] for direction, _ in key.directions if direction in AXIS}
    bends = tuple(R[:, k] for k in sorted(across - {0}))
    carrier, straight = _carried(chain, i, mount, before), np.array([base, base + way])
    return LinkShape(i, R, r, line, straight, rest, mount, carrier, axes, key.slides, bends)


def _displaced(chain: Chain, q: np.ndarray, i: int) -> np.ndarray:
    """(places, 3): the displacement of the centreline, in axes of the link."""
    return np.asarray(displacement(chain.keys[i], PLACES) @ _modal(chain, q, i))


def _modal(chain: Chain, q: np.ndarray, i: int) -> np.ndarray:
    """Its modal coordinates."""
    first = chain.eta_q + chain.eta_offset[i]
    return q[first : first + chain.keys[i].modes]


def _joint(
    chain: Chain, q: np.ndarray, i: int, R: np.ndarray, base: np.ndarray
) -> tuple[np.ndarray, tuple[np.ndarray, ...]]:
    """Where a joint sits, and the directions of its axes."""
    key, turn, place = chain.keys[i], R, base
    if not key.screws:
        return base, tuple(R @ np.array(screw.axis) for screw in key.joint.along)
    axes: list[np.ndarray] = []
    for screw, x in zip(key.screws[::-1], q[chain.q_offset[i] :][: len(key.screws)][::-1], strict=True):
        axis = np.array(screw.axis)
        axes.insert(0, turn @ axis)
        place = place - turn @ (screw.travel * x * axis)
        turn = turn @ rotation(axis, -x * screw.turn)
    return place, tuple(axes)


def rotation(axis: np.ndarray, angle: float) -> np.ndarray:
    """(3, 3): a turn about a unit vector."""
    K = np.cross(np.eye(3), axis)
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K)


def _carried(chain: Chain, i: int, mount: np.ndarray, before: Sequence[LinkShape]) -> np.ndarray:
    """The point of its carrier on which a link is mounted; of a link on the world its joint's own place."""
    parent, station = chain.tree.parents[i], chain.tree.at(i)
    carrier = next((part for part in before if part.number == parent), None)
    if carrier is None:
        return mount
    return carrier.at(1.0 if station == TIP else chain.keys[parent].stations_at[station])
