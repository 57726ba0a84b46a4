"""A drawing as SVG, which takes its colours from the page, and in LaTeX's own environment ``picture``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from ..templates import markup, render
from . import text
from .drawing import DASHES, WIDTHS, Drawing, Stroke, dashes, rounded
from .label_text import DROP, SMALLER, runs, size

BASELINE = 0.35
"""How far the line of a text is below its middle, over the size of its letters."""
UNIT, MOST = 0.75, 430.0
"""pt per px in LaTeX, less where a drawing would be wider than that, pt."""
THIN = 0.85
"""The width of lines in LaTeX, which has no colours, over that of SVG."""
TOUCH = 0.7
"""The distance of the dots of which LaTeX makes a line, over its width."""


class TextRun(NamedTuple):
    """A piece of a label in SVG."""

    text: str
    style: str
    size: str
    """Empty where it is that of the label."""
    down: str
    """How far it is below the piece before it, px; empty where it is on the same line."""


STRAIGHT = 0.9
"""The cosine of the angle from which on a line goes on in its direction."""


def svg(drawing: Drawing) -> str:
    """The drawing in SVG."""
    width, height = drawing.size
    upright = lambda p: (_number(p[0]), _number(rounded(height - p[1])))  # noqa: E731
    paths = [(look, " ".join(_path([upright(p) for p in s.points]) for s in own)) for look, own in _by_look(drawing)]
    labels = [
        (label, _number(label.at[0]), _number(rounded(height - label.at[1] + BASELINE * size(label.look))))
        for label in drawing.labels
    ]
    out = render(
        "latex/sketch.html.jinja",
        width=_number(width),
        height=_number(height),
        paths=paths,
        dots=[(dot.look, *upright(dot.at), _number(dot.radius)) for dot in drawing.dots],
        labels=[
            (label.look, x, y, _number(size(label.look)), ", ".join(label.names), list(_pieces(label.text, label.look)))
            for label, x, y in labels
        ],
        widths={look: _number(x) for look, x in WIDTHS.items()},
        dashes={look: f"{_number(on)} {_number(off)}" for look, (on, off) in DASHES.items()},
    )
    return markup(out)


def picture(drawing: Drawing) -> str:
    """The drawing in LaTeX: every line is made of parabolas by ``\\qbezier``."""
    width, height = drawing.size
    return render(
        "latex/sketch.tex.jinja",
        unit=f"{min(UNIT, MOST / width):.4g}pt",
        width=_number(width),
        height=_number(height),
        looks=[
            (f"{THIN * UNIT * WIDTHS[look]:.2f}pt", [curve for stroke in own for curve in _curves(stroke)])
            for look, own in _by_look(drawing)
        ],
        dots=[(*map(_number, dot.at), _number(2 * dot.radius)) for dot in drawing.dots],
        labels=[(*map(_number, label.at), text.tex(label.text)) for label in drawing.labels],
    )


def _by_look(drawing: Drawing) -> Iterator[tuple[str, list[Stroke]]]:
    """The strokes of every look that there is, in the order of `WIDTHS`."""
    for look in WIDTHS:
        own = [stroke for stroke in drawing.strokes if stroke.look == look]
        if own:
            yield look, own


def _path(points: list[tuple[str, str]]) -> str:
    return "M" + "L".join(f"{x} {y}" for x, y in points)


def _pieces(label: str, look: str) -> Iterator[TextRun]:
    level, letters = 0, size(look)
    for run in runs(label):
        down = _number(rounded(DROP * letters * (run.level - level))) if run.level != level else ""
        yield TextRun(run.text, run.style, _number(rounded(SMALLER * letters)) if run.level else "", down)
        level = run.level


def _curves(stroke: Stroke) -> Iterator[str]:
    """The commands that draw a line; one draws all dashes of a straight one, of which the last ends where it ends."""
    if stroke.look not in DASHES:
        yield from _parabolas(stroke.points, stroke.look)
        return
    (on, off), (first, *_, last) = DASHES[stroke.look], stroke.points
    way = np.subtract(last, first)
    length = float(np.hypot(*way))
    count = round((length + off) / (on + off))
    if len(stroke.points) > 2 or count < 2:
        for points in dashes(stroke.points, on, off):
            yield from _parabolas(points, stroke.look)
        return
    step, dash = way * (length - on) / (length * (count - 1)), way * on / length
    (one,) = _parabolas([(0.0, 0.0), (rounded(dash[0]), rounded(dash[1]))], stroke.look)
    at, by = (",".join(f"{x:.4g}" for x in pair) for pair in (first, step))
    yield rf"\multiput({at})({by}){{{count}}}{{{one}}}"


def _parabolas(points: Sequence[tuple[float, float]], look: str) -> Iterator[str]:
    """Those of a line without gaps, each through three points in a row: how many dots make it, and its points."""
    start = 0
    while start < len(points) - 1:
        end = min(start + (2 if _smooth(points[start : start + 3]) else 1), len(points) - 1)
        a, b = points[start], points[end]
        between = points[start + 1] if end > start + 1 else ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        middle = tuple(rounded(2 * m - (x + y) / 2) for m, x, y in zip(between, a, b, strict=True))
        length = sum(np.hypot(y[0] - x[0], y[1] - x[1]) for x, y in ((a, between), (between, b)))
        count = int(np.ceil(length / (TOUCH * THIN * WIDTHS[look])))
        start = end
        if a != b:
            yield rf"\qbezier[{count}]" + "".join(f"({_number(x)},{_number(y)})" for x, y in (a, middle, b))


def _smooth(points: Sequence[tuple[float, float]]) -> bool:
    """Whether a line does not turn sharply in the middle of three points."""
    if len(points) < 3:
        return False
    (ax, ay), (bx, by), (cx, cy) = points
    before, after = (bx - ax, by - ay), (cx - bx, cy - by)
    along = before[0] * after[0] + before[1] * after[1]
    return along > STRAIGHT * np.hypot(*before) * np.hypot(*after)


def _number(x: float) -> str:
    return f"{x:.6g}"
