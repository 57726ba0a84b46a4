"""The contract of a force on single coordinates that is not linear, and the programs that follow from it.

An example: dry friction ``F = c w / sqrt(w² + s²)`` at a rate w. Three things are needed of it. The dynamics need F.
An implicit method takes it as the damping ``c / sqrt(w² + s²)`` at the rates of a stage, times the rate after the
step. The derivative of that step needs the slopes of both. A law states the first two; the tracer derives the third,
and every back end replays or prints these programs: NumPy, CasADi and JAX on arrays of all coordinates of a kind, C in
a loop.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple, Protocol

import numpy as np

from ..ir.derivative import columns
from ..ir.program import Label, Program, Tracer, Value, give_label
from ..ir.replay import run


class Secant(NamedTuple):
    """A law as the linear force ``stiffness (x - rest) + damping w`` over a step."""

    stiffness: Any
    damping: Any
    rest: Any


class Law(Hashable, Protocol):
    """A kind of force on single coordinates, on the left of the equations of motion.

    ``side``: +1 or -1, which of two ends it acts at; ``x``, ``w``: the coordinate (rad or m) and its rate.
    """

    @property
    def name(self) -> str:
        """A word for generated code."""

    @property
    def words(self) -> str:
        """What it is called in comments."""

    @property
    def constants(self) -> tuple[str, ...]:
        """The robot's columns that hold its constants, one entry for each coordinate."""

    @property
    def positional(self) -> bool:
        """Whether it depends on the coordinate, not on the rate alone."""

    def force(self, t: Tracer, side: Value, x: Value, w: Value, *constants: Value) -> Value:
        """The force in a state."""

    def secant(self, t: Tracer, side: Value, x: Value, w: Value, there: Value, h: Value, *constants: Value) -> Secant:
        """What implicit methods take ``h`` after ``x`` and ``w``; ``there``: the rate at the stage."""


def named(name: str, value: Value) -> Value:
    """The value, called so in generated code."""
    give_label(value, Label(name))
    return value


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
    """``(STAGE, constants) -> (stiffness, damping, rest)`` of one coordinate."""
    tracer, inputs = _stage(law)
    found = law.secant(tracer, *inputs)
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
    stiffness, damping, rest = law.secant(tracer, *inputs)
    moved = stiffness * (x - rest + h * w) if law.positional else 0.0
    return moved + damping * w, h * (damping + h * stiffness)


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
