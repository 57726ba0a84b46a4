"""Transmissions of axes in phases: what the travels of their drives (:mod:`..elements.travel`) do to joints.

With the travel ``l(q)`` and the effort ``F`` the axis gets ``l' F``. A rotor of inertia ``J`` that turns by ``N`` per
travel is the inertia ``J N² l'²`` of the axis and the force ``J N² l' l'' qdot²``. Friction acts at the rate ``l'
qdot``, and ``l'`` times it on the axis. All of it depends on posture and rates alone and is explicit in every method.

The gear may be elastic: :mod:`.elastic_travels`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from ..elements import Travel
from ..ir.program import Array, Program, Tracer, Value
from . import matrices as mx
from .scope import Scope

INERTIA = "crank_inertia"
"""The inertia of a rotor along the travel that it drives, and what a phase stores of it at the axis."""


@cache
def relation(travel: Travel) -> Program:
    """``(q, given) -> (relation)`` of a transmission, with the values of its keys as ``given``: l' and l''."""
    tracer, count = Tracer(), len(travel.KEYS)
    *found, room = travel.slopes(tracer, tracer.input("q", 1)[0], *tracer.input("given", count))
    tracer.guard(room)
    return tracer.program("relation", {"q": 1, "given": count}, {"relation": list(found)})


@dataclass
class Cranks:
    """The transmissions of a joint's axes: l', inertia and force, (m,) each; an axis without one has 1, 0 and 0.

    ``bias``: the force along the travel, of which ``force`` is ``l'`` times; stored where gears are elastic.
    """

    slope: Array
    inertia: Array
    force: Array
    bias: Array

    def keep(self, s: Scope) -> None:
        """Store it for later phases of the link."""
        for name in _stored(s):
            s.keep(f"crank_{name}", getattr(self, name))


def _stored(s: Scope) -> tuple[str, ...]:
    return ("slope", "inertia", "force", *["bias"] * bool(s.key.elastic_travels))


def kept(s: Scope) -> Cranks:
    """What an earlier phase stored."""
    found = {name: s.kept(f"crank_{name}") for name in _stored(s)}
    return Cranks(**{"bias": mx.zeros(s.key.joints)} | found)


def of_axis(s: Scope, axis: int, q: Array, guarded: bool = True) -> tuple[Value, Value]:
    """``l'`` and ``l''`` of an axis with a transmission; ``guarded``: the program has no result out of its reach."""
    drive, constant = s.key.drives[axis], lambda x: s.constant(f"drive_{x}_{axis + 1}")
    assert drive.travel is not None
    slope, curve, room = drive.travel.slopes(
        s.tracer, q[axis], *map(constant, drive.travel.KEYS), elastic=drive.elastic
    )
    if guarded:
        s.tracer.guard(room)
    return slope, curve


def slopes(s: Scope, q: Array) -> Array:
    """``l'`` of every axis (m,), 1 without a transmission."""
    return mx.array([of_axis(s, k, q)[0] if k in s.key.travels else 1.0 for k in range(s.key.joints)])


def cranks(s: Scope, q: Array, qdot: Array) -> Cranks:
    """The transmissions of the joint's axes at a posture and at rates."""
    m = s.key.joints
    out = Cranks(mx.array([1.0] * m), mx.zeros(m), mx.zeros(m), mx.zeros(m))
    for axis in s.key.travels:
        slope, curve = of_axis(s, axis, q)
        force = _friction(s, axis, travel_rate(s, axis, slope, qdot)) if rubs(s, axis) else 0.0
        if s.key.drives[axis].rotor_inertia:
            mass = s.constant(f"{INERTIA}_{axis + 1}")
            out.inertia[axis] = mass * slope * slope
            force = force + mass * curve * qdot[axis] * qdot[axis]
        out.slope[axis], out.force[axis], out.bias[axis] = slope, slope * force, force
    return out


def rubs(s: Scope, axis: int) -> bool:
    """Whether friction acts along the travel of an axis."""
    drive = s.key.drives[axis]
    return drive.coulomb or drive.viscous or drive.bend


def travel_rate(s: Scope, axis: int, slope: Value, qdot: Array) -> Value:
    """The rate of the travel of a transmission, with that of the rotor ahead of it where the gear is elastic."""
    rate = slope * qdot[axis]
    return rate + s.read("thetadot")[s.key.added_axes.index(axis)] if axis in s.key.elastic_travels else rate


def _friction(s: Scope, axis: int, rate: Value) -> Value:
    """The friction along the travel at its rate."""
    drive = s.key.drives[axis]
    total: Value = 0.0
    if drive.viscous:
        total = s.constant(f"drive_viscous_{axis + 1}") * rate
    for law, names in drive.frictions:
        constants = law.prepared(*(s.constant(f"drive_{name}_{axis + 1}") for name in names))
        total = total + law.force(s.tracer, 1.0, 0.0, rate, *constants)
    return total


def kinetic(s: Scope, q: Array, qdot: Array) -> Value:
    """Twice the kinetic energy of the rotors, not a number out of the reach of their linkages."""
    total: Value = 0.0
    for axis in s.key.travels if s.key.has_travelling_inertia else ():
        if s.key.drives[axis].rotor_inertia:
            rate = travel_rate(s, axis, of_axis(s, axis, q, guarded=False)[0], qdot)
            total = total + s.constant(f"{INERTIA}_{axis + 1}") * rate * rate
    return total


def store(s: Scope, q: Array, qdot: Array) -> None:
    """Base to tip: the transmissions of the joint's axes, for the phases that follow."""
    if s.key.travels:
        cranks(s, q, qdot).keep(s)


def levers(s: Scope) -> None:
    """The travel per unit of each axis: what its effort is multiplied by."""
    s.write("levers", slopes(s, s.read("q")) if s.key.travels else np.array([1.0] * s.key.torques, object))


def cylinders(s: Scope) -> None:
    """The length of the cylinder of each axis; 0 of an axis without one."""
    q, out = s.read("q"), mx.zeros(s.key.torques)
    for axis, travel in s.key.travels.items():
        if travel.IS_LENGTH:
            numbers = (s.constant(f"drive_{x}_{axis + 1}") for x in travel.KEYS)
            out[axis] = travel.length(s.tracer, q[axis], *numbers)
    s.write("cylinder_length", out)
