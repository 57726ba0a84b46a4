"""Steps of the DAE form on SE(3): poses move by the exponential map.

The state is that of the assembled system, ``x = [poses; eta; twists; etadot; q]``; the accelerations come
from the same block elimination as the joint form's.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from ...integrators.method import Method, Move, Stage, times, weighted
from ...integrators.space import FLAT, Curved, Space, beside_states
from ...joints.exponential import Series, algebra_rate, exponential
from ...topology.chain import Chain
from .own_forces import CoordinateForces
from .python import c4, c5

SERIES = Series(c4, c5)
"""The Stumpff functions of numbers."""


def space_of(chain: Chain) -> Space:
    """How the coordinates of the joint form move."""
    return beside_states(Curved(chain, SERIES) if chain.curved else FLAT, chain)


Function = Callable[..., Sequence]


class DaeDynamics:
    """``xdot`` of the DAE form under held inputs; methods give the inertia and force of modes and sprung joints.

    `properties`: those of :class:`.CoordinateForces`. `solve (x, tau, w_ext, inertia, force) -> (xdot, vdot, wrench)`;
    `projection (x) -> (x,)`; `joint_rates (x) -> (qdot,)`, which is read where joints are sprung; `memory (x, tau,
    start, h) -> (rate,)`: of the internal states of forces between frames, which are the last entries of x. `rows`:
    `(x) -> (terms,)` and `(x, tau, w_ext, inertia, force, terms, h, ahead) -> (w_ext,)` of rows that give way.
    """

    def __init__(
        self,
        chain: Chain,
        properties: Sequence,
        solve: Function,
        projection: Function,
        joint_rates: Function,
        memory: Function | None = None,
        rows: Sequence[Function] = (),
    ):
        n, r = chain.n, chain.n_inner
        self.memory, self.rows = memory, rows
        self.forces = CoordinateForces.of_columns(chain, properties)
        self.solve, self.projection, self.sprung, self.joint_rates = (
            solve,
            projection,
            chain.has_axis_forces,
            joint_rates,
        )
        self.pose, self.eta, self.twist = slice(0, 7 * n), slice(7 * n, 7 * n + r), slice(7 * n + r, 13 * n + r)
        self.chain, self.axes = chain, np.array(chain.axis_places, int) - chain.base_q
        self.joints = slice(chain.base_v, chain.base_v + chain.n_joints)
        self.etadot = slice(13 * n + r, 13 * n + 2 * r)
        self.q = slice(13 * n + 2 * r, 13 * n + 2 * r + chain.n_redundant)
        self.z = slice(self.q.stop, None)

    def rates(
        self, x: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, h: float = 0.0, start: np.ndarray | None = None
    ) -> np.ndarray:
        """The ``xdot`` of :meth:`solution`."""
        return self.solution(x, tau, w_ext, h, start)[0]

    def solution(
        self, x: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, h: float = 0.0, start: np.ndarray | None = None
    ) -> Sequence[np.ndarray]:
        """``xdot``, ``vdot`` and the wrenches at ``x``, the forces of modes and joints those ``h`` after ``start``."""
        here = self.own(x)
        own, rate = here if start is None or start is x else self.own(start)
        begin = x if start is None else start
        forces = self.forces.remembering(begin[self.z]).linearised_over(own, rate, h, here[1])
        felt = forces.inertia(h), forces.force(own, rate, h)
        if self.rows and h:
            terms, wrenches = self.rows
            w_ext = wrenches(x, tau, w_ext, *felt, terms(begin)[0], *np.array([h, begin is not x]))[0]
        xdot, vdot, *more = self.solve(x, tau, w_ext, *felt)
        if self.chain.n_internal:
            xdot = np.append(xdot[: self.z.start], forces.internal_rates(vdot))
        if self.memory is not None:
            states = slice(len(x) - self.chain.n_force_states, None)
            xdot[states] = self.memory(x, tau, begin[states], h)[0]
        return xdot, vdot, *more

    def own(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The coordinates with stiffness and damping (sprung joints, rotors, modes), and their rates."""
        eta, etadot = x[self.eta], x[self.etadot]
        if not self.sprung:
            return eta, etadot
        return np.append(x[self.q][self.axes], eta), np.append(self.joint_rates(x)[0], etadot)

    def project(self, x: np.ndarray) -> np.ndarray:
        return self.projection(x)[0]

    def move(self, x: np.ndarray, u: np.ndarray, change: np.ndarray) -> np.ndarray:
        """``x + change``, but for the poses: those of ``x`` times ``exp(u)``, one row of ``u`` per link."""
        new = x + change
        new[self.pose] = np.concatenate(
            [exponential(*row, SERIES) for row in zip(x[self.pose].reshape(-1, 7), u, strict=True)]
        )
        return new

    def redundant(self, q: np.ndarray, rates: np.ndarray, more: np.ndarray) -> np.ndarray:
        """The rates of the joint coordinates beside the poses, with ``more`` of the joints' rates."""
        chain, at, v = self.chain, self.chain.base_q, self.chain.base_v
        out = rates.copy()
        adding, by = (k[k < end] for k, end in ((chain.flat_q, chain.q_offset[-1]), (chain.flat_v, chain.v_offset[-1])))
        out[adding - at] += more[by - v]
        for part in (part for part in chain.curved if not part.joint.in_space):
            own = slice(part.q.start - at, part.q.stop - at)
            out[own] += part.joint.coordinate_rates(q[own], more[part.v.start - v : part.v.stop - v])
        return out

    def twists(self, x: np.ndarray) -> np.ndarray:
        return x[self.twist].reshape(-1, 6)


