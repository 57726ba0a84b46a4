"""Steps in prepared memory: what a control loop or an environment of reinforcement learning calls at every period."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .memory import Array, LinkMotions, Real

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
