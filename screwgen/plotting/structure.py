"""The figure of M_sys: its blocks in the paper's order, the nonzero entries coloured by kind."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib import rc_context
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from . import look
from .look import GREY, PALETTE, canvas, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..studies.analysis.regularity import Structure

MEANINGS = {
    "joint": "rows of the joints: compatibility P, and the motors",
    "inertia": "inertia",
    "wrench": "columns of the wrenches in rows of links and modes",
    "coupling": "twists against modes, M_D and its transpose",
}
SIZE = 7.2
ROOM = 0.027
"""The least distance between names, as a share of the picture."""
MOST_LINES = 40


def png(s: Structure, name: str) -> bytes:
    """The picture as PNG, the same bytes every time, without date or version; `name` is the robot's."""
    return look.png(figure(s, name))


@styled
def figure(s: Structure, name: str) -> Figure:
    """The figure: rows downwards, a pixel block per entry."""
    text = rf"$\mathbf{{M}}_{{sys}}$ of {name}: {s.nonzeros} of {s.size} × {s.size} entries ({100 * s.fill:.1f} %)"
    out = canvas(SIZE, SIZE + 0.9, text)
    with rc_context({"axes.grid": False, "axes.spines.top": True, "axes.spines.right": True}):
        axes = out.add_subplot()
    _entries(axes, s)
    _frame(axes, s)
    used = [kind for kind in MEANINGS if kind in s.kinds]
    handles = [Patch(color=PALETTE[list(MEANINGS).index(kind)], label=MEANINGS[kind]) for kind in used]
    out.legend(handles=handles, loc="outside lower center", ncols=2, handlelength=1.0, handleheight=1.0)
    return out


def _entries(axes: Axes, s: Structure) -> None:
    image = np.ones((s.size, s.size, 3))
    colors = {kind: to_rgb(PALETTE[k]) for k, kind in enumerate(MEANINGS)}
    image[s.rows, s.columns] = [colors[kind] for kind in s.kinds]
    axes.imshow(image, interpolation="nearest", aspect="equal", resample=False)


def _frame(axes: Axes, s: Structure) -> None:
    """Lines between the blocks (for many links, between the links), and the names of the blocks if they fit."""
    edges = np.array([*s.starts, s.size]) - 0.5
    twists = len([label for label in s.labels if not label.startswith("eta")])
    crowded = len(edges) > MOST_LINES
    for edge in edges[2 : twists + 1 : 2] if crowded else edges[1:-1]:
        axes.axhline(edge, color="#cbd5e0", linewidth=0.3 if crowded else 0.6)
        axes.axvline(edge, color="#cbd5e0", linewidth=0.3 if crowded else 0.6)
    middles = (edges[:-1] + edges[1:]) / 2
    modal = spread(middles[twists:], ROOM * s.size, [])
    places = spread(middles[:twists], ROOM * s.size, modal) + modal
    names = [_symbol(s.labels[list(middles).index(place)]) for place in places]
    size = 9 if len(s.labels) <= 12 else 7.5
    axes.set_yticks(places, names, fontsize=size)
    axes.set_xticks(places, names, fontsize=size, rotation=90 if len(names) > 14 else 0)
    axes.tick_params(length=0, colors=GREY, top=True, labeltop=True, bottom=False, labelbottom=False)
    axes.set_xlabel("columns: unknowns, (67) and (100)")
    axes.set_ylabel("rows: joint i, link i, …, modes")


def spread(places: np.ndarray, room: float, taken: list[float]) -> list[float]:
    """The ascending `places` that are at least `room` apart from each other and from those taken."""
    out: list[float] = []
    for place in places.tolist():
        if all(abs(place - other) >= room for other in (*out[-1:], *taken[:1])):
            out.append(place)
    return out


def _symbol(label: str) -> str:
    kind, _, number = label.rpartition("_")
    symbol = {"w": r"\mathbf{w}", "V": r"\dot{\mathbf{V}}", "eta": r"\ddot{\eta}"}[kind]
    return f"${symbol}_{{{number}}}$"
