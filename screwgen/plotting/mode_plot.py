"""The figure of an arm's mode shapes: one spatial view per mode, with the arm at rest behind it.

Links with torsion modes carry cross-sections, which turn as the sections do.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from scipy.spatial.transform import Rotation

from ..backends.numpy.dae_step import SERIES
from ..backends.numpy.rest_shape import link_at_rest
from ..errors import UsageError
from ..robot_model import RobotModel
from ..simulation.motion import centrelines, modal_columns, twist
from ..spec.modes import DIRECTIONS
from ..spec.parameters import changes
from ..spec.reduced import ELASTIC
from ..spec.segments import owner
from ..studies.modes import ModeShapes
from ..studies.stiffness import stiffness_matrix
from . import look
from .look import GREY, PALE, PALETTE, canvas, filled, fit, fitted_legend, into_space, rooms, styled, view
from .strands import strands

if TYPE_CHECKING:
    from matplotlib.axes import Axes


MOST, COLUMNS, GRID, PANEL = 6, 3, 6, (4.4, 3.8)
STATIONS = np.linspace(0.0, 1.0, 25)
"""Places along a link at which it is drawn, base to tip."""
SPARSE, DENSE = 12, 4
"""Stations from one cross-section to the next, for many links with sections and for at most two."""
AMPLITUDE, TURN = 0.15, 0.7
"""The largest displacement drawn, over the size of the arm, or the largest turn of a section, rad."""
WIDTH = 0.025
"""Half a side of a cross-section, over the size of the arm."""
STEP = 1e-6
"""m: the displacement from which the linear one is taken."""
REST, MOVED, OTHER = PALE, PALETTE[0], "#90cdf4"
WORDS = {direction: direction.replace("_", " in ") for direction in DIRECTIONS} | {ELASTIC: "modes"}


class ModeMotion(NamedTuple):
    """The motion of an arm in a mode: of the centrelines and, for links with torsion modes, of their sections."""

    motion: np.ndarray
    """(n, stations, 3) m."""
    turns: dict[int, np.ndarray]
    """Of each link with torsion modes (stations,) rad: about its centreline."""

    def scaled(self, factor: float) -> ModeMotion:
        """The shape, larger."""
        return ModeMotion(factor * self.motion, {i: factor * turn for i, turn in self.turns.items()})


def png(model: RobotModel, q: np.ndarray, found: ModeShapes) -> bytes:
    """The picture as PNG, the same bytes every time, without date or version."""
    return look.png(figure(model, q, found))


@styled
def figure(model: RobotModel, q: np.ndarray, found: ModeShapes) -> Figure:
    """The lowest modes, up to six of them; raises UsageError where there are none."""
    count = min(len(found.frequencies), MOST)
    if not count:
        raise UsageError("there are no modes to draw: every link is rigid and no joint has a spring; leave out --plot")
    rest, frames = centrelines(model, q, STATIONS), _frames(model, q)
    rows = -(-count // COLUMNS)
    more = f", the lowest {count} of {len(found.frequencies)} modes" if count < len(found.frequencies) else ""
    out = canvas(-(-count // rows) * PANEL[0], rows * PANEL[1] + 0.8, f"Mode shapes of {model.robot.name}{more}")
    spaces = rooms(out, filled(out.add_gridspec(rows, GRID), count, COLUMNS))
    _legend(out, any(modal_columns(model, i, "torsion") for i in range(len(model.robot.links))))
    for k, axes in enumerate(into_space(out, spaces)):
        shape, title = found.shapes[:, k], f"{k + 1}: {found.frequencies[k]:.4g} Hz"
        points = _draw(axes, model, rest, frames, amplified(rest, field(model, q, shape)))
        fit(axes, points, title, meaning(model, shape))
    return out


def _frames(model: RobotModel, q: np.ndarray) -> np.ndarray:
    """(n, stations, 3, 3): the axes of the links' sections, undeformed, as columns."""
    links, count = model.numpy().link_pose(q)[0][model.chain.firsts], range(len(model.robot.links))
    return np.array(
        [[R @ link_at_rest(model.chain, i, s)[0] for s in STATIONS] for i, R in zip(count, links, strict=True)]
    )


# ------------------------------------------------------------------------------ what moves


def field(model: RobotModel, q: np.ndarray, shape: np.ndarray) -> ModeMotion:
    """The motion of the arm, linear in the mode, of arbitrary size."""
    size = np.max(np.abs(shape))
    there, back = (displaced(model, q, sign * STEP / size * shape) for sign in (1, -1))
    motion = (centrelines(model, there, STATIONS) - centrelines(model, back, STATIONS)) / (2 * STEP)
    R, R_there, R_back = (model.numpy().link_pose(x)[0][model.chain.firsts] for x in (q, there, back))
    turns, turning = {}, np.append(np.zeros(model.nq - model.nv), shape / size)
    for i in range(len(model.robot.links)):
        if modal_columns(model, i, "torsion"):
            rolls = R[i].T @ (R_there[i] - R_back[i]) / (2 * STEP)
            turns[i] = rolls[2, 1] + twist(model, turning[None], i, STATIONS)[0]
    return ModeMotion(motion, turns)


