"""The longest stable step of each integrator: its amplification matrix against the exact motion.

A step map has an eigenvalue `μ` for every motion `exp(λ h)` of the linearised arm, recognised by its eigenvector. An
oscillation that does not grow by itself grows under the method where `log|μ| > TOLERANCE |log μ|`, by a share of its
amplitude a radian; one that does where `log|μ| > 2 h Re λ + OWN |log μ|`. The limits are those of the arm held at the
state by constant forces (`Linearised.trimmed`): where it accelerates, a method's small error looks like slow growth.

Where joints turn at a rate r, oscillations slower than `TURN r` are left out: the arm turns by a radian within their
period, so frozen coefficients cannot say whether they grow. Methods of order 1 add up to about `h r² / 2` per second
to them, which is their error, not the end of their stability; `StateAnalysis.turning` says how far a step turns joints.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from ...integrators.methods import METHODS
from .spectrum import STILL, TOLERANCE, Linearised

if TYPE_CHECKING:
    from ...model import Model

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


@dataclass(frozen=True)
class StepLimit:
    """What a method bears at a state.

    `limit`: the largest step in s up to which no oscillation (of those that are faster than the joints turn) grows
    faster than by itself; 0.0 if there is none, None
    if there is no limit up to `tried` seconds. `factor`: the spectral radius of the step map over the asked step;
    `rate`: its logarithm over the step, 1/s; `borne`: whether that step is within the limit.
    """

    method: str
    limit: float | None
    tried: float
    factor: float
    rate: float
    borne: bool


def step_limits(motion: Linearised, step: float) -> list[StepLimit]:
    """The limit of every method about a state, and its growth at `step` seconds."""
    held = Held(motion.trimmed())
    return [_limit(motion, held, method, step) for method in METHODS]


def _limit(motion: Linearised, held: Held, method: str, step: float) -> StepLimit:
    limit = first_failure(held.steps, partial(held.bears, method))
    S = motion.step_map(method, step)
    mu = np.append(np.linalg.eigvals(S), motion.closing_factors(method, step))
    fastest = mu[np.abs(mu).argmax()] if len(mu) else 1.0
    moving = abs(exponents(np.array(fastest))) > held.noise(step)
    rate = float(np.log(abs(fastest))) / step if moving else 0.0
    within = (limit is None or step <= limit) and held.bears(method, step)
    return StepLimit(method, limit, float(held.steps[-1]), float(abs(fastest)), rate, within)


class Held:
    """The linearised motions of an arm held at a state, and the methods' approximations of them."""

    def __init__(self, motion: Linearised):
        self.motion, omega = motion, 1.0
        self.eigenvalues, vectors = np.linalg.eig(motion.jacobian)
        self.largest = float(np.abs(self.eigenvalues).max(initial=0.0))
        if self.largest > 0:
            omega = float(np.exp(np.log(np.maximum(np.abs(self.eigenvalues), STILL * self.largest)).mean()))
        root = np.linalg.cholesky(motion.inertia).T
        zero = np.zeros_like(root)
        self.scale = np.block([[omega * root, zero], [zero, root]])
        """Coordinates and rates in the root of energy, so that eigenvectors can be compared."""
        self.vectors = unit(self.scale @ vectors)
        self.slowest = TURN * motion.turning

    @cached_property
    def steps(self) -> np.ndarray:
        """The steps to try, ascending."""
        fastest = self.largest or 1.0
        low, high = np.log10(0.1 / fastest), np.log10(max(LONGEST, 10.0 / fastest))
        count = int(np.ceil((high - low) * PER_DECADE)) + 1
        return np.append(SHORTEST / fastest, np.logspace(low, high, count))

    def bears(self, method: str, h: float) -> bool:
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
        turning = (np.abs(z) > self.noise(h)) & (np.abs(z.imag) > NOISE) & (np.abs(own) >= self.slowest)
        allowed = np.where(
            own.real > TOLERANCE * np.abs(own), 2 * h * own.real + OWN * np.abs(z), TOLERANCE * np.abs(z)
        )
        return not (turning & (z.real > allowed)).any()

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


def paper_bound(model: Model) -> float | None:
    """(stability) as printed, in s, which does not hold: see E19. None where no link bends.

    The least of `2 l² / (1.8751² n²) √(ρA/EI)` over links and directions with n bending modes. Where measured
    frequencies stand for EI, `√(ρA/EI) l² / 1.8751² = 1 / (2π f_1)`.
    """
    values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    bounds = [
        2.0 / (omega * count**2)
        for link in model.robot.links
        for direction, stiffness in (("bending_y", "EIz"), ("bending_z", "EIy"))
        if (count := getattr(link.modes, direction))
        for omega in [link.pieces**2 * _first(values, link.name, direction, stiffness)]
    ]
    return min(bounds, default=None)


def _first(values: dict[str, float], link: str, direction: str, stiffness: str) -> float:
    """The first circular frequency of a clamped-free link, rad/s."""
    if (measured := values.get(f"{link}.frequencies.{direction}[0]")) is not None:
        return 2 * np.pi * measured
    section = link if f"{link}.rhoA" in values else f"{link}.section[0]"  # the paper knows uniform links only
    EI, rhoA = values[f"{section}.{stiffness}"], values[f"{section}.rhoA"]
    return float(1.8751**2 / values[f"{link}.length"] ** 2 * np.sqrt(EI / rhoA))
