"""The controller that plays a plan: joint law about its references, with its torques ahead."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace

import numpy as np

from ..errors import UsageError
from ..planning.plan import MotionPlan
from ..planning.plan_files import read_plan
from ..robot_model import RobotModel
from .controllers import PD


@dataclass(frozen=True)
class Played(PD):
    """A :class:`PD` law whose references and torques ahead are those of a plan.

    `step`, s: how long torques are held; a run puts its own in. What is held is the mean of the planned torque until
    the next sample: one that is an eighth of a millisecond early costs a factor of ten in what vibrates.
    """

    plan: MotionPlan | None = None
    step: float = 1e-3

    @classmethod
    def of(cls, plan: MotionPlan) -> Played:
        """The law of a plan with its own gains and limits."""
        kp, kd, goal, start = (tuple(x.tolist()) for x in (plan.kp, plan.kd, plan.q[-1], plan.q[0]))
        return cls(kp, kd, goal, duration=plan.time, q_start=start, plan=plan)

    def sampled_every(self, step: float) -> Played:
        """The same for a run of steps of so many seconds."""
        return replace(self, step=step)

    def starting_at(self, q: object) -> Played:
        """The law itself: a plan has a start of its own."""
        return self

    def reference(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        assert self.plan is not None
        return self.plan.reference(t)

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The torques, N·m, of slides forces, N."""
        assert self.plan is not None
        q_ref, v_ref = self.reference(t)
        lag, late = q_ref - self.measured(q, self.ahead), v_ref - self.measured(v)
        tau = self.plan.mean_torque(t, t + self.step) + np.array(self.kp) * lag + np.array(self.kd) * late
        most = self.plan.tau_max
        return np.append(np.clip(tau, -most, most), np.zeros(self.idle))


def read_played(path: str | os.PathLike[str], model: RobotModel) -> Played:
    """The law of the plan in the file at `path`, .npz; raises UsageError."""
    plan = read_plan(path)
    if len(plan.joints) != model.n_joints:
        said = f"is a plan for {len(plan.joints)} joint coordinates; the robot has {model.n_joints}"
        raise UsageError(f"{os.fsdecode(path)}: {said}; plan for this robot")
    return Played.of(plan)
