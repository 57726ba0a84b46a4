"""What steps hold of the inputs of a motion, and of which they held something else: from when, and how often."""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np

from ..algorithms.law_programs import on_arrays
from ..algorithms.robot_programs import force_rates, held_inputs
from ..backends.numpy.python import c4, c5
from ..ir.replay import run
from ..robot_model import RobotModel
from .hits import LimitWarning

SLIGHT = 1e-9
"""The share of an input by which what is found for a posture may be beyond a limit."""


def held(model: RobotModel, q: np.ndarray, v: np.ndarray, tau: np.ndarray, p: np.ndarray) -> np.ndarray:
    """What steps that begin at ``q`` (…, nq), ``v`` (…, nv) hold of ``tau`` (…, n_tau); ``p`` (…, parameters)."""
    if not model.chain.holds:
        return tau
    program = model.once("held inputs", lambda: held_inputs(model.chain))
    given = {"q": q, "v": v, "tau": tau, "p": p}
    found, _ = run(program, {name: list(np.moveaxis(x, -1, 0)) for name, x in given.items()}, _functions)
    return np.stack(np.broadcast_arrays(*found["held"]), axis=-1)


def warn_at_rest(model: RobotModel, q: np.ndarray, tau: np.ndarray, p: np.ndarray, stacklevel: int = 2) -> None:
    """A :class:`LimitWarning` for each input that steps which begin at rest at `q` hold otherwise than as `tau`."""
    most = held(model, q, _at_rest(model, q, tau, p), tau, p)
    for k in np.flatnonzero(np.abs(most - tau) > SLIGHT * np.abs(tau)):
        what = f"{model.tau_names[k]} is {tau[k]:.6g} in this posture, and {most[k]:.6g} as a step holds it"
        warnings.warn(f"{what}; state a stronger drive, or rest elsewhere", LimitWarning, stacklevel=stacklevel + 1)


def _functions(op: str, x: np.ndarray, *more: np.ndarray) -> np.ndarray:
    """The primitives on arrays; Stumpff's functions, which exact rods need, entry by entry."""
    series = {"c4": c4, "c5": c5}
    return np.vectorize(series[op], otypes=[float])(x) if op in series else on_arrays(op, x, *more)


def _at_rest(model: RobotModel, q: np.ndarray, tau: np.ndarray, p: np.ndarray) -> np.ndarray:
    """Rates and internal states (nvz,) at rest; what held laws remember of the inputs no longer changes under these."""
    chain, v = model.chain, np.zeros(model.chain.nvz)
    if chain.n_held_states:
        program, count = model.once("force rates", lambda: force_rates(chain)), chain.n_force_states
        given = {"q": list(q), "v": list(v), "tau": list(tau), "h": [0.0], "p": list(p)}
        rates = (run(program, given | {"start": [z] * count}, _functions)[0]["rate"] for z in (0.0, 1.0))
        gain, less = (np.array(x, float) for x in rates)
        v[chain.force_states] = np.divide(gain, gain - less, out=np.zeros(count), where=gain > less)
        v[chain.force_states.start : chain.held_states.start] = 0.0
    return v


@dataclass
class LimitedInputs:
    """Of how many samples each input was held otherwise than it was given, (n_tau,), and the ``first`` such time, s.

    In a run of the C, its loop fills the arrays.
    """

    first: np.ndarray
    count: np.ndarray
    samples: int = 0

    @classmethod
    def none(cls, model: RobotModel) -> LimitedInputs:
        """Those before the first sample."""
        return cls(np.full(model.n_tau, np.nan), np.zeros(model.n_tau, np.int32))

    def take(self, t: np.ndarray, given: np.ndarray, held: np.ndarray) -> LimitedInputs:
        """Look at samples at ``t`` (N,): the inputs (…, N, n_tau) as they were given, and as they were held."""
        other = (np.not_equal(given, held) & ~np.isnan(given)).reshape(-1, len(t), len(self.count))
        self.count += other.sum(axis=(0, 1), dtype=np.int32)
        for k in np.flatnonzero(other.any(axis=(0, 1))):
            self.first[k] = np.fmin(self.first[k], t[other[:, :, k].any(axis=0)].min())
        self.samples += other.shape[0] * other.shape[1]
        return self

    def joined(self, other: LimitedInputs) -> LimitedInputs:
        """Those of the samples of both."""
        first, count = np.fmin(self.first, other.first), self.count + other.count
        return LimitedInputs(first, count, self.samples + other.samples)

    def warn(self, model: RobotModel, stacklevel: int = 2) -> None:
        """A :class:`LimitWarning` for each axis whose input was held otherwise; ``stacklevel`` as of a function."""
        said = [" or ".join(dict.fromkeys(law.SAID for law in laws)) for laws in model.chain.laws_of_inputs]
        for k in np.flatnonzero(self.count):
            share = f"{100 * self.count[k] / self.samples:.3g} % of the samples, first at t = {self.first[k]:.6g} s"
            what = f"{model.tau_names[k]} was held {said[k]}: in {share}"
            warnings.warn(f"{what}; ask for less, or state a stronger drive", LimitWarning, stacklevel=stacklevel + 1)
