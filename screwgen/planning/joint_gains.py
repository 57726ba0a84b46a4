"""Gains of a joint law from the sampled closed loop, over postures and models: the fastest decay of what is slowest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..arguments import Given, Numbers, array, seconds
from ..errors import UsageError
from ..lazily import linalg
from ..robot_model import RobotModel
from .make import scaled
from .members import Still
from .refusals import refuse_robot

STEP = 1e-3
SLOWEST, FASTEST = 1.0, 60.0
"""Between which a joint alone, all others held, would swing on its gain, rad/s."""
DAMPING = (0.05, 3.0)
"""Between which its damping ratio would be."""
GROWTH = 1e-4
"""The ratio to its frequency at which a fast oscillation may grow: a tenth of what metals take out of it."""
THRIFT = 0.03
"""What a factor e of a gain is worth in decay, 1/s: of laws that are alike the softer one is taken."""
STEEP, SPARE = 1e4, 2.0
ROUNDS, CROWD, SEED = 60, 8, 1


@dataclass(frozen=True, eq=False)
class JointGains:
    """A joint law and what its sampled loop does, over all postures and models that were looked at."""

    kp: np.ndarray
    kd: np.ndarray
    decay: float
    """1/s: of the slowest motion of the loop below `band`."""
    damping: float
    """The least damping ratio of the motions below `band`."""
    band: float
    """Hz: up to where motions count as those of the loop."""
    margin: float
    """The least damping ratio of all motions, fast ones too; no damping of materials is assumed beyond the file's."""
    spare: float
    """The factor on all gains up to which nothing grows; at most ten."""

    @property
    def line(self) -> str:
        """The figures in words."""
        return (
            f"slowest decay {self.decay:.3g} 1/s and least damping {self.damping:.3g} up to {self.band:.3g} Hz; "
            f"least damping of all {self.margin:.2g}; all gains may grow by a factor {self.spare:.3g}"
        )


def gains(
    model: RobotModel,
    postures: Sequence[Numbers],
    *,
    models: Sequence[Mapping[str, float]] = (),
    step: float = STEP,
    kp_max: Numbers | None = None,
    kd_max: Numbers | None = None,
    parameters: Given = None,
) -> JointGains:
    """Gains `kp`, `kd` of all joints under which what is slowest decays fastest, in all `postures` and `models`.

    The loop is the one that a clock of `step` seconds closes: torques are held between samples. `models`: factors of
    parameters, as :func:`plan` has them. `kp_max`, `kd_max` (n_joints,): the largest gains. What counts are motions up
    to a fortieth of the clock's rate; faster ones, of further modes, may only not grow, with twice the gains neither.

    Raises UsageError where no gains are stable.
    """
    refuse_robot(model, "search for gains", "state gains of your own")
    m, step = model.n_joints, seconds(step, "the step")
    values = model.chain.parameters.vector(parameters)
    stills = [Still(model, p) for p in (values, *(scaled(model, values, f) for f in models))]
    rests = [(still, still.held(array(q, "postures:", (m,))).q) for q in postures for still in stills]
    if not rests:
        raise UsageError("postures: are none; give at least one")
    loops = [SampledLoop.of(still, q, step) for still, q in rests]
    inertia = np.max([np.diag(np.array(still.inertia(q)))[:m] for still, q in rests], axis=0)
    search = Search(loops, inertia, 0.025 / step, *(_most(x, m) for x in (kp_max, kd_max)))
    return search.found()


def _most(given: Numbers | None, m: int) -> np.ndarray:
    most = np.full(m, np.inf) if given is None else array(given, "gains: largest:", (m,))
    if not (most > 0).all():
        raise UsageError("gains: the largest ones must be > 0")
    return most


