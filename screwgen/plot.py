"""A run at a glance: one figure with its angles, modes, torques, wrenches, energy and tip path."""

from __future__ import annotations

import io
import os
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from matplotlib import colormaps, rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from .runs import Run, check_output, outputs

if TYPE_CHECKING:
    from matplotlib.axes import Axes

PALETTE = ("#2b6cb0", "#dd6b20", "#2f855a", "#b83280", "#6b46c1", "#0987a0", "#744210", "#718096")
STYLES = ("-", "--", ":", "-.")
GREY = "#4a5568"
COLUMNS, PANEL = 3, (4.6, 3.1)
NOTHING = 1e-12
"""What never exceeds this, in SI units, counts as zero throughout."""
MOST_IN_LEGEND = 8
MOST_POINTS = 4000
LOOK = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.edgecolor": "#a0aec0",
    "axes.labelcolor": GREY,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.formatter.useoffset": False,
    "axes.formatter.limits": (-3, 4),
    "grid.color": "#e2e8f0",
    "grid.linewidth": 0.7,
    "xtick.color": GREY,
    "ytick.color": GREY,
    "legend.frameon": True,
    "legend.framealpha": 0.8,
    "legend.edgecolor": "none",
    "legend.fontsize": 7.5,
    "lines.linewidth": 1.3,
    "path.simplify": True,
}


class Line(NamedTuple):
    """A curve over time: what it is called, the link it belongs to and which of the link's it is."""

    label: str
    values: np.ndarray
    link: int
    member: int = 0


class Panel(NamedTuple):
    """One set of axes over time."""

    title: str
    symbol: str
    unit: str
    lines: list[Line]

    @property
    def largest(self) -> float:
        """The largest magnitude of all, in SI units."""
        return max(float(np.abs(line.values).max()) for line in self.lines)


def figure(run: Run) -> Figure:
    """The figure of a run; what is zero throughout is said, not drawn. Views of the tip's path fill the grid."""
    with rc_context(LOOK):
        shown, silent = sift(panels(run))
        n = run.wrench.shape[1]
        plots = [partial(_curves, panel=panel, run=run) for panel in shown]
        plots += [partial(_energy, run=run), partial(_tip, run=run)]
        views = (_path, *(partial(_view, across=x, up=y) for x, y in ("xy", "xz")))[: COLUMNS - len(plots) % COLUMNS]
        rows = (len(plots) + len(views)) // COLUMNS
        out = Figure(figsize=(COLUMNS * PANEL[0], rows * PANEL[1] + 0.6), layout="constrained")
        FigureCanvasAgg(out)
        for k, paint in enumerate(plots):
            paint(out.add_subplot(rows, COLUMNS, k + 1))
        for k, paint in enumerate(views, len(plots) + 1):
            paint(out.add_subplot(rows, COLUMNS, k, projection=None if k > len(plots) + 1 else "3d"), run=run)
        _headline(out, run, silent)
        if n > len(PALETTE):
            _scale(out, n)
        return out


def save(run: Run, path: str | os.PathLike[str]) -> None:
    """Write the figure as a .png file, the same bytes every time; raises UsageError."""
    check_output(path, (".png",))
    with outputs(path) as (stream,):
        stream.write(png(run))


def png(run: Run) -> bytes:
    """The figure as PNG, without date or version."""
    stream = io.BytesIO()
    with rc_context(LOOK):
        figure(run).savefig(stream, format="png", dpi=150, metadata={"Software": None})
    return stream.getvalue()


# ------------------------------------------------------------------------------ what is shown


