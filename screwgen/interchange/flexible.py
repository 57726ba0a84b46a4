"""The side file of a URDF: which links are flexible, and what else of a robot file the URDF has no word for.

It is a part of a robot file. Its `[[links]]` name links of the URDF and add keys of a robot file to them; keys beside
`[[links]]`, such as `gravity`, are those of the robot. Three keys are its own: `tip`, where the centreline of a link
ends, `y`, the direction of the section's y axis, and `rpy`, how the axes of a body from finite elements stand, all
in the frame of the URDF's link.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..bases.weighted import LINEAR
from ..errors import RobotFileError
from ..spec.load import decode, one_line, parse, read
from ..spec.ranges import several, within
from ..spec.reduced import FOLDER, Reduced
from ..spec.robot import Link
from ..spec.stations import MOST_POLYNOMIAL, Stations, checked, lagrange
from ..spec.values import quoted, shown
from .rigid import HERE, Inertial, Pose, pose
from .urdf import FIXED, Urdf

OWN = ("tip", "y", "rpy")
ROD = ("length", "section", "profile", "tip", "y")
ASKEW = 1.0
"""Degrees between the centreline and an axis of its link from which on it is said."""
UPRIGHT = 0.9
"""Cosine of the angle to the centreline from which on the link's y axis is no direction for that of the section."""


@dataclass
class SideFile:
    """The content: keys of the robot, and the table of each link of the URDF by its name."""

    file: str = ""
    folder: str = ""
    robot: dict[str, Any] = field(default_factory=dict)
    links: dict[str, dict[str, Any]] = field(default_factory=dict)
    places: dict[str, int] = field(default_factory=dict)

    def fault(self, link: str, key: str, what: str) -> RobotFileError:
        """The error of a key of a link."""
        return RobotFileError(f"{self.file}: links[{self.places[link]}]{key and '.' + key} (link {link}): {what}")


def read_side_file(path: str | os.PathLike[str] | None, urdf: Urdf) -> SideFile:
    """The side file at `path`, its names those of the URDF."""
    if path is None:
        return SideFile()
    file = one_line(os.fsdecode(path))
    data = parse(decode(read(path, file), file), file)
    tables = data.pop("links", [])
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise RobotFileError(f"{file}: links: is no array of tables; write [[links]] for each")
    found = SideFile(file, os.path.dirname(os.fspath(path)), data)
    for i, table in enumerate(tables):
        name = table.get("name")
        if not isinstance(name, str) or name not in urdf.links:
            known = ", ".join(map(quoted, list(urdf.links)[:12])) + (", …" if len(urdf.links) > 12 else "")
            what = f"is {shown(name)}, no link of {urdf.element.file}; it has {known}"
            raise RobotFileError(f"{file}: links[{i}].name: {what}")
        if name in found.links:
            raise RobotFileError(f"{file}: links[{i}].name: is {quoted(name)} again; state all of a link in one table")
        found.links[name], found.places[name] = table, i
        _refuse_the_urdfs(found, name, table)
    return found


def _refuse_the_urdfs(side: SideFile, name: str, table: dict[str, Any]) -> None:
    joint = table.get("joint", {})
    if not isinstance(joint, dict):
        raise side.fault(name, "joint", f"is {shown(joint)}; it must be a table")
    stated = ["parent"] if "parent" in table else [f"joint.{key}" for key in ("axes", "mount") if key in joint]
    if stated:
        raise side.fault(name, stated[0], "is what the URDF states; change it there")
    if "rest" in table:
        what = "bends the link away from where the URDF has what it carries"
        raise side.fault(name, "rest", f"{what}; state it in the robot file that is written")
    if not isinstance(table.get("bodies", []), list):
        raise side.fault(name, "bodies", f"is {shown(table['bodies'])}; it must be an array of tables")


