"""Forces of single axes that are not linear: dry friction and compliant stops.

A stop acts on the joint coordinate while that is beyond its limit. With the penetration ``p > 0`` it pushes back with
``max(0, k p + d pdot)``: a spring and a damper in parallel, clamped so that the stop never pulls. The potential
``k p^2 / 2`` is stored, all else dissipated.

Implicit methods take every law as a linear one, by secants. That of dry friction is a damping of the size that it has
at the rates of a stage. That of a stop follows from the way of the coordinate over a step, as its rate predicts it:
``share`` of the way is beyond the limit, and ``k`` and ``d`` times the share act on the mean penetration of that part
(:func:`secants`). A body that hits a stop of any stiffness gets no more energy back than it brought; in contact
throughout it is the midpoint rule.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from ..ir.program import Program, Tracer, Value
from ..spec.link_class import SIDES, Stop
from .scope import Scope


@cache
def friction(count: int) -> Program:
    """``(w, coulomb, speed) -> (force, slope)``: dry friction at rates ``w``, and its derivative; speeds are squared.

    ``coulomb w / sqrt(w^2 + speed)``, whose secant ``coulomb / sqrt(w^2 + speed)`` implicit methods take as a damping.
    """
    tracer = Tracer()
    w, coulomb, speed = (tracer.input(name, count) for name in ("w", "coulomb", "speed"))
    force: list[Value] = []
    slope: list[Value] = []
    for rate, dry, square in zip(w, coulomb, speed, strict=True):
        whole = rate * rate + square
        secant = dry / tracer.call("sqrt", whole)
        force.append(secant * rate)
        slope.append(secant * square / whole)
    return tracer.program("friction", {"w": count, "coulomb": count, "speed": count}, {"force": force, "slope": slope})


# ------------------------------------------------------------------------------------------ stops

STOP = ("stop_at", "stop_K", "stop_D")
"""Limit, stiffness and damping of a stop."""


@cache
def stop(sides: tuple[str, ...]) -> Program:
    """``(x, w, stop_at, stop_K, stop_D) -> (force, slope_x, slope_w)``: stops at coordinates ``x`` with rates ``w``.

    ``force`` is that on the left of the equations of motion; the slopes are its derivatives.
    """
    tracer, names, count = Tracer(), ("x", "w", *STOP), len(sides)
    columns = [tracer.input(name, count) for name in names]
    out: dict[str, list[Value]] = {"force": [], "slope_x": [], "slope_w": []}
    for side, x, w, at, k, d in zip(sides, *columns, strict=True):
        push, acts = pushed(tracer, side, x, w, at, k, d)
        for name, value in zip(out, (SIDES[side] * (acts * push), acts * k, acts * d), strict=True):
            out[name].append(value)
    return tracer.program("stop", dict.fromkeys(names, count), out)


def pushed(tracer: Tracer, side: str, x: Value, w: Value, at: Value, k: Value, d: Value) -> tuple[Value, Value]:
    """``k p + d pdot`` of a stop, and 1 where it acts, else 0."""
    depth, rate = SIDES[side] * (x - at), SIDES[side] * w
    push = k * depth + d * rate
    return push, tracer.call("on", depth) * tracer.call("on", push)


class Secants(NamedTuple):
    """A stop as the linear force ``stiffness (x - rest) + damping w`` over a step."""

    stiffness: Any
    damping: Any
    rest: Any


def secants(side, x, w, there, h, at, k, d, on: Callable) -> Secants:
    """The secants of stops that implicit methods take ``h`` after the coordinates ``x`` with rates ``w``.

    ``there``: the rates at the stage; of both the one that leads deeper counts. A step is taken to end ``2 h`` after
    its start. ``side``: 1 at an upper limit, -1 at a lower one; ``on(x)`` is 1 where x > 0, else 0. Values are numbers,
    arrays, or symbols of CasADi; the C has the same operations in the same order.
    """
    start, rate, later = side * (x - at), side * w, side * there
    rate = rate + (later - rate) * on(later - rate)
    way = 2 * h * rate
    low, high = start + way * on(-way), start + way * on(way)
    outside, beyond = low * on(-low), on(high)
    share = beyond * high / (beyond * high - outside + (1 - beyond))
    push = k * (start + 0.5 * way - 0.5 * outside) + d * rate
    share = share * on(push)
    return Secants(k * share, d * share, at + side * (0.5 * outside))


def constant_of_stop(s: Scope, name: str, where: Stop) -> Value:
    """One of ``STOP``, recorded from the parameters."""
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


def stop_torque(s: Scope, q, qdot) -> list[Value]:
    """The forces of the stops on the joint's axes, 0 on axes without any."""
    out: list[Value] = [0.0] * s.key.joints
    for axis, side in s.key.stops:
        push, acts = pushed(s.tracer, side, q[axis], qdot[axis], *_constants(s, (axis, side)))
        out[axis] = out[axis] - SIDES[side] * (acts * push)
    return out


def stop_energy(s: Scope, q) -> Value:
    """Twice the potential of the stops."""
    total: Value = 0.0
    for axis, side in s.key.stops:
        at, k, _ = _constants(s, (axis, side))
        depth = SIDES[side] * (q[axis] - at)
        total = total + s.tracer.call("on", depth) * (k * depth * depth)
    return total
