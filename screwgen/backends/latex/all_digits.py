"""The constants of a class of links with all their digits, which its steps print with fewer."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ...bases import Shapes
from ...bases.polynomial import polynomial_latex
from ...spec.link_class import LinkClass
from .content import DocumentTable, Item, Paragraph
from .layout import PAGE, width
from .steps import DIGITS

TERM = re.compile(r" (?=[+-] )")
"""Where a sum goes on with its next term."""
FORMULAS = 6
"""Of up to that many polynomial shapes the coefficients are printed."""


def has_formulas(shapes: Shapes) -> bool:
    """Whether the coefficients of polynomial shapes are printed."""
    return bool(shapes.family.changes) and shapes.count <= FORMULAS


def exact_shapes(key: LinkClass) -> Iterator[tuple[str, str]]:
    """The polynomial shapes whose coefficients are printed, with all digits; equal ones together."""
    found: dict[tuple[int, str], list[str]] = {}
    for n, (direction, k) in enumerate(key.directions, 1) if key.elastic is None else ():
        if has_formulas(shapes := key.shapes(direction)):
            form = polynomial_latex(shapes.functions[k], DIGITS)
            found.setdefault((k + 1, form), []).append(rf"\varphi_{{{n}}}")
    yield from ((" = ".join([*names, rf"\psi_{{{k}}}(s)"]), form) for (k, form), names in found.items())


def _by_terms(formula: str) -> str:
    """A formula that may be broken before each term, also in brackets."""
    parts = TERM.split(formula.replace(r"\left(", "(").replace(r"\right)", ")"))
    out = parts[0]
    for part in parts[1:]:
        out += ("$ $" if out.count("{") == out.count("}") else " ") + part
    return out


def constants(rows: Sequence[tuple[str, str]]) -> Iterator[Item]:
    """The entries of the constants that have numbers, two in a row where they are short."""
    yield Paragraph(
        "The entries of the constants above, and the shapes, whose numbers are printed there with fewer digits:"
    )
    short: list[str] = []
    long: list[str] = []
    for left, right in dict(rows).items():
        narrow = width(f"{left} = {right}") <= PAGE / 2 - 2.0
        (short if narrow else long).append(f"${left} =$ ${_by_terms(right)}$")
    for cells, count in ((short, 2), (long, 1)):
        cells += [""] * (-len(cells) % count)
        lines = tuple(tuple(cells[k : k + count]) for k in range(0, len(cells), count))
        if lines:
            yield DocumentTable(("entry",) * count, (1.0 / count,) * count, lines)
