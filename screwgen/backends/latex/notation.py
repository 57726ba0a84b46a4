"""Another notation: a table that maps letters and decorations, applied to a finished document.

A document is derived and laid out in the paper's letters. A notation rewrites every formula of it: `\\mathbf{V}_i` to
`\\mathbf{v}_i`, `\\dot{q}_{1}` to `q_{1}'`. Tables stand in `notations/*.toml`; a user may give one of their own.
Two symbols that would look alike are refused, so that no notation makes a document ambiguous.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import cached_property
from pathlib import Path
from typing import Any

from ...errors import UsageError, one_line
from ...ir.block import NamedSignal
from .breaking import fitted
from .content import (
    SYMBOLS,
    Display,
    Document,
    DocumentTable,
    DrawingItem,
    Heading,
    Item,
    NumberedLine,
    Paragraph,
    StepEquation,
)
from .layout import Formula
from .scalars import entry
from .tables import NONE

FOLDER = Path(__file__).parent / "notations"
CHOICES = {"vectors": ("bold", "arrow"), "rates": ("dot", "prime"), "skew": ("tilde", "hat", "cross")}
"""The decorations: keys with what they may be, first that of the paper."""
TEXTS = ("about", "transpose")
TABLE = "letters"

GROUP = r"\{(?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})*\}"
ACCENT = r"\\(?:dot|ddot|tilde|hat|bar)"
BOLD = r"\\(?:mathbf|boldsymbol|mathcal)"
SCRIPT = rf"(?:{GROUP}|\\[A-Za-z]+|[A-Za-z0-9*])"
SYMBOL = re.compile(
    rf"(?P<skip>\\(?:begin|end|mathrm|operatorname|text){GROUP})"
    rf"|(?P<accents>(?:{ACCENT}\{{)*)(?P<letter>{BOLD}{GROUP}|(?<![A-Za-z\\])\\[A-Za-z]+|(?<![A-Za-z\\])[A-Za-z])"
    rf"(?P<closed>\}}*)(?P<scripts>(?:[_^]{SCRIPT})*)"
)
LETTER = re.compile(
    rf"(?P<letter>(?P<accent>{ACCENT}\{{)?(?:{BOLD}{GROUP}|\\[A-Za-z]+|[A-Za-z])(?(accent)\}}))(?:_(?P<below>{SCRIPT}))?"
)
NEIGHBOUR = re.compile(r"\(?i[+-]1\)?")
"""The subscript of the link before or behind."""
OTHER_MATRICES = (r"\mathbf{0}", r"\boldsymbol{\Delta}")
"""Bold letters that are not in the table of symbols are vectors, but for these."""

Symbol = tuple[str, str]
"""A letter and its subscript."""
Entries = Mapping[Symbol, Symbol]
Vectors = Mapping[str, Mapping[str, bool]]
"""Of a letter with each of its subscripts: whether it is a vector."""


@dataclass(frozen=True)
class Notation:
    """How letters, vectors, rates, skew-symmetric matrices and transposes are written."""

    name: str
    letters: Mapping[str, str]
    vectors: str = "bold"
    rates: str = "dot"
    skew: str = "tilde"
    transpose: str = r"\top"
    shapes: Vectors = field(default_factory=dict, compare=False)
    """Of the symbols of the document."""

    @cached_property
    def changes(self) -> bool:
        """Whether anything differs from the paper."""
        return self != Notation(self.name, {})

    @cached_property
    def _table(self) -> dict[tuple[str, str], tuple[str, str]]:
        return {_split(source): _split(target) for source, target in self.letters.items()}

    def formula(self, text: str, entries: Entries) -> str:
        """A formula of the document in this notation; ``entries``: those of vectors and matrices, as in the paper."""
        out = SYMBOL.sub(lambda match: self._symbol(match, entries), text)
        return out.replace(r"\top", self.transpose) if self.transpose != r"\top" else out

    def _symbol(self, match: re.Match[str], entries: Entries) -> str:
        if match["skip"]:
            return match[0]
        accents = re.findall(r"\\(\w+)\{", match["accents"])
        inside, outside = match["closed"][: len(accents)], match["closed"][len(accents) :]
        if len(inside) < len(accents):
            return match[0]  # an accent over more than a letter stays
        scripts = "" if outside else match["scripts"]
        rest = match["scripts"] if outside else ""
        below, above = _scripts(scripts)
        letter, place = self._letter(match["letter"], below, entries)
        if (letter, place) == (match["letter"], below) and not self._redecorates(accents):
            return match[0]
        return self._decorated(letter, accents, place, above) + outside + rest

    def _letter(self, letter: str, below: str, entries: Entries) -> tuple[str, str]:
        """The letter and its subscript."""
        whole = entries.get((letter, below)) or (self._table.get((letter, below)) if below else None)
        if whole is not None:
            return whole
        written, own = self._table.get((letter, ""), (letter, ""))
        below = ",".join(filter(None, (own, below)))
        if self.vectors == "arrow" and self._is_vector(letter, below):
            written = rf"\vec{{{_plain(written)}}}"
        return written, below

    def _is_vector(self, letter: str, below: str) -> bool:
        """Whether it is a vector's; with a subscript that is not in the table, if it is one with all others."""
        if not re.match(BOLD, letter) or letter in OTHER_MATRICES:
            return False
        known = self.shapes.get(letter, {})
        own = known.get(below, known.get(NEIGHBOUR.sub("i", below)))
        return all(known.values()) if own is None else own

    def _redecorates(self, accents: list[str]) -> bool:
        rates = self.rates != "dot" and not {"dot", "ddot"}.isdisjoint(accents)
        return rates or (self.skew != "tilde" and "tilde" in accents)

    def _decorated(self, letter: str, accents: list[str], below: str, above: str) -> str:
        place = f"_{{{below}}}" if len(below) > 1 else f"_{below}" if below else ""
        primes, cross = "", False
        for accent in reversed(accents):
            if accent in ("dot", "ddot") and self.rates == "prime":
                primes += "'" * (len(accent) - 2)
            elif accent == "tilde" and self.skew == "cross":
                cross = True
            else:
                letter = rf"\{'hat' if accent == 'tilde' and self.skew == 'hat' else accent}{{{letter}}}"
        if cross:
            letter, place, primes = rf"[{letter}{place}{primes}]", r"_{\times}", ""
        above, primes = (r"\prime" * len(primes) + above, "") if above else (above, primes)
        power = f"^{{{above}}}" if len(above) > 1 else f"^{above}" if above else ""
        return f"{letter}{place}{primes}{power}"


