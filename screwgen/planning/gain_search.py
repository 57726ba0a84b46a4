"""The search for joint gains over sampled loops; it draws the same numbers in every run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..errors import UsageError
from .gain_bounds import GainBounds
from .sampled_loop import LoopFigures, LoopGains, SampledLoop

SLOWEST, FASTEST = 1.0, 60.0
"""Between which a joint alone, all others held, would swing on its gain, rad/s."""
DAMPING = (0.05, 3.0)
"""Between which its damping ratio would be."""
SUMMED = (0.05, 20.0)
"""Between which `ki / kp` is, 1/s."""
GROWTH = 1e-4
"""The ratio to its frequency at which a fast oscillation may grow: a tenth of what metals take out of it."""
THRIFT = 0.03
"""What a factor e of a gain is worth in decay, 1/s: of laws that are alike the softer one is taken."""
STEEP, WANTED, SPARE = 1e4, 1e3, 2.0
CLOSE = 1e-2
"""The share of a decay or damping wanted by which it may be missed."""
BEYOND = 1 + CLOSE / 4
"""The factor on a decay wanted at which the search aims, so that it ends above."""
DIGITS = (3, 4, 5, 6)
"""Of gains as a file states them: the fewest with which nothing wanted is missed."""
ROUNDS, CROWD, SEED = 60, 8, 1


@dataclass(frozen=True)
class GainSearch:
    """What is sought: gains under which the slowest motion of all loops decays fastest."""

    loops: Sequence[SampledLoop]
    inertia: np.ndarray
    band: float
    bounds: GainBounds
    integral: bool
    most: tuple[np.ndarray, np.ndarray]
    """The largest `kp` and `kd`."""
    others: Sequence[SampledLoop] = ()
    """Loops that may only not grow."""

    def beside(self, loops: Sequence[SampledLoop]) -> GainSearch:
        """The same search where further loops may not grow either."""
        return replace(self, others=loops)

    def closer(self, law: LoopGains, by_kp: np.ndarray, by_kd: np.ndarray) -> GainSearch:
        """The same search with gains smaller than those of a law by factors, where these exceed 1."""
        smaller = lambda own, by, most: np.where(by > 1, own / np.maximum(by, 1.0), most)  # noqa: E731
        return replace(self, most=(smaller(law.kp, by_kp, self.most[0]), smaller(law.kd, by_kd, self.most[1])))

    def gains(self, x: np.ndarray) -> LoopGains:
        """Gains from logarithms of frequencies and damping ratios of joints alone, and of `ki / kp`."""
        m = len(self.inertia)
        rate, damping = np.exp(x[:m]), np.exp(x[m : 2 * m])
        kp, kd = self.inertia * rate**2, 2 * damping * self.inertia * rate
        kp, kd = np.minimum(kp, self.most[0]), np.minimum(kd, self.most[1])
        ki = np.minimum(kp * np.exp(x[2 * m]), self.bounds.ki) if self.integral else None
        return LoopGains(kp, kd, ki)

    def figures(self, law: LoopGains) -> LoopFigures:
        """Of the loops that count."""
        return LoopFigures.of([loop.poles(law) for loop in self.loops], self.band)

    def borne(self, law: LoopGains, loops: Sequence[SampledLoop]) -> bool:
        """Whether nothing grows in other loops."""
        found = LoopFigures.of([loop.poles(law) for loop in loops], self.band)
        return found.margin >= -2 * GROWTH and found.decay > 0

    def cost(self, x: np.ndarray) -> float:
        """What is minimised: slowness, then size, and growth above all."""
        law = self.gains(x)
        decay, damping, margin, _ = self.figures(law)
        for factor, loops in ((SPARE, self.loops), (1.0, self.others)):
            if loops:
                margin = min(margin, LoopFigures.of([y.poles(law.times(factor)) for y in loops], self.band).margin)
        growth = STEEP * max(0.0, -margin - GROWTH) + WANTED * max(0.0, self.bounds.damping - damping)
        wanted = self.bounds.decay * BEYOND
        slowness = WANTED * max(0.0, wanted - decay) if wanted else -decay
        return growth + THRIFT * float(np.abs(x).sum()) + slowness

    def found(self) -> LoopGains:
        """The best gains; raises UsageError where they are unstable."""
        from scipy.optimize import differential_evolution, minimize

        m = len(self.inertia)
        limits = [tuple(np.log((SLOWEST, FASTEST)))] * m + [tuple(np.log(DAMPING))] * m
        limits += [tuple(np.log(SUMMED))] * self.integral
        rough = differential_evolution(
            self.cost, limits, seed=SEED, popsize=CROWD, maxiter=ROUNDS, polish=False, init="sobol"
        )
        law = self.gains(minimize(self.cost, rough.x, method="Nelder-Mead", options={"maxfev": 500}).x)
        law = next(filter(self.does_what_is_wanted, map(law.rounded, DIGITS)), law.rounded(DIGITS[0]))
        figures = self.figures(law)
        if figures.margin < -2 * GROWTH or figures.decay <= 0:
            raise UsageError("gains: none were found that are stable; take a shorter step, or wider bounds")
        return law

    def does_what_is_wanted(self, law: LoopGains) -> bool:
        """Whether decay and damping are not below those wanted, where rounding may end."""
        figures = self.figures(law)
        return figures.decay >= self.bounds.decay and figures.damping >= self.bounds.damping

    def check(self, figures: LoopFigures) -> None:
        """Refuse a law that does not do what is wanted."""
        wanted = {"decay": self.bounds.decay, "damping": self.bounds.damping}
        for name, most in wanted.items():
            if (best := getattr(figures, name)) < most * (1 - CLOSE):
                raise UsageError(f"bounds: {name}: {most:.4g} is wanted, {best:.3g} was found; ask for less")

    def spare(self, law: LoopGains) -> float:
        """How far gains may grow together, up to ten times."""
        factors = np.geomspace(1.0, 10.0, 47)
        held = [self.figures(law.times(s)).margin >= -2 * GROWTH for s in factors]
        return float(factors[max(0, held.index(False) - 1) if False in held else -1])
