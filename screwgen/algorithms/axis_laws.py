"""Where the laws of single axes act (:mod:`..elements`): on the coordinates of a link and of a robot, and in phases."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ..elements import FRICTION, STOP, Law
from ..ir.program import Value
from ..spec.link_class import SIDES, LinkClass, Stop
from ..topology.chain import Chain
from .scope import Scope

Place = tuple[str, int]
"""A part of a link's coordinates, `q` or `theta`, and the number there."""


class OfLink(NamedTuple):
    """A law, where it acts among the coordinates of a link, and at which side of each."""

    law: Law
    places: list[Place]
    sides: tuple[int, ...]


class OfRobot(NamedTuple):
    """A law, the coordinates on which it acts, as numbers among the given ones (``n_given``), and the side of each."""

    law: Law
    coordinates: list[int]
    sides: list[int]


def of_link(key: LinkClass) -> list[OfLink]:
    """The laws that act on a link's coordinates; dry friction behind an elastic gear acts on its rotor."""
    dry = [("theta", key.motors.index(axis)) if axis in key.motors else ("q", axis) for axis in key.rubbed]
    stops = [("q", axis) for axis, _ in key.stops]
    sides = tuple(SIDES[side] for _, side in key.stops)
    found = OfLink(FRICTION, dry, (1,) * len(dry)), OfLink(STOP, stops, sides)
    return [one for one in found if one.places]


def of_robot(chain: Chain) -> list[OfRobot]:
    """The laws that act in a robot, link by link."""
    dry = OfRobot(FRICTION, chain.dry, [1] * len(chain.dry))
    stops = OfRobot(STOP, [k for k, _ in chain.stops], [side for _, side in chain.stops])
    return [one for one in (dry, stops) if one.coordinates]


# ------------------------------------------------------------------------------------------ in phases


def constant_of_stop(s: Scope, name: str, where: Stop) -> Value:
    """One of the constants of a stop, recorded from the parameters."""
    axis, side = where
    if name == "stop_D" and axis not in s.key.stop_damping:
        return 0.0
    label = {"stop_at": side, "stop_K": "stiffness", "stop_D": "damping"}[name]
    return s.read(f"p.limit_{label}_{axis + 1}", 1)[0]


def _constants(s: Scope, where: Stop) -> tuple[Value, Value, Value]:
    """The same for a phase, out of the link's constants."""
    axis, side = where
    damped = axis in s.key.stop_damping
    read = lambda label: s.constant(f"limit_{label}_{axis + 1}")  # noqa: E731
    return read(side), read("stiffness"), read("damping") if damped else 0.0


def axis_forces(s: Scope, q: Sequence[Value], qdot: Sequence[Value]) -> Iterator[tuple[int, Value]]:
    """The forces of laws on the joint's axes, each with its axis; friction of rotors is not among them."""
    for axis in (axis for axis in s.key.rubbed if axis not in s.key.motors):
        velocity, coulomb = (s.constant(f"drive_{x}_{axis + 1}") for x in ("velocity", "coulomb"))
        yield axis, FRICTION.force(s.tracer, 1.0, q[axis], qdot[axis], coulomb, velocity * velocity)
    for where in s.key.stops:
        axis, side = where
        constants = _constants(s, where)
        yield axis, STOP.force(s.tracer, float(SIDES[side]), q[axis], qdot[axis], *constants)


def stop_energy(s: Scope, q: Sequence[Value]) -> Value:
    """Twice the potential of the stops."""
    total: Value = 0.0
    for axis, side in s.key.stops:
        at, k, _ = _constants(s, (axis, side))
        total = total + STOP.energy(s.tracer, float(SIDES[side]), q[axis], at, k)
    return total
