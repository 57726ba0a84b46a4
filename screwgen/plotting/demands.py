"""What is asked of the axes of a run, where a controller states it: set points, limits of torques; names of axes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..robot_model import RobotModel
from ..simulation.inputs import started
from ..simulation.runs import Run
from ..spec.base import POSE
from ..spec.robot import Link
from .curves import MOST_POINTS


def place_names(run: Run) -> list[str]:
    """The names of a floating base's coordinates; none of a fixed one."""
    return [name for name in run.q_names if name.removeprefix("base.") in POSE]


def axis_word(link: Link, axis: int) -> str:
    """Which of the axes of a link's joint it is: about what it turns, along what it slides; empty of a single one."""
    screws = link.joint.screws
    if len(screws) < 2:
        return ""
    way = np.abs(screws[axis].axis)
    return "xyz"[int(way.argmax())] if np.isclose(way.max(), np.linalg.norm(way)) else f"axis {axis + 1}"


def set_points(run: Run, model: RobotModel | None, controller: Any) -> np.ndarray | None:
    """The set points (n_joints, N), rad and m, at the samples of a run; None of a controller that states none."""
    law = _started(run, model, controller)
    if not hasattr(law, "reference"):
        return None
    times = np.linspace(run.t[0], run.t[-1], min(len(run.t), MOST_POINTS))
    return np.array([np.interp(run.t, times, x) for x in np.transpose([law.reference(t)[0] for t in times])])


def bounds_of(run: Run, model: RobotModel | None, controller: Any) -> np.ndarray | None:
    """The limits of torques and forces (n_tau,), N·m and N, of a controller that states them, else of the robot file.

    Infinite where there is none; None where no axis has one.
    """
    law = _started(run, model, controller)
    bounds = getattr(law, "bounds", getattr(law, "tau_max", None))
    if bounds is None and model is not None and np.isfinite(model.chain.most("effort")).any():
        bounds = np.append(model.chain.most("effort"), np.full(model.n_tau - model.n_joints, np.inf))
    return None if bounds is None else np.array(bounds, float)


def _started(run: Run, model: RobotModel | None, controller: Any) -> Any:
    return started(controller, run.q[0] if model else run.q[0, len(place_names(run)) :], model)
