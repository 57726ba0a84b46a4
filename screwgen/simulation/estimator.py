"""The estimator in NumPy: an extended Kalman filter over q and v, for trees, loops, floating bases and ball joints.

It does what the generated C does, in the same order, and needs no compiler. The covariance is that of changes
[δ; δv] (nv + nvz), δ that by which joints move their coordinates: of the pose of a floating base [turn; shift] in its
own axes, pose exp(δ), of a ball joint a turn in axes of its link. δv holds changes of rates, then of internal states.
Where loops close the tree the mean is closed after every call, and the covariance is projected onto the motions that
keep it closed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..algorithms.measurement import Measurement, SensorNumber, comparison
from ..arguments import Given
from ..backends.numpy import prescribed
from ..backends.numpy.covariance import corrected, root
from ..backends.numpy.covariance import deviations as of_innovations
from ..backends.numpy.held import HeldChain
from ..backends.numpy.numeric import EPSILON, Numeric, function_of, singular
from ..errors import DivergedError, ScrewgenError, SingularError
from ..ir.program import Program
from ..robot_model import RobotModel
from ..runtime.estimator import NOT_FINITE, OPEN, TOO_LONG
from ..runtime.filtering import Judged, KalmanFilter
from ..runtime.measurements import Consistency, Innovation, Measured, deviations, gate_of, numbers, of_rates, spread
from .integrate import JointStepper
from .mobility import closing

ROUNDS, CHORDS, CLOSED = 2, 6, 1e4 * EPSILON
"""Corrections with the same directions, and the gap, m or of cosines, at which loops are closed."""
WIDEN = 3.0
"""By how much deviations become larger at most in an update that believes what is beyond the gate: more would throw far
away what is hardly measured."""
FIRM = 1.0
"""The seconds over which springs and modes resist the closing of a loop, so that joints close it."""


class Compared(NamedTuple):
    """A measurement beside the estimate."""

    H: np.ndarray
    """(n, nv + nvz): the derivatives of its entries with changes of the state."""
    rest: np.ndarray
    """(n,): what was measured less what the estimate says."""


class AtParameters(NamedTuple):
    """What a filter has of its robot at parameters ``p`` (n,)."""

    p: np.ndarray
    numeric: Numeric
    stepper: JointStepper
    chained: HeldChain | None


class Estimator(KalmanFilter):
    """The filter in NumPy; arguments, results and errors as of :class:`.KalmanFilter`."""

    def __init__(
        self, model: RobotModel, parameters: Given = None, measurements: Sequence[str | Measurement] | None = None
    ):
        super().__init__(model, parameters, measurements)
        chain = model.chain
        self._take(self._at_parameters(self._p))
        self._put(np.array(chain.home), np.zeros(chain.nvz), np.zeros((chain.n_changes, chain.n_changes)))
        self._judgements = self._none_yet()

    def _at_parameters(self, p: np.ndarray) -> AtParameters:
        """Of parameters (n,); raises UsageError where there is no such robot."""
        chain, stepper = self.model.chain, JointStepper(self.model, "modal_midpoint", p.tolist())
        return AtParameters(p, self.model.numpy(p), stepper, HeldChain(chain, p) if chain.holds else None)

    def _take(self, at: AtParameters) -> None:
        """The filter is that of these parameters from now on."""
        self._at = at
        self._p, self._numeric, self._stepper, self._chained = at
        self._space, self._hold = at.stepper.space, at.stepper.hold

    def _start(self, q: np.ndarray, v: np.ndarray, deviation_q: np.ndarray, deviation_v: np.ndarray) -> None:
        q, v, _ = self._shut(self.model.chain.unit(q), v)
        q, v, T = self._shut(q, v)  # the projection is that at closed rates
        S = T @ self._conditioned(self._spread(np.concatenate([deviation_q, deviation_v])))
        P = S @ S.T
        self._judgements = self._none_yet()
        self._put(q, v, P)

    def _spread(self, deviations: np.ndarray) -> np.ndarray:
        """The root of the covariance of all states where those of q and v have these deviations, each by itself."""
        return np.diag(deviations)

    def _put(self, q: np.ndarray, v: np.ndarray, P: np.ndarray) -> None:
        self._q, self._v, self._P = np.array(q, float), np.array(v, float), np.array(P, float)

    @property
    def state(self) -> tuple[np.ndarray, np.ndarray]:
        """The mean of q (nq,) and of v (nvz,)."""
        return self._q.copy(), self._v.copy()

    @property
    def covariance(self) -> np.ndarray:
        """``P`` of [q; v], (nv + nvz, nv + nvz)."""
        return self._P.copy()

    # ------------------------------------------------------------------------------ prediction

    def _predict(self, tau: np.ndarray, w_ext: np.ndarray, dt: float) -> None:
        q, v = self._stepper.step(self._stepper.initial(self._q, self._v), tau, w_ext, dt)
        middle, held = self._middle(q, v, dt), self._hold(self._q, self._v, tau)
        Phi, G = self._transition(*middle, self._slopes(*middle, tau, held, w_ext), dt)
        n, S = self.model.nv, self._carried(root(self._P), Phi, G, (*middle, held, w_ext), dt)
        kicks = G * np.sqrt(dt * of_rates(self.model.chain, self.noise.density_v, "density_v"))
        P = S @ S.T
        P[: len(G), : len(G)] += kicks @ kicks.T
        P[np.arange(n), np.arange(n)] += dt * spread(self.noise.density_q, "density_q", n)
        self._accept(q, v, P)

    def _carried(
        self, S: np.ndarray, Phi: np.ndarray, G: np.ndarray, at: tuple[np.ndarray, ...], dt: float
    ) -> np.ndarray:
        """The root of the covariance after a step; `at`: q, v and inputs in its middle."""
        return Phi @ S

    def _middle(self, q: np.ndarray, v: np.ndarray, dt: float) -> tuple[np.ndarray, np.ndarray]:
        """The state in the middle of a step to q and v."""
        rate, chain = (self._v + v) / 2, self.model.chain
        half = dt / 2 * rate[: chain.nv]
        half[chain.flat_v] = (q - self._q)[chain.flat_q] / 2
        return self._moved(self._q, half), rate

    def _transition(
        self, q: np.ndarray, v: np.ndarray, slopes: tuple[np.ndarray, np.ndarray], h: float
    ) -> tuple[np.ndarray, np.ndarray]:
        """The implicit midpoint rule of the motion linearised in the middle of a step, and its answer to noise.

        ``slopes``: the derivatives of the accelerations there with coordinates and rates; those of internal states
        are among them.
        """
        chain = self.model.chain
        n, size, one = chain.nv, chain.n_changes, np.eye(chain.n_changes)
        A = np.vstack([one[n : 2 * n], np.hstack(slopes)])
        A[:n, :n] = chain.carried(v[:n])
        try:
            solved = np.linalg.solve(one - h / 2 * A, np.hstack([one + h / 2 * A, one[:, n:]]))
        except np.linalg.LinAlgError:
            raise SingularError(TOO_LONG) from None
        return solved[:, :size], solved[:, size:]

    def _slopes(
        self, q: np.ndarray, v: np.ndarray, tau: np.ndarray, held: np.ndarray, w_ext: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """The derivatives of the accelerations with coordinates and rates, under inputs as a step holds them."""
        found = self._numeric.derivatives(q, v, held, w_ext)
        return self._chained(q, v, tau, *found)[:2] if self._chained else found[:2]

    # ------------------------------------------------------------------------------ update

    def _update(self, tau: np.ndarray, w_ext: np.ndarray, measured: Measured) -> Judged:
        chain, S, consistency = self.model.chain, root(self._P), Consistency()
        found, judgements, used = {}, {}, []
        for row in self.measurements:
            values, made = measured[row.name]
            there = np.repeat(made, row.group)
            rest, normalised, weight = np.full(len(there), np.nan), np.full(len(there), np.nan), np.zeros(len(there))
            if made.any():
                (H, left), variances = self.compared(row, values, tau, w_ext), deviations(chain, row, self.noise) ** 2
                sizes = of_innovations(S, H, variances)
                rest[there], normalised[there] = left[there], (left / sizes)[there]
                weight, judgements[row.name] = self._judged(row, normalised, there)
                taken = weight > 0
                more = (1 / weight[taken] - 1) * sizes[taken] ** 2
                excess = np.maximum(np.abs(normalised[taken]) / (gate_of(row, self.noise) or np.inf), 1.0)
                times, trial = judgements[row.name][:, taken]
                slips = np.where(times == self.noise.patience - trial + 1, left[taken] * (1 - 1 / excess), 0.0)
                used.append([H[taken], left[taken], variances[taken] + more, slips, np.minimum(excess, WIDEN)])
            found[row.name] = Innovation(rest, normalised, ~np.isnan(normalised) & (weight == 0), weight)
        if used:
            dx, S, squared = corrected(S, *(np.concatenate(x) for x in zip(*used, strict=True)))
            consistency = Consistency(squared, sum(len(left) for _, left, *_ in used))
            dq, dv, more = np.split(dx, [chain.nv, chain.n_changes])
            self._corrected(dq, dv, more, S @ S.T)
        self._judgements |= judgements
        return found, consistency

    def _corrected(self, dq: np.ndarray, dv: np.ndarray, more: np.ndarray, P: np.ndarray) -> None:
        """Takes an update: its loops close at the parameters that it finds."""
        before = self._at
        self._take(self._learnt(more))
        try:
            self._accept(self._moved(self._q, dq), self._v + dv, P)
        except ScrewgenError:
            self._take(before)
            raise

    def _learnt(self, change: np.ndarray) -> AtParameters:
        """The model after an update that says so much of entries of the estimate behind [q; v]."""
        return self._at

    def _none_yet(self) -> dict[str, np.ndarray]:
        """Of each measurement (2, entries): how often in a row beyond the gate, by how much the patience is less."""
        return {row.name: np.zeros((2, row.size(self.model.chain)), int) for row in self.measurements}

    def _judged(self, row: Measurement, normalised: np.ndarray, made: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The weight of every entry, one for those judged together, and what :meth:`_none_yet` counts."""
        noise, gate = self.noise, gate_of(row, self.noise)
        sizes = np.where(made, np.abs(normalised), 0.0).reshape(-1, row.group).max(axis=1)
        sizes = np.repeat(sizes, row.group)
        beyond = sizes > (gate or np.inf)
        times, trial = self._judgements[row.name]
        trial = np.minimum(trial, noise.patience - 1)  # patience may have become less
        after = np.where(times > 0, noise.patience - 1, np.maximum(trial - 1, 0))
        trial = np.where(made & ~beyond, after, trial)
        times = np.where(beyond, np.minimum(times + 1, noise.patience + 2), np.where(made, 0, times))
        doubted = ~beyond & (sizes > (noise.doubt or np.inf))
        weight = np.where(doubted, noise.doubt / np.where(doubted, sizes, 1.0), 1.0) ** 2
        refused = beyond & (times <= noise.patience - trial)
        return np.where(made & ~refused, weight, 0.0), np.array([times, trial])

    def compared(self, row: Measurement, values: np.ndarray, tau: np.ndarray, w_ext: np.ndarray) -> Compared:
        """A measurement beside the estimate, of its values; where these are NaN it is of no use."""
        chain, numeric = self.model.chain, self._numeric
        program, spans = self.model.once(("comparison", row), lambda: comparison(row, chain))
        held = self._hold(self._q, self._v, tau)
        given: dict[str, Any] = {"q": self._q, "v": self._v, "tau": held, "w_ext": w_ext.ravel(), "p": self._p}
        given["measured"] = np.where(np.isnan(values), 1.0, values)
        given |= {number.keyword: self._number(row, number) for number in row.numbers}
        if "vdot" in program.inputs:
            given["vdot"] = numeric.forward_dynamics(self._q, self._v, held, w_ext)[0]
        found = self._found(program, given)
        H, at = np.zeros((len(spans), chain.n_changes)), 0
        for own, (first, size) in zip(H, spans, strict=True):
            own[first : first + size] = found["rows"][at : at + size]
            at += size
        if "by_vdot" in found:
            by_q, by_v = self._slopes(self._q, self._v, tau, held, w_ext)
            H += np.reshape(found["by_vdot"], (-1, chain.nvz)) @ np.hstack([by_q, by_v])
        return Compared(H, np.array(found["rest"]))

    def _number(self, row: Measurement, number: SensorNumber) -> np.ndarray:
        """Numbers of a sensor, stated or as they follow from the parameters."""
        if callable(number.start):
            return np.array(number.start(self.model.chain, self._p.tolist()), float)
        return numbers(self.model.chain, row, self.noise)[number.name]

    def _found(self, program: Program, given: Mapping[str, Any]) -> dict[str, list[float]]:
        """The results of a program; raises SingularError that names the link, DivergedError where there are none."""
        try:
            found, guards = function_of(program)({name: list(given[name]) for name in program.inputs}, EPSILON)
        except (ZeroDivisionError, ValueError, OverflowError):
            raise DivergedError(NOT_FINITE) from None
        for guard, link in zip(guards, program.origins, strict=True):
            if not guard > 0:
                raise singular(self.model.chain, link, self._p)
        return found

    # ------------------------------------------------------------------------------ loops

    def _accept(self, q: np.ndarray, v: np.ndarray, P: np.ndarray) -> None:
        """The new estimate, closed and of full symmetry, if it is finite."""
        q, v, T = self._shut(q, v)
        if self.model.chain.closing.rows:
            S = T @ root(P)
            P = S @ S.T
        if not all(np.isfinite(x).all() for x in (q, v, P)):
            raise DivergedError(NOT_FINITE)
        self._put(q, v, P)

    def _shut(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The closed state, and the projection of changes of all states onto those that keep it closed."""
        n, T = self.model.nv, np.eye(len(self._P))
        A = B = self._rows_of_loops = np.zeros((0, len(T)))
        reach = np.zeros((n, 0))
        if not self.model.chain.closing.rows:
            return q, v, T
        for k in range(ROUNDS * CHORDS):
            if k % CHORDS == 0:
                A, B, reach = self._directions(q, v)
            q = self._moved(q, -reach @ self._numeric.gaps(q, None)[0])
        rows, frames = self._numeric.gaps(q, None)[0], self._numeric.mismatch(q)
        if not ((np.abs(rows) < CLOSED).all() and (frames < EPSILON**0.5).all()):
            raise SingularError(OPEN)
        self._rows_of_loops = np.vstack([A, B])
        T[:n] -= reach @ A
        T[n : 2 * n] -= reach @ (B @ T)
        return q, np.append(v[:n] - reach @ (A[:, :n] @ v[:n]), v[n:]), T

    def _directions(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The slopes (rows, states) of gaps and of their rates, and what gaps take to close in a step of one second."""
        chain, own = self.model.chain, self._stepper.dynamics.own
        own = own.over(q, v, FIRM)
        M = self._numeric.mass_matrix(q)
        at = slice(chain.nv - chain.n_given, None)
        M[at, at] += chain.modal_product(own.added(FIRM)[:, None], np.eye(chain.n_given))
        _, J, J_q, *_ = (np.array(x) for x in closing(self.model)(q, v, np.zeros(len(chain.closing.rows)), self._p))
        answers = prescribed.answers(chain, M, J.T)
        (gap_p, rate_p), none = self._gaps_by_p(q, v), np.zeros((len(J), chain.n_internal))
        A, B = np.hstack([J, np.zeros_like(J), none, gap_p]), np.hstack([J_q, J, none, rate_p])
        return A, B, self._numeric.row_forces(J @ answers, answers.T).T

    def _gaps_by_p(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The slopes (rows, k) of the gaps and of their rates with states behind those of v."""
        none = np.zeros((len(self.model.chain.closing.rows), 0))
        return none, none

    def _conditioned(self, S: np.ndarray) -> np.ndarray:
        """The root of a covariance where it is known that the loops are closed, up to rounding."""
        for H in self._rows_of_loops:
            size = H * H @ np.sum(S * S, axis=1)
            if size > 0:
                S = corrected(S, H[None], np.zeros(1), np.array([EPSILON * size]))[1]
        return S

    def _moved(self, q: np.ndarray, change: np.ndarray) -> np.ndarray:
        moved = self._space.moved(q, change)
        return self.model.chain.unit(moved)
