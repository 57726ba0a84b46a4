"""A URDF as it stands: its links and joints with their numbers checked, and notes on what is not read."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

import numpy as np

from ..spec.ranges import RANGES
from ..spec.values import quoted, shown
from .markup import Element, read_xml
from .rigid import HERE, Inertial, Pose, pose, turned

FREE, FIXED = "floating", "fixed"
TURNING, SLIDING = ("revolute", "continuous"), ("prismatic",)
TYPES = (*TURNING, *SLIDING, FIXED, FREE, "planar")
BOUNDLESS = 1e6
"""N·m or N: an effort that is written where there is no limit; files mean none by it and by 0."""
SHORTEST = 1e-6
"""An axis shorter than this is lengthened, so that the square of its length is a number."""
LOOKS = ("visual", "collision", "material")
READ = {
    "robot": ("link", "joint", "transmission"),
    "link": ("inertial",),
    "joint": ("origin", "parent", "child", "axis", "limit", "dynamics", "mimic"),
    "transmission": ("type", "joint", "actuator", "hardwareInterface", "mechanicalReduction"),
}
REDUCTION = ("mechanicalReduction", "mechanical_reduction", "drake:gear_ratio")
ROTOR = ("rotorInertia", "rotor_inertia", "motorInertia", "drake:rotor_inertia")


@dataclass
class UrdfLink:
    """A link, and its body in its frame; None where the file states no inertial."""

    element: Element
    name: str
    body: Inertial | None


@dataclass
class UrdfJoint:
    """A joint: its frame in that of its parent link, its axis in the joint frame, and what acts on it."""

    element: Element
    name: str
    kind: str
    parent: str
    child: str
    xyz: list[float]
    rpy: list[float]
    axis: list[float]
    lower: float | None = None
    upper: float | None = None
    effort: float | None = None
    velocity: float | None = None
    damping: float = 0.0
    friction: float = 0.0
    mimic: Element | None = None
    notes: list[str] = field(default_factory=list)
    ratio: float | None = None
    rotor_inertia: float | None = None

    @property
    def armature(self) -> float:
        """The rotor's inertia as the joint feels it; 0 where the file states none."""
        return (self.rotor_inertia or 0.0) * (self.ratio or 1.0) ** 2

    @property
    def limited(self) -> bool:
        """Whether there is a range."""
        return self.lower is not None or self.upper is not None

    @property
    def origin(self) -> Pose:
        """The joint frame in the frame of the parent link."""
        return pose(self.xyz, self.rpy)

    @property
    def mimicked(self) -> tuple[str, float, float]:
        """Of a joint that mimics another: the other's name, and ratio and offset of what it does."""
        assert self.mimic is not None
        offset = self.mimic.number("offset", "coupling offset", "0")
        return self.mimic.string("joint"), self.mimic.number("multiplier", "coupling ratio", "1"), offset

    @property
    def mimicking(self) -> Pose:
        """The motion of a joint that mimics one at 0; none of others."""
        offset = self.mimic.number("offset", "limit", "0") if self.mimic is not None else 0.0
        axis = np.array(self.axis) / np.linalg.norm(self.axis)
        return Pose(HERE.R, offset * axis) if self.kind in SLIDING else Pose(turned(axis, offset), HERE.p)


@dataclass
class Urdf:
    """The file's content; `root` is the link that no joint carries."""

    element: Element
    name: str
    links: dict[str, UrdfLink]
    joints: dict[str, UrdfJoint]
    root: str
    notes: list[str] = field(default_factory=list)

    def below(self, link: str) -> list[UrdfJoint]:
        """The joints that a link carries, in the order of the file."""
        return [joint for joint in self.joints.values() if joint.parent == link]


