"""Evaluation of programs: on values of any algebra, into another tracer, or with some inputs bound to numbers."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .names import Label, OperationGroup
from .program import Node, Program, Tracer, Value, give_label

BINARY: dict[str, Callable] = {"add": operator.add, "sub": operator.sub, "mul": operator.mul, "div": operator.truediv}


def run(
    program: Program,
    inputs: Mapping[str, list],
    functions: Callable[..., Any],
    epsilon: float = 0.0,
    literal: Callable[[float], Any] = lambda x: x,
    binary: Mapping[str, Callable] = BINARY,
) -> tuple[dict[str, list], list]:
    """Evaluate a program on values of any algebra: floats, mpmath numbers, casadi.SX, nodes of a tracer.

    ``functions(op, *values)`` evaluates ``neg`` and the ``FUNCTIONS``, ``binary`` has the other operations by name;
    ``literal`` makes a value of a number that stands in the program.  Returns the outputs and the values of the guards.
    """
    values: dict[int, object] = {}
    pick = lambda v: values[v.id] if isinstance(v, Node) else literal(v)  # noqa: E731
    for node in program.nodes:
        op, args = node.op, node.args
        if op in binary:
            a, b = args
            first = values[a.id] if type(a) is Node else literal(a)
            values[node.id] = binary[op](first, values[b.id] if type(b) is Node else literal(b))
        elif op == "input":
            values[node.id] = inputs[args[0]][args[1]]
        else:
            values[node.id] = epsilon if op == "epsilon" else functions(op, *map(pick, args))
    return {n: [pick(v) for v in entries] for n, entries in program.outputs.items()}, [pick(g) for g in program.guards]


def inline(
    program: Program, inputs: Mapping[str, list[Value]], tracer: Tracer, link: str = "", origin: int = 0
) -> dict[str, list[Value]]:
    """Replay a program into a tracer: the fused layout.

    ``link`` is added to labels and section titles; ``origin`` is the number of the link that a failing guard reports.
    """
    start = len(tracer.sections)
    section = {i: start + i for i in range(len(program.sections))}
    for title, routine, call in program.sections:
        named = f"{link}, {title}" if link and title else title
        tracer.sections.append(OperationGroup(named, routine, f"{call}.{start}" if call else ""))
    binary = {op: getattr(tracer, op) for op in BINARY}
    values: dict[int, Value] = {}
    pick = lambda v: values[v.id] if type(v) is Node else v  # noqa: E731
    before = tracer._section
    for node in program.nodes:
        tracer._section, op, args = section[node.section], node.op, node.args
        if op in binary:
            a, b = args
            first = values[a.id] if type(a) is Node else a
            value = binary[op](first, values[b.id] if type(b) is Node else b)
        elif op == "input":
            value = inputs[args[0]][args[1]]
        else:
            value = tracer.epsilon() if op == "epsilon" else _function(op, tracer, *map(pick, args))
        values[node.id] = value
        if (label := node.label) is not None and type(value) is Node:
            given = Label(label.quantity, label.place, link, label.negative) if link and link != label.link else label
            give_label(value, given)
    tracer._section = before
    for g in program.guards:
        tracer.guard(pick(g), origin)
    return {name: [pick(v) for v in entries] for name, entries in program.outputs.items()}


def _function(op: str, tracer: Tracer, a: Value, *more: Value) -> Value:
    return tracer.neg(a) if op == "neg" else tracer.call(op, a, *more)


def bind(program: Program, known: Mapping[str, Sequence[float | None]]) -> Program:
    """The program with some entries of its inputs bound to numbers; None leaves an entry as it is."""
    tracer = Tracer()
    given = {}
    for name, size in program.inputs.items():
        symbols = tracer.input(name, size)
        given[name] = [x if v is None else v for x, v in zip(symbols, known.get(name, [None] * size), strict=True)]
    outputs = inline(program, given, tracer)
    left = {n: size for n, size in program.inputs.items() if n not in known or None in known[n]}
    return tracer.program(program.name, left, outputs)
