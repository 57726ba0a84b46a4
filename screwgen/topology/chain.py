"""The links: their classes, the tree that they form, their coordinates and parameters.

A link that is split into segments stands here as so many links; see :mod:`..spec.segments`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from copy import copy
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from ..arguments import Numbers, Parameters, array, choice
from ..errors import SingularError, UsageError
from ..interactions import ReportedQuantity
from ..joints.free import FREE, MOVING
from ..spec import base as kinds
from ..spec.assumptions import assumptions
from ..spec.limit import Limit
from ..spec.link_class import MARKER, link_class
from ..spec.markers import TIP as END
from ..spec.parameters import per_axis, turning
from ..spec.robot import Robot
from ..spec.segments import segments
from .coordinates import Coordinates
from .forces import CompliantRow, compliant_rows, placed_forces
from .inputs import ChosenInputs
from .loops import Closing
from .markers import PlacedMarker, markers
from .parameters import labels
from .stations import mounted
from .tree import TIP

IN_SPACE = {kinds.FLOATING: FREE, kinds.MOVING: MOVING}
"""The joints of bases whose pose is a part of the state."""
SPARED = 0.9
"""The part of the reach of a four-bar linkage that is well away from its dead centres."""


class Chain(Coordinates, ChosenInputs):
    """A robot as the algorithms see it: one class per link, the coordinates, the tree and what closes it."""

    def __init__(self, robot: Robot):
        self.robot = robot
        self.segments = segments(robot)
        self.tree, stations = mounted(robot, self.segments)
        base = IN_SPACE.get(robot.base)
        keys = [
            link_class(robot.links[s.link], robot.section_rotation, robot.order, s.number, None if i else base)
            if s.marker is None
            else MARKER
            for i, s in enumerate(self.segments)
        ]
        keys = [replace(key, stations_at=at) if at else key for key, at in zip(keys, stations, strict=True)]
        own = labels(robot)
        super().__init__(keys, [own[s.link] for s in self.segments])
        self.classes = list(dict.fromkeys(self.keys))
        self.closing = Closing.of(robot, self.segments)
        self.forces = placed_forces(robot, self.segments)

    @cached_property
    def markers(self) -> tuple[PlacedMarker, ...]:
        """The sections at which functions measure: the tip of every link, and the markers that it declares."""
        return markers(self.robot, self.segments)

    @cached_property
    def seen(self) -> Chain:
        """The same chain with a node for every marker: a tip, or a station behind those that carry links.

        So phases that run over tips and stations run over markers, and all else is as in the chain itself.
        """
        further: list[tuple[float, ...]] = [()] * self.n
        for marker in self.markers:
            i, known = marker.segment, (END, *self.keys[marker.segment].stations_at)
            if marker.at not in (*known, *further[i]):
                further[i] = (*further[i], marker.at)
        if not any(further):
            return self
        out, pairs = copy(self), zip(self.keys, further, strict=True)
        out.keys = [replace(key, stations_at=(*key.stations_at, *more)) if more else key for key, more in pairs]
        out.classes = list(dict.fromkeys(out.keys))
        counts = tuple(len(key.stations_at) for key in out.keys)
        out.tree = replace(self.tree, carried_at=self.tree.carried_at or (TIP,) * self.n, stations=counts)
        return out

    def node(self, marker: PlacedMarker) -> int:
        """The node of a marker in :attr:`seen`."""
        i, seen = marker.segment, self.seen
        if marker.at == END:
            return seen.tree.tip(i)
        return seen.tree.station(i, seen.keys[i].stations_at.index(marker.at))

    @cached_property
    def given(self) -> dict[int, int]:
        """The coordinates whose motion is given: the place in ``v`` by the number of the input, their acceleration."""
        base = range(self.n_tau)[self.inputs[kinds.BASE_MOTION]] if self.moving else ()
        return {k: self.held_places[k] for k in self.prescribed} | {k: place for place, k in enumerate(base)}

    @cached_property
    def compliant(self) -> tuple[CompliantRow, ...]:
        """The rows of forces that implicit steps take at their end, as of loops whose joints give way."""
        return compliant_rows(self.forces)

    @property
    def n_force_states(self) -> int:
        return (self.forces[-1].states.stop if self.forces else 0) + super().n_force_states

    @property
    def n_force_numbers(self) -> int:
        """The numbers of all forces between frames, the last parameters."""
        return sum(force.count for force in self.forces)

    @property
    def force_quantities(self) -> dict[str, ReportedQuantity]:
        """What runs report of the forces between frames, by the names of its entries, `spring.length`."""
        kinds = [(force.name, force.shape.kind.QUANTITIES) for force in self.forces]
        return {f"{name}.{own}": quantity for name, of in kinds for own, quantity in of.items()}

    @cached_property
    def turned_wrenches(self) -> tuple[int, ...]:
        """The segments whose row of ``w_ext`` is stated in the axes of the world."""
        return tuple(i for i, segment in enumerate(self.segments) if segment.pushed == "world")

    @property
    def acts_on_tips(self) -> bool:
        """Whether forces between frames act on tips, or wrenches in the axes of the world."""
        return bool(self.forces or self.turned_wrenches)

    @property
    def serial(self) -> bool:
        """Whether every link carries at most one other, on a fixed base, and nothing else joins or pushes them."""
        return self.tree.is_chain and not self.closing.rows and not self.floating and not self.acts_on_tips

    @property
    def needs_rates_first(self) -> bool:
        """Whether forces depend on the joint rates, which the DAE form then finds before all else."""
        return self.has_axis_forces or bool(self.closing.rows) or self.acts_on_tips or self.holds_by_motion

    @cached_property
    def parameters(self) -> Parameters:
        """The robot's parameters, and the checks of their values."""
        return Parameters(self.robot)

    def refuse_floating_base(self, what: str, instead: str) -> None:
        """Raises UsageError where the base floats: ``what`` there is none of, and what to do ``instead``."""
        if self.floating:
            said = f"robot '{self.robot.name}' has a {self.robot.base} base, for which there is no {what}"
            raise UsageError(f"{said}; {instead}")

    def refuse_loops(self, what: str, instead: str) -> None:
        """The same where loops close the tree."""
        if self.closing.rows:
            raise UsageError(f"robot '{self.robot.name}' has loops, for which there is no {what}; {instead}")

    def refuse_quaternion_joints(self, what: str, instead: str) -> None:
        """The same where a joint behind the base has coordinates that do not add up: a ball joint."""
        for part in self.curved:
            if not part.joint.in_space:
                said = (
                    f"robot '{self.robot.name}' has a {part.joint.name} joint, that of link '{self.names[part.link]}',"
                )
                raise UsageError(f"{said} for which there is no {what} yet; {instead}")

    def needs_independent_rows(self, what: str, instead: str) -> None:
        """The same where rows of the loops depend on each other in every posture."""
        if self.closing.overconstrained:
            said = f"robot '{self.robot.name}' is overconstrained: rows of its loops depend on each other, for which"
            raise UsageError(f"{said} there is no {what}; {instead}")

    def singular(self, link: int) -> SingularError:
        """The error of a link that cannot be solved for."""
        if self.keys[link].floats:
            said = f"the floating base has no inertia about some axis in this posture{self.caution}"
            return SingularError(f"{said}; give link '{self.names[link]}' a body with mass and inertia")
        said = f"the joint of link '{self.names[link]}' is singular in this posture"
        return SingularError("".join((said, *(f", or {end}" for end in self.keys[link].ends), self.caution)))

    def unresisted(self, link: int) -> SingularError:
        """The error of a link whose joint has no inertia in any posture."""
        said = f"nothing resists the joint of link '{self.names[link]}'; give the link rhoIp, a body with inertia"
        if any(part.link == link for part in self.curved):
            return SingularError(f'{said}, or axes in place of "ball" about which something resists')
        return SingularError(f"{said}, or the joint an armature")

    def singular_loops(self) -> SingularError:
        """The error of loops whose rows depend on each other in a posture."""
        remedy = "let their joints leave free what the links cannot follow, or give the links modes that can"
        remedy = f"open a brake, {remedy}" if self.braked else remedy
        return SingularError(f"the loops of '{self.robot.name}' are singular in this posture; {remedy}")

    @property
    def caution(self) -> str:
        """What else than a posture may make the mass matrix singular, for the end of a message."""
        if all(key.order != 2 for key in self.keys):
            return ""
        bent = "a link of order 2 bends so far that its mass matrix is no longer positive definite"
        return f', or {bent}; then give it order = "exact", or more segments'

    @cached_property
    def axis_names(self) -> list[str]:
        """The names of the axes (n_joints) along which torques act: of the coordinates there; of the turns of a ball
        joint about the axes of its link `hand.joint[0]` …"""
        return list(per_axis(self.robot, "joint", "slide"))

    @property
    def sliding(self) -> bool:
        """Whether any joint has a coordinate in m."""
        return not all(turning(self.robot))

    @property
    def limits(self) -> np.ndarray:
        """(n_joints, 2): lower and upper limits of the axes in the robot file, rad, of slides m; infinite without."""
        joints = (link.joint for link in self.robot.links)
        own = [limit.bounds for joint in joints for limit in joint.limits or (Limit(),) * len(joint.axes)]
        return np.array(own, float).reshape(-1, 2)

    def most(self, key: str) -> np.ndarray:
        """(n_joints,): the limits of inputs under a key of the robot file, where the drives act; infinite without."""
        joints = (link.joint for link in self.robot.links)
        own = [getattr(limit, key) for joint in joints for limit in joint.limits or (Limit(),) * len(joint.axes)]
        return np.array([math.inf if one is None else one for one in own], float)

    @cached_property
    def reach(self) -> np.ndarray:
        """(n_joints, 2): the coordinates between which four-bar linkages of the file reach, infinite without one."""
        ends = [own.reach for link in self.robot.links for own in link.joint.driven]
        return np.array(ends, float).reshape(-1, 2)

    def reached(self, q: Numbers, most: float) -> list[float]:
        """Joint coordinates between -most and most, those of linkages brought into four fifths of their reach."""
        ends = np.minimum(0.8 * np.abs(self.reach), most) / most
        return [float(x * (upper if x > 0 else lower)) for x, (lower, upper) in zip(q, ends, strict=True)]

    def within_reach(self, q: Numbers) -> bool:
        """Whether the four-bar linkages of the file reach the links at all coordinates (nq,), dead centres apart."""
        joints, (lower, upper) = np.array(self.of_joints(q), float), SPARED * self.reach.T
        return bool(((lower < joints) & (joints < upper)).all())

    @property
    def names(self) -> list[str]:
        """The names of the links, in messages and tables; of segments `boom[2]`."""
        return [s.name for s in self.segments]

    def assumptions(self, quote: str = "'") -> list[str]:
        """What the models of the links assume, in sentences; names of links stand between ``quote``."""
        pairs = zip(self.segments, self.keys, strict=True)
        return assumptions([(self.robot.links[s.link].name, key) for s, key in pairs if s.marker is None], quote)

    @property
    def identifiers(self) -> list[str]:
        """The names of the links in code; of segments `boom_2`."""
        return [s.identifier for s in self.segments]

    @cached_property
    def wrench_rows(self) -> dict[str, int]:
        """The rows of ``w_ext`` by the names of what a wrench acts on: the tips of links, then pushes."""
        rows = dict(zip((link.name for link in self.robot.links), self.lasts, strict=True))
        return rows | {s.label: i for i, s in enumerate(self.segments) if s.pushed}

    def tip_wrenches(self, given: Any, name: str) -> np.ndarray:
        """Wrenches on the tips (n, 6) from those given: of all segments, on the tips of links alone, or by names."""
        if isinstance(given, Mapping):
            out = np.zeros((self.n, 6))
            for key, wrench in given.items():
                row = self.wrench_rows[choice(key, self.wrench_rows, f"{name} there is no link or push")]
                out[row] = array(wrench, f"{name} {key}", (6,))
            return out
        links = len(self.robot.links)
        if links == self.n or not (hasattr(given, "__len__") and len(given) == links):
            return array(given, name, (self.n, 6))
        out = np.zeros((self.n, 6))
        out[self.lasts] = array(given, name, (links, 6))
        return out

    @cached_property
    def moved_joints(self) -> list[int]:
        """The joint axes that something moves and no spring holds, by their numbers among all axes."""
        joints = [(link.joint, k) for link in self.robot.links for k in range(len(link.joint.axes))]
        return [n for n, (joint, k) in enumerate(joints) if joint.is_moved(k) and not joint.has_spring(k)]

    @property
    def driven_axes(self) -> list[int]:
        """Where in `v` the axes stand on which drives act directly: all, where the file states no drive."""
        kept = self.moved_joints or range(self.n_joints)
        return [self.base_v + k for k in kept if k not in self.added_joints]

    @property
    def passive_axes(self) -> list[int]:
        """Where in `v` the axes stand on which no drive acts, neither directly nor through an elastic gear."""
        kept = {*(self.moved_joints or range(self.n_joints)), *self.added_joints}
        return [self.base_v + k for k in range(self.n_joints) if k not in kept]

    @property
    def last(self) -> int:
        """The segment whose tip is that of the robot, of the last link of the file."""
        return self.lasts[-1]

    @property
    def last_entries(self) -> slice:
        """The entries of its point among those of all tips."""
        return slice(3 * self.last, 3 * self.last + 3)

    @property
    def firsts(self) -> list[int]:
        """Where in the chain each link of the robot begins: its only or its first segment."""
        return [i for i, s in enumerate(self.segments) if s.first]

    @property
    def lasts(self) -> list[int]:
        """Where in the chain each link of the robot ends."""
        return [i for i, s in enumerate(self.segments) if s.last]
