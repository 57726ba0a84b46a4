"""Link classes: the structure of a link without its numbers. Links of one class share one derivation."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from functools import cached_property

from ..bases import Basis, shapes
from ..reduction.invariants import Invariants
from .reduced import damped, directions, elastic
from .robot import Link
from .screw import Screw
from .values import DIRECTIONS


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
    counts: tuple[int, int, int, int]
    screws: tuple[Screw, ...]
    """The degrees of freedom of the joint, in order."""
    mount_xyz: bool
    mount_rpy: bool
    armature: bool
    joint_damping: bool
    stiffness: bool
    frame_at: bool
    spin: bool
    damping: bool
    section_rotation: bool
    bodies: tuple[BodyClass, ...]
    length: bool = True
    """Whether the link states a length."""
    beam: bool = True
    """Whether the link states a section, and so is a rod."""
    body: Hashable | None = None
    """A rigid body from outside, see :class:`screwgen.bodies.contract.RigidMoments`."""
    elastic: Invariants | None = None
    """A flexible body given by numbers; they are part of the class."""
    order: int = 1
    """The order of the rod's shape in its strains, 1 or 2."""
    measured: tuple[str, ...] = ()
    """The directions whose stiffness is stated by natural frequencies."""
    stations: tuple[float, ...] = ()
    """The places s in [0, 1] at which a section that varies is stated; none: the rod is uniform."""
    between: str = "linear"
    """How the section's properties are interpolated between the stations."""

    @property
    def modes(self) -> int:
        """The number of modal coordinates."""
        return len(self.directions)

    @property
    def bends(self) -> bool:
        """Whether the link has modes of bending, or of a body from a file whose tip is not at its base."""
        return any(self.counts[1:3]) or (self.elastic is not None and self.elastic.reach > 0)

    @property
    def unstiffened(self) -> bool:
        """Whether the link is a rod whose model leaves out what axial loads and rotation do to its bending."""
        return any(self.counts[1:3]) and self.order == 1

    @property
    def joints(self) -> int:
        """The number of joint coordinates."""
        return len(self.screws)

    @property
    def slides(self) -> bool:
        """Whether the joint moves its link along an axis."""
        return any(screw.slides for screw in self.screws)

    @property
    def sprung(self) -> bool:
        """Whether springs or dampers act on the joint's axes."""
        return self.joint_damping or self.stiffness

    @cached_property
    def directions(self) -> tuple[tuple[str, int], ...]:
        """Direction and number (from 0) of every modal coordinate, in their order."""
        return directions(self.counts, self.elastic)

    @cached_property
    def coupled(self) -> tuple[tuple[int, int], ...]:
        """Row and column of the entries below the diagonal of the modal inertia, stiffness and damping.

        A uniform rod has none. Where its sections vary the modes of one direction are coupled; those of a body from a
        file are as its matrices have it.
        """
        if self.elastic is not None:
            return self.elastic.coupled
        if not self.stations:
            return ()
        of = [d for d, _ in self.directions]
        return tuple((i, j) for i in range(self.modes) for j in range(i) if of[i] == of[j])

    def shapes(self, direction: str):
        """The mode shapes of a direction."""
        k = DIRECTIONS.index(direction)
        return shapes(self.bases[k], direction, self.counts[k])

    def bodies_at(self, section: str) -> list[int]:
        return [b for b, body in enumerate(self.bodies) if body.at == section]


def link_class(link: Link, section_rotation: bool, order: int = 1) -> LinkClass:
    """The class of a link in a robot whose ``section_rotation`` and ``order`` are given."""
    joint, modes = link.joint, link.modes
    counts, body = modes.counts, elastic(link)
    mount = joint.mount
    return LinkClass(
        bases=tuple(modes.basis_of(d) if n else "" for d, n in zip(DIRECTIONS, counts, strict=True)),
        counts=counts,
        screws=joint.screws,
        mount_xyz=mount is not None and mount.xyz is not None,
        mount_rpy=mount is not None and mount.rpy is not None,
        armature=bool(joint.armature),
        joint_damping=bool(joint.damping),
        stiffness=bool(joint.stiffness),
        frame_at=link.frame_at is not None,
        length=link.length is not None,
        beam=link.section is not None,
        body=None if body else link.body,
        elastic=body,
        spin=link.section is not None and link.section.states("rhoIp"),
        damping=damped(link) and (any(counts) or body is not None),
        section_rotation=section_rotation and (any(counts[1:]) or body is not None),
        bodies=tuple(BodyClass(b.at, b.com is not None, b.inertia is not None) for b in link.bodies),
        order=1 + body.geometric if body else (link.order or order) if any(counts) else 1,
        measured=modes.measured,
        stations=link.section.places if link.section else (),
        between=link.section.between if link.section else "linear",
    )
