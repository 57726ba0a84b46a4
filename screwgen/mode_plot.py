"""Mode shapes of an arm in its posture as a picture: a view in space per mode, the arm at rest behind it."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from .errors import UsageError
from .modes import ModeShapes, stiffness
from .motion import displacements
from .plot import GREY, LOOK, PALETTE, equal_scales

if TYPE_CHECKING:
    from .build import Model

MOST, COLUMNS, PANEL = 6, 3, (4.2, 3.9)
STATIONS = np.linspace(0.0, 1.0, 25)
"""Places along a link at which it is drawn, base to tip."""
AMPLITUDE = 0.15
"""The largest displacement drawn, over the size of the arm."""
STEP = 1e-6
"""m: the displacement from which the linear one is taken."""
VIEWS = ((22.0, -58.0), (22.0, 32.0), (55.0, -58.0), (55.0, 32.0))
REST, MOVED, OTHER = "#a0aec0", PALETTE[0], "#90cdf4"
WORDS = {"axial": "axial", "bending_y": "bending in y", "bending_z": "bending in z", "torsion": "torsion"}


def png(model: Model, q: np.ndarray, found: ModeShapes) -> bytes:
    """The picture as PNG, the same bytes every time, without date or version."""
    stream = io.BytesIO()
    with rc_context(LOOK):
        figure(model, q, found).savefig(stream, format="png", dpi=150, metadata={"Software": None})
    return stream.getvalue()


def figure(model: Model, q: np.ndarray, found: ModeShapes) -> Figure:
    """The lowest modes, up to six of them; raises UsageError where there are none."""
    count = min(len(found.frequencies), MOST)
    if not count:
        raise UsageError("there are no modes to draw: every link is rigid and no joint has a spring; leave out --plot")
    rest = centrelines(model, q)
    rows, columns = -(-count // COLUMNS), min(count, COLUMNS)
    with rc_context(LOOK):
        out = Figure(figsize=(columns * PANEL[0] + 0.2, rows * PANEL[1] + 0.9))
        FigureCanvasAgg(out)
        for k in range(count):
            axes = out.add_subplot(rows, columns, k + 1, projection="3d")
            _panel(axes, rest, amplified(rest, field(model, q, found.shapes[:, k])))
            place = dict(transform=axes.transAxes, ha="center")
            axes.text2D(0.5, 1.05, f"{k + 1}: {found.frequencies[k]:.4g} Hz", weight="bold", size=10, **place)
            axes.text2D(0.5, 0.99, meaning(model, found.shapes[:, k]), color=GREY, **place)
        sides = dict(left=0.02, right=0.95, wspace=0.08, hspace=0.16)
        out.subplots_adjust(bottom=0.16 / rows, top=1 - 0.2 / rows, **sides)
        more = f", the lowest {count} of {len(found.frequencies)} modes" if count < len(found.frequencies) else ""
        out.suptitle(f"Mode shapes of {model.robot.name}{more}", fontsize=12, fontweight="bold")
        out.text(0.99, 0.99, "each mode from the side that shows it", ha="right", va="top", color=GREY, fontsize=8)
        _legend(out)
    return out


# ------------------------------------------------------------------------------ what moves


def centrelines(model: Model, q: np.ndarray) -> np.ndarray:
    """The centrelines (n, stations, 3) of all links in the inertial frame, m."""
    R, r = model.numpy().link_pose(q)
    lines = []
    for i, link in enumerate(model.robot.links):
        place = displacements(model, q[None], i, STATIONS)[0]
        place[:, 0] += link.length * STATIONS - (link.frame_at or 0.0)
        lines.append(r[i] + place @ R[i].T)
    return np.array(lines)


def field(model: Model, q: np.ndarray, shape: np.ndarray) -> np.ndarray:
    """The displacements (n, stations, 3) of the centrelines, m, linear in the mode, of arbitrary size."""
    small = STEP / np.max(np.abs(shape))
    there, back = centrelines(model, q + small * shape), centrelines(model, q - small * shape)
    return (there - back) / (2 * STEP)


def amplified(rest: np.ndarray, motion: np.ndarray) -> np.ndarray:
    """`motion` with its largest displacement in proportion to the arm; its greatest component positive."""
    size = np.linalg.norm(np.ptp(rest.reshape(-1, 3), axis=0))
    largest = motion.reshape(-1, 3)[np.argmax(np.linalg.norm(motion, axis=2))]
    length = np.linalg.norm(largest)
    if length < 1e-9:
        return np.zeros_like(motion)
    return motion * np.copysign(AMPLITUDE * size / length, largest[np.argmax(np.abs(largest))])


def meaning(model: Model, shape: np.ndarray) -> str:
    """Where most of a mode's strain energy is: `bending in z of upper_arm`, with its share."""
    energies: dict[str, float] = {}
    for name, energy in zip(model.q_names, stiffness(model) * shape**2, strict=True):
        link, kind, *direction = name.partition("[")[0].split(".")
        what = f"{WORDS[direction[0]]} of {link}" if kind == "eta" else f"joint spring of {link}"
        energies[what] = energies.get(what, 0.0) + energy
    what = max(energies, key=energies.__getitem__)
    return f"{what}, {100 * energies[what] / sum(energies.values()):.0f} % of its energy"


# ------------------------------------------------------------------------------ how it is drawn


def _panel(axes, rest: np.ndarray, motion: np.ndarray) -> None:
    for share, color, width in ((-1.0, OTHER, 0.9), (0.0, REST, 1.6), (1.0, MOVED, 1.8)):
        line = rest + share * motion
        axes.plot(*line.reshape(-1, 3).T, color=color, linewidth=width)
        if share >= 0:
            axes.plot(*line[:, 0].T, "o", color=color, markersize=4.5, linestyle="none")
            axes.plot(*line[-1, -1], "D", color=color, markersize=5)
    points = np.concatenate([rest + motion, rest - motion]).reshape(-1, 3)
    equal_scales(axes, points, label_pad=-4, tick_pad=-2, size=7, zoom=0.9)
    elevation, azimuth = view(rest, motion)
    axes.view_init(elev=elevation, azim=azimuth)


def view(rest: np.ndarray, motion: np.ndarray) -> tuple[float, float]:
    """Elevation and azimuth, degrees, of those in `VIEWS` from which the motion covers the largest area."""
    along, moved = np.diff(rest, axis=1), motion[:, 1:]

    def area(angles: tuple[float, float]) -> float:
        up, round_ = np.radians(angles)
        eye = [np.cos(up) * np.cos(round_), np.cos(up) * np.sin(round_), np.sin(up)]
        return float(np.abs(np.cross(along, moved) @ eye).sum())

    areas = [area(angles) for angles in VIEWS]
    first_good = next(k for k, a in enumerate(areas) if a >= 0.8 * max(areas))
    return VIEWS[first_good]


def _legend(out: Figure) -> None:
    mark = lambda marker: dict(marker=marker, linestyle="none", color=GREY, markersize=5)  # noqa: E731
    handles = [
        Line2D([], [], color=REST, linewidth=1.6, label="at rest"),
        Line2D([], [], color=MOVED, linewidth=1.8, label="mode, enlarged"),
        Line2D([], [], color=OTHER, linewidth=0.9, label="half a period later"),
        Line2D([], [], label="joint", **mark("o")),
        Line2D([], [], label="tip", **mark("D")),
    ]
    out.legend(handles=handles, loc="lower center", ncols=5, bbox_to_anchor=(0.5, 0.005))
