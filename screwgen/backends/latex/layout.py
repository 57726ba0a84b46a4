"""The layout of formulas: their width, and where they are broken.

A formula is a list of rows, a row a list of cells that are aligned right, left, right, left ...
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache

Row = tuple[str, ...]
Formula = tuple[Row, ...]

PAGE = 42.0
"""Width of the text in em."""

TALL = 12
"""Of a matrix with more rows or columns than that only the first and the last ones are shown."""

TOKEN = re.compile(r"\\begin\{\w+\*?\}|\\end\{\w+\*?\}|\\[A-Za-z]+|\\.|.", re.DOTALL)
WIDE = {
    r"\qquad": 2.0,
    r"\quad": 1.0,
    r"\,": 0.17,
    r"\;": 0.28,
    r"\ ": 0.33,
    r"\int": 1.0,
    r"\exp": 1.6,
    r"\cos": 1.7,
    r"\sin": 1.6,
    r"\tan": 1.5,
    r"\cosh": 2.0,
    r"\sinh": 1.9,
    r"\cdots": 1.3,
    r"\times": 1.2,
    r"\sqrt": 0.8,
}
NOTHING = {
    r"\left",
    r"\right",
    r"\mathbf",
    r"\boldsymbol",
    r"\dot",
    r"\ddot",
    r"\tilde",
    r"\widetilde",
    r"\mathrm",
    r"\operatorname",
    r"\text",
    r"\mathcal",
    r"\bar",
    r"\limits",
    r"\!",
    r"\displaystyle",
}
SPACE = 0.06
"""Behind every index."""
FRACTIONS = {r"\frac", r"\tfrac", r"\dfrac"}


@lru_cache(maxsize=20000)
def width(tex: str) -> float:
    """About how wide a formula is, in em."""
    return _Measure(tex).row()


class _Measure:
    """Reads LaTeX from left to right and adds up the widths."""

    def __init__(self, tex: str):
        self.tokens = [t for t in TOKEN.findall(tex) if not t.isspace()]
        self.at = 0

    def row(self) -> float:
        """The width up to the end of the group, cell or line."""
        total = script = 0.0
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            if token in ("}", "&", r"\\") or token.startswith(r"\end{"):
                break
            if token in ("_", "^"):
                self.at += 1
                script = max(script, 0.75 * self.atom() + SPACE)
                continue
            total, script = total + script, 0.0
            total += self.atom()
        return total + script

    def atom(self) -> float:
        token = self.tokens[self.at]
        self.at += 1
        if token == "{":
            inner = self.row()
            self.at += 1
            return inner
        if token.startswith(r"\begin{"):
            return self.matrix()
        if token in FRACTIONS:
            return max(self.atom(), self.atom()) * (0.75 if token == r"\tfrac" else 1.0) + 0.25
        if token in NOTHING:
            return 0.0
        return WIDE.get(token, _character(token))

    def matrix(self) -> float:
        columns: list[float] = []
        column = 0
        while not self.tokens[self.at].startswith(r"\end{"):
            cell = self.row()
            columns[column : column + 1] = [max([cell, *columns[column : column + 1]])]
            if self.tokens[self.at] in ("&", r"\\"):
                column = column + 1 if self.tokens[self.at] == "&" else 0
                self.at += 1
        self.at += 1
        return sum(columns) + max(len(columns) - 1, 0) + 1.0


@cache
def _character(token: str) -> float:
    if token.startswith("\\"):
        return 0.65
    if token in "+-=":
        return 1.25
    if token.isdigit():
        return 0.5
    if token.isupper():
        return 0.8
    if token in "()":
        return 0.4
    return 0.33 if token in ",.|[]/'!" else 0.55


# ------------------------------------------------------------------------------------------ breaking


def equation(left: str, *sides: Sequence[str]) -> Formula:
    """``left = terms = terms ...``: on one line if it fits, else broken at equals signs, then at terms."""
    whole = " = ".join(" ".join(terms) for terms in sides)
    if not sides or width(f"{left} = {whole}") <= PAGE:
        return ((left, f"= {whole}" if sides else ""),)
    rows: list[Row] = []
    room = PAGE - width(left) - 2.0
    for terms in sides:
        for i, line in enumerate(fill(terms, room)):
            rows.append((left if not rows else "", f"= {line}" if i == 0 else rf"\quad {line}"))
    return tuple(rows)


def one_line(formula: Formula) -> str:
    """A formula without its breaks."""
    return " ".join(cell.removeprefix(r"\quad ") for row in formula for cell in row if cell)


def fill(terms: Sequence[str], room: float) -> list[str]:
    """Terms on as few lines as hold them."""
    lines: list[str] = []
    for term in terms:
        longer = f"{lines[-1]} {term}" if lines else term
        if lines and width(longer) <= room:
            lines[-1] = longer
        else:
            lines.append(term)
    return lines


def columns(first: Sequence[Formula], last: Sequence[Formula] = ()) -> Formula:
    """Many equations, side by side if they are short, with dots between the first and the last."""
    count = across([*first, *last])
    rows = tuple(_grouped([row for e in first for row in e], count))
    if not last:
        return rows
    return (*rows, ("", r"\;\;\vdots"), *_grouped([row for e in last for row in e], count))


def across(equations: Sequence[Formula]) -> int:
    """How many of the equations fit beside each other: one if any of them takes more than a line."""
    if any(len(e) > 1 for e in equations):
        return 1
    left, right = (max(width(e[0][side]) for e in equations) for side in (0, 1))
    return max(1, min(4, int(PAGE / (left + right + 2.0))))


def _grouped(rows: list[Row], size: int) -> Iterator[Row]:
    for start in range(0, len(rows), size):
        yield _joined(rows[start : start + size])


def _joined(rows: list[Row]) -> Row:
    first, *others = rows
    return (*first, *(cell for head, *tail in others for cell in (rf"\qquad {head}", *tail)))


def matrix(entries: Sequence[Sequence[str]]) -> str:
    """A matrix of formulas in brackets."""
    rows = r" \\ ".join(" & ".join(row) for row in entries)
    return rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"


def abridged(size: int) -> list[int | None]:
    """The rows or columns of a matrix that are shown; None stands for those that are not."""
    return list(range(size)) if size <= TALL else [0, 1, 2, None, size - 1]


def dots(row: int | None, column: int | None) -> str:
    """What stands for entries that are not shown."""
    return r"\ddots" if row is None and column is None else r"\vdots" if row is None else r"\cdots"
