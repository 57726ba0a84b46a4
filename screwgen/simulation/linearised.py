"""Linearised motion about a state: its Jacobian, and the amplification matrices of integration methods.

Everything is linearised at the state as it is, rates included; bristles of friction stick, as springs. Where the
state is no equilibrium these are frozen coefficients: they describe what happens near it, while the motion stays near.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ..arguments import Numbers
from ..backends.numpy import prescribed
from ..backends.numpy.braked import BalancedRates, balance
from ..backends.numpy.dae_step import space_of
from ..errors import SingularError, UsageError
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..integrators.space import Space
from ..robot_model import RobotModel
from ..spec.parameters import changes, turning
from . import mobility
from .inputs import Inputs, coordinates, started
from .integrate import CasadiEvaluator, Dynamics, holding
from .linearised_rows import LinearisedRows

Parameters = Sequence[float] | Mapping[str, float]
Law = Callable[[float, np.ndarray, np.ndarray], Numbers]
Torque = Callable[[np.ndarray, np.ndarray], np.ndarray]

STILL = 3e-6
"""Eigenvalues smaller than this, relative to the largest, are motions that nothing drives back."""
TOLERANCE = 1e-4
"""Growth per radian, relative to the amplitude, that counts as none."""
DIFFERENCE = 1e-5
"""The variation of a controller's arguments, relative if they exceed 1."""


def speed(model: RobotModel, v: np.ndarray) -> float:
    """How fast the joints turn, rad/s: the norm of the rates of the axes that turn, of `v` (nv,)."""
    first = model.chain.base_v
    return float(np.linalg.norm(v[first : first + model.n_joints][turning(model.robot)]))


def check_step(step: float) -> None:
    """Refuse a step that is no time."""
    if not (np.isfinite(step) and step > 0):
        raise UsageError(f"the step is {step:g} s; it must be a finite number > 0")


class AccelerationSlopes(NamedTuple):
    """Derivatives of the accelerations (nv,) by coordinates, rates, torques and the forces of modes and joints."""

    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    force: np.ndarray