def _plain(letter: str) -> str:
    """A letter that is not bold."""
    return re.sub(rf"{BOLD}\{{(.*)\}}", r"\1", letter)


def _scripts(scripts: str) -> tuple[str, str]:
    """What stands below and above, without braces; what cannot be told apart stays above."""
    found = {"_": "", "^": ""}
    for kind, text in re.findall(rf"([_^])({SCRIPT})", scripts):
        found[kind] += text[1:-1] if text.startswith("{") else text
    return found["_"], found["^"]


def _split(written: str) -> tuple[str, str]:
    """The letter and the subscript of what a table writes."""
    match = LETTER.fullmatch(written)
    assert match is not None, written
    below = match["below"] or ""
    return match["letter"], below[1:-1] if below.startswith("{") else below


# ---------------------------------------------------------------------------------------- reading one


def names() -> list[str]:
    """The notations that there are."""
    return sorted(path.stem for path in FOLDER.glob("*.toml"))


def notation(given: str) -> Notation:
    """A notation by its name or from a TOML file; raises UsageError, one line with file, key, fault and remedy."""
    path = FOLDER / f"{given}.toml" if given in names() else Path(given)
    shown = one_line(given)
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError):
        known = ", ".join(names())
        raise UsageError(f"--notation {shown}: there is no such file and no such name; choose {known}") from None
    except tomllib.TOMLDecodeError as error:
        raise UsageError(f"{shown}: is not valid TOML ({one_line(str(error))}); mend that place") from None
    _check(shown, table)
    return Notation(given, table.get(TABLE, {}), **{k: v for k, v in table.items() if k not in (TABLE, "about")})


def _check(file: str, table: Mapping[str, Any]) -> None:
    known = (*TEXTS, *CHOICES, TABLE)
    for key, value in table.items():
        if key not in known:
            near = get_close_matches(key, known, 1)
            remedy = f"did you mean {near[0]}?" if near else f"there are {', '.join(known)}"
            raise UsageError(f"{file}: {one_line(key)}: unknown key; {remedy}")
        if key in CHOICES and value not in CHOICES[key]:
            raise UsageError(f"{file}: {key}: {one_line(repr(value))} is no choice; write {' or '.join(CHOICES[key])}")
        if key in TEXTS and not isinstance(value, str):
            raise UsageError(f"{file}: {key}: is no text; put it in quotes")
        if key == TABLE and not isinstance(value, dict):
            raise UsageError(f"{file}: {key}: is no table; write [letters] with a line for each letter")
    for source, target in table.get(TABLE, {}).items():
        for text in (source, target):
            if not isinstance(text, str) or not LETTER.fullmatch(text):
                raise UsageError(
                    f"{file}: letters.{one_line(source)}: {one_line(repr(text))} is no letter; "
                    r"write a letter in LaTeX, with a subscript if need be, as '\mathbf{v}_O'"
                )


