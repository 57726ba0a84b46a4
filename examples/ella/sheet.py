"""Sheets: figures of several panels in the look of `screwgen.plot`, the same bytes every time."""

from __future__ import annotations

import io
from collections.abc import Iterable

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from screwgen.plot import GREY, LOOK, PALETTE, thin

PANEL = (4.3, 2.7)
LIMITS = dict(color=GREY, linewidth=0.9, linestyle=":")


class Sheet:
    """A grid of panels, filled row by row; `png()` gives the file."""

    def __init__(self, rows: int, columns: int, title: str, panel: tuple[float, float] = PANEL):
        self.rows, self.columns, self.count, self.panels = rows, columns, 0, 0
        with rc_context(LOOK):
            self.figure = Figure(figsize=(columns * panel[0], rows * panel[1] + 0.45), layout="constrained")
            FigureCanvasAgg(self.figure)
            self.figure.suptitle(title, fontsize=12, fontweight="bold")

    def axes(self, title: str, xlabel: str = "t (s)", ylabel: str = "", span: int = 1):
        """The next panel, over `span` columns, marked (a), (b), …"""
        first, self.count = self.count + 1, self.count + span
        with rc_context(LOOK):
            out = self.figure.add_subplot(self.rows, self.columns, (first, self.count))
            out.set_title(f"({'abcdefgh'[self.panels]})  {title}")
            out.set(xlabel=xlabel, ylabel=ylabel)
            self.panels += 1
        return out

    def curves(self, title: str, t: np.ndarray, curves: Iterable, ylabel: str, legend: bool = True, **options):
        """A panel of curves over time: each a label, values, colour and style; `None` as label: not in the legend."""
        out = self.axes(title, ylabel=ylabel, **options)
        with rc_context(LOOK):
            for label, values, color, style in curves:
                out.plot(thin(t), thin(values), style, color=color, label=label)
            out.margins(x=0)
            if legend:
                out.legend(loc="best", handlelength=2.0, borderpad=0.3, labelspacing=0.3)
        return out

    def png(self, dpi: int) -> bytes:
        stream = io.BytesIO()
        with rc_context(LOOK):
            self.figure.savefig(stream, format="png", dpi=dpi, metadata={"Software": None})
        return stream.getvalue()


def xyz(values: np.ndarray, names: str, scale: float = 1.0) -> list:
    """Three components as curves."""
    labels = [f"{names}$_{k}$" for k in "xyz"]
    return [(label, scale * x, shade, "-") for label, x, shade in zip(labels, values.T, PALETTE, strict=False)]
