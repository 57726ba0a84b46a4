"""The pattern of the system's matrix and its unknowns for one robot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...topology.chain import Chain
from .layout import PAGE, matrix, width

Place = tuple[str, int]
"""A row or column of the pattern: of a ``joint``, a ``link`` or its ``modes``, and the link's number."""

DOTS: Place = ("dots", 0)
ELLIPSIS = r"\ldots"


@dataclass(frozen=True)
class Pattern:
    """The LaTeX of the unknowns and of the matrix, and whether links are left out."""

    unknowns: str
    matrix: str
    elided: bool


def pattern(chain: Chain, rate: str) -> Pattern:
    """The pattern of all links, or of the first two where that is too wide; ``rate`` is the letter
    of the links' unknowns, V for twists.
    """
    places = _places(chain, range(chain.n))
    text = _matrix(chain, places, rate) if len(places) < PAGE else ""  # a column takes an em at least
    if not text or width(text) > PAGE - 4.0:
        places = _places(chain, range(2), [DOTS])
        text = _matrix(chain, places, rate)
    return Pattern(_unknowns(places, rate), text, DOTS in places)


def _places(chain: Chain, links: Sequence[int], between: Sequence[Place] = ()) -> list[Place]:
    flexible = [i for i in links if chain.keys[i].modes]
    return [
        *((part, i) for i in links for part in ("joint", "link")),
        *between,
        *(("modes", i) for i in flexible),
    ]


def _matrix(chain: Chain, places: Sequence[Place], rate: str) -> str:
    return matrix([[_cell(chain, row, column, rate) for column in places] for row in places])


def _cell(chain: Chain, row: Place, column: Place, rate: str) -> str:
    if DOTS in (row, column):
        return r"\ddots" if row == column else r"\vdots" if row == DOTS else r"\cdots"
    (of, i), (to, j) = row, column
    number = f",{i + 1}"
    inside = {
        ("joint", "joint"): r"\mathbf{P}_{\mathcal{W}" + number + "}",
        ("joint", "link"): rf"\mathbf{{P}}_{{{rate}{number}}}",
        ("link", "joint"): rf"-\mathbf{{J}}_{{B{number}}}^{{\top}}" if chain.keys[i].frame_at else r"-\mathbf{I}_6",
        ("link", "link"): rf"\mathbf{{M}}_{{V{rate}{number}}}",
        ("link", "modes"): r"\mathbf{M}_{V\eta" + number + "}",
        ("modes", "link"): rf"\mathbf{{M}}_{{\eta {rate}{number}}}",
        ("modes", "modes"): r"\mathbf{M}_{\eta\eta" + number + "}",
    }
    onward = {
        ("link", "joint"): r"\mathbf{M}_{V\mathcal{W}" + number + "}",
        ("modes", "joint"): r"\mathbf{M}_{\eta\mathcal{W}" + number + "}",
    }
    back = {
        ("joint", "link"): rf"\mathbf{{P}}_{{{rate}{number}}}^{{-}}",
        ("joint", "modes"): r"\mathbf{M}_{\eta" + number + "}^{-}",
    }
    tree = chain.tree.parents
    coupling = inside if i == j else onward if tree[j] == i else back if tree[i] == j else {}
    return coupling.get((of, to), r"\mathbf{0}")


def _unknowns(places: Sequence[Place], rate: str) -> str:
    letter = {"joint": r"\mathbf{w}", "link": rf"\dot{{\mathbf{{{rate}}}}}", "modes": r"\ddot{\boldsymbol{\eta}}"}
    names = [ELLIPSIS if place == DOTS else f"{letter[place[0]]}_{place[1] + 1}" for place in places]
    if DOTS in places:
        names.append(ELLIPSIS)
    return "[" + r";\ ".join(names) + "]"


def occupied(chain: Chain) -> tuple[list[Place], list[list[bool]]]:
    """The rows of all links, and which blocks of the system's matrix are not zero."""
    places = _places(chain, range(chain.n))
    zero = r"\mathbf{0}"
    return places, [[_cell(chain, row, column, "V") != zero for column in places] for row in places]
