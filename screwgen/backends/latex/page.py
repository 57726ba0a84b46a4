"""A document as one page for a browser: levels of detail, contents, definitions of symbols, numbers, lines of C.

The page is the document's sections with anchors, and what a browser needs to move among them. What only robots have,
numbers, the diagram and the lines of generated C, are a page's `Extras`.
"""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ...topology.chain import Chain
from ..templates import folder, markup, render
from . import code_lines, diagram, numbers, text
from .algorithm import defined, plain
from .code_lines import CodeLines, GeneratedC
from .content import (
    SYMBOLS,
    Display,
    Document,
    DocumentSection,
    DocumentTable,
    Heading,
    Item,
    Paragraph,
    StepEquation,
)
from .drawing_writers import svg
from .joint_words import called, sought
from .joints import instance
from .layout import Formula
from .marks import Entries, Marks
from .mass_matrix import MassMatrix, mass_matrix
from .numbers import MANY_LINKS, Table
from .page_sections import ALL, CLASSES, ESSENCE, SYMBOL_HEAD, PageItem, PageSection, name_rows
from .steps import KEY_STEPS

CLASS_STEPS = (*KEY_STEPS, "M_eta", "K", "S", "J", "A")
"""Steps that the second level shows besides those that the paper numbers."""
SOLUTION = "Outward: accelerations"
BIAS = re.compile(r"joint: .*eliminated")
"""The heading, in generated C, of what has the bias of a joint."""
TORQUE = "tau["
"""What generated C calls an entry of the torques."""
FORWARD = "forward_dynamics"
BOLD = r"(?:\\\w+\{)*\\(?:mathbf|boldsymbol)\{"


@dataclass(frozen=True)
class Guide:
    """Where a page has what readers look for of a link; anchors, empty where there is none."""

    link: str
    number: int
    of_class: str
    modes: str
    bias: CodeLines | None
    line: int
    """The number of the line there that takes the bias from the torque; 0 if there is none."""
    place: str
    """The anchor of the lines of C of the joint's bias."""
    torque: str
    """The anchor of the equation of the joint's torques."""
    efforts: Sequence[int]
    """The numbers of these torques."""
    word: str
    """What people call the joint, if the link's name says it."""
    sought: str
    """The word by which a search finds the joint."""


@dataclass(frozen=True)
class Extras:
    """What a page has of a robot beside its document."""

    diagram: str
    numbers: Mapping[str, Mapping[str, Table]]
    modes: DocumentTable | None
    held: DocumentTable | None
    """The frequencies of the links, each held at its base."""
    held_about: str
    """What they mean."""
    code: GeneratedC
    firsts: Sequence[int]
    """The first link of every class."""
    names: Sequence[str]
    classes: Sequence[int]
    """The number of every link's class, from 1."""
    entries: Entries
    efforts: Sequence[Sequence[int]]
    """The numbers of the torques of every link's joint, from 1."""
    sought: Sequence[str]
    """The words by which a search finds the links' joints."""
    mass: MassMatrix


def extras(chain: Chain, at: Sequence[float] | None = None) -> Extras:
    """What the page of a robot has beside its document; ``at``: the coordinates (nq,) of the mass matrix in numbers."""
    found = numbers.numbers(chain)
    firsts = [chain.keys.index(key) for key in chain.classes]
    classes = [chain.classes.index(key) + 1 for key in chain.keys]
    table, held = numbers.modes(chain), numbers.held_table(chain.robot)
    drawn, code = diagram.diagram(chain), code_lines.generated(chain)
    places = chain.tau_offset
    efforts = [range(places[i] + 1, places[i + 1] + 1) for i in range(chain.n)]
    entries = numbers.entries(chain)
    return Extras(
        drawn,
        found,
        table,
        held,
        numbers.about(numbers.HELD, chain),
        code,
        firsts,
        chain.names,
        classes,
        entries,
        efforts,
        sought(chain),
        mass_matrix(chain, at),
    )


