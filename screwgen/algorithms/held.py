"""What a step holds of its inputs, in a phase: the laws of axes (:mod:`..elements.held`) run at its beginning."""

from __future__ import annotations

from ..topology.held_laws import reads_motion
from . import matrices as mx
from .axis_terms import driven_rate
from .scope import Scope


def hold(s: Scope) -> None:
    """The inputs of a joint as a step holds them."""
    held = s.read("tau").copy() if s.key.torques else mx.zeros(0)
    for kind, axis, labels in s.key.held_laws:
        x, w = s.read("q")[axis], driven_rate(s, axis, guarded=False) if reads_motion(kind) else 0.0
        if axis in s.key.added_axes and axis not in s.key.travels:
            x = s.read("theta")[s.key.added_axes.index(axis)]
        held[axis] = kind.held(s.tracer, held[axis], x, w, *map(s.constant, labels))
    s.write("held", held)
