"""Where the labels of a drawing go: each to the freest place near what it says, in the order of their importance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from .drawing import Dot, DrawnLabel, Point, Stroke, resampled
from .label_text import measured

DISTANCES = (9.0, 13.0, 18.0, 25.0, 34.0, 46.0, 62.0, 84.0, 112.0, 150.0, 200.0)
"""How far the edge of a label may be from its anchor, px: the first distance with a free place is taken."""
EDGE = 5.0
"""px: what of such a distance counts as the room around the anchor itself."""
DIRECTIONS = 24
FAR = 15.0
"""px: from here on a thin line leads from the anchor to its label."""
STEP = 2.5
"""px from one point to the next at which lines are felt."""
ROOM = 2.0
"""px around a label that stay free."""
ACROSS = 6.0
"""The cost of a point of a line below a label, in px of distance."""
BLINDED = 90.0
"""The cost of a line to a label that runs through another one, in px of distance."""
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


def placed(
    wishes: Sequence[Wish], strokes: Sequence[Stroke], dots: Sequence[Dot]
) -> tuple[list[DrawnLabel], list[Stroke]]:
    """The labels, none of which overlap, and the lines that lead to those that are far from their anchors."""
    taken, boxes = [_felt(strokes, dots)], np.empty((0, 4))
    labels: list[DrawnLabel] = []
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


def _best(wish: Wish, taken: np.ndarray, boxes: np.ndarray) -> DrawnLabel | None:
    """The label at its freest place; None where it is not needed and there is none that is free."""
    size = measured(wish.text, wish.look)
    centres, costs = _candidates(wish, size)
    low, high = (centres + side * (np.array(size) / 2 + ROOM) for side in (-1, 1))
    over = (boxes[None, :, :2] < high[:, None]) & (boxes[None, :, 2:] > low[:, None])
    best, least = None, np.inf
    for k in np.flatnonzero(~np.any(np.all(over, axis=2), axis=1)):
        label = DrawnLabel(wish.look, wish.text, (float(centres[k, 0]), float(centres[k, 1])), size, wish.names)
        cost = ACROSS * float(np.sum(np.all((taken > low[k]) & (taken < high[k]), axis=1)))
        cost += BLINDED * _crosses(_leader(wish.anchor, label), boxes)
        if not cost:
            return best if least <= costs[k] else label
        if wish.needed and costs[k] + cost < least:
            best, least = label, costs[k] + cost
    return _aside(wish, boxes) if best is None and wish.needed else best


def _aside(wish: Wish, boxes: np.ndarray) -> DrawnLabel:
    """The label to the right of all others, where no place around its anchor is left."""
    size = measured(wish.text, wish.look)
    right = float(np.max(boxes[:, 2], initial=wish.anchor[0])) + ROOM + size[0] / 2
    return DrawnLabel(wish.look, wish.text, (right, wish.anchor[1]), size, wish.names)


def _candidates(wish: Wish, size: Point) -> tuple[np.ndarray, np.ndarray]:
    """(n, 2) and (n,): centres of boxes around the anchor with their costs, the cheapest first."""
    distances = np.array([x for x in DISTANCES if x <= wish.reach])
    turns = 2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    angles = np.arctan2(wish.towards[1], wish.towards[0]) + turns
    ways = np.column_stack([np.cos(angles), np.sin(angles)])
    within = np.min(np.array(size) / 2 / np.maximum(np.abs(ways), 1e-9), axis=1)
    centres = np.array(wish.anchor) + (distances[:, None, None] - EDGE + within[None, :, None]) * ways[None]
    costs = np.round(distances[:, None] + ASIDE * (1 - np.cos(turns)) / 2, 6)
    order = np.argsort(costs, axis=None, kind="stable")
    return np.round(centres.reshape(-1, 2)[order], 6), costs.ravel()[order]


def _leader(anchor: Point, label: DrawnLabel) -> Stroke | None:
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


def overlaps(labels: Sequence[DrawnLabel]) -> Iterator[tuple[DrawnLabel, DrawnLabel]]:
    """The pairs of labels that overlap."""
    for i, first in enumerate(labels):
        for second in labels[i + 1 :]:
            (a0, b0, a1, b1), (c0, d0, c1, d1) = first.box, second.box
            if a0 < c1 and c0 < a1 and b0 < d1 and d0 < b1:
                yield first, second