def page(shown: Document, more: Extras | None = None) -> str:
    """The document in HTML."""
    symbols = symbols_of(shown)
    sections = list(_sections(shown, symbols, more))
    name_rows(sections)
    values = {"text": text.in_html, "rows": text.html_rows, "document": shown, "sections": sections, "more": more}
    data = _data(sections, symbols, more)
    body = render(
        "latex/document.html.jinja",
        **values,
        svg=svg,
        levels=any(item.level == ESSENCE for s in sections for item in s.items) and more is not None,
        guides=list(_guides(sections, more)) if more else [],
        torque=_anchor_of(sections, r"\mathbf{J}_m &") or _anchor_of(sections, r"\mathbf{f}_{q,i}"),
        solved=_anchor_of(sections, r"\ddot{\mathbf{q}}_i"),
        diagram=markup(more.diagram) if more else "",
        mass=markup(_mass(sections, more.mass)) if more else "",
        data=markup(json.dumps(data, separators=(",", ":"), ensure_ascii=False).translate(SAFE)),
        font=math_font(),
    )
    return Marks(symbols, more.entries if more else None, _instances(symbols, more))(body)


def _mass(sections: Sequence[PageSection], mass: MassMatrix) -> str:
    """The picture of the mass matrix, whose blocks lead to their formulas."""
    places = {
        "own": _anchor_of(sections, r"\mathbf{M}_{q_jq_j}"),
        "carried": _anchor_of(sections, r"\mathbf{M}_{q_ix_j}"),
    }
    return render("latex/mass.html.jinja", mass=mass, places=places, text=text.in_html, rows=text.html_rows)


SAFE = {ord(c): f"\\u{ord(c):04x}" for c in "<>&"}


def math_font() -> str:
    """The math font of a page in base64: without one, brackets do not grow and accents stand aside."""
    return b64encode((folder() / "latex" / "font" / "math.woff").read_bytes()).decode()


# ------------------------------------------------------------------------------------------ sections


def _instances(symbols: Sequence[str], more: Extras | None) -> dict[str, tuple[str, str]]:
    """By the LaTeX of a symbol of one link, or of links j and k: that of the symbol of link i, and the link's name."""
    links: list[tuple[int | str, str]] = [*enumerate(more.names[:MANY_LINKS], 1)] if more else []
    links += [("j", "j"), ("k", "k")] if more else []
    of_link = lambda symbol: re.search(r"_(i|\{.*i\})$", symbol) is not None  # noqa: E731
    bold = sorted((symbol for symbol in symbols if re.match(BOLD, symbol)), key=of_link)  # those of link i go before
    return {instance(symbol, n): (symbol, name) for n, name in links for symbol in bold}


def symbols_of(shown: Document) -> list[str]:
    """The LaTeX of the symbols, in the order of their tables."""
    tables = (item for s in shown.sections for item in s.items if isinstance(item, DocumentTable))
    return [row[0].strip("$") for table in tables if table.head[:3] == SYMBOL_HEAD for row in table.rows]


def _sections(shown: Document, symbols: Sequence[str], more: Extras | None) -> Iterator[PageSection]:
    number_of = {symbol: number for number, symbol in enumerate(symbols)}
    for number, section in enumerate(shown.sections, 1):
        out = PageSection(section, f"s{number}", number)
        out.items = list(_items(section, out.anchor, number_of, more, first=number == 1))
        _lift(out.items)
        if section.title == SYMBOLS and more:
            yield from _frequencies(more)
        yield out


def _frequencies(more: Extras) -> Iterator[PageSection]:
    """The frequencies of the links."""
    if more.held is not None:
        items = [
            PageItem(Paragraph(more.held_about), "held-about", CLASSES),
            PageItem(more.held, "held-table", CLASSES),
        ]
        yield PageSection(DocumentSection("Frequencies of the links", []), "held", 0, items)


def _items(
    section: DocumentSection, anchor: str, number_of: Mapping[str, int], more: Extras | None, first: bool
) -> Iterator[PageItem]:
    """The items of a section; before the heading that follows the solution, what C computes there."""
    seen: Counter[str] = Counter()
    solving = False
    for place, item in enumerate(section.items, 1):
        if solving and isinstance(item, Heading) and more:
            yield _solution(section, anchor, more)
        if isinstance(item, Heading):
            solving = item.text == SOLUTION
        if not isinstance(item, StepEquation):
            level = ESSENCE if first or getattr(item, "essential", False) else CLASSES
            link = more.names[item.link - 1] if more and isinstance(item, Display) and item.link else ""
            yield PageItem(item, f"torque-{link}" if link else f"{anchor}-{place}", level, link=link)
            continue
        seen[item.step.name] += 1
        name = item.step.name if seen[item.step.name] == 1 else f"{item.step.name}-{seen[item.step.name]}"
        level = CLASSES if item.step.equation or item.step.name in CLASS_STEPS else ALL
        code = _code(item, section.link_class, more)
        yield PageItem(item, f"{anchor}-{name}", level, number_of.get(_left(item.step.formula), -1), code)


