"""Steps in prepared memory: what a control loop or an environment of reinforcement learning calls at every period."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..arguments import Given, Loads, Numbers
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from .differentiated import NO_METHOD
from .memory import Array, LinkMotions, Pair, Real

if TYPE_CHECKING:
    from .compiled import Compiled


class Stepper:
    """Steps of the joint form whose state and inputs stay in memory: :meth:`.compiled.Compiled.stepper` makes it.

    Write ``q`` (nq,), ``v`` (nv,), ``tau`` (n_tau,) and ``w_ext`` (n, 6) in place, as in ``stepper.q[:] = 0``.  All are
    zero at first, and a floating base is without rotation.  A call makes the steps, the inputs held: ``q`` and ``v``
    are then the new state.  The arrays are those of the C, of its number type, and stay the same for the life of the
    stepper.  Not for several threads at once.
    """

    q: Array
    v: Array
    tau: Array
    w_ext: Array

    def __init__(self, compiled: Compiled, number: int, count: int, dt: Real):
        self.q, self.v, self.tau, self.w_ext = compiled.q, compiled.v, compiled.tau, compiled.w_ext
        self._compiled, self._call = compiled, compiled.library.shim_step
        self._given = compiled.memory, number, count, dt
        self.q[: compiled.chain.nq] = compiled.chain.home

    def __call__(self) -> None:
        """Make the steps.

        Raises ScrewgenError where the state, an input or a result is not finite, and SingularError that names the link
        whose joint is singular; the state is then that before the step that failed.
        """
        if status := self._call(*self._given):
            self._compiled.check(status)

    def kinematics(self) -> LinkMotions:
        """Poses of all links and of their tips, and twists of the tips, in the state."""
        return self._compiled.motion()


class CompiledStepper:
    """A stepper of :mod:`screwgen.simulation` that steps the joint form in the generated C."""

    default = "modal_implicit"

    def __init__(self, compiled: Compiled, model: RobotModel, integrator: str | Method, p: Given):
        self.compiled, self.method = compiled, method_of(integrator, compiled.methods, NO_METHOD)
        compiled.prepare(p)

    def initial(self, q: Numbers, v: Numbers) -> Pair:
        return np.array(q, float), np.array(v, float)

    def step(self, state: Pair, tau: Loads, w_ext: Loads, dt: float) -> Pair:
        return self.compiled.step(*state, tau, w_ext, dt, self.method)

    def coordinates(self, state: Pair) -> Pair:
        return state
