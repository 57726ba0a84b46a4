"""The joint law with an integral: what joints lack is summed up from sample to sample, within the limits of drives."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..errors import UsageError
from ..spec.ranges import within
from .controllers import PD
from .state import refusals


@dataclass
class SummedError:
    """What an integral has come to (n_joints,), N·m, and how it goes on from the latest sample, N·m/s."""

    effort: np.ndarray
    rate: np.ndarray
    time: float | None = None

    def advanced_to(self, t: float) -> np.ndarray:
        """The integral at a time, s; earlier times than that of the latest sample leave it as it is."""
        if self.time is not None and t > self.time:
            self.effort = self.effort + self.rate * (t - self.time)
        self.time = t if self.time is None else max(t, self.time)
        return self.effort


@dataclass(frozen=True)
class PID(PD):
    """A :class:`PD` law with an integral: `ki`, N·m/(rad·s), of slides N/(m·s), times what the joints lack, summed up.

    `tau_max`: the integral of a joint stands still while its drive gives all that it has and more would be
    asked for (anti-windup). The law remembers; a run starts it anew.
    """

    ki: tuple[float, ...] = ()
    summed: SummedError = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        count = np.size(self.q_des)
        if np.size(self.ki) != count:
            raise UsageError(f"PID: ki has length {np.size(self.ki)}; q_des has {count}, one per joint")
        with refusals("PID"):
            ki = tuple(within("ki")(float(x), at=("ki", j)) for j, x in enumerate(np.ravel(self.ki)))
        object.__setattr__(self, "ki", ki)
        object.__setattr__(self, "summed", SummedError(np.zeros(count), np.zeros(count)))

    @property
    def plain(self) -> bool:
        """Never: the law remembers."""
        return False

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The torques, N·m, of slides forces, N, where they act; `t` is that of a clock that does not go back."""
        there = self.seen(q, v)[0]
        added = self.summed.advanced_to(t) / self.own_ratios
        tau, m = self.unlimited(t, q, v), len(self.ki)
        tau[:m] += added if self.efforts is None else self.efforts(added, there)[:m]
        lack, rate, most = self.reference(t)[0] - there, np.array(self.ki), self.bounds
        if most is not None:
            clipped, grows = np.clip(tau[:m], -most, most), lack
            if self.efforts is not None:  # behind a lever of negative sign less force turns on
                grows = lack * self.efforts(np.ones(m), there)[:m]
            rate = np.where((tau[:m] - clipped) * grows > 0, 0.0, rate)
            tau[:m] = clipped
        self.summed.rate = rate * lack
        return tau
