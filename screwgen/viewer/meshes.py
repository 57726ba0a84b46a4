"""The visuals of a URDF on the links of a robot that came from it: they bend where the links do.

Where a visual sits on its link is read off the two at zero coordinates, at which the robot stands as the URDF does,
whatever frames its links have. A link that the robot does not have was merged into the one that carries it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ..errors import UsageError
from ..interchange.geometry import dimensions, meshes_of, trimesh_package
from ..interchange.tree import identifiers
from ..interchange.urdf import Urdf, read_urdf
from ..interchange.visuals import Visual, at_zero, visuals
from ..model import Model
from ..spec.load import one_line, read
from .pack import b64, rounded
from .solids import METAL, Solid

CREASE = np.radians(35.0)
"""Faces that meet at less are shaded as one surface."""
FINE = 2e-5
"""How far a vertex may be off in the page, over the size of the robot."""
NEAR = 1e-5
"""How far a link of the robot may be from that of the URDF, over the size of the robot."""
LONGEST = 0.08
"""Of edges on links that bend, over the length of the link; longer ones are cut."""
MOST_TRIANGLES = 3_000_000


class ColouredSurface(NamedTuple):
    """A surface in one colour in the frame of a link of the URDF: vertices (V, 3), m, and triangles (F, 3)."""

    link: str
    points: np.ndarray
    triangles: np.ndarray
    color: str


@dataclass
class Looks:
    """The visuals of a URDF; `notes`: what could not be read, one line each."""

    file: str
    urdf: Urdf
    parts: list[ColouredSurface] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    count: int = 0
    """How many visuals were read."""

    @property
    def triangles(self) -> int:
        """Of all parts."""
        return sum(len(part.triangles) for part in self.parts)


def read_looks(path: str | os.PathLike[str]) -> Looks:
    """The visuals of the URDF at `path`. Raises RobotFileError, and UsageError for want of the package."""
    trimesh = trimesh_package()
    file = one_line(os.fsdecode(path))
    looks = Looks(file, read_urdf(read(path, file), file))
    for visual in visuals(looks.urdf):
        before = len(looks.parts)
        for points, triangles, color in _surfaces(trimesh, visual, os.fsdecode(path), looks.notes):
            looks.parts.append(ColouredSurface(visual.link, visual.at.p + points @ visual.at.R.T, triangles, color))
        looks.count += len(looks.parts) > before
        if looks.triangles > MOST_TRIANGLES:
            raise UsageError(f"{file}: its visuals have more than {MOST_TRIANGLES} triangles; simplify the meshes")
    if not looks.parts:
        looks.notes.append("has no visual that could be read; the robot is drawn without")
    return looks


def _surfaces(
    trimesh: Any, visual: Visual, file: str, notes: list[str]
) -> Iterator[tuple[np.ndarray, np.ndarray, str]]:
    """The surfaces of a visual, cut along their creases, with their colours."""
    for mesh, color in _meshes(trimesh, visual, file, notes):
        plain = trimesh.Trimesh(mesh.vertices, mesh.faces)  # equal vertices are one, whatever their textures
        smooth = plain.face_adjacency[plain.face_adjacency_angles < CREASE]
        patches = trimesh.graph.connected_component_labels(smooth, node_count=len(plain.faces))
        corners = plain.faces * (int(patches.max()) + 1) + patches[:, None]
        used, triangles = np.unique(corners, return_inverse=True)
        points = np.array(plain.vertices[used // (int(patches.max()) + 1)], float)
        yield points, triangles.reshape(-1, 3), visual.color or color


def _meshes(trimesh: Any, visual: Visual, file: str, notes: list[str]) -> list[tuple[Any, str]]:
    shape = visual.shape
    if shape.tag != "mesh":
        make = {
            "box": trimesh.creation.box,
            "sphere": partial(trimesh.creation.icosphere, 3),
            "cylinder": partial(trimesh.creation.cylinder, sections=40),
        }[shape.tag]
        return [(make(*(x if len(x) > 1 else x[0] for x in dimensions(shape).values())), METAL)]
    try:
        return [(mesh, _color(mesh)) for mesh in meshes_of(shape, file, "it is drawn without")]
    except ValueError as error:
        notes.append(f"link '{visual.link}': {error}")
        return []


def _color(mesh: Any) -> str:
    """The colour that a mesh brings along."""
    material = getattr(mesh.visual, "material", None)
    if material is None and not mesh.visual.defined:
        return METAL
    color = material.main_color if material is not None else mesh.visual.main_color
    return "#" + "".join(f"{int(x):02x}" for x in color[:3])


def placed(
    looks: Looks, model: Model, scene: dict[str, Any], label: str, p: np.ndarray | None = None
) -> list[tuple[int, Solid]]:
    """Each surface with the number of the link of `scene` to which it is fixed, -1: the world; triangles alone.

    `p`: values of the model's parameters as `scene` has them, those of the file by default.

    Raises UsageError where the robot's links at zero are not where the URDF has them.
    """
    names, links = identifiers(looks.urdf.links), [link.name for link in model.robot.links]
    held = {link for link, name in names.items() if name not in links}
    zero = at_zero(looks.urdf, held)
    R, r = poses = model.numpy(p).link_pose(model.chain.home)
    _refuse_another(looks, model, scene, {names[link]: x.p for link, x in zero.items()}, label, poses)
    carrier = {joint.child: joint.parent for joint in looks.urdf.joints.values()}
    out: dict[tuple[int, str], list] = {}
    for part in looks.parts:
        owner: str | None = part.link
        while owner is not None and names[owner] not in links:
            owner = carrier.get(owner)
        points = zero[part.link].p + part.points @ zero[part.link].R.T
        if owner is None:
            out.setdefault((-1, part.color), []).append((points, part.triangles, np.empty(0)))
            continue
        i = links.index(names[owner])
        link = scene["links"][model.chain.firsts[i]]
        if link["curved"]:
            raise UsageError(f"{looks.file}: '{owner}' of {label} is curved at rest; meshes of such are not drawn")
        whole = (points, part.triangles)
        if link["modes"] and any(link["reach"]):
            whole = _cut(*whole, LONGEST * float(np.linalg.norm(link["reach"])), f"{looks.file}: link '{owner}'")
        for k, own, triangles in _segments(*whole, model, i, scene, poses):
            out.setdefault((k, part.color), []).append(_fixed((own - r[k]) @ R[k], triangles, scene["links"][k]))
    return [(k, _together(parts, color, k)) for (k, color), parts in out.items()]


def _refuse_another(
    looks: Looks, model: Model, scene: dict, zero: dict[str, np.ndarray], label: str, poses: tuple
) -> None:
    first, known = model.robot.links[0], [i for i, x in enumerate(model.robot.links) if x.name in zero]
    remedy = "name the URDF from which it came"
    if not known:
        raise UsageError(f"{looks.file}: none of its links is one of '{model.robot.name}' of {label}; {remedy}")
    if model.chain.keys[0].floats and first.length is not None:
        raise UsageError(
            f"{looks.file}: '{first.name}' of {label} floats and has a length; meshes of such are not drawn"
        )
    R, r = poses
    for i in known:
        k, name = model.chain.firsts[i], model.robot.links[i].name
        away = float(np.linalg.norm(r[k] + R[k] @ scene["links"][k]["base"] - zero[name]))
        if away > NEAR * scene["size"]:
            what = f"'{name}' of {label} is {away:.3g} m away from it at zero coordinates"
            raise UsageError(f"{looks.file}: {what}; {remedy}")


def _cut(points: np.ndarray, triangles: np.ndarray, longest: float, shown: str) -> tuple[np.ndarray, np.ndarray]:
    """A surface whose edges are at most `longest`, m, so that it can bend; raises UsageError where these are many."""
    import trimesh

    edges = np.linalg.norm(points[triangles] - points[np.roll(triangles, 1, axis=1)], axis=2).max(axis=1)
    if (4.0 ** np.ceil(np.log2(np.maximum(edges / longest, 1.0)))).sum() > MOST_TRIANGLES:
        size = np.ptp(points, axis=0).max() / (longest / LONGEST)
        raise UsageError(f"{shown}: a visual is {size:.3g} times as long as the link; state the scale of its mesh")
    return trimesh.remesh.subdivide_to_size(points, triangles, longest, max_iter=30)


def _segments(
    points: np.ndarray, triangles: np.ndarray, model: Model, link: int, scene: dict, poses: tuple
) -> Iterator[tuple[int, np.ndarray, np.ndarray]]:
    """The points and triangles of each segment of a link, by where along it the triangles' middles are."""
    first, last = model.chain.firsts[link], model.chain.lasts[link]
    own, end = scene["links"][first], scene["links"][last]
    if first == last:
        yield first, points, triangles
        return
    R, r = poses
    start = r[first] + R[first] @ own["base"]
    way = r[last] + R[last] @ np.add(end["base"], end["reach"]) - start
    s = (points[triangles].mean(axis=1) - start) @ way / (way @ way)
    number = np.clip((s * (last - first + 1)).astype(int), 0, last - first)
    for k in np.unique(number):
        used, chosen = np.unique(triangles[number == k], return_inverse=True)
        yield first + int(k), points[used], chosen.reshape(-1, 3)


