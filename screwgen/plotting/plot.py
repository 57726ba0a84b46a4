"""The figure of a run: the arm in space, its angles, torques, modes, wrenches, energy and tip position over time."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from ..robot_model import RobotModel
from ..simulation.motion import centrelines
from ..simulation.runs import Run, check_output, outputs
from . import look
from .curves import over_time, scale, thin
from .look import GREY, INK, PALE, PALETTE, STYLES, canvas, filled, fitted_legend, legend_above, styled
from .run_panels import Panel, PanelCurve, chosen, link_names, panels, sift
from .strands import feet, strands

if TYPE_CHECKING:
    from matplotlib.axes import Axes


COLUMNS, GRID = 3, 6
"""Panels in a row, and columns of the grid below them, which hold one to three panels without a gap."""
PANEL = (4.6, 2.9)
SPACE = (2, 4)
"""Rows and columns of the grid for the arm in space; the first panels stand beside it."""
POSTURES, STATIONS = 5, np.linspace(0.0, 1.0, 17)
"""In how many postures the arm is drawn, and at which places along each link."""
GOAL = dict(linewidth=4.5, alpha=0.28, solid_capstyle="butt")
BOUND = dict(linewidth=0.9, linestyle=(0, (7, 2, 1, 2)))
END_OF_RANGE = dict(linewidth=0.9, linestyle=(0, (1, 1.5)))
PATH = dict(color=INK, linewidth=0.9)
EARLIER = dict(color=PALE, linewidth=1.6)
MARK = dict(marker="o", linestyle="none", markersize=6)
START, END = PALETTE[2], PALETTE[3]
NAMED = dict(zip("xyz", PALETTE, strict=False)) | {"kinetic": PALETTE[0], "potential": PALETTE[1], "total": INK}
"""The colours of curves that are no link's."""


