"""Time steps of the joint form: the accelerations that a method needs, and the stepper that applies it.

The torques and external wrenches are held over a step, which first makes of the torques what the drives can give.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeVar

import numpy as np

from ..algorithms.tip_programs import COMPLIANT
from ..arguments import Numbers
from ..backends.numpy.dae_step import space_of
from ..backends.numpy.own_forces import CoordinateForces
from ..errors import DivergedError
from ..integrators.method import Method, Motion
from ..integrators.methods import method_of
from ..robot_model import RobotModel

if TYPE_CHECKING:
    from .validity import Watch

DEFAULT = "modal_midpoint"
"""The integrator to take where none is asked for."""

LIMIT = 1e9
"""A coordinate or rate beyond this (m, rad, per second) means that the method diverges."""


_State = TypeVar("_State")


class EquationForm(Protocol[_State]):
    """The interface of a form of the equations for runs; the type of a state is the form's own."""

    default: str
    """The integrator to take where none is asked for."""

    method: Method

    def initial(self, q: np.ndarray, v: np.ndarray) -> _State:
        """The state at the coordinates `q` (nq,) and rates `v` (nvz,)."""

    def step(self, state: _State, tau: np.ndarray, w_ext: np.ndarray, dt: float) -> _State:
        """The state `dt` seconds later under torques (n_tau,) and tip wrenches (n, 6).

        Both are held over the step, which begins with :func:`holding`.

        Raises SingularError or DivergedError.
        """

    def coordinates(self, state: _State) -> tuple[np.ndarray, np.ndarray]:
        """`q` (nq,) and `v` (nv,) of a state."""


class CasadiEvaluator:
    """A CasADi function on NumPy arrays without intermediate copies, which saves about 10 µs a call."""

    def __init__(self, function: Any):
        self.inputs = [np.zeros(function.numel_in(i)) for i in range(function.n_in())]
        self.outputs = [np.zeros(function.nnz_out(i)) for i in range(function.n_out())]
        self.places = [np.array(function.sparsity_out(i).find(), int) for i in range(function.n_out())]
        self.sizes = [function.numel_out(i) for i in range(function.n_out())]
        self.buffer, self.evaluate = function.buffer()
        for i, x in enumerate(self.inputs):
            self.buffer.set_arg(i, x.data)
        for i, x in enumerate(self.outputs):
            self.buffer.set_res(i, x.data)

    def __call__(self, *values: np.ndarray) -> list[np.ndarray]:
        """The outputs, flat (column by column), for the inputs: (n, 6) arrays stand for 6 x n."""
        for x, value in zip(self.inputs, values, strict=True):
            x[:] = np.ravel(value)
        self.evaluate()
        out = [np.zeros(size) for size in self.sizes]
        for x, places, found in zip(out, self.places, self.outputs, strict=True):
            x[places] = found
        return out


