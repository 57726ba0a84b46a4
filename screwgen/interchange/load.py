"""The front door for robots in files: robot files, and URDFs with what a side file adds to them."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import UsageError
from ..spec.joint import MOVED_BY
from ..spec.load import load as load_robot_file
from ..spec.load import one_line, read, validated
from ..spec.robot import Robot
from .flexible import SideFile, read_side_file, replaced
from .rigid import Inertial
from .singular import first_without_inertia
from .tables import robot_tables
from .toml_write import document
from .tree import MergedLink, Options, UrdfTree
from .urdf import read_urdf
from .weights import weigh

SUFFIXES = (".urdf", ".xacro", ".xml")


class ImportNote(UserWarning):
    """What of a URDF was left out or changed, one line each."""


@dataclass(frozen=True)
class Imported:
    """A robot from a URDF.

    ``notes``: what was left out or changed, one line each; ``joints``: for each joint of the URDF that moves, the names
    of its coordinates; ``tables``: the content of the robot file.
    """

    robot: Robot
    notes: tuple[str, ...]
    joints: Mapping[str, tuple[str, ...]]
    tables: dict[str, Any]
    comments: dict[str, str]
    sources: tuple[str, ...]
    folder: str

    def summary(self) -> str:
        """One line: the links, and how many coordinates they have."""
        return self.robot.summary

    def text(self, folder: str | os.PathLike[str] = ".") -> str:
        """The robot file as text; `folder`: where it will be, from which the files of bodies are named."""
        from ..version import __version__

        head = [f"From {' and '.join(self.sources)}, by screwgen {__version__}.", *self.notes]
        return document(self.tables, head, self.comments, self.folder, folder)


def load(
    path: str | os.PathLike[str],
    flexible: str | os.PathLike[str] | None = None,
    *,
    keep_fixed: bool = False,
    floating: bool = False,
    mimic: str = "couple",
    tip: str | None = None,
    nearest_inertia: bool = False,
    density: float | None = None,
    total_mass: float | None = None,
) -> Robot:
    """The robot that the file at `path` describes: a robot file (TOML), or a URDF.

    What else is given is for a URDF alone.  ``flexible``: a side file that says which links are flexible; the others
    as :class:`.Options` has them.  Each thing of a URDF that is left out is an :class:`ImportNote`.  Raises
    RobotFileError, one line that names the file, the place in it, the fault and the remedy.
    """
    options = Options(keep_fixed, floating, mimic, tip, nearest_inertia, density, total_mass)
    if not is_urdf(path):
        if flexible is not None or options != Options():
            raise UsageError(
                f"{one_line(os.fsdecode(path))}: is no .urdf; flexible and the options are those of a URDF"
            )
        return load_robot_file(path)
    found = import_urdf(path, flexible, options)
    for note in found.notes:
        warnings.warn(f"{one_line(os.fsdecode(path))}: {note}", ImportNote, stacklevel=2)
    return found.robot


def is_urdf(path: str | os.PathLike[str]) -> bool:
    """Whether the file's name is that of a URDF."""
    return os.path.splitext(os.fsdecode(path))[1].lower() in SUFFIXES


def import_urdf(
    path: str | os.PathLike[str], flexible: str | os.PathLike[str] | None = None, options: Options | None = None
) -> Imported:
    """The robot in a URDF, with notes and names; as :func:`load`."""
    file = one_line(os.fsdecode(path))
    urdf = read_urdf(read(path, file), file)
    side = read_side_file(flexible, urdf)
    options = options or Options()
    weigh(urdf, side, path, options.density, options.total_mass)
    tree = UrdfTree(urdf, side, options)
    tables, comments, joints = robot_tables(tree)
    robot = validated(tables, side.folder, lambda at: _place(at, tree, file))
    _refuse_without_inertia(tree, robot)
    shaped = [(x, link) for x, link in zip(tree.nodes, robot.links, strict=True) if x.shape and x.shape.stated]
    tree.notes += [replaced(side, x.urdf, x.shape, urdf.links[x.urdf].body, link) for x, link in shaped if x.shape]
    sources = [os.path.basename(name) for name in (file, side.file) if name]
    return Imported(robot, tuple(tree.notes), joints, tables, comments, tuple(sources), side.folder)


def _place(at: tuple, tree: UrdfTree, file: str) -> tuple[str, tuple]:
    """The file, and the path in it, of a fault at the path `at` of the robot's tables."""
    side = tree.side
    match at:
        case ("links", int(i), *rest) if (name := tree.nodes[i].urdf) in side.links:
            return side.file, ("links", side.places[name], *rest)
        case (str(key), *_) if key in side.robot:
            return side.file, at
    return file, at


def _refuse_without_inertia(tree: UrdfTree, robot: Robot) -> None:
    """Refuse a joint that the mass matrix could not be solved for; links with a shape are taken to have inertia."""
    nodes = tree.nodes
    inertias = []
    for node, link in zip(nodes, robot.links, strict=True):
        bodies = (Inertial.of(x.mass, x.com, x.inertia).about_origin() for x in link.bodies)
        inertias.append(np.eye(6) if node.shape else sum(bodies, np.zeros((6, 6))))
    mounts = [node.mount for node in nodes]
    armature = [_armature(x, tree.side) for x in nodes]
    carriers = [node.carrier for node in nodes]
    found = first_without_inertia(carriers, mounts, [node.axes for node in nodes], inertias, armature)
    joint = nodes[found].joint if found is not None else None
    if joint is not None:
        what = f"moves nothing that resists it: link '{joint.child}' and what it carries have no inertia about its axis"
        raise joint.element.fault(f"{what}; give the link an <inertial>, or bodies in a side file, or fix the joint")
    if tree.floating and np.linalg.matrix_rank(inertias[0]) < 6 and len(nodes) == 1:
        if not inertias[0].any():
            raise tree.without_mass(nodes[0].urdf)
        what = "is a floating base that does not resist every motion; give it a whole <inertial>"
        raise tree.urdf.links[nodes[0].urdf].element.fault(what)


def _armature(node: MergedLink, side: SideFile) -> float:
    """The rotor's inertia at the joint; 1 where the side file states one, whose value is then not checked here."""
    stated = side.links.get(node.urdf, {}).get("joint", {})
    if node.joint is None or not stated.keys().isdisjoint(MOVED_BY):
        return 1.0
    return node.joint.armature
