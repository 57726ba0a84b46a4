"""The programs of forces between frames (:mod:`..interactions`): their wrenches on both ends, energies, slopes.

All are functions of how the tips of two segments lie and move: ``R`` (9) and ``d`` (3), the pose of the second in the
first, and the twists ``V_A``, ``V_B`` (6) of both, each in its own axes, and of the ``numbers`` that the robot states,
behind which stand the inputs and the states of the force.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from ..interactions import InteractionClass, Relative
from ..ir.derivative import columns, tangents
from ..ir.program import Array, Program, Tracer
from . import matrices as mx
from .loop_slopes import pose_changes


@cache
def wrenches(shape: InteractionClass) -> Program:
    """``(R, d, V_A, V_B, numbers) -> (first, second)``: the wrenches (6,) on both tips, each in its own axes."""
    tracer, inputs = _inputs(shape, "R d V_A V_B")
    return _program(tracer, shape, "R d V_A V_B", **_wrenches(tracer, shape, inputs))


@cache
def energy(shape: InteractionClass) -> Program:
    """``(R, d, numbers) -> (energy)``, J."""
    tracer, inputs = _inputs(shape, "R d")
    R, d, numbers = inputs["R"].reshape(3, 3), inputs["d"], list(inputs["numbers"])
    found = shape.energy(tracer, Relative(d, R, mx.zeros(3), mx.zeros(3)), numbers)
    return _program(tracer, shape, "R d", energy=mx.array([found]))


@cache
def quantities(shape: InteractionClass) -> Program:
    """``(R, d, V_A, V_B, numbers) -> (quantity)``: what runs report of it."""
    tracer, inputs = _inputs(shape, "R d V_A V_B")
    found = shape.outputs(tracer, _relative(inputs), list(inputs["numbers"]))
    return _program(tracer, shape, "R d V_A V_B", quantity=mx.array(found))


@cache
def powers(shape: InteractionClass) -> Program:
    """``(R, d, V_A, V_B, numbers) -> (power)`` that its inputs give to the robot."""
    tracer, inputs = _inputs(shape, "R d V_A V_B")
    found = shape.power(tracer, _relative(inputs), list(inputs["numbers"]))
    return _program(tracer, shape, "R d V_A V_B", power=mx.array(found))


@cache
def input_slopes(shape: InteractionClass) -> Program:
    """``(R, d, V_A, V_B, numbers) -> (first, second)``: how the wrenches change with each input, (inputs, 6)."""
    tracer, inputs = _inputs(shape, "R d V_A V_B")
    return _by(tracer, shape, inputs, shape.count, len(shape.inputs))


@cache
def state_slopes(shape: InteractionClass) -> Program:
    """The same with each of its states, (states, 6)."""
    tracer, inputs = _inputs(shape, "R d V_A V_B")
    return _by(tracer, shape, inputs, shape.count + len(shape.inputs), len(shape.states))


def _by(tracer: Tracer, shape: InteractionClass, inputs: dict[str, Array], first: int, count: int) -> Program:
    """How the wrenches change with some of the numbers."""
    found, chosen = _wrenches(tracer, shape, inputs), [*inputs["numbers"]][first : first + count]
    slopes = {name: mx.array(columns([*own], chosen)) for name, own in found.items()}
    return _program(tracer, shape, "R d V_A V_B", **slopes)


@cache
def state_rates(shape: InteractionClass) -> Program:
    """``(R, d, V_A, V_B, numbers, start, h) -> (rate)``: of its states, the mean over h from ``start``."""
    tracer, inputs = _inputs(shape, STATE)
    return _program(tracer, shape, STATE, rate=mx.array(_mean_rates(tracer, shape, inputs)))


STATE = "R d V_A V_B start h"


def _mean_rates(tracer: Tracer, shape: InteractionClass, inputs: dict[str, Array]) -> list:
    (h,), numbers = inputs["h"], list(inputs["numbers"])
    found = zip(shape.rates(tracer, _relative(inputs), numbers), inputs["start"], strict=True)
    return [(one.gain - one.decay * z) / (1.0 + h * one.decay) for one, z in found]


@cache
def slopes(shape: InteractionClass) -> Program:
    """``(R, d, V_A, V_B, numbers) -> (by_pose, by_twist)``: the derivatives of both wrenches, (12, 12) row by row.

    Columns: turn and shift of the first tip in its own axes, then of the second; and the twists of both.
    """
    tracer, inputs = _inputs(shape, "R d V_A V_B")
    found = np.concatenate(list(_wrenches(tracer, shape, inputs).values()))
    changes = pose_changes(inputs["R"].reshape(3, 3), inputs["d"])
    by_pose = mx.array([tangents([*found], seed) for seed in changes]).T
    by_twist = mx.array(columns([*found], [*inputs["V_A"], *inputs["V_B"]])).T
    return _program(tracer, shape, "R d V_A V_B", by_pose=by_pose, by_twist=by_twist)


def _wrenches(tracer: Tracer, shape: InteractionClass, inputs: dict[str, Array]) -> dict[str, Array]:
    x = _relative(inputs)
    found = shape.wrench(tracer, x, list(inputs["numbers"]))
    torque, force = mx.array(list(found.torque)), mx.array(list(found.force))
    first = -np.concatenate([torque + mx.cross(x.d, force), force])
    return {"first": first, "second": mx.rotate_wrench(x.R.T, np.concatenate([torque, force]))}


def _relative(inputs: dict[str, Array]) -> Relative:
    """How the second tip lies and moves as seen from the first."""
    R, d, (V_A, V_B) = inputs["R"].reshape(3, 3), inputs["d"], (inputs["V_A"], inputs["V_B"])
    at_second = mx.rotate_wrench(R, V_B)
    v = at_second[3:] - V_A[3:] - mx.cross(V_A[:3], d)
    return Relative(d, R, v, at_second[:3] - V_A[:3])


SIZES = {"R": 9, "d": 3, "V_A": 6, "V_B": 6}


def _sizes(shape: InteractionClass, names: str) -> dict[str, int]:
    sizes = SIZES | {"start": len(shape.states), "h": 1}
    return {name: sizes[name] for name in names.split()} | {"numbers": shape.size}


def _inputs(shape: InteractionClass, names: str) -> tuple[Tracer, dict[str, Array]]:
    tracer, sizes = Tracer(), _sizes(shape, names)
    return tracer, {name: mx.array(tracer.input(name, size), (size,)) for name, size in sizes.items()}


def _program(tracer: Tracer, shape: InteractionClass, names: str, **outputs: Array) -> Program:
    sizes = _sizes(shape, names)
    return tracer.program(shape.kind.KIND, sizes, {name: list(x.flat) for name, x in outputs.items()})