# ------------------------------------------------------------------------------ a step


class Evaluated(NamedTuple):
    """The results of a stage: the rate of the state, `vdot` (nv,), and the rate (n, 6) of the poses' vectors ``u``."""

    rates: np.ndarray
    vdot: np.ndarray
    turn: np.ndarray
    reach: float


class HeldDae:
    """Steps of a method from `x` over `h` seconds, torques and wrenches held."""

    def __init__(self, dynamics: DaeDynamics, x: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, h: float):
        self.d, self.x, self.input, self.h = dynamics, x, (tau, w_ext), h
        self.found: list[Evaluated] = []

    def step(self, method: Method) -> np.ndarray:
        """The state at the end, not projected."""
        for stage in method.stages:
            self.evaluate(stage)
        return self.moved(method.end)[0]

    def evaluate(self, stage: Stage) -> None:
        """Find the rates of the next stage."""
        there, u = self.moved(stage)
        start = self.x if stage.implicit else None
        rates, vdot, _ = self.d.solution(there, *self.input, times(self.h, stage.part), start)
        turn, reach = algebra_rate(u, self.d.twists(there)), times(self.h, stage.reach)
        self.found.append(Evaluated(rates, vdot, turn, reach))

    def moved(self, move: Move) -> tuple[np.ndarray, np.ndarray]:
        """The state of a move, and `u` (n, 6): its poses are those of the start times ``exp(u)``."""
        d, x, h = self.d, self.x, self.h
        if not move.terms:
            return x, np.zeros((len(x[d.pose]) // 7, 6))
        if move.moved == "stages":
            u = weighted(move, h, [s.turn for s in self.found])
            return d.move(x, u, weighted(move, h, [s.rates for s in self.found])), u
        return self._leap(move)

    def _leap(self, move: Move) -> tuple[np.ndarray, np.ndarray]:
        """The state by one acceleration: coordinates and poses move by the rates that it has changed."""
        d, x, (j, _) = self.d, self.x, move.terms[0]
        rates, vdot, _, reach = self.found[j]
        by, kick = times(self.h, move.reach), times(self.h, move.kick)
        change = rates.copy()
        change[d.eta] = x[d.etadot] + kick * rates[d.etadot]
        change[d.q] = d.redundant(x[d.q], change[d.q], (kick - reach) * vdot[d.joints])
        u = by * (d.twists(x) + kick * d.twists(rates))
        return d.move(x, u, by * change), u
