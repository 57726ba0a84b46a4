"""Linearised motion about a state: the Jacobian of the dynamics, and a method's amplification matrix.

Everything is linearised at the state as it is, rates included. Where the state is no equilibrium these are frozen
coefficients: they describe what happens near it, for as long as the motion stays near it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ...arguments import Numbers, parameters_keyword
from ...errors import SingularError, UsageError
from ...integrators.methods import method_of
from ...simulation import mobility
from ...simulation.integrate import Dynamics, Evaluator
from ...simulation.simulate import Inputs, coordinates, started
from ...spec.parameters import turning

if TYPE_CHECKING:
    from ...model import Model

Parameters = Sequence[float] | Mapping[str, float]
Law = Callable[[float, np.ndarray, np.ndarray], Numbers]

STILL = 3e-6
"""Eigenvalues smaller than this, relative to the largest, are motions that nothing drives back."""
TOLERANCE = 1e-4
"""Growth per radian, relative to the amplitude, that counts as none."""
DIFFERENCE = 1e-5
"""The variation of a controller's arguments, relative if they exceed 1."""


def speed(model: Model, v: np.ndarray) -> float:
    """How fast the joints turn, rad/s: the norm of the rates of the axes that turn, of `v` (nq,)."""
    return float(np.linalg.norm(v[: model.n_joints][turning(model.robot)]))


@parameters_keyword
def jacobian(
    model: Model,
    q: Numbers,
    v: Numbers,
    tau: Numbers | None = None,
    w_ext: Numbers | None = None,
    parameters: Parameters | None = None,
    controller: Law | None = None,
) -> np.ndarray:
    """`A` (2 nq, 2 nq) with `d/dt [δq; δv] = A [δq; δv]`: the dynamics linearised at `q`, `v` (nq,), exactly.

    `tau` (n_joints,), N·m, and `w_ext` (n, 6) are held; with a `controller(t, q, v)` the torques follow the
    motion instead, at t = 0. Derivatives by automatic differentiation. Raises UsageError, SingularError.
    """
    return Linearised(model, q, v, tau, controller, w_ext, parameters).jacobian


@parameters_keyword
def step_map(
    model: Model,
    method: str,
    q: Numbers,
    v: Numbers,
    step: float,
    tau: Numbers | None = None,
    controller: Law | None = None,
    w_ext: Numbers | None = None,
    parameters: Parameters | None = None,
) -> np.ndarray:
    """`S` (2 nq, 2 nq) with `[δq; δv]` after a step `= S [δq; δv]` before it: the amplification matrix.

    It is the method itself (of `integrators`, which the generated C steps too) applied to the dynamics
    linearised at `q`, `v` (nq,); `step` in s. `tau` (n_joints,), N·m, is held; with a `controller(t, q, v)` the
    torques are those of the step's start, held over the step, as in a simulation. For methods that evaluate the
    dynamics once a step, and for all of them at an equilibrium, S is the exact derivative of the step.
    Raises UsageError, SingularError.
    """
    return Linearised(model, q, v, tau, controller, w_ext, parameters).step_map(method, step)


def check_step(step: float) -> None:
    """Refuse a step that is no time."""
    if not (np.isfinite(step) and step > 0):
        raise UsageError(f"the step is {step:g} s; it must be a finite number > 0")


def growth(S: np.ndarray) -> float:
    """The spectral radius of a step map: the asymptotic growth factor per step."""
    return float(np.abs(np.linalg.eigvals(S)).max(initial=0.0))


class Slopes(NamedTuple):
    """Derivatives of the accelerations (nq,) by coordinates, rates, torques and the forces of modes and joints."""

    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    force: np.ndarray


