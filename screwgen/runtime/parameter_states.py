"""Parameters of a robot that filters find: what a caller states of them, and what filters in Python and C share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..algorithms.estimated_parameters import LEAST
from ..backends.numpy.estimated import check_estimated
from ..errors import UsageError
from ..topology.chain import Chain


@dataclass(frozen=True)
class ParameterState:
    """A parameter that a filter finds, in its unit."""

    parameter: str
    """Its name, as ``forearm.bodies[0].mass``."""
    deviation: float
    """The standard deviation of its value at the start."""
    density: float = 0.0
    """The variance that it gains per second, as a random walk: how fast it may change."""
    lower: float = -math.inf
    """The least value that it is given; of those that must not be negative a millionth of the start at least."""
    upper: float = math.inf

    def __post_init__(self) -> None:
        for name in ("deviation", "density"):
            if not 0 <= getattr(self, name) < math.inf:
                raise UsageError(f"{self.parameter}: {name} is {getattr(self, name)}; it must be a number >= 0")
        if not self.lower < self.upper:
            raise UsageError(f"{self.parameter}: lower is {self.lower}; it must be less than upper, {self.upper}")


class ParameterStates:
    """Those of a filter, in the order of the robot's parameters, whose values ``p`` (n,) are those at the start."""

    def __init__(self, chain: Chain, states: Sequence[ParameterState], p: np.ndarray):
        found = {chain.parameters.place(one.parameter): one for one in states}
        if len(found) < len(states) or not found:
            raise UsageError("states: each parameter must be named once, and one at least; leave out the others")
        self.places, self.states = map(list, zip(*sorted(found.items()), strict=True))
        check_estimated(chain, self.places)
        self.names, self.start = [one.parameter for one in self.states], p[self.places]
        least = np.where(chain.parameters.least[self.places] == 0.0, np.maximum(0.0, LEAST * self.start), -np.inf)
        self.lower, self.upper = np.maximum([one.lower for one in self.states], least), self._of("upper")
        self.deviation, self.density = self._of("deviation"), self._of("density")
        if ((self.start < self.lower) | (self.start > self.upper)).any():
            raise UsageError(f"states: values at the start, {self.start.tolist()}, are not within their bounds")

    def __len__(self) -> int:
        return len(self.states)

    def _of(self, name: str) -> np.ndarray:
        return np.array([getattr(one, name) for one in self.states])

    def named(self, values: np.ndarray) -> dict[str, float]:
        """Values (k,) by the names of the parameters."""
        return dict(zip(self.names, values.tolist(), strict=True))

    def deviations(self, P: np.ndarray) -> dict[str, float]:
        """The standard deviations, by name, of a covariance of all states, of which these are the last."""
        return self.named(np.sqrt(np.diag(P)[len(P) - len(self) :]))
