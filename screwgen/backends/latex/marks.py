"""Symbols in the formulas of a page, marked with the number of their row in the table of symbols."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from xml.etree import ElementTree

from . import mathml

Element = ElementTree.Element
FORMULA = re.compile(r"<math>.*?</math>", re.DOTALL)
SCRIPTED = {"msub", "msup", "msubsup", "mover", "munder", "munderover"}
SYMBOL, ENTRY, LINK = "data-s", "data-e", "data-l"
Entries = Mapping[str, tuple[str, tuple[int, int]]]
"""By the LaTeX of an entry: the LaTeX of its symbol, and its row and column."""
Instances = Mapping[str, tuple[str, str]]
"""By the LaTeX of a symbol with the number of a link: the LaTeX with the index i, and the link's name."""


class Marks:
    """Marks what a page shows of the symbols whose LaTeX is given, and of their entries; a mark is a symbol's place
    in the list, and of an entry its row and column, of a symbol of one link the link.
    """

    def __init__(self, symbols: Sequence[str], entries: Entries | None = None, instances: Instances | None = None):
        self.symbols, self.entries, self.instances = symbols, entries or {}, instances or {}
        self._done: dict[str, str] = {}

    @cached_property
    def _known(self) -> dict[tuple[str, ...], dict[str, str]]:
        """The marks by the elements that are marked."""
        out: dict[tuple[str, ...], dict[str, str]] = {}
        number_of = {symbol: number for number, symbol in enumerate(self.symbols)}
        for symbol, number in number_of.items():
            for written in (symbol, *([f"{symbol[:-2]}_{{T,i}}"] if symbol.endswith("_T") else [])):
                out.setdefault(tuple(map(_plain, _parts(written))), {SYMBOL: str(number)})
        for entry, (symbol, (i, j)) in self.entries.items():
            if symbol in number_of:
                mark = {SYMBOL: str(number_of[symbol]), ENTRY: f"{i},{j}"}
                out.setdefault(tuple(map(_plain, _parts(entry))), mark)
        for text, (symbol, link) in self.instances.items():
            mark = {SYMBOL: str(number_of[symbol]), LINK: link}
            out.setdefault(tuple(map(_plain, _parts(text))), mark)
        return out

    @cached_property
    def _several(self) -> dict[str, list[int]]:
        """By its first element, of how many elements a symbol consists that has several; the longest first."""
        out: dict[str, set[int]] = {}
        for first, *others in self._known:
            if others:
                out.setdefault(first, set()).add(1 + len(others))
        return {first: sorted(sizes, reverse=True) for first, sizes in out.items()}

    def __call__(self, page: str) -> str:
        """HTML with its formulas marked."""
        return FORMULA.sub(lambda match: self._formula(match[0]), page)

    def _formula(self, text: str) -> str:
        if text not in self._done:
            root = ElementTree.fromstring(text)
            self._children(root)
            mathml.shorten(root)
            self._done[text] = ElementTree.tostring(root, encoding="unicode").replace(" />", "/>")
        return self._done[text]

    def _children(self, parent: Element) -> None:
        """Marks below an element; letters in indices are no symbols of their own."""
        place = 0
        while place < len(parent):
            first = 1 if parent.tag in SCRIPTED else len(parent)
            if place >= first:
                return
            size = self._run(parent, place) if parent.tag not in SCRIPTED else 0
            if not size and not self._one(parent[place]):
                self._children(parent[place])
            place += 1

    def _run(self, parent: Element, place: int) -> int:
        """Puts several elements that are one symbol into a group, such as a modulus times a moment."""
        for size in self._several.get(_plain(parent[place]), ()):
            mark = self._known.get(tuple(_plain(e) for e in parent[place : place + size]))
            if mark is not None:
                group = ElementTree.Element("mrow", dict(mark))
                group.extend(list(parent[place : place + size]))
                parent[place : place + size] = [group]
                return size
        return 0

    def _one(self, element: Element) -> bool:
        for form in _forms(element):
            if (mark := self._known.get((form,))) is not None:
                element.attrib.update(mark)
                return True
        return False


def _parts(symbol: str) -> list[Element]:
    """The elements of a symbol, without groups around all of them."""
    root = ElementTree.fromstring(mathml.inline(symbol))
    while len(root) == 1 and root[0].tag == "mrow":
        root = root[0]
    return list(root)


def _plain(element: Element) -> str:
    """The text of an element's tags without attributes, padding and groups of one."""
    if element.tag in ("mpadded", "mrow") and len(element) == 1:
        return _plain(element[0])
    inside = "".join(map(_plain, element)) or (element.text or "").strip()
    return f"<{element.tag}>{inside}</{element.tag}>"


def _forms(element: Element) -> Iterator[str]:
    """How a symbol is written: as it stands, without its superscript, without dots and tildes above."""
    yield _plain(element)
    if element.tag in ("mpadded", "mrow") and len(element) == 1:
        element = element[0]
    base = _bare(element[0]) if len(element) else ""
    if element.tag == "msub":
        yield f"<msub>{base}{_plain(element[1])}</msub>"
    elif element.tag == "msubsup":
        yield f"<msub>{_plain(element[0])}{_plain(element[1])}</msub>"
        yield f"<msub>{base}{_plain(element[1])}</msub>"
    elif element.tag == "mover":
        yield base


def _bare(element: Element) -> str:
    """A letter without what stands above it."""
    while (element.tag in ("mpadded", "mrow") and len(element) == 1) or element.tag == "mover":
        element = element[0]
    return _plain(element)