def panels(run: Run) -> list[Panel]:
    """The panels over time, link by link within each; a label lacks its unit, which depends on the size."""
    links = link_names(run)
    q, tau = partial(_lines, run.q, run.q_names, links), partial(_lines, run.tau, run.tau_names, links)
    return [
        Panel("Joint angles", "q", "rad", q(".joint[")),
        Panel("Joint torques", "τ", "N·m", tau(".torque[")),
        Panel("Bending in y", "η", "m", q(".eta.bending_y[")),
        Panel("Bending in z", "η", "m", q(".eta.bending_z[")),
        Panel("Axial modes", "η", "m", q(".eta.axial[")),
        Panel("Torsion modes", "η", "rad", q(".eta.torsion[")),
        Panel("Joint forces", "|F|", "N", _norms(run.wrench[:, :, 3:], links)),
        Panel("Joint moments", "|τ|", "N·m", _norms(run.wrench[:, :, :3], links)),
    ]


def sift(given: list[Panel]) -> tuple[list[Panel], list[str]]:
    """The panels with something to show, and the titles of those that are zero throughout."""
    full = [panel for panel in given if panel.lines]
    return [p for p in full if p.largest > NOTHING], [p.title.lower() for p in full if p.largest <= NOTHING]


def link_names(run: Run) -> list[str]:
    """The names of the links, base to tip."""
    return [name.rpartition(".")[0] for name in run.wrench_names[::6]]


def _lines(values: np.ndarray, names: tuple[str, ...], links: list[str], part: str) -> list[Line]:
    """The columns whose name has `part` after the link's; a number where a link has several."""
    found = [
        (k, links.index(name[: name.index(part)]), int(name[name.rindex("[") + 1 : -1]))
        for k, name in enumerate(names)
        if part in name
    ]
    several = {link for _, link, member in found if member}
    return [
        Line(f"{links[link]} {member + 1}" if link in several else links[link], values[:, k], link, member)
        for k, link, member in found
    ]


def _norms(vectors: np.ndarray, links: list[str]) -> list[Line]:
    return [Line(name, np.linalg.norm(vectors[:, i], axis=1), i) for i, name in enumerate(links)]


# ------------------------------------------------------------------------------ how it is drawn


def _headline(out: Figure, run: Run, silent: list[str]) -> None:
    note = f"   (zero throughout: {', '.join(silent)})" if silent else ""
    out.suptitle(f"{run.name}: {run.t[-1]:g} s in {len(run.t) - 1} steps{note}", fontsize=12, fontweight="bold")


def _curves(axes: Axes, panel: Panel, run: Run) -> None:
    scale, unit = prefixed(panel.largest, panel.unit)
    for line in panel.lines:
        style, shade = STYLES[line.member % len(STYLES)], color(line.link, run.wrench.shape[1])
        axes.plot(thin(run.t), scale * thin(line.values), style, color=shade, label=line.label)
    _finish(axes, panel.title, f"{panel.symbol} ({unit})")
    if run.wrench.shape[1] <= len(PALETTE):
        _legend(axes)


def prefixed(size: float, unit: str) -> tuple[float, str]:
    """The factor and the unit in which a small quantity is written: mm, µm, mrad."""
    power = 0 if size >= 0.05 else 3 if size >= 5e-5 else 6
    return (1.0, unit) if unit not in ("m", "rad") else (10.0**power, {0: "", 3: "m", 6: "µ"}[power] + unit)


def color(link: int, n: int) -> tuple | str:
    """The colour of a link: by name while there are few, on a scale from base to tip when there are many."""
    return PALETTE[link % len(PALETTE)] if n <= len(PALETTE) else colormaps["viridis"](0.95 * link / (n - 1))


def thin(values: np.ndarray) -> np.ndarray:
    """At most `MOST_POINTS` of the samples, evenly, the last one among them."""
    count = min(len(values), MOST_POINTS)
    return values[np.linspace(0, len(values) - 1, count).round().astype(int)]


def _finish(axes: Axes, title: str, label: str) -> None:
    axes.set_title(title)
    axes.set_xlabel("t (s)")
    axes.set_ylabel(label)
    axes.margins(x=0)


