"""Reverse-mode differentiation of a program: its adjoint, which is a program again."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from itertools import islice

from .derivative import gradients
from .program import Program, Tracer, Value
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
    inputs: dict[str, list[Value]] = {name: [*nodes] for name, nodes in given.items()}
    sizes = {SEED + name: len(entries) for name, entries in program.outputs.items()}
    seeds = {name: tracer.input(name, size) for name, size in sizes.items()}
    outputs = inline(replace(program, guards=[], origins=[]), inputs, tracer)
    values = [x for entries in outputs.values() for x in entries]
    weights = [x for name in outputs for x in seeds[SEED + name]]
    names = [name for name in program.inputs if name in wanted]
    slopes = iter(gradients(values, weights, [x for name in names for x in given[name]]))
    found = {GRADIENT + name: list(islice(slopes, program.inputs[name])) for name in names}
    return tracer.program(f"adjoint of {program.name}", program.inputs | sizes, found)
