"""The controller that plays a plan: joint law about its references, with its torques ahead."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import Numbers
from ..errors import UsageError, one_line
from ..planning.drive_coordinates import DriveCoordinates
from ..planning.members import Still
from ..planning.plan import MotionPlan, PlanWarning
from ..planning.plan_files import read_plan
from ..planning.task import JointLaw
from ..robot_model import RobotModel
from .controllers import PD

if TYPE_CHECKING:
    from ..topology.chain import Chain

AWAY = 1e-6
"""How far from its start, rad or m, a plan may be played without a word."""


@dataclass(frozen=True)
class Played(PD):
    """A :class:`PD` law whose references and torques ahead are those of a plan.

    `step`, s: how long torques are held; a run puts its own in. What is held is the mean of the planned torque until
    the next sample: one that is an eighth of a millisecond early costs a factor of ten in what vibrates.
    """

    plan: MotionPlan | None = None
    step: float = 1e-3
    effort_ratios: tuple[float, ...] = ()
    """(n_joints,): of planned efforts to inputs, filled in by a run; those of drives without one."""

    @classmethod
    def of(cls, plan: MotionPlan) -> Played:
        """The law of a plan with its own gains and limits."""
        kp, kd, goal, start = (tuple(x.tolist()) for x in (plan.kp, plan.kd, plan.q[-1], plan.q[0]))
        return cls(kp, kd, goal, duration=plan.time, q_start=start, plan=plan)

    def through(self, chain: Chain, p: Numbers) -> Played:
        """The same law for a robot; of axes whose motion is given the input is an acceleration."""
        own, ratios = super().through(chain, p), DriveCoordinates(chain, p).effort_ratios
        assert isinstance(own, Played)
        return replace(own, effort_ratios=tuple(ratios.tolist()))

    def sampled_every(self, step: float) -> Played:
        """The same for a run of steps of so many seconds."""
        return replace(self, step=step)

    def rest(self, model: RobotModel, p: np.ndarray) -> np.ndarray:
        """The coordinates (nq,) in which a model rests under the law before the plan begins."""
        assert self.plan is not None
        model.chain.refuse_loops("rest of a plan", "state q0")
        plan, still = self.plan, Still(model, p)
        held = still.held(plan.q[0]).q
        law = JointLaw(plan.kp, plan.kd)
        return still.drives.to_robot(still.under(law, plan.q[0], plan.tau[0], held).q if plan.kp.all() else held)

    def starting_at(self, q: Any) -> Played:
        """The law itself: a plan has a start of its own. A run that starts elsewhere is warned."""
        assert self.plan is not None
        start = self.plan.q[0]
        there = self.seen(q, np.zeros(len(q)))[0]
        if (off := np.abs(there - start)).max() > AWAY:
            j = int(off.argmax())
            said = f"the plan starts at {start[j]:.4g} of {self.plan.joints[j]}, the run at {there[j]:.4g}"
            warnings.warn(f"{said}: its torques are those of the plan's start", PlanWarning, stacklevel=2)
        return self

    def reference(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        assert self.plan is not None
        return self.plan.reference(t)

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The torques, N·m, of slides and cylinders forces, N, where they act: on the rotors of elastic drives."""
        assert self.plan is not None
        (q_ref, v_ref), (there, rate) = self.reference(t), self.seen(q, v)
        added = np.array(self.kp) * (q_ref - there) + np.array(self.kd) * (v_ref - rate)
        added = added if self.efforts is None else self.efforts(added, there)
        tau, most = self.plan.mean_torque(t, t + self.step) + added, self.plan.tau_max
        ratios = np.array(self.effort_ratios) if self.effort_ratios else self.own_ratios
        return np.append(np.clip(tau, -most, most) / ratios, np.zeros(self.idle))


def read_played(path: str | os.PathLike[str], model: RobotModel) -> Played:
    """The law of the plan in the file at `path`, .npz; raises UsageError."""
    plan = read_plan(path)
    if plan.joints != tuple(model.q_names[: model.n_joints]):
        own = ", ".join(model.q_names[: model.n_joints]) or "no joints"
        said = f"is a plan for {', '.join(plan.joints)}; the robot has {own}"
        raise UsageError(f"{os.fsdecode(path)}: {said}; plan for this robot")
    if plan.robot != (name := model.robot.name):
        said = f"a plan for robot '{one_line(plan.robot)}' is played by '{name}', whose torques may be others"
        warnings.warn(f"{os.fsdecode(path)}: {said}", PlanWarning, stacklevel=2)
    return Played.of(plan)
