"""Differentiation of traced operations, forward and in reverse, recorded by the same tracer."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import AbstractContextManager, nullcontext
from itertools import groupby

from .program import Node, Value, Vector, live

Slopes = dict[int, Value]


def tangents(values: Vector, seeds: Mapping[Node, Value]) -> list[Value]:
    """The directional derivative of every value; ``seeds`` maps nodes to their components of the direction.

    A seed is an independent variable, whatever it was computed from.  Inputs that are no seeds are constant, as are
    floats.  Equal operations are one node, so directions share common operations.
    """
    slopes: Slopes = {node.id: slope for node, slope in seeds.items()}
    computed = (node for node in live(values) if node.op not in ("input", "epsilon") and node.id not in slopes)
    for _, same in groupby(computed, lambda node: node.called):
        nodes = list(same)
        with _slopes_of(nodes[0]):
            for node in nodes:
                slopes[node.id] = _slope(node, slopes)
    return [_of(v, slopes) for v in values]


def _slopes_of(node: Node) -> AbstractContextManager[None]:
    """Where the slopes of a routine are recorded: they recur as its operations do."""
    routine, _ = node.called
    return node.tracer.routine(f"{routine}_slope") if routine else nullcontext()


def columns(values: Vector, variables: Vector) -> list[list[Value]]:
    """The partial derivatives of ``values``, one column per variable; floats are constant."""
    unit = lambda x: {x: 1.0} if isinstance(x, Node) else {}  # noqa: E731
    return [tangents(values, unit(x)) for x in variables]


def gradients(values: Vector, weights: Vector, variables: Vector) -> list[Value]:
    """The derivatives of ``sum(weights * values)`` with every one of ``variables``, in reverse mode.

    A variable is independent, whatever it was computed from.  Weights are no functions of the variables.
    """
    found: Slopes = {}
    ends = {x.id for x in variables if isinstance(x, Node)}
    for value, weight in zip(values, weights, strict=True):
        _add(found, value, weight)
    for node in reversed(live(values)):
        if node.id in ends or node.op in ("input", "epsilon") or _zero(_of_found(found, node)):
            continue
        for arg, share in _shares(node, found[node.id]):
            _add(found, arg, share)
    return [_of_found(found, x) for x in variables]


def _shares(node: Node, weight: Value) -> list[tuple[Value, Value]]:
    """The operands of an operation, and the weight of each that follows from the weight of the result."""
    a = node.args[0]
    if len(node.args) == 1:
        return [(a, _unary(node, a, weight))]
    b = node.args[1]
    if node.op in ("add", "sub"):
        return [(a, weight), (b, weight if node.op == "add" else -weight)]
    if node.op == "mul":
        return [(x, weight * y) for x, y in ((a, b), (b, a)) if isinstance(x, Node)]
    if node.op == "atan2":
        share = weight / (a * a + b * b)
        return [(a, share * b), (b, -(share * a))]
    quotient = weight / b
    return [(a, quotient), (b, -(quotient * node))]


def _add(found: Slopes, value: Value, weight: Value) -> None:
    if isinstance(value, Node):
        found[value.id] = found[value.id] + weight if value.id in found else weight


def _of_found(found: Slopes, value: Value) -> Value:
    return found.get(value.id, 0.0) if isinstance(value, Node) else 0.0


def _of(value: Value, slopes: Slopes) -> Value:
    return slopes.get(value.id, 0.0) if isinstance(value, Node) else 0.0


def _slope(node: Node, slopes: Slopes) -> Value:
    a, da = node.args[0], _of(node.args[0], slopes)
    if len(node.args) == 1:
        return 0.0 if _zero(da) else _unary(node, a, da)
    b, db = node.args[1], _of(node.args[1], slopes)
    if node.op == "add":
        return da + db
    if node.op == "sub":
        return da - db
    if node.op == "mul":
        return 2.0 * a * da if a is b else da * b + a * db
    if _zero(da) and _zero(db):
        return 0.0
    return (b * da - a * db) / (a * a + b * b) if node.op == "atan2" else (da - node * db) / b


def _unary(node: Node, a: Node, da: Value) -> Value:
    call = node.tracer.call
    if node.op == "neg":
        return -da
    if node.op == "on":
        return 0.0
    if node.op == "sqrt":
        return da / (2.0 * node)
    if node.op == "exp":
        return node * da
    if node.op == "sin":
        return call("cos", a) * da
    if node.op == "cos":
        return -(call("sin", a) * da)
    if node.op.startswith("c") and node.op[1:].isdigit():
        k = int(node.op[1:])
        return stumpff_slope(k, call(f"c{k + 1}", a), call(f"c{k + 2}", a)) * da
    raise TypeError(f"no derivative of {node.op}")


def stumpff_slope(k: int, following: Value, second: Value) -> Value:
    """``c_k' = (k c_(k+2) - c_(k+1)) / 2``."""
    return 0.5 * k * second - 0.5 * following


def _zero(value: Value) -> bool:
    return not isinstance(value, Node) and value == 0.0
