"""The style of all figures: colours, type and lines, canvases, grids, and reproducible files."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from functools import wraps
from itertools import combinations, pairwise, product
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, MaxNLocator
from matplotlib.transforms import Bbox
from mpl_toolkits.mplot3d.proj3d import proj_transform

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.gridspec import GridSpec, SubplotSpec
    from matplotlib.legend import Legend
    from matplotlib.lines import Line2D
    from matplotlib.text import Text

PALETTE = ("#2b6cb0", "#dd6b20", "#2f855a", "#b83280", "#6b46c1", "#0987a0", "#744210", "#718096")
STYLES = ("-", "--", ":", "-.")
INK, GREY, PALE, PANE = "#1a202c", "#4a5568", "#a0aec0", "#f7fafc"
LIMITS = dict(color=GREY, linewidth=0.9, linestyle=":")
"""A line at a bound that is not to be passed."""
LOOK = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.edgecolor": PALE,
    "axes.labelcolor": GREY,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.formatter.useoffset": False,
    "axes.formatter.limits": (-3, 5),
    "grid.color": "#e2e8f0",
    "grid.linewidth": 0.7,
    "xtick.color": GREY,
    "ytick.color": GREY,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "legend.handlelength": 1.8,
    "legend.labelspacing": 0.35,
    "legend.columnspacing": 1.4,
    "lines.linewidth": 1.3,
    "path.simplify": True,
}
SMALL = 7.5
"""Points: the size of notes."""
FLATTEST = 0.3
"""The least extent of axes in space, over the largest."""
LABEL_PADS, TICK_PAD, OFFSETS = (27.0, 27.0, 20.0), 10.0, (21.0, 8.0)
"""How far names, of x, y and z, and numbers stand off the edges of a cube, and what of that matplotlib adds itself."""
MARGIN = 16
"""Pixels left free at either side of a view in space."""
VIEWS = ((22.0, -58.0), (22.0, 32.0), (55.0, -58.0), (55.0, 32.0))
"""Elevations and azimuths, degrees, to look from."""


_P = ParamSpec("_P")
_R = TypeVar("_R")


def styled(draw: Callable[_P, _R]) -> Callable[_P, _R]:
    """`draw` in this look."""

    @wraps(draw)
    def drawn(*args: _P.args, **options: _P.kwargs) -> _R:
        with rc_context(LOOK):
            return draw(*args, **options)

    return drawn


@styled
def canvas(width: float, height: float, title: str = "", layout: str = "constrained") -> Figure:
    """An empty figure, inches, without a window."""
    out = Figure(figsize=(width, height), layout=layout)
    FigureCanvasAgg(out)
    if title:
        out.suptitle(title, fontsize=12, fontweight="bold")
    return out


@styled
def png(figure: Figure, dpi: float = 150) -> bytes:
    """The figure as PNG, the same bytes every time: without date or version."""
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=dpi, metadata={"Software": None})
    return stream.getvalue()


def filled(grid: GridSpec, count: int, columns: int, top: int = 0) -> list[SubplotSpec]:
    """Cells for `count` panels from row `top` on, at most `columns` in a row, in rows as even as may be.

    The grid has a multiple of 1, 2, … `columns` columns, so that shorter rows hold wider panels and none has a gap.
    """
    out, rows = [], -(-count // columns)
    for row in range(rows):
        here = count // rows + (row < count % rows)
        edges = np.arange(here + 1) * grid.ncols // here
        out += [grid[top + row, a:b] for a, b in pairwise(edges)]
    return out


def legend_above(axes: Axes, width: float = np.inf) -> Legend | None:
    """The legend of axes above them, so that it covers no curve: beside their title, or where both take more than
    `width`, pixels, between title and curves, in as many rows as it needs."""
    handles = axes.get_legend_handles_labels()[0]
    if not handles:
        return None
    place, title = dict(borderaxespad=0.1, borderpad=0.2), axes.title if axes.title.get_text() else axes._left_title
    beside = width - title.get_window_extent().width
    out = axes.legend(handles=handles, ncols=len(handles), loc="lower right", bbox_to_anchor=(1.0, 1.0), **place)
    if out.get_window_extent().width <= beside:
        return out
    out.remove()
    out = fitted_legend(axes, handles, width, loc="lower left", bbox_to_anchor=(0.0, 1.0), **place)
    points = out.get_window_extent().height * 72 / axes.figure.dpi
    axes.set_title(axes.get_title(loc="left"), loc="left", pad=points + 3)
    return out


def legend_below(axes: Axes, columns: int, handles: Sequence | None = None) -> Legend:
    """The legend of axes below their label, for long entries."""
    handles = axes.get_legend_handles_labels()[0] if handles is None else handles
    place = dict(loc="upper center", bbox_to_anchor=(0.5, 0.0), borderaxespad=4.5)
    return axes.legend(handles=handles, ncols=columns, **place)


def name_ends(axes: Axes, lines: Sequence[Line2D], gap: float = 0.075) -> None:
    """Names of lines (their labels) at the right of axes, at the height of their ends, moved apart to `gap` at least.

    `gap`: of the height of the axes, whose limits have been set.
    """
    ends = [axes.transAxes.inverted().transform(axes.transData.transform(line.get_xydata()[-1]))[1] for line in lines]
    below = -np.inf
    for height, line in sorted(zip(ends, lines, strict=True), key=lambda pair: pair[0]):
        below = max(min(height, 1.0), below + gap)
        place = dict(xycoords="axes fraction", textcoords="offset points", va="center", annotation_clip=False)
        axes.annotate(line.get_label(), (1, below), (5, 0), color=line.get_color(), fontsize=SMALL, **place)


def fitted_legend(owner: Axes | Figure, handles: Sequence, width: float, **options: Any) -> Legend:
    """A legend of axes or of a figure with as many columns as fit into `width`, pixels."""
    for columns in range(len(handles), 0, -1):
        out = owner.legend(handles=handles, ncols=columns, **options)
        if columns == 1 or out.get_window_extent().width <= width:
            return out
        out.remove()
    raise ValueError("a legend needs handles")


# ------------------------------------------------------------------------------ in space


def rooms(figure: Figure, cells: Sequence[SubplotSpec]) -> list[Axes]:
    """Empty axes that keep room for axes in space until `into_space` puts these there."""
    out = [figure.add_subplot(cell) for cell in cells]
    for room in out:
        room.axis("off")
    return out


def into_space(figure: Figure, rooms: Sequence[Axes]) -> list[Axes]:
    """Lay the figure out, once and for all, and put axes in space into the rooms; draw, then `fit` them."""
    if figure.get_layout_engine() is not None:
        figure.get_layout_engine().execute(figure)
        figure.set_layout_engine("none")
    out = []
    for room in rooms:
        out.append(figure.add_axes(room.get_position().bounds, projection="3d"))
        out[-1].patch.set_visible(False)
        room.remove()
    return out


def fit(axes: Axes, points: np.ndarray, title: str, subtitle: str = "") -> None:
    """Frame points (N, 3), m, in space with the same scale on all axes, as large as title and labels leave room.

    Axes of `into_space`; looked at from where they have been turned to.
    """
    figure, place = axes.figure, axes.get_position(original=True)
    middle, top = (place.x0 + place.x1) / 2, place.y1
    for text, options in ((title, dict(weight="bold", size=10)), (subtitle, dict(color=GREY))):
        if text:
            line = _within(figure.text(middle, top, text, ha="center", va="top", **options), place.width)
            top -= 1.25 * line.get_window_extent().height / figure.bbox.height
    _frame(axes, points)
    room = Bbox([[place.x0, place.y0], [place.x1, top]]).transformed(figure.transFigure).padded(-MARGIN, 0)
    side, centre = min(room.width, room.height), _centre(room)
    for turn in range(5):
        square = Bbox([centre - side / 2, centre + side / 2])
        axes.set_position(square.transformed(figure.transFigure.inverted()))
        if turn < 4:
            drawn = _drawn(axes)
            centre = centre + _centre(room) - _centre(drawn)
            side *= 0.99 * min(room.width / drawn.width, room.height / drawn.height)
    _thin_numbers(axes)


def _thin_numbers(axes: Axes) -> None:
    """Leave a single number, in the middle, to axes in space whose numbers cover each other, the shortest first."""
    renderer = axes.figure.canvas.get_renderer()
    limits = {name: getattr(axes, f"get_{name}lim")() for name in "xyz"}
    for name in sorted("xyz", key=lambda name: limits[name][1] - limits[name][0]):
        axes.draw(renderer)
        boxes = [box for other in "xyz" for box in _numbers(getattr(axes, f"{other}axis"), limits[other], renderer)]
        if not any(a.overlaps(b) for a, b in combinations(boxes, 2)):
            return
        axis, middle = getattr(axes, f"{name}axis"), sum(limits[name]) / 2
        axis.set_major_locator(FixedLocator([min(axis.get_majorticklocs(), key=lambda x: abs(x - middle))]))


def _numbers(axis: Any, limits: tuple[float, float], renderer: Any) -> list[Bbox]:
    """What the numbers along an axis cover, with some room, pixels."""
    pairs = zip(axis.get_majorticklocs(), axis.get_major_ticks(), strict=False)
    return [tick.label1.get_window_extent(renderer).padded(2) for x, tick in pairs if limits[0] <= x <= limits[1]]


def _within(text: Text, width: float) -> Text:
    """The text in as many lines as a `width`, of the figure's, asks for."""
    words, room = text.get_text().split(), 0.95 * width * text.figure.bbox.width
    lines = words[:1]
    for word in words[1:]:
        text.set_text(f"{lines[-1]} {word}")
        fits = text.get_window_extent().width <= room
        lines = [*lines[:-1], text.get_text()] if fits else [*lines, word]
    text.set_text("\n".join(lines))
    return text


