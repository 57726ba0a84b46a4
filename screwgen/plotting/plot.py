"""The figure of a run: the arm in space, its angles, torques, modes, wrenches, energy and tip position over time."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from scipy.spatial.transform import Rotation

from ..simulation.motion import centrelines, modal_columns, tip_deflections, twist
from ..simulation.runs import Run, check_output, outputs
from ..spec.modes import DIRECTIONS
from ..spec.reduced import ELASTIC
from ..spec.segments import owner
from . import look
from .curves import NOTHING, over_time, scale, thin
from .demands import axis_word, bounds_of, place_names, set_points
from .look import GREY, INK, PALE, PALETTE, STYLES, canvas, filled, fitted_legend, legend_above, styled
from .strands import feet, strands

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..model import Model

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


AXES = (".joint[", ".slide[", ".torque[", ".force[")
"""What the names of joint axes' quantities have."""
TIPS = (
    ("Deflection of tips in y", "y", ("bending_y", "shear_y", ELASTIC)),
    ("Deflection of tips in z", "z", ("bending_z", "shear_z", ELASTIC)),
    ("Elongation", "x", ("axial", ELASTIC)),
)
"""Title, axis of the link, and the directions of modes that move the tip along it."""


class Line(NamedTuple):
    """A curve over time with colour, style and label, and the goal and the bound that are drawn with it."""

    values: np.ndarray
    color: Any
    style: str = "-"
    label: str | None = None
    goal: np.ndarray | None = None
    bound: float | None = None
    ends: Sequence[float] = ()
    """The limits of a joint axis, infinite where there is none."""


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


@styled
def figure(run: Run, model: Model | None = None, controller: Any = None) -> Figure:
    """The figure of a run; quantities that are always zero are named, not drawn.

    `model`: that of the run, to draw the arm, and the displacements of tips in place of modal coordinates.
    Displacements, forces and moments are along the axes of their links. `controller`: its set points
    (`reference(t)`) and torque limits (`tau_max`) are drawn where it states them.
    """
    shown, silent = sift(panels(run, controller, model))
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
        _curves(out.add_subplot(cell), panel, run.t)
    space = grid[: SPACE[0], : SPACE[1] if shown else GRID].subgridspec(2, 1, height_ratios=(8, 1))
    room = look.rooms(out, [space[0]])
    _key(out.add_subplot(space[1]), run, shown, model is not None)
    if len(link_names(run)) > len(PALETTE):
        _links(out, len(link_names(run)))
    for axes in look.into_space(out, room):
        _space(axes, run, model)
    return out


def save(run: Run, path: str | os.PathLike[str], model: Model | None = None, controller: Any = None) -> None:
    """Write the figure as a .png file, the same bytes every time; arguments as of `figure`. Raises UsageError."""
    check_output(path, (".png",))
    with outputs(path) as (stream,):
        stream.write(png(run, model, controller))


def png(run: Run, model: Model | None = None, controller: Any = None) -> bytes:
    """The figure as PNG, without date or version; arguments as of `figure`."""
    return look.png(figure(run, model, controller))


# ------------------------------------------------------------------------------ what is shown


