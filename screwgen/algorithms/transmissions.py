"""Transmissions: drives whose ratio depends on the posture.

A transmission of an axis is a relation from its coordinate q to the travel ``l(q)`` of what drives it. The input of
the axis is the effort ``F`` along that travel, so the axis gets ``l' F``. A rotor of inertia ``J_r`` that turns by
``N`` per travel has the energy ``J_r N^2 l'^2 qdot^2 / 2``: the inertia ``J_r N^2 l'^2`` of the axis and the force
``J_r N^2 l' l'' qdot^2``. Friction acts at the rate ``l' qdot``, and ``l'`` times it on the axis. All of it depends on
posture and rates alone and is explicit in every method. The travel of a cylinder is its length, that of a four-bar
linkage the angle of its crank, whose torque is then the effort.

Its gear may be elastic: :mod:`.elastic_gears`.

A further transmission is a ``Kind`` in ``KINDS``, with its keys in ``spec/transmission.py``.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial

import numpy as np

from ..arguments import Numbers
from ..elements import FRICTION
from ..errors import SingularError
from ..ir.program import Array, Program, Tracer, Value
from ..ir.replay import run
from ..spec.four_bar import NUMBERS
from ..spec.parameters import coordinate_names
from ..topology.chain import Chain
from . import four_bar
from . import matrices as mx
from .scope import Scope

Relation = tuple[Value, Value, Value]
"""The first and second derivative of a travel ``l`` with the coordinate of the axis, and what must be > 0 for them."""


@dataclass(frozen=True)
class Kind:
    """A kind of transmission: the keys of its parameters, what it is and what drives it, in words, and two functions.

    ``relation`` and the ``travel`` itself are functions of coordinate and parameters, the second of numbers alone.
    """

    keys: tuple[str, ...]
    words: tuple[str, str]
    relation: Callable[..., Relation]
    travel: Callable[..., float]


def cylinder(t: Tracer, q: Value, crank: Value, base: Value, angle: Value) -> Relation:
    """A cylinder from an eye on the carrier to one on the link; where its length is zero nothing is finite.

    ``l^2 = (base - crank)^2 + 4 base crank sin^2(u / 2)`` with ``u = q + angle`` loses no digits where it is short.
    """
    half = 0.5 * (q + angle)
    sine, cosine = t.call("sin", half), t.call("cos", half)
    area, gap = base * crank, base - crank
    square = gap * gap + 4.0 * area * (sine * sine)
    length = t.call("sqrt", square)
    slope = 2.0 * area * (sine * cosine) / length
    return slope, (area * (1.0 - 2.0 * (sine * sine)) - slope * slope) / length, 1.0


def _length(q: float, crank: float, base: float, angle: float) -> float:
    return math.hypot(base - crank * math.cos(q + angle), crank * math.sin(q + angle))


FORCE, TORQUE = ("cylinder", "force"), ("four-bar linkage", "torque at the crank")
KINDS = {
    "cylinder": Kind(("crank", "base", "angle"), FORCE, cylinder, _length),
    "four_bar_left": Kind(NUMBERS, TORQUE, partial(four_bar.slopes, 1), partial(four_bar.turn, 1)),
    "four_bar_right": Kind(NUMBERS, TORQUE, partial(four_bar.slopes, -1), partial(four_bar.turn, -1)),
}


@cache
def relation(kind: str) -> Program:
    """``(q, given) -> (relation)`` of a kind, with the values of its keys as ``given``: l' and l''."""
    tracer, keys = Tracer(), KINDS[kind].keys
    *found, room = KINDS[kind].relation(tracer, tracer.input("q", 1)[0], *tracer.input("given", len(keys)))
    tracer.guard(room)
    return tracer.program("relation", {"q": 1, "given": len(keys)}, {"relation": list(found)})


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
    return ("slope", "inertia", "force", *["bias"] * bool(s.key.loose))


def kept(s: Scope) -> Cranks:
    """What an earlier phase stored."""
    found = {name: s.kept(f"crank_{name}") for name in _stored(s)}
    return Cranks(**{"bias": mx.zeros(s.key.joints)} | found)


def of_axis(s: Scope, axis: int, q: Array, guarded: bool = True) -> tuple[Value, Value]:
    """``l'`` and ``l''`` of an axis with a transmission; ``guarded``: the program has no result out of its reach."""
    name = s.key.drives[axis].transmission
    kind, constant = KINDS[name], lambda x: s.constant(f"drive_{x}_{axis + 1}")
    more = {"elastic": True} if axis in s.key.loose and name != "cylinder" else {}
    slope, curve, room = kind.relation(s.tracer, q[axis], *map(constant, kind.keys), **more)
    if guarded:
        s.tracer.guard(room)
    return slope, curve


def slopes(s: Scope, q: Array) -> Array:
    """``l'`` of every axis (m,), 1 without a transmission."""
    return mx.array([of_axis(s, k, q)[0] if k in s.key.cranked else 1.0 for k in range(s.key.joints)])