class Linearised:
    """The accelerations to first order about a state, as methods ask `integrate.HeldAccelerations` for them.

    `q` (nq,), `v` (nv,); `tau` (n_tau,), N·m, and `w_ext` (n, 6) are held; with a `controller(t, q, v)` its torques at
    t = 0 follow the motion instead; of both what a step holds is meant (:func:`.integrate.holding`). Motions are
    matrices, a column per motion, of small changes (nv,) of the coordinates, by which joints move them, and of their
    rates. Raises UsageError where arguments make no sense, SingularError where the mass matrix cannot be inverted.
    """

    def __init__(
        self,
        model: RobotModel,
        q: Numbers,
        v: Numbers,
        tau: Numbers | None = None,
        controller: Law | None = None,
        w_ext: Numbers | None = None,
        parameters: Parameters | None = None,
    ):
        if controller is not None and tau is not None:
            raise UsageError("torques are given beside a controller; leave one of them out")
        self.model, self.p = model, model.chain.parameters.vector(parameters)
        self.q, self.v = coordinates(q, "q", model, self.p), coordinates(v, "v", model, self.p)
        law = tau if controller is None else started(controller, self.q, model, self.p)
        self.given, self.space = Inputs(model, law, w_ext), space_of(model.chain)
        self.hold, (_, self.w_ext) = holding(model, self.p), self.given(0.0, self.q, self.v)
        self.tau = self._torques(self.q, self.v)
        self.numeric = model.numpy(self.p)
        self.vdot = self.numeric.forward_dynamics(self.q, self.v, self.tau, self.w_ext)[0][: model.nv]
        self.dynamics = Dynamics(model, self.p)
        own = self.dynamics.own
        self.own = own.over(self.q, self.v).stuck
        self.directional = model.once("slopes", lambda: _directional(model))
        self.identity = np.vsplit(np.eye(2 * model.nv), 2)
        follows = controller is not None or model.chain.holds_by_motion
        self.gains = self._gains() if follows else np.zeros((model.n_tau, 2 * model.nv))
        self.trim: np.ndarray | None = None
        self.armature = np.zeros(model.nv)
        self._known: dict[float, AccelerationSlopes] = {}
        self._known_rows: LinearisedRows | None = None

    def trimmed(self) -> Linearised:
        """The same about the same state, with constant generalised forces that make the accelerations zero."""
        own, out = self._balance, copy(self)
        firm = np.divide(own.inertia, own.share, out=np.zeros(len(own.share)), where=own.share > 0)
        trim = self.mass_matrix @ self.vdot + firm * self.vdot  # what brakes hold rests anyway
        out.trim, out._known = trim, {}
        out.__dict__.pop("_light", None)
        return out

    def with_gains(self, gains: np.ndarray) -> Linearised:
        """The same with torques that follow the motion by `gains` (n_tau, 2 nv)."""
        out = copy(self)
        out.gains = gains
        return out

    def with_armature(self, armature: np.ndarray) -> Linearised:
        """The same, trimmed, with so much more inertia (nv,) of the coordinates."""
        out = copy(self)
        out.armature, out._known, out._known_rows = armature, {}, None
        out.__dict__.pop("mass_matrix", None)
        return out

    @property
    def inertia(self) -> np.ndarray:
        """That of the motions, `mass_matrix` where they are those of all coordinates."""
        return self.mass_matrix

    @property
    def names(self) -> list[str]:
        """The coordinates of the motions."""
        return list(changes(self.model.robot))

    @property
    def carried(self) -> np.ndarray:
        """The rates of the motions' changes that follow from these, as the axes of changes turn."""
        return self.model.chain.carried(self.v)

    @property
    def turning(self) -> float:
        """How fast the joints turn at the state, rad/s: the norm of their rates."""
        return speed(self.model, self.v)

    @cached_property
    def mass_matrix(self) -> np.ndarray:
        """`M` (nv, nv) at the state."""
        return self.numeric.mass_matrix(self.q) + np.diag(self.armature)

    @property
    def jacobian(self) -> np.ndarray:
        """`A` (2 nv, 2 nv) of `d/dt [δq; δv] = A [δq; δv]`; where loops are open it closes them."""
        moved, rates = self.identity
        return np.vstack([self.carried @ moved + rates, self.explicit(*self.identity)])

    def step_map(self, method: str | Method, step: float) -> np.ndarray:
        """The amplification matrix (2 nv, 2 nv) of a method over `step` seconds."""
        check_step(step)
        return np.vstack(method_of(method).step(self, self.identity[0], self.identity[1], step))

    def closing_factors(self, method: str | Method, step: float) -> np.ndarray:
        """By what a step multiplies gaps of open loops; none without loops."""
        return np.zeros(0)

    def explicit(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The accelerations of the motions `q`, `v` (nv, k); the torques are those of `identity`, held."""
        return self.implicit(q, v, 0.0)

    def implicit(self, q: np.ndarray, v: np.ndarray, h: float, there: tuple | None = None) -> np.ndarray:
        """The same with the forces of modes and joints that the accelerations lead to `h` after `q`, `v`."""
        a, own = self.slopes(h), self.own
        at_q, at_v = there or (q, v)
        force = own.slopes.force(own.of_rates(q), own.of_rates(v), h)
        if own.laws:
            force = force + own.softened(own.of(self.q), *map(own.of_rates, (self.v, self._felt(h), at_v, q)))
        out = a.q @ at_q + a.v @ at_v + a.tau @ self.gains + a.force @ force
        if self.model.chain.compliant and h:
            ahead = there is not None and not np.array_equal(there[0], q)
            out = out + self._rows(h).added((q, v), (at_q, at_v), out, ahead)
        return np.asarray(out)

    def _rows(self, h: float) -> LinearisedRows:
        """The rows that give way, over a step of `h` seconds."""
        if self._known_rows is None or self._known_rows.h != h:
            heavy, brakes = self._balance.over(self._inertia_over(h)), self._balance
            answers = lambda J: prescribed.answers(self.model.chain, heavy, brakes.share[:, None] * J.T)  # noqa: E731
            self._known_rows = LinearisedRows.of(self.numeric, self.q, self.tau, h, answers)
        return self._known_rows

    def _felt(self, h: float) -> np.ndarray:
        """The rates (nv,) that dry friction resists: those `h` later, as the accelerations lead to them."""
        if h == 0 or self.trim is not None:
            return self.v
        here = (self.q, self.v)
        return self.v + h * self.dynamics.implicit(*here, self.tau, self.w_ext, h, here)

    def slopes(self, h: float) -> AccelerationSlopes:
        """The derivatives of the accelerations with modes and sprung joints implicit over `h`."""
        if h not in self._known:
            self._known = {0.0: self._known[0.0]} if 0.0 in self._known else {}
            if h == 0 and not self.armature.any():
                self._known[h] = self._light
            else:
                self._known[h] = self._derivatives(h) if self.trim is None else self._heavier(h)
        return self._known[h]

    @cached_property
    def _light(self) -> AccelerationSlopes:
        """Those without implicit forces and without inertia that was added."""
        return self._derivatives(0.0)

    def _heavier(self, h: float) -> AccelerationSlopes:
        """Where the accelerations are zero, the inertia over `h` does but divide: `M_h⁻¹ M` times the slopes.

        Where loops close the tree `M_h a_h − Jᵀ λ = M a` with `J a_h = J a`.
        """
        heavy = self._inertia_over(h)
        given, force = prescribed.places(self.model.chain), self.mass_matrix - np.diag(self.armature)
        brakes = self._balance
        heavy, force = brakes.over(heavy), brakes.over(force)
        force[:, given] -= heavy[:, given]
        factor = prescribed.answers(self.model.chain, heavy, force)
        factor[given, given] = 1.0
        if self.model.chain.closing.rows:
            J = mobility.jacobian(self.model, self.q, self.p)
            reach = prescribed.answers(self.model.chain, heavy, brakes.share[:, None] * J.T)
            factor += reach @ self.numeric.row_forces(J @ reach, J @ (np.eye(len(heavy)) - factor))
        return AccelerationSlopes(*(factor @ slope for slope in self._light))

    def _inertia_over(self, h: float) -> np.ndarray:
        """The mass matrix with the forces of modes and joints implicit over `h`."""
        n, out = self.model.chain.n_given, self.mass_matrix.copy()
        own = slice(self.model.nv - n, None)
        out[own, own] += self.model.chain.modal_product(self.own.added(h)[:, None], np.eye(n))
        return out

    @cached_property
    def _balance(self) -> BalancedRates:
        """What brakes make of the equations of motion."""
        return balance(self.numeric, self.mass_matrix, self.q, self.v, self.vdot, self.tau, self.w_ext)

    def _derivatives(self, h: float) -> AccelerationSlopes:
        if not self.model.nv:
            return AccelerationSlopes(*4 * [np.zeros((0, 0))])
        own, chain = self.own, self.model.chain
        nv, m, n, b = chain.nv, chain.n_tau, chain.n, chain.base_v
        force, torque = own.force_of(self.q, self.v, h), self.tau
        if self.trim is not None and chain.n_added:
            force = force + self.trim[b:]
        elif self.trim is not None:
            k = chain.n_joints
            modes = np.append(np.zeros(chain.n_given - nv + b + k), self.trim[b + k :])
            force, torque = force + modes, torque - chain.with_idle_inputs(self.trim[b : b + k])
        if self.trim is not None and chain.given:  # accelerations that are given, and zero
            torque = torque.copy()
            torque[list(chain.given)] = 0.0
        parts = np.cumsum([nv, nv, m, chain.n_given])
        seeds = np.split(np.eye(parts[-1]), parts[:-1], axis=1)
        still = [np.zeros((parts[-1], k)) for k in (6 * n, chain.n_inertia, len(self.p))]
        results = (np.zeros(nv), np.zeros((n, 6)))
        place = (self.q, self.v, torque, self.w_ext, own.inertia(h), force, self.p)
        q, v, tau, f = seeds
        v = np.pad(v, ((0, 0), (0, chain.n_internal)))
        columns = self.directional(*place, *results, q @ self.moving, v, tau, still[0], still[1], f, still[2])[0]
        if not np.isfinite(columns).all():
            what = "the accelerations have no finite derivatives in this state"
            raise SingularError(f"{what}; masses or stiffnesses differ by too many orders of magnitude")
        return AccelerationSlopes(*np.split(columns.reshape(parts[-1], nv).T, parts[:-1], axis=1))

    def _gains(self) -> np.ndarray:
        """The derivatives of the torques by changes and rates (n_tau, 2 nv)."""
        return slopes_of(self._torques, self.q, self.v, self.space, self.model.nv)

    def _torques(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """What a step that begins at a state holds."""
        return self.hold(q, v, self.given(0.0, q, v)[0])

    @cached_property
    def moving(self) -> np.ndarray:
        """(nv, nq): how the coordinates change with small changes, a row for each: ones where they add up."""
        chain, out = self.model.chain, np.zeros((self.model.nv, self.model.nq))
        out[chain.flat_v, chain.flat_q] = 1.0
        for part in chain.curved:
            for k, unit in enumerate(np.eye(part.joint.nv), part.v.start):
                out[k, part.q] = part.joint.coordinate_rates(self.q[part.q], unit)
        return out


def slopes_of(
    torque: Torque, q: np.ndarray, v: np.ndarray, space: Space, nv: int, width: float = DIFFERENCE
) -> np.ndarray:
    """The derivatives (n_tau, 2 nv) of torques `(q, v)` by changes and rates, by central differences of a width."""
    change = lambda u, w: torque(space.moved(q, u), v + np.pad(w, (0, len(v) - nv)))  # noqa: E731
    size = width * np.maximum(1, np.abs(np.append(q[len(q) - nv :], v[:nv])))
    pairs = (np.split(e, 2) for e in np.diag(size))
    sides = [(change(*e) - change(*(-x for x in e))) / (2 * d) for e, d in zip(pairs, size, strict=True)]
    return np.reshape(sides, (2 * nv, -1)).T


def _directional(model: RobotModel) -> CasadiEvaluator:
    """The derivatives of `modal_dynamics` in nv + nv + n_tau + n_given directions at once."""
    function, chain = model.modal_functions["modal_dynamics"], model.chain
    primal, count = list(range(function.n_in() + function.n_out())), 2 * chain.nv + chain.n_tau + chain.n_given
    return CasadiEvaluator(function.forward(1).map("slopes", "serial", max(1, count), primal, []))
