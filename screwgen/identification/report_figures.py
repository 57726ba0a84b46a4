"""The figures of the report: measured against model, numbers over their starts, spectra of residuals."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..plotting.curves import thin
from ..plotting.look import GREY, INK, LIMITS, PALE, PALETTE, canvas, legend_above, png, styled
from .identification import Estimated, Explained

MODEL, FOUND = PALETTE[1], PALETTE[0]
DPI = 110
FAR = 3.0
"""So many times the extent of the readings the curve of the start is drawn."""
WIDEST = 100.0
"""Factors beyond this, and below its inverse, are cut off."""


@styled
def against_model(log: Explained, title: str) -> bytes:
    """Of each sensor the readings with the model's before and after, and what is left, over time."""
    out = canvas(11.0, 1.9 * len(log.sensors) + 0.5, title)
    grid = out.subplots(len(log.sensors), 2, squeeze=False, sharex=True, width_ratios=(1.6, 1.0))
    for k, (sensor, (left, right)) in enumerate(zip(log.sensors, grid, strict=True)):
        y = log.readings[:, k]
        low, high = float(np.nanmin(y)), float(np.nanmax(y))
        room = max(high - low, 1e-12) / 4
        bounded = np.clip(log.before[:, k], low - FAR * room, high + FAR * room)
        left.plot(*thin(log.t, bounded), color=PALE, linewidth=1.0, label="model of the start")
        left.plot(*thin(log.t, y), color=INK, linewidth=1.6, label="measured")
        left.plot(*thin(log.t, log.whole[:, k]), color=MODEL, linewidth=1.1, label="model found")
        left.set_ylim(low - room, high + room)
        left.set_ylabel(sensor)
        right.plot(*thin(log.t, y - log.whole[:, k]), color=MODEL, linewidth=1.0, label="in one run")
        right.plot(*thin(log.t, y - log.windows[:, k]), color=FOUND, linewidth=1.0, label="over windows")
        right.axhline(0.0, color=PALE, linewidth=0.8)
    for axes, label in zip(grid[0], ("", "measured less model"), strict=True):
        axes.set_title(label)
        legend_above(axes)
    for axes in grid[-1]:
        axes.set_xlabel("t (s)")
        axes.set_xlim(log.t[0], log.t[-1])
    return png(out, DPI)


@styled
def over_start(estimates: Sequence[Estimated]) -> bytes:
    """Numbers over their starts with their intervals, on a logarithmic scale; nothing where none is sought so."""
    shown = [x for x in estimates if x.start and x.value / x.start > 0]
    if not shown:
        return b""
    out = canvas(11.0, 0.26 * len(shown) + 1.0)
    axes = out.subplots()
    for k, one in enumerate(reversed(shown)):
        colour = FOUND if one.determined else PALE
        ends = np.clip(np.sort(np.array([one.low, one.high]) / one.start), 1 / WIDEST, WIDEST)
        axes.plot(ends if one.determined else [1 / WIDEST, WIDEST], [k, k], color=colour, linewidth=3.0, alpha=0.45)
        axes.plot(np.clip(one.value / one.start, 1 / WIDEST, WIDEST), k, "o", color=colour, markersize=4.5)
    axes.axvline(1.0, **LIMITS)
    axes.set_xscale("log")
    axes.set_yticks(range(len(shown)), [x.name for x in reversed(shown)])
    axes.set_ylim(-0.7, len(shown) - 0.3)
    axes.set_xlabel("found over start; intervals, grey what the data do not determine")
    return png(out, DPI)


@styled
def spectra(of: Mapping[str, tuple[np.ndarray, np.ndarray]], frequencies: Sequence[float]) -> bytes:
    """Spectra of residuals, by sensor, and the model's frequencies, Hz."""
    out = canvas(11.0, 3.2)
    axes = out.subplots()
    for k, (sensor, (f, power)) in enumerate(of.items()):
        axes.loglog(f[1:], np.maximum(power[1:], 1e-16), color=PALETTE[k % len(PALETTE)], label=sensor)
    low, high = axes.get_xlim()
    for own in frequencies:
        if low < own < high:
            axes.axvline(own, **LIMITS)
    axes.set_xlabel("frequency (Hz)", color=GREY)
    axes.set_ylabel("power over variance")
    legend_above(axes)
    return png(out, DPI)
