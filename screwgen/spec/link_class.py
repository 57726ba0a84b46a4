"""Link classes: the structure of a link without its numbers. Links of one class share one derivation."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, replace
from functools import cached_property

from ..bases import Basis, Shapes, shapes
from ..elements import AxisElement, HeldLaw, Travel, gear
from ..joints.kind import JointKind
from ..joints.product import WELD as WELDED
from ..joints.screw import Screw
from ..reduction.invariants import Invariants
from .axis_laws import HeldOnAxis, LawOnAxis, held_laws, laws
from .drive_class import DriveClass, Stop, drive_classes, stops
from .joint import Joint
from .markers import TIP
from .modes import DIRECTIONS, SHEARED
from .reduced import damped, directions, elastic
from .rest import gauss_points
from .robot import Link
from .tendons import TendonClass, tendon_classes

WELD = Joint(axes=())
EXACT = "exact"
"""The order of a rod whose kinematics are not expanded in its strains."""
AXIS = {"axial": 0, "bending_y": 1, "bending_z": 2, "shear_y": 1, "shear_z": 2}
"""The axis of F_i along which the modes of a direction displace the centreline; torsion does not."""
TURN = {"torsion": (0, 1), "bending_z": (1, -1), "bending_y": (2, 1)}
"""The axis about which the modes of a direction turn the sections, and the sign of the turn; shear does not."""


@dataclass(frozen=True)
class BodyClass:
    """Which properties a rigid body states."""

    at: str
    com: bool
    inertia: bool


@dataclass(frozen=True)
class LinkClass:
    """Everything of a link but its numbers: the complete key of its derivation."""

    bases: tuple[str | Basis, ...]
    """The basis of each direction that has modes."""
    counts: tuple[int, ...]
    """The numbers of modes in the order of `DIRECTIONS`; without shear the first four."""
    joint: JointKind
    """The kind of the joint: how the link moves relative to its carrier."""
    mount_xyz: bool = False
    mount_rpy: bool = False
    armature: bool = False
    joint_damping: bool = False
    stiffness: bool = False
    frame_at: bool = False
    spin: bool = False
    damping: tuple[str, ...] = ()
    """The terms of the damping of the modes, see `reduced.damped`; none: the modes are undamped."""
    section_rotation: bool = False
    bodies: tuple[BodyClass | None, ...] = ()
    """The link's bodies; None for those on other segments."""
    length: bool = True
    """Whether the link states a length."""
    beam: bool = True
    """Whether the link states a section, and so is a rod."""
    body: Hashable | None = None
    """A rigid body from outside, see :class:`screwgen.bodies.contract.RigidMoments`."""
    elastic: Invariants | None = None
    """A flexible body given by numbers; they are part of the class."""
    order: int | str = 1
    """The order of the rod's shape in its strains, 1 or 2, or EXACT."""
    points: int = 0
    """The number of Gauss points of a rod of order EXACT that the robot file states or that its curvature at rest asks
    for; 0: by the number of modes."""
    rest: tuple[str, ...] = ()
    """The directions in which a rod of order EXACT is bent at rest."""
    rest_at: tuple[float, ...] = ()
    """The places s in [0, 1] along the link at which that is stated; none: it is the same all along."""
    measured: tuple[str, ...] = ()
    """The directions whose stiffness is stated by natural frequencies."""
    stations: tuple[float, ...] = ()
    """The places s in [0, 1] at which a section that varies is stated; none: the rod is uniform."""
    between: str = "linear"
    """How the section's properties are interpolated between the stations."""
    segments: int = 1
    """The number of equal segments of the link, of which this is the class of one."""
    segment: int = 0
    """Which segment, where section or curvature at rest vary; segments of a uniform link have equal bodies."""
    rotary: tuple[int, ...] = ()
    """The transverse axes (1: y, 2: z) about which the sections have a rotary inertia."""
    drives: tuple[DriveClass, ...] = ()
    """The drives of the axes; none where the robot file states none."""
    stops: tuple[Stop, ...] = ()
    """The stops of the axes, axis by axis; none where limits have no stiffness."""
    stop_damping: tuple[int, ...] = ()
    """The axes whose stops have damping."""
    limits: tuple[tuple[type[HeldLaw], int], ...] = ()
    """The laws of what a step holds that limits of the axes state, each with its axis."""
    prescribed: tuple[int, ...] = ()
    """The axes whose motion is given: their input is an acceleration."""
    brakes: tuple[int, ...] = ()
    """The axes that have a brake."""
    elements: tuple[tuple[type[AxisElement], int], ...] = ()
    """The elements of the axes by their kind, each with its axis."""
    tendons: tuple[TendonClass, ...] = ()
    """The pieces of tendons along the link."""
    has_inertialess_section_modes: bool = False
    """Whether modes turn sections that have no rotary inertia, without moving the centreline: see `Modes.alike`."""
    stations_at: tuple[float, ...] = ()
    """The places s in [0, 1) along the link, or along its segment, at which it carries others, besides its tip."""
    section_at: float = TIP
    """The place of the section that blocks of the tip describe; see `station`."""

    def station(self, number: int) -> LinkClass:
        """The class in which a station stands for the tip; it carries no bodies."""
        bodies = tuple(body if body and body.at != "tip" else None for body in self.bodies)
        return replace(self, section_at=self.stations_at[number], stations_at=(), bodies=bodies if any(bodies) else ())

    @property
    def modes(self) -> int:
        """The number of modal coordinates."""
        return len(self.directions)

    @property
    def bends(self) -> bool:
        """Whether the link has modes of bending whose model ends at large ones, or a body from a file that has a reach.

        A rod of order EXACT bends as far as it likes.
        """
        rod = any(self.counts[1:3]) and self.order != EXACT
        return rod or (self.elastic is not None and self.elastic.reach > 0)

    @property
    def turned(self) -> tuple[int, ...]:
        """The axes about which the sections have an inertia of their own: spin, rotary inertia."""
        return (0,) * self.spin + self.rotary

    def turns(self, axis: int) -> bool:
        """Whether modes turn the sections about an axis."""
        return any(d in TURN and TURN[d][0] == axis for d, _ in self.directions)

    @property
    def lacks_geometric_stiffness(self) -> bool:
        """Whether the link is a rod whose model leaves out what axial loads and rotation do to its bending."""
        return any(self.counts[1:3]) and self.order == 1

    @property
    def screws(self) -> tuple[Screw, ...]:
        """The screws of the joint, in order; none of a joint of another kind."""
        return self.joint.screws

    @property
    def joints(self) -> int:
        """The number of joint rates: the columns of the motion subspace."""
        return self.joint.nv

    @property
    def torques(self) -> int:
        """The number of the joint's torques."""
        return self.joint.torques

    @property
    def floats(self) -> bool:
        """Whether the link is a floating base, which nothing carries."""
        return self.joint.in_space

    @property
    def slides(self) -> bool:
        """Whether the joint moves its link along an axis."""
        return self.joint.slides

    @property
    def added_axes(self) -> tuple[int, ...]:
        """The axis of each coordinate that an elastic gear adds: of its rotor, or of the stretch of a transmission."""
        return tuple(k for k, drive in enumerate(self.drives) if drive.elastic)

    @cached_property
    def travels(self) -> dict[int, Travel]:
        """The axes whose drives have a transmission, and what it is."""
        return {k: drive.travel for k, drive in enumerate(self.drives) if drive.travel}

    @property
    def elastic_travels(self) -> tuple[int, ...]:
        """The axes whose drives have a transmission with an elastic gear."""
        return tuple(k for k in self.travels if self.drives[k].elastic)

    @property
    def ends(self) -> list[str]:
        """Where the transmissions of its axes end, for messages."""
        said = (travel.limit(self.drives[axis].elastic) for axis, travel in self.travels.items())
        return list(dict.fromkeys(filter(None, said)))

    @cached_property
    def laws(self) -> tuple[LawOnAxis, ...]:
        """The forces that are not linear on the coordinates of the joint: friction, stops, elements of axes."""
        return tuple(laws(self))

    @cached_property
    def internal(self) -> tuple[LawOnAxis, ...]:
        """Those of the laws that have an internal state, kind by kind."""
        kinds = dict.fromkeys(one.law for one in self.laws if one.law.state is not None)
        return tuple(one for law in kinds for one in self.laws if one.law == law)

    @cached_property
    def held_laws(self) -> tuple[HeldOnAxis, ...]:
        """What every step does to the inputs of the joint's axes before it holds them, in order."""
        return tuple(held_laws(self))

    @cached_property
    def remembering(self) -> tuple[HeldOnAxis, ...]:
        """Those of them that have an internal state."""
        return tuple(one for one in self.held_laws if one.kind.state is not None)

    @property
    def has_constant_inertia(self) -> bool:
        """Whether the joint's coordinates have an inertia of their own, the same in every posture."""
        return self.armature or self._gears_add("inertia")

    @property
    def has_travelling_inertia(self) -> bool:
        """Whether they have one that depends on the posture."""
        return any(gear.travelling(self.drives[axis].stated) for axis in self.travels)

    @property
    def has_springs(self) -> bool:
        """Whether springs act on the joint's axes, those of gears among them."""
        return self.stiffness or self._gears_add("stiffness")

    @property
    def has_dampers(self) -> bool:
        """Whether viscous dampers act on the joint's axes."""
        return self.joint_damping or self._gears_add("damping")

    def _gears_add(self, term: str) -> bool:
        """Whether gears add one of the :class:`..elements.Terms` to an axis."""
        added = lambda x: getattr(gear.linear(x.elastic, x.travel).axis, term)  # noqa: E731
        return any(added(drive)(drive.stated) for drive in self.drives)

    @property
    def has_axis_forces(self) -> bool:
        """Whether springs, dampers, friction, stops or other elements act on the joint's axes."""
        acts = any(one.part == "q" for one in self.laws)
        return self.has_dampers or self.has_springs or acts or bool(self.elastic_travels)

    @cached_property
    def directions(self) -> tuple[tuple[str, int], ...]:
        """Direction and number (from 0) of every modal coordinate, in their order."""
        return directions(self.counts, self.elastic)

    @cached_property
    def coupled(self) -> tuple[tuple[int, int], ...]:
        """Row and column of the entries below the diagonal of the modal inertia, stiffness and damping.

        A uniform rod of Euler and Bernoulli has none. Where its sections vary the modes of one direction are coupled,
        by rotary inertia those of bending in a plane, by mass those of bending and shear in a plane. Those of a body
        from a file are as its matrices have it.
        """
        if self.elastic is not None:
            return self.elastic.coupled
        of = [d for d, _ in self.directions]
        return tuple((i, j) for i in range(self.modes) for j in range(i) if self._couples(of[i], of[j]))

    @cached_property
    def rest_shapes(self) -> tuple[tuple[str, int], ...]:
        """Direction and station (0 of one that is the same all along) of every number of the curvature at rest."""
        return tuple((direction, k) for direction in self.rest for k in range(len(self.rest_at) or 1))

    @property
    def full_inertia(self) -> bool:
        """Whether the inertia of the modes has entries off its diagonal, constant ones or by bending."""
        return bool(self.coupled) or self.order == EXACT

    def _couples(self, first: str, second: str) -> bool:
        if first != second:
            return AXIS.get(first) == AXIS.get(second)
        return bool(self.stations) or (first in TURN and TURN[first][0] in self.rotary)

    def shapes(self, direction: str) -> Shapes:
        """The mode shapes of a direction."""
        k = DIRECTIONS.index(direction)
        return shapes(self.bases[k], direction, self.counts[k])

    def bodies_at(self, section: str) -> list[int]:
        return [b for b, body in enumerate(self.bodies) if body and body.at == section]