@dataclass(frozen=True)
class SampledLoop:
    """Small motions about a rest from sample to sample: `x+ = A x + B tau`."""

    A: np.ndarray
    B: np.ndarray
    step: float

    @classmethod
    def of(cls, still: Still, q: np.ndarray, step: float) -> SampledLoop:
        """About a rest, torques held over a step."""
        n, m = len(q), still.joints
        M, D, K = still.matrices(q)
        A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, np.hstack([K, D]))]])
        B = np.vstack([np.zeros((n, m)), np.linalg.solve(M, np.eye(n)[:, :m])])
        whole = linalg.expm(step * np.block([[A, B], [np.zeros((m, 2 * n + m))]]))
        return cls(whole[: 2 * n, : 2 * n], whole[: 2 * n, 2 * n :], step)

    def poles(self, kp: np.ndarray, kd: np.ndarray) -> np.ndarray:
        """Rates of growth and angular frequencies of the loop, 1/s, as complex numbers."""
        n, m = len(self.A) // 2, len(kp)
        G = np.zeros((m, 2 * n))
        G[range(m), range(m)], G[range(m), range(n, n + m)] = kp, kd
        return np.log(np.linalg.eigvals(self.A - self.B @ G).astype(complex)) / self.step


@dataclass(frozen=True)
class Search:
    """The search for gains over loops."""

    loops: Sequence[SampledLoop]
    inertia: np.ndarray
    band: float
    kp_max: np.ndarray
    kd_max: np.ndarray

    def gains(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Gains from logarithms of frequencies and damping ratios of joints alone."""
        rate, damping = np.exp(np.split(x, 2))
        kp, kd = self.inertia * rate**2, 2 * damping * self.inertia * rate
        return np.minimum(kp, self.kp_max), np.minimum(kd, self.kd_max)

    def figures(self, kp: np.ndarray, kd: np.ndarray) -> tuple[float, float, float]:
        """Slowest decay and least damping up to the band, and least damping of all."""
        each = [loop.poles(kp, kd) for loop in self.loops]
        slow = np.concatenate([s[np.abs(s.imag) < 2 * np.pi * self.band] for s in each])
        every = np.concatenate(each)
        ratio = lambda s: float((-s.real / np.maximum(np.abs(s), 1e-300)).min())  # noqa: E731
        return float((-slow.real).min()) if len(slow) else np.inf, ratio(slow) if len(slow) else 1.0, ratio(every)

    def cost(self, x: np.ndarray) -> float:
        """What is minimised: slowness, then size, and growth above all."""
        kp, kd = self.gains(x)
        decay, _, margin = self.figures(kp, kd)
        margin = min(margin, self.figures(SPARE * kp, SPARE * kd)[2])
        return -decay + THRIFT * float(np.abs(x).sum()) + STEEP * max(0.0, -margin - GROWTH)

    def found(self) -> JointGains:
        """The best gains; the search draws the same numbers in every run."""
        from scipy.optimize import differential_evolution, minimize

        m = len(self.inertia)
        bounds = [tuple(np.log((SLOWEST, FASTEST)))] * m + [tuple(np.log(DAMPING))] * m
        rough = differential_evolution(
            self.cost, bounds, seed=SEED, popsize=CROWD, maxiter=ROUNDS, polish=False, init="sobol"
        )
        x = minimize(self.cost, rough.x, method="Nelder-Mead", options={"maxfev": 500}).x
        kp, kd = (np.array([float(f"{g:.3g}") for g in each]) for each in self.gains(x))
        decay, damping, margin = self.figures(kp, kd)
        if margin < -2 * GROWTH or decay <= 0:
            raise UsageError("gains: none were found that are stable at this step; take a shorter one")
        return JointGains(kp, kd, decay, damping, self.band, margin, self._spare(kp, kd))

    def _spare(self, kp: np.ndarray, kd: np.ndarray) -> float:
        """How far gains may grow together, up to ten times."""
        factors = np.geomspace(1.0, 10.0, 47)
        held = [self.figures(s * kp, s * kd)[2] >= -2 * GROWTH for s in factors]
        return float(factors[max(0, held.index(False) - 1) if False in held else -1])
