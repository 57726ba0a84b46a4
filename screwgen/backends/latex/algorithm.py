"""The algorithm of forward dynamics: numbered lines in the order of evaluation, and what they take as given."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count

from ...topology.chain import Chain
from ..templates import render
from . import elements, forces
from .content import Display, DocumentTable, Item, Paragraph, parse, words
from .layout import Row
from .steps import BlockView, StepView

ALGORITHM = "Algorithm"
NUMBER = re.compile(r"\(A#\)")
LABEL = r"\text{"
GIVEN = "@@given"
"""What stands in the template where the table of given symbols goes."""
TENSION = r" + \sum\limits_c T_c\,\begin{bmatrix} \mathbf{0} \\ \partial\boldsymbol{\ell}_c \end{bmatrix}"
"""What the tensions of tendons do to the rows of a link."""
MAIN = ("section", "element", "section_spin", "section_load", "link", "tip", "tip_body", "joint", "link_rows", "tendon")
"""The blocks that the algorithm needs; the others are further forms of the equations."""
SHARED = ("tip", "link_rows")
"""Those of them with steps for further forms, too."""


def lines(chain: Chain) -> list[Item]:
    """The text and the numbered lines; a place is left for the table of what they take as given."""
    number = count(1)
    text = NUMBER.sub(lambda _: f"(A{next(number)})", render("latex/algorithm.tex.jinja", **_values(chain)))
    return parse(text)


def items(lines: Sequence[Item], views: Iterable[BlockView]) -> Iterator[Item]:
    """The content of the section. ``views``: the blocks that the lines need, of all classes."""
    for item in lines:
        yield _given(lines, views) if isinstance(item, Paragraph) and item.text == GIVEN else item


def _given(lines: Sequence[Item], views: Iterable[BlockView]) -> DocumentTable:
    """The symbols of the lines that the steps of the classes define, in the order in which lines need them."""
    own = {plain(row[0]) for row in _rows(lines)}
    steps = {plain(step.formula[0][0]): (step, view) for view in reversed(list(views)) for step in view.steps}
    rows: dict[str, tuple[str, ...]] = {}
    for row in (row for row in _rows(lines) if row[-1].startswith(LABEL)):
        for symbol in (s for s in steps if s not in own and s not in rows and occurs(s, row[1])):
            step, view = steps[symbol]
            number = row[-1].removeprefix(LABEL).removesuffix("}")
            rows[symbol] = (f"${step.formula[0][0]}$", words(step.meaning), view.title, number)
    widths = (0.16, 0.48, 0.22, 0.14)
    head = ("quantity", "meaning", "its part of the class", "first needed in")
    return DocumentTable(head, widths, tuple(rows.values()), essential=True)


def _rows(lines: Sequence[Item]) -> list[Row]:
    return [row for item in lines if isinstance(item, Display) for row in item.formula]


def plain(formula: str) -> str:
    """A formula with single letters below others not in braces, and without the tildes of skew matrices."""
    formula = re.sub(r"\\(?:wide)?tilde\{((?:[^{}]|\{[^{}]*\})*)\}", r"\1", formula)
    return re.sub(r"_\{(\\?\w+)\}", r"_\1", formula.strip())


def occurs(symbol: str, formula: str) -> bool:
    """Whether a formula uses a symbol."""
    return re.search(r"(?<![\\A-Za-z])" + re.escape(plain(symbol)) + r"(?!\}?[\w{]|\}_)", plain(formula)) is not None


def parted(lines: Sequence[Item], views: Sequence[BlockView]) -> tuple[list[BlockView], list[BlockView]]:
    """The steps that the lines need, and all others: further forms of the equations.

    Of the tip and of the rows of a link some steps serve such forms alone.
    """
    text = " ".join(plain(row[1]) for row in _rows(lines))
    kept = {step for view in views if view.name in MAIN and view.name not in SHARED for step in view.steps}
    text += "".join(map(_text, kept))
    left = [step for view in views if view.name in SHARED for step in view.steps]
    while found := [step for step in left if occurs(step.formula[0][0], text)]:
        kept |= set(found)
        left = [step for step in left if step not in found]
        text = "".join(map(_text, found))
    main, others = [], []
    for view in views:
        own, rest = (tuple(s for s in view.steps if (s in kept) == needed) for needed in (True, False))
        if view.name in MAIN:
            main.append(replace(view, steps=own))
        if rest:
            others.append(replace(view, steps=rest, zeros=(), identities=()))
    return main, others


def _text(step: StepView) -> str:
    """All that a step says, but for its symbol."""
    cells = [cell for row in (*step.formula, *step.components) for cell in row]
    return " " + plain(" ".join(cells[1:]))


def _values(chain: Chain) -> Mapping[str, object]:
    keys = chain.keys
    return {
        "several": chain.n > 1,
        "floating": chain.floating,
        "jointed": any(not key.floats for key in keys),
        "welded": any(not key.floats and not key.joints for key in keys),
        "bodies": any(key.bodies_at("tip") for key in keys),
        "slides": chain.slides,
        "point": "J" if chain.slides else "M",
        "tension": TENSION if chain.n_tensions else "",
        "effort": elements.effort(chain),
        "acting": elements.acting(chain),
        "elements": elements.equations(chain),
        "forces": forces.lines(chain),
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
