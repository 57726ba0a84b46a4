"""Time steps of the DAE form on SE(3): poses move by the exponential, every step ends on the joints.

The state is that of the assembled system, ``x = [poses; eta; twists; etadot; q]``; the accelerations come
from the same block elimination as the joint form's.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ..backends.numpy.python import c4, c5
from ..errors import UsageError
from .integrate import LIMIT, DivergedError, Evaluator

if TYPE_CHECKING:
    from ..model import Model


@lru_cache(maxsize=4)
def _functions(model: Model) -> dict:
    from ..backends.casadi.functions import modal_functions

    return modal_functions(model.chain) | {"dae_state": model.casadi()["dae_state"]}


class DaeDynamics:
    """``xdot`` of the DAE form under held inputs; methods choose what acts within modes and sprung joints."""

    def __init__(self, model: Model, p: Sequence[float]):
        functions = _functions(model)
        self.p, n, r = np.array(p, float), model.n_links, model.nq - model.n_joints
        self.solve, self.projection = Evaluator(functions["dae_dynamics"]), Evaluator(functions["project"])
        self.joint_rates = Evaluator(functions["joint_rates"]) if model.chain.sprung else None
        self.M, self.K, self.D = Evaluator(functions["modal_properties"])(self.p)
        self.pose, self.eta, self.twist = slice(0, 7 * n), slice(7 * n, 7 * n + r), slice(7 * n + r, 13 * n + r)
        self.etadot, self.q = slice(13 * n + r, 13 * n + 2 * r), slice(13 * n + 2 * r, None)

    def rates(self, x: np.ndarray, tau, w_ext, h: float = 0.0, start: np.ndarray | None = None) -> np.ndarray:
        """``xdot`` alone of :meth:`solution`."""
        return self.solution(x, tau, w_ext, h, start)[0]

    def solution(self, x, tau, w_ext, h: float = 0.0, start: np.ndarray | None = None) -> list[np.ndarray]:
        """``xdot``, ``vdot`` and the wrenches at ``x``, the forces of modes and joints those ``h`` after ``start``."""
        own, rate = self.own(x if start is None else start)
        inertia = self.M + h * self.D + h**2 * self.K
        force = self.K * (own + h * rate) + self.D * rate
        return self.solve(x, tau, w_ext, inertia, force, self.p)

    def own(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The coordinates that have forces of their own, and their rates."""
        eta, etadot = x[self.eta], x[self.etadot]
        if self.joint_rates is None:
            return eta, etadot
        return np.append(x[self.q], eta), np.append(self.joint_rates(x, self.p)[0], etadot)

    def project(self, x: np.ndarray) -> np.ndarray:
        return self.projection(x, self.p)[0]

    def move(self, x: np.ndarray, u: np.ndarray, rates: np.ndarray, h: float) -> np.ndarray:
        """``x + h rates``, but for the poses: those of ``x`` times ``exp(u)``, one row of ``u`` per link."""
        new = x + h * rates
        new[self.pose] = np.concatenate([exponential(*row) for row in zip(x[self.pose].reshape(-1, 7), u, strict=True)])
        return new

    def twists(self, x: np.ndarray) -> np.ndarray:
        return x[self.twist].reshape(-1, 6)


def exponential(pose: np.ndarray, u: np.ndarray) -> np.ndarray:
    """The pose (w, x, y, z, px, py, pz) times ``exp`` of ``u = [turn; shift]`` in the body's axes."""
    turn, shift = u[:3], u[3:]
    x = float(turn @ turn)
    cross = np.cross(turn, shift)
    moved = shift + (0.5 - x * c4(x)) * cross + (1 / 6 - x * c5(x)) * np.cross(turn, cross)
    quarter = x / 4
    w, v = 1 - quarter * (0.5 - quarter * c4(quarter)), (1 - quarter * (1 / 6 - quarter * c5(quarter))) / 2 * turn
    a, b = pose[0], pose[1:4]
    t = 2 * np.cross(b, moved)
    return np.concatenate([[a * w - b @ v], a * v + w * b + np.cross(b, v), pose[4:] + moved + a * t + np.cross(b, t)])


def algebra_rate(u: np.ndarray, V: np.ndarray) -> np.ndarray:
    """The rate of ``u`` in ``pose = start exp(u)`` at the twist ``V``: enough terms for order four."""
    first = bracket(u, V)
    return V + first / 2 + bracket(u, first) / 12