def _fixed(points: np.ndarray, triangles: np.ndarray, link: dict[str, Any]) -> tuple:
    """Points of F_i; of a link with modes as offsets from the sections at which they are, with the rows of these."""
    reach = np.array(link["reach"])
    if not link["modes"] or not reach.any():
        return points, triangles, np.empty(0)
    s = np.clip((points - link["base"]) @ reach / (reach @ reach), 0.0, 1.0)
    rows = np.interp(s, link["places"], np.arange(len(link["places"])))
    return points - link["base"] - s[:, None] * reach, triangles, rows


def _together(parts: list[tuple], color: str, k: int) -> Solid:
    starts = np.cumsum([0, *(len(points) for points, *_ in parts)])
    points, rows = (np.concatenate([part[n] for part in parts]) for n in (0, 2))
    triangles = np.concatenate([part[1] + start for part, start in zip(parts, starts, strict=False)])
    to = "world" if k < 0 else "sections" if len(rows) else "frame"
    return Solid(points, np.column_stack([triangles, triangles[:, 2]]), color, to, rows)


def packed(link: int, solid: Solid, size: float) -> dict[str, Any]:
    """A surface for the page; `size`: that of the robot, m."""
    table = np.column_stack([solid.points, solid.rows]) if len(solid.rows) else solid.points
    wide = len(solid.points) >= 2**16  # the index 65535 would end a strip of triangles
    index = np.ascontiguousarray(solid.faces[:, :3], "<u4" if wide else "<u2")
    tolerance = np.array([FINE * size] * 3 + [1e-3])[: table.shape[1]]
    return {
        "link": link,
        "color": solid.color,
        "table": rounded(table, tolerance),
        "wide": wide,
        "index": b64(index),
    }
