"""The equations of a force between frames: those that its kind states, or what its program computes, entry by entry."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import sympy as sp

from ...algebra.stumpff import stumpff
from ...interactions import FORCE, POTENTIAL, TORQUE, InteractionClass, LawEquation, Number, Relative
from ...ir.block import Binding
from .layout import PAGE, width
from .scalars import ELLIPSIS_ABOVE, Scalars, subscripted
from .steps import DIGITS

RELATIVE = {
    "d": (r"\mathbf{d}_{AB}", (3,)),
    "R": (r"\mathbf{R}_{AB}", (3, 3)),
    "v": (r"\mathbf{v}_{AB}", (3,)),
    "omega": (r"\boldsymbol{\omega}_{AB}", (3,)),
}
"""The letters and sizes of how the second frame lies and moves as seen from the first."""
VALUE = "x"
"""The letter of the values of a program."""
ROOM = PAGE - 7.0
"""em: the width of a line, beside its number."""
BESIDE = 4.0
"""em: what a left side has of it."""


def equations(shape: InteractionClass) -> tuple[LawEquation, ...]:
    """The equations in the order of evaluation."""
    return shape.equations or tuple(_Written(shape).equations())


def symbols(one: Number) -> list[str]:
    """The symbol of a number, or those of its entries."""
    places = "xyz" if len(one.entries) == len("xyz") else [f"{k}" for k, _ in enumerate(one.entries, 1)]
    return [subscripted(one.symbol, place) for place in places] or [one.symbol]


def digits(e: sp.Expr) -> int:
    """How many digits the numbers of an expression need, so that none is lost."""
    floats = [float(x) for x in e.atoms(sp.Float)]
    return next(k for k in range(1, DIGITS + 1) if all(float(f"{x:.{k}g}") == x for x in floats))


_Cut = tuple[sp.Expr, sp.Expr, sp.Expr]
"""A part of formulas, what of it gets a symbol, and what is added to that."""


class _SymbolTracer:
    """Records what a law names, over symbols; see :class:`...interactions.Interaction`."""

    def __init__(self) -> None:
        self.values: dict[tuple[str, sp.Expr], sp.Symbol] = {}

    def call(self, name: str, x: Any, *more: Any) -> sp.Expr:
        """A function of a program."""
        x = sp.sympify(x)
        if name == "on":
            return sp.Function(r"mathrm{H}")(x)
        if name.startswith("c") and name[1:].isdigit():
            return stumpff(int(name[1:]), x)
        return getattr(sp, name)(x, *more)

    def named(self, name: str, x: Any) -> Any:
        """A symbol for the value, unless it is one by itself."""
        if not isinstance(x, sp.Expr) or x.is_Atom:
            return x
        return self.values.setdefault((name, x), sp.Symbol(f"v{len(self.values)}"))


class _LawScalars(Scalars):
    """Writes the scalars of a law."""

    def _power(self, f: sp.Expr) -> str:
        whole = f.base.is_Add and f.exp.is_Integer
        return rf"{self._factor(f.base)}^{{{f.exp}}}" if whole else super()._power(f)


class _Value(NamedTuple):
    """A value that has a symbol of its own: what it is made from, and the name that the law gives it."""

    right: sp.Expr
    name: str = ""


class _Written:
    """A law run on symbols."""

    def __init__(self, shape: InteractionClass):
        self.names: dict[sp.Symbol, str] = {}
        given = Relative(*(self._entries(*of) for of in RELATIVE.values()))
        table = shape.kind.table()
        numbers = [self._symbol(latex) for name in shape.stated for latex in symbols(table[name])]
        numbers += [self._symbol(entry.symbol) for entry in shape.inputs.values()]
        states = [self._symbol(state.symbol) for state in shape.states.values()]
        numbers += states
        tracer = _SymbolTracer()
        wrench = shape.wrench(tracer, given, numbers)
        sides = [*zip((TORQUE,) * 3, "xyz", wrench.torque, strict=True)]
        sides += zip((FORCE,) * 3, "xyz", wrench.force, strict=True)
        sides.append((POTENTIAL, "", shape.energy(tracer, given, numbers)))
        rates = zip(shape.states.values(), states, shape.rates(tracer, given, numbers), strict=True)
        sides += [(state.rate_symbol, "", one.gain - one.decay * z) for state, z, one in rates]
        found = {subscripted(letter, place): sp.sympify(x) for letter, place, x in sides}
        self.sides = {left: x for left, x in found.items() if x != 0}
        self.values = {s: _Value(x, name) for (name, x), s in tracer.values.items()}

    def _symbol(self, latex: str) -> sp.Symbol:
        out = sp.Symbol(f"s{len(self.names):04}")
        self.names[out] = latex
        return out

    def _entries(self, letter: str, size: tuple[int, ...]) -> np.ndarray:
        places = ["".join("xyz"[k] for k in index) for index in np.ndindex(size)]
        symbols = [self._symbol(subscripted(letter, place)) for place in places]
        return np.array(symbols, dtype=object).reshape(size)

    def equations(self) -> Iterator[LawEquation]:
        """The values in the order of evaluation, then the entries of the wrench and the potential that are not zero."""
        self._cut()
        order = self._ordered()
        named = {s: rf"{VALUE}_{{{k}}}" for k, s in enumerate(order, 1)}
        for s in order:
            name = self.values[s].name.replace("_", " ")
            about = f"{name}, a value of the program" if name else "a value of the program"
            yield LawEquation(named[s], self._latex(self.values[s].right, named), "-", about)
        yield from (LawEquation(left, self._latex(x, named)) for left, x in self.sides.items())

    def _rights(self) -> list[sp.Expr]:
        return [*(value.right for value in self.values.values()), *self.sides.values()]

    def _writer(self, e: sp.Expr, named: Mapping[sp.Symbol, str]) -> _LawScalars:
        names = {**self.names, **named}
        rank = {s: (int(Binding.STATE), 0, (False, k), 0) for k, s in enumerate(names)}
        return _LawScalars(names, rank, digits(e))

    def _latex(self, e: sp.Expr, named: Mapping[sp.Symbol, str]) -> str:
        return self._writer(e, named)(e)

    def _is_wide(self, e: sp.Expr) -> bool:
        """Whether a term is wider than a line, where alone a formula is broken."""
        named = dict.fromkeys(self.values, rf"{VALUE}_{{99}}")
        return any(width(term) > ROOM - BESIDE for term in self._writer(e, named).terms(e))

    def _cut(self) -> None:
        """Symbols for parts of formulas that no page holds."""
        while cut := self._sum_cut() or self._term_cut():
            whole, part, rest = cut
            symbol = sp.Symbol(f"u{len(self.values)}")
            swap = lambda e, of=whole, by=symbol + rest: e.xreplace({of: by})  # noqa: E731
            self.values = {s: value._replace(right=swap(value.right)) for s, value in self.values.items()}
            self.sides = {left: swap(x) for left, x in self.sides.items()}
            self.values[symbol] = _Value(part)

    def _sums(self) -> Iterator[sp.Expr]:
        return (x for e in self._rights() for x in sp.preorder_traversal(e) if x.is_Add)

    def _sum_cut(self) -> _Cut | None:
        """A part of a sum of so many terms that not all would be printed."""
        long = next((e for e in self._sums() if len(e.args) > ELLIPSIS_ABOVE), None)
        if long is None:
            return None
        own, rest = long.args[:ELLIPSIS_ABOVE], long.args[ELLIPSIS_ABOVE:]
        return long, sp.Add(*own), sp.Add(*rest)

    def _term_cut(self) -> _Cut | None:
        """A sum within a term that is wider than a line; one that occurs often first."""
        counts = Counter(self._sums())
        for wide in filter(self._is_wide, self._rights()):
            inner = [e for e in sp.preorder_traversal(wide) if e.is_Add and e != wide]
            if inner:
                part = max(inner, key=lambda e: (counts[e], e.count_ops(), e.sort_key()))
                return part, part, sp.S.Zero
        return None

    def _ordered(self) -> list[sp.Symbol]:
        """The values, each after those that it needs."""
        out: list[sp.Symbol] = []
        left = list(self.values)
        while left:
            ready = next(s for s in left if not self.values[s].right.free_symbols & set(left))
            out.append(ready)
            left.remove(ready)
        return out
