"""The texts of labels: their pieces on and below the line, for SVG, and the room that they take."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple
from xml.etree import ElementTree

from . import mathml
from .drawing import Point
from .text import PIECES

SIZES = {"link": 12.0, "frame": 12.0, "loop": 12.5}
"""The size of the letters of labels by their look, px."""
USUAL = 14.0
SMALLER = 0.72
"""The size of what stands below the line, over that on it."""
DROP = 0.28
"""How far it stands below, over the size of the letters."""
HIGH = 1.15
"""The height of a line over the size of its letters."""
WIDE, CAPITAL, MONO, NARROW = 0.62, 0.75, 0.61, 0.36
"""Widths of characters over their size: of small letters and digits, of capitals, of code, of narrow ones."""
THIN = set("iljt.,;:'|!()[]I 1")


class LetterRun(NamedTuple):
    """A piece of a label in one style."""

    text: str
    style: str
    """``code``, ``math`` (italic), ``sign`` (upright, of a formula) or ``plain``."""
    level: int
    """1 below the line, -1 above it."""


def size(look: str) -> float:
    """The size of the letters of a label, px."""
    return SIZES.get(look, USUAL)


def runs(text: str) -> Iterator[LetterRun]:
    """The pieces of a text in the markup of documents."""
    for piece in filter(None, PIECES.split(text)):
        if piece.startswith("$"):
            yield from _spaced(list(_formula(ElementTree.fromstring(mathml.inline(piece[1:-1])), 0)))
        elif piece.startswith("`"):
            yield LetterRun(piece[1:-1], "code", 0)
        else:
            yield LetterRun(piece, "plain", 0)


def _spaced(formula: list[LetterRun]) -> Iterator[LetterRun]:
    """The letters of a formula with room around the signs that join two terms, and behind commas."""
    before = "="
    for run in formula:
        joins = run.text == "=" or (run.text in "+-\u2212" and before != "=")
        text = f" {run.text} " if joins else ", " if run.text == "," else run.text
        yield run if run.level else run._replace(text=text)
        before = run.text


LEVELS = {"msub": (0, 1), "msup": (0, -1), "msubsup": (0, 1, -1)}


def _formula(element: ElementTree.Element, level: int) -> Iterator[LetterRun]:
    """The letters of MathML in a line."""
    if element.tag in ("mi", "mn", "mo", "mtext"):
        text = (element.text or "").strip() or " "
        italic = element.tag == "mi" and len(text) == 1 and element.get("mathvariant") != "normal"
        yield LetterRun(text, "math" if italic else "sign", level)
        return
    for place, child in enumerate(element):
        yield from _formula(child, level or LEVELS.get(element.tag, (0,) * len(element))[place])


def measured(text: str, look: str) -> Point:
    """Width and height of the box that a label fills, px, ample."""
    letters = size(look)
    width = sum(_width(run) * letters * (SMALLER if run.level else 1.0) for run in runs(text))
    return round(width + 2.0, 1), round(HIGH * letters, 1)


def _width(run: LetterRun) -> float:
    if run.style == "code":
        return MONO * len(run.text)
    return sum(map(_wide, run.text))


def _wide(c: str) -> float:
    """The width of a character over the size of the letters."""
    if c in THIN:
        return NARROW
    if c > "\u2000":
        return 1.0
    return WIDE if c.islower() or c.isdigit() else CAPITAL
