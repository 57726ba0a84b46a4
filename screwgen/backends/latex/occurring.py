"""Which symbols a document has: those in its formulas, whatever stands above them or for ``i`` below them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from .content import (
    Display,
    DocumentSection,
    DocumentTable,
    DrawingItem,
    Heading,
    Item,
    NumberedLine,
    Paragraph,
    StepEquation,
)
from .layout import Formula
from .symbols import Entry

FORMULA = re.compile(r"\$([^$]*)\$")
LINK = r"(?:i|[1-9]\d*|i[+-]1|\{(?:i|[1-9]\d*|i[+-]1)\})"
"""The number of a link below a symbol."""
ALONE = r"(?<![A-Za-z\\])(?<!\\mathbf\{)(?<!\\boldsymbol\{)(?<!\\mathrm\{)(?<!_)(?<!_\{)"
"""What stands before a symbol: a letter that is bold or upright, or an index, is another symbol or none."""
OTHER = r"(?!\}*(?:_|\^(?!\{?(?:\\top|[-\d]))))"
"""A letter without an index is another one than that with an index, or with a star or the like."""
SCRIPT = re.compile(r"[_^]")


def occurring(entries: Iterable[Entry], sections: Iterable[DocumentSection]) -> list[Entry]:
    """The entries whose symbols stand in a formula of the sections."""
    found = (formula for section in sections for item in section.items for formula in formulas(item))
    text = " ".join(dict.fromkeys(found))
    stands = lambda symbol: symbol[: _scripts(symbol)] in text and pattern(symbol).search(text)  # noqa: E731
    return [entry for entry in entries if stands(entry.display)]


def pattern(symbol: str) -> re.Pattern[str]:
    """What finds a symbol in LaTeX, also below an accent, and also that of a link with a number."""
    cut = _scripts(symbol)
    base, below = re.escape(symbol[:cut]), re.escape(symbol[cut:])
    below = re.sub(r"(?<![A-Za-z])i(?![A-Za-z])", lambda _: LINK, below)
    other = OTHER * ("_" not in symbol)
    return re.compile(rf"{ALONE}{base}(?![A-Za-z]){other}\}}*{below}(?![A-Za-z])")


def _scripts(symbol: str) -> int:
    """Where the scripts of a symbol begin, which is its end if it has none."""
    depth = 0
    for place, c in enumerate(symbol):
        depth += (c == "{") - (c == "}")
        if depth == 0 and SCRIPT.match(c):
            return place
    return len(symbol)


def formulas(item: Item) -> Iterator[str]:
    """The LaTeX of the formulas of an item."""
    match item:
        case Display() | NumberedLine():
            yield from _cells(item.formula)
        case StepEquation():
            yield from _cells((*item.step.formula, *item.step.components))
            yield from _inline((item.meaning, item.unit, item.frame))
        case DocumentTable():
            yield from _inline([*item.head, *(cell for row in item.rows for cell in row)])
        case Paragraph() | Heading():
            yield from _inline([item.text])
        case DrawingItem():
            yield from _inline([item.caption])


def _cells(formula: Formula) -> Iterator[str]:
    yield from (cell for row in formula for cell in row)


def _inline(texts: Sequence[str]) -> Iterator[str]:
    yield from (found[1] for text in texts for found in FORMULA.finditer(text))