@dataclass(frozen=True)
class LinkPlacement:
    """How a link that the side file gives a shape sits in the frame of the URDF's link.

    `frame`: the link frame F_i there, with the same origin; `tip`: the undeformed tip frame in F_i; `keys`: what the
    file states of the link, as a robot file has it; `bends`: whether it has modes; `ends`: whether its tip alone can
    carry others.
    """

    frame: Pose
    tip: Pose
    keys: dict[str, Any]
    bends: bool
    ends: bool

    @property
    def stated(self) -> str:
        """The key that says what the link weighs, in place of the URDF's inertial; "" where none does."""
        return next((key for key in ("body", "profile", "section") if key in self.keys), "")

    def section(self, s: float) -> Pose:
        """The undeformed section at the place s, in F_i."""
        return self.tip if s == 1 else Pose(HERE.R, s * self.tip.p)

    def foot(self, point: np.ndarray) -> float:
        """The place s of the section nearest to a point of F_i."""
        length = self.tip.p @ self.tip.p
        if self.ends or not self.bends or not length:
            return 1.0
        s = float(point @ self.tip.p / length)
        return 0.0 if s < 1e-9 else 1.0 if s > 1 - 1e-9 else s


def shape_of(side: SideFile, urdf: Urdf, name: str, body: Inertial | None) -> LinkPlacement | None:
    """The shape of a link, None where the side file gives it none; `body`: its inertia as the URDF states it."""
    table = {key: value for key, value in side.links.get(name, {}).items() if key != "name"}
    keys = {key: value for key, value in table.items() if key not in OWN}
    if "body" in table:
        frame = pose((0, 0, 0), _numbers(side, name, "rpy", table.get("rpy", [0, 0, 0]), "turn"))
        for key in ("tip", "y"):
            if key in table:
                raise side.fault(name, key, "is stated beside body, whose file gives the tip; leave it out")
        try:
            read_body = checked(Reduced, table["body"], (), context={FOLDER: side.folder})
        except ValueError as error:
            where = ".".join(("body", *map(str, getattr(error, "context", {}).get("at", ()))))
            raise side.fault(name, where, getattr(error, "context", {}).get("what", str(error))) from None
        end = read_body.data.tip
        tip = Pose(np.array(end.axes), np.array(end.origin))
        return LinkPlacement(frame, tip, keys | {"body": read_body}, True, True)
    if not any(key in table for key in ROD):
        if "rpy" in table:
            raise side.fault(name, "rpy", "is stated without body, whose axes it turns; leave it out, or state y")
        return None
    if "rpy" in table:
        raise side.fault(name, "rpy", "is stated of a rod, whose x axis is its centreline; state y")
    return _rod(side, urdf, name, table, keys, body)


def _rod(side: SideFile, urdf: Urdf, name: str, table: dict, keys: dict, body: Inertial | None) -> LinkPlacement:
    end = _tip(side, urdf, name, table.get("tip"))
    size = float(np.linalg.norm(end))
    if size == 0:
        raise side.fault(name, "tip", "is the origin of the link; state another joint, or [x, y, z] in its frame, m")
    x = end / size
    R = np.column_stack([x, y := _across(side, name, table.get("y"), x), np.cross(x, y)])
    R[np.abs(R) < 1e-15] = 0.0
    length = _checked(side, name, "length", keys.get("length", size), within("length"))
    section = keys.get("section")
    if (
        isinstance(section, dict)
        and not {"rhoA", "density", "stations"} & set(section)
        and body
        and body.mass
        and length
    ):
        keys = keys | {"section": {"rhoA": body.mass / length} | section}
    keys = {"length": length} | keys
    return LinkPlacement(Pose(R, np.zeros(3)), Pose(HERE.R, np.array([length, 0.0, 0.0])), keys, "modes" in keys, False)