class Linearised:
    """The accelerations to first order about a state, as integration methods ask for them: see `integrate.Held`.

    Arguments as those of `step_map`. Motions are matrices, a column per motion. Raises UsageError where
    arguments make no sense, SingularError where the mass matrix cannot be inverted.
    """

    @parameters_keyword
    def __init__(
        self,
        model: Model,
        q: Numbers,
        v: Numbers,
        tau: Numbers | None = None,
        controller: Law | None = None,
        w_ext: Numbers | None = None,
        parameters: Parameters | None = None,
    ):
        model.chain.needs_fixed("spectrum", "analyse the robot with a fixed base")
        if controller is not None and tau is not None:
            raise UsageError("torques are given beside a controller; leave one of them out")
        self.model, self.p = model, model.chain.parameters.vector(parameters)
        self.q, self.v = coordinates(q, "q", model, self.p), coordinates(v, "v", model, self.p)
        law = tau if controller is None else started(controller, self.q, model, self.p)
        self.given = Inputs(model, law, w_ext)
        self.tau, self.w_ext = self.given(0.0, self.q, self.v)
        self.vdot = model.numpy(self.p).forward_dynamics(self.q, self.v, self.tau, self.w_ext)[0]
        self.dynamics = Dynamics(model, self.p)  # type: ignore[arg-type]
        own = self.dynamics.own
        self.own = own.acting(own.of(self.q), own.of(self.v))
        self.directional = model.once("slopes", lambda: _directional(model))
        self.identity = np.vsplit(np.eye(2 * model.nq), 2)
        self.gains = np.zeros((model.n_tau, 2 * model.nq)) if controller is None else self._gains()
        self.trim: np.ndarray | None = None
        self._known: dict[float, Slopes] = {}

    def trimmed(self) -> Linearised:
        """The same about the same state, with constant generalised forces that make the accelerations zero."""
        trim, out = self.mass_matrix @ self.vdot, copy(self)
        out.trim, out._known = trim, {}
        return out

    @property
    def inertia(self) -> np.ndarray:
        """That of the motions, `mass_matrix` where they are those of all coordinates."""
        return self.mass_matrix

    @property
    def names(self) -> list[str]:
        """The coordinates of the motions."""
        return self.model.q_names

    @property
    def turning(self) -> float:
        """How fast the joints turn at the state, rad/s: the norm of their rates."""
        return speed(self.model, self.v)

    @cached_property
    def mass_matrix(self) -> np.ndarray:
        """`M` (nq, nq) at the state."""
        return self.model.numpy(self.p).mass_matrix(self.q)

    @property
    def jacobian(self) -> np.ndarray:
        """`A` (2 nq, 2 nq) of `d/dt [δq; δv] = A [δq; δv]`; where loops are open it closes them."""
        return np.vstack([self.identity[1], self.explicit(*self.identity)])

    def step_map(self, method: str, step: float) -> np.ndarray:
        """The amplification matrix (2 nq, 2 nq) of a method over `step` seconds."""
        check_step(step)
        return np.vstack(method_of(method).step(self, self.identity[0], self.identity[1], step))

    def closing_factors(self, method: str, step: float) -> np.ndarray:
        """By what a step multiplies gaps of open loops; none without loops."""
        return np.zeros(0)

    def explicit(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The accelerations of the motions `q`, `v` (nq, k); the torques are those of `identity`, held."""
        return self.implicit(q, v, 0.0)

    def implicit(self, q: np.ndarray, v: np.ndarray, h: float, there: tuple | None = None) -> np.ndarray:
        """The same with the forces of modes and joints that the accelerations lead to `h` after `q`, `v`."""
        a, own = self.slopes(h), self.own
        at_q, at_v = there or (q, v)
        force = own.slopes.force(own.of(q), own.of(v), h)
        if self.model.chain.dry:
            force = force + own.softened(own.of(self.v), own.of(self._felt(h)), own.of(at_v))
        return a.q @ at_q + a.v @ at_v + a.tau @ self.gains + a.force @ force

    def _felt(self, h: float) -> np.ndarray:
        """The rates (nv,) that dry friction resists: those `h` later, as the accelerations lead to them."""
        if h == 0 or self.trim is not None:
            return self.v
        here = (self.q, self.v)
        return self.v + h * self.dynamics.implicit(*here, self.tau, self.w_ext, h, here)

    def slopes(self, h: float) -> Slopes:
        """The derivatives of the accelerations with modes and sprung joints implicit over `h`."""
        if h not in self._known:
            self._known = {0.0: self._known[0.0]} if 0.0 in self._known else {}
            self._known[h] = self._derivatives(h) if self.trim is None or h == 0 else self._heavier(h)
        return self._known[h]

    def _heavier(self, h: float) -> Slopes:
        """Where the accelerations are zero, the inertia over `h` does but divide: `M_h⁻¹ M` times the slopes.

        Where loops close the tree `M_h a_h − Jᵀ λ = M a` with `J a_h = J a`.
        """
        M = self.mass_matrix
        n = self.model.chain.n_given
        added, own = np.zeros_like(M), slice(self.model.nq - n, None)
        added[own, own] = self.model.chain.modal_product(self.own.added(h)[:, None], np.eye(n))
        factor = np.linalg.solve(M + added, M)
        if self.model.chain.closures:
            J = mobility.jacobian(self.model, self.q, self.p)
            reach = np.linalg.solve(M + added, J.T)
            factor += reach @ self.model.numpy(self.p).row_forces(J @ reach, J @ (np.eye(len(M)) - factor))
        return Slopes(*(factor @ slope for slope in self.slopes(0.0)))

    def _derivatives(self, h: float) -> Slopes:
        if not self.model.nq:
            return Slopes(*4 * [np.zeros((0, 0))])
        own, (nq, m, n) = self.own, (self.model.nq, self.model.n_tau, self.model.n_links)
        force, torque = own.force(own.of(self.q), own.of(self.v), h), self.tau
        if self.trim is not None and self.model.chain.n_motors:
            force = force + self.trim
        elif self.trim is not None:
            modes = np.append(np.zeros(self.model.chain.n_given - nq + m), self.trim[m:])
            force, torque = force + modes, torque - self.trim[:m]
        parts = np.cumsum([nq, nq, m, self.model.chain.n_given])
        seeds = np.split(np.eye(parts[-1]), parts[:-1], axis=1)
        still = [np.zeros((parts[-1], k)) for k in (6 * n, self.model.chain.n_inertia, len(self.p))]
        results = (np.zeros(nq), np.zeros((n, 6)))
        place = (self.q, self.v, torque, self.w_ext, own.inertia(h), force, self.p)
        q, v, tau, f = seeds
        columns = self.directional(*place, *results, q, v, tau, still[0], still[1], f, still[2])[0]
        if not np.isfinite(columns).all():
            what = "the accelerations have no finite derivatives in this state"
            raise SingularError(f"{what}; masses or stiffnesses differ by too many orders of magnitude")
        return Slopes(*np.split(columns.reshape(parts[-1], nq).T, parts[:-1], axis=1))

    def _gains(self) -> np.ndarray:
        """The controller's derivatives by q and v (n_joints, 2 nq), by central differences."""
        x = np.append(self.q, self.v)
        torque = lambda x: self.given(0.0, *np.split(x, 2))[0]  # noqa: E731
        sides = [(torque(x + e) - torque(x - e)) / (2 * e.max()) for e in np.diag(DIFFERENCE * np.maximum(1, abs(x)))]
        return np.array(sides).reshape(-1, self.model.n_tau).T


def _directional(model: Model) -> Evaluator:
    """The derivatives of `modal_dynamics` in nq + nq + n_joints + n_given directions at once."""
    function, chain = model.modal_functions["modal_dynamics"], model.chain
    primal, count = list(range(function.n_in() + function.n_out())), 2 * chain.nq + chain.n_tau + chain.n_given
    return Evaluator(function.forward(1).map("slopes", "serial", max(1, count), primal, []))


# ------------------------------------------------------------------------------ motions


@dataclass(frozen=True)
class Motion:
    """A motion `exp(λ t)` of the linearised arm; a conjugate pair is one, with the positive imaginary part.

    `kind`: "oscillates", "grows" (an oscillation that gains), "falls" (real, growing), "decays" (real, shrinking) or
    "free" (nothing drives it back); `frequency_hz`: |λ| / 2π of an oscillation, else 0; `damping`: its ratio −Re λ/|λ|;
    `coordinate`: the one with the largest share of the motion's kinetic energy.
    """

    eigenvalue: complex
    kind: str
    frequency_hz: float
    damping: float
    coordinate: str


def motions(motion: Linearised) -> list[Motion]:
    """The spectrum: motions that fall, then the others by |λ|, slowest first."""
    eigenvalues, vectors = np.linalg.eig(motion.jacobian)
    largest = np.abs(eigenvalues).max(initial=0.0)
    found = []
    for x, vector in zip(eigenvalues.astype(complex), vectors.T, strict=True):
        if abs(x) <= STILL * largest:
            x = 0j
        if x.imag >= 0:
            u = vector[: len(vector) // 2]
            share = np.abs((u.conj() * (motion.inertia @ u)).real)
            found.append(_motion(complex(x), motion.names[int(share.argmax())]))
    return sorted(found, key=lambda m: (m.kind != "falls", abs(m.eigenvalue)))


def _motion(x: complex, coordinate: str) -> Motion:
    if x == 0:
        return Motion(x, "free", 0.0, 0.0, coordinate)
    if x.imag == 0:
        return Motion(x, "falls" if x.real > 0 else "decays", 0.0, float(-np.sign(x.real)), coordinate)
    damping = -x.real / abs(x)
    return Motion(x, "grows" if damping < -TOLERANCE else "oscillates", abs(x) / (2 * np.pi), damping, coordinate)
