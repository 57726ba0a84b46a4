"""The paper, checked, as a document: LaTeX, PDF, HTML; and the list of errata in Markdown."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from ..algebra.expression import BlockMatrix, Expression, Sum, is_zero
from ..algebra.notation import latex, terms
from ..backends.latex import document as latex_document
from ..backends.latex.content import (
    CITATION,
    Display,
    Document,
    DocumentSection,
    DocumentTable,
    Heading,
    Item,
    Paragraph,
)
from ..backends.latex.layout import PAGE, Formula, fill, width
from ..backends.latex.layout import equation as broken
from ..version import __version__
from .equation import Equality, Equation
from .equation import Formula as Statement
from .erratum import Erratum, Figure
from .register import SECTIONS
from .terminal import counted, judgement, number, where

TITLE = "The paper, checked"
METHOD = (
    "Every printed equation is evaluated on random motions of a two-link arm whose velocities, accelerations, momenta "
    "and wrenches are computed from their definitions, without any formula of the paper or of the derivation. An "
    "equation holds if its two sides agree to 1e-11 of its largest term, on every motion; it holds after a change of "
    "notation if it does so once a symbol is read as stated. Where it fails, the derived formula, which does agree, "
    "is given, and the difference of the two as a formula."
)
LIST_WIDTHS = (0.16, 0.42, 0.26, 0.16)
FIGURE_WIDTHS = (0.52, 0.16, 0.16, 0.16)


def tex(equations: Sequence[Equation], errata: Sequence[Erratum]) -> str:
    """The equations and errata as a LaTeX document."""
    return latex_document.tex(content(equations, errata))


def html(equations: Sequence[Equation], errata: Sequence[Erratum]) -> str:
    """The same as one HTML page with MathML."""
    return latex_document.page(content(equations, errata))


def content(equations: Sequence[Equation], errata: Sequence[Erratum]) -> Document:
    """Sections of the paper with their equations, then the errata with their figures."""
    sections = [_overview(equations)] if len(equations) > 1 else []
    for number_, title in SECTIONS.items():
        items = [item for e in equations if e.section == number_ for item in equation_items(e)]
        if items:
            place = f"Section {number_}" if number_.isdigit() else f"Appendix {number_}"
            sections.append(DocumentSection(f"{place}: {title}", items))
    if errata:
        sections.append(DocumentSection("Errata", [item for e in errata for item in erratum_items(e)]))
    return Document("paper", __version__, tuple(sections), TITLE)


def _overview(equations: Sequence[Equation]) -> DocumentSection:
    """How the paper was checked, and a table of what became of each equation."""
    rows = [(f"({e.label})", e.title, e.standing.value, ", ".join(e.errata)) for e in equations]
    table = DocumentTable(("equation", "what", "standing", "errata"), LIST_WIDTHS, tuple(rows))
    words = [Paragraph(text) for text in (f"{CITATION}.", METHOD, counted(equations))]
    return DocumentSection("What holds", [*words, table])


# ----------------------------------------------------------------------------------------- equations


def equation_items(e: Equation) -> list[Item]:
    """One equation: printed, derived, the difference, and how it was judged."""
    items: list[Item] = [Heading(f"({e.label}) {e.title}: {e.standing.value}")]
    if e.derived or e.reading:
        items.append(Paragraph("Printed:"))
    items += map(statement, e.printed)
    for name, value in e.reading.items():
        symbol = next(s for s in e.symbols if s.name == name)
        items.append(Paragraph(f"Read ${latex(symbol)}$ as ${latex(value)}$."))
    if e.derived:
        items += [Paragraph("Derived:"), *map(statement, e.derived)]
    differences = e.gaps()
    if differences:
        items.append(Paragraph("Printed minus derived:"))
        items += [statement(d) if isinstance(d, Statement) else Display(_laid_out("", d)) for d in differences]
    see = f"See {', '.join(e.errata)}." if e.errata else ""
    block = f"Derived block and step: `{e.block}`." if e.block else ""
    verdict = judgement(e) if e.derived else ""
    text = " ".join(filter(None, (e.note, verdict, see, block)))
    return [*items, Paragraph(text)] if text else items


def statement(s: Equality | Statement) -> Item:
    """A printed or derived line: a displayed formula, or words."""
    if isinstance(s, Equality):
        left, right = latex(s.left), latex(s.right)
        if isinstance(s.left, Sum) and not isinstance(s.right, BlockMatrix) and width(f"{left} = {right}") > PAGE:
            return Display(tuple(("", line) for line in fill([*terms(s.left), f"= {right}"], PAGE)))
        return Display(_laid_out(left, s.right))
    if isinstance(s.statement, str):
        return Paragraph(s.latex)
    lines = fill(s.terms, PAGE) if width(s.latex) > PAGE else [s.latex]
    return Display(tuple(("", line) for line in lines))


def _laid_out(left: str, right: Expression) -> Formula:
    """``left = right`` fitted to the page; a matrix that is too wide, entry by entry."""
    if not isinstance(right, BlockMatrix) or width(f"{left} = {latex(right)}") <= PAGE:
        return broken(left, terms(right)) if left else tuple(("", line) for line in fill(terms(right), PAGE))
    rows = [(rf"\text{{row }}{i}\text{{, column }}{j}:", x) for i, j, x in _entries(right)]
    head = ((left, r"= \text{the matrix with}"),) if left else ()
    return (*head, *(line for mark, x in rows for line in _entry(mark, x)))


def _entries(e: BlockMatrix) -> list[tuple[int, int, Expression]]:
    return [(i, j, x) for i, row in enumerate(e.rows, 1) for j, x in enumerate(row, 1) if not is_zero(x)]


def _entry(mark: str, x: Expression) -> list[tuple[str, str]]:
    lines = fill(terms(x) if isinstance(x, Sum) else [latex(x)], PAGE - 9)
    return [(mark if k == 0 else "", rf"\quad {line}") for k, line in enumerate(lines)]


# -------------------------------------------------------------------------------------------- errata


def erratum_items(e: Erratum) -> list[Item]:
    """One erratum with its figures."""
    return [
        Heading(f"{e.number}: {e.title}"),
        Paragraph(f"In {where(e)}. Printed: {e.printed}."),
        Paragraph(f"What holds: {e.holds}."),
        DocumentTable(("figure", "printed", "derived", "must be"), FIGURE_WIDTHS, tuple(map(_figure, e.figures))),
    ]


def _figure(f: Figure) -> tuple[str, str, str, str]:
    unit = "" if f.unit == "-" else f" {f.unit}"
    cells = (_set(number(f, x)) for x in (f.printed, f.derived, f.truth))
    printed, derived, truth = (cell + (unit if cell != "0" else "") for cell in cells)
    return f.what, printed, derived, truth


def _set(text: str) -> str:
    """A number as it is set: with a minus sign, and a power of ten as a formula."""
    mantissa, _, exponent = text.partition("e")
    return rf"${mantissa}\times 10^{{{int(exponent)}}}$" if exponent else mantissa.replace("-", "−")


def errata_page(errata: Sequence[Erratum]) -> str:
    """``docs/errata.md``: every erratum with the numbers that show it."""
    lines = [
        "# Errata of the paper",
        "",
        *textwrap.wrap(f"The paper is {CITATION}.", 110, break_on_hyphens=False),
        "",
        "Each entry says what is printed, what holds instead, and shows both with numbers: what the printed formula",
        "gives, what the derived one gives, and what must be by a judge that shares nothing with either. The page is",
        "made by `screwgen paper --errata -o docs/errata.md`; a test recomputes every number.",
        "",
        "An equation such as (27) is called by its label in the paper's source, `eq:27`. The pages number the",
        "equations in order, and (27) is number 10 there; `screwgen paper` lists the numbers beside the labels.",
        "",
        "| erratum | equations | what |",
        "|---|---|---|",
        *(f"| [{e.number}](#{e.number.lower()}) | {where(e)} | {e.title} |" for e in errata),
    ]
    return "\n".join([*lines, *(line for e in errata for line in _chapter(e)), ""])


def _chapter(e: Erratum) -> list[str]:
    rows = [" | ".join(cell.replace("|", r"\|") for cell in _figure(f)) for f in e.figures]
    return [
        "",
        f"## {e.number}",
        "",
        f"**{e.title[:1].upper()}{e.title[1:]}.** In {where(e)}.",
        "",
        f"Printed: {e.printed}.",
        "",
        f"What holds: {e.holds}.",
        "",
        "| figure | printed | derived | must be |",
        "|---|---:|---:|---:|",
        *(f"| {row} |" for row in rows),
    ]
