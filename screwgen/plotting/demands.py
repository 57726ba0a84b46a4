"""What a controller asks of a run and is bound by, where it states them: set points and limits of torques."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..simulation.inputs import started
from ..simulation.runs import Run
from ..spec.base import POSE
from .curves import MOST_POINTS

if TYPE_CHECKING:
    from ..model import Model


def place_names(run: Run) -> list[str]:
    """The names of a floating base's coordinates; none of a fixed one."""
    return [name for name in run.q_names if name.removeprefix("base.") in POSE]


def set_points(run: Run, model: Model | None, controller: Any) -> np.ndarray | None:
    """The set points (n_joints, N), rad and m, at the samples of a run; None of a controller that states none."""
    law = _started(run, model, controller)
    if not hasattr(law, "reference"):
        return None
    times = np.linspace(run.t[0], run.t[-1], min(len(run.t), MOST_POINTS))
    return np.array([np.interp(run.t, times, x) for x in np.transpose([law.reference(t)[0] for t in times])])


def bounds_of(run: Run, model: Model | None, controller: Any) -> np.ndarray | None:
    """The limits of torques and forces (n_tau,), N·m and N; None of a controller that states none."""
    law = _started(run, model, controller)
    bounds = getattr(law, "bounds", getattr(law, "tau_max", None))
    return None if bounds is None else np.array(bounds, float)


def _started(run: Run, model: Model | None, controller: Any) -> Any:
    return started(controller, run.q[0] if model else run.q[0, len(place_names(run)) :], model)
