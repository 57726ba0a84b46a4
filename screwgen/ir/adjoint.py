"""Reverse-mode differentiation of a program: its adjoint, which is a program again."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from .program import Node, Program, Tracer, Value
from .replay import inline

SEED, GRADIENT = "adjoint of ", "gradient of "
"""Before the names of outputs among the inputs of an adjoint, and of inputs among its outputs."""


def only(program: Program, outputs: Collection[str]) -> Program:
    """The program with some of its outputs, and its guards."""
    return replace(program, outputs={name: program.outputs[name] for name in outputs})


def adjoint(program: Program, wanted: Collection[str], of: Collection[str]) -> Program:
    """``(inputs, adjoints of some outputs) -> (gradients of the wanted inputs)``; guards are left out.

    ``gradient of x`` is the sum over these outputs of their adjoint times their derivative with ``x``.
    """
    program = only(program, of)
    tracer = Tracer()
    given = {name: tracer.input(name, size) for name, size in program.inputs.items()}
    values: dict[str, list[Value]] = {name: [*nodes] for name, nodes in given.items()}
    sizes = {SEED + name: len(entries) for name, entries in program.outputs.items()}
    seeds = {name: tracer.input(name, size) for name, size in sizes.items()}
    outputs = inline(replace(program, guards=[], origins=[]), values, tracer)
    sums: dict[int, Value] = {}
    for name, entries in outputs.items():
        for value, seed in zip(entries, seeds[SEED + name], strict=True):
            _give(sums, value, seed)
    _backward(tracer, outputs, sums, {x.id for name in wanted for x in given[name]})
    found = {GRADIENT + name: [sums.get(x.id, 0.0) for x in given[name]] for name in program.inputs if name in wanted}
    return tracer.program(f"adjoint of {program.name}", program.inputs | sizes, found)


def _backward(tracer: Tracer, outputs: Mapping[str, list[Value]], sums: dict[int, Value], wanted: set[int]) -> None:
    """Hand the adjoint of every value to its arguments, those on the way to a wanted input alone."""
    forward = Program("", {}, dict(outputs), [], []).nodes
    moving = set(wanted)
    for node in forward:
        if any(isinstance(a, Node) and a.id in moving for a in node.args):
            moving.add(node.id)
    for node in reversed(forward):
        bar = sums.get(node.id, 0.0)
        if node.op in ("input", "epsilon") or node.id not in moving or not isinstance(bar, Node):
            continue
        for argument, share in _shares(node, bar):
            if isinstance(argument, Node) and argument.id in moving:
                _give(sums, argument, share())


def _give(sums: dict[int, Value], to: Value, what: Value) -> None:
    if isinstance(to, Node):
        sums[to.id] = sums[to.id] + what if to.id in sums else what


def _shares(node: Node, bar: Node):
    """The arguments of an operation, and what makes the part of its adjoint that each gets."""
    a = node.args[0]
    if len(node.args) == 1:
        return [(a, lambda: bar * _slope(node, a))]
    b = node.args[1]
    if node.op == "add":
        return [(a, lambda: bar), (b, lambda: bar)]
    if node.op == "sub":
        return [(a, lambda: bar), (b, lambda: -bar)]
    if node.op == "mul":
        return [(a, lambda: bar * b), (b, lambda: bar * a)]
    return [(a, lambda: bar / b), (b, lambda: -(bar * node / b))]


def _slope(node: Node, a: Node) -> Value:
    """The derivative of a unary primitive; of the Stumpff functions ``c_k' = (k c_(k+2) - c_(k+1)) / 2``, any k."""
    call = node.tracer.call
    if node.op.startswith("c") and node.op[1:].isdigit():
        k = int(node.op[1:])
        return 0.5 * k * call(f"c{k + 2}", a) - 0.5 * call(f"c{k + 1}", a)
    slopes = {
        "neg": lambda: -1.0,
        "on": lambda: 0.0,
        "sqrt": lambda: 0.5 / node,
        "sin": lambda: call("cos", a),
        "cos": lambda: -call("sin", a),
    }
    return slopes[node.op]()
