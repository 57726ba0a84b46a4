"""The limit of the rate of the effort of a drive, as a valve or a current loop has it.

What is held follows the input with a time T, and that follower z is an internal state: ``(tau - z)/T`` is the rate of
the effort, filtered over T. It is kept within ``r``, so what is held is between ``z - r T`` and ``z + r T``.

An example: of 20 N·m, asked of a drive at rest with r = 40 N·m/s and T = 20 ms, a step first holds 0.8 N·m, and then
40 N·m/s more. A step of length h adds ``r h/(1 + h/T)``, 5 % less than ``r h`` where h is a twentieth of T.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .axis_element import key
from .held import HeldLaw, MemoryRate
from .law import Key, Value


@dataclass(frozen=True)
class EffortRateLimit(HeldLaw):
    """The limit of that rate, which a robot file states as ``effort_rate`` and ``effort_time`` of the axis' limits."""

    KIND = "effort_rate"
    WORDS = "limits of the rate of efforts"
    FORMULA = r"\min\left( \max\left( \tau, z - r_m\,T_r \right), z + r_m\,T_r \right)"
    RATE = r"\frac{\tau - z}{T_r}"
    SAID = "at the limit of its rate"
    state = Key("N·m", "N", "effort that follows what is held", r"z")

    effort_rate: float = key(
        *("N·m/s", "N/s", "largest rate of the effort, of either sign", "r_m"),
        sign="positive",
        least=1e-12,
    )
    effort_time: float = key(
        *("s", "s", "time over which that rate is measured", "T_r"), sign="positive", least=1e-9, most=1e6
    )

    @staticmethod
    def held(t: Any, tau: Value, x: Value, w: Value, z: Value, rate: Value, time: Value) -> Value:
        most = t.named("most", rate * time)
        above, below = t.named("above", t.call("on", tau - z - most)), t.named("below", t.call("on", z - tau - most))
        return tau * (1.0 - above - below) + z * (above + below) + most * (above - below)

    @staticmethod
    def rate(t: Any, tau: Value, x: Value, w: Value, z: Value, rate: Value, time: Value) -> MemoryRate:
        return MemoryRate(tau / time, 1.0 / time)
