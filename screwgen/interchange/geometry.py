"""The shapes of a URDF: where they stand on their links, their lengths, and the meshes of files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from ..errors import UsageError, one_line
from ..spec.values import quoted
from .markup import Element
from .rigid import Pose, pose
from .urdf import origin_of

KINDS = ("mesh", "box", "cylinder", "sphere")
PACKAGE, FILE = "package://", "file://"
PATHS = {"ROS_PACKAGE_PATH": "", "AMENT_PREFIX_PATH": "share"}
"""Variables with folders of packages, and where in these packages lie."""


def placed_shape(element: Element) -> tuple[Pose, Element]:
    """Where a `<visual>` or `<collision>` stands in the frame of its link, and its one shape."""
    geometry = element.needed("geometry", 'state <geometry><mesh filename="…"/></geometry>')
    shapes = [x for x in geometry.children if x.tag in KINDS]
    if len(shapes) != 1 or len(geometry.children) != 1:
        raise geometry.fault(f"must have one of {', '.join(f'<{kind}>' for kind in KINDS)}")
    return pose(*origin_of(element)), shapes[0]


def dimensions(shape: Element) -> dict[str, list[float]]:
    """The lengths of a box, a cylinder or a sphere, or the scale of a mesh, by their attributes."""
    keys = {"box": {"size": 3}, "cylinder": {"radius": 1, "length": 1}, "sphere": {"radius": 1}}
    if shape.tag == "mesh":
        scale = shape.numbers("scale", 3, "position", "1 1 1")
        if 0 in scale:
            raise shape.fault(f"is {quoted(shape.attributes['scale'])}; factors must not be 0", "scale")
        return {"scale": scale}
    given = {key: shape.numbers(key, size, "position") for key, size in keys[shape.tag].items()}
    for key, numbers in given.items():
        if min(numbers) <= 0:
            raise shape.fault(f"is {quoted(shape.attributes[key])}; lengths must be > 0", key)
    return given


def trimesh_package() -> Any:
    """The package that reads meshes. Raises UsageError where it is not there."""
    try:
        import trimesh
    except ImportError:
        raise UsageError("meshes need trimesh, which is not there; pip install 'screwgen[meshes]'") from None
    return trimesh


def meshes_of(shape: Element, urdf_file: str, otherwise: str) -> list[Any]:
    """The meshes (trimesh) of a `<mesh>`, m, in the frame of the shape.

    Raises ValueError, one line, where they cannot be read; `otherwise`: what that line says will follow.
    """
    name, scale = shape.string("filename"), dimensions(shape)["scale"]
    try:
        path = located(name, urdf_file)
    except OSError:  # as of a name that is too long
        path = None
    if path is None:
        raise ValueError(f"there is no file {one_line(name)}; {otherwise}{_where(name)}")
    try:
        if out := _read(trimesh_package(), path, scale):
            return out
        reason = "it holds no triangles that have an area"
    except UsageError:
        raise
    except Exception as error:
        reason = one_line(str(error)) or type(error).__name__
    raise ValueError(f"{one_line(str(path))} cannot be read ({reason}); {otherwise}")


def _read(trimesh: Any, path: Path, scale: Sequence[float]) -> list[Any]:
    scene = trimesh.load_scene(path)
    unit = trimesh.units.unit_conversion(scene.units, "meters") if scene.units else 1.0
    out = []
    for node in scene.graph.nodes_geometry:
        transform, geometry = scene.graph[node]
        mesh = scene.geometry[geometry].copy()
        if isinstance(mesh, trimesh.Trimesh) and len(mesh.faces):
            mesh.apply_transform(np.diag([*scale, 1.0]) @ np.diag([unit] * 3 + [1.0]) @ transform)
            out.append(mesh)
    sound = np.isfinite([mesh.bounds for mesh in out]).all() and any(mesh.area > 0 for mesh in out)
    return out if sound else []


def _where(name: str) -> str:
    """How to say where a package lies, of which `name` is a file."""
    if not name.startswith(PACKAGE):
        return ""
    package = one_line(name[len(PACKAGE) :].split("/")[0])
    return f"; set ROS_PACKAGE_PATH to the folder that holds the folder '{package}'"


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
