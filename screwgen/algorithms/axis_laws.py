"""Where the laws of single axes act (:mod:`..elements`): on the coordinates of a link and of a robot, and in phases."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..elements import FRICTION, STOP, Law
from ..elements.axis_element import OfElement
from ..ir.program import Value, Vector
from ..spec.link_class import SIDES, LinkClass
from ..topology.chain import Chain
from ..topology.parameters import element_label
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
    found = [OfLink(FRICTION, dry, (1,) * len(dry)), OfLink(STOP, stops, sides)]
    for kind in dict.fromkeys(kind for kind, _ in key.elements):
        axes = [("q", axis) for axis in key.axes_with(kind)]
        found.append(OfLink(OfElement(kind), axes, (1,) * len(axes)))
    return [one for one in found if one.places]


def of_robot(chain: Chain) -> list[OfRobot]:
    """The laws that act in a robot, link by link."""
    dry = OfRobot(FRICTION, chain.dry, [1] * len(chain.dry))
    stops = OfRobot(STOP, [k for k, _ in chain.stops], [side for _, side in chain.stops])
    more = [OfRobot(OfElement(kind), places, [1] * len(places)) for kind, places in chain.elements.items()]
    return [one for one in (dry, stops, *more) if one.coordinates]


# ------------------------------------------------------------------------------------------ constants


class Acting(NamedTuple):
    """A law on one axis of a joint: its side there, and the labels of its constants, None for one that is zero."""

    law: Law
    axis: int
    side: int
    labels: tuple[str | None, ...]


def on_axes(key: LinkClass) -> Iterator[Acting]:
    """The laws on the axes of a link's joint; friction on rotors and in transmissions is not among them."""
    for axis in (axis for axis in key.rubbed if axis not in key.motors):
        yield Acting(FRICTION, axis, 1, (f"drive_coulomb_{axis + 1}", f"drive_velocity_{axis + 1}"))
    yield from stops(key)
    for kind, axis in key.elements:
        yield Acting(OfElement(kind), axis, 1, tuple(element_label(kind.KIND, x, axis) for x in kind.table()))


def stops(key: LinkClass) -> Iterator[Acting]:
    """The stops of the axes."""
    for axis, side in key.stops:
        damping = f"limit_damping_{axis + 1}" if axis in key.stop_damping else None
        yield Acting(STOP, axis, SIDES[side], (f"limit_{side}_{axis + 1}", f"limit_stiffness_{axis + 1}", damping))


def columns_of(s: Scope) -> Iterator[tuple[str, list[Value]]]:
    """The columns of stops and elements, recorded from the parameters: name, an entry for each coordinate."""
    acting = [*stops(s.key), *(one for one in on_axes(s.key) if isinstance(one.law, OfElement))]
    for law in dict.fromkeys(one.law for one in acting):
        labels = zip(*(one.labels for one in acting if one.law == law), strict=True)
        for name, own in zip(law.constants, labels, strict=True):
            yield name, [0.0 if label is None else s.read(f"p.{label}", 1)[0] for label in own]


# ------------------------------------------------------------------------------------------ in phases


def axis_forces(s: Scope, q: Vector, qdot: Vector) -> Iterator[tuple[int, Value]]:
    """The forces of laws on the joint's axes, each with its axis; friction of rotors is not among them."""
    for law, axis, side, labels in on_axes(s.key):
        constants = [0.0 if label is None else s.constant(label) for label in labels]
        if law == FRICTION:
            constants[1] = constants[1] * constants[1]
        yield axis, law.force(s.tracer, float(side), q[axis], qdot[axis], *constants)


def axis_energy(s: Scope, q: Vector) -> Value:
    """Twice the potential of stops and elements."""
    total: Value = 0.0
    for law, axis, side, labels in on_axes(s.key):
        constants = [0.0 if label is None else s.constant(label) for label in labels]
        if law == STOP:
            total = total + STOP.energy(s.tracer, float(side), q[axis], *constants[:2])
        elif isinstance(law, OfElement):
            total = total + law.energy(s.tracer, float(side), q[axis], *constants)
    return total