def _legend(axes: Axes) -> None:
    """A legend; of many lines, one entry a link."""
    handles, labels = axes.get_legend_handles_labels()
    if len(labels) > MOST_IN_LEGEND:
        entries = {label.rpartition(" ")[0] or label: handle for handle, label in zip(handles, labels, strict=True)}
        handles, labels = list(entries.values()), list(entries)
    columns = 1 if len(labels) <= 4 else 2
    axes.legend(handles, labels, loc="best", ncols=columns, handlelength=1.8, borderpad=0.3, labelspacing=0.3)


def _scale(out: Figure, n: int) -> None:
    """The link's number as a colour bar."""
    shades = ScalarMappable(Normalize(1, n), colormaps["viridis"])
    out.colorbar(shades, ax=out.axes, label="link, from base to tip", ticks=_ticks(n), pad=0.01, aspect=60)


def _ticks(n: int) -> list[int]:
    return sorted({round(x) for x in np.linspace(1, n, 6)})


def _energy(axes: Axes, run: Run) -> None:
    kinetic, potential = run.energy.T
    for label, values, shade, style in (
        ("kinetic", kinetic, PALETTE[0], "-"),
        ("potential", potential, PALETTE[1], "-"),
        ("total", kinetic + potential, "#1a202c", "--"),
    ):
        axes.plot(thin(run.t), thin(values), style, color=shade, label=label)
    _finish(axes, "Energy", "E (J)")
    _legend(axes)


def _tip(axes: Axes, run: Run) -> None:
    for name, values, shade in zip("xyz", run.tip_position.T, PALETTE, strict=False):
        axes.plot(thin(run.t), thin(values), color=shade, label=name)
    _finish(axes, "Tip position, inertial frame", "r (m)")
    _legend(axes)


def equal_scales(axes: Axes, points: np.ndarray, label_pad: float, tick_pad: float, size: float, zoom: float) -> None:
    """Axes in space about points (N, 3), m, with the same scale in all directions; pads and size in points."""
    reach = max(float(np.ptp(points, axis=0).max()) / 2, 1e-3)
    for name, centre in zip("xyz", (points.max(0) + points.min(0)) / 2, strict=True):
        getattr(axes, f"set_{name}lim")(centre - reach, centre + reach)
        getattr(axes, f"set_{name}label")(f"{name} (m)", labelpad=label_pad)
        getattr(axes, f"{name}axis").set_major_locator(MaxNLocator(4))
        getattr(axes, f"{name}axis").set_pane_color("#f7fafc")
    axes.tick_params(pad=tick_pad, labelsize=size)
    axes.set_box_aspect((1, 1, 1), zoom=zoom)


def _path(axes: Axes, run: Run) -> None:
    """The tip's path in space, its start marked, equal scales on all axes."""
    place = thin(run.tip_position)
    axes.plot(*place.T, color=PALETTE[0])
    axes.scatter(*place[0], color=PALETTE[2], s=22, label="start", depthshade=False)
    axes.scatter(*place[-1], color=PALETTE[3], s=22, label="end", depthshade=False)
    equal_scales(axes, place, label_pad=-2, tick_pad=-1, size=7.5, zoom=0.92)
    axes.set_title("Tip path")
    axes.legend(loc="upper right", borderpad=0.3)


def _view(axes: Axes, run: Run, across: str, up: str) -> None:
    """The tip's path on a plane of the inertial frame, equal scales on both axes."""
    place = thin(run.tip_position)[:, ["xyz".index(across), "xyz".index(up)]]
    axes.plot(*place.T, color=PALETTE[0])
    axes.plot(*place[0], "o", color=PALETTE[2], markersize=5, label="start")
    axes.plot(*place[-1], "o", color=PALETTE[3], markersize=5, label="end")
    axes.set(xlabel=f"{across} (m)", ylabel=f"{up} (m)", title=f"Tip path on the {across}-{up} plane")
    axes.margins(0.12)
    axes.set_aspect("equal", adjustable="datalim")
    axes.legend(loc="best", borderpad=0.3)
