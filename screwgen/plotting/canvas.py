"""A picture of given pixels, in which lines and polygons are moved from one frame of a film to the next."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import colors
from matplotlib.collections import LineCollection, PolyCollection

from .look import canvas, styled

if TYPE_CHECKING:
    from matplotlib.lines import Line2D
    from matplotlib.text import Text

DPI = 100


def rgb(color: str) -> np.ndarray:
    """The shares (3,) of red, green and blue of a colour such as `#2f6fab`."""
    return np.array(colors.to_rgb(color))


class Canvas:
    """The picture, `size` pixels, (0, 0) its top left corner."""

    @styled
    def __init__(self, size: tuple[int, int], paper: str):
        self.size = size
        self.figure = canvas(size[0] / DPI, size[1] / DPI, layout="none")
        self.figure.set_dpi(DPI)
        self.figure.set_facecolor(paper)
        self.axes = self.figure.add_axes((0, 0, 1, 1))
        self.axes.axis("off")
        self.axes.set_xlim(0, size[0])
        self.axes.set_ylim(size[1], 0)

    def lines(self, ends: np.ndarray, shades: np.ndarray, width: float) -> None:
        """Lines between pairs of points (N, 2, 2) in the colours (N, 3), behind all else."""
        self.axes.add_collection(LineCollection(ends, colors=shades, linewidth=width, zorder=0), autolim=False)

    def line(self, points: np.ndarray, **style: Any) -> Line2D:
        """A line through points (N, 2)."""
        return self.axes.plot(*points.T, **style)[0]

    def polygons(self, height: float, color: str | None = None) -> Polygons:
        """Polygons that hide what has a lesser `height`."""
        found = Polygons([], linewidth=0.4, zorder=height, **({} if color is None else {"color": color}))
        self.axes.add_collection(found, autolim=False)
        return found

    @styled
    def write(self, x: float, y: float, text: str, color: str, **style: Any) -> Text:
        """Text at a pixel; distances from the right and lower edges are negative."""
        across, down = x / self.size[0] % 1.0, 1 - y / self.size[1] % 1.0
        style = {"va": "top" if y >= 0 else "bottom", "ha": "left" if x >= 0 else "right"} | style
        return self.axes.text(
            across, down, text, color=color, transform=self.axes.transAxes, zorder=9, parse_math=False, **style
        )

    @styled
    def picture(self) -> np.ndarray:
        """The picture (height, width, 3) as bytes."""
        self.figure.canvas.draw()
        return np.asarray(self.figure.canvas.buffer_rgba())[:, :, :3].copy()


class Polygons(PolyCollection):
    """Polygons of one kind."""

    def move(self, corners: np.ndarray, shades: np.ndarray | None = None) -> None:
        """Draw polygons (N, k, 2), each in one of the colours (N, 3) if there are any, the last on top."""
        self.set_verts(corners)
        if shades is not None:
            self.set_color(shades)
