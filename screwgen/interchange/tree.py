"""From a URDF to the tables of a robot file: which links remain, where they sit, and what they weigh.

A link that the side file gives no shape keeps the frame of the URDF's link, so its numbers are those of the file; fixed
joints are merged: what they weld becomes a part of the body that carries it. A link with a shape gets the frame of a
robot file, x along the centreline, and carries the joints behind it where the section is nearest.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..errors import RobotFileError, UsageError
from ..spec.names import FILE_NAMES, KEYWORDS, MAX_LENGTH
from ..spec.parents import WORLD
from ..spec.values import quoted
from .flexible import LinkPlacement, SideFile, shape_of
from .markup import Element
from .rigid import HERE, Inertial, Pose, cleaned, nearest, possible, together
from .urdf import FIXED, FREE, SLIDING, Urdf, UrdfJoint

MIMIC = ("couple", "free", "weld", "refuse")
"""What becomes of joints that mimic others."""


@dataclass(frozen=True)
class Options:
    """How a URDF is read.

    ``keep_fixed``: fixed joints stay welded links instead of being merged; ``floating``: the root link is the floating
    base; ``mimic``: joints that mimic others are coupled to these, left to move on their own (``"free"``), welded
    (``"weld"``) or refused (``"refuse"``); ``tip``: the link that comes last, even where it is fixed, so that it is
    *the tip*; ``nearest_inertia``: replaces inertias that no body has by the nearest that one has; ``density`` (kg/m³)
    or ``total_mass`` (kg): links without an inertial weigh what their shapes do, see :func:`.weights.weigh`.
    """

    keep_fixed: bool = False
    floating: bool = False
    mimic: str = "couple"
    tip: str | None = None
    nearest_inertia: bool = False
    density: float | None = None
    total_mass: float | None = None


@dataclass
class MergedLink:
    """A link of the robot: its carrier (-1: the world), its joint, and the bodies that are merged into it."""

    name: str
    urdf: str
    carrier: int
    joint: UrdfJoint | None
    axes: list
    shape: LinkPlacement | None
    mount: Pose = HERE
    literal: bool = False
    """Whether the mount is the origin of the URDF's joint as it stands."""
    at: Any = "tip"
    base: list[tuple[str, Inertial]] = field(default_factory=list)
    """Bodies in axes of the link frame, from the joint, with the links of the URDF whose they are."""
    tip: list[tuple[str, Inertial]] = field(default_factory=list)
    """Bodies in axes of the tip frame, from the tip."""


