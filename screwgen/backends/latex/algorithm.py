"""The algorithm of forward dynamics: numbered lines in the order of evaluation, and what they take as given."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import count

from ...topology.chain import Chain
from ..templates import render
from . import elements
from .content import Display, DocumentTable, Item, Paragraph, parse, words
from .steps import BlockView

ALGORITHM = "Algorithm"
NUMBER = re.compile(r"\(A#\)")
GIVEN = "@@given"
"""What stands in the template where the table of given symbols goes."""
TENSION = r" + \sum\limits_c T_c\,\begin{bmatrix} \mathbf{0} \\ \partial\boldsymbol{\ell}_c \end{bmatrix}"
"""What the tensions of tendons do to the rows of a link."""
MAIN = ("section", "element", "section_spin", "section_load", "link", "tip", "tip_body", "joint", "link_rows", "tendon")
"""The blocks that the algorithm needs; the others are further forms of the equations."""


def items(chain: Chain, views: Iterable[BlockView]) -> Iterator[Item]:
    """The content of the section. ``views``: the blocks of all classes."""
    number = count(1)
    text = NUMBER.sub(lambda _: f"(A{next(number)})", render("latex/algorithm.tex.jinja", **_values(chain)))
    found = parse(text)
    for item in found:
        yield _given(found, views) if isinstance(item, Paragraph) and item.text == GIVEN else item


def _given(lines: Sequence[Item], views: Iterable[BlockView]) -> DocumentTable:
    """The symbols of the lines that the steps of the classes define, in the order of these."""
    displays = [row for item in lines if isinstance(item, Display) for row in item.formula]
    own = {row[0].strip() for row in displays}
    text = " ".join(cell for row in displays for cell in row[1:])
    rows: dict[str, tuple[str, ...]] = {}
    for view in filter(needed, views):
        for step in view.steps:
            symbol = step.formula[0][0]
            if symbol not in own and re.search(r"(?<![\\A-Za-z])" + re.escape(symbol) + r"(?![\w{])", text):
                rows.setdefault(symbol, (f"${symbol}$", words(step.meaning), view.title))
    widths = (0.16, 0.6, 0.24)
    return DocumentTable(("quantity", "meaning", "its part of the class"), widths, tuple(rows.values()), essential=True)


def _values(chain: Chain) -> Mapping[str, object]:
    keys = chain.keys
    return {
        "several": chain.n > 1,
        "floating": chain.floating,
        "jointed": any(not key.floats for key in keys),
        "welded": any(not key.floats and not key.joints for key in keys),
        "bodies": any(key.bodies_at("tip") for key in keys),
        "slides": chain.slides,
        "point": "J" if chain.slides else "m",
        "tension": TENSION if chain.n_tensions else "",
        "effort": elements.effort(chain),
        "acting": elements.acting(chain),
        "elements": elements.equations(chain),
        "inputs": _inputs(chain),
        "loops": bool(chain.closing.rows),
        "joined": bool(chain.robot.loops),
        "couplings": bool(chain.robot.couplings),
        "markers": any(segment.marker is not None for segment in chain.segments),
        "relations": bool(chain.closing.related),
        "shared": chain.closing.overconstrained,
    }


def _inputs(chain: Chain) -> str:
    if elements.acting(chain):
        return r"$\boldsymbol{\tau}_{q,i}$ what acts on the axes of joint $i$, by the last section"
    return r"$\boldsymbol{\tau}_i$ the torques of joint $i$" + ", of slides forces" * chain.slides


def needed(view: BlockView) -> bool:
    """Whether the algorithm needs the steps of a block."""
    return view.name in MAIN
