"""Where the laws of single axes act (:mod:`..elements`): on the coordinates of a link and of a robot, and in phases."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..elements import Law
from ..ir.program import Value, Vector
from ..spec.axis_laws import LawOnAxis
from ..spec.link_class import LinkClass
from ..topology.chain import Chain
from .scope import Scope

Place = tuple[str, int]
"""A part of a link's coordinates, `q` or `theta`, and the number there."""


class LawsOfLink(NamedTuple):
    """A law, where it acts among the coordinates of a link, and at which side of each."""

    law: Law
    places: list[Place]
    sides: tuple[int, ...]


class LawsOfRobot(NamedTuple):
    """A law, the coordinates on which it acts, as numbers among the given ones (``n_given``), and the side of each.

    ``axes``: the axes that elastic gears join to these, of a law that depends on them.
    """

    law: Law
    coordinates: list[int]
    sides: list[int]
    axes: list[int]


def of_link(key: LinkClass) -> list[LawsOfLink]:
    """The laws that act on a link's coordinates."""
    groups = [(law, [one for one in key.laws if one.law == law]) for law in dict.fromkeys(one.law for one in key.laws)]
    return [LawsOfLink(law, [(x.part, x.place) for x in own], tuple(x.side for x in own)) for law, own in groups]


def of_robot(chain: Chain) -> list[LawsOfRobot]:
    """The laws that act in a robot, link by link."""
    return [
        LawsOfRobot(
            law, [x.coordinate for x in own], [x.side for x in own], [x.axis for x in own if x.axis is not None]
        )
        for law, own in chain.laws.items()
    ]


def columns_of(s: Scope) -> Iterator[tuple[str, list[Value]]]:
    """The columns of laws, recorded from the parameters: name, an entry for each coordinate."""
    for law in dict.fromkeys(one.law for one in s.key.laws):
        read = lambda label: 0.0 if label is None else s.read(f"p.{label}", 1)[0]  # noqa: E731
        entries = (law.prepared(*map(read, one.labels)) for one in s.key.laws if one.law == law)
        yield from zip(law.constants, map(list, zip(*entries, strict=True)), strict=True)


# ------------------------------------------------------------------------------------------ in phases


def axis_forces(s: Scope, q: Vector, qdot: Vector) -> Iterator[tuple[int, Value]]:
    """The forces of laws on the joint's axes, each with its axis; friction of rotors is not among them."""
    for one in _on_axes(s):
        law, _, axis, side, labels = one
        given, constants = (s.tracer, float(side), q[axis], qdot[axis]), _constants(s, law, labels)
        if law.bristle is None:
            yield axis, law.force(*given, *constants)
            continue
        z = s.read("z")[s.key.internal.index(one)]
        own = law.bristle(*given, z, *constants)
        yield axis, own.stiffness * z + own.damping * (own.gain * qdot[axis] - own.decay * z)


def axis_energy(s: Scope, q: Vector) -> Value:
    """Twice the potential of laws, and of the internal states of all of them."""
    total: Value = 0.0
    for k, one in enumerate(s.key.internal):
        z, constants = s.read("z")[k], _constants(s, one.law, one.labels)
        assert one.law.bristle is not None
        bent = one.law.bristle(s.tracer, float(one.side), 0.0, 0.0, z, *[0.0] * one.law.beside, *constants)
        total = total + bent.stiffness * (z * z) / bent.sticks
    for law, _, axis, side, labels in _on_axes(s):
        total = total + law.energy(s.tracer, float(side), q[axis], *_constants(s, law, labels))
    return total


def _on_axes(s: Scope) -> list[LawOnAxis]:
    return [one for one in s.key.laws if one.part == "q"]


def _constants(s: Scope, law: Law, labels: tuple[str | None, ...]) -> tuple[Value, ...]:
    return law.prepared(*(0.0 if label is None else s.constant(label) for label in labels))
