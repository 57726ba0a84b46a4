"""What a step holds of its inputs, in phases: the laws of axes (:mod:`..elements.held`) run at its beginning."""

from __future__ import annotations

from collections.abc import Iterator

from ..ir.program import Value
from ..spec.axis_laws import HeldOnAxis
from ..topology.held_laws import reads_motion
from . import matrices as mx
from .axis_terms import driven_rate
from .scope import Scope


def hold(s: Scope) -> None:
    """The inputs of a joint as a step holds them."""
    held = s.read("tau").copy() if s.key.torques else mx.zeros(0)
    remembered = dict(_remembered(s))
    for one in s.key.held_laws:
        motion = _motion(s, one) if reads_motion(one.kind) else (0.0, 0.0)
        z = (remembered[one],) if one in remembered else ()
        held[one.axis] = one.kind.held(s.tracer, held[one.axis], *motion, *z, *map(s.constant, one.labels))
    s.write("held", held)


def remember(s: Scope) -> None:
    """How the internal states of these laws change while the inputs of the joint act."""
    tau = s.read("tau") if s.key.remembering else ()
    rates = [
        one.kind.rate(s.tracer, tau[one.axis], *_motion(s, one), z, *map(s.constant, one.labels))
        for one, z in _remembered(s)
    ]
    s.write("memory_gain", mx.array([rate.gain for rate in rates]))
    s.write("memory_decay", mx.array([rate.decay for rate in rates]))


def _remembered(s: Scope) -> Iterator[tuple[HeldOnAxis, Value]]:
    """The laws with an internal state, and the states."""
    return zip(s.key.remembering, s.read("memory") if s.key.remembering else (), strict=True)


def _motion(s: Scope, law: HeldOnAxis) -> tuple[Value, Value]:
    """The coordinate of an axis and the rate of its drive."""
    x, added = s.read("q")[law.axis], law.axis in s.key.added_axes and law.axis not in s.key.travels
    if added:
        x = s.read("theta")[s.key.added_axes.index(law.axis)]
    return x, driven_rate(s, law.axis, guarded=False)
