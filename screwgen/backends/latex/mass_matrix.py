"""The mass matrix on a page: its blocks as a picture, its entries at a posture, and formulas of those that are short.

A search finds entries by number and by words.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass

import numpy as np

from ...spec.parameters import changes, parameters
from ...topology.chain import Chain
from ..equations.names import Name
from ..equations.short import Coordinate, short_entries
from ..numpy.numeric import Numeric
from . import coordinate_symbols
from .content import DocumentTable
from .joint_words import called
from .layout import PAGE, Formula, equation
from .motion import Group, groups, related
from .parameter_symbols import of_links
from .tables import DIRECTION, decimal, plain_unit

MANY = 40
"""Of larger matrices the entries are left out."""
LAST_DIGIT = 9
"""Indices beyond are parted by a comma."""
ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")
ZERO = 1e-13
"""Entries below that part of the largest on their diagonals are rounding."""


@dataclass(frozen=True)
class BlockCell:
    """A block: its letters, its size, the part of the text that has its formula, and its first entry."""

    row: str
    column: str
    size: str
    formula: str
    """`own` or `carried`; empty for a block of zeros."""
    part: int
    """Which of the formulas of its place it is."""
    transposed: bool
    letters: str
    """What the letters of links in the formula are, and which coordinates `x` are."""


@dataclass(frozen=True)
class MassFormulas:
    """The entries with short formulas by row and column, from 1, and what the letters of parameters there are.

    ``zeros``: those that are zero in every posture.
    """

    entries: Mapping[tuple[int, int], Formula]
    zeros: Set[tuple[int, int]]
    letters: DocumentTable


@dataclass(frozen=True)
class MassMatrix:
    """What the page has of the matrix."""

    groups: Sequence[str]
    blocks: Sequence[Sequence[BlockCell]]
    names: Sequence[str]
    """The coordinates in words, in the order of `v`."""
    units: Sequence[str]
    """Theirs, rad or m."""
    owners: Sequence[int]
    """The place of the group of each."""
    entries: Sequence[Sequence[str]]
    """Numbers; empty for a matrix that is too large."""
    posture: str
    formulas: MassFormulas | None


def mass_matrix(chain: Chain, at: Sequence[float] | None = None) -> MassMatrix:
    """The matrix in the coordinates ``at`` (nq,), by default in the posture in which all are at home."""
    q = np.array(chain.home if at is None else at, float)
    every = groups(chain)
    shown = [_html(group) for group in every]
    small = chain.nv <= MANY
    M = Numeric(chain).mass_matrix(q) if small else np.zeros((0, 0))
    scale = np.sqrt(np.outer(np.diag(M), np.diag(M)))
    entries = [[_number(x, s) for x, s in zip(row, sizes, strict=True)] for row, sizes in zip(M, scale, strict=True)]
    return MassMatrix(
        shown,
        [[_cell(chain, a, b) for b in every] for a in every],
        words(chain),
        list(changes(chain.robot).values()),
        [k for k, group in enumerate(every) for _ in range(group.size)],
        entries,
        _posture(chain, at),
        formulas(chain) if small else None,
    )


def _posture(chain: Chain, at: Sequence[float] | None) -> str:
    if at is None:
        links = "at rest" if any(key.rest for key in chain.keys) else "straight"
        return f"all coordinates at home, joints at 0 and links {links}; --at gives another posture"
    return "q = " + ", ".join(f"{x:g}" for x in at)


def _html(group: Group) -> str:
    letter = {"joint": "q", "modes": "η", "rotors": "ϑ"}[group.kind]
    return letter if group.kind == "rotors" else f"{letter}{group.link + 1}"


def _cell(chain: Chain, a: Group, b: Group) -> BlockCell:
    own = a.link == b.link or "rotors" in (a.kind, b.kind)
    formula = "" if not related(chain, a, b) else "own" if own else "carried"
    first, second = sorted((a, b), key=lambda group: (group.link, group.kind))
    part = (first.kind == "modes") + (own and second.kind == "modes")
    size, letters = f"{a.size} × {b.size}", "" if "rotors" in (a.kind, b.kind) else _letters(chain, first, second)
    return BlockCell(_html(a), _html(b), size, formula, part, a.first > b.first, letters)


def _letters(chain: Chain, first: Group, second: Group) -> str:
    """Of link i, of link j that it carries, and of link k between, which sits on link i."""
    i, j = first.link, second.link
    k = j
    while chain.tree.parents[k] > i:
        k = chain.tree.parents[k]
    known = {"i": i + 1, "k": k + 1, "j": j + 1, "x": "q" if second.kind == "joint" else "η"} if i < j else {"j": j + 1}
    return ", ".join(f"{letter}\u00a0=\u00a0{value}" for letter, value in known.items())


def formulas(chain: Chain) -> MassFormulas:
    """The entries that are short enough to be read."""
    symbols, known = of_links(chain), parameters(chain.robot)
    found = short_entries(chain, coordinates(chain), [Name(p.name, x) for p, x in zip(known, symbols, strict=True)])
    comma = "," if chain.nv > LAST_DIGIT else ""
    entries = {
        (i + 1, j + 1): equation(f"M_{{{i + 1}{comma}{j + 1}}}", found.latex.terms(formula, PAGE - 6.0))
        for (i, j), formula in sorted(found.formulas.items(), key=lambda pair: pair[0])
        if formula.terms
    }
    zeros = {(i + 1, j + 1) for (i, j), formula in found.formulas.items() if not formula.terms}
    stated = [(symbols[k], known[k]) for k in found.parameters]
    rows = ((f"${x}$", p.description, f"`{p.name}`", decimal(p.value), plain_unit(p.unit)) for x, p in stated)
    head = ("symbol", "meaning", "parameter", "value", "unit")
    return MassFormulas(entries, zeros, DocumentTable(head, (0.15, 0.35, 0.25, 0.15, 0.1), tuple(rows)))


def coordinates(chain: Chain) -> list[Coordinate | None]:
    """The coordinates in the order of `q`; None of a floating base and of a quaternion."""
    letters = coordinate_symbols.axes(chain)
    out: list[Coordinate | None] = []
    for i, key in enumerate(chain.keys):
        axes = letters[chain.tau_offset[i] : chain.tau_offset[i + 1]]
        if len(key.screws) == len(axes) and not key.floats:
            out += [Coordinate(Name(x, x), screw.turn) for x, screw in zip(axes, key.screws, strict=True)]
        else:
            out += [None] * (chain.q_offset[i + 1] - chain.q_offset[i])
    others = [*coordinate_symbols.rotors(chain).values(), *coordinate_symbols.modes(chain)]
    return [*out, *(Coordinate(Name(x, x), False) for x in others)]


def _number(value: float, scale: float) -> str:
    return "0" if abs(value) <= ZERO * scale else f"{value:.5g}".replace("-", "−")


def words(chain: Chain) -> list[str]:
    """Every rate of `v` in the words by which one looks for it."""
    names = list(changes(chain.robot))
    out = [f"base {name}" for name in names[: chain.base_v]]
    for i, key in enumerate(chain.keys):
        word = called(chain.names[i])
        for k in range(0 if key.floats else key.torques):
            number = chain.tau_offset[i] + k + 1
            out.append(f"joint {number} q_{number}, {names[len(out)]}" + f", {word}" * bool(word))
    out += [f"rotor {name}" for name in names[len(out) : len(out) + chain.n_added]]
    for i, key in enumerate(chain.keys):
        for k, (direction, number) in enumerate(key.directions):
            ordinal = ORDINALS[number] if number < len(ORDINALS) else f"{number + 1}th"
            about = DIRECTION.get(direction, direction)
            out.append(f"mode {k + 1} of link {i + 1}, {names[len(out)]}, {ordinal} {about}")
    return out
