"""The functions of a robot that its sensors are: each follows from the row of its measurement.

An example: a gyroscope. Its row says the lines that compute what it reads, of q and v, three entries at every marker
and their unit, and how it is `told`. The function has that name, result and program. Where a row reads accelerations
they are those of the forward dynamics, so the function is one of torques and wrenches.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

from ..errors import UsageError
from ..ir.program import Value
from . import fused
from .functions import FORWARD, Functions
from .measurement import AtMarkers, Measurement, Told
from .robot_function import SENSORS, RobotFunction
from .sensors import ALL
from .signals import Signal

DYNAMIC = "q v tau w_ext"
"""The inputs where accelerations count."""


@cache
def function_of(row: Measurement) -> RobotFunction:
    """The function of a row that is told."""
    told = row.told
    assert told is not None
    if row.group > 1 or any(not number.stated for number in row.numbers):
        what = "an attitude" if row.group > 1 else "one whose numbers follow from parameters"
        raise UsageError(f"{row.name}: is {what}, which is no function of the robot; leave 'told' out")
    if told.c_file != SENSORS and isinstance(row.labels, AtMarkers):
        raise UsageError(f"{row.name}: what sits at markers is computed when it is asked for; leave 'c_file' out")
    accelerates = "vdot" in row.inputs.split()
    inputs = DYNAMIC if accelerates else row.inputs
    algorithms = (FORWARD,) * accelerates + row.algorithms

    def body(f: Functions, **x: Sequence[Value]) -> fused.Outputs:
        given: dict[str, Any] = {n.keyword: n.starts(f.chain) for n in row.numbers}
        if accelerates:
            falling = f.falling(x["tau"])
            x["vdot"] = f.forward_dynamics(*(x[name] for name in DYNAMIC.split()))[0]
            f = falling
        return {told.result: row.value(f, **given, **{name: x[name] for name in row.inputs.split()})}

    program = fused.program(inputs, row.name, algorithms=tuple(dict.fromkeys((*ALL, *algorithms))))(body)
    return RobotFunction(
        row.name,
        inputs,
        {told.result: _signal(row, told)},
        program,
        algorithms,
        told.about,
        offered=told.offered or row.offered,
        c_file=told.c_file,
        sensor=True,
    )


def _signal(row: Measurement, told: Told) -> Signal:
    """Shape, unit, frame and meaning of the result, and what its entries are called."""
    if not isinstance(row.labels, AtMarkers):
        return Signal(told.shape, row.unit, told.frame, told.meaning)
    parts = row.labels.parts
    return Signal(("NMARKERS", *(len(parts),) * bool(parts)), row.unit, told.frame, told.meaning, parts=parts)


@cache
def own_function(row: Measurement) -> RobotFunction:
    """The function of a sensor that a `Robot` of Python holds."""
    if row.told is not None and row.told.c_file != SENSORS:
        raise UsageError(f"{row.name}: what runs report at every sample is the product's own; leave 'c_file' out")
    return function_of(row)
