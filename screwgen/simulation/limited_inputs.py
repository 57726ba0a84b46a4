"""What steps hold of the inputs of a motion, and of which they held something else: from when, and how often."""

from __future__ import annotations

import warnings

import numpy as np

from ..algorithms.law_programs import on_arrays
from ..algorithms.robot_programs import held_inputs
from ..ir.replay import run
from ..robot_model import RobotModel
from .hits import LimitWarning


def held(model: RobotModel, q: np.ndarray, v: np.ndarray, tau: np.ndarray, p: np.ndarray) -> np.ndarray:
    """What steps that begin at ``q`` (…, nq), ``v`` (…, nv) hold of ``tau`` (…, n_tau); ``p`` (…, parameters)."""
    if not model.chain.holds:
        return tau
    program = model.once("held inputs", lambda: held_inputs(model.chain))
    given = {"q": q, "v": v, "tau": tau, "p": p}
    found, _ = run(program, {name: list(np.moveaxis(x, -1, 0)) for name, x in given.items()}, on_arrays)
    return np.stack(np.broadcast_arrays(*found["held"]), axis=-1)


class LimitedInputs:
    """Gathers them sample by sample, in Python or, in the arrays ``first`` and ``count`` (n_tau,), in C."""

    def __init__(self, model: RobotModel):
        self.chain, self.names = model.chain, model.tau_names
        self.first = np.full(max(model.n_tau, 1), np.nan)
        self.count = np.zeros(max(model.n_tau, 1), np.int32)

    def __call__(self, t: float, given: np.ndarray, held: np.ndarray) -> None:
        """Look at a sample: the inputs (n_tau,) as they were given, and as they were held."""
        if self.chain.holds:
            self.take(np.array([t]), np.asarray(given)[None] != held[None])

    def take(self, t: np.ndarray, other: np.ndarray) -> None:
        """Look at samples (N,): whether (…, N, n_tau) inputs were held otherwise than they were given."""
        each = other.reshape(-1, *other.shape[-2:])
        self.count[: other.shape[-1]] += each.sum(axis=(0, 1))
        for k in np.flatnonzero(each.any(axis=(0, 1))):
            self.first[k] = np.fmin(self.first[k], t[each[:, :, k].any(axis=0)].min())

    def warn(self, samples: int, stacklevel: int = 3) -> None:
        """A :class:`LimitWarning` for each axis whose input was held otherwise, of so many samples."""
        said = [", ".join(dict.fromkeys(law.SAID for law in laws)) for laws in self.chain.laws_of_inputs]
        for k in np.flatnonzero(self.count):
            share = f"{100 * self.count[k] / samples:.3g} % of the samples, first at t = {self.first[k]:.6g} s"
            what = f"{self.names[k]} was held {said[k]}: in {share}"
            warnings.warn(f"{what}; ask for less, or state a stronger drive", LimitWarning, stacklevel=stacklevel)
