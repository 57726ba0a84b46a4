"""Sheets: figures of several panels in the look of `screwgen.look`, the same bytes every time."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from screwgen.plotting import look
from screwgen.plotting.curves import over_time, scale, thin
from screwgen.plotting.look import LIMITS, PALETTE, canvas, styled

PANEL = (4.3, 2.7)


class Sheet:
    """A grid of panels, filled row by row; `png()` gives the file."""

    def __init__(self, rows: int, columns: int, title: str, panel: tuple[float, float] = PANEL):
        self.rows, self.columns, self.count, self.panels = rows, columns, 0, 0
        self.figure = canvas(columns * panel[0], rows * panel[1] + 0.45, title)

    @styled
    def axes(self, title: str, xlabel: str = "t (s)", ylabel: str = "", span: int = 1):
        """The next panel, over `span` columns, marked (a), (b), …"""
        first, self.count = self.count + 1, self.count + span
        out = self.figure.add_subplot(self.rows, self.columns, (first, self.count))
        out.set_title(self.marked(title))
        out.set(xlabel=xlabel, ylabel=ylabel)
        self.panels += 1
        return out

    def marked(self, title: str) -> str:
        """The title of the next panel with its letter."""
        return f"({'abcdefgh'[self.panels]})  {title}"

    @styled
    def curves(self, title: str, t: np.ndarray, curves: Iterable, ylabel: str, unit: str, bounds=()):
        """A panel of curves over time: each a label, values in SI units, colour and style; a label of None: no entry.

        `ylabel` and `unit` name the quantity and its SI unit; the panel shows it in the unit that suits its size.
        `bounds`: limits ±b, in SI units.
        """
        curves, full = list(curves), self.marked(title)
        fitted = scale(t, [values for _, values, *_ in curves], unit, bounds)
        out = self.axes(title)
        for label, values, color, style in curves:
            x, y = thin(t, values)
            out.plot(x, fitted.factor * y, style, color=color, label=label)
        for bound in bounds:
            out.axhline(fitted.factor * bound, **LIMITS)
            out.axhline(-fitted.factor * bound, **LIMITS)
        over_time(out, t, full, f"{ylabel} ({fitted.unit})", fitted)
        return out

    @styled
    def legend(self) -> None:
        """One legend for all panels, below them: every label once."""
        found = [zip(*axes.get_legend_handles_labels()[::-1], strict=True) for axes in self.figure.axes]
        handles = list({label: handle for pairs in found for label, handle in pairs}.values())
        look.fitted_legend(self.figure, handles, 0.95 * self.figure.bbox.width, loc="outside lower center")

    def png(self, dpi: int) -> bytes:
        return look.png(self.figure, dpi)


def xyz(values: np.ndarray) -> list:
    """Three components as curves."""
    return [(name, x, shade, "-") for name, x, shade in zip("xyz", values.T, PALETTE, strict=False)]
