"""What a figure's texts, legends and axes cover, in pixels, after it has been laid out."""

from itertools import combinations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

SLACK = 1.0
"""Pixels by which boxes may touch."""


def laid_out(figure: Figure) -> Figure:
    figure.draw_without_rendering()
    return figure


def labels(figure: Figure) -> list[tuple[str, Bbox]]:
    """Every text that is drawn."""
    hidden, ticks = set(), []
    for axes in figure.axes:
        for axis in axes._axis_map.values():
            mine = axis.get_major_ticks() + axis.get_minor_ticks()
            hidden |= {label for tick in mine for label in (tick.label1, tick.label2)}
            if axes.axison:
                low, high = sorted(axis.get_view_interval())
                room = 1e-9 * (high - low)
                ticks += [t.label1 for t in mine if t.label1.get_visible() and low - room <= t.get_loc() <= high + room]
            else:
                hidden.add(axis.label)
    texts = [text for text in figure.findobj(Text) if text not in hidden] + ticks
    return [(text.get_text(), text.get_window_extent()) for text in texts if text.get_visible() and text.get_text()]


def collisions(figure: Figure) -> list[tuple[str, str]]:
    """Pairs of texts that cover one another."""
    pairs = combinations(labels(figure), 2)
    return [(a, b) for (a, one), (b, other) in pairs if overlap(one, other)]


def outside(figure: Figure) -> list[str]:
    """Texts that leave the figure."""
    width, height = figure.bbox.size
    reach = lambda box: min(box.x0, box.y0, width - box.x1, height - box.y1)  # noqa: E731
    return [text for text, box in labels(figure) if reach(box) < -SLACK]


def covered(figure: Figure) -> list[str]:
    """Axes over time, by title, that a legend covers."""
    legends = [x for x in (*figure.legends, *(axes.get_legend() for axes in figure.axes)) if x is not None]
    flat = [axes for axes in figure.axes if axes.name != "3d" and axes.axison]
    return [
        axes.get_title(loc="left")
        for axes in flat
        if any(overlap(axes.get_window_extent(), legend.get_window_extent()) for legend in legends)
    ]


def overlap(one: Bbox, other: Bbox) -> bool:
    return bool(np.all(np.minimum(one.max, other.max) - np.maximum(one.min, other.min) > SLACK))
