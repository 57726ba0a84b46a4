"""Formulas as MathML: latex2mathml for each cell, and tables of cells for what is aligned."""

from __future__ import annotations

import re
from functools import cache

from latex2mathml.converter import convert

from .latex_layout import Formula

BOLD_GREEK, BOLD_ITALIC_GREEK = 0x1D6A8, 0x1D736
"""Where the bold Greek letters start in Unicode, capital and upright, or small and italic."""

SCRIPT, BOLD_SCRIPT = 0x1D49C, 0x1D4D0


def inline(tex: str) -> str:
    """A formula in a line of text."""
    return f"<math>{_inner(tex)}</math>"


def display(formula: Formula) -> str:
    """Aligned rows of cells; the cells are right-aligned and left-aligned in turn."""
    rows = "".join(f"<mtr>{''.join(_cell(c, i) for i, c in enumerate(row))}</mtr>" for row in formula)
    return f'<math display="block"><mtable class="rows" displaystyle="true">{rows}</mtable></math>'


def _cell(tex: str, place: int) -> str:
    side = "left" if place % 2 else "right"
    return f'<mtd class="{side}">{_inner(tex) if tex else ""}</mtd>'


@cache
def _inner(tex: str) -> str:
    """The MathML of a formula without the element ``math``."""
    raw = convert(tex.replace(r"\!", ""))
    body = raw[raw.index(">") + 1 : raw.rindex("</math>")]
    body = re.sub(r"&#x([0-9A-Fa-f]+);", _character, body)
    body = re.sub(r'<mi mathvariant="bold-italic">([^<]+)</mi>', lambda m: f"<mi>{_bold(m[1])}</mi>", body)
    body = re.sub(r'<mo>(\u2a4a|[~\u02d9\u00a8])</mo>', _accent, body.replace(' stretchy="false">~', ">~"))
    return body.replace('mathvariant="normal"', 'mathvariant="normal"')


def _character(match: re.Match) -> str:
    character = chr(int(match[1], 16))
    return {"&": "&amp;", "<": "&lt;", ">": "&gt;"}.get(character, character)


def _accent(match: re.Match) -> str:
    """Dots and tildes above a letter, in the characters that fonts place there."""
    return f'<mo accent="true" stretchy="false">{"˜" if match[1] == "~" else match[1]}</mo>'


def _bold(letters: str) -> str:
    """Bold letters as characters of their own: browsers do not make them from a style."""
    return "".join(_bold_letter(c) for c in letters)


def _bold_letter(c: str) -> str:
    code = ord(c)
    if 0x391 <= code <= 0x3A9:
        return chr(BOLD_GREEK + code - 0x391)
    if 0x3B1 <= code <= 0x3C9:
        return chr(BOLD_ITALIC_GREEK + 26 + code - 0x3B1)
    if SCRIPT <= code < SCRIPT + 52:
        return chr(BOLD_SCRIPT + code - SCRIPT)
    return {"ϕ": "𝝓", "ε": "𝜺", "ϵ": "𝝐"}.get(c, c)
