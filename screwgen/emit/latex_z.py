"""The section on the Z-form: its coordinates and rates, the system in ``Zdot``, the Cauchy form."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ..chain.chain import Chain
from ..chain.scope import common
from ..chain.z_functions import cauchy_size
from .latex_content import Item, Section, equation, parse
from .latex_layout import PAGE, matrix, width
from .latex_steps import BlockView, block_view
from .templates import render

STEPS = re.compile(r"^@ (.*)$", re.MULTILINE)
"""A line of the template that stands for steps of the block."""

Place = tuple[str, int]
"""A row or column of the pattern: of a ``joint``, a ``link`` or its ``modes``, and the link's number."""

DOTS: Place = ("dots", 0)


def z_view() -> BlockView:
    """The block of the Z-form as it is shown."""
    return block_view(common()["z_form"])


def z_section(chain: Chain) -> Section:
    """The Z-form of a robot."""
    shown, text = _pattern(chain)
    prose = render(
        "latex/z_form.tex.jinja",
        unknowns=_unknowns(shown),
        pattern=text,
        elided=DOTS in shown,
        size=cauchy_size(chain),
    )
    return Section("The Z-form", list(_items(prose)))


def _items(prose: str) -> Iterator[Item]:
    """Prose with the steps that it asks for."""
    steps = {step.name: step for step in z_view().steps}
    for i, part in enumerate(STEPS.split(prose)):
        yield from map(equation, (steps[name] for name in part.split())) if i % 2 else parse(part)


# --------------------------------------------------------------------------------------------- pattern


def _pattern(chain: Chain) -> tuple[list[Place], str]:
    """The places that are shown, and the matrix: of all links, or of the first two where that is too wide."""
    places = _places(chain, range(chain.n))
    text = _matrix(chain, places)
    if width(text) > PAGE - 4.0:
        places = _places(chain, range(2), [DOTS])
        text = _matrix(chain, places)
    return places, text


def _places(chain: Chain, links: Sequence[int], between: Sequence[Place] = ()) -> list[Place]:
    flexible = [i for i in links if chain.keys[i].modes]
    return [
        *((part, i) for i in links for part in ("joint", "link")),
        *between,
        *(("modes", i) for i in flexible),
    ]


def _matrix(chain: Chain, places: Sequence[Place]) -> str:
    return matrix([[_cell(chain, row, column) for column in places] for row in places])


def _cell(chain: Chain, row: Place, column: Place) -> str:
    if DOTS in (row, column):
        return r"\ddots" if row == column else r"\vdots" if row == DOTS else r"\cdots"
    (of, i), (to, j) = row, column
    number = f",{i + 1}"
    inside = {
        ("joint", "joint"): r"\mathbf{M}_{\mathcal{W}" + number + "}",
        ("joint", "link"): r"\mathbf{M}_{Z" + number + "}",
        ("link", "joint"): rf"-\mathbf{{J}}_{{B{number}}}^{{\top}}" if chain.keys[i].frame_at else r"-\mathbf{I}_6",
        ("link", "link"): r"\mathbf{M}_{VZ" + number + "}",
        ("link", "modes"): r"\mathbf{M}_{V\eta" + number + "}",
        ("modes", "link"): r"\mathbf{M}_{\eta Z" + number + "}",
        ("modes", "modes"): r"\mathbf{M}_{\eta\eta" + number + "}",
    }
    onward = {
        ("link", "joint"): r"\mathbf{M}_{V\mathcal{W}" + number + "}",
        ("modes", "joint"): r"\mathbf{M}_{\eta\mathcal{W}" + number + "}",
    }
    back = {
        ("joint", "link"): r"\mathbf{M}_{Z" + number + "}^{-}",
        ("joint", "modes"): r"\mathbf{M}_{\eta" + number + "}^{-}",
    }
    coupling = {0: inside, 1: onward, -1: back}.get(j - i, {})
    return coupling.get((of, to), r"\mathbf{0}")


def _unknowns(places: Sequence[Place]) -> str:
    letter = {"joint": r"\mathbf{w}", "link": r"\dot{\mathbf{Z}}", "modes": r"\ddot{\boldsymbol{\eta}}"}
    names = [r"\ldots" if place == DOTS else f"{letter[place[0]]}_{place[1] + 1}" for place in places]
    if DOTS in places:
        names.append(r"\ldots")
    return "[" + r";\ ".join(names) + "]"