# -------------------------------------------------------------------------------------- a document


def respelled(document: Document, chosen: Notation, signals: Iterable[NamedSignal]) -> Document:
    """The document in a notation; raises UsageError where two of its symbols would look alike."""
    if not chosen.changes:
        return document
    chosen = replace(chosen, shapes=_vectors(document))
    entries = dict(_entries(chosen, signals))
    _check_distinct(document, chosen)
    sections = tuple(replace(s, items=[_item(item, chosen, entries) for item in s.items]) for s in document.sections)
    return replace(document, sections=sections)


def _vectors(document: Document) -> Vectors:
    """What the shapes in the table of symbols say of bold letters."""
    out: dict[str, dict[str, bool]] = {}
    tables = (item for s in document.sections if s.title == SYMBOLS for item in s.items)
    for item in (table for table in tables if isinstance(table, DocumentTable) and "shape" in table.head):
        for row in item.rows:
            shape = row[item.head.index("shape")]
            match = SYMBOL.fullmatch(row[0].strip("$"))
            if match and match["letter"] and re.match(BOLD, match["letter"]):
                below, _ = _scripts(match["scripts"])
                out.setdefault(match["letter"], {})[below] = shape not in (NONE, "$1$") and r"\times" not in shape
    return out


def _entries(chosen: Notation, signals: Iterable[NamedSignal]) -> Iterator[tuple[Symbol, Symbol]]:
    """The entries of vectors and matrices whose letter is another: as in the paper, as here."""
    for signal in signals:
        other = replace(signal, display=replace(chosen, vectors="bold", rates="dot").formula(signal.display, {}))
        if other.display != signal.display and re.match(BOLD, signal.display):
            for index, _ in signal.labels():
                before, after = (SYMBOL.fullmatch(entry(of, index)) for of in (signal, other))
                if before and after:
                    below = [_scripts(match["scripts"])[0] for match in (before, after)]
                    yield (before["letter"], below[0]), (_accented(after, before), below[1])


def _accented(after: re.Match[str], before: re.Match[str]) -> str:
    """The letter of an entry with the accents that the table gives it."""
    own = after["accents"].removeprefix(before["accents"])
    return own + after["letter"] + "}" * own.count("{")


def _check_distinct(document: Document, chosen: Notation) -> None:
    plain = replace(chosen, rates="dot", skew="tilde", transpose=r"\top")
    seen: dict[str, str] = {}
    for text in _formulas(document):
        for match in SYMBOL.finditer(text):
            if match["letter"] and re.match(BOLD, match["letter"]):
                below, _ = _scripts(match["scripts"])
                index = (f"_{{{below}}}" if len(below) > 1 else f"_{below}") if below else ""
                source = match["letter"] + index
                target = plain.formula(source, {})
                other = seen.setdefault(target, source)
                if other != source:
                    raise UsageError(
                        f"{one_line(chosen.name)}: letters: {other} and {source} would both be written {target}; "
                        "give one of them another letter"
                    )


def _formulas(document: Document) -> Iterator[str]:
    for section in document.sections:
        for item in section.items:
            match item:
                case Display():
                    yield from (cell for row in item.formula for cell in row)
                case StepEquation():
                    yield from (cell for row in (*item.step.formula, *item.step.components) for cell in row)
                case DocumentTable():
                    yield from (
                        piece for row in item.rows for cell in row for piece in re.findall(r"\$([^$]*)\$", cell)
                    )
                case DrawingItem():
                    for label in item.drawing.labels:
                        yield from re.findall(r"\$([^$]*)\$", label.text)
                case Paragraph() | Heading():
                    yield from re.findall(r"\$([^$]*)\$", item.text)


def _item(item: Item, chosen: Notation, entries: Entries) -> Item:
    def text(of: str) -> str:
        return re.sub(r"\$([^$]*)\$", lambda m: f"${chosen.formula(m[1], entries)}$", of)

    def rows(of: Formula) -> Formula:
        return fitted(tuple(tuple(chosen.formula(cell, entries) for cell in row) for row in of))

    match item:
        case Display():
            return replace(item, formula=rows(item.formula))
        case StepEquation():
            formula, components, alone = map(rows, (item.step.formula, item.step.components, item.step.alone))
            step = replace(item.step, formula=formula, components=components, alone=alone)
            return replace(item, step=step, meaning=text(item.meaning), frame=text(item.frame))
        case DrawingItem():
            return replace(item, drawing=item.drawing.respelled(text), caption=text(item.caption))
        case DocumentTable():
            return replace(item, rows=tuple(tuple(map(text, row)) for row in item.rows))
        case NumberedLine():
            return replace(item, formula=rows(item.formula), about=text(item.about))
    return replace(item, text=text(item.text))
