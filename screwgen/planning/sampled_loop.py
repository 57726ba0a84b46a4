"""Small motions of an arm about a rest as a clock samples them, and the loop that a law of the joints closes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..lazily import linalg
from .members import AtRest, Still

ALIKE = 0.02
"""How far a fast motion may be moved by a loop, times the step, and still be known."""


class LoopGains(NamedTuple):
    """Gains of a joint law (n_joints,): N·m/rad, N·m·s/rad and N·m/(rad·s), of slides N in place of N·m, m of rad."""

    kp: np.ndarray
    kd: np.ndarray
    ki: np.ndarray | None = None
    """None: nothing is summed up."""

    @property
    def locked(self) -> np.ndarray:
        """The joints whose `kp` is infinite."""
        return np.isinf(self.kp)

    def times(self, factor: float) -> LoopGains:
        """All gains times a factor."""
        return LoopGains(factor * self.kp, factor * self.kd, None if self.ki is None else factor * self.ki)

    def rounded(self, digits: int) -> LoopGains:
        """Gains in so many digits, as a file states them."""
        short = lambda g: np.array([float(f"{x:.{digits}g}") for x in g])  # noqa: E731
        return LoopGains(short(self.kp), short(self.kd), None if self.ki is None else short(self.ki))


class Closed(NamedTuple):
    """A closed loop from sample to sample: `x+ = (A − B G) x`, with the torques `−G x`."""

    A: np.ndarray
    B: np.ndarray
    G: np.ndarray

    @property
    def transition(self) -> np.ndarray:
        """`A − B G`."""
        return self.A - self.B @ self.G


@dataclass(frozen=True)
class SampledLoop:
    """Small motions about a rest from sample to sample: `x+ = A x + B tau`."""

    A: np.ndarray
    B: np.ndarray
    step: float
    beyond: np.ndarray
    """Poles, 1/s, of open motions that turn by more than half a turn in a step: samples show them as slower ones."""

    @classmethod
    def of(cls, still: Still, rest: AtRest, step: float) -> SampledLoop:
        """About a rest, torques held over a step."""
        return cls.of_matrices(*still.matrices(rest), still.joints, step)

    @classmethod
    def of_matrices(cls, M: np.ndarray, D: np.ndarray, K: np.ndarray, joints: int, step: float) -> SampledLoop:
        """Of inertia, damping and stiffness, of which torques act on the first coordinates."""
        n, m = len(M), joints
        A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, np.hstack([K, D]))]])
        B = np.vstack([np.zeros((n, m)), np.linalg.solve(M, np.eye(n)[:, :m])])
        whole = linalg.expm(step * np.block([[A, B], [np.zeros((m, 2 * n + m))]]))
        s = np.linalg.eigvals(A).astype(complex)
        return cls(whole[: 2 * n, : 2 * n], whole[: 2 * n, 2 * n :], step, s[np.abs(s.imag) > np.pi / step])

    def closed(self, gains: LoopGains) -> Closed:
        """The loop under a joint law; behind coordinates and rates stand integrals of what joints lack."""
        n, m = len(self.A) // 2, len(gains.kp)
        G = np.zeros((m, 2 * n))
        G[range(m), range(m)], G[range(m), range(n, n + m)] = gains.kp, gains.kd
        if gains.ki is None:
            return Closed(self.A, self.B, G)
        summed = np.hstack([-self.step * np.eye(m, 2 * n), np.eye(m)])
        A = np.vstack([np.hstack([self.A, np.zeros((2 * n, m))]), summed])
        return Closed(A, np.vstack([self.B, np.zeros((m, m))]), np.hstack([G, -np.diag(gains.ki)]))

    def poles(self, gains: LoopGains) -> np.ndarray:
        """Rates of growth and angular frequencies of the loop, 1/s, as complex numbers."""
        return self.rates(self.closed(gains).transition)

    def rates(self, transition: np.ndarray) -> np.ndarray:
        """The poles of a loop that is closed about these motions; those of fast ones with their true frequencies."""
        s = rates(transition, self.step)
        for pole in self.beyond:
            shown = np.log(np.exp(pole * self.step)) / self.step
            k = int(np.abs(s - shown).argmin())
            if np.abs(s[k] - shown) * self.step < ALIKE:
                s[k] = complex(s[k].real, pole.imag)
        return s


def rates(transition: np.ndarray, step: float) -> np.ndarray:
    """Rates of growth and angular frequencies, 1/s, as complex numbers, of a motion from sample to sample."""
    return np.log(np.linalg.eigvals(transition).astype(complex)) / step


class LoopFigures(NamedTuple):
    """How motions of loops decay."""

    decay: float
    """1/s: of the slowest one below the band; of all where none is below."""
    damping: float
    """The least damping ratio below the band."""
    margin: float
    """The least damping ratio of all."""
    growth: float
    """1/s: of what grows fastest; negative where all decays."""

    @property
    def growing(self) -> str:
        """What grows, in words, if anything does: fast motions by less than materials take out of them."""
        return f", which grows by {self.growth:.2g} 1/s unless its material damps it" if self.growth > 0 else ""

    @property
    def words(self) -> str:
        """The figures in words."""
        decays = f"slowest decay {self.decay:.3g} 1/s, least damping {self.damping:.3g}"
        return f"{decays}, of all {self.margin:.2g}{self.growing}"

    @classmethod
    def of(cls, each: list[np.ndarray], band: float) -> LoopFigures:
        """Of the poles of loops; `band`, Hz."""
        slow = np.concatenate([s[np.abs(s.imag) < 2 * np.pi * band] for s in each])
        every = np.concatenate(each)
        slow = slow if len(slow) else every
        return cls(float((-slow.real).min()), _ratio(slow), _ratio(every), float(every.real.max()))


def _ratio(s: np.ndarray) -> float:
    return float((-s.real / np.maximum(np.abs(s), 1e-300)).min())


def step_torques(loop: SampledLoop, gains: LoopGains, jump: np.ndarray, samples: int) -> np.ndarray:
    """The largest torques (n_joints,), of either sign, after all references jump at once by `jump` (n_joints,)."""
    closed = loop.closed(gains)
    x, most, step = np.zeros(len(closed.A)), np.zeros(len(jump)), closed.transition
    x[: len(jump)] = -jump
    for _ in range(samples):
        most = np.maximum(most, np.abs(closed.G @ x))
        x = step @ x
    return most


def noise_torques(loop: SampledLoop, gains: LoopGains, noise: np.ndarray) -> np.ndarray:
    """The standard deviations of the torques (n_joints,) under white noise of what is measured.

    `noise` (2, n_joints): the standard deviations of coordinates and of rates, from sample to sample independent.
    """
    closed, m, n = loop.closed(gains), len(gains.kp), len(loop.A) // 2
    read = np.zeros((len(closed.A), 2 * m))
    read[:m, :m], read[n : n + m, m:] = np.eye(m), np.eye(m)
    summed = np.zeros_like(read)
    if gains.ki is not None:
        summed[2 * n :, :m] = -loop.step * np.eye(m)
    N = np.diag(noise.ravel() ** 2)
    enters, reaches = summed - closed.B @ closed.G @ read, closed.G @ read
    P = linalg.solve_discrete_lyapunov(closed.transition, enters @ N @ enters.T)
    return np.sqrt(np.diag(closed.G @ P @ closed.G.T + reaches @ N @ reaches.T))
