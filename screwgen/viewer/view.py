"""The viewer's front door: runs, their files and mode shapes, as pages."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algorithms.robot_function import entries
from ..algorithms.robot_functions import reported
from ..errors import RobotFileError, UsageError
from ..files import sound
from ..interchange.load import ImportNote
from ..model import Model, derive
from ..plotting.mode_plot import STATIONS, STEP, amplified, displaced, field, meaning
from ..simulation.motion import centrelines
from ..simulation.runs import ARRAYS, NAMES, NEEDED, Run, run_arrays
from ..spec.load import loads, one_line
from ..spec.robot import Robot
from ..studies.modes import ModeShapes
from .meshes import Looks, read_looks
from .page import View, mode_clip, page, run_page
from .scene import scene

MOST_RUNS, MOST_MODES = 2, 12
PHASES = np.linspace(0.0, 1.0, 49)
"""Of a period, at which a mode is stored."""
TURN = 0.35
"""The largest turn of a tip in a mode, rad."""


def view(
    *runs: Run,
    robot: Robot | None = None,
    labels: Sequence[str] = (),
    meshes: str | os.PathLike[str] | Looks | None = None,
) -> View:
    """The page of a run, in which a second one is a ghost: a View, to be saved or shown in a notebook.

    `robot`: that of runs which do not know theirs, such as one read from a file of an older version; `labels`: what the
    runs are called; `meshes`: the URDF from which the robot came, whose visuals are then drawn in place of tubes; what
    of it cannot be read is an ImportNote each. Raises UsageError, and RobotFileError for the URDF.
    """
    return run_page(modelled(runs, robot, labels), worn(meshes))


def worn(meshes: str | os.PathLike[str] | Looks | None) -> Looks | None:
    """The visuals of a URDF, with a warning for each that cannot be read."""
    if meshes is None or isinstance(meshes, Looks):
        return meshes
    found = read_looks(meshes)
    for note in found.notes:
        warnings.warn(f"{found.file}: {note}", ImportNote, stacklevel=3)
    return found


def modelled(runs: Sequence[Run], robot: Robot | None, labels: Sequence[str]) -> list[tuple[Run, Model, str]]:
    """Each run with its model and what it is called; arguments as of `view`."""
    if not 1 <= len(runs) <= MOST_RUNS:
        raise UsageError(f"there are {len(runs)} runs to view; give one, or two to have the second as a ghost")
    names = [*labels, *(f"run {k + 1}" for k in range(len(labels), len(runs)))]
    return [(run, _model(run, robot, name), name) for run, name in zip(runs, names, strict=False)]


def _model(run: Run, robot: Robot | None, name: str) -> Model:
    """The model of a run's robot, with the coordinates that the run has."""
    own = run.robot if run.robot is not None else robot
    if own is None:
        raise UsageError(
            f"{one_line(name)}: does not know its robot; name the robot's file by --robot, robot=… in Python"
        )
    model = derive(own)
    if tuple(run.q_names) != tuple(model.q_names) or tuple(run.tau_names) != tuple(model.tau_names):
        pairs = zip([*run.q_names, "no more"], [*model.q_names, "no more"], strict=False)
        here, there = next((pair for pair in pairs if pair[0] != pair[1]), ("other torques", "its own"))
        raise UsageError(f"{one_line(name)}: is a run of another robot: it has {here} where '{own.name}' has {there}")
    shapes = {"q": (model.nq,), "v": (model.chain.nvz,), "tau": (model.n_tau,), "wrench": (model.n_links, 6)}
    shapes |= {"tip_position": (3,), "t": ()}
    shapes |= {row.name: (entries(row, model.chain),) for row in reported(model.chain) if row.name in run.reports}
    shapes |= {} if run.w_ext is None else {"w_ext": (model.n_links, 6)}
    for key, shape in shapes.items():
        found = np.asarray(getattr(run, key))
        if found.shape != (len(run.t), *shape) or not len(run.t):
            raise UsageError(f"{one_line(name)}: {key} has the shape {found.shape}; it must be (samples, *{shape})")
        if not sound(found):
            raise UsageError(f"{one_line(name)}: {key} holds numbers that are not finite; simulate again")
    if (np.diff(run.t) < 0).any():
        raise UsageError(f"{one_line(name)}: t falls; times must rise")
    wanted = len(model.parameter_values)
    if run.parameters is not None and np.shape(run.parameters) != (wanted,):
        said = f"parameters has the shape {np.shape(run.parameters)}; '{own.name}' has {wanted} parameters"
        raise UsageError(f"{one_line(name)}: {said}")
    return model


