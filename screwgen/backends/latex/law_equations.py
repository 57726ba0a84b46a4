"""The equations of a force between frames: those that its kind states, or what its program computes, entry by entry."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sp

from ...algebra.stumpff import stumpff
from ...interactions import FORCE, POTENTIAL, TORQUE, Equation, InteractionClass, Number, Relative
from ...ir.block import Binding
from .scalars import Scalars, subscripted
from .steps import DIGITS

RELATIVE = {
    "d": (r"\mathbf{d}_{AB}", (3,)),
    "R": (r"\mathbf{R}_{AB}", (3, 3)),
    "v": (r"\mathbf{v}_{AB}", (3,)),
    "omega": (r"\boldsymbol{\omega}_{AB}", (3,)),
}
"""The letters and sizes of how the second frame lies and moves as seen from the first."""
VALUE = "x"
"""The letter of values that a program names."""


def equations(shape: InteractionClass) -> tuple[Equation, ...]:
    """The equations in the order of evaluation."""
    return shape.equations or tuple(_Written(shape).quantities())


def symbols(one: Number) -> list[str]:
    """The symbol of a number, or those of its entries."""
    places = "xyz" if len(one.entries) == len("xyz") else [f"{k}" for k, _ in enumerate(one.entries, 1)]
    return [subscripted(one.symbol, place) for place in places] or [one.symbol]


def digits(e: sp.Expr) -> int:
    """How many digits the numbers of an expression need, so that none is lost."""
    floats = [float(x) for x in e.atoms(sp.Float)]
    return next(k for k in range(1, DIGITS + 1) if all(float(f"{x:.{k}g}") == x for x in floats))


class _SymbolTracer:
    """Records what a law names, over symbols; see :class:`...interactions.Interaction`."""

    def __init__(self) -> None:
        self.values: dict[tuple[str, sp.Expr], sp.Symbol] = {}

    def call(self, name: str, x: Any) -> sp.Expr:
        """A function of a program."""
        x = sp.sympify(x)
        if name == "on":
            return sp.Function(r"mathrm{H}")(x)
        if name.startswith("c") and name[1:].isdigit():
            return stumpff(int(name[1:]), x)
        return getattr(sp, name)(x)

    def named(self, name: str, x: Any) -> Any:
        """A symbol for the value, unless it is one by itself."""
        if not isinstance(x, sp.Expr) or x.is_Atom:
            return x
        return self.values.setdefault((name, x), sp.Symbol(f"{VALUE}_{len(self.values) + 1}"))


class _Written:
    """A law run on symbols."""

    def __init__(self, shape: InteractionClass):
        self.names: dict[sp.Symbol, str] = {}
        given = Relative(*(self._entries(*of) for of in RELATIVE.values()))
        table = shape.kind.table()
        numbers = [self._symbol(latex) for name in shape.stated for latex in symbols(table[name])]
        self.tracer = _SymbolTracer()
        wrench = shape.wrench(self.tracer, given, numbers)
        sides = [*zip((TORQUE,) * 3, "xyz", wrench.torque, strict=True)]
        sides += zip((FORCE,) * 3, "xyz", wrench.force, strict=True)
        sides.append((POTENTIAL, "", shape.energy(self.tracer, given, numbers)))
        self.sides = [(subscripted(letter, place), sp.sympify(x)) for letter, place, x in sides]

    def _symbol(self, latex: str) -> sp.Symbol:
        out = sp.Symbol(f"s{len(self.names)}")
        self.names[out] = latex
        return out

    def _entries(self, letter: str, size: tuple[int, ...]) -> np.ndarray:
        places = ["".join("xyz"[k] for k in index) for index in np.ndindex(size)]
        symbols = [self._symbol(subscripted(letter, place)) for place in places]
        return np.array(symbols, dtype=object).reshape(size)

    def quantities(self) -> list[Equation]:
        """The values that the law names, then the entries of the wrench and the potential that are not zero."""
        named = {x: rf"{VALUE}_{{{k}}}" for k, x in enumerate(self.tracer.values.values(), 1)}
        names = self.names | named
        rank = {s: (int(Binding.STATE), 0, (False, k), 0) for k, s in enumerate(names)}
        write = lambda x: Scalars(names, rank, digits(x))(x)  # noqa: E731
        words = lambda name: f"{name.replace('_', ' ')}, a value of the program"  # noqa: E731
        out = [Equation(named[s], write(x), "-", words(name)) for (name, x), s in self.tracer.values.items()]
        return out + [Equation(left, write(x)) for left, x in self.sides if x != 0]