def _tip(side: SideFile, urdf: Urdf, name: str, stated: Any) -> np.ndarray:
    below = urdf.below(name)
    if isinstance(stated, str):
        found = [joint for joint in below if stated in (joint.name, joint.child)]
        if not found:
            known = ", ".join(quoted(joint.name) for joint in below) or "none"
            raise side.fault(name, "tip", f"is {quoted(stated)}, no joint that the link carries; it carries {known}")
        return found[0].origin.p
    if stated is not None:
        return np.array(_numbers(side, name, "tip", stated, "position"))
    found = [joint for joint in below if joint.kind != FIXED] if len(below) > 1 else below
    if len(found) != 1:
        what = f"is missing, and the link carries {len(found)} joints that move"
        raise side.fault(name, "tip", f"{what}; state the one at the tip, or [x, y, z] in the link's frame, m")
    return found[0].origin.p


def _across(side: SideFile, name: str, stated: Any, x: np.ndarray) -> np.ndarray:
    """The unit y axis of the section: what is stated, or an axis of the link, made perpendicular to the centreline."""
    if stated is None:
        y = np.eye(3)[1 if abs(x[1]) < UPRIGHT else 2]
    else:
        y = np.array(_numbers(side, name, "y", stated, "position"))
    across: np.ndarray = y - float(y @ x) * x
    if np.linalg.norm(across) <= 1e-6 * float(np.linalg.norm(y)):
        raise side.fault(name, "y", "is along the centreline; state a direction across it, in the link's frame")
    return across / np.linalg.norm(across)


def _numbers(side: SideFile, name: str, key: str, value: Any, quantity: str) -> tuple[float, ...]:
    return _checked(side, name, key, value, several(quantity, 3))


def _checked(side: SideFile, name: str, key: str, value: Any, check: Callable[[Any], Any]) -> Any:
    try:
        return check(value)
    except ValueError as error:
        raise side.fault(name, key, str(error)) from None


def replaced(side: SideFile, name: str, shape: LinkPlacement, body: Inertial | None, link: Link) -> str:
    """One line on a link that the side file gives a body: where its centreline runs, and what it weighs now and did."""
    own = side.links[name].get("section")
    if shape.stated == "section" and isinstance(own, dict) and body and shape.keys["section"] != own:
        weight = f"its {body.mass:.6g} kg are spread over the section"
    else:
        was = (
            f"takes the place of the inertial, {body.mass:.6g} kg" if body else "stands where the URDF has no inertial"
        )
        weight = f"its {shape.stated} {was}, and weighs {_mass(link):.6g} kg"
    line = "" if shape.stated == "body" else f"{_line(side, name, shape)}; "
    return f"link '{name}': {line}{weight}; what else it carries are bodies of the side file"


def _line(side: SideFile, name: str, shape: LinkPlacement) -> str:
    """The length of a rod, and how its centreline runs in the link's axes, with the tip that would lay it along one."""
    x, length = shape.frame.R[:, 0], float(shape.tip.p[0])
    axis = int(np.abs(x).argmax())
    skew = float(np.degrees(np.arccos(min(abs(x[axis]), 1.0))))
    if skew < ASKEW:
        return f"a beam of {length:.4g} m along its {'xyz'[axis]} axis"
    along = [float(f"{length * x[axis]:.6g}") if k == axis else 0.0 for k in range(3)]
    unstated = "tip" not in side.links[name] and "length" not in side.links[name]
    remedy = f" (tip = {along} lays it along)" if unstated else ""
    return f"a beam of {length:.4g} m, {skew:.1f}° askew to its {'xyz'[axis]} axis{remedy}"


def _mass(link: Link) -> float:
    """What the section or the body of a link weighs, kg."""
    if link.body is not None:
        return float(link.body.data.mass)
    section, length = link.section, link.length or 0.0
    if not isinstance(section, Stations):
        return length * (section.rhoA if section else 0.0)
    if section.between == LINEAR:
        return length * float(np.trapezoid(section.values("rhoA"), section.places))
    s, w = np.polynomial.legendre.leggauss(MOST_POLYNOMIAL)
    values = [lagrange(section.places, section.values("rhoA"), (1 + x) / 2) for x in s]
    return length * float(w @ values) / 2
