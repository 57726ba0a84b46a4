"""The content of a document, independent of its format: sections of text, formulas, steps and tables.

Text is a small markup: ``$...$`` is a formula, backquotes are code, the rest is plain.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import ClassVar

from ...ir.block import Binding, Block
from .drawing import Drawing
from .layout import Formula
from .steps import BlockView, StepView

CITATION = (
    "S. Yaqubi, A. Kitzinger, A. Müller, H. Gattringer, J. Mattila: Screw-Theoretic PDE-Based Synthesis for Unified "
    "Representation of Multibody Flexible Manipulator Dynamics, 2026, arXiv:2601.16242v3"
)
"""The paper whose equations carry the numbers."""


@dataclass(frozen=True)
class Paragraph:
    kind: ClassVar[str] = "paragraph"
    text: str
    essential: bool = False
    """Whether the shortest level of a page shows it."""
    repeats: bool = False
    """Whether it only says what other items say."""
    sought: str = ""
    """The words by which the search of a page finds it before others."""


@dataclass(frozen=True)
class Display:
    kind: ClassVar[str] = "display"
    formula: Formula
    essential: bool = False
    link: int = 0
    """The number of the one link whose torques it says; 0 if it says none."""
    sought: str = ""
    """The words by which the search of a page finds it before others."""


@dataclass(frozen=True)
class Heading:
    kind: ClassVar[str] = "heading"
    text: str


@dataclass(frozen=True)
class StepEquation:
    """A step of a derivation."""

    kind: ClassVar[str] = "equation"
    step: StepView
    meaning: str
    unit: str
    frame: str


@dataclass(frozen=True)
class DocumentTable:
    """Cells are text; ``widths`` are the columns' shares of the page."""

    kind: ClassVar[str] = "table"
    head: tuple[str, ...]
    widths: tuple[float, ...]
    rows: tuple[tuple[str, ...], ...]
    essential: bool = False
    repeats: bool = False
    """Whether it only says what other items say."""

    @property
    def is_prose(self) -> bool:
        """Whether some of its several columns have sentences: on a narrow page such rows are set as paragraphs."""
        return len(self.head) > 3 and any(len(_plain_words(cell)) > WORDS for row in self.rows for cell in row)


def _plain_words(cell: str) -> list[str]:
    """The words of a cell but for its formulas."""
    return re.sub(r"\$[^$]*\$", "", cell).split()


@dataclass(frozen=True)
class DrawingItem:
    """A drawing with its caption."""

    kind: ClassVar[str] = "figure"
    drawing: Drawing
    caption: str
    essential: bool = False


@dataclass(frozen=True)
class NumberedLine:
    """A line of an algorithm as it is printed, with the meaning of what it defines; without one where it is long."""

    kind: ClassVar[str] = "line"
    number: str
    formula: Formula
    about: str


Item = Paragraph | Display | Heading | StepEquation | DocumentTable | DrawingItem | NumberedLine


@dataclass
class DocumentSection:
    """A numbered part of a document."""

    title: str
    items: list[Item] = field(default_factory=list)
    link_class: int = 0
    """The number of the class of links that it is about; 0 if it is about none."""
    appendix: bool = False
    """Whether it has further forms of the equations, which the algorithm does not need."""


SYMBOLS, PARAMETERS, MODES = "Symbols", "Parameters", "Modes in numbers"
"""The titles of the tables in which readers look things up."""

Named = tuple[str, str, str, str, str, Binding | None]
"""A symbol of the text: LaTeX, meaning, unit, shape, frame, binding."""


@dataclass(frozen=True)
class Chapter:
    """What a plug-in adds to a document: sections, the blocks that they show, and the symbols of their text."""

    sections: tuple[DocumentSection, ...]
    views: tuple[tuple[Block, BlockView], ...] = ()
    symbols: tuple[Named, ...] = ()


@dataclass(frozen=True)
class Document:
    name: str
    version: str
    sections: tuple[DocumentSection, ...]
    title: str = ""

    @property
    def heading(self) -> str:
        """The title: of a robot's document it is made from the robot's name."""
        return self.title or f"Equations of motion of `{self.name}`"


