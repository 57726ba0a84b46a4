"""The programs of the laws of single coordinates (:mod:`..elements`): forces, what implicit steps take, derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np

from ..elements.law import Bristle, Law, Secant
from ..ir.derivative import columns
from ..ir.program import Node, Program, Tracer, Value
from ..ir.replay import run


@cache
def forces(law: Law, sides: tuple[int, ...]) -> Program:
    """``(x, w, constants) -> (force, by_x, by_w)`` of coordinates with these sides, and the derivatives.

    Of a law with a state ``(x, w, z, constants) -> (force, by_x, by_w, by_z, rate, rate_x, rate_w, rate_z)``. One that
    depends on an axis besides has its coordinate ``axis`` behind these, and the slopes by it.
    """
    motions = ("x", "w", *_more(law))
    tracer, names = Tracer(), (*motions, *law.constants)
    inputs = [tracer.input(name, len(sides)) for name in names]
    out: dict[str, list[Value]] = {}
    for side, *given in zip(sides, *inputs, strict=True):
        motion = given[: len(names) - len(law.constants)]
        if law.bristle is None:
            values = {"force": law.force(tracer, float(side), *given)}
        else:
            own = law.bristle(tracer, float(side), *given)
            rate = own.gain * motion[1] - own.decay * motion[2]
            values = {"force": own.stiffness * motion[2] + own.damping * rate, "rate": rate}
        for name, value in values.items():
            slopes = (column[0] for column in columns([value], motion))
            parts = zip(("", *motions), (value, *slopes), strict=True)
            for by, part in parts:
                out.setdefault(f"{SLOPE[name]}_{by}" if by else name, []).append(part)
    return tracer.program(law.name, dict.fromkeys(names, len(sides)), out)


SLOPE = {"force": "by", "rate": "rate"}

STAGE = ("side", "x", "w", "there", "h")
"""The inputs of a stage besides the constants. A law with a state has this, `z`, at the start, and one that depends on
an axis besides the coordinate of this, `axis`."""


def _more(law: Law) -> tuple[str, ...]:
    return (*["z"] * (law.state is not None), *["axis"] * law.beside)


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
    """``(STAGE, constants, a) -> (by_x, by_w, by_there)`` of that force at a given acceleration ``a``, all of it.

    Of a law with a state ``by_z`` besides, of one that depends on an axis ``by_axis``.
    """
    tracer, inputs = _stage(law)
    force, inertia = _later(law, tracer, inputs)
    whole = force + inertia * tracer.input("a", 1)[0]
    return tracer.program(law.name, _sizes(law) | {"a": 1}, _slopes(law, whole, inputs, "by"))


@cache
def state_rate(law: Law) -> Program:
    """``(STAGE, constants, a) -> (rate)``: the mean rate of a law's state over ``h`` at a given acceleration ``a``."""
    tracer, inputs = _stage(law)
    return tracer.program(law.name, _sizes(law) | {"a": 1}, {"rate": [_rate(law, tracer, inputs)]})


@cache
def state_slopes(law: Law) -> Program:
    """``(STAGE, constants, a) -> (rate_x, rate_w, rate_there, rate_z, rate_a)`` of that rate, and ``rate_axis``."""
    tracer, inputs = _stage(law)
    rate, a = _rate(law, tracer, inputs), tracer.input("a", 1)[0]
    out = _slopes(law, rate, inputs, "rate") | {"rate_a": columns([rate], [a])[0]}
    return tracer.program(law.name, _sizes(law) | {"a": 1}, out)


@cache
def stuck(law: Law) -> Program:
    """``(STAGE, constants) -> (stiffness, damping, force)`` of a law whose state follows its coordinate as it does at
    rest: a spring and a damper, and the force at once."""
    tracer, inputs = _stage(law)
    assert law.bristle is not None
    side, x, w, _, _, z, *constants = inputs
    own = law.bristle(tracer, side, x, w, z, *constants)
    force = own.stiffness * z + own.damping * (own.gain * w - own.decay * z)
    out = {"stiffness": [own.stiffness * own.gain], "damping": [own.damping * own.gain], "force": [force]}
    return tracer.program(law.name, _sizes(law), out)


def _rate(law: Law, tracer: Tracer, inputs: Sequence[Value]) -> Value:
    _, _, w, _, h, z, *_ = inputs
    own, share = _bristle(law, tracer, inputs)
    return share * (own.gain * (w + h * tracer.input("a", 1)[0]) - own.decay * z)


def _bristle(law: Law, tracer: Tracer, inputs: Sequence[Value]) -> tuple[Bristle, Value]:
    """A law's state at the rates of a stage, and ``1 / (1 + h decay)``."""
    assert law.bristle is not None
    side, x, _, there, h, z, *constants = inputs
    own = law.bristle(tracer, side, x, there, z, *constants)
    return own, tracer.named("share", 1.0 / (1.0 + h * own.decay))


def _slopes(law: Law, value: Value, inputs: Sequence[Value], word: str) -> dict[str, list[Value]]:
    """The derivatives of a value of a stage with coordinate, rates and state."""
    names = ("x", "w", "there", *_more(law))
    found = columns([value], [dict(zip(_sizes(law), inputs, strict=True))[name] for name in names])
    return {f"{word}_{name}": column for name, column in zip(names, found, strict=True)}


def _stage(law: Law) -> tuple[Tracer, list[Value]]:
    tracer = Tracer()
    return tracer, [tracer.input(name, 1)[0] for name in _sizes(law)]


def _sizes(law: Law) -> dict[str, int]:
    return dict.fromkeys((*STAGE, *_more(law), *law.constants), 1)


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
    if law.state is not None:
        own, share = _bristle(law, tracer, inputs)
        _, _, _, _, h, z, *_ = inputs
        damping = share * own.gain * (h * own.stiffness + own.damping)
        return Secant(0.0, damping, 0.0, share * (own.stiffness - own.damping * own.decay) * z)
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


def on_arrays(op: str, x: Any, *more: Any) -> Any:
    """The primitives on arrays of NumPy."""
    if op in ("neg", "atan2"):
        return -x if op == "neg" else np.arctan2(x, *more)
    return np.asarray(x > 0, float) if op == "on" else getattr(np, op)(x)


def replayed(program: Program, given: Mapping[str, Any], functions: Callable = on_arrays) -> dict[str, Any]:
    """The outputs of a program of one coordinate, run on arrays of all of them."""
    found, _ = run(program, {name: [value] for name, value in given.items()}, functions)
    return {name: value for name, (value,) in found.items()}
