"""Compliant stops: a spring and a damper in parallel beyond a limit, which never pull.

With the penetration ``p > 0`` a stop pushes back with ``max(0, k p + d pdot)``. The potential ``k p² / 2`` is stored,
all else dissipated. Over a step it is linear by secants, which follow from the way of the coordinate as its rate
predicts it: ``share`` of the way is beyond the limit, and ``k`` and ``d`` times the share act on the mean penetration
of that part. A body that hits a stop of any stiffness gets no more energy back than it brought; in contact throughout
it is the midpoint rule.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from .law import Key, Secant, Value


@dataclass(frozen=True)
class Stop:
    """The law; ``side``: 1 at an upper limit, -1 at a lower one."""

    name: str = "stop"
    words: str = "stops"
    constants: tuple[str, ...] = ("stop_at", "stop_K", "stop_D")
    notes: tuple[str, str] = (
        "A stop pushes with K p + D dp/dt while its coordinate is beyond its limit by p, and never pulls. Over a step "
        "it is linear: K and D times the share of the way that is beyond the limit, as the rates predict it.",
        'Stops are those on a way at the rates of s or "there".',
    )
    positional: bool = True
    beside: ClassVar[bool] = False
    bristle: ClassVar[None] = None
    state: ClassVar[None] = None
    state_name: ClassVar[str] = ""

    @property
    def table(self) -> Mapping[str, Key]:
        return {
            "stop_at": Key("rad", "m", "limits with stops", "q_s"),
            "stop_K": Key("N·m/rad", "N/m", "stiffness of the stops", "k_s", "positive"),
            "stop_D": Key("N·m·s/rad", "N·s/m", "damping of the stops", "d_s", "non-negative"),
        }

    def prepared(self, *numbers: Value) -> tuple[Value, ...]:
        return numbers

    def force(self, t: Any, side: Value, x: Value, w: Value, at: Value, k: Value, d: Value) -> Value:
        depth, rate = side * (x - at), side * w
        push = k * depth + d * rate
        return side * (t.call("on", depth) * t.call("on", push) * push)

    def energy(self, t: Any, side: Value, x: Value, at: Value, k: Value, d: Value) -> Value:
        depth = side * (x - at)
        return t.call("on", depth) * (k * depth * depth)

    def secant(
        self, t: Any, side: Value, x: Value, w: Value, there: Value, h: Value, at: Value, k: Value, d: Value
    ) -> Secant:
        """A step is taken to end ``2 h`` after its start; of the rates at start and stage the one that leads deeper
        counts."""
        on = lambda value: t.call("on", value)  # noqa: E731
        start = t.named("start", side * (x - at))
        before, later = t.named("before", side * w), t.named("later", side * there)
        rate = t.named("rate", before + (later - before) * on(later - before))
        way = t.named("way", 2.0 * h * rate)
        low, high = t.named("low", start + way * on(-way)), t.named("high", start + way * on(way))
        outside, beyond = t.named("outside", low * on(-low)), t.named("beyond", on(high))
        part = t.named("part", beyond * high / (beyond * high - outside + (1.0 - beyond)))
        push = t.named("push", k * (start + 0.5 * way - 0.5 * outside) + d * rate)
        share = t.named("share", part * on(push))
        stiffness, damping = t.named("K_s", k * share), t.named("D_s", d * share)
        return Secant(stiffness, damping, t.named("rest", at + side * (0.5 * outside)))


STOP = Stop()

LETTERS = {"lower": "q_s", "upper": "q_s", "stiffness": "k_s", "damping": "d_s"}
"""The letters of the keys of a limit in formulas."""

SYMBOLS = (
    (r"q_s", "limit of a joint axis, of slides in m", "rad", False),
    (r"k_s, d_s", "stiffness and damping of its stop", "N*m/rad, N*m*s/rad", False),
    (r"p, \tau_s", "penetration of a stop, and its torque, of slides in m and N", "rad, N*m", True),
)
"""Symbol, meaning, unit of what documents name, and whether it is a state."""

EQUATIONS = (
    r"""
A stop at the limit $q_s$ of an axis pushes the joint back while that is beyond it by $p > 0$, and never pulls. With
$\sigma_s = 1$ at an upper limit and $-1$ at a lower one,

$$
\tau_q &\leftarrow \tau_q - \sigma_s\,\tau_s, & \quad \tau_s &= \max\left( 0,\ k_s\,p + d_s\,\dot{p} \right), & \quad"""
    r""" p &= \sigma_s\,\left( q - q_s \right), & \quad \dot{p} &= \sigma_s\,\dot{q}
$$

and $\tau_s = 0$ where $p \leq 0$. The potential $k_s\,p^2/2$ is stored, all else is dissipated.
"""
)
