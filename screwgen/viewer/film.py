"""Pictures of runs at given times: the arm as it bends, its ghost, the path of its tip, from where the page looks.

Poses are the model's own; sections bend by the table that the page's shader has. Faces are drawn from the farthest to
the nearest.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from ..model import Model
from ..plotting.canvas import Canvas, Polygons, rgb
from ..simulation.runs import Run
from ..spec.load import one_line
from . import lines
from .actuators import eyes
from .meshes import Looks, placed
from .scene import scene
from .solids import AROUND, DARK_METAL, METAL, Bend, Solid, solids, strut, thinnest, touching

PAPER, INK, SOFT, GRID, SHADOW = "#f5f6f8", "#1d2733", "#5d6b7a", "#c3cad3", "#dfe3e8"
LIGHT = np.array([0.35, 0.25, 1.0])
"""Where light comes from, in the axes of the picture, z up."""
LIT = (0.7, 1.25)
"""By how much colours are multiplied in the shade, and where light falls straight."""
OPENING = np.radians(32.0)
"""The camera's angle of view, top to bottom."""
BARREL = 0.55
"""How long the barrel of a cylinder is, over the distance of its eyes at zero coordinates."""
FAINT = 0.3
"""How much of its colour a ghost has, over that of the paper."""
PATH, SURVEYED = 400, 16
"""Places of the tip along its path, and postures whose surfaces must be in the picture."""
MARGINS = (50, 34, 20)
"""Pixels that the title, the notes and the sides take."""