class Dynamics:
    """Accelerations and joint wrenches of the joint form; methods give inertia and force of modes and sprung joints."""

    def __init__(self, model: RobotModel, p: Numbers):
        functions = model.modal_functions
        self.p, self.n_links = np.array(p, float), model.n_links
        self.evaluate = CasadiEvaluator(functions["modal_dynamics"])
        self.own = CoordinateForces.of_columns(model.chain, CasadiEvaluator(functions["modal_properties"])(self.p))
        self.states = model.chain.force_states
        self.memory = CasadiEvaluator(functions["force_rates"]) if model.chain.n_force_states else None
        self.rows = [CasadiEvaluator(functions[x.__name__]) for x in COMPLIANT] if model.chain.compliant else None

    def explicit(self, q: np.ndarray, v: np.ndarray, tau: np.ndarray, w_ext: np.ndarray) -> list[np.ndarray]:
        """`vdot` (nvz,) and the joint wrenches (6 n,)."""
        own = self.own.over(q, v)
        vdot, *more = self.evaluate(q, v, tau, w_ext, own.M, own.force_of(q, v, 0.0), self.p)
        return [self._with_internal(own, vdot, v, tau, 0.0, (q, v)), *more]

    def modes(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Inertia (n_inertia,) and force (n_given,) of the coordinates with stiffness and damping."""
        own = self.own.over(q, v)
        return own.M, own.force_of(q, v, 0.0)

    def _with_internal(
        self, own: CoordinateForces, vdot: np.ndarray, v: np.ndarray, tau: np.ndarray, h: float, there: Motion
    ) -> np.ndarray:
        """The accelerations, and the rates of internal states: those of laws follow from them."""
        if not own.chain.n_internal:
            return vdot
        out = np.append(vdot, own.internal_rates(vdot))
        if self.memory is not None:
            out[self.states] = self.memory(*there, tau, v[self.states], np.array(h), self.p)[0]
        return out

    def implicit(
        self, q: np.ndarray, v: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, h: float, there: Motion
    ) -> np.ndarray:
        """`vdot` (nvz,) with the forces of modes and joints implicit, `h` after `q, v`; the rest is that at `there`."""
        own = self.own.over(q, v, h, there[1])
        felt = own.inertia(h), own.force_of(q, v, h)
        if self.rows is not None:
            terms, wrenches = self.rows
            ahead = np.array([h, there[0] is not q])
            w_ext = wrenches(*there, tau, w_ext, *felt, terms(q, v, self.p)[0], *ahead, self.p)[0]
        vdot = self.evaluate(*there, tau, w_ext, *felt, self.p)[0]
        return self._with_internal(own, vdot, v, tau, h, there)


def holding(model: RobotModel, p: Numbers) -> Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]:
    """What a step that begins at `q, v` holds of its inputs `(q, v, tau)`, (n_tau,): within limits of efforts.

    Every step begins with it, and what is recorded of a step is what it holds.
    """
    return model.numpy(p).held_inputs if model.chain.holds else lambda q, v, tau: tau


class HeldAccelerations(NamedTuple):
    """The accelerations while torques and external wrenches are held."""

    dynamics: Dynamics
    tau: np.ndarray
    w_ext: np.ndarray

    def explicit(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return self.dynamics.explicit(q, v, self.tau, self.w_ext)[0]

    def implicit(self, q: np.ndarray, v: np.ndarray, h: float, there: Motion | None = None) -> np.ndarray:
        return self.dynamics.implicit(q, v, self.tau, self.w_ext, h, there or (q, v))


# ------------------------------------------------------------------------------ the stepper


def diverged(method: Method) -> DivergedError:
    """The error of an integrator that is unstable at its step size."""
    other = "" if method.name == DEFAULT else f", or {DEFAULT}"
    return DivergedError(f"the integrator '{method}' diverged; take a smaller step{other}")


def left(method: Method, watch: Watch) -> DivergedError:
    """The error of a run in which a link bends by its own length, by an integrator."""
    if watch.jumped:
        return diverged(method)
    return watch.left("" if method.implicit else method.name)


class JointState(NamedTuple):
    """Coordinates (nq,) and rates (nv,)."""

    q: np.ndarray
    v: np.ndarray


class JointStepper:
    """Steps of the joint form; constraints hold by construction."""

    default = DEFAULT

    def __init__(self, model: RobotModel, integrator: str | Method, p: Numbers):
        self.method, self.dynamics = method_of(integrator), Dynamics(model, p)
        self.reference, self.space, self.chain = model.numpy(p), space_of(model.chain), model.chain
        self.hold = holding(model, p)

    def initial(self, q: np.ndarray, v: np.ndarray) -> JointState:
        return JointState(np.array(q, float), np.array(v, float))

    def step(self, state: JointState, tau: np.ndarray, w_ext: np.ndarray, dt: float) -> JointState:
        tau = self.hold(state.q, state.v, tau)
        q, v = self.method.step(HeldAccelerations(self.dynamics, tau, w_ext), state.q, state.v, dt, self.space)
        new = JointState(self.chain.unit(q), v)
        if not (np.abs(new.q) < LIMIT).all() or not (np.abs(new.v) < LIMIT).all():
            self.reference.forward_dynamics(state.q, state.v, tau, w_ext)
            raise diverged(self.method)
        return new

    def coordinates(self, state: JointState) -> tuple[np.ndarray, np.ndarray]:
        return state.q, state.v
