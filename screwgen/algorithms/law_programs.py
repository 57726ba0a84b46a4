"""The programs of the laws of single coordinates (:mod:`..elements`): forces, what implicit steps take, derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np

from ..elements.law import Law, Secant
from ..ir.derivative import columns
from ..ir.program import Node, Program, Tracer, Value
from ..ir.replay import run


@cache
def forces(law: Law, sides: tuple[int, ...]) -> Program:
    """``(x, w, constants) -> (force, by_x, by_w)`` of coordinates with these sides, and the derivatives."""
    tracer, names = Tracer(), ("x", "w", *law.constants)
    inputs = [tracer.input(name, len(sides)) for name in names]
    out: dict[str, list[Value]] = {"force": [], "by_x": [], "by_w": []}
    for side, x, w, *constants in zip(sides, *inputs, strict=True):
        force = law.force(tracer, float(side), x, w, *constants)
        slopes = (column[0] for column in columns([force], [x, w]))
        for name, value in zip(out, (force, *slopes), strict=True):
            out[name].append(value)
    return tracer.program(law.name, dict.fromkeys(names, len(sides)), out)


STAGE = ("side", "x", "w", "there", "h")
"""The inputs of a stage besides the constants."""


@cache
def secants(law: Law) -> Program:
    """``(STAGE, constants) -> (stiffness, damping, rest, constant)`` of one coordinate."""
    tracer, inputs = _stage(law)
    found = _secant(law, tracer, inputs)
    return tracer.program(law.name, _sizes(law), {name: [value] for name, value in found._asdict().items()})


@cache
def stage(law: Law) -> Program:
    """``(STAGE, constants) -> (force, inertia)``: the force ``h`` later without the accelerations' part, which is
    ``inertia`` times the acceleration."""
    tracer, inputs = _stage(law)
    force, inertia = _later(law, tracer, inputs)
    return tracer.program(law.name, _sizes(law), {"force": [force], "inertia": [inertia]})


@cache
def stage_slopes(law: Law) -> Program:
    """``(STAGE, constants, a) -> (by_x, by_w, by_there)`` of that force at a given acceleration ``a``, all of it."""
    tracer, inputs = _stage(law)
    force, inertia = _later(law, tracer, inputs)
    whole = force + inertia * tracer.input("a", 1)[0]
    _, x, w, there, *_ = inputs
    by_x, by_w, by_there = columns([whole], [x, w, there])
    return tracer.program(law.name, _sizes(law) | {"a": 1}, {"by_x": by_x, "by_w": by_w, "by_there": by_there})


def _stage(law: Law) -> tuple[Tracer, list[Value]]:
    tracer = Tracer()
    return tracer, [tracer.input(name, 1)[0] for name in _sizes(law)]


def _sizes(law: Law) -> dict[str, int]:
    return dict.fromkeys((*STAGE, *law.constants), 1)


def _later(law: Law, tracer: Tracer, inputs: Sequence[Value]) -> tuple[Value, Value]:
    _, x, w, _, h, *_ = inputs
    return _linear(_secant(law, tracer, inputs), x, w, h, law.positional)


def _linear(secant: Secant, x: Value, w: Value, h: Value, positional: bool = True) -> tuple[Value, Value]:
    """The linear force ``h`` later without the accelerations' part, and what multiplies these."""
    stiffness, damping, rest, constant = secant
    moved = stiffness * (x - rest + h * w) if positional else 0.0
    return moved + damping * w + constant, h * (damping + h * stiffness)


SPRING = ("x", "w", "h", "K", "D")
"""The inputs of a spring and a damper, of one coordinate or between two."""


@cache
def spring_stage(later: bool = True, own: bool = False) -> Program:
    """``SPRING -> (inertia, force)``: what a spring and a damper exert ``h`` later, as :func:`stage` says.

    ``later``: with h, else at once; ``own``: with the inertia ``M`` of the coordinate itself, an input, added.
    """
    tracer, names = Tracer(), (*SPRING, *["M"] * own)
    x, w, h, K, D, *M = (tracer.input(name, 1)[0] for name in names)
    force, inertia = _linear(Secant(K, D, 0.0), x, w, h if later else 0.0)
    total = M[0] + inertia if own else inertia
    return tracer.program("spring", dict.fromkeys(names, 1), {"inertia": [total], "force": [force]})


@cache
def spring_slopes(times: int = 1) -> Program:
    """``(SPRING, a) -> (by_x, by_w)``: the derivatives of that force, with the part of the acceleration a.

    ``times``: in how many places of a matrix they stand, two between coordinates.
    """
    tracer, names = Tracer(), (*SPRING, "a")
    x, w, h, K, D, a = (tracer.input(name, 1)[0] for name in names)
    force, inertia = _linear(Secant(K, D, 0.0), x, w, h)
    by_x, by_w = columns([force + inertia * a], [x, w])
    tracer.named("by_rate", by_w[0])
    return tracer.program("spring", dict.fromkeys(names, 1), {"by_x": by_x * times, "by_w": by_w * times})


def _secant(law: Law, tracer: Tracer, inputs: Sequence[Value]) -> Secant:
    """What a law states, or the tangents in the state.

    Where the force falls with the coordinate or its rate, what accelerations add to it over a step is left out: it
    would take inertia from the coordinate, and turn its motion round where none is left.
    """
    if law.secant is not None:
        return law.secant(tracer, *inputs)
    side, x, w, _, h, *constants = inputs
    force = law.force(tracer, side, x, w, *constants)
    slope, by_rate = (column[0] for column in columns([force], [x, w]))
    stiffness, damping = _rising(tracer, slope), _rising(tracer, by_rate)
    return Secant(stiffness, damping, x, force - damping * w + (slope - stiffness) * (h * w))


def _rising(tracer: Tracer, slope: Value) -> Value:
    """A slope where it is positive, else zero."""
    return tracer.call("on", slope) * slope if isinstance(slope, Node) else max(slope, 0.0)


# ------------------------------------------------------------------------------------------ on arrays


def on_arrays(op: str, x: Any) -> Any:
    """The unary primitives on arrays of NumPy."""
    if op == "neg":
        return -x
    return np.asarray(x > 0, float) if op == "on" else getattr(np, op)(x)


def replayed(program: Program, given: Mapping[str, Any], unary: Callable = on_arrays) -> dict[str, Any]:
    """The outputs of a program of one coordinate, run on arrays of all of them."""
    found, _ = run(program, {name: [value] for name, value in given.items()}, unary)
    return {name: value for name, (value,) in found.items()}
