"""Formulas in text, in LaTeX and as expressions of sympy."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from ...lazily import sp
from ..latex.layout import width
from .names import Name
from .numbers import exactly
from .ring import Exponent
from .trees import Atom, FormulaProduct, FormulaSum

DIGITS = 6
"""Of numbers that are no fractions, where they are shown; expressions have all."""


class Parts(NamedTuple):
    """What a product is made of: its number as a fraction, factors before and behind its bracket, what it is over."""

    top: str
    under: str
    before: list[str]
    bracket: str
    behind: list[str]
    over: list[str]


@dataclass(frozen=True)
class Style:
    """How one notation writes a formula."""

    symbol: Callable[[Name], str]
    function: str
    power: Callable[[str, str], str]
    product: Callable[[Parts], str]
    number: Callable[[str], str]


def _text_product(p: Parts) -> str:
    above = [*p.before, *[f"({p.bracket})"] * bool(p.bracket), *p.behind]
    above = [p.top, *above] if p.top != "1" or not above else above
    below = [p.under, *p.over] if p.under != "1" else p.over
    under = "*".join(below)
    return "*".join(above) + (f"/({under})" if len(below) > 1 else f"/{under}" if below else "")


TEXT = Style(lambda name: name.text, "{0}({1})", "{0}**{1}".format, _text_product, str)

TIMES = r"\,"


def _latex_product(p: Parts) -> str:
    """Fractions of numbers small, what stands over symbols as a fraction, a bracket beside it."""
    bracket = [rf"\left({p.bracket}\right)"] if p.bracket else []
    number = [p.top] if p.top != "1" else []
    if not p.over:
        lead = [rf"\tfrac{{{p.top}}}{{{p.under}}}"] if p.under != "1" else number
        return _times([*lead, *p.before, *bracket, *p.behind]) or "1"
    below = _times([p.under, *p.over] if p.under != "1" else p.over)
    above = [*number, *p.before]
    if not bracket:
        return rf"\frac{{{_times([*above, *p.behind]) or '1'}}}{{{below}}}"
    if not above and not p.behind:
        return rf"\frac{{{p.bracket}}}{{{below}}}"
    if not above:
        return _times([rf"\frac{{{p.bracket}}}{{{below}}}", *p.behind])
    return _times([rf"\frac{{{_times(above)}}}{{{below}}}", *bracket, *p.behind])


def _times(factors: Sequence[str]) -> str:
    """Factors side by side; the bar of a root ends it without a gap."""
    return re.sub(r"(\\sqrt\{\d+\})\\,", r"\1", TIMES.join(factors))


def _latex_number(text: str) -> str:
    mantissa, _, exponent = text.partition("e")
    return mantissa + (rf"\times 10^{{{int(exponent)}}}" if exponent else "")


def _latex_power(base: str, exponent: str) -> str:
    simple = "^" not in base and not base.endswith(")") and " " not in base
    return rf"{base}^{{{exponent}}}" if simple else rf"({base})^{{{exponent}}}"


LATEX = Style(lambda name: name.latex, r"\{0} {1}", _latex_power, _latex_product, _latex_number)


@dataclass(frozen=True)
class FormulaWriter:
    """Writes formulas with the names of generators, by their numbers.

    ``moving``: the numbers of coordinates and rates, before which a bracket of parameters stands.
    """

    names: Mapping[int, Name]
    style: Style
    moving: frozenset[int] = frozenset()

    def __call__(self, formula: FormulaSum) -> str:
        """The formula; a zero is 0."""
        return " ".join(self.terms(formula)) or "0"

    def terms(self, formula: FormulaSum, room: float = math.inf) -> list[str]:
        """The terms, each but the first with its sign before it; those wider than ``room`` (em) in pieces."""
        out: list[str] = []
        for term in formula.terms:
            minus = term.coefficient < 0
            sign = ("- " if minus else "+ ") if out else ("-" if minus else "")
            pieces = [self._product(term)]
            if term.inner is not None and room < math.inf and width(pieces[0]) > room:
                pieces = self._pieces(term, term.inner, room)
            out += [sign + pieces[0], *pieces[1:]]
        return out

    def _pieces(self, term: FormulaProduct, inner: FormulaSum, room: float) -> list[str]:
        """A wide product as what stands before its bracket with the first term in it, and the other terms."""
        first, *others = self.terms(inner, room)
        before = self._product(FormulaProduct(abs(term.coefficient), term.factors))
        before = before + TIMES if term.factors or abs(term.coefficient) != 1 else ""
        *middle, last = [f"{before}\\Bigl({first}", *others]
        return [*middle, f"{last}\\Bigr)"]

    def _product(self, term: FormulaProduct) -> str:
        size = abs(term.coefficient)
        first = term.inner is not None and not any(map(self._moves, term.inner.atoms()))
        behind = [self._power(atom, e) for atom, e in term.factors if e > 0 and first and self._moves(atom)]
        parts = Parts(
            *((str(size.numerator), str(size.denominator)) if exactly(size) else (self._decimal(size), "1")),
            [self._power(atom, e) for atom, e in term.factors if e > 0 and not (first and self._moves(atom))],
            "" if term.inner is None else self(term.inner),
            behind,
            [self._power(atom, -e) for atom, e in term.factors if e < 0],
        )
        return self.style.product(parts)

    def _decimal(self, size: Fraction) -> str:
        return self.style.number(f"{float(size):.{DIGITS}g}")

    def _moves(self, atom: Atom) -> bool:
        return any(number in self.moving for number, _ in atom.of)

    def _power(self, atom: Atom, exponent: Exponent) -> str:
        if exponent == 1:
            return self._atom(atom)
        power = str(exponent) if Fraction(exponent).denominator == 1 else f"({exponent})"
        if self.style is LATEX:
            if exponent == Fraction(1, 2):
                return rf"\sqrt{{{self._atom(atom)}}}"
            if atom.function:
                return rf"\{atom.function}^{{{exponent}}} {self._argument(atom)}"
            power = str(exponent)
        return self.style.power(self._atom(atom), power)

    def _atom(self, atom: Atom) -> str:
        if not atom.function:
            return self.style.symbol(self.names[atom.of[0][0]])
        return self.style.function.format(atom.function, self._argument(atom))

    def _argument(self, atom: Atom) -> str:
        inner = FormulaSum(tuple(FormulaProduct(Fraction(k), ((Atom("", ((n, 1),)), 1),)) for n, k in atom.of))
        text = self(inner)
        alone = self.style is TEXT or (len(atom.of) == 1 and atom.of[0][1] == 1)
        return text if alone else rf"\left({text}\right)"


def expression(formula: FormulaSum, symbols: Mapping[int, sp.Expr]) -> sp.Expr:
    """The formula as an expression of sympy."""
    return sp.Add(*(_product(term, symbols) for term in formula.terms))


def _product(term: FormulaProduct, symbols: Mapping[int, sp.Expr]) -> sp.Expr:
    c = term.coefficient
    factors = [sp.Rational(c.numerator, c.denominator) if exactly(c) else sp.Float(float(c))]
    factors += [_atom(atom, symbols) ** _exponent(e) for atom, e in term.factors]
    if term.inner is not None:
        factors.append(expression(term.inner, symbols))
    return sp.Mul(*factors)


def _exponent(e: Exponent) -> sp.Rational:
    return sp.Rational(Fraction(e).numerator, Fraction(e).denominator)


def _atom(atom: Atom, symbols: Mapping[int, sp.Expr]) -> sp.Expr:
    if not atom.function:
        return symbols[atom.of[0][0]]
    argument = sp.Add(*(_exponent(k) * symbols[n] for n, k in atom.of))
    return getattr(sp, atom.function)(argument)
