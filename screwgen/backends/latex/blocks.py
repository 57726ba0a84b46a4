"""Matrices that are wider than the page, as named blocks: one for each pair of directions of the modes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ...ir.block import NamedSignal
from .layout import PAGE, Formula, columns, equation, matrix, width
from .scalars import Scalars, entry, subscripted

Parts = Sequence[tuple[str, int]]
"""The directions of the modes of a link in their order: the letter of each, and how many modes it has."""
LETTERS = {
    "axial": "x",
    "bending_y": "y",
    "bending_z": "z",
    "torsion": r"\theta",
    "shear_y": r"\gamma_y",
    "shear_z": r"\gamma_z",
}
TWIST: Parts = ((r"\omega", 3), ("v", 3))
"""The halves of a twist's rows."""


@dataclass(frozen=True)
class Span:
    """Rows or columns of a matrix that belong together; the letter is empty if they are all there are."""

    letter: str
    first: int
    size: int

    @property
    def slice(self) -> slice:
        return slice(self.first, self.first + self.size)


def by_blocks(
    signal: NamedSignal, entries: np.ndarray, write: Scalars, parts: Parts, shown: Callable[[np.ndarray], str]
) -> tuple[str, Formula]:
    """The matrix of blocks, and their equations below; ("", ()) where there are none or a block is too wide.

    ``shown`` writes the entries of a block.
    """
    rows, cols = (_spans(signal, dimension, parts) for dimension in (0, 1))
    if len(rows) * len(cols) == 1:
        return "", ()
    alike = entries.shape[0] == entries.shape[1] and bool((entries == entries.T).all())
    cells: list[list[str]] = []
    below: list[Formula] = []
    for i, row in enumerate(rows):
        cells.append([])
        for j, col in enumerate(cols):
            block = entries[row.slice, col.slice]
            if not any(value != 0 for value in block.flat):
                cells[-1].append("0" if block.shape == (1, 1) else r"\mathbf{0}")
            elif alike and j < i and block.shape != (1, 1):
                cells[-1].append(_transposed(_name(signal, col, row)))
            elif block.shape == (1, 1):
                name = entry(signal, (row.first, col.first))
                cells[-1].append(name)
                if name != write(block.item()) and not (alike and j < i):
                    below.append(equation(name, write.terms(block.item())))
            else:
                cells[-1].append(_name(signal, row, col))
                below.append(((cells[-1][-1], f"= {shown(block)}"),))
    whole = matrix(cells)
    if width(whole) > PAGE - 8.0 or any(width(" ".join(line)) > PAGE for formula in below for line in formula):
        return "", ()
    return whole, columns(below)


def _name(signal: NamedSignal, row: Span, col: Span) -> str:
    letters = [span.letter for span in (row, col) if span.letter]
    joint = "," if any(len(letter) > 1 and letter != LETTERS["torsion"] for letter in letters) else ""
    return subscripted(signal.display, joint.join(letters), bold=True)


def _transposed(name: str) -> str:
    r"""A name with \top; one that has a superscript becomes a group, for LaTeX sets no second one beside it."""
    return rf"{{{name}}}^{{\top}}" if "^" in name else rf"{name}^{{\top}}"


def _spans(signal: NamedSignal, dimension: int, parts: Parts) -> list[Span]:
    """How the rows or the columns of a matrix fall into parts."""
    size = signal.shape[dimension]
    axes = size == 3 and signal.frame != "-" and dimension not in signal.numbered
    modal = not axes and size == sum(count for _, count in parts) and len(parts) > 1
    chosen = parts if modal else TWIST if size == 6 else [("", size)]
    out: list[Span] = []
    for letter, count in chosen:
        out.append(Span(letter, sum(span.size for span in out), count))
    return out
