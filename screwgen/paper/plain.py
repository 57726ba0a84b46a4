"""Matrix expressions as Unicode text, for a terminal: from the same tree as the LaTeX, line by line."""

from __future__ import annotations

import re
import unicodedata
from itertools import groupby

from ..algebra.expression import (
    BlockMatrix,
    Constant,
    Expression,
    Hat,
    Integral,
    Inverse,
    Negative,
    Product,
    Sum,
    Symbol,
    Trace,
    Transpose,
    is_identity,
    is_zero,
)
from ..backends.latex.text import LETTERS

WIDTH = 100
SIGNS = {
    "top": "ᵀ", "int": "∫", "sum": "Σ", "prod": "∏", "leq": "≤", "geq": "≥", "in": "∈", "times": "×", "cdots": "⋯",
    "vdots": "⋮",
    "ddots": "⋱", "quad": "  ", "qquad": "    ", "infty": "∞", "sqrt": "√", "pm": "±", "to": "→", "mapsto": "↦",
    "ldots": "…", "dots": "…", "neq": "≠", "approx": "≈", "partial": "∂", "cdot": "·", "succ": "≻", "succeq": "⪰",
    "left": "", "right": "", "displaystyle": "", "limits": "",
}  # fmt: skip
FUNCTIONS = ("sin", "cos", "tan", "sinh", "cosh", "exp")
SIGNS |= {name: name for name in (*FUNCTIONS, "max", "min")}
ACCENTS = {"tilde": "\u0303", "widetilde": "\u0303", "dot": "\u0307", "ddot": "\u0308", "bar": "\u0304"}
RAISED = {"o": "ᵒ", "i": "ⁱ"}
RAISED_DIGITS = str.maketrans("0123456789−", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
TOKEN = re.compile(r"\\[A-Za-z]+|\\.|.", re.DOTALL)


def plain(e: Expression) -> str:
    """The expression on one line: ``ρA ∫ r̃_b ω̃ v_ib dξ``."""
    match e:
        case Symbol():
            return letters(e.display)
        case Constant():
            return _constant(e)
        case Sum():
            first, *rest = e.terms
            return plain(first) + "".join(f" − {p[1:]}" if p[0] == "−" else f" + {p}" for p in map(_term, rest))
        case Product():
            return " ".join(_powers(_factors(e)))
        case Negative():
            inner = _term(e.arg)
            return inner[1:] if inner[0] == "−" else f"−{inner}"
        case Transpose():
            return f"({plain(e.arg)})ᵀ" if isinstance(e.arg, Integral | Product) else f"{_factor(e.arg)}ᵀ"
        case Inverse(Symbol()) if e.shape == (1, 1):
            return f"1/({plain(e.arg)})"
        case Inverse():
            return f"{_factor(e.arg.arg)}⁻ᵀ" if isinstance(e.arg, Transpose) else f"{_factor(e.arg)}⁻¹"
        case Hat():
            if isinstance(e.arg, Symbol | Constant):
                return accent(letters(e.arg.display), "\u0303")
            return f"hat({plain(e.arg)})"
        case Trace():
            return f"tr({plain(e.arg)})"
        case Integral():
            weight = "" if e.weight is None else f"{plain(e.weight)} "
            return f"{weight}∫" + ("" if is_identity(e.integrand) else f" {_factor(e.integrand)}") + " dξ"
        case BlockMatrix():
            return "[" + "; ".join(", ".join(map(plain, row)) for row in e.rows) + "]"
    raise TypeError(f"no text for {type(e).__name__}")


def _term(e: Expression) -> str:
    return f"({plain(e)})" if isinstance(e, Sum) else plain(e)


def _factor(e: Expression) -> str:
    return f"({plain(e)})" if isinstance(e, Sum | Negative) else plain(e)


def _factors(e: Expression) -> list[Expression]:
    return [*_factors(e.left), *_factors(e.right)] if isinstance(e, Product) else [e]


def _powers(factors: list[Expression]) -> list[str]:
    """The factors, equal neighbours as a power: ``ω̃²``."""
    groups = [(f, len(list(g))) for f, g in groupby(factors)]
    return [_factor(f) + {1: "", 2: "²", 3: "³"}.get(n, f"^{n}") for f, n in groups]


def _constant(e: Constant) -> str:
    if e.shape == (1, 1):
        return str(e.rows[0][0])
    return "0" if is_zero(e) else "I" if is_identity(e) else letters(e.display)


# ------------------------------------------------------------------------------------------ letters


def letters(tex: str) -> str:
    """A symbol's LaTeX as letters with accents: ``\\tilde{\\mathbf{r}}_{b_i}`` is ``r̃_bi``."""
    text = _Reader(tex).group()
    return re.sub(r" {3,}(?! )|(?<=\S) {2}(?=\S)", " ", text).strip().replace(" )", ")")


def accent(text: str, mark: str) -> str:
    """A mark on the letter of a symbol, before its index."""
    at = re.search(r"(?![ᵒⁱ])[^\W\d_]", text)
    place = at.end() if at else len(text)
    while place < len(text) and unicodedata.combining(text[place]):
        place += 1
    return unicodedata.normalize("NFC", text[:place] + mark + text[place:])


APART = {rf"\{name}" for name in (*ACCENTS, *FUNCTIONS, "mathbf", "boldsymbol", "mathrm", "frac")}
"""What begins a new factor: a space stands before it."""


class _Reader:
    """Reads LaTeX from left to right."""

    def __init__(self, tex: str):
        self.tokens = TOKEN.findall(tex)
        self.at = 0

    def group(self) -> str:
        """Text up to the end of the group."""
        out = ""
        while self.at < len(self.tokens) and self.tokens[self.at] != "}":
            if out and out[-1] not in " ᵒⁱ([{" and self.tokens[self.at] in APART:
                out += " "
            out += self.script() if self.tokens[self.at] in ("_", "^") else self.atom()
        return out

    def script(self) -> str:
        mark = self.tokens[self.at]
        self.at += 1
        inner = self.atom()
        if mark == "_":
            return "_" + inner.replace("_", "").replace(" ", "")
        if re.fullmatch(r"−?\d+", inner):
            return inner.translate(RAISED_DIGITS)
        return inner if inner in ("ᵀ", "*", "+", "'") else RAISED.get(inner, f"^{inner}")

    def atom(self) -> str:
        token = self.tokens[self.at]
        self.at += 1
        if token == "{":
            inner = self.group()
            self.at += 1
            return inner
        name = token[1:] if token.startswith("\\") else ""
        if name in ACCENTS:
            return accent(self.atom(), ACCENTS[name])
        if name in ("frac", "tfrac", "dfrac"):
            above, below = self.atom(), self.atom()
            above, below = _grouped(above, r" [+−] "), _grouped(below, r" |\d[^\W\d]")
            return f"{above}/{below}" + (" " if above.startswith("d") else "")
        if name == "sqrt":
            return f"√{_grouped(self.atom(), ' |/')}"
        if name in FUNCTIONS:
            return name + ("" if self.tokens[self.at : self.at + 1] in (["("], ["{"], [r"\left"]) else " ")
        if name in LETTERS or name in SIGNS:
            return LETTERS.get(name, SIGNS.get(name, ""))
        if name in (",", ";", ":", "!", " "):
            return "" if name == "!" else " "
        if name and not name.isalpha():
            return name
        return "−" if token == "-" else token if not name else ""


def _grouped(text: str, pattern: str) -> str:
    """Parentheses around a text in which the pattern is found."""
    text = text.strip()
    return f"({text})" if re.search(pattern, text) else text


# ---------------------------------------------------------------------------------------- relations


def relation(left: Expression, right: Expression, width: int = WIDTH) -> list[str]:
    """``left = right`` on as few lines as the width allows; matrices of blocks as boxes, or row by row."""
    whole = f"{plain(left)} = {plain(right)}"
    if shown(whole) <= width and not _tall(right):
        return [whole]
    if isinstance(left, Sum) and shown(plain(left)) > 2 * width // 3:
        return _below(_broken(left, width), boxed(right, width - 4), width)
    head = f"{plain(left)} = "
    return hung(head, boxed(right, width - len(head)))


def _below(left: list[str], right: list[str], width: int) -> list[str]:
    """A long left side with the right side behind or below it."""
    if len(right) == 1 and shown(left[-1]) + shown(right[0]) + 3 <= width:
        return [*left[:-1], f"{left[-1]} = {right[0]}"]
    return [*left, *hung("  = ", right)]


def hung(head: str, lines: list[str]) -> list[str]:
    """Lines behind a head, which stands before the middle one of a box and before the first of a list."""
    middle = (len(lines) - 1) // 2 if lines and lines[0][:1] in "⎡[" and len(lines) > 1 else 0
    return [(head if i == middle else " " * shown(head)) + line for i, line in enumerate(lines)]


def boxed(e: Expression, width: int = WIDTH) -> list[str]:
    """An expression on several lines."""
    if not isinstance(e, BlockMatrix):
        return _broken(e, width)
    cells = [[plain(x) for x in row] for row in e.rows]
    columns = [max(shown(row[k]) for row in cells) for k in range(len(cells[0]))]
    if sum(columns) + 3 * len(columns) + 2 > width:
        return [line for k, row in enumerate(e.rows) for line in _row(k, row, width)]
    text = ["   ".join(c + " " * (w - shown(c)) for c, w in zip(row, columns, strict=True)) for row in cells]
    marks = ["[]"] if len(text) == 1 else ["⎡⎤", *["⎢⎥"] * (len(text) - 2), "⎣⎦"]
    return [f"{m[0]} {line} {m[1]}" for m, line in zip(marks, text, strict=True)]


def _tall(e: Expression) -> bool:
    return isinstance(e, BlockMatrix) and (len(e.rows) > 1)


def _row(number: int, row: tuple[Expression, ...], width: int) -> list[str]:
    """A row of a matrix that is too wide for a box: its entries that are not zero, one after the other."""
    out = []
    for k, x in enumerate(row):
        if len(row) > 1 and is_zero(x):
            continue
        head = f"row {number + 1}" + (f", column {k + 1}" if len(row) > 1 else "") + ":  "
        out += hung(head, _broken(x, width - len(head)))
    return out or [f"row {number + 1}:  0"]


def _broken(e: Expression, width: int) -> list[str]:
    """A sum on several lines, each beginning with a sign."""
    if not isinstance(e, Sum) or shown(plain(e)) <= width:
        return [plain(e)]
    first, *rest = e.terms
    parts = [plain(first)] + [f"− {p[1:]}" if p[0] == "−" else f"+ {p}" for p in map(_term, rest)]
    lines = [parts[0]]
    for part in parts[1:]:
        if shown(lines[-1]) + shown(part) + 1 <= width:
            lines[-1] += f" {part}"
        else:
            lines.append(f"  {part}")
    return lines


def shown(text: str) -> int:
    """How many columns of a terminal a text takes."""
    return sum(not unicodedata.combining(c) for c in text)
