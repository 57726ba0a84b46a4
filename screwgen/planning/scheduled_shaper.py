"""A shaper whose impulses follow the posture and the payload: polynomials of frequencies and damping ratios."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..arguments import Numbers, array, seconds
from ..errors import UsageError
from .beyond import beyond
from .shapers import Shaper, shaper

MOST_MODES, MOST_TERMS, MOST_DEGREE = 3, 500, 12
"""Of a shaper, and of its polynomials."""


@dataclass(frozen=True, eq=False)
class FittedMode:
    """Coefficients (terms,) of the frequency, Hz, and the damping ratio, and between what they are held (2,)."""

    frequency: np.ndarray
    damping: np.ndarray
    frequencies: tuple[float, float]
    dampings: tuple[float, float]


@dataclass(frozen=True, eq=False, repr=False)
class ScheduledShaper:
    """A shaper for every posture within bounds.

    V variables: joint coordinates, rad or m, then perhaps a payload, in the order of `variables`.
    """

    robot: str
    kind: str
    vibrates: str
    """One of `shapers.VIBRATES`."""
    joints: tuple[str, ...]
    """Whose references are shaped."""
    variables: tuple[str, ...]
    lower: np.ndarray
    upper: np.ndarray
    """(V,) each: the bounds; beyond them the values at the bounds are taken."""
    powers: np.ndarray
    """(terms, V): of the variables, which are scaled to −1 … 1 between their bounds."""
    modes: tuple[FittedMode, ...]
    law: str | None = None
    """The file of the joint law whose references are shaped."""
    residual: float = np.nan
    """The largest vibration that it leaves, over that of one impulse, at postures of a grid of their own."""
    table: np.ndarray = field(default_factory=lambda: np.empty((0, 0)))
    """(postures, V + 1): that grid, and what is left at each; files do not store it."""

    def vibrations(self, place: Any) -> tuple[np.ndarray, np.ndarray]:
        """Natural frequencies, Hz, and damping ratios (modes,) at values of the variables (V,)."""
        place = np.clip(array(place, "posture:", (len(self.variables),)), self.lower, self.upper)
        scaled = 2 * (place - self.lower) / np.where(self.upper > self.lower, self.upper - self.lower, 1.0) - 1
        terms = np.prod(scaled**self.powers, axis=1)
        found = [
            (np.clip(terms @ x.frequency, *x.frequencies), np.clip(terms @ x.damping, *x.dampings)) for x in self.modes
        ]
        return np.array([f for f, _ in found]), np.array([z for _, z in found])

    def at(self, place: Any) -> Shaper:
        """The shaper at values of the variables (V,)."""
        return shaper(*self.vibrations(place), self.kind)

    def outside(self, place: np.ndarray) -> str | None:
        """A line where values of the variables (V,) are out of the bounds; None within."""
        return beyond(self.variables, place, self.lower, self.upper)

    @property
    def delay(self) -> float:
        """The longest delay, s: what a reference ends later, at most."""
        slow = shaper([x.frequencies[0] for x in self.modes], [x.dampings[1] for x in self.modes], self.kind)
        return slow.delay

    def __repr__(self) -> str:
        return f"<ScheduledShaper of '{self.robot}': {self.kind}, {self.line}>"

    @property
    def line(self) -> str:
        """The figures in words."""
        of = ", ".join(f"{x.frequencies[0]:.3g} to {x.frequencies[1]:.3g} Hz" for x in self.modes)
        left = "" if np.isnan(self.residual) else f"; at most {100 * self.residual:.2f} % are left"
        return f"{self.vibrates}: {of}; delays of up to {self.delay:.3g} s{left}"

    def sampled(self, step: float) -> SampledShaper:
        """What a clock of `step` seconds runs, with a memory of fixed length."""
        return SampledShaper(self, seconds(step, "the step"))

    def c(self, step: float = 1e-3) -> dict[str, str]:
        """The shaper as C99 for a clock of `step` seconds: `<robot>_shaper.h` and `<robot>_shaper.c`.

        Raises UsageError.
        """
        from .shaper_c import shaper_files

        return shaper_files(self, seconds(step, "the step"))


class SampledShaper:
    """References with rates in, shaped ones out, sample by sample: what the generated C does."""

    def __init__(self, scheduled: ScheduledShaper, step: float):
        self.scheduled, self.step = scheduled, step
        self.length = int(np.ceil(scheduled.delay / step)) + 2
        self.memory = np.empty((0, 2, 0))
        self.newest = 0

    def start(self, reference: Numbers) -> None:
        """Begin at rest at a reference (n,), which counts as that of all samples before."""
        reference = array(reference, "reference:", (len(self.scheduled.joints),))
        self.memory, self.newest = np.tile([reference, 0.0 * reference], (self.length, 1, 1)), 0

    def __call__(self, reference: Numbers, rate: Numbers, place: Numbers) -> tuple[np.ndarray, np.ndarray]:
        """The shaped reference (n,) and its rate (n,) at the next sample, at values of the variables (V,).

        Rates are sums of earlier rates: how the delays themselves change is left out. Between samples coordinates
        are those of a cubic, and rates lie on a straight line; both are exact where the reference accelerates evenly.
        """
        if not self.memory.size:
            raise UsageError("shaper: is not started; call start with the first reference")
        size, impulses = self.memory.shape[2:], self.scheduled.at(place)
        sample = array(reference, "reference:", size), array(rate, "rate:", size)
        self.newest = (self.newest + 1) % self.length
        self.memory[self.newest] = sample
        out = np.zeros_like(self.memory[0])
        for time, amplitude in zip(impulses.times, impulses.amplitudes, strict=True):
            back, share = divmod(time / self.step, 1.0)
            late, earlier = (self.memory[(self.newest - int(back) - k) % self.length] for k in (0, 1))
            way = earlier - late
            bend = share * (way[0] + self.step * earlier[1]) - (1.0 - share) * (way[0] + self.step * late[1])
            out += amplitude * (late + share * way)
            out[0] += amplitude * share * (1.0 - share) * bend
        return out[0], out[1]
