"""What a document says of inputs: the lines of their table, and what they add to the acceleration of free fall."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from ...ir.block import Binding
from ...spec.input import Input
from ...spec.inputs import input_names, input_units
from ...topology.chain import Chain
from .content import Named
from .tables import plain_unit, span

OWN_FALL, FALL = r"\mathbf{g}_0", r"\mathbf{g}"
"""Free fall of the robot file where inputs add to it, and with what they add."""
STATED = f"Energies take ${OWN_FALL}$ alone."


def lines(chain: Chain) -> tuple[tuple[str, ...], ...]:
    """Number, symbol, name, what it acts on, and unit of each line."""
    names, units, out = input_names(chain.robot), input_units(chain.robot), []
    for row, own in chain.inputs.items():
        first = own.start
        for line in row.lines(chain, first + 1):
            kept = slice(first, first + line.entries)
            unit = plain_unit(", ".join(dict.fromkeys(units[kept])))
            name = f"`{names[first]}`" + " …" * (line.entries > 1)
            out.append((span(first, line.entries), f"${line.symbol}$", name, line.about, unit))
            first = kept.stop
    return tuple(out)


def said(chain: Chain) -> str:
    """How inputs act that meet no coordinate directly, in sentences."""
    texts = [row.said for row in chain.inputs if row.said]
    words = " and of ".join(row.words for row in chain.inputs if row.free_fall is not None)
    texts += [rf"Inputs of {words} act in ${FALL}$ alone; their columns of $\mathbf{{B}}_u$ are zero."] * bool(words)
    return "".join(f" {text}" for text in texts)


def symbols(chain: Chain) -> Iterator[Named]:
    """The symbols of inputs that add to free fall, and that of free fall without them."""
    units = input_units(chain.robot)
    for row, own in chain.inputs.items():
        if row.free_fall is not None:
            for k, symbol in enumerate(_entries(chain, row, own.start), own.start):
                yield symbol, row.words, units[k].replace("·", "*").replace("²", "^2"), "1", "-", Binding.STATE
    if chain.falls:
        yield OWN_FALL, "free fall of the robot file", "m/s^2", "3", "inertial", Binding.PARAMETER
        yield FALL, "free fall with what inputs add to it", "m/s^2", "3", "inertial", Binding.STATE


def fall(chain: Chain) -> str:
    """The formula of free fall with what inputs add to it; empty where none does."""
    out = OWN_FALL
    for row, own in chain.inputs.items():
        if row.free_fall is not None:
            known = {sp.Symbol(f"u{k}"): x for k, x in enumerate(_entries(chain, row, own.start), own.start)}
            added = r";\ ".join(_formula(sp.sympify(x), known) for x in row.free_fall(list(known)))
            out += f" + [{added}]"
    return out if chain.falls else ""


def _entries(chain: Chain, row: Input, first: int) -> list[str]:
    """The symbol of each entry: that of its line, or its number where entries share one."""
    out: list[str] = []
    for line in row.lines(chain, first + 1):
        at = first + len(out) + 1
        out += [line.symbol] if line.entries == 1 else [f"u_{{{k}}}" for k in range(at, at + line.entries)]
    return out


def _formula(x: sp.Expr, known: dict[sp.Symbol, str]) -> str:
    """A linear expression; whole numbers without a point."""
    whole = x.xreplace({n: sp.Integer(int(n)) for n in x.atoms(sp.Float) if n == int(n)})
    return sp.latex(whole, symbol_names=known, mul_symbol=r"\,")
