"""Formulas as MathML: latex2mathml for each cell, and tables of cells for aligned formulas."""

from __future__ import annotations

import re
from functools import cache
from xml.etree import ElementTree

from latex2mathml.converter import convert

from .layout import Formula

BOLD = (
    ("0", "9", 0x1D7CE),
    ("A", "Z", 0x1D400),
    ("a", "z", 0x1D41A),
    ("\u0391", "\u03a9", 0x1D6A8),  # capital Greek, upright
    ("\u03b1", "\u03c9", 0x1D736),  # small Greek, italic
    ("\U0001d49c", "\U0001d4cf", 0x1D4D0),  # script
)
"""Ranges of characters, and their bold forms in Unicode."""

FUNCTION = re.compile(r"(\\(?:cosh|sinh|cos|sin)(?![a-z]))(?!\s*[\^(]|\s*\\left)")
BEFORE = re.compile(r"([\w}])(?=\\(?:cosh|sinh|cos|sin)(?![a-z]))")
"""A function needs a space before it, and one behind it if its argument stands without brackets."""

BESIDE = '<mspace width="0.15em"></mspace>'
"""The room beside a matrix, as TeX leaves it."""
BRACKETS = (
    ("<mo>[</mo><mtable>", f"<mrow>{BESIDE}<mo>[</mo><mtable>"),
    ("</mtable><mo>]</mo>", f"</mtable><mo>]</mo>{BESIDE}</mrow>"),
)
"""A matrix is a group of its own, because brackets grow with the content of their group."""

SCRIPTED = re.compile(r"<m(?:sup|subsup)><mover>")
LETTER, ACCENT = "0.7em", "1.05em"
"""The height of an accented letter for its superscript, and that of both together."""


def inline(tex: str) -> str:
    """A formula in a line of text."""
    return f"<math>{_inner(tex)}</math>"


def display(formula: Formula) -> str:
    """Aligned rows of cells; the page's style aligns the cells right and left in turn."""
    rows = "".join(f"<mtr>{''.join(map(_cell, row))}</mtr>" for row in formula)
    return f'<math><mtable class="rows" displaystyle="true">{rows}</mtable></math>'


def _cell(tex: str) -> str:
    return f"<mtd>{_inner(tex) if tex else ''}</mtd>"


@cache
def _inner(tex: str) -> str:
    """The MathML of a formula without the element ``math``: the same with all versions of the converter."""
    upright = re.sub(r"\\mathrm\{([A-Za-z]+)\}", r"\\text{\1}", tex.replace(r"\!", ""))
    raw = convert(BEFORE.sub(r"\1\,", FUNCTION.sub(r"\1\,", upright)))
    body = raw[raw.index(">") + 1 : raw.rindex("</math>")]
    body = re.sub(r"&#x([0-9A-Fa-f]+);", _character, body)
    body = re.sub(r'<(m[in]) mathvariant="bold(?:-italic)?">([^<]+)</m[in]>', _bold, body)
    body = re.sub("<mi>([×·])</mi>", r"<mo>\1</mo>", body.replace('<mover accent="true">', "<mover>"))
    body = body.replace("<mo>/</mo>", '<mo lspace="0" rspace="0">/</mo>')
    for plain, grouped in BRACKETS:
        body = body.replace(plain, grouped)
    body = re.sub(r'<mo(?: stretchy="(?:true|false)")?>([~^\u02d9\u00a8\u00af])</mo></mover>', _accent, body)
    return _scripts(body.replace(' mathvariant="italic"', "")).replace("<mover>", '<mover accent="true">')


def _character(match: re.Match) -> str:
    character = chr(int(match[1], 16))
    return {"&": "&amp;", "<": "&lt;", ">": "&gt;"}.get(character, character)


def _accent(match: re.Match) -> str:
    """Dots, hats and tildes above a letter, in the characters that fonts place there."""
    character = {"~": "\u02dc", "^": "\u02c6"}.get(match[1], match[1])
    return f'<mo stretchy="false">{character}</mo></mover>'


def _scripts(body: str) -> str:
    """Superscripts beside an accent at the height that they have beside the bare letter, as TeX sets them."""
    if not SCRIPTED.search(body):
        return body
    root = ElementTree.fromstring(f"<math>{body}</math>")
    for parent in list(root.iter()):
        for place, child in enumerate(list(parent)):
            if child.tag in ("msup", "msubsup") and child[0].tag == "mover":
                child[0] = _padded(child[0], LETTER)
                parent[place] = _padded(child, ACCENT)
    text = ElementTree.tostring(root, encoding="unicode", short_empty_elements=False)
    return text.removeprefix("<math>").removesuffix("</math>")


def _padded(inner: ElementTree.Element, height: str) -> ElementTree.Element:
    out = ElementTree.Element("mpadded", height=height)
    out.append(inner)
    return out


def _bold(match: re.Match) -> str:
    """Bold letters as characters of their own: browsers do not make them from a style."""
    return f"<{match[1]}>{''.join(map(_bold_letter, match[2]))}</{match[1]}>"


def _bold_letter(c: str) -> str:
    for first, last, bold in BOLD:
        if first <= c <= last:
            return chr(bold + ord(c) - ord(first))
    return "\U0001d753" if c == "\u03d5" else c


# ------------------------------------------------------------------------------------------- fewer bytes

ROWS = {"math", "mrow", "mtd", "mpadded", "msqrt"}
"""Elements whose content is a row without a group around it."""
BRACKET = {"stretchy": "true", "fence": "true"}
"""What every bracket is by itself."""


def shorten(parent: ElementTree.Element) -> None:
    """Takes out groups and attributes that change nothing: a third of the bytes of formulas.

    A group around an operator stays, because operators have room beside them by their place in a group.
    """
    for place, child in enumerate(parent):
        shorten(child)
        if child.tag == "mrow" and len(child) == 1 and not _is_operator(child[0]):
            if not child.attrib.keys() & child[0].attrib.keys():
                child[0].attrib.update(child.attrib)
                parent[place] = child[0]
        elif child.tag == "mo" and child.text in set("()[]{}") and child.attrib.items() >= BRACKET.items():
            child.attrib.clear()
        elif child.tag == "mspace":
            child.set("width", child.get("width", "").removeprefix("0"))
    if parent.tag in ROWS and len(parent) == 1 and parent[0].tag == "mrow" and not parent[0].attrib:
        parent[:] = list(parent[0])


def _is_operator(element: ElementTree.Element) -> bool:
    """Whether an element is an operator, with whatever scripts."""
    while len(element) and element.tag not in ("mtable", "mrow"):
        element = element[0]
    return element.tag in ("mo", "mrow")