def _centre(box: Bbox) -> np.ndarray:
    return (box.min + box.max) / 2


def _frame(axes: Axes, points: np.ndarray) -> None:
    """Limits, labels and ticks about points (N, 3), m, in parallel projection, without large empty margins."""
    half = np.ptp(points, axis=0) / 2
    half = 1.05 * np.maximum(half, max(FLATTEST * float(half.max()), 1e-3))
    shares = half / half.max()
    stand_off = dict(zip("xyz", LABEL_PADS, strict=True))
    for k, (name, centre) in enumerate(zip("xyz", (points.max(0) + points.min(0)) / 2, strict=True)):
        axis, depth = getattr(axes, f"{name}axis"), float(np.sqrt(np.mean(np.delete(shares, k) ** 2)))
        getattr(axes, f"set_{name}lim")(centre - half[k], centre + half[k])
        getattr(axes, f"set_{name}label")(f"{name} (m)", labelpad=stand_off[name] / depth**0.8 - OFFSETS[0])
        axis.set_tick_params(pad=TICK_PAD / depth**0.5 - OFFSETS[1], labelsize=SMALL)
        axis.set_major_locator(MaxNLocator(max(2, round(5 * shares[k]))))
        axis.set_pane_color(PANE)
    axes.set_box_aspect(shares)
    axes.set_proj_type("ortho")


def _drawn(axes: Axes) -> Bbox:
    """What axes in space cover with their box and its labels, pixels."""
    renderer = axes.figure.canvas.get_renderer()
    axes.draw(renderer)
    corners = np.array(list(product(*(getattr(axes, f"get_{name}lim")() for name in "xyz"))))
    flat = np.column_stack(proj_transform(*corners.T, axes.get_proj())[:2])
    box = axes.transData.transform(flat)
    labels = [getattr(axes, f"{name}axis").get_tightbbox(renderer) for name in "xyz"]
    return Bbox.union([Bbox([box.min(axis=0), box.max(axis=0)]), *labels])


def view(along: np.ndarray, across: np.ndarray) -> tuple[float, float]:
    """Of `VIEWS` the first that shows nearly all of the area that pairs of vectors (…, 3) span."""

    def area(angles: tuple[float, float]) -> float:
        up, round_ = np.radians(angles)
        eye = [np.cos(up) * np.cos(round_), np.cos(up) * np.sin(round_), np.sin(up)]
        return float(np.abs(np.cross(along, across) @ eye).sum())

    areas = [area(angles) for angles in VIEWS]
    return VIEWS[next(k for k, a in enumerate(areas) if a >= 0.8 * max(areas))]
