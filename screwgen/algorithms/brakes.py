"""Brakes of axes in phases: what the row of an axis becomes where its brake is closed by b, from 0 to 1.

Of the row of an axis, ``m qddot + ... - tau = 0``, a share ``r^2`` with ``r = 1 - b`` is left, and a flywheel of the
brake's inertia J takes the rest: ``r^2 (m qddot + ... - tau) + (1 - r^2) J (qddot - a) = 0``, where ``a = -b qdot / T``
stops the axis over the brake's time T. So an open brake does nothing, and a closed one gives ``qddot = a``, whatever
acts. Divided by ``r^2`` it is a flywheel of ``J (1 - r^2) / r^2`` on the axis.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from ..ir.derivative import columns
from ..ir.program import Array, Value
from . import matrices as mx
from .scope import Scope


class Grip(NamedTuple):
    """What a brake makes of the row of its axis: what ``share`` of it is left, the ``inertia`` beside that, and the
    acceleration ``stop`` that it has."""

    share: Value
    inertia: Value
    stop: Value

    def mobility(self, pivot: Value) -> Value:
        """The acceleration by a unit force, of an axis whose inertia is ``pivot`` without the brake."""
        return self.share / (self.share * pivot + self.inertia)


FREE = Grip(1.0, 0.0, 0.0)
"""Without a brake."""


def grips(s: Scope, axes: Iterable[int], rates: Array) -> dict[int, Grip]:
    """The brakes of some axes, at the rates of what they act on: of the axes, or of the rotors of elastic drives."""
    closed = dict(zip(s.key.brakes, s.read("brake"), strict=True)) if s.key.brakes else {}
    return {axis: _grip(s, axis, closed[axis], rates[k]) for k, axis in enumerate(axes) if axis in closed}


def on_rotors(s: Scope) -> dict[int, Grip]:
    """Those that act on rotors of elastic drives, by their axes."""
    braked = set(s.key.brakes) & set(s.key.added_axes)
    return grips(s, s.key.added_axes, s.read("thetadot")) if braked else {}


def on_axes(s: Scope, qdot: Array) -> dict[int, Grip]:
    """Those that act on the joint's axes themselves."""
    found = grips(s, range(s.key.joints), qdot)
    return {axis: grip for axis, grip in found.items() if axis not in s.key.added_axes}


def kept(s: Scope) -> dict[int, Grip]:
    """The same at the rates that an earlier phase has kept."""
    return on_axes(s, s.kept("braked_rate")) if s.key.brakes else {}


def stops(s: Scope) -> Array:
    """The accelerations of the joint's axes with which their brakes stop them, at these rates."""
    own = kept(s)
    return mx.array([own.get(axis, FREE).stop for axis in range(s.key.joints)])


def _grip(s: Scope, axis: int, stated: Value, rate: Value) -> Grip:
    closed = within(s, stated)
    left = 1.0 - closed
    share = left * left
    rest = (1.0 - share) * s.constant(f"brake_inertia_{axis + 1}")
    return Grip(share, rest, -(closed * rate) / s.constant(f"brake_time_{axis + 1}"))


def within(s: Scope, closed: Value) -> Value:
    """A number between 0 and 1, which one outside counts as."""
    above, below = s.tracer.call("on", closed - 1.0), s.tracer.call("on", -closed)
    return closed * (1.0 - above - below) + above


def by_axis(s: Scope, qdot: Array) -> dict[str, Array]:
    """What the rows of the assembled system take of the brakes, axis by axis."""
    own = on_axes(s, qdot)
    rows = [own.get(axis, FREE) for axis in range(s.key.joints)]
    names = {"share": "share", "grip": "inertia", "stop": "stop"}
    return {name: mx.array([getattr(grip, part) for grip in rows]) for name, part in names.items()}


def braked_rows(s: Scope) -> None:
    """The rows with brakes at given motion and efforts: their sum, which vanishes in a motion that the rest makes.

    Also share and inertia, and by what the sum changes with rate and input where motion and efforts are held.
    """
    out: dict[str, list[Value]] = {name: [] for name in (BALANCE, *ROWS)}
    efforts, qdot, qddot = s.read("brake_effort", len(s.key.brakes)), s.read("qdot"), s.read("qddot")
    found = on_axes(s, qdot) | on_rotors(s)
    for place, axis in enumerate(s.key.brakes):
        grip, rate, acceleration, borne = found[axis], qdot[axis], qddot[axis], efforts[place]
        if axis in s.key.added_axes:  # what an implicit method couples to its axis, inverse dynamics leaves out
            k = s.key.added_axes.index(axis)
            borne = borne + s.read("m_gear")[k] * acceleration
            rate, acceleration = s.read("thetadot")[k], s.read("thetaddot")[k]
        row = grip.share * borne + grip.inertia * (acceleration - grip.stop)
        (by_rate,), (by_input,) = columns([row], [rate, s.read("brake")[place]])
        for name, value in zip(out, (row, grip.share, grip.inertia, by_rate, by_input), strict=True):
            out[name].append(value)
    for name, values in out.items():
        s.write(name, values)


BALANCE = "brake_balance"
ROWS = ("brake_share", "brake_inertia", "brake_by_rate", "brake_by_input")