@styled
def figure(run: Run, model: RobotModel | None = None, controller: Any = None, only: Sequence[str] = ()) -> Figure:
    """The figure of a run; quantities that are always zero are named, not drawn.

    `model`: that of the run, to draw the arm, and the displacements of tips in place of modal coordinates.
    Displacements, forces and moments are along the axes of their links. `controller`: its set points
    (`reference(t)`) and torque limits (`tau_max`) are drawn where it states them. `only`: words, one of which
    the titles of drawn panels have, in any case of letters; without it all are. Raises UsageError where none has one.
    """
    shown, silent = sift(chosen(panels(run, controller, model), only))
    below = max(len(shown) - SPACE[0], 0)
    rows = SPACE[0] + -(-below // COLUMNS)
    out = canvas(COLUMNS * PANEL[0], rows * PANEL[1] + 0.5, _headline(run))
    if silent:
        out.supxlabel(f"zero throughout: {', '.join(silent)}", fontsize=look.SMALL, color=GREY)
    grid = out.add_gridspec(rows, GRID)
    beside = min(len(shown), SPACE[0])
    cells = [grid[k * SPACE[0] // beside : (k + 1) * SPACE[0] // beside, SPACE[1] :] for k in range(beside)]
    cells += filled(grid, below, COLUMNS, SPACE[0])
    for panel, cell in zip(shown, cells, strict=True):
        _curves(out.add_subplot(cell), panel, run.t, len(link_names(run)))
    space = grid[: SPACE[0], : SPACE[1] if shown else GRID].subgridspec(2, 1, height_ratios=(8, 1))
    room = look.rooms(out, [space[0]])
    _key(out.add_subplot(space[1]), run, shown, model is not None)
    if len(link_names(run)) > len(PALETTE):
        _links(out, len(link_names(run)))
    for axes in look.into_space(out, room):
        _space(axes, run, model)
    return out


def save(
    run: Run,
    path: str | os.PathLike[str],
    model: RobotModel | None = None,
    controller: Any = None,
    only: Sequence[str] = (),
) -> None:
    """Write the figure as a .png file, the same bytes every time; arguments as of `figure`. Raises UsageError."""
    check_output(path, (".png",))
    with outputs(path) as (stream,):
        stream.write(png(run, model, controller, only))


def png(run: Run, model: RobotModel | None = None, controller: Any = None, only: Sequence[str] = ()) -> bytes:
    """The figure as PNG, without date or version; arguments as of `figure`."""
    return look.png(figure(run, model, controller, only))


# ------------------------------------------------------------------------------ how it is drawn


def _headline(run: Run) -> str:
    steps = len(run.t) - 1
    return f"{run.name}: {run.t[-1]:g} s in {steps} step{'s' if steps != 1 else ''}"


def color(owner: int | str, n: int) -> Any:
    """The colour of a curve of one of n links: by name while there are few, else on a scale from base to tip."""
    if isinstance(owner, str):
        return NAMED[owner]
    return PALETTE[owner % len(PALETTE)] if n <= len(PALETTE) else colormaps["viridis"](0.95 * owner / (n - 1))


def _style(line: PanelCurve) -> str:
    return STYLES[line.number % len(STYLES)] if line.owner != "total" else "--"


def _on_scale(line: PanelCurve, n: int) -> bool:
    """Whether the curve is told by its place on a scale of colours, and not by its name."""
    return isinstance(line.owner, int) and n > len(PALETTE)


def _curves(axes: Axes, panel: Panel, t: np.ndarray, n: int) -> None:
    goals = [line.goal for line in panel.lines if line.goal is not None]
    bounds = [line.bound for line in panel.lines if np.isfinite(line.bound)]
    ends = [x for line in panel.lines for x in line.ends]
    fitted = scale(t, [line.values for line in panel.lines] + goals, panel.unit, bounds, ends)
    for line in panel.lines:
        look = {"color": color(line.owner, n), "linestyle": _style(line)}
        for values, options in ((line.goal, GOAL), (line.values, {} if _on_scale(line, n) else {"label": line.label})):
            if values is not None:
                x, y = thin(t, values)
                axes.plot(x, fitted.factor * y, **look, **options)
        if np.isfinite(line.bound):
            for sign in (-1, 1):
                axes.axhline(sign * fitted.factor * line.bound, color=look["color"], **BOUND)
        for place in (fitted.factor * x for x in line.ends if fitted.low <= fitted.factor * x <= fitted.high):
            axes.axhline(place, color=look["color"], **END_OF_RANGE)
    over_time(axes, t, panel.title, f"{panel.symbol} ({fitted.unit})", fitted)
    legend_above(axes, 0.8 * len(axes.get_subplotspec().colspan) / GRID * axes.figure.bbox.width)


def _key(axes: Axes, run: Run, shown: list[Panel], arm: bool) -> None:
    """What colours and styles mean, for all panels, in a strip of its own."""
    links, lines = link_names(run), [line for panel in shown for line in panel.lines]
    n, every = len(links), (run.t[-1] - run.t[0]) / (POSTURES - 1)
    entries: list[tuple[str, dict]] = [
        (name, dict(color=color(i, n))) for i, name in enumerate(links) if n <= len(PALETTE)
    ]
    for style, word in zip(STYLES[1:], ("second", "third", "fourth"), strict=True):
        if any(_style(line) == style and _on_scale(line, n) for line in lines):
            entries.append((f"{word} axis or mode of a link", dict(linestyle=style)))
    if any(line.goal is not None for line in lines):
        entries.append(("set point", GOAL))
    if any(np.isfinite(line.bound) for line in lines):
        entries.append(("limit of the drive" if any(".force[" in x for x in run.tau_names) else "torque limit", BOUND))
    if any(np.isfinite(line.ends).any() for line in lines):
        entries.append(("limit of the joint", END_OF_RANGE))
    entries.append(("path of the tip", PATH))
    entries += [(name, MARK | dict(color=shade)) for name, shade in (("its start", START), ("its end", END))]
    if arm:
        entries.append((f"the arm before, every {every:.3g} s", EARLIER))
    handles = [Line2D([], [], label=name, **{"color": GREY} | style) for name, style in entries]
    axes.axis("off")
    fitted_legend(axes, handles, 0.95 * SPACE[1] / GRID * axes.figure.bbox.width, loc="center")


def _links(out: Figure, n: int) -> None:
    """The link's number as a colour bar."""
    shades = ScalarMappable(Normalize(1, n), colormaps["viridis"])
    ticks = sorted({round(x) for x in np.linspace(1, n, 6)})
    out.colorbar(shades, ax=out.axes, label="link, from base to tip", ticks=ticks, pad=0.01, aspect=60)


def _space(axes: Axes, run: Run, model: RobotModel | None) -> None:
    """The arm in some postures and the path of its tip, true to scale; without a model the path alone."""
    path = run.tip_position[np.linspace(0, len(run.t) - 1, min(len(run.t), 2000)).round().astype(int)]
    axes.plot(*path.T, **PATH)
    for place, shade in ((path[:1], START), (path[-1:], END)):
        axes.plot(*place.T, color=shade, zorder=5, **MARK)
    points = [path]
    if model is not None:
        rows = np.searchsorted(run.t, np.linspace(run.t[0], run.t[-1], POSTURES)).clip(0, len(run.t) - 1)
        postures = np.array([centrelines(model, run.q[row], STATIONS) for row in rows])
        starts = [postures[-1, 0, 0]] if model.chain.base_v else feet(model)
        _arm(axes, [strands(model, posture) for posture in postures], starts)
        points += [postures.reshape(-1, 3), np.array(starts)]
    cloud = np.concatenate(points)
    _, size, direction = np.linalg.svd(cloud - cloud.mean(axis=0), full_matrices=False)
    elevation, azimuth = look.view(size[0] * direction[0], size[1] * direction[1])
    axes.view_init(elev=elevation, azim=azimuth)
    what = "The path of the tip" if model is None else "The arm and the path of its tip"
    what += f", {link_names(run)[-1]}" if model is not None and len(model.chain.tree.leaves) > 1 else ""
    look.fit(axes, cloud, f"{what}, true to scale")


def _arm(axes: Axes, postures: list[list[np.ndarray]], starts: list[np.ndarray]) -> None:
    """The strands of postures: the earlier ones pale, the last one link by link in their colours; where they start."""
    for posture in postures[:-1]:
        for strand in posture:
            axes.plot(*strand.T, **EARLIER)
            axes.plot(*strand[1:2].T, "o", color=PALE, markersize=3)
    for i, strand in enumerate(postures[-1]):
        axes.plot(*strand.T, color=color(i, len(postures[-1])), linewidth=2.4)
        axes.plot(*strand[1:2].T, "o", color=color(i, len(postures[-1])), markersize=4.5)
    axes.plot(*np.array(starts).T, "s", color=INK, markersize=7, linestyle="none")
