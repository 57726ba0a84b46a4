"""The sections and items of a page, with their anchors and levels of detail."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import count

from .code_lines import CodeLines
from .content import MODES, PARAMETERS, SYMBOLS, DocumentSection, DocumentTable, Item

ESSENCE, CLASSES, ALL = 1, 2, 3
"""The levels of detail: what a robot is solved by, what each class of links adds, every auxiliary step."""
SYMBOL_HEAD = ("symbol", "meaning", "unit")
"""The first columns of tables whose rows say what is known of a symbol in a formula."""


@dataclass
class PageItem:
    """An item with its anchor, its level, the row of the symbol that it defines, and its lines of C."""

    item: Item
    anchor: str
    level: int
    symbol: int = -1
    code: CodeLines | None = None
    codes: Sequence[tuple[str, str, CodeLines]] = ()
    """Anchors, links and lines of what has no step of its own; of the heading of the solution."""
    link: str = ""
    """The name of the one link that it is about."""
    rows: Sequence[str] = ()
    """The anchors of the rows of a table to which links and searches lead."""

    @property
    def kind(self) -> str:
        return self.item.kind


@dataclass
class PageSection:
    section: DocumentSection
    anchor: str
    number: int
    items: list[PageItem] = field(default_factory=list)

    @property
    def title(self) -> str:
        return self.section.title

    @property
    def level(self) -> int:
        return min((item.level for item in self.items), default=CLASSES)

    @property
    def is_reference(self) -> bool:
        """Whether it is a table to look things up in, which is closed at first."""
        return self.title in (SYMBOLS, PARAMETERS)

    @property
    def headings(self) -> list[PageItem]:
        return [item for item in self.items if item.kind == "heading"]


def name_rows(sections: Sequence[PageSection]) -> None:
    """The anchors of rows: of symbols ``y0`` … through all tables, of parameters, of modes by link and number."""
    symbols = count()
    for section, item in ((s, item) for s in sections for item in s.items):
        if not isinstance(item.item, DocumentTable):
            continue
        rows = item.item.rows
        if item.item.head[:3] == SYMBOL_HEAD:
            item.rows = [f"y{next(symbols)}" for _ in rows]
        elif section.title == PARAMETERS:
            item.rows = [f"p{k}" for k in range(len(rows))]
        elif section.title == MODES:
            item.rows = [f"mode-{row[1].strip('`')}{f'-{row[2]}' * (row[2] != '1')}" for row in rows]