def bracket(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The Lie bracket of se(3), row by row, (25)."""
    angular = np.cross(a[:, :3], b[:, :3])
    return np.hstack([angular, np.cross(a[:, 3:], b[:, :3]) + np.cross(a[:, :3], b[:, 3:])])


# ------------------------------------------------------------------------------ the methods


def euler(d: DaeDynamics, x, tau, w_ext, h: float) -> np.ndarray:
    """Forward Euler, order 1."""
    return d.move(x, h * d.twists(x), d.rates(x, tau, w_ext), h)


def _symplectic(d: DaeDynamics, x, tau, w_ext, h: float, modal: float) -> np.ndarray:
    """Twists and modal rates first, then poses, modal coordinates and joints with the new rates."""
    rates, vdot, _ = d.solution(x, tau, w_ext, modal)
    new = x + h * rates
    rates[d.eta] = new[d.etadot]
    rates[d.q] += h * vdot[: len(rates[d.q])]
    return d.move(x, h * d.twists(new), rates, h)


def semi_implicit(d: DaeDynamics, x, tau, w_ext, h: float) -> np.ndarray:
    """Symplectic Euler, order 1."""
    return _symplectic(d, x, tau, w_ext, h, 0.0)


def modal_implicit(d: DaeDynamics, x, tau, w_ext, h: float) -> np.ndarray:
    """Symplectic Euler with the forces of modes, joint springs and dampers at the step's end, order 1."""
    return _symplectic(d, x, tau, w_ext, h, h)


def modal_midpoint(d: DaeDynamics, x, tau, w_ext, h: float) -> np.ndarray:
    """The midpoint rule with the forces of modes, joint springs and dampers implicit, order 2."""
    middle = _symplectic(d, x, tau, w_ext, h / 2, h / 2)
    rates = d.rates(middle, tau, w_ext, h / 2, x)
    new = x + h * rates
    rates[d.eta] = (x[d.etadot] + new[d.etadot]) / 2
    return d.move(x, h / 2 * (d.twists(x) + d.twists(new)), rates, h)


def rk4(d: DaeDynamics, x, tau, w_ext, h: float) -> np.ndarray:
    """Runge-Kutta-Munthe-Kaas, order 4."""
    stage, u = x, np.zeros((len(x[d.pose]) // 7, 6))
    total, moved = np.zeros_like(x), np.zeros_like(u)
    for weight, reach in ((1 / 6, 0.5), (1 / 3, 0.5), (1 / 3, 1.0), (1 / 6, 0.0)):
        rates, turn = d.rates(stage, tau, w_ext), algebra_rate(u, d.twists(stage))
        total, moved = total + weight * rates, moved + weight * h * turn
        u = reach * h * turn
        stage = d.move(x, u, rates, reach * h)
    return d.move(x, moved, total, h)


METHODS: dict[str, Callable] = {
    "euler": euler,
    "semi_implicit": semi_implicit,
    "modal_implicit": modal_implicit,
    "modal_midpoint": modal_midpoint,
    "rk4": rk4,
}


class DaeStepper:
    """Steps of the DAE form, each followed by the projection onto the joints."""

    default = "modal_midpoint"

    def __init__(self, model: Model, integrator: str, p: Sequence[float]):
        if integrator not in METHODS:
            raise UsageError(f"there is no integrator '{integrator}' in the DAE form; known: {', '.join(METHODS)}")
        self.name, self.method, self.dynamics = integrator, METHODS[integrator], DaeDynamics(model, p)
        self.judge, self.n_joints = model.numpy(p), model.n_joints
        self.place = Evaluator(_functions(model)["dae_state"])

    def initial(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The state on the joints."""
        return self.place(q, v, self.dynamics.p)[0]

    def step(self, x: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, dt: float) -> np.ndarray:
        """The state ``dt`` later, on the joints."""
        new = self.dynamics.project(self.method(self.dynamics, x, tau, w_ext, dt))
        if not (np.abs(new) < LIMIT).all():
            self.judge.dae_rates(x, tau, w_ext)
            raise DivergedError(f"the integrator '{self.name}' diverged; take a smaller step")
        return new

    def coordinates(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """``q`` and ``v``: the joints' rates are those that the twists show."""
        d = self.dynamics
        rates = d.rates(x, np.zeros(self.n_joints), np.zeros((len(x[d.pose]) // 7, 6)))
        q, qdot = x[len(x) - self.n_joints :], rates[len(x) - self.n_joints :]
        return np.concatenate([q, x[d.eta]]), np.concatenate([qdot, x[d.etadot]])