def displaced(model: RobotModel, q: np.ndarray, change: np.ndarray) -> np.ndarray:
    """`q` (nq,) and a small change (nv,), which turns and moves a floating base along axes of its own."""
    chain = model.chain
    out = np.array(chain.integrate(q, np.append(np.zeros(chain.base_v), change[chain.base_v :]), SERIES))
    if chain.base_q:
        R = Rotation.from_quat(q[3:7], scalar_first=True)
        out[:3] += R.apply(change[3:6])
        out[3:7] = (R * Rotation.from_rotvec(change[:3])).as_quat(scalar_first=True)
    return out


def amplified(rest: np.ndarray, shape: ModeMotion) -> ModeMotion:
    """The shape scaled to the arm's size by its largest part, section or centreline, which is positive."""
    size = np.linalg.norm(np.ptp(rest.reshape(-1, 3), axis=0))
    largest = shape.motion.reshape(-1, 3)[np.argmax(np.linalg.norm(shape.motion, axis=2))]
    turns = np.concatenate([*shape.turns.values(), [0.0]])
    parts = np.array([largest[np.argmax(np.abs(largest))], turns[np.argmax(np.abs(turns))]])
    reach = np.array([np.linalg.norm(largest) / (AMPLITUDE * size), abs(parts[1]) / TURN])
    return shape.scaled(np.copysign(1 / reach.max(), parts[reach.argmax()]) if reach.max() > 1e-9 else 0.0)


def sections(line: np.ndarray, frame: np.ndarray, turn: np.ndarray, width: float) -> np.ndarray:
    """The corners (stations, 5, 3), m, of square sections across a centreline; the first corner closes the square.

    `line` (stations, 3), m; `frame` (stations, 3, 3), or of a straight link (3, 3): the axes of its sections at rest;
    `turn` (stations,) rad: about the centreline.
    """
    frame = np.array(np.broadcast_to(frame, (len(line), 3, 3)))
    tangent = np.gradient(line, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    up = Rotation.from_rotvec(turn[:, None] * frame[..., 0]).apply(frame[..., 1])
    up -= np.sum(up * tangent, axis=1, keepdims=True) * tangent
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    side = np.cross(tangent, up)
    return np.stack([line + width * (a * up + b * side) for a, b in ((1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1))], 1)


def meaning(model: RobotModel, shape: np.ndarray) -> str:
    """Where most of a mode's strain energy is: `bending in z of upper_arm`, with its share."""
    energies: dict[str, float] = {}
    first = model.chain.base_v
    energy_of = (shape * (stiffness_matrix(model) @ shape))[first:]
    for name, energy in zip(list(changes(model.robot))[first:], energy_of, strict=True):
        kind, *direction = name.partition(".")[2].partition("[")[0].split(".")
        what = f"{WORDS[direction[0]]} of {owner(name)}" if kind == "eta" else f"joint spring of {owner(name)}"
        energies[what] = energies.get(what, 0.0) + energy
    what = max(energies, key=energies.__getitem__)
    return f"{what}, {100 * energies[what] / sum(energies.values()):.0f} % of its energy"


# ------------------------------------------------------------------------------ how it is drawn


def _draw(axes: Axes, model: RobotModel, rest: np.ndarray, frames: np.ndarray, shape: ModeMotion) -> np.ndarray:
    """Draw the arm at rest and at both ends of the vibration; returns the points to frame, (N, 3) m."""
    points, width = [], WIDTH * np.linalg.norm(np.ptp(rest.reshape(-1, 3), axis=0))
    for share, color, weight in ((-1.0, OTHER, 0.9), (0.0, REST, 1.6), (1.0, MOVED, 1.8)):
        now = shape.scaled(share)
        line = rest + now.motion
        points.append(line)
        for strand in strands(model, line):
            axes.plot(*strand.T, color=color, linewidth=weight)
        if share >= 0:
            axes.plot(*line[:, 0].T, "o", color=color, markersize=4.5, linestyle="none")
            for node in model.chain.tree.leaves:
                axes.plot(*line[model.chain.segments[node - 1].link, -1], "D", color=color, markersize=5)
            for i, turn in now.turns.items():
                corners = sections(line[i], frames[i], turn, float(width))
                _sections(axes, corners, DENSE if len(now.turns) <= 2 else SPARSE, color)
                points.append(corners)
    elevation, azimuth = view(np.diff(rest, axis=1), shape.motion[:, 1:])
    axes.view_init(elev=elevation, azim=azimuth)
    return np.concatenate([x.reshape(-1, 3) for x in points])


def _sections(axes: Axes, corners: np.ndarray, step: int, color: str) -> None:
    """The edges along a link, and the squares across it."""
    for edge in range(4):
        axes.plot(*corners[:, edge].T, color=color, linewidth=0.6)
    for square in corners[::step]:
        axes.plot(*square.T, color=color, linewidth=0.9)


def _legend(out: Figure, torsion: bool) -> None:
    marks = [dict(marker="o", label="joint"), dict(marker="D", label="tip")]
    if torsion:
        marks.append(dict(marker="s", label="cross-section", fillstyle="none"))
    handles = [
        Line2D([], [], color=REST, linewidth=1.6, label="at rest"),
        Line2D([], [], color=MOVED, linewidth=1.8, label="mode, enlarged"),
        Line2D([], [], color=OTHER, linewidth=0.9, label="half a period later"),
        *(Line2D([], [], linestyle="none", color=GREY, markersize=5, **mark) for mark in marks),
    ]
    title = "each mode from the side that shows it"
    fitted_legend(out, handles, 0.95 * out.bbox.width, loc="outside lower center", title=title, title_fontsize=8)
