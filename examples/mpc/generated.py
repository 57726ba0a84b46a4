"""The predictive controller of the generated C in the loop of the example."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from screwgen import ScrewgenError
from screwgen.runtime.mpc import CompiledMpc
from screwgen.spec.mpc import load_mpc

from .arms import Arms
from .loop import Controller
from .ocp import Form, Solution
from .plan import Plan

FILE = Path(__file__).with_name("mpc.toml")
BOUNDED = Path(__file__).with_name("mpc_wrench.toml")
"""The same with a bounded joint wrench."""


@dataclass(frozen=True)
class Sampled(Solution):
    """A sample; `seconds` is processor time of preparation and feedback, with the calls from Python."""

    state: np.ndarray
    """(nx,): what the controller was given."""
    reference: np.ndarray
    """The references of all stages, in the order of the C struct."""
    late: bool


def always_in_time(k: int) -> bool:
    """Whether the preparation for sample k is late."""
    return False


class Generated(Controller):
    """One real-time iteration in generated C for each sample, along the plan or, without one, towards the goal.

    A late sample is one whose preparation is not done when the measurement comes.  Then `feedback` is called all the
    same: it returns the next torque of what was predicted and says BAD_ARGUMENT, and that moves on by an interval.
    """

    def __init__(
        self,
        arms: Arms,
        intervals: int = 0,
        plan: Plan | None = None,
        file: Path = FILE,
        late: Callable[[int], bool] = always_in_time,
    ):
        self.file, self.late, horizon = file, late, load_mpc(file).horizon
        super().__init__(arms, Form(horizon.step, horizon.intervals), intervals, plan)

    def stated(self, form: Form) -> CompiledMpc:
        return self.arms.model.mpc(self.file, parameters=self.dynamics.parameters(self.extra))

    def refer(self, t: float) -> np.ndarray:
        """The references from time t on: states, torques and tips of the plan, or without one the rest at the goal."""
        c, h, n = self.problem, self.form.h, self.arms.model.nq
        for k, stage in enumerate(c.reference):
            at = t + k * h
            x, tau = (self.plan.states(at), self.plan.torques(at, h)) if self.plan else self.ends[1]
            stage["q"][:], stage["v"][:], stage["tau"][:] = x[:n], x[n:], tau
            stage["tip_position"][:] = np.array(self.dynamics.tip(x, self.extra)).ravel()
        return np.array([np.concatenate([np.ravel(part) for part in stage.values()]) for stage in c.reference])

    def solve(self, problem: CompiledMpc, x, t: float) -> Sampled:
        """The first sample, at rest before the motion: what acts from t = 0 on."""
        n, reference = self.arms.model.nq, self.refer(t)
        problem.initialise(x[:n], x[n:])
        if not problem.converged:
            raise ScrewgenError("the cold start does not converge")
        return self._fed(x, reference, False)

    def sample(self, x, acting: Solution, t: float) -> Sampled:
        reference, late = self.refer(t + self.form.h), self.late(round(t / self.form.h))
        return self._fed(x, reference, late, None if late else self.problem.prepare)

    def _fed(self, x, reference, late: bool, prepare: Callable[[], None] | None = None) -> Sampled:
        c, n, start = self.problem, self.arms.model.nq, time.thread_time()
        if prepare:
            prepare()
        try:
            u = c.feedback(x[:n], x[n:])
        except ScrewgenError:
            if not late:
                raise
            u = c.inner["acting"].astype(float)
        seconds, solved = time.thread_time() - start, late or c.outcome == "solved"
        return Sampled(u[None], c.states, solved, c.iterations, seconds, float("nan"), x.copy(), reference, late)
