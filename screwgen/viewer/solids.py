"""The surfaces of what is drawn, as quadrilaterals in the frame of a link, that bend along with its sections."""

from __future__ import annotations

from base64 import b64decode
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

AROUND = 14
"""Sides of tubes and cylinders."""
METAL, DARK_METAL, THREAD = "#8b95a1", "#4b5561", "#c2541b"
COLORS = ("#2f6fab", "#d17a22", "#3c9a6b", "#b0527a", "#7568bb", "#6b7886", "#2a95a5", "#a8912f")
"""The colours of the page, templates/view/style.css."""


class Solid(NamedTuple):
    """`points` (V, 3), m; `faces` (F, 4) rows of them, a triangle's last twice; `color`; what they are fixed to.

    Fixed to the link's ``frame``, to its ``tip``, or to its ``sections``: then `rows` (V,) tells, in rows of the table
    of sections, where, and the points are offsets from the centreline in the section's axes.
    """

    points: np.ndarray
    faces: np.ndarray
    color: str
    to: str = "frame"
    rows: np.ndarray = np.empty(0)


AHEAD = np.array([1.0, 0.0, 0.0])


class Bend:
    """The centreline of a link of a scene: where its sections are at given modal coordinates."""

    def __init__(self, link: dict[str, Any]):
        rows = len(link["places"])
        self.rest = np.ones(int(link["curved"]))
        count = link["modes"] + len(link["pairs"]) // 2 + len(self.rest)
        self.fine, self.places = link["fine"], np.array(link["places"])
        rows = self.fine * (rows - 1) or rows
        self.columns = np.frombuffer(b64decode(link["columns"]), "<f4").reshape(count, rows, 6).astype(float)
        self.pairs = np.array(link["pairs"], int).reshape(-1, 2)
        self.eta = slice(link["eta"], link["eta"] + link["modes"])
        self.straight = link["base"] + np.outer(link["places"], link["reach"])

    def moved(self, q: np.ndarray, solid: Solid) -> np.ndarray:
        """The points of a solid that is fixed to the sections, in the link's frame, at the coordinates `q` (nq,)."""
        table = self.sections(q)
        first = np.minimum(solid.rows.astype(int), len(table) - 2)
        share = (solid.rows - first)[:, None]
        u, line = ((1 - share) * x[first] + share * x[first + 1] for x in (table, self.straight))
        return line + u[:, :3] + Rotation.from_rotvec(u[:, 3:]).apply(solid.points)

    def sections(self, q: np.ndarray) -> np.ndarray:
        """(S, 6): displacement, m, and rotation vector of the sections, in the link's frame."""
        eta = q[self.eta]
        products = eta[self.pairs[:, 0]] * eta[self.pairs[:, 1]]
        table = np.einsum("k,ksc->sc", np.concatenate([eta, products, self.rest]), self.columns)
        return self._integrated(table) if self.fine else table

    def _integrated(self, strains: np.ndarray) -> np.ndarray:
        """(S, 6): displacement and rotation vector of the sections of an exact rod, of its strains step by step."""
        length = float(np.linalg.norm(self.straight[-1] - self.straight[0]))
        steps = np.repeat(np.diff(self.places) * length / self.fine, self.fine)
        turn, place, out = Rotation.identity(), np.zeros(3), [np.zeros(6)]
        for k, (h, (stretch, bend)) in enumerate(zip(steps, strains.reshape(-1, 2, 3), strict=True), 1):
            middle = turn * Rotation.from_rotvec(h / 2 * bend)
            place = place + h * middle.apply(stretch + AHEAD)
            turn = turn * Rotation.from_rotvec(h * bend)
            if k % self.fine == 0:
                along = self.places[k // self.fine] * length * AHEAD
                out.append(np.append(place - along, _near(turn.as_rotvec(), out[-1][3:])))
        return np.array(out)


def _near(turn: np.ndarray, other: np.ndarray) -> np.ndarray:
    """A rotation vector, or one full turn less, whichever is nearer to another: so turns go on beyond half of one."""
    size = float(np.linalg.norm(turn))
    beyond = turn * (1 - 2 * np.pi / size) if size > 0 else turn
    return min(turn, beyond, key=lambda x: float(np.linalg.norm(x - other)))


def thinnest(links: Sequence[dict[str, Any]], size: float) -> float:
    """The radius of the thinnest tube of a scene's links, m."""
    return max(0.006 * size, min((x["radius"] for x in links if x["radius"]), default=0.0))


def solids(scene: dict[str, Any], i: int) -> Iterator[Solid]:
    """What is drawn of link `i`, as in templates/view/drawing.js."""
    link, size = scene["links"][i], scene["size"]
    thin = thinnest(scene["links"], size)
    if link["radius"] and np.linalg.norm(link["reach"]) > 1e-9:
        yield _tube(link)
    for tendon in link["tendons"]:
        yield _thread(link, tendon, 0.25 * thin)
    if link["screws"] and not link["welded"] and not link["loose"]:
        radius, base = 1.55 * max(link["radius"], thin), np.array(link["base"])
        slide = not link["screws"][0]["turn"]
        turn = turn_along(link["screws"][0 if slide else -1]["axis"])
        shape = _box(np.array([3.0, 2.2, 2.2]) * radius) if slide else _ring(radius, radius, 3.2 * radius)
        yield _hull(base + shape @ turn.T, DARK_METAL)
    if link["parent"] < 0 and not link["loose"]:
        radius, up = 0.035 * size, np.array(scene["gravity"]) * (1.0 if link["hangs"] else -1.0)
        turn = turn_along(up if up.any() else np.array([0.0, 0.0, 1.0]))
        cone = _ring(1.25 * radius, 0.8 * radius, 0.9 * radius) - [
            0.45 * radius + (1.2 * thin if link["screws"] else 0.0),
            0,
            0,
        ]
        yield _hull(np.array(link["mount"]["at"]) + cone @ turn.T, DARK_METAL, "world")
    for body in link["bodies"]:
        at = np.array([0.0] * 3 if body["tip"] else link["base"])
        yield _hull(at + _corners(body, size), METAL, "tip" if body["tip"] else "frame")


def touching(scene: dict[str, Any]) -> list[tuple[int, Solid]]:
    """What touches, with the links to which it is fixed, -1 for the world; what is clear is left to the page."""
    own = [x for x in scene["surfaces"] if not x.get("clear")]
    size = scene["size"]
    return [(x["link"], _hull(_corners(x, size), METAL, "world" if x["link"] < 0 else "tip")) for x in own]


def _corners(body: dict[str, Any], size: float) -> np.ndarray:
    """Of a box or of a ball about its place."""
    at = np.array(body["at"])
    if "box" in body:
        return at + _box(np.maximum(body["box"], 1e-3 * size)) @ Rotation.from_quat(body["turn"]).as_matrix().T
    return at + body["ball"] * _sphere()


def _tube(link: dict[str, Any]) -> Solid:
    count, last = AROUND, len(link["places"]) - 1
    angle = 2 * np.pi * np.arange(count) / count
    ring = link["radius"] * np.column_stack([0 * angle, np.cos(angle), np.sin(angle)]) @ turn_along(link["reach"]).T
    points = np.concatenate([np.tile(ring, (last + 1, 1)), np.zeros((2, 3))])
    rows = np.append(np.repeat(np.arange(last + 1.0), count), [0.0, last])
    a, b = np.arange(count), (np.arange(count) + 1) % count
    sides = [np.column_stack([k + a, k + b, k + count + b, k + count + a]) for k in range(0, last * count, count)]
    near, far = (np.full(count, len(points) - k) for k in (2, 1))
    ends = [np.column_stack([b, a, near, near]), np.column_stack([last * count + a, last * count + b, far, far])]
    return Solid(points, np.concatenate(sides + ends), COLORS[link["owner"] % len(COLORS)], "sections", rows)


def _thread(link: dict[str, Any], tendon: dict[str, Any], radius: float) -> Solid:
    """A tendon: a thin tube beside the centreline."""
    count, offsets = 5, np.array(tendon["offsets"])
    angle = 2 * np.pi * np.arange(count) / count
    ring = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    across = (offsets[:, None] + ring).reshape(-1, 2)
    rows = np.interp(tendon["places"], link["places"], np.arange(len(link["places"])))
    points = np.column_stack([np.zeros(len(across)), across])
    return Solid(points, _sides(count, len(offsets)), THREAD, "sections", np.repeat(rows, count))


def strut(near: np.ndarray, far: np.ndarray, radius: float) -> np.ndarray:
    """The faces (F, 4, 3) of a bar between two points, of which there are always as many."""
    way = far - near
    turn = turn_along(way if way.any() else AHEAD)
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    ring = radius * np.column_stack([0 * angle, np.cos(angle), np.sin(angle)]) @ turn.T
    points = np.concatenate([near + ring, far + ring])
    return points[_sides(AROUND, 2)]


def _sides(around: int, rings: int) -> np.ndarray:
    """The faces between rings of points."""
    a, b = np.arange(around), (np.arange(around) + 1) % around
    starts = range(0, (rings - 1) * around, around)
    return np.concatenate([np.column_stack([k + a, k + b, k + around + b, k + around + a]) for k in starts])


def turn_along(way: Any) -> np.ndarray:
    """A rotation (3, 3) whose x axis is along `way`."""
    x = np.asarray(way, float) / np.linalg.norm(way)
    y = np.cross(np.eye(3)[2 if abs(x[2]) < 0.9 else 0], x)
    y /= np.linalg.norm(y)
    return np.column_stack([x, y, np.cross(x, y)])


def _ring(near: float, far: float, length: float) -> np.ndarray:
    """The points of a cylinder, or of a cone without its top, along x about the origin."""
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    disc = np.column_stack([0 * angle, np.cos(angle), np.sin(angle)])
    shift = [length / 2, 0.0, 0.0]
    return np.concatenate([near * disc - shift, far * disc + shift])


def _box(edges: np.ndarray) -> np.ndarray:
    return np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]) * edges


def _sphere() -> np.ndarray:
    """Points spread over the unit sphere."""
    k = np.arange(180) + 0.5
    z, angle = 1 - 2 * k / 180, k * np.pi * (1 + 5**0.5)
    return np.column_stack([np.sqrt(1 - z**2) * np.cos(angle), np.sqrt(1 - z**2) * np.sin(angle), z])


def _hull(points: np.ndarray, color: str, to: str = "frame") -> Solid:
    """The convex solid with these corners, its faces seen from outside counter-clockwise."""
    triangles = ConvexHull(points).simplices
    corners = points[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("fi,fi->f", normal, corners.mean(axis=1) - points.mean(axis=0)) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return Solid(points, np.column_stack([triangles, triangles[:, 2]]), color, to)
