"""Lines that have become too long, broken where structure allows: at top-level equals signs, then at + and -.

What stands in braces, in brackets or in a matrix is never torn.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from .layout import PAGE, TOKEN, Formula, Row, equation, fill, width

OPENING = ("{", "(", "[", r"\left", r"\begin{")
CLOSING = ("}", ")", "]", r"\right", r"\end{")


def fitted(formula: Formula) -> Formula:
    """The formula with rows of ``left = right`` that are wider than the page broken; other rows as they are."""
    return tuple(line for row in formula for line in _lines(row))


def _lines(row: Row) -> Iterator[Row]:
    if len(row) != 2 or width(" ".join(row)) <= PAGE:
        yield row
        return
    left, right = row
    if right.startswith("= "):
        yield from equation(left, *map(terms, split(right.removeprefix("= "), "=")))
    else:
        indent = r"\quad" if right.startswith(r"\quad") else ""
        lines = fill(terms(right.removeprefix(r"\quad").strip()), PAGE - width(left) - 2.0)
        yield from ((left if i == 0 else "", f"{indent} {line}".strip()) for i, line in enumerate(lines))


def terms(text: str) -> list[str]:
    """The terms of a sum with their signs: at the top level, in no bracket, fraction or matrix."""
    parts = split(text, "+-")
    return [part for part in parts if part]


def split(text: str, signs: str) -> list[str]:
    """``text`` cut before each of ``signs`` (``=`` itself is left out) that stands between blanks at the top level."""
    parts, depth, at = [""], 0, 0
    for token in re.findall(TOKEN, text):
        before = text[at - 1 : at]
        at += len(token)
        if token.startswith(CLOSING[-1]) or token in CLOSING:
            depth -= 1
        elif token.startswith(OPENING[-1]) or token in OPENING:
            depth += 1
        if depth == 0 and token in signs and before == " " and text[at : at + 1] == " ":
            parts.append("" if token == "=" else token)
        else:
            parts[-1] += token
    return [part.strip() for part in parts]
