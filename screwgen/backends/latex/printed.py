"""What of a document is printed: on paper each thing stands once, and what the algorithm needs stands alone."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from math import ceil

from .content import (
    SYMBOLS,
    Display,
    Document,
    DocumentSection,
    DocumentTable,
    Heading,
    Item,
    NumberedLine,
    Paragraph,
    StepEquation,
)
from .layout import PAGE, Formula, width
from .occurring import formulas, pattern
from .tables import NONE
from .text import PIECES

MORE = (
    "Derivation, energies, the system of all rows and further forms of the equations follow with "
    "`screwgen latex --all`, and stand on the page for a browser."
)
"""Where the rest is."""
OWN = (
    "Symbols that a step or a line defines have their meaning, unit and frame there. In brackets stand unit, frame and "
    "size, where it is not a plain number."
)
BESIDE = 23.0
"""Formulas up to that width, in em, have their meaning beside them."""
WHOLE_ROWS, SOME = 12, 3
"""Tables up to so many rows stay on a page; of others so many go with what stands above."""
HEADING, LETTERS, USUAL = 3, 150, 8
"""The lines of a heading, letters of markup in a line of text, and how many lines a heading wants anyway."""
LETTER = 0.5
"""The width of a letter, em."""
COUNT = re.compile(r"\$\d+\$")
"""The size of a scalar, and of a vector of a known number of entries."""
NUMBER = r"\text{(A"
"""How the number of a line begins."""


def printed(shown: Document, whole: bool) -> Document:
    """The document on paper; not ``whole``: without what the algorithm does not need."""
    further = any(section.appendix for section in shown.sections)
    sections = [section for section in shown.sections if whole or not section.appendix]
    meanings = _meanings(shown)
    shorter = sections if whole else [replace(s, items=list(map(_alone, filter(_needed, s.items)))) for s in sections]
    out = [replace(s, items=[x for item in s.items for x in _lines(item, meanings)]) for s in shorter]
    known = set(_defined(out))
    out = [replace(s, items=list(_symbols(s, out, known))) if s.title == SYMBOLS else s for s in out]
    if further and not whole:
        out[0] = replace(out[0], items=[*out[0].items, Paragraph(MORE)])
    return replace(shown, sections=tuple(out))


def room(items: Sequence[Item]) -> int:
    """How many lines of a page a heading wants: those of a paragraph below it and of what follows that."""
    lines, after = HEADING, False
    for item in items:
        if isinstance(item, Paragraph) and not after:
            lines, after = lines + 1 + len(item.text) // LETTERS, True
        elif isinstance(item, Heading):
            lines, after = lines + HEADING, False
        else:
            return lines + (_rows(item) if isinstance(item, DocumentTable) else HEADING)
    return lines


def _rows(table: DocumentTable) -> int:
    """The lines of a table that stay together: all if it is short, else a few."""
    rows = table.rows if len(table.rows) <= WHOLE_ROWS else table.rows[:SOME]
    return HEADING + sum(max(map(_wrapped, row, table.widths)) for row in rows)


def _wrapped(cell: str, share: float) -> int:
    """How many lines a cell takes in a column with a share of the page, about."""
    size = sum(width(p[1:-1]) if p.startswith("$") else LETTER * len(p) for p in PIECES.split(cell))
    return max(1, ceil(size / (share * PAGE)))


def is_short(formula: Formula) -> bool:
    """Whether a formula leaves room for its meaning beside it."""
    return len(formula) == 1 and width(" ".join(formula[0])) <= BESIDE


def _needed(item: Item) -> bool:
    """Whether an item says what no other one says."""
    return not (isinstance(item, Paragraph | DocumentTable) and item.repeats)


def _alone(item: Item) -> Item:
    """A step without components that only write out its equation."""
    if not isinstance(item, StepEquation) or not item.step.alone:
        return item
    return replace(item, step=replace(item.step, formula=item.step.alone, components=()))


def _meanings(shown: Document) -> Mapping[str, str]:
    """By symbol, what the table of symbols says, but for its size."""
    tables = (item for s in shown.sections if s.title == SYMBOLS for item in s.items)
    rows = [row for table in tables if isinstance(table, DocumentTable) for row in table.rows]
    return {row[0].strip("$"): _said(row[1:4]) for row in rows}


def _said(row: Sequence[str]) -> str:
    """Meaning, and in brackets unit, frame and size where there are any."""
    meaning, *about = row[:4]
    known = "; ".join(cell for cell in about if cell not in (NONE, "") and not COUNT.fullmatch(cell))
    return f"{meaning} [{known}]" if known else meaning


def _lines(item: Item, meanings: Mapping[str, str]) -> Iterator[Item]:
    """An item; the rows of a display that have numbers one by one, with the meaning of what they define."""
    if not isinstance(item, Display) or not all(row[-1].startswith(NUMBER) for row in item.formula):
        yield item
        return
    for row in item.formula:
        *cells, _, number = row
        formula = (tuple(cells[:2]),)
        own = [meanings[s] for s in _columns(cells[0]) if s in meanings]
        about = "; ".join(own) if is_short(formula) else ""
        yield NumberedLine(number.removeprefix(r"\text{").removesuffix("}"), formula, about)


def _columns(left: str) -> list[str]:
    """The symbols on the left side of a line: one, or those that stand above each other in a column."""
    return [part.strip() for part in left.removeprefix("[").removesuffix("]").split(r";\ ")]


def _defined(sections: Iterable[DocumentSection]) -> Iterator[str]:
    """The symbols whose meaning stands at a step or at a line."""
    for item in (item for section in sections for item in section.items):
        if isinstance(item, StepEquation):
            yield item.step.formula[0][0]
        elif isinstance(item, NumberedLine) and item.about:
            yield from _columns(item.formula[0][0])


def _symbols(own: DocumentSection, sections: Sequence[DocumentSection], known: set[str]) -> Iterator[Item]:
    """The symbols that the sections use and whose meaning stands nowhere else, two in a row."""
    found = (x for section in sections if section is not own for item in section.items for x in formulas(item))
    text = " ".join(dict.fromkeys(found))
    yield Paragraph(OWN)
    for item in own.items:
        if not isinstance(item, DocumentTable):
            yield item
            continue
        rows = [(row[0], _said(row[1:])) for row in item.rows]
        yield _paired([row for row in rows if (s := row[0].strip("$")) not in known and pattern(s).search(text)])


def _paired(rows: Sequence[tuple[str, str]]) -> DocumentTable:
    """A table of two columns of rows, the second of which goes on where the first ends."""
    half = (len(rows) + 1) // 2
    right = [*rows[half:], *[("", "")] * (2 * half - len(rows))]
    lines = tuple((*a, *b) for a, b in zip(rows[:half], right, strict=True))
    return DocumentTable(("symbol", "meaning") * 2, (0.11, 0.39) * 2, lines)