class UrdfTree:
    """The links of a robot, from the root outwards."""

    def __init__(self, urdf: Urdf, side: SideFile, options: Options):
        if options.mimic not in MIMIC:
            raise UsageError(f"mimic: there is no '{options.mimic}'; choose {', '.join(MIMIC[:-1])} or {MIMIC[-1]}")
        if options.tip is not None and options.tip not in urdf.links:
            raise UsageError(f"tip: {urdf.element.file} has no link {quoted(options.tip)}; name one")
        self.urdf, self.side, self.options = urdf, side, options
        self.notes = list(urdf.notes)
        self.nodes: list[MergedLink] = []
        self.dropped: list[str] = []
        self.floating = options.floating or side.robot.get("base") == FREE
        self.names = identifiers(urdf.links)
        self.name = robot_identifier(urdf.name)
        self.heavy, self.to_tip = self._heavy(), self._to_tip()
        root = self._root()
        if self.floating or root in side.links:
            self._add(None, root, -1, HERE)
            self._visit(root, 0, HERE)
        else:
            self._drop(root)
            self._visit(root, -1, HERE)
        self._say()

    def _root(self) -> str:
        """The link at which the robot begins: a floating joint of the root makes its child the floating base."""
        root, below = self.urdf.root, self.urdf.below(self.urdf.root)
        if len(below) == 1 and below[0].kind == FREE:
            self.floating = True
            self._drop(root)
            if any(below[0].xyz + below[0].rpy):
                self.notes.append(
                    f"joint '{below[0].name}': the pose of a floating base is state; its origin is left out"
                )
            root = below[0].child
        for joint in self.urdf.joints.values():
            if joint.kind == FREE and joint.child != root:
                what = "is floating, which only the joint of the base may be"
                raise joint.element.fault(f"{what}; make it fixed, or let the root link carry it alone", "type")
        return root

    def _heavy(self) -> set[str]:
        """The links that have inertia or carry what has."""
        found = {x.name for x in self.urdf.links.values() if x.name in self.side.links or (x.body and x.body.something)}
        found |= {joint.child for joint in self.urdf.joints.values() if joint.armature}
        return self._with_carriers(found)

    def _to_tip(self) -> set[str]:
        return self._with_carriers({self.options.tip} - {None})

    def _with_carriers(self, links: set) -> set[str]:
        carrier = {joint.child: joint.parent for joint in self.urdf.joints.values()}
        found = set()
        for name in links:
            while name is not None and name not in found:
                found.add(name)
                name = carrier.get(name)
        return found

    def _visit(self, link: str, index: int, T: Pose) -> None:
        """The joints of `link`, which is a part of the node `index` and sits in its URDF link's frame at T."""
        for joint in sorted(self.urdf.below(link), key=lambda joint: joint.child in self.to_tip):
            placed = T @ joint.origin
            if not self._welded(joint):
                new = self._add(joint, joint.child, index, placed, T is HERE)
                self._visit(joint.child, new, HERE)
                continue
            if self.options.mimic == "weld" and joint.mimic is not None:
                placed = placed @ joint.mimicking
            if self._merge(joint.child, index, placed):
                self._visit(joint.child, index, placed)
            else:
                new = self._add(joint, joint.child, index, placed, T is HERE and joint.mimic is None, welded=True)
                self._visit(joint.child, new, HERE)

    def _welded(self, joint: UrdfJoint) -> bool:
        if joint.kind == FIXED:
            return True
        if joint.child not in self.heavy:
            self.notes.append(f"joint '{joint.name}': moves nothing that has mass; it is welded")
            return True
        if joint.mimic is None or self.options.mimic == "couple":
            return False
        if self.options.mimic == "refuse":
            what = "couples two joints"
            raise joint.mimic.fault(f"{what}; keep it (--mimic couple), let both move (free) or hold this one (weld)")
        said = {"free": "moves on its own", "weld": "is welded where the other joint is at 0"}[self.options.mimic]
        self.notes.append(f"joint '{joint.name}': its <mimic> is left out; it {said}")
        return self.options.mimic == "weld"

    def _merge(self, link: str, index: int, placed: Pose) -> bool:
        """Add a welded link to the body of a node; not where it has keys of its own, or hangs between the ends."""
        if self.options.keep_fixed or link == self.options.tip or link in self.side.links:
            return False
        if index < 0:
            self._drop(link)
            return True
        node, body = self.nodes[index], self._body(link)
        if node.shape is None:
            node.base += [(link, body.seen(placed))] if body else []
            return True
        inside = node.shape.frame.inverse @ placed
        s = node.shape.foot(inside.p) if body else 1.0
        if s not in (0.0, 1.0):
            return False
        held = node.shape.section(s).inverse @ inside
        (node.tip if s else node.base).extend([(link, body.seen(held))] if body else [])
        return True

    def _body(self, link: str) -> Inertial | None:
        """The body of a link, None where it weighs nothing; point masses have no tensor."""
        body = self.urdf.links[link].body
        return body if body and body.something else None

    def _drop(self, link: str) -> None:
        if self._body(link):
            self.dropped.append(link)

    def _add(
        self, joint: UrdfJoint | None, link: str, carrier: int, placed: Pose, direct: bool = False, welded: bool = False
    ) -> int:
        """A node for a link whose joint frame sits in the frame of its carrier's URDF link at `placed`."""
        body, table = self._body(link), self.side.links.get(link, {})
        shape = shape_of(self.side, self.urdf, link, body)
        node = MergedLink(
            self.names[link], link, carrier, joint, [] if welded or joint is None else _axes(joint, shape), shape
        )
        above = self.nodes[carrier].shape if carrier >= 0 else None
        if above is not None:
            placed = above.frame.inverse @ placed
            s = above.foot(placed.p) if "at" not in table else self._place(carrier, link, table["at"])
            node.at = table.get("at", {0.0: "base", 1.0: "tip"}.get(s, {"s": s}))
            placed = above.section(s).inverse @ placed
        elif "at" in table:
            what = "is stated, but its carrier has no length in the side file"
            raise self.side.fault(link, "at", f"{what}; leave it out, or state the carrier's")
        node.literal = direct and above is None and shape is None
        node.mount = placed if shape is None else placed @ shape.frame
        if body and not (shape and shape.stated):
            node.base.append((link, body.seen(shape.frame.inverse) if shape else body))
        self.nodes.append(node)
        return len(self.nodes) - 1

    def _place(self, carrier: int, link: str, at: Any) -> float:
        """The place s that `at` of the side file names on its carrier."""
        shape = self.nodes[carrier].shape
        markers = shape.keys.get("markers", ()) if shape else ()
        known = {"base": 0.0, "tip": 1.0} | {str(x.get("name")): x.get("at") for x in markers if isinstance(x, dict)}
        s = at.get("s") if isinstance(at, dict) else known.get(at) if isinstance(at, str) else None
        if not isinstance(s, int | float) or not 0 <= s <= 1:
            places = ", ".join(map(quoted, known))
            raise self.side.fault(link, "at", f"is no place of its carrier; choose {places} or {{ s = … }}")
        return float(s)

    def _say(self) -> None:
        if self.options.tip is not None and (not self.nodes or self.nodes[-1].urdf != self.options.tip):
            raise UsageError(f"tip: link {quoted(self.options.tip)} carries links that move; name one at an end")
        if self.dropped:
            self.notes.append(f"on the fixed base, left out: the inertia of {', '.join(self.dropped)}")
        if not self.nodes or not (self.floating or any(node.axes for node in self.nodes)):
            if moving := next((x.child for x in self.urdf.joints.values() if x.kind != FIXED), None):
                raise self.without_mass(moving)
            raise self.urdf.element.fault("has no joint that moves, and its base is fixed; --floating lets it float")
        both = {self.urdf.name: self.name} | {node.urdf: node.name for node in self.nodes}
        renamed = [f"{old} -> {new}" for old, new in both.items() if old != new]
        if renamed:
            self.notes.append(f"names that became C identifiers: {', '.join(renamed)}")

    def without_mass(self, link: str) -> RobotFileError:
        """The error of a link that has no mass where one is needed."""
        what = "has no mass, nor has what it carries; give it an <inertial>, or bodies in a side file (--flexible)"
        return self.urdf.links[link].element.fault(f"{what}, or take masses from its shapes (--density, --total-mass)")

    def inertia(self, bodies: list[tuple[str, Inertial]]) -> Inertial:
        """Bodies that are welded together as one; refuses an inertia that no body has.

        A wrong one that is hidden by what it is welded to is kept, and said.
        """
        whole = together([body for _, body in bodies])
        wrong = [(link, body) for link, body in bodies if not possible(body) and body.matters_in(whole)]
        if wrong and self.options.nearest_inertia:
            return together([self._nearest(link, body) if not possible(body) else body for link, body in bodies])
        for link, body in wrong:
            element, said = self._tensor(link), f"principal moments {_moments(body)}"
            if not possible(whole):
                what = f"is one that no body has, {said}: none may be negative or exceed the sum of the others"
                raise element.fault(f"{what}; mend it, or take the nearest (--nearest-inertia)")
            remedy = "what it is welded to hides that; --nearest-inertia takes the nearest"
            self.notes.append(f"line {element.line}: link '{link}': no body has its {said}; {remedy}")
        return whole

    def _tensor(self, link: str) -> Element:
        """The element that states the inertia of a link."""
        own = self.urdf.links[link].element
        return next((x for x in own.walk() if x.tag == "inertia"), own)

    def _nearest(self, link: str, body: Inertial) -> Inertial:
        taken = nearest(body)
        what = f"no body has its principal moments {_moments(body)}; the nearest that one has are {_moments(taken)}"
        self.notes.append(f"line {self._tensor(link).line}: link '{link}': {what}")
        return taken


