"""Blocks: named steps of matrix equations, with unit, frame and meaning.

A :class:`Block` is a list of named steps.  Each step is *one* matrix expression over the block's
inputs and earlier steps; its components, its LaTeX and its code all come from that expression.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import IntEnum
from functools import cached_property
from typing import Any

import numpy as np

from ..algebra.components import Array, components
from ..algebra.expression import Expression, Symbol
from ..algebra.notation import latex
from ..lazily import sp
from ..notebook import code, formula, plain, steps_table
from .names import Label, component
from .quantities import QUANTITIES, Quantity, described


class Binding(IntEnum):
    """When a quantity is known: at generation, on a change of parameters, or in every call."""

    CONSTANT = 0
    PARAMETER = 1
    STATE = 2


@dataclass(frozen=True)
class NamedSignal:
    """A named quantity: shape, unit, frame of its components, and how the paper writes it."""

    name: str
    shape: tuple[int, int]
    display: str
    unit: str
    frame: str
    meaning: str
    binding: Binding = Binding.STATE
    numbered: tuple[int, ...] = ()

    def labels(self) -> Iterator[tuple[tuple[int, int], str]]:
        """The index of every entry with its label: ``S_x``, ``J_xy``, ``eta_2``."""
        for index in np.ndindex(*self.shape):
            yield index, self.name + self.suffix(index)

    def label(self, index: tuple[int, int]) -> Label:
        """The name of an entry in generated code."""
        return Label(self.name, component(self.unit, index[0]) if self.shape == (6, 1) else self.suffix(index)[1:])

    def suffix(self, index: tuple[int, int]) -> str:
        """The suffix of an entry's label: letters along the axes of a frame, numbers elsewhere.

        Quantities without a frame, and the dimensions named in ``numbered``, are numbered.
        """
        parts = []
        for dimension, (i, n) in enumerate(zip(index, self.shape, strict=True)):
            spatial = n == 3 and self.frame != "-" and dimension not in self.numbered
            if n != 1 or dimension in self.numbered:
                parts.append("xyz"[i] if spatial else str(i + 1))
        separator = "_" if any(n > 9 for n in self.shape) else ""
        return "_" + separator.join(parts) if parts else ""


@dataclass(frozen=True)
class Step:
    """One equation: ``signal = expression``, with its number in the paper.

    ``assignments`` are its components: pairs of a fresh symbol and a sympy expression over the
    symbols of inputs and earlier steps.  Entries that are numbers or earlier symbols need none.
    """

    signal: NamedSignal
    expression: Expression
    equation: str
    assignments: tuple[tuple[sp.Symbol, sp.Expr], ...]

    @cached_property
    def labels(self) -> dict[str, Label]:
        """The names in generated code of the symbols that the step may define."""
        return {text: self.signal.label(index) for index, text in self.signal.labels()}

    @cached_property
    def uses(self) -> dict[str, set[str]]:
        """The names of the symbols that the step defines, each with the names of the symbols that it depends on."""
        return {symbol.name: {s.name for s in e.free_symbols} for symbol, e in self.assignments}

    @property
    def equation_latex(self) -> str:
        """The step as one equation in LaTeX."""
        s = self.signal
        return f"{latex(Symbol(s.name, s.shape, s.display))} = {latex(self.expression)}"

    def __repr__(self) -> str:
        s = self.signal
        numbered = f", ({self.equation}) of the paper" if self.equation else ""
        return f"<Step {s.name}: {s.meaning}, {s.shape[0]} x {s.shape[1]}, unit {s.unit}, frame {s.frame}{numbered}>"

    def _repr_latex_(self) -> str:
        return formula(self.equation_latex)


@dataclass
class Block:
    """A named list of steps over named inputs; ``values`` holds the entries of every signal."""

    name: str
    title: str
    inputs: dict[str, NamedSignal] = field(default_factory=dict)
    steps: dict[str, Step] = field(default_factory=dict)
    values: dict[str, Array] = field(default_factory=dict)
    bindings: dict[sp.Symbol, Binding] = field(default_factory=dict)
    along: dict[str, NamedSignal] = field(default_factory=dict)
    """What varies along the link and is listed in documents."""

    def input(
        self, name: str, shape: tuple[int, int], *words: str, binding: Binding = Binding.STATE, **named: Any
    ) -> Symbol:
        """Declare an input and return the symbol that stands for it.

        ``words`` (display, unit, frame, meaning) and ``numbered`` replace those of the table of quantities.
        """
        given = dict(zip(("display", "unit", "frame", "meaning"), words, strict=False)) | named
        signal = _signal(name, shape, described(self.name, name, given), binding)
        self.inputs[name] = signal
        self.values[name] = np.empty(shape, dtype=object)
        for index, label in signal.labels():
            self.values[name][index] = sp.Symbol(label, real=True)
            self.bindings[self.values[name][index]] = binding
        return Symbol(name, shape, signal.display)

    def parameter(self, name: str, shape: tuple[int, int], *words: str, **named: Any) -> Symbol:
        """Declare an input that is known before the state."""
        return self.input(name, shape, *words, binding=Binding.PARAMETER, **named)

    def entries(self, symbol: Symbol) -> list[Symbol]:
        """The entries of a column as 1 x 1 symbols that share its values."""
        out = []
        for i, value in enumerate(self.values[symbol.name][:, 0]):
            alias = Symbol(f"{symbol.name}[{i}]", (1, 1), rf"{{{symbol.display}}}_{{{i + 1}}}")
            self.values[alias.name] = np.array([[value]], dtype=object)
            out.append(alias)
        return out

    def field(self, name: str, values: Array, display: str | None = None, **words: Any) -> Symbol:
        """A quantity that varies along the link and occurs only under an integral.

        Its words are those of the table of quantities or given; without them documents do not list it. A symbol of
        ``values`` that the block does not know is one that parameters determine at a given place.
        """
        self.values[name] = values
        known = f"{self.name}.{name}" in QUANTITIES or name in QUANTITIES or "meaning" in words
        if not known:
            return Symbol(name, values.shape, display or name)
        symbols = set().union(*(sp.sympify(entry).free_symbols for entry in values.flat))
        binding = max((self.bindings.get(s, Binding.PARAMETER) for s in symbols), default=Binding.CONSTANT)
        quantity = described(self.name, name, {"display": display, **words})
        self.along[name] = _signal(name, values.shape, quantity, binding)
        return Symbol(name, values.shape, quantity.display)

    def generators(self, name: str) -> Symbol:
        """A field of three generators of its own, which depends on the state."""
        symbols = sp.symbols(f"{name}_x:z", real=True)
        self.bindings.update(dict.fromkeys(symbols, Binding.STATE))
        return self.field(name, np.array([[symbol] for symbol in symbols], dtype=object))

    def step(
        self, name: str, expression: Expression, display: str | None = None, *, symmetric: bool = False, **words: Any
    ) -> Symbol:
        """Append ``name = expression`` and return the symbol of the new quantity.

        ``words`` (unit, frame, equation, meaning, numbered) replace those of the table of quantities.
        """
        if name in self.values:
            raise ValueError(f"block {self.name}: {name} is defined twice")
        raw = components(expression, self.values)
        quantity = described(self.name, name, {"display": display, **words})
        signal = _signal(name, expression.shape, quantity, self._binding(raw))
        values, assignments = self._name(signal, raw, symmetric)
        self.bindings.update((symbol, signal.binding) for symbol, _ in assignments)
        self.values[name] = values
        self.steps[name] = Step(signal, expression, quantity.equation, assignments)
        return Symbol(name, expression.shape, quantity.display)

    def __repr__(self) -> str:
        return f"<Block {self.name}: {self.title}, {len(self.inputs)} inputs, {len(self.steps)} steps>"

    def _repr_markdown_(self) -> str:
        """Its steps with formula, meaning, unit, frame and number in the paper."""
        pairs = ((step, step.signal) for step in self.steps.values())
        rows = [(s.name, step.equation_latex, s.unit, s.frame, s.meaning, step.equation) for step, s in pairs]
        return f"**{plain(self.title)}**: block {code(self.name)}\n\n{steps_table(rows)}"

    def symbol(self, name: str) -> Symbol:
        """The symbol of an earlier signal."""
        signal = self.signal(name)
        return Symbol(name, signal.shape, signal.display)

    def signal(self, name: str) -> NamedSignal:
        return self.inputs[name] if name in self.inputs else self.steps[name].signal

    def _binding(self, raw: Array) -> Binding:
        """The latest binding time among the dependences of the entries."""
        symbols = set().union(*(entry.free_symbols for entry in raw.flat)) if raw.size else set()
        return max((self.bindings[s] for s in symbols), default=Binding.CONSTANT)

    def _name(
        self, signal: NamedSignal, raw: Array, symmetric: bool
    ) -> tuple[Array, tuple[tuple[sp.Symbol, sp.Expr], ...]]:
        """Give every entry that is not a number or a plain symbol a symbol of its own."""
        values, assignments = np.empty(raw.shape, dtype=object), []
        for (i, j), label in signal.labels():
            entry = raw[j, i] if symmetric and j < i else raw[i, j]
            if symmetric and j < i:
                values[i, j] = values[j, i]
            elif entry.is_Number or entry.is_Symbol or _negated(entry):
                values[i, j] = entry
            else:
                values[i, j] = sp.Symbol(label, real=True)
                assignments.append((values[i, j], entry))
        return values, tuple(assignments)


def _signal(name: str, shape: tuple[int, int], q: Quantity, binding: Binding) -> NamedSignal:
    return NamedSignal(name, shape, q.display, q.unit, q.frame, q.meaning, binding, q.numbered)


def _negated(entry: sp.Expr) -> bool:
    """Whether an entry is the negative of a symbol."""
    return entry.is_Mul and len(entry.args) == 2 and entry.args[0] is sp.S.NegativeOne and entry.args[1].is_Symbol
