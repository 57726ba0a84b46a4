"""The steps that an integrator bears: its amplification matrix against the exact motion.

A step map has an eigenvalue `μ` for every motion `exp(λ h)` of the linearised arm, recognised by its eigenvector. An
oscillation that does not grow by itself grows under the method where `log|μ| > TOLERANCE |log μ|`, by a share of its
amplitude a radian; one that does where `log|μ| > 2 h Re λ + OWN |log μ|`. The limits are those of the arm held at the
state by constant forces (`Linearised.trimmed`): where it accelerates, a method's small error looks like slow growth.

Where joints turn at a rate r, oscillations slower than `TURN r` are left out: the arm turns by a radian within their
period, so frozen coefficients cannot say whether they grow. Methods of order 1 add up to about `h r² / 2` per second
to them, which is their error, not the end of their stability; an analysis says how far a step turns joints.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from ..integrators.method import Method
from .linearised import STILL, TOLERANCE, Linearised

OWN = 1e-2
"""The same for an oscillation that grows by itself, beyond twice its own growth."""
NOISE = 1e-6
"""The largest rounding error of two coinciding eigenvalues 1 of a step map."""
SHORTEST, LONGEST = 1e-3, 1.0
"""The steps tried: from this many radians of the fastest oscillation to this many seconds."""
TURN = 2 * np.pi
"""How much faster than the joints turn, both in rad/s, an oscillation must be for frozen coefficients to hold."""
PER_DECADE = 8
HALVINGS = 16


class LinearisedMotions:
    """The linearised motions of an arm held at a state, and the methods' approximations of them."""

    def __init__(self, motion: Linearised):
        self.motion, self.slowest = motion, TURN * motion.turning
        self.eigenvalues, self._vectors = np.linalg.eig(motion.jacobian)
        self.largest = float(np.abs(self.eigenvalues).max(initial=0.0))

    @cached_property
    def scale(self) -> np.ndarray:
        """Coordinates and rates in the root of energy, so that eigenvectors can be compared."""
        omega = 1.0
        if self.largest > 0:
            omega = float(np.exp(np.log(np.maximum(np.abs(self.eigenvalues), STILL * self.largest)).mean()))
        root = np.linalg.cholesky(self.motion.inertia).T
        zero = np.zeros_like(root)
        return np.block([[omega * root, zero], [zero, root]])

    @cached_property
    def vectors(self) -> np.ndarray:
        """The motions, scaled so, of length 1."""
        return unit(self.scale @ self._vectors)

    @cached_property
    def steps(self) -> np.ndarray:
        """The steps to try, ascending."""
        fastest = self.largest or 1.0
        low, high = np.log10(0.1 / fastest), np.log10(max(LONGEST, 10.0 / fastest))
        count = int(np.ceil((high - low) * PER_DECADE)) + 1
        return np.append(SHORTEST / fastest, np.logspace(low, high, count))

    def bears(self, method: str | Method, h: float) -> bool:
        """Whether no oscillation grows under steps of `h` seconds faster than by itself."""
        S = self.motion.step_map(method, h)
        if not (len(S) and np.isfinite(S).all()):
            return not len(S)
        if not (np.abs(self.motion.closing_factors(method, h)) < 1 + NOISE).all():
            return False
        mu, vectors = np.linalg.eig(S)
        alike = np.abs(self.vectors.conj().T @ unit(self.scale @ vectors))
        own = self.eigenvalues[alike.argmax(axis=0)]
        z = exponents(mu)
        dying = own.real < -np.abs(own) / 2  # whose factor may leave the circle at 1, without turning
        turning = (np.abs(z) > self.noise(h)) & ((np.abs(z.imag) > NOISE) | dying) & (np.abs(own) >= self.slowest)
        allowed = np.where(
            own.real > TOLERANCE * np.abs(own), 2 * h * own.real + OWN * np.abs(z), TOLERANCE * np.abs(z)
        )
        return not (turning & (z.real > allowed)).any()

    def grows(self, method: str | Method, h: float, rate: float) -> bool:
        """Whether an oscillation gains more than `rate`, 1/s, and more than a share a radian, under steps of `h` s."""
        S = self.motion.step_map(method, h)
        if not np.isfinite(S).all():
            return True
        z = exponents(np.linalg.eigvals(S))
        fast = (np.abs(z) > self.noise(h)) & (np.abs(z.imag) > NOISE) & (np.abs(z) >= h * self.slowest)
        return bool((fast & (z.real > np.maximum(TOLERANCE * np.abs(z), h * rate))).any())

    def noise(self, h: float) -> float:
        """Exponents over `h` seconds that are zero but for rounding."""
        return NOISE + h * STILL * self.largest


def unit(vectors: np.ndarray) -> np.ndarray:
    """Columns of length 1."""
    return vectors / np.linalg.norm(vectors, axis=0)


def exponents(mu: np.ndarray) -> np.ndarray:
    """`log μ`; a large negative number for a mode that vanishes in one step."""
    return np.log(np.where(np.abs(mu) > 1e-300, mu, 1e-300).astype(complex))


def first_failure(steps: np.ndarray, bears: Callable[[float], bool]) -> float | None:
    """The step before the first that is not borne, to some digits; 0.0 if that is the shortest, None if all are."""
    bad = next((k for k, h in enumerate(steps) if not bears(h)), None)
    if bad is None:
        return None
    if bad == 0:
        return 0.0
    low, high = steps[bad - 1], steps[bad]
    for _ in range(HALVINGS):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if bears(middle) else (low, middle)
    return float(low)


def shown_time(seconds: float, digits: int = 4) -> str:
    """A time with its unit, `22 µs`."""
    scale, unit = (1.0, "s") if seconds >= 0.1 else (1e3, "ms") if seconds >= 1e-4 else (1e6, "µs")
    return f"{seconds * scale:.{digits}g} {unit}"