def read_urdf(content: bytes, file: str) -> Urdf:
    """The robot of a URDF.  Raises RobotFileError, one line with file, line, element, fault and remedy."""
    root = read_xml(content, file)
    if root.tag != "robot":
        raise root.fault('is the root of the file; a URDF has <robot name="…">')
    name = root.string("name")
    links = {x.name: x for x in map(_link, _distinct(root.all("link")))}
    if not links:
        raise root.fault("has no <link>; a robot needs at least one")
    joints = {x.name: x for x in map(_joint, _distinct(root.all("joint")))}
    notes = _left_out(root) + [note for joint in joints.values() if (note := _range_note(joint))]
    notes += [note for joint in joints.values() for note in joint.notes] + _transmissions(root, joints)
    return Urdf(root, name, links, joints, _root(root, links, joints), notes)


def _distinct(elements: list[Element]) -> list[Element]:
    seen: set[str] = set()
    for element in elements:
        if (name := element.string("name")) in seen:
            raise element.fault("has the name of an earlier one; give each its own", "name")
        seen.add(name)
    return elements


def _link(element: Element) -> UrdfLink:
    stated = element.only("inertial")
    return UrdfLink(element, element.string("name"), None if stated is None else _inertial(stated))


def _inertial(element: Element) -> Inertial:
    mass = element.needed("mass", 'state <mass value="…"/>, kg').number("value", "mass")
    tensor = element.needed("inertia", 'state <inertia ixx="…" ixy="…" … izz="…"/>, kg·m²')
    entries = [tensor.number(key, "inertia") for key in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")]
    xyz, rpy = origin_of(element)
    return Inertial.of(mass, None, entries).seen(pose(xyz, rpy) if any(rpy) else Pose(HERE.R, np.array(xyz)))


def origin_of(element: Element) -> tuple[list[float], list[float]]:
    """Position and turn of the `<origin>` of an element, zero where there is none."""
    stated = element.only("origin")
    if stated is None:
        return [0.0] * 3, [0.0] * 3
    return stated.numbers("xyz", 3, "position", "0 0 0"), stated.numbers("rpy", 3, "turn", "0 0 0")


def _joint(element: Element) -> UrdfJoint:
    kind = element.string("type")
    if kind not in TYPES:
        raise element.fault(f"is {quoted(kind)}; it must be {', '.join(TYPES[:-1])} or {TYPES[-1]}", "type")
    ends = [element.needed(tag, f'state <{tag} link="…"/>').string("link") for tag in ("parent", "child")]
    (parent, child), (xyz, rpy) = ends, origin_of(element)
    found = UrdfJoint(element, element.string("name"), kind, parent, child, xyz, rpy, _axis(element, kind))
    found.mimic = element.only("mimic")
    if (limit := element.only("limit")) is not None:
        _limits(found, limit)
    if (dynamics := element.only("dynamics")) is not None:
        found.damping = dynamics.number("damping", "damping", "0")
        found.friction = dynamics.number("friction", "coulomb", "0")
    return found


def _axis(element: Element, kind: str) -> list[float]:
    stated = element.only("axis")
    if stated is None or kind in (FIXED, FREE):
        return [1.0, 0.0, 0.0]
    axis = stated.numbers("xyz", 3, "position")
    if not any(axis):
        raise stated.fault("is the zero vector; an axis needs a direction", "xyz")
    largest = max(map(abs, axis))
    return axis if largest > SHORTEST else [x / largest for x in axis]


def _limits(joint: UrdfJoint, limit: Element) -> None:
    """The range; 0 to 0, which is also what a file means that states neither, is none, nor is what no joint reaches."""
    lower, upper = (limit.number(key, "any limit", "0") for key in ("lower", "upper"))
    if lower > upper:
        raise limit.fault(f"is {shown(lower)}; it must be less than upper, {shown(upper)}", "lower")
    if joint.kind in (*TURNING[:1], *SLIDING) and lower < upper:
        reach = RANGES["limit"].high
        joint.lower, joint.upper = lower if lower >= -reach else None, upper if upper <= reach else None
    for key in ("effort", "velocity"):
        if key in limit.attributes:
            setattr(joint, key, limit.number(key, "any limit"))
    if joint.effort is not None and not 0 < joint.effort < BOUNDLESS:
        joint.effort = None
        joint.notes.append(f"joint '{joint.name}': effort {limit.attributes['effort']} counts as no limit")


def _range_note(joint: UrdfJoint) -> str | None:
    if joint.kind not in (*TURNING[:1], *SLIDING) or joint.limited:
        return None
    return f"joint '{joint.name}': states no range from lower to upper; it gets no range"


def _left_out(root: Element) -> list[str]:
    """One line for what gives a robot its looks, one for each other kind of tag that is not read."""
    parts = [(root.tag, root), *((part.tag, part) for part in root.all("link", "joint", "transmission"))]
    unread = Counter(
        (child.tag, where) for where, part in parts for child in part.children if child.tag not in READ[where]
    )
    looks = [tag for tag in LOOKS if any(tag == unread_tag for unread_tag, _ in unread)]
    notes = [f"{', '.join(f'<{tag}>' for tag in looks)}: left out, the robot file has no geometry"] if looks else []
    for (tag, where), count in unread.items():
        if tag not in (*LOOKS, *REDUCTION, *ROTOR):
            times = f", {count} times" if count > 1 else ""
            notes.append(f"<{shown(tag)[1:-1]}> in <{where}>{times}: left out, it is not read")
    return notes


def _transmissions(root: Element, joints: dict[str, UrdfJoint]) -> list[str]:
    """Gives joints the reduction and rotor inertia of their transmissions."""
    bare = 0
    for element in root.all("transmission"):
        ratios = [x for x in element.walk() if x.tag in REDUCTION]
        rotors = [x for x in element.walk() if x.tag in ROTOR]
        if not rotors:
            bare += bool(ratios)
            continue
        name = element.needed("joint", 'state <joint name="…"/>').string("name")
        if name not in joints:
            raise element.fault(f'names the joint {quoted(name)}, which is not there; state <joint name="…"/>')
        if len(rotors) > 1 or len(ratios) > 1 or joints[name].rotor_inertia is not None:
            raise element.fault(f"states a second rotor for joint '{name}'; leave one of them out")
        joints[name].rotor_inertia = rotors[0].content("rotor inertia")
        if ratios:
            joints[name].ratio = ratios[0].content("ratio")
    said = f"transmissions, {bare} of them: left out, mechanicalReduction acts on a rotor inertia, which they lack"
    return [said] if bare else []


def _root(root: Element, links: dict[str, UrdfLink], joints: dict[str, UrdfJoint]) -> str:
    """The link that no joint carries; refuses what is no tree."""
    carrier: dict[str, UrdfJoint] = {}
    for joint in joints.values():
        for tag, name in (("parent", joint.parent), ("child", joint.child)):
            if name not in links:
                end = joint.element.all(tag)[0]
                raise end.fault(f"is {quoted(name)}, which is no link of the file; name one", "link")
        if joint.child in carrier:
            what = f"carries link '{joint.child}', as joint '{carrier[joint.child].name}' does"
            raise joint.element.fault(f"{what}; a URDF is a tree: close loops by [[loops]] of the robot file")
        carrier[joint.child] = joint
    roots = [name for name in links if name not in carrier]
    if not roots:
        raise root.fault("has no root link: its joints go round in a circle; let one link be no child")
    if len(roots) > 1:
        what = f"has no joint that carries it, as link '{roots[0]}', the root"
        raise links[roots[1]].element.fault(f"{what}; join the two, or leave one out")
    reached = [roots[0]]
    for name in reached:
        reached += [joint.child for joint in joints.values() if joint.parent == name]
    if lost := next((name for name in links if name not in set(reached)), None):
        raise links[lost].element.fault("hangs on itself: its joints go round in a circle; let the root carry it")
    return roots[0]
