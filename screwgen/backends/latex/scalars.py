"""The LaTeX of scalar entries: names such as ``S_0_x`` in the paper's notation, sums and products."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache

import sympy as sp

from ...algebra.notation import number, symbol
from ...algebra.stumpff import stumpff
from ...ir.block import Binding, Block, NamedSignal

ELLIPSIS_ABOVE = 16
"""A sum of more terms shows its first and last ones."""

SCRIPT = re.compile(
    r"(?P<head>.+?)(?P<scripts>(?:[_^](?:\{(?:[^{}]|\{[^{}]*\})*\}|\\[A-Za-z]+|[A-Za-z0-9*]))*)", re.DOTALL
)
ONE_SCRIPT = re.compile(r"([_^])(\{(?:[^{}]|\{[^{}]*\})*\}|\\[A-Za-z]+|[A-Za-z0-9*])")
OWN_LINK = re.compile(r",?\s*(\(i-1\))?i")
"""The index of the link itself: entries are written without it."""


def entry(signal: NamedSignal, index: tuple[int, int]) -> str:
    """The LaTeX of one entry of a signal: its letter, not bold, with the entry's place below."""
    place = ",".join(signal.suffix(index).strip("_").split("_"))
    return subscripted(symbol(signal.display), place)


@lru_cache(maxsize=20000)
def subscripted(display: str, place: str, bold: bool = False) -> str:
    """The letter of ``display`` with ``place`` among its subscripts; a power stays inside a bracket.

    Entries are not ``bold``, blocks are.
    """
    written = re.search(r"\\(?:mathbf|boldsymbol)", display)
    if not place and not written:
        return display
    plain = display if bold else re.sub(r"\\(?:mathbf|boldsymbol)\{([^{}]*)\}", r"\1", display)
    head, below, above = _scripts(plain)
    below = "" if OWN_LINK.fullmatch(below) else re.sub(r",i$", "", below)
    if above not in ("", "*"):
        inner = f"_{{{below}}}" if below else ""
        return rf"({head}{inner}^{{{above}}})_{{{place}}}"
    star, place = "^*" if above else "", ",".join(filter(None, (below, place)))
    return rf"{head}{star}_{{{place}}}" if place else head + star


def _scripts(display: str) -> tuple[str, str, str]:
    """The letter of a symbol, its subscript and its superscript."""
    match = SCRIPT.fullmatch(display)
    if match is None:
        return rf"\left({display}\right)", "", ""
    scripts = {"_": "", "^": ""}
    for kind, text in ONE_SCRIPT.findall(match["scripts"]):
        scripts[kind] = text[1:-1] if text.startswith("{") else text
    return match["head"], scripts["_"], scripts["^"]


