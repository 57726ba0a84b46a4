"""The pen of a sketch: what is in space becomes strokes on paper, those behind the solids of joints cut off there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .drawing import Dot, Drawing, Point, Stroke, framed, hull, outside
from .label_places import Wish, placed
from .sketch_pose import SketchView

HEAD, OPEN = 6.5, 0.42
"""Arrow heads: their length, px, and half the angle between their sides, rad."""
SHORT = 4.0
"""px: arrows that are seen no longer than this have no head."""
ROUND = 28
"""Corners of a circle in space."""
DIGITS = 6
"""The decimals of a place on paper, px: rounding errors must not decide which points a line keeps."""
UNCUT = ("joint", "ground")
"""The looks of strokes that nothing hides."""
MARGIN = 8.0


class Line(NamedTuple):
    """A line on paper, perhaps an arrow."""

    look: str
    points: np.ndarray
    head: bool


class Pen:
    """Draws in space by a view at ``scale`` px per m; lengths that are called sizes are in px.

    ``letters``: those of labels that are not a document's own, by these.
    """

    def __init__(self, view: SketchView, scale: float, letters: Mapping[str, str] | None = None):
        self.view, self.scale, self.letters = view, scale, letters or {}
        self.lines: list[Line] = []
        self.dots: list[Dot] = []
        self.wishes: list[Wish] = []
        self.holes: list[np.ndarray] = []
        self.shortened = False  # whether a line with a gap is drawn shorter than it is

    def flat(self, points: np.ndarray) -> np.ndarray:
        """(..., 2) px: points on paper, without the last digits, which differ from machine to machine."""
        return np.round(self.scale * self.view.flat(np.asarray(points)), DIGITS)

    def point(self, place: np.ndarray) -> Point:
        """One of them."""
        x, y = self.flat(place)
        return float(x), float(y)

    def far(self, a: np.ndarray, b: np.ndarray) -> float:
        """The distance of two points on paper, px."""
        return float(np.linalg.norm(self.flat(a) - self.flat(b)))

    def along(self, place: np.ndarray, way: np.ndarray, size: float) -> np.ndarray:
        """The point in space that is ``size`` px from another one in a direction."""
        return np.asarray(place + size / self.scale * way / np.linalg.norm(way))

    # lines ----------------------------------------------------------------------------------------

    def line(self, look: str, *points: np.ndarray, head: bool = False) -> None:
        """A line through points in space."""
        self.drawn(look, self.flat(np.array(points)), head)

    def drawn(self, look: str, points: ArrayLike, head: bool = False) -> None:
        """A line through points on paper."""
        self.lines.append(Line(look, np.round(np.array(points, float), DIGITS), head))

    def circle(
        self, place: np.ndarray, axis: np.ndarray, size: float, turn: float = 2 * np.pi, start: float = 0.0
    ) -> np.ndarray:
        """(n, 3): a circle or an arc about an axis, in the sense of a turn, from where it is seen rightmost."""
        first, second = across(axis, self.view.right)
        angles = start + np.linspace(0.0, turn, ROUND + 1)[:, None]
        return np.asarray(place + size / self.scale * (np.cos(angles) * first + np.sin(angles) * second))

    def ring(self, look: str, place: np.ndarray, size: float) -> None:
        """A circle on paper."""
        self.line(look, *self.circle(place, self.view.towards, size))

    def dot(self, look: str, place: np.ndarray, size: float) -> None:
        """A filled circle on paper."""
        self.dots.append(Dot(look, self.point(place), size))

    # solids ---------------------------------------------------------------------------------------

    def cylinder(self, place: np.ndarray, axis: np.ndarray, radius: float, half: float) -> None:
        """A cylinder: its outline, and the edge of the end that one sees."""
        ends = [self.circle(self.along(place, axis, s * half), axis, radius) for s in (-1, 1)]
        self.solid(np.concatenate(ends), [ends[1] if axis @ self.view.towards > 0 else ends[0]])

    def box(self, place: np.ndarray, axis: np.ndarray, half: float, side: float) -> None:
        """A box along an axis: its outline, and the faces that one sees."""
        axes = (axis / np.linalg.norm(axis), *across(axis, self.view.up))
        sizes = np.array([half, side, side]) / self.scale
        faces = []
        for k, way in enumerate(axes):
            outwards = way if way @ self.view.towards > 0 else -way
            first, second = (sizes[j] * axes[j] for j in range(3) if j != k)
            middle = place + sizes[k] * outwards
            faces.append([middle + a * first + b * second for a, b in ((1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1))])
        self.solid(np.array(faces).reshape(-1, 3), [np.array(face) for face in faces])

    def ball(self, place: np.ndarray, size: float) -> None:
        """A ball."""
        self.solid(self.circle(place, self.view.towards, size), [])

    def solid(self, corners: np.ndarray, edges: Sequence[np.ndarray]) -> None:
        """A solid that hides what is behind: the outline of its corners, and edges that one sees."""
        outline = hull(self.flat(corners))
        self.holes.append(outline)
        self.drawn("joint", [*outline, outline[0]])
        for edge in edges:
            self.line("joint", *edge)

    # the whole ------------------------------------------------------------------------------------

    def wish(self, look: str, text: str, place: np.ndarray, **more: object) -> None:
        """A label at a point in space, or on paper."""
        text = respelled(text, self.letters)
        anchor = self.point(place) if len(place) == 3 else (float(place[0]), float(place[1]))
        self.wishes.append(Wish(look, text, anchor, **more))  # type: ignore[arg-type]

    def corners(self) -> np.ndarray:
        """(n, 2): all points of lines."""
        return np.concatenate([line.points for line in self.lines])

    def strokes(self) -> list[Stroke]:
        """All lines with what hides them cut off, and with the heads of arrows."""
        return [stroke for line in self.lines for stroke in self._seen(line)]

    def drawing(self) -> Drawing:
        """All of it, with the labels where there is room for them."""
        strokes = self.strokes()
        labels, leaders = placed(self.wishes, strokes, self.dots)
        return framed([*strokes, *leaders], self.dots, labels, MARGIN)

    def _seen(self, line: Line) -> Iterator[Stroke]:
        pieces = list(outside(line.points, () if line.look in UNCUT else self.holes))
        if line.head and not any(_span(piece) > SHORT for piece in pieces):
            pieces = [line.points]  # a hidden arrow says nothing
        for piece in pieces:
            yield _stroke(line.look, piece)
        if line.head and _span(pieces[-1]) > SHORT:
            yield _stroke(line.look, head(pieces[-1]))


def respelled(text: str, letters: Mapping[str, str]) -> str:
    """Text with other letters in its formulas."""
    known = sorted(letters, key=len, reverse=True)
    return re.sub("|".join(map(re.escape, known)), lambda m: letters[m[0]], text) if known else text


def _span(points: np.ndarray) -> float:
    """The distance of the ends of a line."""
    return float(np.linalg.norm(points[-1] - points[0]))


def _stroke(look: str, points: np.ndarray) -> Stroke:
    return Stroke(look, tuple((float(x), float(y)) for x, y in points))


def head(points: np.ndarray) -> np.ndarray:
    """(3, 2): the open head of an arrow at the end of a line."""
    behind = [p for p in points[:-1] if np.linalg.norm(points[-1] - p) > HEAD / 2]
    way = points[-1] - (behind[-1] if behind else points[0])
    angle, size = np.arctan2(way[1], way[0]), min(HEAD, 0.8 * float(np.linalg.norm(points[-1] - points[0])))
    sides = [points[-1] - size * np.array([np.cos(angle + s * OPEN), np.sin(angle + s * OPEN)]) for s in (-1, 1)]
    return np.array([sides[0], points[-1], sides[1]])


def across(axis: np.ndarray, near: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors across an axis, right-handed with it; the first as near to a direction as it can be."""
    axis = axis / np.linalg.norm(axis)
    for way in (near, *np.eye(3)):
        flat = way - (way @ axis) * axis
        if np.linalg.norm(flat) > 1e-3:
            first = flat / np.linalg.norm(flat)
            return first, np.cross(axis, first)
    raise AssertionError("one of three axes is not along another")