class Camera(NamedTuple):
    """`turn` (3, 3): inertial axes to those of the picture; `eye` there; `axes`: right, up and towards the eye."""

    turn: np.ndarray
    eye: np.ndarray
    axes: np.ndarray
    size: tuple[int, int]

    def flat(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Pixels (…, 2) from the top left corner, and depths (…), m, of points (…, 3) in the axes of the picture."""
        seen = (points - self.eye) @ self.axes.T
        depth = np.maximum(-seen[..., 2], 1e-9)
        focus = self.size[1] / 2 / np.tan(OPENING / 2)
        middle = np.array(self.size) / 2
        return middle + focus * seen[..., :2] * [1, -1] / depth[..., None], depth

    def project(self, points: np.ndarray) -> np.ndarray:
        """Pixels (…, 2) from the top left corner of points (…, 3) in the inertial frame, m."""
        return self.flat(points @ self.turn.T)[0]


class Actor:
    """A run that is drawn, with its modes magnified; `looks`: the visuals that it wears."""

    def __init__(self, run: Run, model: Model, label: str, magnified: float, looks: Looks | None = None):
        self.run, self.model, self.magnified = run, model, magnified
        self.scene, self.numeric = scene(model, run.parameters, run.q[0]), model.numpy(run.parameters)
        links = self.scene["links"]
        self.bends = [Bend(link) for link in links]
        worn = placed(looks, model, self.scene, label, run.parameters) if looks else []
        over = {links[i]["owner"] for i, _ in worn if i >= 0}
        self.solids: list[tuple[int, Solid]] = [
            (i, x)
            for i, link in enumerate(links)
            for x in solids(self.scene, i)
            if not (any(k < 0 for k, _ in worn) if x.to == "world" else link["owner"] in over)
        ] + [*worn, *touching(self.scene)]
        thick = 1.3 * thinnest(links, self.scene["size"])
        self.cylinders = [(i, x, thick) for i, link in enumerate(links) for x in link["cylinders"]]
        bars = [color for _ in self.cylinders for color in (DARK_METAL, METAL) for _ in range(AROUND)]
        colors = [color for _, x in self.solids for color in [x.color] * len(x.faces)] + bars
        down = np.array(self.scene["gravity"])
        self.down = _unit(down) if down.any() else np.array([0.0, 0.0, -1.0])
        tips = self.numeric.tip_poses(run.q[0])[1]
        colors += [color for _, own in self._lines(run.q[0], tips) for color in own]
        self.colors = np.array([rgb(color) for color in colors])
        self.leaf = max(i for i, x in enumerate(links) if x["radius"] or x["bodies"] or i == 0)

    def at(self, times: np.ndarray) -> np.ndarray:
        """The coordinates (N, nq) at some times, on straight lines between samples."""
        q = np.column_stack([np.interp(times, self.run.t, x) for x in self.run.q.T])
        q = np.array([self.model.chain.unit(x) for x in q]).reshape(q.shape)
        q[:, self.model.chain.eta_q :] *= self.magnified
        return q

    def ends(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The origins (n, 3) of all links and their tips (n, 3), inertial frame, m."""
        return self.numeric.link_pose(q)[1], self.numeric.tip_poses(q)[1]

    def faces(self, q: np.ndarray) -> np.ndarray:
        """All faces (F, 4, 3) at the coordinates `q` (nq,), inertial frame, m."""
        (R, r), (R_tip, r_tip) = self.numeric.link_pose(q), self.numeric.tip_poses(q)
        out = []
        for i, solid in self.solids:
            points = self.bends[i].moved(q, solid) if solid.to == "sections" else solid.points
            if solid.to != "world":
                turn, place = (R_tip[i], r_tip[i]) if solid.to == "tip" else (R[i], r[i])
                points = place + points @ turn.T
            out.append(points[solid.faces])
        for i, found, thick in self.cylinders:
            near, far = eyes(self.scene["links"][i], found, R[i], r[i], q)
            half = near + BARREL * np.linalg.norm(np.subtract(found["link"], found["carrier"])) * _unit(far - near)
            out += [strut(near, half, thick), strut(near, far, 0.55 * thick)]
        out += [x for x, _ in self._lines(q, r_tip)]
        return np.concatenate(out)

    def _lines(self, q: np.ndarray, tips: np.ndarray) -> list[tuple[np.ndarray, list[str]]]:
        """The faces of the lines of forces, and their colours; `tips`: as drawn, at the coordinates `q`."""
        real, out = q.copy(), []
        real[self.model.chain.eta_q :] /= self.magnified or 1.0
        there = self.numeric.tip_poses(real)[1] if self.scene["lines"] and self.magnified != 1 else tips
        for line in self.scene["lines"]:
            spare = line["rest"] - float(np.linalg.norm(np.subtract(*lines.ends(line, there))))
            out.append(lines.faces(line, *lines.ends(line, tips), self.down, spare))
        return out


class Film:
    """Pictures of a run, and of a second one as its ghost, of `size` pixels."""

    def __init__(
        self,
        runs: Sequence[tuple[Run, Model, str]],
        size: tuple[int, int],
        magnified: float = 1.0,
        looks: Looks | None = None,
    ):
        self.actors = [Actor(*each, magnified, looks) for each in runs]
        self.start, self.end = min(run.t[0] for run, *_ in runs), max(run.t[-1] for run, *_ in runs)
        self.times = np.linspace(self.start, self.end, PATH)
        ends = [[actor.ends(q) for q in actor.at(self.times)] for actor in self.actors]
        self.paths = [np.array([tip[a.leaf] for _, tip in x]) for a, x in zip(self.actors, ends, strict=True)]
        first, self.size = self.actors[0].scene, size
        down = np.array(first["gravity"])
        turn = _down(down / np.linalg.norm(down)) if down.any() else np.eye(3)
        clouds = [np.reshape(x, (-1, 3)) @ turn.T for x in ends]
        for a in self.actors:
            clouds += [a.faces(q).reshape(-1, 3) @ turn.T for q in a.at(self.times[:: PATH // SURVEYED])]
        self.cloud = np.concatenate(clouds)
        self.camera = _camera(turn, self.cloud, first["size"], size)
        self._prepare(runs, magnified)

    def _prepare(self, runs: Sequence[tuple[Run, Model, str]], magnified: float) -> None:
        """The picture, with what does not move."""
        self.canvas = Canvas(self.size, PAPER)
        cell = self._floor()
        self.shadow = self.canvas.polygons(1, SHADOW)
        style = dict(color=INK, linewidth=1.4)
        flat = [self.camera.project(path) for path in self.paths]
        for path in flat:
            self.canvas.line(path, alpha=0.4, **style)
        self.trails = [self.canvas.line(path, alpha=0.45 if k else 0.95, **style) for k, path in enumerate(flat)]
        self.bodies = [self.canvas.polygons(4 - k) for k in range(len(self.actors))]
        labels = " · ghost: ".join(one_line(label) for *_, label in runs)
        notes = [f"a cell of the floor is {cell:g} m"] + [f"bending × {magnified:g}"] * (magnified != 1)
        self.canvas.write(14, 12, one_line(runs[0][1].robot.name), INK, size=12, weight="bold")
        self.canvas.write(14, 33, labels, SOFT)
        self.canvas.write(14, -10, " · ".join(notes), SOFT)
        self.clock = self.canvas.write(-14, 12, "", INK, size=12)

    def _floor(self) -> float:
        """Lines on the floor, which fade away; the distance between them, m."""
        low, high = self.cloud.min(axis=0), self.cloud.max(axis=0)
        size = self.actors[0].scene["size"]
        extent = max(float(np.linalg.norm(high - low)), size)
        thin = min((x["radius"] for x in self.actors[0].scene["links"] if x["radius"]), default=0.0)
        self.ground = low[2] - 0.035 * size - 1.5 * max(0.006 * size, thin)
        power = 10.0 ** np.floor(np.log10(extent / 5))
        cell = float(power * next(k for k in (5, 2, 1) if k * power <= extent / 5 * 1.0001))
        count = int(np.ceil(1.15 * extent / cell))
        i, j = (x.ravel() for x in np.meshgrid(np.arange(-count, count + 1), np.arange(-count, count)))
        near = np.hypot(i, j + 0.5) <= count
        i, j = i[near], j[near]
        steps = np.concatenate([[[i, j], [i, j + 1]], [[j, i], [j + 1, i]]], axis=2).transpose(2, 0, 1)
        middle = np.rint((low + high)[:2] / 2 / cell) * cell
        places = np.dstack([steps * cell + middle, np.full(steps.shape[:2], self.ground)])
        share = np.clip(1 - (np.linalg.norm(steps.mean(axis=1), axis=1) / count) ** 1.6, 0.0, 1.0)[:, None]
        colors = share * rgb(GRID) + (1 - share) * rgb(PAPER)
        self.canvas.lines(self.camera.flat(places)[0], colors, 0.9)
        return cell

    def picture(self, time: float) -> np.ndarray:
        """The picture (height, width, 3) at a time, s, as bytes."""
        for k, (actor, polygons) in enumerate(zip(self.actors, self.bodies, strict=True)):
            faces = actor.faces(actor.at(np.array([time]))[0]) @ self.camera.turn.T
            self._draw(polygons, faces, actor.colors, FAINT if k else 1.0)
            if k == 0:
                self._cast(faces)
        for done, path in zip(self.trails, self.paths, strict=True):
            gone = np.append(path[self.times < time], [_between(self.times, path, time)], axis=0)
            done.set_data(*self.camera.project(gone).T)
        self.clock.set_text(f"{time:.3f} s")
        return self.canvas.picture()

    def shades(self) -> np.ndarray:
        """The colours of the run's solids in some lights, (N, 3) bytes."""
        colors = np.unique(self.actors[0].colors, axis=0)
        return np.rint(255 * np.clip(np.concatenate([x * colors for x in np.linspace(*LIT, 8)]), 0, 1)).astype(np.uint8)

    def _draw(self, polygons: Polygons, faces: np.ndarray, colors: np.ndarray, share: float) -> None:
        normal = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
        middle = faces.mean(axis=1)
        seen = np.einsum("fi,fi->f", normal, self.camera.eye - middle) > 0
        normal, middle = normal[seen], middle[seen]
        flat, depth = self.camera.flat(faces[seen])
        order = np.argsort(-depth.mean(axis=1))
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
        lit = LIT[0] + (LIT[1] - LIT[0]) * np.maximum(normal @ (LIGHT / np.linalg.norm(LIGHT)), 0.0)
        shade = np.clip(colors[seen] * lit[:, None], 0.0, 1.0)
        shade = (share * shade + (1 - share) * rgb(PAPER))[order]
        polygons.move(flat[order], shade)

    def _cast(self, faces: np.ndarray) -> None:
        """The shadow on the floor."""
        if not any(self.actors[0].scene["gravity"]):
            return
        normal = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
        lit = faces[normal @ LIGHT > 0]
        fallen = lit - (lit[..., 2:] - self.ground) / LIGHT[2] * LIGHT
        self.shadow.move(self.camera.flat(fallen)[0])


def _unit(way: np.ndarray) -> np.ndarray:
    return np.asarray(way / max(float(np.linalg.norm(way)), 1e-12))


def _between(times: np.ndarray, values: np.ndarray, time: float) -> list[float]:
    return [float(np.interp(time, times, x)) for x in values.T]


def _down(way: np.ndarray) -> np.ndarray:
    """The least rotation (3, 3) of a unit vector to −z."""
    axis = np.cross(way, [0.0, 0.0, -1.0])
    size = float(np.linalg.norm(axis))
    if size < 1e-12:
        return np.diag([1.0, 1.0, 1.0]) if way[2] < 0 else np.diag([1.0, -1.0, -1.0])
    return Rotation.from_rotvec(axis / size * np.arctan2(size, -way[2])).as_matrix()


def _camera(turn: np.ndarray, points: np.ndarray, reach: float, size: tuple[int, int]) -> Camera:
    """The camera that sees all points (N, 3), in the picture's axes; as `look` of templates/view/player.js."""
    low, high = points.min(axis=0), points.max(axis=0)
    spread, aspect, half = high - low, size[0] / size[1], float(np.tan(OPENING / 2))
    wide = spread[0] > 2.2 * spread[1]
    way = np.array([1.0, -0.42, 0.42] if spread[1] > 2.2 * spread[0] else [0.42 if wide else 0.75, -1.0, 0.45])
    way /= np.linalg.norm(way)
    right = np.cross([0.0, 0.0, 1.0], way)
    right /= np.linalg.norm(right)
    axes = np.array([right, np.cross(way, right), way])
    x, y, depth = ((points - (low + high) / 2) @ axes.T).T
    above, below, aside = (half * max(1 - 2 * pixels / size[1], 0.5) for pixels in MARGINS)
    across = aside + half * (aspect - 1)
    ways = _fitted(x, depth, across, across), _fitted(y, depth, below, above)
    far = max(ways[0][0], ways[1][0], 0.45 * reach / (half * min(aspect, 1.0)))
    middle = (low + high) / 2 + sum((a + b * far) * axis for (_, a, b), axis in zip(ways, axes, strict=False))
    return Camera(turn, middle + way * far, axes, size)


def _fitted(places: np.ndarray, depths: np.ndarray, below: float, above: float) -> tuple[float, float, float]:
    """From how far all `places` on an axis of the picture are between −below and above, tangents from its middle, and
    where that then is: the distance, a and b of a + b times the distance.
    """
    top, bottom = float((places + above * depths).max()), float((below * depths - places).max())
    return (top + bottom) / (above + below), (top - bottom) / 2, (below - above) / 2
