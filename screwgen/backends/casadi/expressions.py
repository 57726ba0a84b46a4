"""Programs on SX."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, partial
from math import factorial

import casadi as ca

from ...ir.program import Program
from ...ir.replay import run

LIMIT = 4.0
TERMS = 14
BINARY = {
    op: partial(ca.SX.binary, code)
    for op, code in {"add": ca.OP_ADD, "sub": ca.OP_SUB, "mul": ca.OP_MUL, "div": ca.OP_DIV}.items()
}
"""What the operators of SX do, in a sixth of their time: they try conversions to other types first."""


def expressions(program: Program, given: Mapping[str, ca.SX]) -> dict[str, ca.SX]:
    """The outputs of a program as columns of SX."""
    inputs = {name: ca.vertsplit(ca.vec(given[name])) if size else [] for name, size in program.inputs.items()}
    outputs, _ = run(program, inputs, functions, literal=cache(ca.SX), binary=BINARY)
    return {name: ca.vertcat(ca.SX(0, 1), *values) for name, values in outputs.items()}


def functions(op: str, x: ca.SX, *more: ca.SX) -> ca.SX:
    """The primitives in SX."""
    if op == "neg":
        return -x
    if op == "on":
        return x > 0
    if op[0] == "c" and op[1:].isdigit():
        return _stumpff(int(op[1]), x)
    return getattr(ca, op)(x, *more)


def _stumpff(order: int, x: ca.SX) -> ca.SX:
    """The series below the limit, sine and cosine above; each branch is regular in the range of the other."""
    large = x >= LIMIT
    far = ca.if_else(large, x, LIMIT)
    s = ca.sqrt(far)
    if order > 5:
        closed = (1 / factorial(order - 2) - _stumpff(order - 2, far)) / far
    else:
        closed = (ca.cos(s) - 1 + far / 2) / far**2 if order == 4 else (ca.sin(s) - s + s * far / 6) / (far**2 * s)
    near = ca.if_else(large, 0, x)
    series = ca.SX(1)
    for j in reversed(range(1, TERMS)):
        series = 1 - near / ((order + 2 * j - 1) * (order + 2 * j)) * series
    return ca.if_else(large, closed, series / factorial(order))