def parse(prose: str) -> list[Item]:
    """Paragraphs, ``## headings`` and ``$$`` displays, with empty lines between them; ``!`` before essential ones."""
    chunks = [chunk.strip() for chunk in re.split(r"\n\s*\n", prose)]
    return [_item(chunk) for chunk in chunks if chunk]


def _item(chunk: str) -> Item:
    if chunk.startswith("## "):
        return Heading(chunk[3:])
    essential, chunk = chunk.startswith("!"), chunk.removeprefix("!").lstrip()
    if chunk.startswith("$$"):
        lines = chunk.removeprefix("$$").removesuffix("$$").strip().split("\n")
        return Display(tuple(split_row(line.strip()) for line in lines), essential)
    return Paragraph(" ".join(chunk.split("\n")), essential)


def split_row(line: str) -> tuple[str, ...]:
    """The cells of a row: ``&`` inside an environment belongs to that environment."""
    cells, depth = [""], 0
    for part in re.split(r"(\\begin\{\w+\}|\\end\{\w+\}|&)", line):
        depth += part.startswith(r"\begin") - part.startswith(r"\end")
        if part == "&" and depth == 0:
            cells.append("")
        else:
            cells[-1] += part
    return tuple(cell.strip() for cell in cells)


# ---------------------------------------------------------------------------------------------- words

WORDS = 2
"""A cell of more words has a sentence."""
_LETTERS = {
    "M*": r"\mathbf{M}^*",
    "H*": r"\mathbf{H}^*_i",
    "h_MD": r"\mathbf{h}_{M_D,i}",
    "F_{i+1}": r"\mathcal{F}_{i+1}",
    "F_i": r"\mathcal{F}_i",
    "F_j": r"\mathcal{F}_j",
    "F_k": r"\mathcal{F}_k",
    "R_oi^T g": r"\mathbf{R}_{oi}^{\top}\mathbf{g}",
    "R_oT^T g": r"\mathbf{R}_{oT}^{\top}\mathbf{g}",
    "etaddot": r"\ddot{\boldsymbol{\eta}}",
}
_MATHEMATICS = re.compile(
    "|".join(map(re.escape, _LETTERS)) + r"|(?P<symbol>\b[uc]_?[xyz\d]'*(?!\w))"
    r"|(?P<unit>kg\*m\^2|N\*m(?:\*s)?(?:/rad)?)|(?P<marked>\$[^$]*\$)"
)


def words(meaning: str) -> str:
    """The words of a signal, with their mathematics marked."""
    return _MATHEMATICS.sub(_marked, meaning)


def _marked(match: re.Match) -> str:
    if match["marked"]:
        return match["marked"]
    if match["unit"]:
        return f"${_unit(match['unit'])}$"
    if match["symbol"]:
        letter, place, primes = re.findall(r"^([uc])_?(\w)('*)$", match["symbol"])[0]
        return f"${letter}_{place}{primes}$"
    return f"${_LETTERS[match[0]]}$"


def unit(text: str) -> str:
    """The unit of a signal as text with formulas: ``kg*m^2``."""
    return "" if text in ("", "-") else ", ".join(f"${_unit(u)}$" for u in text.split(", "))


def _unit(text: str) -> str:
    if text == "-":
        return "1"
    above, _, below = text.replace("(", "").replace(")", "").partition("/")
    side = lambda s: r"\,".join(_powered(f) for f in s.split("*"))  # noqa: E731
    return side(above) + (f"/{side(below)}" if below and "*" not in below else rf"/({side(below)})" if below else "")


def _powered(factor: str) -> str:
    base, _, exponent = factor.partition("^")
    return (base if base.isdigit() else rf"\mathrm{{{base}}}") + (f"^{{{exponent}}}" if exponent else "")


def frame(text: str) -> str:
    return "" if text == "-" else words(text)


def equation(step: StepView) -> StepEquation:
    return StepEquation(step, words(step.meaning), unit(step.unit), frame(step.frame))