def panels(run: Run, controller: Any = None, model: Model | None = None) -> list[Panel]:
    """The panels over time, link by link within each; a unit lacks its prefix, which depends on the size."""
    kinetic, potential = run.energy.T
    energy = [Line(kinetic, PALETTE[0], label="kinetic"), Line(potential, PALETTE[1], label="potential")]
    energy.append(Line(kinetic + potential, INK, "--", "total"))
    lines = partial(_lines, run, model)
    q, tau = partial(lines, run.q, run.q_names), partial(lines, run.tau, run.tau_names)
    goals, bounds = set_points(run, model, controller), bounds_of(run, model, controller)
    turns = np.array([".torque[" in name for name in run.tau_names], bool)
    ends = None if model is None else model.chain.limits
    turning = np.array([".joint[" in name for name in run.q_names if ".joint[" in name or ".slide[" in name], bool)
    rotors = any(".theta[" in name for name in run.q_names) or (model is not None and bool(model.chain.linked))
    pushed = {name.replace(".force[", ".joint[") for name in run.tau_names if ".force[" in name} & set(run.q_names)
    forces = "Forces of drives" if pushed else "Forces on slides"
    place = [Line(x, shade, "-", name) for name, x, shade in zip("xyz", run.tip_position.T, PALETTE, strict=False)]
    return [
        *_base(run),
        Panel("Joint angles", "q", "rad", _with(_with(q(".joint["), "goal", goals, turning), "ends", ends, turning)),
        Panel("Slides", "q", "m", _with(_with(q(".slide["), "goal", goals, ~turning), "ends", ends, ~turning)),
        Panel("Rotor angles", "θ", "rad", q(".theta[")),
        Panel("Rotors ahead of their cranks", "e", "rad", q(".gear[")),
        Panel("Rotors ahead of their cylinders", "e", "m", q(".stretch[")),
        Panel("Torques" if rotors else "Joint torques", "τ", "N·m", _with(tau(".torque["), "bound", bounds, turns)),
        Panel(forces, "f", "N", _with(tau(".force["), "bound", bounds, ~turns)),
        *(_tips(run, model) if model else _modes(q)),
        *_wrenches(run),
        Panel("Energy", "E", "J", energy),
        Panel("Tip, inertial frame", "r", "m", place),
    ]


def _base(run: Run) -> list[Panel]:
    """Where a floating base is, and how it has turned since the start: rotation vectors in inertial axes."""
    if not place_names(run):
        return []
    turns = Rotation.from_quat(run.q[:, 3:7], scalar_first=True)
    turned = (turns * turns[0].inv()).as_rotvec()
    place, turn = (
        [Line(x, shade, "-", name) for name, x, shade in zip("xyz", values.T, PALETTE, strict=False)]
        for values in (run.q[:, :3], turned)
    )
    return [Panel("Base, inertial frame", "r", "m", place), Panel("Turn of the base", "θ", "rad", turn)]


def sift(given: list[Panel]) -> tuple[list[Panel], list[str]]:
    """The panels with something to show, and the titles of those that are zero throughout."""
    full = [panel for panel in given if panel.lines]
    return [p for p in full if p.largest > NOTHING], [p.title.lower() for p in full if p.largest <= NOTHING]


def link_names(run: Run) -> list[str]:
    """The names of the links, base to tip."""
    return list(dict.fromkeys(map(owner, run.wrench_names)))


def color(link: int, n: int) -> tuple | str:
    """The colour of a link: by name while there are few, on a scale from base to tip when there are many."""
    return PALETTE[link % len(PALETTE)] if n <= len(PALETTE) else colormaps["viridis"](0.95 * link / (n - 1))


def _lines(run: Run, model: Model | None, values: np.ndarray, names: tuple[str, ...], part: str) -> list[Line]:
    """The columns whose name has `part` after the link's, in the link's colour; the style counts those of a link."""
    links, given = link_names(run), {x.name: x for x in model.robot.links} if model else {}
    found: list[tuple] = [(k, *name.split(part)) for k, name in enumerate(names) if part in name]
    out = []
    for k, link, member in found:
        i, own, number = links.index(owner(link)), owner(link), int(member[:-1])
        word = axis_word(given[own], number) if part in AXES and own in given else str(number + 1) if number else ""
        label = _few(f"{own} {word}".strip(), len(links))
        out.append(Line(values[:, k], color(i, len(links)), STYLES[number % len(STYLES)], label))
    return out


def _modes(q: Callable[[str], list[Line]]) -> list[Panel]:
    """The modal coordinates of a run whose model is not at hand."""
    titles = {d: f"Modes, {d.replace('_', ' in ')}" for d in DIRECTIONS} | {ELASTIC: "Modes of bodies from files"}
    units = {"torsion": "rad"}
    return [Panel(title, "η", units.get(d, "m"), q(f".eta.{d}[")) for d, title in titles.items()]


