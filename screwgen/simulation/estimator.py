"""The estimator in NumPy: an extended Kalman filter over q and v, for trees, loops, floating bases and ball joints.

It does what the generated C does, in the same order, and needs no compiler. The covariance is that of changes
[δ; δv] (2 nv), δ that by which joints move their coordinates: of the pose of a floating base [turn; shift] in its own
axes, pose exp(δ), of a ball joint a turn in axes of its link. Where loops close the tree the mean is closed after
every call, and the covariance is projected onto the motions that keep it closed.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ..algorithms.gauges import bending, gauges
from ..algorithms.joint_sensors import PoseSensor, encoders, pose_sensors
from ..algorithms.tip_acceleration import tip_acceleration
from ..arguments import Given, Loads, Numbers
from ..backends.numpy.covariance import corrected, deviations, root
from ..backends.numpy.numeric import EPSILON, function_of
from ..errors import DivergedError, SingularError
from ..joints.exponential import angular_velocity
from ..robot_model import RobotModel
from ..runtime.estimator import NOT_FINITE, OPEN, TOO_LONG
from ..runtime.measurements import (
    Innovation,
    Noise,
    check_noise,
    check_step,
    checked_input,
    checked_measurements,
    checked_start,
    fibres,
    sensors,
    spread,
)
from .integrate import JointStepper
from .mobility import closing

ROUNDS, CHORDS, CLOSED = 2, 6, 1e4 * EPSILON
"""Corrections with the same directions, and the gap, m or of cosines, at which loops are closed."""
WIDEN = 3.0
"""By how much deviations become larger at most in an update that believes what is beyond the gate: more would throw far
away what is hardly measured."""
FIRM = 1.0
"""The seconds over which springs and modes resist the closing of a loop, so that joints close it."""


class Estimator:
    """The same interface as :class:`..runtime.estimator.CompiledEstimator`.

    ``parameters``: values in the order of ``model.parameter_names``, or by name. Raises UsageError, DivergedError,
    SingularError; then the estimate is as it was.
    """

    def __init__(self, model: RobotModel, parameters: Given = None):
        chain, self.model = model.chain, model
        self._p = chain.parameters.vector(parameters)
        self._numeric, self._stepper = model.numpy(self._p), JointStepper(model, "modal_midpoint", self._p.tolist())
        self._space, self.gauges, self._names = self._stepper.space, gauges(chain), sensors(chain)
        self._strains = self._numeric.strain_slopes()[bending(chain)]
        self._felt = model.once("accelerometer", lambda: tip_acceleration(chain, "parameters"))
        self.noise, n = Noise(0.0), model.nv
        self._q, self._v, self._P = np.array(chain.home), np.zeros(n), np.zeros((2 * n, 2 * n))
        self.innovations: dict[str, Innovation] = {}
        """What the last update made of each measurement; empty before one."""
        self._judgements = self._none_yet()

    def start(self, q: Numbers, v: Numbers, deviation_q: Any, deviation_v: Any, noise: Noise) -> None:
        """Begin at a state, as of :class:`..runtime.estimator.CompiledEstimator`."""
        chain = self.model.chain
        q, v, *sizes = checked_start(chain, q, v, deviation_q, deviation_v)
        check_noise(chain, noise)
        q, v, _ = self._shut(chain.unit(q), v)
        q, v, T = self._shut(q, v)  # the projection is that at closed rates
        S = T @ self._conditioned(np.diag(np.concatenate(sizes)))
        P = S @ S.T
        self.innovations, self._judgements = {}, self._none_yet()
        self.put(q, v, P)
        self.set(noise)

    def set(self, noise: Noise) -> None:
        """Change the noise model."""
        check_noise(self.model.chain, noise)
        self.noise = noise

    def put(self, q: Numbers, v: Numbers, P: Any) -> None:
        """Set mean and covariance."""
        self._q, self._v, self._P = np.array(q, float), np.array(v, float), np.array(P, float)

    @property
    def state(self) -> tuple[np.ndarray, np.ndarray]:
        """The mean of q (nq,) and of v (nv,)."""
        return self._q.copy(), self._v.copy()

    @property
    def covariance(self) -> np.ndarray:
        """``P`` of [q; v], (2 nv, 2 nv)."""
        return self._P.copy()

    # ------------------------------------------------------------------------------ prediction

    def predict(self, tau: Numbers, w_ext: Loads, dt: float) -> None:
        """Predict the state ``dt`` seconds later; torques and tensions (n_tau) and tip wrenches (n, 6) are held."""
        tau, w_ext = checked_input(self.model.chain, tau, w_ext)
        check_step(dt)
        q, v = self._stepper.step(self._stepper.initial(self._q, self._v), tau, w_ext, dt)
        Phi, G = self._transition(*self._middle(q, v, dt), tau, w_ext, dt)
        n, S = self.model.nv, Phi @ root(self._P)
        kicks = G * np.sqrt(dt * spread(self.noise.density_v, "density_v", n))
        P = S @ S.T + kicks @ kicks.T
        P[np.arange(n), np.arange(n)] += dt * spread(self.noise.density_q, "density_q", n)
        self._accept(q, v, P)

    def _middle(self, q: np.ndarray, v: np.ndarray, dt: float) -> tuple[np.ndarray, np.ndarray]:
        """The state in the middle of a step to q and v."""
        rate, chain = (self._v + v) / 2, self.model.chain
        half = dt / 2 * rate
        half[chain.flat_v] = (q - self._q)[chain.flat_q] / 2
        return self._moved(self._q, half), rate

    def _transition(
        self, q: np.ndarray, v: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, h: float
    ) -> tuple[np.ndarray, np.ndarray]:
        """The implicit midpoint rule of the motion linearised in the middle of a step, and its answer to noise."""
        by_q, by_v, _ = self._numeric.derivatives(q, v, tau, w_ext)
        n = self.model.nv
        one, none = np.eye(n), np.zeros((n, n))
        A = np.block([[none, one], [by_q, by_v]])
        A[:n, :n] = self.model.chain.carried(v)
        left = np.eye(2 * n) - h / 2 * A
        try:
            solved = np.linalg.solve(left, np.hstack([np.eye(2 * n) + h / 2 * A, np.vstack([none, one])]))
        except np.linalg.LinAlgError:
            raise SingularError(TOO_LONG) from None
        return solved[:, : 2 * n], solved[:, 2 * n :]

    # ------------------------------------------------------------------------------ update

    def update(
        self,
        tau: Numbers,
        w_ext: Loads,
        encoder: Numbers | None = None,
        strain: Numbers | None = None,
        acceleration: Numbers | None = None,
        **poses: Any,
    ) -> None:
        """Update the estimate by measurements, as of :class:`..runtime.estimator.CompiledEstimator`."""
        tau, w_ext = checked_input(self.model.chain, tau, w_ext)
        given = {"encoder": encoder, "strain": strain, "acceleration": acceleration} | poses
        measured, S = checked_measurements(self.model.chain, self.noise, given), root(self._P)
        found, judgements, used = {}, {}, []
        for name, (values, made) in measured.items():
            size = self._names[name][2]
            rest, normalised, weight = np.full(size, np.nan), np.full(size, np.nan), np.zeros(size)
            if made.any():
                H, left, variances, there = self._rows(name, values, made, tau, w_ext)
                sizes = deviations(S, H, variances)
                rest[there], normalised[there] = left[there], (left / sizes)[there]
                weight, judgements[name] = self._judged(name, normalised, there)
                taken = weight > 0
                more = (1 / weight[taken] - 1) * sizes[taken] ** 2
                excess = np.maximum(np.abs(normalised[taken]) / (self.noise.gate or np.inf), 1.0)
                times, trial = judgements[name][:, taken]
                slips = np.where(times == self.noise.patience - trial + 1, left[taken] * (1 - 1 / excess), 0.0)
                used.append([H[taken], left[taken], variances[taken] + more, slips, np.minimum(excess, WIDEN)])
            found[name] = Innovation(rest, normalised, ~np.isnan(normalised) & (weight == 0), weight)
        if used:
            dx, S = corrected(S, *(np.concatenate(x) for x in zip(*used, strict=True)))
            n = self.model.nv
            self._accept(self._moved(self._q, dx[:n]), self._v + dx[n:], S @ S.T)
        self.innovations, self._judgements = found, self._judgements | judgements

    def _rows(
        self, name: str, values: np.ndarray, made: np.ndarray, tau: np.ndarray, w_ext: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Of every entry of a measurement its row, innovation and variance, and whether it was made."""
        H, rest = self._innovation(name, values, tau, w_ext)
        deviation = spread(getattr(self.noise, name), name, self._names[name][2])
        return H, rest, deviation**2, np.repeat(made, len(H) // len(made))

    def _none_yet(self) -> dict[str, np.ndarray]:
        """Of each measurement (2, entries): how often in a row beyond the gate, by how much the patience is less."""
        return {name: np.zeros((2, size[2]), int) for name, size in self._names.items()}

    def _judged(self, name: str, normalised: np.ndarray, made: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The weight of every entry, those of an attitude as one, and what :meth:`_none_yet` counts."""
        together, noise = 3 if name.endswith("_attitude") else 1, self.noise
        sizes = np.where(made, np.abs(normalised), 0.0).reshape(-1, together).max(axis=1)
        sizes = np.repeat(sizes, together)
        beyond = sizes > (noise.gate or np.inf)
        times, trial = self._judgements[name]
        after = np.where(times > 0, noise.patience - 1, np.maximum(trial - 1, 0))
        trial = np.where(made & ~beyond, after, trial)
        times = np.where(beyond, np.minimum(times + 1, noise.patience + 2), np.where(made, 0, times))
        doubted = ~beyond & (sizes > (noise.doubt or np.inf))
        weight = np.where(doubted, noise.doubt / np.where(doubted, sizes, 1.0), 1.0) ** 2
        refused = beyond & (times <= noise.patience - trial)
        return np.where(made & ~refused, weight, 0.0), np.array([times, trial])

    def _innovation(
        self, name: str, values: np.ndarray, tau: np.ndarray, w_ext: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """The rows of a measurement over changes (2 nv), and what its values have over those of the estimate."""
        if name == "acceleration":
            return self._acceleration(values, tau, w_ext)
        if name in ("encoder", "strain"):
            return self._encoder(values) if name == "encoder" else self._strain(values)
        word, _, what = name.partition("_")
        own = [one for one in pose_sensors(self.model.chain) if one.word == word]
        find = {"position": self._position, "attitude": self._attitude, "rate": self._rate}[what]
        found = [find(one, part) for one, part in zip(own, np.split(values, len(own)), strict=True)]
        return np.vstack([H for H, _ in found]), np.concatenate([rest for _, rest in found])

    def _encoder(self, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        of_q, of_v = np.array(encoders(self.model.chain), int).reshape(-1, 2).T
        return np.eye(2 * self.model.nv)[of_v], values - self._q[of_q]

    def _strain(self, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        chain, fibre = self.model.chain, fibres(self.model.chain, self.noise)
        H = np.zeros((len(self.gauges), 2 * chain.nv))
        H[:, chain.eta_v : chain.nv] = -fibre[:, None] * self._strains
        return H, values - H[:, chain.eta_v : chain.nv] @ self._q[chain.eta_q :]

    def _acceleration(self, values: np.ndarray, tau: np.ndarray, w_ext: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, v, numeric = self._q, self._v, self._numeric
        vdot = numeric.forward_dynamics(q, v, tau, w_ext)[0]
        by_q, by_v, _ = numeric.derivatives(q, v, tau, w_ext)
        given = {"q": q, "v": v, "vdot": vdot, "p": self._p}
        found = function_of(self._felt)({name: list(given[name]) for name in self._felt.inputs}, EPSILON)[0]
        of_q, of_v, of_vdot = (np.reshape(found[f"a_{x}"], (-1, 3)).T for x in ("q", "v", "vdot"))
        return np.hstack([of_q + of_vdot @ by_q, of_v + of_vdot @ by_v]), values - found["a"]

    def _position(self, one: PoseSensor, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        H, own = np.zeros((3, 2 * self.model.nv)), one.part
        q = self._q[own.q]
        H[:, own.v] = np.transpose([own.joint.coordinate_rates(q, unit)[:3] for unit in np.eye(own.joint.nv)])
        return H, values - q[:3]

    def _attitude(self, one: PoseSensor, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Twice the vector part of the quaternion that leads from the estimate to what was measured."""
        turn, first = one.turn(self._q), one.part.v.start
        rest = angular_velocity(turn, values / np.linalg.norm(values))
        return np.eye(2 * self.model.nv)[first : first + 3], rest * np.copysign(1.0, turn @ values)

    def _rate(self, one: PoseSensor, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        n, first = self.model.nv, one.part.v.start
        return np.eye(2 * n)[n + first : n + first + 3], values - self._v[first : first + 3]

    # ------------------------------------------------------------------------------ loops

    def _accept(self, q: np.ndarray, v: np.ndarray, P: np.ndarray) -> None:
        """The new estimate, closed and of full symmetry, if it is finite."""
        q, v, T = self._shut(q, v)
        if self.model.chain.closing.rows:
            S = T @ root(P)
            P = S @ S.T
        if not all(np.isfinite(x).all() for x in (q, v, P)):
            raise DivergedError(NOT_FINITE)
        self.put(q, v, P)

    def _shut(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The closed state, and the projection (2 nv, 2 nv) of changes onto motions that keep it closed."""
        n = self.model.nv
        J = J_q = reach = np.zeros((0, n))
        self._rows_of_loops = J, J_q
        if not self.model.chain.closing.rows:
            return q, v, np.eye(2 * n)
        for k in range(ROUNDS * CHORDS):
            if k % CHORDS == 0:
                J, J_q, reach = self._directions(q, v)
            q = self._moved(q, -reach @ self._numeric.gaps(q, None)[0])
        rows, frames = self._numeric.gaps(q, None)[0], self._numeric.mismatch(q)
        if not ((np.abs(rows) < CLOSED).all() and (frames < EPSILON**0.5).all()):
            raise SingularError(OPEN)
        self._rows_of_loops = J, J_q
        keep = np.eye(n) - reach @ J
        T = np.block([[keep, np.zeros((n, n))], [-reach @ J_q @ keep, keep]])
        return q, v - reach @ (J @ v), T

    def _directions(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """``J``, ``J_q`` of ``J v``, and what gaps take to close, by the inertia of a step of one second."""
        chain, own = self.model.chain, self._stepper.dynamics.own
        own = own.linearised_over(own.of(q), own.of(v), FIRM, own.of(v))
        M = self._numeric.mass_matrix(q)
        at = slice(chain.nv - chain.n_given, None)
        M[at, at] += chain.modal_product(own.added(FIRM)[:, None], np.eye(chain.n_given))
        _, J, J_q, *_ = (np.array(x) for x in closing(self.model)(q, v, np.zeros(len(chain.closing.rows)), self._p))
        answers = np.linalg.solve(M, J.T)
        return J, J_q, self._numeric.row_forces(J @ answers, answers.T).T

    def _conditioned(self, S: np.ndarray) -> np.ndarray:
        """The root of a covariance where it is known that the loops are closed, up to rounding."""
        J, J_q = self._rows_of_loops
        for H in np.vstack([np.hstack([J, np.zeros_like(J)]), np.hstack([J_q, J])]):
            size = H * H @ np.sum(S * S, axis=1)
            if size > 0:
                S = corrected(S, H[None], np.zeros(1), np.array([EPSILON * size]))[1]
        return S

    def _moved(self, q: np.ndarray, change: np.ndarray) -> np.ndarray:
        moved = self._space.moved(q, change)
        return self.model.chain.unit(moved)
