"""The looks of a URDF: its visuals with their colours, and where its links are at zero coordinates."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from urllib.parse import unquote

from ..spec.values import quoted
from .markup import Element
from .rigid import HERE, Pose, pose
from .urdf import FREE, Urdf

KINDS = ("mesh", "box", "cylinder", "sphere")
PACKAGE, FILE = "package://", "file://"
PATHS = {"ROS_PACKAGE_PATH": "", "AMENT_PREFIX_PATH": "share"}
"""Variables with folders of packages, and where in these packages lie."""


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
            geometry = element.needed("geometry", 'state <geometry><mesh filename="…"/></geometry>')
            shapes = [x for x in geometry.children if x.tag in KINDS]
            if len(shapes) != 1 or len(geometry.children) != 1:
                raise geometry.fault(f"must have one of {', '.join(f'<{kind}>' for kind in KINDS)}")
            origin = element.only("origin")
            at = HERE
            if origin is not None:
                place = (origin.numbers(key, 3, kind, "0 0 0") for key, kind in (("xyz", "position"), ("rpy", "turn")))
                at = pose(*place)
            color = _color(element.only("material"), named)
            if color is None or color[3] > 0:
                yield Visual(link.name, at, shapes[0], None if color is None else _hex(color))


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


def located(name: str, urdf_file: str) -> Path | None:
    """The file that a `filename` of a URDF means, None where there is none.

    `package://` is looked for in the folders of ROS_PACKAGE_PATH and AMENT_PREFIX_PATH, then upwards from the URDF's
    own folder; other names are relative to that folder.
    """
    own = Path(urdf_file).resolve().parent
    if not name.startswith(PACKAGE):
        path = own / (unquote(name[len(FILE) :]) if name.startswith(FILE) else name)
        return path if path.is_file() else None
    package, _, rest = name[len(PACKAGE) :].lstrip("/").partition("/")
    folders = [
        Path(x) / inner
        for variable, inner in PATHS.items()
        for x in os.environ.get(variable, "").split(os.pathsep)
        if x
    ]
    for folder in (*folders, own, *own.parents):
        for path in (folder / package / rest, *([folder / rest] if folder.name == package else [])):
            if path.is_file():
                return path
    return None
