"""Reports: one HTML page, a list of sections, each a template and what it shows."""

from __future__ import annotations

import base64
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Generic, NamedTuple, TypeVar

from ..backends.templates import markup, render

Context = Mapping[str, Any]
Subject = TypeVar("Subject")


class ReportSection(NamedTuple, Generic[Subject]):
    """A part of a report: its title, its template as `report/said`, and what that shows of the report's subject."""

    title: str
    template: str
    context: Callable[[Subject], Context]
    """Empty where there is nothing to show: the page is then without the section."""


class ShownSection(NamedTuple):
    """A section as it stands on the page."""

    title: str
    html: str


def report_page(title: str, sections: Sequence[ReportSection[Subject]], subject: Subject) -> str:
    """The page, which needs nothing else."""
    contexts = [(section, section.context(subject)) for section in sections]
    shown = [
        ShownSection(section.title, markup(render(f"{section.template}.html.jinja", **context)))
        for section, context in contexts
        if context
    ]
    return render("report/page.html.jinja", title=title, sections=shown)


class TableRow(NamedTuple):
    """A row of a table of the page."""

    cells: Sequence[str]
    odd: bool = False
    """Whether its numbers deserve a look."""


def table(
    head: Sequence[str],
    rows: Sequence[TableRow],
    text: str = "",
    pictures: Mapping[str, bytes] | None = None,
    words: int = 1,
) -> Context:
    """What `report/table` shows: a text, a table whose first `words` columns are no numbers, pictures by labels."""
    shown = [{"label": label, "source": embedded(png)} for label, png in (pictures or {}).items()]
    return {"head": head, "rows": rows, "text": text, "pictures": shown, "words": words}


def said(lines: Sequence[str], nothing: str = "") -> Context:
    """What `report/said` shows of lines that all deserve a look, and what it says where there are none."""
    return {"lines": lines, "odd": lines, "nothing": nothing}


def embedded(png: bytes) -> str:
    """A picture as the address that holds all of it."""
    return "data:image/png;base64," + base64.b64encode(png).decode()
