"""A line drawing: strokes, dots and labels, in px with y upwards, whatever writes them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

Point = tuple[float, float]

WIDTHS = {
    "rigid": 5.0,
    "rod": 3.0,
    "offset": 1.6,
    "joint": 1.3,
    "ground": 1.2,
    "axis": 1.2,
    "frame": 0.9,
    "straight": 0.9,
    "mode": 1.5,
    "pull": 1.2,
    "drive": 1.3,
    "loop": 1.5,
    "force": 1.5,
    "leader": 0.6,
}
"""The looks of strokes, each with the width of its lines in px."""
DASHES = {"straight": (5.0, 4.0), "loop": (5.0, 3.0)}
"""The looks of dashed strokes: the lengths of a dash and of the gap behind it, px."""
TIE = 1e-7
"""Added before rounding, so that a coordinate halfway between two decimals is rounded alike on every machine."""


@dataclass(frozen=True)
class Stroke:
    """A line through points."""

    look: str
    points: tuple[Point, ...]


@dataclass(frozen=True)
class Dot:
    """A filled circle."""

    look: str
    at: Point
    radius: float


@dataclass(frozen=True)
class DrawnLabel:
    """A text, in the markup of documents, around its centre."""

    look: str
    text: str
    at: Point
    size: Point
    """Width and height of the box that it fills."""
    names: tuple[str, ...] = ()
    """The full names of what it stands for."""

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Its left, lower, right and upper edge."""
        (x, y), (width, height) = self.at, self.size
        return x - width / 2, y - height / 2, x + width / 2, y + height / 2


@dataclass(frozen=True)
class Drawing:
    """Strokes, dots and labels inside of a box from the origin to ``size``."""

    size: Point
    strokes: tuple[Stroke, ...]
    dots: tuple[Dot, ...]
    labels: tuple[DrawnLabel, ...]

    def respelled(self, text: Callable[[str], str]) -> Drawing:
        """The drawing with other texts of its labels."""
        return replace(self, labels=tuple(replace(label, text=text(label.text)) for label in self.labels))


def rounded(x: float) -> float:
    """A coordinate as it is written, with one decimal."""
    return round(float(x) + TIE, 1) + 0.0


def framed(strokes: Sequence[Stroke], dots: Sequence[Dot], labels: Sequence[DrawnLabel], margin: float) -> Drawing:
    """A drawing of these, moved into the smallest box with a margin, with rounded coordinates."""
    corners = [p for stroke in strokes for p in stroke.points]
    corners += [(x + s * dot.radius, y + s * dot.radius) for dot in dots for x, y in [dot.at] for s in (-1, 1)]
    corners += [corner for label in labels for corner in (label.box[:2], label.box[2:])]
    low = np.floor(np.min(corners, axis=0) - margin)
    width, height = np.ceil(np.max(corners, axis=0) + margin - low)

    def moved(point: Point) -> Point:
        return rounded(point[0] - low[0]), rounded(point[1] - low[1])

    return Drawing(
        (float(width), float(height)),
        tuple(replace(stroke, points=tuple(map(moved, stroke.points))) for stroke in strokes),
        tuple(replace(dot, at=moved(dot.at)) for dot in dots),
        tuple(replace(label, at=moved(label.at)) for label in labels),
    )


# ----------------------------------------------------------------------------------- parts of lines


def resampled(points: np.ndarray, step: float) -> np.ndarray:
    """(n, 2): points along a line, no further apart than ``step``, its corners among them."""
    out = [points[:1]]
    for a, b in pairwise(points):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        out.append(a + np.outer(np.arange(1, count + 1) / count, b - a))
    return np.concatenate(out)


def simplified(points: np.ndarray, error: float) -> np.ndarray:
    """The line through the fewest of its points that is nowhere further off than ``error`` (Douglas and Peucker)."""
    if len(points) < 3:
        return points
    a, b = points[0], points[-1]
    size = float(np.linalg.norm(b - a))
    off = np.linalg.norm(points - a, axis=1) if size < error else np.abs(cross(b - a, points - a)) / size
    k = int(np.argmax(off))
    if off[k] <= error:
        return np.array([a, b])
    return np.concatenate([simplified(points[: k + 1], error)[:-1], simplified(points[k:], error)])


def outside(points: np.ndarray, holes: Sequence[np.ndarray], step: float = 0.5) -> Iterator[np.ndarray]:
    """The pieces of a line that lie outside of convex polygons, whose corners run counterclockwise."""
    dense = resampled(points, step)
    seen = np.ones(len(dense), bool)
    for hole in holes:
        seen &= ~contains(hole, dense)
    breaks = np.flatnonzero(np.diff(seen.astype(int))) + 1
    for run, shown in zip(np.split(dense, breaks), np.split(seen, breaks), strict=True):
        if shown[0] and len(run) > 1:
            yield simplified(run, 0.04)


def contains(polygon: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(n,): whether points are inside of a convex polygon, whose corners run counterclockwise."""
    edges = np.roll(polygon, -1, axis=0) - polygon
    return np.all([cross(edge, points - corner) > 0 for corner, edge in zip(polygon, edges, strict=True)], axis=0)


def hull(points: np.ndarray) -> np.ndarray:
    """The corners of the convex hull of points, counterclockwise (Andrew's monotone chain)."""
    ordered = sorted({(round(float(x), 6), round(float(y), 6)) for x, y in points})
    below, above = _half(ordered), _half(ordered[::-1])
    return np.array([*below[:-1], *above[:-1]])


def _half(ordered: Sequence[Point]) -> list[Point]:
    out: list[Point] = []
    for p in ordered:
        while len(out) > 1 and cross(np.subtract(out[-1], out[-2]), np.subtract(p, out[-2])) <= 0:
            out.pop()
        out.append(p)
    return out


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The component across the plane of the product of vectors in it."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def dashes(points: Sequence[Point], on: float, off: float) -> Iterator[tuple[Point, ...]]:
    """The dashes of a line."""
    dense = resampled(np.array(points, float), 0.5)
    along = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(dense, axis=0), axis=1)))
    for start in np.arange(0.0, along[-1], on + off):
        dash = simplified(dense[(along >= start) & (along <= start + on)], 0.04)
        if len(dash) > 1:
            yield tuple((rounded(x), rounded(y)) for x, y in dash)