MARKER = LinkClass(bases=("",) * 4, counts=(0,) * 4, joint=WELDED, length=False, beam=False)
"""The class of a marker that a loop joins: a link without mass, welded to the section."""


def link_class(
    link: Link, section_rotation: bool, order: int | str = 1, segment: int = 0, base: JointKind | None = None
) -> LinkClass:
    """The class of a link, or of one of its segments, in a robot whose ``section_rotation`` and ``order`` are given.

    ``base``: the joint of the segment that is a base in space.
    """
    joint, modes, count, body = (link.joint if segment == 0 else WELD), link.modes, link.pieces, elastic(link)
    counts, mount, stations = modes.counts, joint.mount, link.section.places if link.section else ()
    stated, rest_at = link.section.states if link.section else lambda _: False, link.rest.places if link.rest else ()
    here = {"base": segment == 0, "tip": segment == count - 1}
    bodies = [BodyClass(b.at, b.com is not None, b.inertia is not None) if here[b.at] else None for b in link.bodies]
    return LinkClass(
        bases=tuple(modes.basis_of(d) if n else "" for d, n in zip(DIRECTIONS, counts, strict=False)),
        counts=counts,
        joint=base or joint.kind,
        mount_xyz=mount is not None and mount.xyz is not None,
        mount_rpy=mount is not None and mount.rpy is not None,
        armature=bool(joint.armature),
        joint_damping=bool(joint.damping),
        stiffness=bool(joint.stiffness),
        drives=drive_classes(joint),
        stops=stops(joint),
        stop_damping=tuple(k for k, x in enumerate(joint.limits or ()) if x.damping is not None),
        limits=tuple((law, k) for k, x in enumerate(joint.limits or ()) for law in x.laws if k not in joint.prescribed),
        prescribed=joint.prescribed,
        brakes=joint.braked,
        elements=tuple((type(one), axis) for axis, own in enumerate(joint.elements or ()) for one in own),
        frame_at=link.frame_at is not None,
        length=link.length is not None,
        beam=link.section is not None,
        body=link.body if here["base"] and not body else None,
        elastic=body,
        spin=stated("rhoIp"),
        damping=damped(link) if any(counts) or body is not None else (),
        section_rotation=section_rotation and (any(counts[1:4]) or body is not None or link.rest is not None),
        bodies=tuple(bodies) if any(bodies) else (),
        order=1 + body.geometric if body else (link.order or order) if any(counts) else 1,
        points=gauss_points(link) if (link.order or order) == EXACT else 0,
        rest=link.rest.directions if link.rest else (),
        rest_at=rest_at,
        measured=modes.measured,
        stations=stations,
        between=link.section.between if link.section else "linear",
        segments=count,
        segment=segment if stations or rest_at else 0,
        tendons=tendon_classes(link, segment),
        rotary=tuple(k for k, name in ((1, "rhoIy"), (2, "rhoIz")) if stated(name)),
        has_inertialess_section_modes=any(
            modes.alike(d) and not stated(inertia) for d, (_, inertia) in SHEARED.items()
        ),
    )
