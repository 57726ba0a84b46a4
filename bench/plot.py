"""The plot of a run: what others take over what screwgen takes, and how time grows with links and modes."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from table import Row, significant

from screwgen.plotting.look import GREY, INK, PALE, PALETTE, SMALL, canvas, legend_above, png, styled

OURS, THEIRS, TARGET = PALETTE[0], PALE, PALETTE[3]


@styled
def draw(rows: Sequence[Row], path: Path) -> None:
    """Bars of the ratios of everything that is not screwgen's, on a logarithmic axis with targets; two curves."""
    others = [r for r in rows if not r.title.startswith(("screwgen", "cc ")) and "all robots" not in r.group]
    height = max(4.5, 1.4 + 0.24 * len(others))
    figure = canvas(12.5, height, "screwgen beside other ways to the same numbers")
    grid = figure.add_gridspec(2, 2, width_ratios=(2.1, 1))
    bars(figure.add_subplot(grid[:, 0]), others)
    growth(figure.add_subplot(grid[0, 1]), rows, "link", ("modular", "fused"))
    growth(figure.add_subplot(grid[1, 1]), rows, "mode", ("auto",))
    path.write_bytes(png(figure))


def bars(axes, others: Sequence[Row]) -> None:
    """One bar per contender from 1 to its ratio, the target as a tick."""
    for place, row in enumerate(others):
        faster = row.ratio >= 1
        axes.barh(place, row.ratio - 1, left=1, height=0.7, color=OURS if faster else TARGET)
        end, text = max(row.ratio, row.target[0] or 1, 1), significant(row.ratio)
        axes.annotate(text, (end, place), (4, 0), textcoords="offset points", va="center", fontsize=SMALL)
        if row.target[0] is not None:
            axes.plot([row.target[0]] * 2, [place - 0.42, place + 0.42], color=TARGET, linewidth=1.6)
    axes.set_yticks(range(len(others)), [f"{short(r.group)}: {r.title}" for r in others], fontsize=SMALL)
    axes.set_ylim(len(others) - 0.4, -0.6)
    axes.set_xscale("log")
    axes.axvline(1, color=INK, linewidth=0.8)
    axes.margins(x=0.15)
    axes.set_xlabel("time over screwgen's: to the right of 1 screwgen is faster; tick: target")
    axes.grid(axis="y", visible=False)


def growth(axes, rows: Sequence[Row], what: str, layouts: Sequence[str]) -> None:
    """Time per link or mode over their number."""
    for layout, colour in zip(layouts, (OURS, THEIRS), strict=False):
        found = []
        for row in rows:
            match = re.fullmatch(rf"screwgen (\d+) {what}s?( per plane)?, {layout}", row.title)
            if match:
                number = int(match[1])
                found.append((number, 1e9 * row.seconds / (number if what == "link" else 4 * number)))
        if found:
            axes.plot(*zip(*found, strict=True), "o-", color=colour, label=layout)
    axes.set_xscale("log", base=2)
    axes.xaxis.set_major_formatter("{x:.0f}")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("links" if what == "link" else "modes per plane, two links")
    axes.set_ylabel(f"ns per {what}")
    if axes.lines:
        legend_above(axes)
    else:
        axes.text(0.5, 0.5, "not run", transform=axes.transAxes, ha="center", color=GREY)


def short(group: str) -> str:
    """What a heading begins with."""
    return re.split(r"[,:;]", group)[0]
