"""From a block's sympy components to nodes of a program."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
import sympy as sp

from ..algebra.functions import stumpff
from ..derive.block import Binding, Block, Step
from .program import Array, Tracer, Value, give_label


def lower(
    block: Block,
    inputs: Mapping[str, Array],
    outputs: Sequence[str],
    tracer: Tracer,
    constant: Callable[[str], Value] | None = None,
) -> dict[str, Array]:
    """Record the steps of ``block`` that ``outputs`` need and return the outputs' entries.

    ``inputs`` holds arrays of nodes or floats for the block's inputs (others are passed over).  With
    ``constant``, whatever follows from the parameters alone is not recorded but asked for by its label:
    that slice of the block is the ``prepare`` program.
    """
    values: dict[sp.Symbol, Value] = {}
    for name, array in inputs.items():
        if name not in block.inputs:
            continue
        for symbol, value in zip(block.values[name].flat, np.asarray(array, dtype=object).flat, strict=True):
            values[symbol] = value
    known = _Environment(block, values, constant)
    for step in needed(block, outputs, values, constant is not None):
        with tracer.section(title(step)):
            for symbol, expression in step.assignments:
                value = translate(expression, known, tracer)
                give_label(value, symbol.name)
                values[symbol] = value
    return {name: _array(block.values[name], known, tracer) for name in outputs}


def title(step: Step) -> str:
    """What a section says of its step."""
    number = f" ({step.equation})" if step.equation else ""
    return f"{step.signal.name}: {step.signal.meaning}{number}"


def needed(block: Block, outputs: Sequence[str], given: Mapping, sliced: bool) -> list[Step]:
    """The steps that ``outputs`` depend on, in their order; with ``sliced`` only those of the state."""
    wanted = {s for name in outputs for entry in block.values[name].flat for s in entry.free_symbols}
    kept = []
    for step in reversed(block.steps.values()):
        if sliced and step.signal.binding <= Binding.PARAMETER:
            continue
        made = {symbol for symbol, _ in step.assignments} - given.keys()
        if made & wanted:
            kept.append(step)
            wanted |= {s for symbol, e in step.assignments if symbol in wanted for s in e.free_symbols}
    return kept[::-1]


class _Environment(dict):
    """Values of symbols; parameter-level ones are fetched on demand as named constants."""

    def __init__(self, block: Block, values: dict, constant: Callable[[str], Value] | None):
        super().__init__()
        self.block, self.values_, self.constant = block, values, constant

    def __missing__(self, symbol: sp.Symbol) -> Value:
        if symbol in self.values_:
            return self.values_[symbol]
        if self.constant is not None and self.block.bindings[symbol] <= Binding.PARAMETER:
            return self.constant(symbol.name)
        raise KeyError(f"block {self.block.name}: no value for {symbol}")


def _array(entries: Array, known: Mapping, tracer: Tracer) -> Array:
    out = np.empty(entries.shape, dtype=object)
    for index, entry in np.ndenumerate(entries):
        out[index] = translate(entry, known, tracer)
    return out


def translate(e: sp.Expr, known: Mapping, tracer: Tracer) -> Value:
    """One sympy expression as nodes, grouped as it is written."""
    inner = lambda x: translate(x, known, tracer)  # noqa: E731
    if e.is_Symbol:
        return known[e]
    if e.is_Number or e.is_NumberSymbol:
        return float(e)
    if e.is_Add:
        return _sum(e, inner)
    if e.is_Mul:
        return _product(e, inner)
    if e.is_Pow:
        return _power(inner(e.base), e.exp, tracer)
    if isinstance(e, stumpff):
        return _stumpff(int(e.args[0]), inner(e.args[1]), tracer)
    if isinstance(e, sp.sin | sp.cos):
        return tracer.call(type(e).__name__, inner(e.args[0]))
    raise TypeError(f"cannot lower {e}")


def _sum(e: sp.Add, inner: Callable) -> Value:
    """Positive terms first, so that a sum need not begin with a sign."""
    terms = sorted(e.args, key=lambda t: t.could_extract_minus_sign())
    total = inner(terms[0])
    for term in terms[1:]:
        total = total - inner(-term) if term.could_extract_minus_sign() else total + inner(term)
    return total


def _product(e: sp.Mul, inner: Callable) -> Value:
    coefficient, rest = e.as_coeff_Mul()
    below = [f for f in rest.as_ordered_factors() if f.is_Pow and f.exp.is_number and f.exp.is_negative]
    above = [f for f in rest.as_ordered_factors() if f not in below]
    total: Value = float(coefficient)
    for factor in above:
        total = total * inner(factor)
    for factor in below:
        total = total / inner(1 / factor)
    return total


def _power(base: Value, exponent: sp.Expr, tracer: Tracer) -> Value:
    if exponent == sp.Rational(1, 2):
        return tracer.call("sqrt", base)
    if not exponent.is_Integer:
        raise TypeError(f"cannot lower the power {exponent}")
    power = base
    for _ in range(abs(int(exponent)) - 1):
        power = power * base
    return 1.0 / power if exponent < 0 else power


def _stumpff(order: int, x: Value, tracer: Tracer) -> Value:
    """``c_k`` from the primitives ``c_4`` and ``c_5`` by ``c_k = 1/k! - x c_{k+2}``."""
    if order in (4, 5):
        return tracer.call(f"c{order}", x)
    if order > 5:
        raise ValueError(f"no primitive for the Stumpff function of order {order}")
    return float(1 / sp.factorial(order)) - x * _stumpff(order + 2, x, tracer)
