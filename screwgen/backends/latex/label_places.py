"""Where the labels of a drawing go: each to the freest place near what it says, in the order of their importance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from .drawing import Dot, Label, Point, Stroke, resampled
from .label_text import measured

DISTANCES = (9.0, 13.0, 18.0, 25.0, 34.0, 46.0, 62.0, 84.0, 112.0, 150.0, 200.0)
"""How far the edge of a label may be from its anchor, px: the first distance with a free place is taken."""
DIRECTIONS = 24
FAR = 15.0
"""px: from here on a thin line leads from the anchor to its label."""
STEP = 2.5
"""px from one point to the next at which lines are felt."""
ROOM = 2.0
"""px around a label that stay free."""
ACROSS = 6.0
"""The cost of a point of a line below a label, in px of distance."""
ASIDE = 7.0
"""The cost of a place opposite to the wanted one, in px of distance."""


@dataclass(frozen=True)
class Wish:
    """A label that is to be placed."""

    look: str
    text: str
    anchor: Point
    towards: Point = (0.0, 1.0)
    """The direction from the anchor that suits it best."""
    names: tuple[str, ...] = ()
    needed: bool = True
    """Whether it is placed even where it must cross lines."""
    reach: float = DISTANCES[-1]
    """The largest distance from its anchor, px."""


def placed(wishes: Sequence[Wish], strokes: Sequence[Stroke], dots: Sequence[Dot]) -> tuple[list[Label], list[Stroke]]:
    """The labels, none of which overlap, and the lines that lead to those that are far from their anchors."""
    taken, boxes = [_felt(strokes, dots)], np.empty((0, 4))
    labels: list[Label] = []
    leaders: list[Stroke] = []
    for wish in wishes:
        label = _best(wish, np.concatenate(taken), boxes)
        if label is None:
            continue
        labels.append(label)
        boxes = np.vstack([boxes, label.box])
        line = _leader(wish.anchor, label)
        if line is not None:
            leaders.append(line)
            taken.append(resampled(np.array(line.points), STEP))
    return labels, leaders


def _felt(strokes: Sequence[Stroke], dots: Sequence[Dot]) -> np.ndarray:
    """(n, 2): points all over what is drawn."""
    ring = np.linspace(0.0, 2 * np.pi, 9)[:-1]
    rings = [np.array(dot.at) + dot.radius * np.column_stack([np.cos(ring), np.sin(ring)]) for dot in dots]
    return np.concatenate([np.empty((0, 2)), *(resampled(np.array(s.points), STEP) for s in strokes), *rings])


def _best(wish: Wish, taken: np.ndarray, boxes: np.ndarray) -> Label | None:
    """The label at its freest place; None where it is not needed and there is none that is free."""
    found: list[tuple[float, Label]] = []
    for distance, label in _candidates(wish):
        x0, y0, x1, y1 = np.array(label.box) + np.array([-ROOM, -ROOM, ROOM, ROOM])
        if np.any((boxes[:, 0] < x1) & (boxes[:, 2] > x0) & (boxes[:, 1] < y1) & (boxes[:, 3] > y0)):
            continue
        x, y = taken.T
        if _crosses(_leader(wish.anchor, label), boxes):
            continue
        crossed = int(np.sum((x > x0) & (x < x1) & (y > y0) & (y < y1)))
        if not crossed:
            found.append((distance, label))
            break
        if wish.needed:
            found.append((distance + ACROSS * crossed, label))
    return min(found, key=lambda one: one[0])[1] if found else None


def _candidates(wish: Wish) -> list[tuple[float, Label]]:
    """Labels around the anchor with their cost, the cheapest first."""
    size, out = measured(wish.text, wish.look), []
    wanted = np.arctan2(wish.towards[1], wish.towards[0])
    for distance in (x for x in DISTANCES if x <= wish.reach):
        for k in range(DIRECTIONS):
            angle = wanted + 2 * np.pi * k / DIRECTIONS
            cost = round(distance + ASIDE * (1 - np.cos(angle - wanted)) / 2, 6)
            out.append((cost, Label(wish.look, wish.text, _at(wish.anchor, angle, distance, size), size, wish.names)))
    return sorted(out, key=lambda one: one[0])


def _at(anchor: Point, angle: float, distance: float, size: Point) -> Point:
    """The centre of a box whose edge is at a distance from the anchor, in a direction."""
    way = np.array([np.cos(angle), np.sin(angle)])
    half = np.array(size) / 2
    within = float(np.min(half / np.maximum(np.abs(way), 1e-9)))
    x, y = np.array(anchor) + (distance - 5.0 + within) * way
    return float(x), float(y)


def _leader(anchor: Point, label: Label) -> Stroke | None:
    """From an anchor to the edge of its label, where that is far."""
    x0, y0, x1, y1 = label.box
    end = np.clip(anchor, (x0, y0), (x1, y1))
    way = end - anchor
    size = float(np.linalg.norm(way))
    if size < FAR:
        return None
    first, last = (np.array(anchor) + share * way for share in (4.0 / size, 1.0 - 2.0 / size))
    return Stroke("leader", ((float(first[0]), float(first[1])), (float(last[0]), float(last[1]))))


def _crosses(line: Stroke | None, boxes: np.ndarray) -> bool:
    """Whether a line runs through any of these boxes."""
    if line is None or not len(boxes):
        return False
    x, y = resampled(np.array(line.points), STEP).T[:, :, None]
    return bool(np.any((boxes[:, 0] < x) & (x < boxes[:, 2]) & (boxes[:, 1] < y) & (y < boxes[:, 3])))


def overlaps(labels: Sequence[Label]) -> Iterator[tuple[Label, Label]]:
    """The pairs of labels that overlap."""
    for i, first in enumerate(labels):
        for second in labels[i + 1 :]:
            (a0, b0, a1, b1), (c0, d0, c1, d1) = first.box, second.box
            if a0 < c1 and c0 < a1 and b0 < d1 and d0 < b1:
                yield first, second
