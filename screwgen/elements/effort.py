"""The limit of the effort of a drive: ``min(max(tau, -most), most)``.

It acts on the input itself, so where the drive does: on the motor of an elastic gear, along a cylinder, at a crank. At
the limit the slope is 1 still, beyond it 0. The input must be finite: of one that is not, no step gives a result.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .axis_element import key
from .held import HeldLaw
from .law import Value


@dataclass(frozen=True)
class EffortLimit(HeldLaw):
    """The limit of the effort of a drive, which a robot file states as ``effort`` of the axis' limits."""

    KIND = "effort"
    WORDS = "limits of effort"
    FORMULA = r"\min\left( \max\left( \tau, -\tau_m \right), \tau_m \right)"
    SAID = "at the limit of its effort"

    effort: float = key(
        *("N·m", "N", "largest effort of the drive, of either sign", r"\tau_m"), sign="positive", least=1e-12, most=1e15
    )

    @staticmethod
    def held(t: Any, tau: Value, x: Value, w: Value, effort: Value) -> Value:
        above, below = t.named("above", t.call("on", tau - effort)), t.named("below", t.call("on", -tau - effort))
        return tau * (1.0 - above - below) + effort * (above - below)
