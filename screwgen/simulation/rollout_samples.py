"""What follows from a rollout, sample by sample: wrenches, tip positions, what is reported, and what is measured."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from dataclasses import dataclass
from math import prod

import numpy as np

from ..algorithms.robot_function import entries
from ..algorithms.robot_functions import reported
from ..integrators.methods import METHODS
from ..robot_model import RobotModel
from ..runtime.memory import pointer
from ..runtime.sampled import library_of, sampled
from .compiled_runs import instance
from .limited_inputs import LimitedInputs, held
from .measured import STRAIN, measured, strain


@dataclass(frozen=True)
class Source:
    """The model of a rollout and what was given.

    ``given``: `tau`, `w_ext` (batch or 1, periods or 1, numbers), `parameters` (batch or 1, n). ``settling``: as of
    :meth:`.Method.settling`, s.
    """

    model: RobotModel
    given: Mapping[str, np.ndarray]
    settling: float

    @property
    def shapes(self) -> dict[str, tuple[int, ...]]:
        """What follows from a sample, by name, with its shape."""
        chain = self.model.chain
        told = {row.name: (entries(row, chain),) for row in reported(chain)}
        return {"wrench": (chain.n, 6), "tip_position": (3,)} | told

    def at_states(self, name: str, q: np.ndarray, v: np.ndarray) -> np.ndarray | tuple[np.ndarray, ...] | None:
        """What follows from coordinates and rates alone, (batch, samples, …); None where more is needed.

        ``name``: of what runs report, of which the results stand behind each other, or of what sensors measure.
        """
        if sampled(self.model.chain, name) is None:
            return None
        found = library_of(self.model, name)(name, self.given["parameters"], q, v)
        if name not in self.shapes:
            return found if len(found) > 1 else found[0]
        return np.concatenate([x.reshape(*x.shape[:2], -1) for x in found], axis=2) if len(found) > 1 else found[0]

    def samples(self, q: np.ndarray, v: np.ndarray) -> dict[str, np.ndarray]:
        """What follows from `q` (batch, samples, nq), `v` (.., nv), by name, (batch, samples, …)."""
        count, samples, _ = q.shape
        p, sizes = self.given["parameters"], [prod(size) for size in self.shapes.values()]
        compiled = instance(self.model, p[0], METHODS["modal_midpoint"])
        rows = np.empty((count, samples, sum(sizes)))
        for k in range(count):
            if k and len(p) > 1:
                compiled.prepare(p[k])
            inputs = [self._held(name, k, samples) for name in ("tau", "w_ext")]
            given = np.ascontiguousarray(np.hstack([q[k], v[k], *inputs]), float)
            over = ctypes.c_double(self.settling)
            compiled.library.shim_samples(compiled.memory, samples, over, pointer(given), pointer(rows[k]))
        parts = np.split(rows, np.cumsum(sizes)[:-1], axis=2)
        return {
            name: part.reshape(count, samples, *size)
            for (name, size), part in zip(self.shapes.items(), parts, strict=True)
        }

    def _held(self, name: str, k: int, samples: int) -> np.ndarray:
        """The input of a scenario at its samples (samples, numbers); the last one holds it on."""
        return self._at_samples(name, samples)[k if len(self.given[name]) > 1 else 0]

    def _at_samples(self, name: str, samples: int) -> np.ndarray:
        """An input at the samples, (batch or 1, samples, numbers)."""
        of = self.given[name]
        return of[:, np.minimum(np.arange(samples), of.shape[1] - 1)]

    def applied(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """What steps that begin at the samples hold of the torques and tensions, (batch, samples, n_tau)."""
        tau = held(self.model, q, v, self._at_samples("tau", q.shape[1]), self.given["parameters"][:, None])
        return np.broadcast_to(tau, (*q.shape[:2], self.model.n_tau))

    def limited(self, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> LimitedInputs:
        """Which inputs the samples hold otherwise than they were given."""
        found = LimitedInputs.none(self.model)
        if not (self.model.chain.holds and self.given["tau"].shape[1]):
            return found
        return found.take(t, self._at_samples("tau", q.shape[1]), self.applied(q, v))

    def measured(self, name: str, q: np.ndarray, v: np.ndarray) -> np.ndarray | tuple[np.ndarray, ...]:
        """What sensors measure at the samples (batch, samples, …); a tuple where a function has several results."""
        p, samples = self.given["parameters"], q.shape[1]
        if name == STRAIN and len(p) == 1:
            return strain(self.model, q, p[0])
        if (quick := self.at_states(name, q, v)) is not None:
            return quick
        tau, found = self.applied(q, v), []
        for k in range(len(q)):
            held = {
                "tau": tau[k],
                "w_ext": self._held("w_ext", k, samples).reshape(samples, -1, 6),
            }
            found.append(measured(self.model, name, {"q": q[k], "v": v[k]} | held, p[k if len(p) > 1 else 0]))
        several = isinstance(found[0], tuple)
        return tuple(map(np.array, zip(*found, strict=True))) if several else np.array(found)
