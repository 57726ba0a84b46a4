"""The looks of a URDF: its visuals with their colours, and where its links are at zero coordinates."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..spec.values import quoted
from .geometry import placed_shape
from .markup import Element
from .rigid import HERE, Pose
from .urdf import FREE, Urdf


class Visual(NamedTuple):
    """A shape in the frame of a link; `shape` is the element `mesh`, `box`, `cylinder` or `sphere`."""

    link: str
    at: Pose
    shape: Element
    color: str | None
    """`#rrggbb`, None where the file states none."""


def visuals(urdf: Urdf) -> Iterator[Visual]:
    """Each visual that can be seen. Raises RobotFileError."""
    named = _named(urdf)
    for link in urdf.links.values():
        for element in link.element.all("visual"):
            at, shape = placed_shape(element)
            color = _color(element.only("material"), named)
            if color is None or color[3] > 0:
                yield Visual(link.name, at, shape, None if color is None else _hex(color))


def _named(urdf: Urdf) -> dict[str, Element]:
    """The materials with a name and a colour, the first of each name: those of the robot, then those of visuals."""
    seen = [visual for link in urdf.links.values() for visual in link.element.all("visual")]
    named: dict[str, Element] = {}
    for material in (x for parent in (urdf.element, *seen) for x in parent.all("material")):
        if (name := material.attributes.get("name")) and material.only("color") is not None:
            named.setdefault(name, material)
    return named


def _color(material: Element | None, named: dict[str, Element]) -> list[float] | None:
    if material is None:
        return None
    own = material.only("color")
    if own is None and material.attributes.get("name") in named:
        own = named[material.attributes["name"]].only("color")
    if own is None:
        return None
    color = own.numbers("rgba", 4, "any limit")
    if not all(0 <= x <= 1 for x in color):
        raise own.fault(f"is {quoted(own.attributes['rgba'])}; each of the four must be from 0 to 1", "rgba")
    return color


def _hex(color: list[float]) -> str:
    return "#" + "".join(f"{round(255 * x):02x}" for x in color[:3])


def at_zero(urdf: Urdf, held: set[str]) -> dict[str, Pose]:
    """The pose of each link in the first one that moves with the robot's base, or the root, at zero coordinates.

    `held`: links whose joints are welded; of joints that mimic others these stand where the others are at 0.
    """
    below = urdf.below(urdf.root)
    base = below[0].child if len(below) == 1 and below[0].kind == FREE else urdf.root
    found, left = {urdf.root: HERE, base: HERE}, [base]
    for link in left:
        for joint in urdf.below(link):
            found[joint.child] = found[link] @ joint.origin @ (joint.mimicking if joint.child in held else HERE)
            left.append(joint.child)
    return found
