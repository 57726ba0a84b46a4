"""How an arm arrives that plays a plan: what is left of its motion, and what the drives give."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import Given, seconds
from ..planning.drive_coordinates import DriveCoordinates
from ..planning.plan import MotionPlan, PlanWarning
from ..robot_model import RobotModel
from .played import Played
from .runs import Run
from .simulate import simulate

STEP, AFTER = 1e-3, 1.0
FULL = 1.0 - 1e-9
"""The share of a drive's limit from which on a sample counts as saturated."""


@dataclass(frozen=True, eq=False, repr=False)
class Arrival:
    """A plan as it was played, and how still the arm is behind its end."""

    run: Run
    residual: float
    """m: the diagonal of the box in which the tip moves behind the end of the plan."""
    effort: np.ndarray
    """(n_joints,): the largest torques, N·m, of slides and cylinders forces, N, of either sign; of elastic drives
    times the ratio."""
    saturated: int
    """Samples at which a drive gives all that it has."""
    joints: np.ndarray
    """(n_joints,): how far joints, of elastic drives rotors over the ratio, are from the goal at the end of the run."""
    rates: np.ndarray
    """(n_joints,): their largest rates, of either sign."""

    def __repr__(self) -> str:
        return f"<Arrival: tip within {self.residual * 1e3:.3g} mm, {self.line}>"

    @property
    def line(self) -> str:
        """Efforts and saturation in words."""
        share = f"{self.saturated} sample{'s' * (self.saturated != 1)} saturated"
        return f"largest torque {self.effort.max():.4g}, {share}"


def play(
    model: RobotModel,
    plan: MotionPlan,
    *,
    step: float = STEP,
    after: float = AFTER,
    parameters: Given = None,
    **ways: Any,
) -> Arrival:
    """Play a plan under its joint law, from rest on, and look at the arm for `after` seconds behind its end.

    `model`: the one that is planned for, or one that knows more, with the same joints. `step`: of the clock that plays;
    `ways`: what else :func:`simulate` takes. Raises UsageError.
    """
    p = model.chain.parameters.vector(parameters)
    duration = step * np.ceil((plan.time + seconds(after, "the time after")) / seconds(step, "the step") - 1e-9)
    with warnings.catch_warnings():  # an arm with another payload rests elsewhere under the law, whence it is played
        warnings.simplefilter("ignore", PlanWarning)
        run = simulate(model, duration, step, None, None, Played.of(plan), parameters=p, **ways)
    behind = run.tip_position[run.t >= plan.time * (1 - 1e-12)]
    drives = DriveCoordinates(model.chain, p)
    applied = np.abs(drives.efforts(run.tau[:-1]))
    return Arrival(
        run,
        float(np.linalg.norm(np.ptp(behind, axis=0))),
        applied.max(axis=0),
        int(((applied >= FULL * plan.tau_max) & (plan.tau_max > 0)).any(axis=1).sum()),
        drives.driven(run.q[-1]) - plan.q[-1],
        np.abs(drives.driven_rates(run.q, run.v)).max(axis=0),
    )