def read_run(path: str | os.PathLike[str], robot: Robot | None = None) -> Run:
    """The run in a .npz file, with its robot if the file has it, else `robot`; raises UsageError."""
    shown = one_line(os.fsdecode(path))
    with run_arrays(path) as stored:
        arrays: dict[str, Any] = {name: stored.numbers(name) for name in ARRAYS if name in stored or name in NEEDED}
        names: dict[str, Any] = {name: stored.texts(name) for name in NAMES}
        text = "".join(stored.texts("robot")) if "robot" in stored else None
        more: dict[str, Any] = {name: stored.numbers(name) for name in ("parameters", "w_ext") if name in stored}
        texts = [stored.texts(key) if key in stored else () for key in ("quantity_names", "quantity_units")]
    more["quantity_units"] = dict(zip(*texts, strict=False))
    if (found := arrays.get("force_quantities")) is not None and found.shape[1:] != (len(more["quantity_units"]),):
        raise UsageError(f"{shown}: force_quantities has the shape {found.shape}, and its names are {len(texts[0])}")
    if robot is None and text is not None:
        try:
            robot = loads(text, shown, os.path.dirname(os.fspath(path)))
        except RobotFileError as error:
            raise UsageError(f"{error}; name the robot's file by --robot") from None
    name = robot.name if robot is not None else ""
    return Run.of(name, arrays, **names, robot=robot, **more)


def view_modes(model: Model, q: np.ndarray, found: ModeShapes) -> View:
    """The page of the lowest vibrations about the posture `q` (nq,), enlarged, with the arm at rest as a ghost."""
    count = min(len(found.frequencies), MOST_MODES)
    if not count:
        raise UsageError("there are no modes to view: every link is rigid and no joint has a spring; leave out --view")
    rest, clips = centrelines(model, q, STATIONS), []
    for k in range(count):
        shape = found.shapes[:, k]
        change = _enlarged(model, q, shape / np.abs(shape).max(), rest)
        motion = np.array([displaced(model, q, np.sin(2 * np.pi * x) * change) for x in PHASES])
        clips.append(mode_clip(f"{k + 1}: {found.frequencies[k]:.4g} Hz, {meaning(model, shape)}", PHASES, motion))
    clips.append(mode_clip("at rest", PHASES[[0, -1]], np.array([q, q])))
    return page(f"Modes of {model.robot.name}", [scene(model)], clips, len(clips) - 1, "modes")


def _enlarged(model: Model, q: np.ndarray, shape: np.ndarray, rest: np.ndarray) -> np.ndarray:
    """The change of coordinates (nv,) at the peak of a mode: as large as figures have it, but no tip turns by more than
    `TURN`, beyond which the arm would not move as the mode says."""
    small = field(model, q, shape)
    sizes = [
        float(np.linalg.norm([np.linalg.norm(x.motion), *map(np.linalg.norm, x.turns.values())]))
        for x in (amplified(rest, small), small)
    ]
    R, moved = (model.numpy().tip_poses(x)[0] for x in (q, displaced(model, q, STEP * shape)))
    turn = float(np.linalg.norm(moved - R, axis=(1, 2)).max()) / np.sqrt(2) / STEP
    factor = min(sizes[0] / max(sizes[1], 1e-300), TURN / max(turn, 1e-300))
    return factor * shape
