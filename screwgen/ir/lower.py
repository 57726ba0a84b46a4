"""Lowering: from a block's sympy components to the nodes of a program."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache

import numpy as np

from ..lazily import sp
from .block import Binding, Block, Step
from .program import Array, Tracer, Value, Vector, give_label


def lower(
    block: Block,
    inputs: Mapping[str, Vector],
    outputs: Sequence[str],
    tracer: Tracer,
    constant: Callable[[str], Value] | None = None,
) -> dict[str, Array]:
    """Record the steps of ``block`` that ``outputs`` need and return the outputs' entries.

    ``inputs`` holds arrays of nodes or floats for the block's inputs (others are ignored).  With ``constant``, values
    that depend on parameters alone are not recorded but requested by their labels: the ``prepare`` program computes
    them.
    """
    known = _Known(block, constant)
    for name, array in inputs.items():
        if name not in block.inputs:
            continue
        for symbol, value in zip(block.values[name].flat, np.asarray(array, dtype=object).flat, strict=True):
            known[symbol.name] = value
    for step in needed(block, outputs, known, constant is not None):
        with tracer.section(title(step)):
            for symbol, expression in step.assignments:
                value = recipe(expression)(known, tracer)
                give_label(value, step.labels[symbol.name])
                known[symbol.name] = value
    return {name: _array(block.values[name], known, tracer) for name in outputs}


def title(step: Step) -> str:
    """The title of a step's section."""
    number = f" ({step.equation})" if step.equation else ""
    return f"{step.signal.name}: {step.signal.meaning}{number}"


def needed(block: Block, outputs: Sequence[str], given: Mapping, sliced: bool) -> list[Step]:
    """The steps that ``outputs`` depend on, whole and in order; with ``sliced`` those alone that depend on the state.

    ``given`` holds the names of the symbols that need no step.
    """
    wanted = {s.name for name in outputs for entry in block.values[name].flat for s in entry.free_symbols}
    kept = []
    for step in reversed(block.steps.values()):
        if sliced and step.signal.binding <= Binding.PARAMETER:
            continue
        if any(name in wanted and name not in given for name in step.uses):
            kept.append(step)
            wanted.update(*step.uses.values())
    return kept[::-1]


class _Known(dict):
    """Values by the names of symbols; parameter-level ones are fetched on demand as named constants."""

    def __init__(self, block: Block, constant: Callable[[str], Value] | None):
        super().__init__()
        self.block, self.constant = block, constant

    def __missing__(self, name: str) -> Value:
        if self.constant is not None and self.block.bindings[sp.Symbol(name, real=True)] <= Binding.PARAMETER:
            return self.constant(name)
        raise KeyError(f"block {self.block.name}: no value for {name}")


def _array(entries: Array, known: Mapping, tracer: Tracer) -> Array:
    out = np.empty(entries.shape, dtype=object)
    for index, entry in np.ndenumerate(entries):
        out[index] = recipe(entry)(known, tracer)
    return out


# ------------------------------------------------------------------------------ one expression

Recipe = Callable[[Mapping[str, Value], Tracer], Value]
"""Records an expression: takes the values of its symbols by name, and the tracer."""


@cache
def recipe(e: sp.Expr) -> Recipe:
    """A function that records a sympy expression as nodes, in its grouping; cached, so an expression is read once."""
    if e.is_Symbol:
        name = e.name
        return lambda known, _: known[name]
    if e.is_Number or e.is_NumberSymbol:
        number = float(e)
        return lambda *_: number
    if e.is_Add:
        return _sum(e)
    if e.is_Mul:
        return _product(e)
    if e.is_Pow:
        return _power(recipe(e.base), e.exp)
    from ..algebra.stumpff import stumpff  # a class of sympy's, which is not imported before it is used

    if isinstance(e, stumpff):
        order, argument = int(e.args[0]), recipe(e.args[1])
        return lambda known, tracer: _stumpff(order, argument(known, tracer), tracer)
    if isinstance(e, sp.sin | sp.cos):
        function, angle = type(e).__name__, recipe(e.args[0])
        return lambda known, tracer: tracer.call(function, angle(known, tracer))
    if isinstance(e, sp.atan2):
        y, x = map(recipe, e.args)
        return lambda known, tracer: tracer.call("atan2", y(known, tracer), x(known, tracer))
    raise TypeError(f"cannot lower {e}")


def _sum(e: sp.Add) -> Recipe:
    """Positive terms first, so that a sum need not begin with a sign."""
    signed = [(t.could_extract_minus_sign(), t) for t in e.args]
    (_, leading), *others = sorted(signed, key=lambda pair: pair[0])
    first, rest = recipe(leading), [(minus, recipe(-t if minus else t)) for minus, t in others]

    def record(known: Mapping[str, Value], tracer: Tracer) -> Value:
        total = first(known, tracer)
        for minus, term in rest:
            value = term(known, tracer)
            total = total - value if minus else total + value
        return total

    return record


def _product(e: sp.Mul) -> Recipe:
    coefficient, rest = e.as_coeff_Mul()
    ordered = rest.as_ordered_factors()
    below = [f for f in ordered if f.is_Pow and f.exp.is_number and f.exp.is_negative]
    number = float(coefficient)
    factors, divisors = [recipe(f) for f in ordered if f not in below], [recipe(1 / f) for f in below]

    def record(known: Mapping[str, Value], tracer: Tracer) -> Value:
        total: Value = number
        for factor in factors:
            total = total * factor(known, tracer)
        for divisor in divisors:
            total = total / divisor(known, tracer)
        return total

    return record


def _power(base: Recipe, exponent: sp.Expr) -> Recipe:
    if exponent == sp.Rational(1, 2):
        return lambda known, tracer: tracer.call("sqrt", base(known, tracer))
    if not exponent.is_Integer:
        raise TypeError(f"cannot lower the power {exponent}")
    count, inverted = abs(int(exponent)), exponent < 0

    def record(known: Mapping[str, Value], tracer: Tracer) -> Value:
        power = value = base(known, tracer)
        for _ in range(count - 1):
            power = power * value
        return 1.0 / power if inverted else power

    return record


def _stumpff(order: int, x: Value, tracer: Tracer) -> Value:
    """``c_k`` from the primitives ``c_4`` and ``c_5`` by ``c_k = 1/k! - x c_{k+2}``."""
    if order in (4, 5):
        return tracer.call(f"c{order}", x)
    if order > 5:
        raise ValueError(f"no primitive for the Stumpff function of order {order}")
    return float(1 / sp.factorial(order)) - x * _stumpff(order + 2, x, tracer)