def cranks(s: Scope, q: Array, qdot: Array) -> Cranks:
    """The transmissions of the joint's axes at a posture and at rates."""
    m = s.key.joints
    out = Cranks(mx.array([1.0] * m), mx.zeros(m), mx.zeros(m), mx.zeros(m))
    for axis in s.key.cranked:
        slope, curve = of_axis(s, axis, q)
        force = _friction(s, axis, travel_rate(s, axis, slope, qdot)) if rubs(s, axis) else 0.0
        if s.key.drives[axis].rotor_inertia:
            mass = s.constant(f"crank_inertia_{axis + 1}")
            out.inertia[axis] = mass * slope * slope
            force = force + mass * curve * qdot[axis] * qdot[axis]
        out.slope[axis], out.force[axis], out.bias[axis] = slope, slope * force, force
    return out


def rubs(s: Scope, axis: int) -> bool:
    """Whether friction acts along the travel of an axis."""
    drive = s.key.drives[axis]
    return drive.coulomb or drive.viscous


def travel_rate(s: Scope, axis: int, slope: Value, qdot: Array) -> Value:
    """The rate of the travel of a transmission, with that of the rotor ahead of it where the gear is elastic."""
    rate = slope * qdot[axis]
    return rate + s.read("thetadot")[s.key.motors.index(axis)] if axis in s.key.loose else rate


def _friction(s: Scope, axis: int, rate: Value) -> Value:
    """The friction along the travel at its rate."""
    drive = s.key.drives[axis]
    total: Value = 0.0
    if drive.viscous:
        total = s.constant(f"drive_viscous_{axis + 1}") * rate
    if drive.coulomb:
        velocity, coulomb = (s.constant(f"drive_{x}_{axis + 1}") for x in ("velocity", "coulomb"))
        total = total + FRICTION.force(s.tracer, 1.0, 0.0, rate, coulomb, velocity * velocity)
    return total


def kinetic(s: Scope, q: Array, qdot: Array) -> Value:
    """Twice the kinetic energy of the rotors, not a number out of the reach of their linkages."""
    total: Value = 0.0
    for axis in s.key.cranked if s.key.swung else ():
        if s.key.drives[axis].rotor_inertia:
            rate = travel_rate(s, axis, of_axis(s, axis, q, guarded=False)[0], qdot)
            total = total + s.constant(f"crank_inertia_{axis + 1}") * rate * rate
    return total


def store(s: Scope, q: Array, qdot: Array) -> None:
    """Base to tip: the transmissions of the joint's axes, for the phases that follow."""
    if s.key.cranked:
        cranks(s, q, qdot).keep(s)


def levers(s: Scope) -> None:
    """The travel per unit of each axis: what its effort is multiplied by."""
    s.write("levers", slopes(s, s.read("q")) if s.key.cranked else np.array([1.0] * s.key.joints, object))


# ------------------------------------------------------------------------------------ of a robot, in numbers


def travels(chain: Chain, q: Numbers, p: Numbers) -> np.ndarray:
    """(3, n_joints): ``l``, ``l'`` and ``l''`` of every axis at the joint coordinates ``q``; q, 1 and 0 without one.

    Raises SingularError where the length of a cylinder is zero, as parameters may make it, and where a linkage does not
    reach the link.
    """
    out = np.array([q, np.ones(chain.n_joints), np.zeros(chain.n_joints)], float)
    for i, key in enumerate(chain.keys):
        for axis in key.cranked:
            name, place = key.drives[axis].transmission, chain.q_offset[i] + axis
            given = [float(p[chain.parameter_labels[i][f"drive_{x}_{axis + 1}"]]) for x in KINDS[name].keys]
            at = float(q[place])
            try:
                found, guards = run(relation(name), {"q": [at], "given": given}, _unary, 2.0**-52)
                travel = KINDS[name].travel(at, *given)
            except (ZeroDivisionError, ValueError):
                guards = [0.0]
            if not all(x > 0 for x in guards):
                raise chain.singular(i)
            out[:, place] = travel, *found["relation"]
    return out


def _unary(op: str, x: float) -> float:
    return -x if op == "neg" else getattr(math, op)(x)


def efforts(chain: Chain, torques: np.ndarray, q: Numbers, p: Numbers, actuated: bool = False) -> np.ndarray:
    """Torques of the joints (n_tau,) at ``q`` as the efforts that cause them: forces of cylinders, torques of cranks.

    ``actuated``: they are the generalised forces at ``chain.actuated``, which are efforts already where gears are
    elastic. Raises SingularError where a transmission stands in a dead centre and would need an infinite effort.
    """
    if not chain.cranked:
        return torques
    slope = travels(chain, q, p)[1]
    slope[list(chain.loose) if actuated else []] = 1.0
    for joint in chain.cranked:
        if abs(slope[joint]) < DEAD and torques[joint]:
            name = coordinate_names(chain.robot).q[chain.base_q + joint]
            part, effort = KINDS[chain.cranked[joint]].words
            raise SingularError(f"{name}: its {part} is in a dead centre, where no {effort} turns the joint; leave it")
    return torques / np.where(slope == 0, 1.0, slope)


DEAD = 1e-9
"""m/rad, of a linkage 1: a lever that counts as none."""