@dataclass
class Scalars:
    """Writes the sympy scalars of one block."""

    names: Mapping[sp.Symbol, str]
    rank: Mapping[sp.Symbol, tuple]
    digits: int = 6
    """How many digits numbers have at most."""

    _ranked: dict[sp.Expr, list[tuple]] = field(default_factory=dict, init=False, repr=False, compare=False)
    _products: dict[sp.Expr, str] = field(default_factory=dict, init=False, repr=False, compare=False)

    def __call__(self, e: sp.Expr) -> str:
        """The LaTeX of a scalar."""
        first, *rest = self.terms(e)
        return " ".join([first, *rest])

    def is_state(self, s: sp.Symbol) -> bool:
        """Whether a symbol is known in a call only."""
        return self._rank(s)[0] >= Binding.STATE

    def terms(self, e: sp.Expr) -> list[str]:
        """The terms of a sum, each but the first with its sign; a very long sum loses its middle."""
        ordered = self._ordered(sp.Add.make_args(e))
        if len(ordered) > ELLIPSIS_ABOVE:
            texts = [*map(self._signed, ordered[:4]), r"+ \cdots", *map(self._signed, ordered[-2:])]
        else:
            texts = [self._signed(t) for t in ordered]
        sign, first = texts[0].split(" ", 1)
        return [first if sign == "+" else f"-{first}", *texts[1:]]

    def _ordered(self, terms: tuple[sp.Expr, ...]) -> list[sp.Expr]:
        """Constants before the state, then by the rank of their symbols; a positive term comes first."""
        ordered = sorted(terms, key=self._term_key)
        first = next((i for i, t in enumerate(ordered) if not _is_negative(t)), 0)
        return [ordered[first], *ordered[:first], *ordered[first + 1 :]]

    def _term_key(self, t: sp.Expr) -> tuple:
        ranks = self._ranks(t)
        return any(rank[0] >= Binding.STATE for rank in ranks), ranks

    def _signed(self, t: sp.Expr) -> str:
        return f"- {self._known(-t)}" if _is_negative(t) else f"+ {self._known(t)}"

    def _known(self, e: sp.Expr) -> str:
        if e not in self._products:
            self._products[e] = self._product(e)
        return self._products[e]

    def _rank(self, s: sp.Symbol) -> tuple:
        return self.rank.get(s, (9, 0, (False, 0), 0))

    def _ranks(self, e: sp.Expr) -> list[tuple]:
        """The ranks of the symbols of an expression, in their order."""
        if e not in self._ranked:
            self._ranked[e] = sorted(self._rank(s) for s in e.free_symbols)
        return self._ranked[e]

    def _product(self, e: sp.Expr) -> str:
        coefficient, rest = e.as_coeff_Mul()
        factors = [f for f in sp.Mul.make_args(rest) if f != 1]
        below = [1 / f for f in factors if f.is_Pow and f.exp.is_number and f.exp.is_negative]
        above = [f for f in factors if not (f.is_Pow and f.exp.is_number and f.exp.is_negative)]
        out = [self._factor(f) for f in sorted(above, key=self._factor_key)]
        if coefficient != 1 or not out:
            out.insert(0, number(coefficient, self.digits))
        under = r"\,".join(self._factor(f) for f in sorted(below, key=self._factor_key))
        slash = f"/({under})" if len(below) > 1 else f"/{under}" if below else ""
        return r"\,".join(out) + slash

    def _factor_key(self, f: sp.Expr) -> tuple:
        return (f.is_Add, f.is_Function, self._ranks(f))

    def _factor(self, f: sp.Expr) -> str:
        if f.is_Symbol:
            return self.names[f] if f in self.names else str(f)
        if f.is_Number or f.is_NumberSymbol:
            return number(f, self.digits)
        if f.is_Pow:
            return self._power(f)
        if isinstance(f, stumpff):
            return rf"\mathrm{{c}}_{{{f.args[0]}}}({self(f.args[1])})"
        if isinstance(f, sp.atan2):
            return rf"\operatorname{{atan2}}({self(f.args[0])}, {self(f.args[1])})"
        if f.is_Function:
            return rf"\{f.func.__name__} {self._argument(f.args[0])}"
        return rf"\left({self(f)}\right)"

    def _argument(self, e: sp.Expr) -> str:
        return self(e) if e.is_Symbol else rf"({self(e)})"

    def _power(self, f: sp.Expr) -> str:
        if f.exp == sp.Rational(1, 2):
            return rf"\sqrt{{{self(f.base)}}}"
        if f.base.is_Function and not isinstance(f.base, stumpff | sp.atan2):
            name, argument = f.base.func.__name__, self._argument(f.base.args[0])
            return rf"\{name}^{{{self(f.exp)}}} {argument}"
        text = self._factor(f.base)
        simple = f.base.is_Symbol and "^" not in text and text.count("_") < 2 and " " not in text
        return rf"{text}^{{{self(f.exp)}}}" if simple else rf"({text})^{{{self(f.exp)}}}"


def _is_negative(t: sp.Expr) -> bool:
    return t.could_extract_minus_sign() and not t.is_Add


def scalars(block: Block) -> Scalars:
    """The writer of a block's scalars: names from the signals' LaTeX, order from their place."""
    names: dict[sp.Symbol, str] = {}
    rank: dict[sp.Symbol, tuple] = {}
    signals = [(1, s) for s in block.inputs.values()] + [(0, step.signal) for step in block.steps.values()]
    for order, (is_input, signal) in enumerate(signals):
        for place, (index, label) in enumerate(signal.labels()):
            symbol = sp.Symbol(label, real=True)
            names[symbol] = entry(signal, index)
            scalar = signal.shape == (1, 1)
            # scalars before vectors, steps before inputs, the length after the property it multiplies
            rank[symbol] = (int(signal.binding), 0 if scalar else 1 + is_input, (signal.name == "length", order), place)
    return Scalars(names, rank)
