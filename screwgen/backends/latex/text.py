"""The small markup of a document's text as LaTeX and as HTML."""

from __future__ import annotations

import html
import re

from ...notebook import plain
from ..templates import markup
from . import mathml
from .layout import Formula

PIECES = re.compile(r"(\$[^$]*\$|`[^`]*`)")
TIED = re.compile(r"(<math>(?:(?!</math>).)*</math>[.,;:)]+)", re.DOTALL)
"""A formula and the sign behind it, between which no line ends."""
SPECIAL: dict[str, str] = {
    "\\": r"\textbackslash{}",
    "_": r"\_",
    "%": r"\%",
    "&": r"\&",
    "#": r"\#",
    "{": r"\{",
    "}": r"\}",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "×": r"$\times$",
    "²": "$^2$",
    "³": "$^3$",
    "⁴": "$^4$",
    "⁻": "$^-$",
    "·": r"$\cdot$",
    "−": "$-$",
    "–": "--",
    "“": "``",
    "”": "''",
    "≤": r"$\leq$",
    "≥": r"$\geq$",
    "≈": r"$\approx$",
    "√": r"$\surd$",
    "°": r"$^\circ$",
    "∫": r"$\int$",
    "→": r"$\to$",
    "ᵀ": r"$^\top$",
}
GREEK = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigmaf sigma tau upsilon "
    "phi chi psi omega"
)
LETTERS = {name: chr(0x3B1 + k) for k, name in enumerate(GREEK.split())}
LETTERS |= {name.capitalize(): chr(0x391 + k) for k, name in enumerate(GREEK.split())}
LATIN = {"omicron", "sigmaf", *(name for name in LETTERS if name[0].isupper())} - {
    *("Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Phi", "Psi", "Omega")
}
"""Greek letters for which LaTeX has no name."""
SPECIAL |= {letter: rf"$\{name}$" for name, letter in LETTERS.items() if name not in LATIN}
UPRIGHT = r"\\mathrm\{((?:[A-Za-z/]|\\,|\^\{\d\})+)\}"
UNIT = re.compile(rf"(?:{UPRIGHT}|1|\\,|[/()]|\^\{{\d\}})+")
"""A formula that is a unit: names of units, their powers, and what stands between them."""
TOGETHER = 4
"""A display of up to that many rows stays on a page."""
RUN = 10
"""An identifier may be broken after that many characters, and after what parts its words; brackets stay with theirs."""


def tex(text: str) -> str:
    """Text for LaTeX."""
    return "".join(_tex_piece(p) for p in PIECES.split(text))


def _tex_piece(piece: str) -> str:
    if piece.startswith("$"):
        return _tex_unit(piece[1:-1]) or piece
    if piece.startswith("`"):
        return rf"\texttt{{{_breakable(piece[1:-1])}}}"
    return _escaped(piece)


def _tex_unit(formula: str) -> str:
    """A unit as text, which is shorter; empty for other formulas."""
    if "mathrm" not in formula or not UNIT.fullmatch(formula):
        return ""
    return re.sub(r"\^\{(\d)\}", r"$^\1$", re.sub(UPRIGHT, r"\1", formula))


def _escaped(text: str) -> str:
    return "".join(SPECIAL.get(c, c) for c in text)


def _breakable(name: str) -> str:
    parts = re.findall(rf"[A-Za-z0-9]{{1,{RUN}}}(?:\[\w+\])?[^A-Za-z0-9\[]*|.", name)
    return r"\cut{}".join(map(_escaped, parts))


def tex_rows(formula: Formula) -> str:
    """Aligned rows of cells."""
    pairs = max(len(row) + 1 for row in formula) // 2
    end = r" \\*" if len(formula) <= TOGETHER else r" \\"
    rows = f"{end}\n".join("  " + " & ".join(row) for row in formula)
    return f"\\begin{{alignat*}}{{{pairs}}}\n{rows}\n\\end{{alignat*}}"


def in_html(text: str) -> str:
    """Text for HTML."""
    return markup(TIED.sub(r'<span class="tie">\1</span>', "".join(_html_piece(p) for p in PIECES.split(text))))


def _html_piece(piece: str) -> str:
    if piece.startswith("$"):
        return _html_unit(piece[1:-1]) or mathml.inline(piece[1:-1])
    if piece.startswith("`"):
        return f"<code>{html.escape(piece[1:-1])}</code>"
    return html.escape(piece)


def _html_unit(formula: str) -> str:
    """A unit as plain text, in one line; empty for other formulas."""
    if "mathrm" not in formula or not UNIT.fullmatch(formula):
        return ""
    plain = re.sub(UPRIGHT, r"\1", formula).replace(r"\,", "\u00a0")
    text = re.sub(r"\^\{(\d)\}", r"<sup>\1</sup>", plain)
    return f'<span class="tie">{text}</span>' if "/" in plain else text


def in_markdown(text: str) -> str:
    """Text for Markdown, which has the same signs for formulas and code."""
    return "".join(piece if piece[:1] in ("$", "`") else plain(piece) for piece in PIECES.split(text))


def html_rows(formula: Formula) -> str:
    """A displayed formula as MathML."""
    return markup(mathml.display(formula))