def _left(formula: Formula) -> str:
    return formula[0][0]


def _code(item: StepEquation, link_class: int, more: Extras | None) -> CodeLines | None:
    if more is None or not link_class:
        return None
    return more.code.of_step(more.firsts[link_class - 1], item.step)


def _solution(section: DocumentSection, anchor: str, more: Extras) -> PageItem:
    """The lines of the solution, link by link, one of each class."""
    codes = [
        (f"{anchor}-c{i}-{place}", more.names[i], lines)
        for i in more.firsts
        for place, lines in enumerate(more.code.between(i, FORWARD))
    ]
    return PageItem(
        Paragraph("What computes this in generated C, for a link of every class:"), "", CLASSES, codes=codes
    )


def _lift(items: Sequence[PageItem]) -> None:
    """A heading is shown where anything below it is."""
    level = ALL
    for item in reversed(items):
        if item.kind == "heading":
            item.level, level = level, ALL
        else:
            level = min(level, item.level)


# ------------------------------------------------------------------------------------- what is found


def _anchor_of(sections: Sequence[PageSection], part: str) -> str:
    """The anchor of the first essential formula with a part."""
    for item in (item for s in sections for item in s.items if isinstance(item.item, Display)):
        assert isinstance(item.item, Display)
        if item.item.essential and any(part in cell for row in item.item.formula for cell in row):
            return item.anchor
    return ""


def _guides(sections: Sequence[PageSection], more: Extras) -> Iterator[Guide]:
    of_class = {s.section.link_class: s.anchor for s in sections if not s.section.appendix}
    places = {(link, lines.title): anchor for s in sections for x in s.items for anchor, link, lines in x.codes}
    torques = {item.link: item.anchor for s in sections for item in s.items if item.link}
    for i, name in enumerate(more.names[:MANY_LINKS]):
        bias = next((x for x in more.code.between(i, FORWARD) if BIAS.match(x.title)), None)
        first = more.names[more.firsts[more.classes[i] - 1]]
        place = next((a for (link, title), a in places.items() if link == first and BIAS.search(title)), "")
        modes = f"mode-{name}" if more.modes and any(row[1] == f"`{name}`" for row in more.modes.rows) else ""
        torque = torques.get(name, "")
        line = next((n for n, text in enumerate(bias.text, bias.first) if TORQUE in text), 0) if bias else 0
        known = (
            of_class[more.classes[i]],
            modes,
            bias,
            line,
            place,
            torque,
            more.efforts[i],
            called(name),
            more.sought[i],
        )
        yield Guide(name, i + 1, *known)


def _numbers_of(item: Item, number_of: Mapping[str, int]) -> list[int]:
    """The symbols that the lines of a formula define, that of link i also where its symbol has no index."""
    found = sorted(defined([item])) if isinstance(item, Display) else []
    ways = ((name, plain(re.sub(",i}$", "}", name))) for name in found)
    return [number_of[name] for name in (next((x for x in way if x in number_of), "") for way in ways) if name]


def _data(sections: Sequence[PageSection], symbols: Sequence[str], more: Extras | None) -> dict[str, Any]:
    """What the page's script reads: by the number of a symbol its numbers, and the anchors of its definitions."""
    places: dict[int, list[str]] = {}
    number_of = {plain(symbol): number for number, symbol in enumerate(symbols)}
    for item in (item for s in sections for item in s.items):
        for number in [item.symbol] if item.symbol >= 0 else _numbers_of(item.item, number_of):
            places.setdefault(number, []).append(item.anchor)
    known = more.numbers if more else {}
    return {"numbers": {k: known[s] for k, s in enumerate(symbols) if s in known}, "defined": places}
