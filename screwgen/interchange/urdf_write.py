"""A robot as a URDF of rigid links: the undeformed robot, for viewers and for tools that read nothing else."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from xml.sax.saxutils import quoteattr

import numpy as np

from ..backends.numpy.numeric import Numeric
from ..backends.numpy.rest_shape import link_at_rest
from ..errors import UsageError
from ..joints.screw import Screw
from ..reduction.invariants import hat
from ..spec.base import FLOATING
from ..spec.couplings import Axis, coupled_axis
from ..spec.drive import FRICTION_TABLES, NO_FRICTION
from ..spec.joint import Joint
from ..spec.markers import carried_at
from ..spec.parents import WORLD, parents
from ..spec.reduced import elastic, of_link
from ..spec.robot import OF_SEVERAL, Link, Robot
from ..topology.chain import Chain
from .rigid import HERE, Pose, pose
from .tables import GRAVITY, STICKING
from .urdf import BOUNDLESS

OPEN_RANGE = 10.0
"""m: the range of a slide without limits, for the sliders of viewers."""
MASSLESS = 1e-15
CURVED = 12
"""Cylinders along a link that is curved at rest."""
GREY, BLUE = "rigid", "flexible"
COLOURS = {GREY: "0.55 0.57 0.6 1", BLUE: "0.25 0.45 0.7 1"}


@dataclass(frozen=True)
class Exported:
    """The text of a URDF, and a line for each thing that it leaves out."""

    text: str
    notes: tuple[str, ...]


def export_urdf(robot: Robot, file: str = "") -> Exported:
    """The robot, from a `file` that errors name, as a URDF.  Raises UsageError for joints that URDF has none for."""
    return _Writer(robot, file or f"robot '{robot.name}'").exported()


@dataclass
class _Writer:
    robot: Robot
    file: str
    notes: list[str] = field(default_factory=list)
    lines: list[str] = field(default_factory=list)

    def exported(self) -> Exported:
        robot = self.robot
        for i, link in enumerate(robot.links):
            if link.joint.kind.curved:
                what = f"links[{i}].joint.axes (link {link.name}): is a ball joint, which URDF does not have"
                raise UsageError(f"{self.file}: {what}; write three axes in its place")
            for k, screw in enumerate(link.joint.screws):
                if screw.turn and screw.travel:
                    where = f"links[{i}].joint.axes[{k}] (link {link.name})"
                    what = "is a screw, and URDF has no joint that turns and travels at once"
                    raise UsageError(f"{self.file}: {where}: {what}; write a slide or a turning axis in its place")
        self._robot_notes()
        self.names = [link.name for link in robot.links]
        self.root = WORLD
        self.size = 0.02 * max(0.2, max(float(np.linalg.norm(self._end(link).p)) for link in robot.links))
        self.carriers, self.places = parents(robot.links), carried_at(robot.links)
        if not robot.floating:
            self.lines.append(f'  <link name="{self.root}"/>')
        for i, link in enumerate(robot.links):
            self._link_notes(link)
            self._joints(i, link)
            self._link(i, link)
        self._transmissions()
        head = f'<?xml version="1.0"?>\n<robot name="{robot.name}">\n'
        return Exported(head + "\n".join(self.lines) + "\n</robot>\n", tuple(self.notes))

    # what is left out

    def _robot_notes(self) -> None:
        robot = self.robot
        if tuple(robot.gravity) != GRAVITY:
            said = f"gravity = {list(robot.gravity)} is left out"
            self.notes.append(f"{said}; where it is read again, state it in a side file")
        if robot.base_acceleration:
            self.notes.append("base_acceleration is left out; a URDF has no inputs but drives")
        if robot.loops:
            self.notes.append(f"{len(robot.loops)} loops are left out; a URDF is a tree")
        for name in ("forces", "pushes"):
            if count := len(getattr(robot, name)):
                self.notes.append(f"{count} of [[{name}]] are left out; a URDF has none")
        if robot.floating:
            how = "floats" if robot.base == FLOATING else "moves as is given"
            said = f"the base {how}, which a URDF does not say"
            self.notes.append(f"{said}; where it is read again, use --floating")

    def _link_notes(self, link: Link) -> None:
        joint = link.joint
        if of_link(link):
            self.notes.append(f"{link.name}: is flexible; it is written as the rigid body of its undeformed shape")
        if link.tendons:
            self.notes.append(f"{link.name}.tendons: are left out; URDF has no tendons")
        if joint.stiffness and any(joint.stiffness):
            self.notes.append(f"{link.name}.joint.stiffness: is left out; URDF has no springs")
        if any(map(joint.between, range(len(joint.axes)))):
            self.notes.append(f"{link.name}.joint.drives: gears are written as rigid, cylinders are left out")
        if any(joint.elements or ()):
            self.notes.append(f"{link.name}.joint.elements: are left out; URDF has no such elements")
        if joint.braked:
            self.notes.append(f"{link.name}.joint.brake: is left out; URDF has no brakes")
        if joint.prescribed:
            self.notes.append(f"{link.name}.joint.actuation: is left out; in a URDF efforts move the axes")
        left = ["the stiffness of their stops"] * any(x.stiffness is not None for x in joint.limits or ())
        left += dict.fromkeys(law.WORDS for x in joint.limits or () for law in x.laws if law.KIND != "effort")
        self.notes += [f"{link.name}.joint.limits: are written without {what}" for what in left]
        for k, drive in enumerate(joint.driven):
            known = (None, STICKING[joint.screws[k].slides])
            friction = drive.friction or NO_FRICTION
            slips = ["velocity"] if friction.velocity not in known else []
            for name in (*slips, *(name for name in FRICTION_TABLES if getattr(friction, name))):
                self.notes.append(f"{link.name}.joint.drives[{k}].friction.{name}: is left out")

    # links

    def _end(self, link: Link) -> Pose:
        """The undeformed tip frame in axes of the link frame, from the joint point."""
        if body := elastic(link):
            return Pose(np.array(body.tip.axes), np.array(body.tip.origin))
        return self._section(link, 1.0)

    def _section(self, link: Link, s: float) -> Pose:
        """That of a section of a rod."""
        if not link.rest:
            return Pose(HERE.R, s * np.array([link.length or 0.0, 0.0, 0.0]))
        return Pose(*link_at_rest(Chain(self._alone(link)), 0, s))

    def _link(self, i: int, link: Link) -> None:
        self.lines.append(f'  <link name="{link.name}">')
        M = self._inertia(link)
        mass = float(np.trace(M[3:, 3:]) / 3)
        com = np.array([M[2, 4], M[0, 5], M[1, 3]]) / mass if mass else np.zeros(3)
        c = hat(com)
        J = M[:3, :3] + mass * c @ c
        J = np.where(np.abs(J) > MASSLESS * np.abs(M[:3, :3]).max(initial=0.0), J, 0.0)
        if mass or J.any():
            com = np.where(np.abs(com) > MASSLESS, com, 0.0)
            entries = {"ixx": J[0, 0], "ixy": J[0, 1], "ixz": J[0, 2], "iyy": J[1, 1], "iyz": J[1, 2], "izz": J[2, 2]}
            self.lines += [
                "    <inertial>",
                f"      <origin xyz={_row(com)}/>",
                f"      <mass value={_row([mass])}/>",
                f"      <inertia {' '.join(f'{key}={_row([x])}' for key, x in entries.items())}/>",
                "    </inertial>",
            ]
        for shape in self._shapes(i, link):
            self.lines += ["    <visual>", *(f"      {line}" for line in shape), "    </visual>"]
        self.lines.append("  </link>")

    def _inertia(self, link: Link) -> np.ndarray:
        """(6, 6): the inertia of the undeformed link about its joint point, for twists [ω; v] in link axes."""
        chain = Chain(self._alone(link))
        q = np.zeros(chain.nq)
        q[3] = 1.0
        return Numeric(chain).mass_matrix(q)[:6, :6]

    def _alone(self, link: Link) -> Robot:
        """The robot that is a link alone, afloat."""
        update = {"joint": Joint(axes=()), "parent": None, "at": "tip", "frame_at": None}
        alone = {"links": (link.model_copy(update=update),), "base": FLOATING, "gravity": (0.0, 0.0, 0.0)}
        return self.robot.model_copy(update={**alone, **dict.fromkeys(OF_SEVERAL, ()), "base_acceleration": False})

    def _shapes(self, i: int, link: Link) -> Iterator[list[str]]:
        """A ball at the joint, cylinders along the link and from it to the joints that it carries, boxes for bodies."""
        yield _visual(HERE, f'<sphere radius="{self.size:g}"/>', GREY)
        count, colour = (CURVED if link.rest else 1), BLUE if of_link(link) else GREY
        ends = [self._place(link, k / count) for k in range(count + 1)]
        lines = [(start, stop, colour) for start, stop in pairwise(ends)]
        for j, carrier in enumerate(self.carriers):
            if carrier == i:
                lines.append((self._place(link, self.places[j]), self._mount(j).p, GREY))
        for start, stop, colour in lines:
            if (size := float(np.linalg.norm(stop - start))) > 1e-9:
                middle = Pose(_towards((stop - start) / size), (start + stop) / 2)
                yield _visual(middle, f'<cylinder radius="{self.size / 2:g}" length="{size:g}"/>', colour)
        for body in link.bodies:
            if body.mass and body.com and any(body.com):
                place = (self._end(link) if body.at == "tip" else HERE) @ Pose(HERE.R, np.array(body.com))
                yield _visual(place, f'<box size="{" ".join([f"{self.size:g}"] * 3)}"/>', GREY)

    def _place(self, link: Link, s: float) -> np.ndarray:
        """A point of the centreline of a link."""
        return self._section(link, s).p if link.rest else s * self._end(link).p

    # joints

    def _mount(self, i: int) -> Pose:
        """The joint frame of a link in the URDF's frame of its carrier."""
        mount = self.robot.links[i].joint.mount
        placed = pose((mount and mount.xyz) or (0, 0, 0), (mount and mount.rpy) or (0, 0, 0))
        if self.carriers[i] < 0:
            return placed
        carrier, s = self.robot.links[self.carriers[i]], self.places[i]
        if carrier.rest:
            return self._section(carrier, s) @ placed
        end = self._end(carrier)
        turned = end.R if s == 1 and self.robot.section_rotation else HERE.R
        return Pose(turned, s * end.p) @ placed

    def _joints(self, i: int, link: Link) -> None:
        """The joint of a link; several axes by links without mass between them."""
        if self.robot.floating and i == 0:
            return
        mount, joint, above = self.robot.links[i].joint.mount, link.joint, self._above(i)
        placed = self._mount(i)
        literal = self.carriers[i] < 0 or not self._end(self.robot.links[self.carriers[i]]).p.any()
        rpy = (mount.rpy if mount and mount.rpy else (0.0, 0.0, 0.0)) if literal else placed.rpy
        origin = f"<origin xyz={_row(placed.p)} rpy={_row(rpy)}/>"
        if not joint.screws:
            self._joint(f"{link.name}_joint", "fixed", above, link.name, [origin])
            return
        for k, screw in enumerate(joint.screws):
            last = k == len(joint.screws) - 1
            below = link.name if last else self._between(link, k)
            kind, above, below, parts = self._motion(joint, k, screw, above, below, origin)
            self._joint(_joint_name(link, k), kind, above, below, [*parts, *self._mimic(Axis(i, k))])
            if not last:
                self.lines.append(f'  <link name="{below}"/>')
            above, origin = below, ""

    def _mimic(self, axis: Axis) -> Iterator[str]:
        """The coupling of an axis that follows another; a URDF has one at most."""
        links = self.robot.links
        every = [c for c in self.robot.couplings if coupled_axis(links, c.axis) == axis]
        own = [c for c in every if c.relation is None]
        self.notes += [f"{c.axis}: a coupling by a relation is left out; URDF has none" for c in every if c.relation]
        for coupling in own[:1]:
            other, number = coupled_axis(links, coupling.of)
            said = f'joint="{_joint_name(links[other], number)}" multiplier={_row([coupling.ratio])}'
            yield f"<mimic {said} offset={_row([coupling.offset])}/>"
        if len(own) > 1:
            self.notes.append(f"{own[0].axis}: {len(own) - 1} of its couplings are left out; a URDF has one a joint")

    def _above(self, i: int) -> str:
        return self.root if self.carriers[i] < 0 else self.names[self.carriers[i]]

    def _between(self, link: Link, k: int) -> str:
        name = f"{link.name}_axis_{k}"
        return name if name not in self.names else f"{name}_without_mass"

    def _motion(
        self, joint: Joint, k: int, screw: Screw, above: str, below: str, origin: str
    ) -> tuple[str, str, str, list[str]]:
        limit = joint.limits[k] if joint.limits else None
        lower, upper = (limit.lower, limit.upper) if limit else (None, None)
        most = self._effort(joint, k, below)
        effort = _row([most]) if most < BOUNDLESS else '"1e6"'
        kind = "prismatic" if screw.slides else "continuous" if lower is None and upper is None else "revolute"
        parts = [origin] if origin else []
        parts.append(f"<axis xyz={_row(screw.axis)}/>")
        if kind != "continuous":
            free = OPEN_RANGE if screw.slides else 2 * np.pi
            for side, value in (("lower", lower), ("upper", upper)):
                if value is None:
                    self.notes.append(
                        f"{below}: its joint has no {side} limit, which URDF needs; {free:g} stands there"
                    )
            lower = -max(free, 2 * abs(upper or 0)) if lower is None else lower
            upper = max(free, 2 * abs(lower)) if upper is None else upper
            parts.append(f'<limit lower={_row([lower])} upper={_row([upper])} effort={effort} velocity="1e3"/>')
        elif most < BOUNDLESS:
            parts.append(f'<limit effort={effort} velocity="1e3"/>')
        friction = (not joint.between(k) and joint.driven[k].friction) or NO_FRICTION
        damping = (joint.damping[k] if joint.damping else 0.0) + (friction.viscous or 0.0)
        dry = friction.coulomb or 0.0
        if damping or dry:
            parts.append(f"<dynamics damping={_row([damping])} friction={_row([dry])}/>")
        return kind, above, below, parts

    def _effort(self, joint: Joint, k: int, below: str) -> float:
        """The limit of the effort at an axis, BOUNDLESS without one."""
        most, drive = joint.limits[k].effort if joint.limits else None, joint.driven[k]
        if most is not None and drive.travel:
            self.notes.append(f"{below}: the effort of its drive is left out, which does not act on the joint")
            return BOUNDLESS
        return BOUNDLESS if most is None else most * (drive.ratio or 1.0 if drive.elastic else 1.0)

    def _joint(self, name: str, kind: str, above: str, below: str, parts: Sequence[str]) -> None:
        self.lines += [
            f'  <joint name="{name}" type="{kind}">',
            f'    <parent link="{above}"/>',
            f'    <child link="{below}"/>',
            *(f"    {part}" for part in parts),
            "  </joint>",
        ]

    def _transmissions(self) -> None:
        """Rotors, with the reduction of their gears; the tag rotorInertia is one that only some tools read."""
        for link in self.robot.links:
            for k in range(len(link.joint.screws)):
                drive = link.joint.driven[k]
                armature = link.joint.armature[k] if link.joint.armature else 0.0
                rotor, ratio = armature, 1.0
                if drive.rotor_inertia is not None and drive.transmission is None:
                    rotor, ratio = drive.rotor_inertia + armature / (drive.ratio or 1.0) ** 2, drive.ratio or 1.0
                if rotor:
                    name = _joint_name(link, k)
                    self.lines += [
                        f'  <transmission name="{name}_drive">',
                        "    <type>transmission_interface/SimpleTransmission</type>",
                        f'    <joint name="{name}"/>',
                        f'    <actuator name="{name}_motor">',
                        f"      <mechanicalReduction>{ratio!r}</mechanicalReduction>",
                        f"      <rotorInertia>{rotor!r}</rotorInertia>",
                        "    </actuator>",
                        "  </transmission>",
                    ]


def _joint_name(link: Link, k: int) -> str:
    """The name of the joint of an axis."""
    return f"{link.name}_joint" + (f"_{k}" if len(link.joint.screws) > 1 else "")


def _row(values: Iterable[float]) -> str:
    """Numbers as an attribute, to the last digit."""
    return quoteattr(" ".join(repr(float(x) + 0.0) for x in values))


def _visual(placed: Pose, shape: str, colour: str) -> list[str]:
    at = f"<origin xyz={_row(placed.xyz)} rpy={_row(placed.rpy)}/>"
    return [
        at,
        f"<geometry>{shape}</geometry>",
        f'<material name="{colour}"><color rgba="{COLOURS[colour]}"/></material>',
    ]


def _towards(axis: np.ndarray) -> np.ndarray:
    """A rotation whose z axis is `axis`: that of a URDF's cylinder."""
    x = np.eye(3)[int(np.argmin(np.abs(axis)))]
    x = x - (x @ axis) * axis
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(axis, x), axis])