def _moments(body: Inertial) -> str:
    """The principal moments about the centre of mass."""
    return ", ".join(f"{w:.4g}" for w in np.linalg.eigvalsh(body.tensor)) + " kg·m²"


def _axes(joint: UrdfJoint, shape: LinkPlacement | None) -> list:
    """The axes of a joint in the axes of the link that it carries."""
    if joint.kind == "planar":
        normal = np.array(joint.axis) / np.linalg.norm(joint.axis)
        x = np.eye(3)[0] if abs(normal[0]) < 0.9 else np.eye(3)[2]
        x = x - (x @ normal) * normal
        x /= np.linalg.norm(x)
        first, second, axis = (_in(shape, a) for a in (x, np.cross(normal, x), normal))
        return [{"slide": first}, {"slide": second}, axis]
    axis = _in(shape, joint.axis)
    return [{"slide": axis} if joint.kind in SLIDING else axis]


def _in(shape: LinkPlacement | None, axis: Sequence[float] | np.ndarray) -> tuple[float, float, float]:
    turn = HERE.R if shape is None else shape.frame.R.T
    return tuple(axis) if shape is None and isinstance(axis, list) else cleaned(turn @ np.array(axis))


def identifiers(names: Iterable[str]) -> dict[str, str]:
    """A C identifier for each name of a link: distinct in any case of letters."""
    found: dict[str, str] = {}
    taken = {WORLD.upper()}
    for name in names:
        plain = stem = _letters(name)
        count = 1
        while plain.upper() in taken or plain in KEYWORDS.split():
            count += 1
            plain = f"{stem[: MAX_LENGTH - len(str(count)) - 1]}_{count}"
        taken.add(plain.upper())
        found[name] = plain
    return found


def robot_identifier(name: str) -> str:
    """A C identifier for the name of a robot, which no file of the generated code has."""
    plain = _letters(name)
    return f"{plain[: MAX_LENGTH - 6]}_robot" if plain.lower() in (*FILE_NAMES.split(), *KEYWORDS.split()) else plain


def _letters(name: str) -> str:
    plain = "".join(c if c.isascii() and c.isalnum() else "_" for c in name)
    return (plain if plain[0].isalpha() else f"link{plain}" if plain[0] == "_" else f"link_{plain}")[:MAX_LENGTH]
