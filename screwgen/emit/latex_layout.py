"""Fitting formulas to a page: how wide a formula is, and where it is broken.

A formula is a list of rows, a row a list of cells that are aligned right, left, right, left ...
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

Row = tuple[str, ...]
Formula = tuple[Row, ...]

PAGE = 42.0
"""Width of the text in em."""

TOKEN = re.compile(r"\\begin\{\w+\*?\}|\\end\{\w+\*?\}|\\[A-Za-z]+|\\.|.", re.DOTALL)
WIDE = {r"\qquad": 2.0, r"\quad": 1.0, r"\,": 0.17, r"\;": 0.28, r"\ ": 0.33, r"\int": 1.0, r"\exp": 1.6, r"\cos": 1.5,
        r"\sin": 1.4, r"\tan": 1.5, r"\cosh": 2.0, r"\sinh": 1.9, r"\cdots": 1.3, r"\times": 1.2, r"\sqrt": 0.8}
NOTHING = {r"\left", r"\right", r"\mathbf", r"\boldsymbol", r"\dot", r"\ddot", r"\tilde", r"\widetilde", r"\mathrm",
           r"\operatorname", r"\text", r"\mathcal", r"\bar", r"\limits", r"\!", r"\displaystyle"}
FRACTIONS = {r"\frac", r"\tfrac", r"\dfrac"}


def width(tex: str) -> float:
    """About how wide a formula is, in em."""
    return _Measure(tex).row()


class _Measure:
    """Reads LaTeX from left to right and adds up what is seen."""

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
                script = max(script, 0.75 * self.atom())
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


def _character(token: str) -> float:
    if token.startswith("\\"):
        return 0.65
    if token in "+-=":
        return 1.25
    if token.isdigit():
        return 0.5
    if token.isupper():
        return 0.8
    return 0.33 if token in ",.|()[]/'!" else 0.55


# ------------------------------------------------------------------------------------------ breaking


def equation(left: str, *sides: Sequence[str]) -> Formula:
    """``left = terms = terms ...``: on one line if it fits, else broken at equals signs, then at terms."""
    whole = " = ".join([left, *(" ".join(terms) for terms in sides)])
    if width(whole) <= PAGE:
        head, *rest = whole.split(" = ", 1) if sides else [whole]
        return ((head, f"= {rest[0]}"),) if rest else ((head, ""),)
    rows: list[Row] = []
    room = PAGE - width(left) - 2.0
    for terms in sides:
        for i, line in enumerate(fill(terms, room)):
            rows.append((left if not rows else "", f"= {line}" if i == 0 else rf"\quad {line}"))
    return tuple(rows)


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


def columns(equations: Sequence[Formula]) -> Formula:
    """Many equations side by side where they are short; a long one keeps its lines."""
    short = [e for e in equations if len(e) == 1]
    if len(short) < len(equations) or len(short) < 2:
        return tuple(row for e in equations for row in e)
    across = max(1, int(PAGE / (max(width(" ".join(row)) for (row,) in short) + 2.0)))
    across = min(across, 4)
    return tuple(_joined(group) for group in _groups([row for (row,) in short], across))


def _groups(rows: list[Row], size: int) -> Iterator[list[Row]]:
    """Column by column, so that neighbours stand below each other only where there is one column."""
    for start in range(0, len(rows), size):
        yield rows[start : start + size]


def _joined(rows: list[Row]) -> Row:
    first, *others = rows
    return (*first, *(cell for head, *tail in others for cell in (rf"\qquad {head}", *tail)))


def matrix(entries: Sequence[Sequence[str]]) -> str:
    """A matrix of formulas in brackets."""
    rows = r" \\ ".join(" & ".join(row) for row in entries)
    return rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"