def _tips(run: Run, model: Model) -> list[Panel]:
    """How far the tips of flexible links are from those of the undeformed links, and how far they are twisted."""
    tips, names, n = tip_deflections(model, run.q), [x.name for x in model.robot.links], len(link_names(run))
    has = lambda i, kinds: any(modal_columns(model, i, kind) for kind in kinds)  # noqa: E731
    named = lambda i, values: Line(values, color(i, n), "-", _few(names[i], n))  # noqa: E731
    moved = [
        Panel(title, f"$u_{axis}$", "m", [named(i, u[:, "xyz".index(axis)]) for i, u in tips.items() if has(i, kinds)])
        for title, axis, kinds in TIPS
    ]
    twisted = [named(i, twist(model, run.q, i, [1.0])[:, 0]) for i in tips if has(i, ("torsion",))]
    return [*moved, Panel("Twist of tips", "φ", "rad", twisted)]


def _wrenches(run: Run) -> list[Panel]:
    """The forces and moments at the bases of links, each along an axis of its link, with their signs."""
    joints = [i for i, name in enumerate(run.wrench_names[::6]) if owner(name) == name.rpartition(".")[0]]
    names, n = link_names(run), len(joints)
    return [
        Panel(f"Joint {what}s in {axis}", f"${letter}_{axis}$", unit, [
            Line(run.wrench[:, i, row + k], color(j, n), "-", _few(names[j], n)) for j, i in enumerate(joints)
        ])
        for what, letter, unit, row in (("force", "F", "N", 3), ("moment", "M", "N·m", 0))
        for k, axis in enumerate("xyz")
    ]  # fmt: skip


def _few(name: str, n: int) -> str | None:
    """The name of a curve beside its panel's title, unless links are so many that their colours are a scale."""
    return name if n <= len(PALETTE) else None


def _with(lines: list[Line], field: str, values: np.ndarray | None, chosen: np.ndarray) -> list[Line]:
    """The lines with one field each from the `chosen` ones of `values`, one per joint axis, if there are any."""
    if values is None or len(values) != len(chosen):
        return lines
    return [line._replace(**{field: value}) for line, value in zip(lines, values[chosen], strict=True)]


# ------------------------------------------------------------------------------ how it is drawn


def _headline(run: Run) -> str:
    steps = len(run.t) - 1
    return f"{run.name}: {run.t[-1]:g} s in {steps} step{'s' if steps != 1 else ''}"


def _curves(axes: Axes, panel: Panel, t: np.ndarray) -> None:
    goals = [line.goal for line in panel.lines if line.goal is not None]
    bounds = [line.bound for line in panel.lines if line.bound is not None]
    ends = [x for line in panel.lines for x in line.ends]
    fitted = scale(t, [line.values for line in panel.lines] + goals, panel.unit, bounds, ends)
    for line in panel.lines:
        for values, options in (
            (line.goal, GOAL | {"linestyle": line.style}),
            (line.values, {"linestyle": line.style, "label": line.label}),
        ):
            if values is not None:
                x, y = thin(t, values)
                axes.plot(x, fitted.factor * y, color=line.color, **options)
        if line.bound is not None:
            for sign in (-1, 1):
                axes.axhline(sign * fitted.factor * line.bound, color=line.color, **BOUND)
        for place in (fitted.factor * x for x in line.ends if fitted.low <= fitted.factor * x <= fitted.high):
            axes.axhline(place, color=line.color, **END_OF_RANGE)
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
        if any(line.style == style and line.label is None for line in lines):
            entries.append((f"{word} axis or mode of a link", dict(linestyle=style)))
    if any(line.goal is not None for line in lines):
        entries.append(("set point", GOAL))
    if any(line.bound is not None for line in lines):
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


def _space(axes: Axes, run: Run, model: Model | None) -> None:
    """The arm in some postures and the path of its tip, true to scale; without a model the path alone."""
    path = run.tip_position[np.linspace(0, len(run.t) - 1, min(len(run.t), 2000)).round().astype(int)]
    axes.plot(*path.T, **PATH)
    for place, shade in ((path[:1], START), (path[-1:], END)):
        axes.plot(*place.T, color=shade, zorder=5, **MARK)
    points = [path]
    if model is not None:
        rows = np.searchsorted(run.t, np.linspace(run.t[0], run.t[-1], POSTURES)).clip(0, len(run.t) - 1)
        postures = np.array([centrelines(model, run.q[row], STATIONS) for row in rows])
        starts = [postures[-1, 0, 0]] if model.chain.floating else feet(model)
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
