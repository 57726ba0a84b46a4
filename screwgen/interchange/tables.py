"""The tables of a robot file from the links of a URDF's tree."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..spec.base import FLOATING
from ..spec.parents import WORLD
from ..spec.values import quoted
from .rigid import LAST_DIGIT, cleaned
from .tree import MergedLink, UrdfTree
from .urdf import SLIDING, UrdfJoint

GRAVITY = (0.0, 0.0, -9.81)
STICKING = {False: 0.01, True: 0.001}
"""The rate over which dry friction changes its sign, rad/s, and m/s of slides: a URDF states none."""
ORDER = ("length", "frame_at", "order", "section", "profile", "body", "modes", "damping", "segments", "markers")


def robot_tables(tree: UrdfTree) -> tuple[dict[str, Any], dict[str, str], dict[str, tuple[str, ...]]]:
    """The robot's keys; a comment for each link by its name; the coordinates' names of each moving joint."""
    robot: dict[str, Any] = {"name": tree.name, "gravity": GRAVITY} | tree.side.robot
    if tree.floating:
        robot["base"] = FLOATING
    if couplings := list(_couplings(tree)):
        robot["couplings"] = couplings
    robot["links"] = [_link(tree, i, node) for i, node in enumerate(tree.nodes)]
    tree.notes += _limits_note(tree, "velocity", "rad/s, m/s")
    comments, joints = {}, {}
    for node in tree.nodes:
        if node.joint is not None:
            comments[node.name] = f"{node.joint.name}: {node.joint.kind}, {node.joint.parent} -> {node.joint.child}"
        if node.joint is not None and node.axes:
            joints[node.joint.name] = coordinates(node)
    return robot, comments, joints


def _couplings(tree: UrdfTree) -> Iterator[dict[str, Any]]:
    """The couplings of joints that mimic others; what they mimic may have been welded for want of mass."""
    nodes = {node.joint.name: node for node in tree.nodes if node.joint is not None and node.axes}
    for node in nodes.values():
        if node.joint is None or node.joint.mimic is None or tree.options.mimic != "couple":
            continue
        other, ratio, offset = node.joint.mimicked
        if other not in tree.urdf.joints or other == node.joint.name:
            raise node.joint.mimic.fault(f"names {quoted(other)}, which is no other joint; name one", "joint")
        if other not in nodes:
            what = f"its <mimic> is left out, for joint '{other}' does not move"
            tree.notes.append(f"joint '{node.joint.name}': {what}; it moves on its own")
            continue
        if len(node.axes) > 1 or len(nodes[other].axes) > 1:
            raise node.joint.mimic.fault("couples a planar joint, which has several coordinates; leave it out")
        (axis,), (of,) = coordinates(node), coordinates(nodes[other])
        yield {"axis": axis, "of": of, "ratio": ratio} | ({"offset": offset} if offset else {})


def coordinates(node: MergedLink) -> tuple[str, ...]:
    """The names of a node's joint coordinates."""
    kinds = ("slide" if isinstance(axis, dict) else "joint" for axis in node.axes)
    return tuple(f"{node.name}.{kind}[{k}]" for k, kind in enumerate(kinds))


def _link(tree: UrdfTree, i: int, node: MergedLink) -> dict[str, Any]:
    side = tree.side.links.get(node.urdf, {})
    table: dict[str, Any] = {"name": node.name}
    if node.carrier != i - 1:
        table["parent"] = WORLD if node.carrier < 0 else tree.nodes[node.carrier].name
    if node.at != "tip":
        table["at"] = node.at
    keys = node.shape.keys if node.shape else {key: value for key, value in side.items() if key != "name"}
    table |= {key: keys[key] for key in ORDER if key in keys}
    table["joint"] = _joint(tree, node) | side.get("joint", {})
    bodies = [tree.inertia(parts).table(at) for at, parts in (("base", node.base), ("tip", node.tip)) if parts]
    bodies += list(keys.get("bodies", ()))
    if not bodies and "section" not in keys and "profile" not in keys and "body" not in keys:
        bodies = [{"at": "base", "mass": 0.0}]
    if bodies:
        table["bodies"] = bodies
    return table | {
        key: value for key, value in keys.items() if key not in table and key not in ("joint", "bodies", "at")
    }


def _joint(tree: UrdfTree, node: MergedLink) -> dict[str, Any]:
    joint = node.joint
    table: dict[str, Any] = {"axes": node.axes}
    floats = node.joint is None and tree.floating
    stated = joint if joint is not None and node.literal else None
    xyz, rpy = (stated.xyz, stated.rpy) if stated else (node.mount.xyz, cleaned(node.mount.rpy, LAST_DIGIT))
    mount = {key: tuple(value) for key, value in (("xyz", xyz), ("rpy", rpy)) if any(value)}
    if mount and not floats:
        table["mount"] = mount
    if joint is None or not node.axes:
        return table
    if len(node.axes) > 1:
        for what, there in (("<dynamics> are", joint.damping or joint.friction), ("effort is", joint.effort)):
            if there:
                said = f"its {what} left out, a planar joint has several coordinates"
                tree.notes.append(f"joint '{joint.name}': {said}")
        return table
    if joint.damping:
        table["damping"] = joint.damping
    if drive := _drive(joint):
        table["drives"] = drive
    if joint.friction:
        rate = drive["friction"]["velocity"]
        unit = "m/s" if joint.kind in SLIDING else "rad/s"
        said = f"friction changes its sign over {rate:g} {unit}, which a URDF does not state"
        tree.notes.append(f"joint '{joint.name}': {said}")
    if limits := {key: x for key in ("lower", "upper", "effort") if (x := getattr(joint, key)) is not None}:
        table["limits"] = limits
    return table


def _drive(joint: UrdfJoint) -> dict[str, Any]:
    drive: dict[str, Any] = {}
    if joint.rotor_inertia is not None:
        drive |= ({"ratio": joint.ratio} if joint.ratio is not None else {}) | {"rotor_inertia": joint.rotor_inertia}
    if joint.friction:
        drive["friction"] = {"coulomb": joint.friction, "velocity": STICKING[joint.kind in SLIDING]}
    return drive


def _limits_note(tree: UrdfTree, key: str, what: str) -> list[str]:
    """Limits that a robot file has no place for, in the order of the torques."""
    values = [getattr(node.joint, key) for node in tree.nodes if node.joint is not None for _ in node.axes]
    if not any(values):
        return []
    shown = ", ".join("none" if value is None else f"{value:g}" for value in values)
    return [f"limits of {key}, which a robot file does not have ({what}): [{shown}]"]
