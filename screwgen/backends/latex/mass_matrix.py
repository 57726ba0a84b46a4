"""The mass matrix on a page: its blocks as a picture, and its entries at a posture, which a search finds by words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...spec.parameters import changes
from ...topology.chain import Chain
from ..numpy.numeric import Numeric
from .joint_words import called
from .motion import Group, groups, related
from .tables import DIRECTION

MANY = 40
"""Of larger matrices the entries are left out."""
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
    transposed: bool


@dataclass(frozen=True)
class MassMatrix:
    """What the page has of the matrix."""

    groups: Sequence[str]
    blocks: Sequence[Sequence[BlockCell]]
    names: Sequence[str]
    """The coordinates in words, in the order of `v`."""
    entries: Sequence[Sequence[str]]
    """Numbers; empty for a matrix that is too large."""
    posture: str


def mass_matrix(chain: Chain, at: Sequence[float] | None = None) -> MassMatrix:
    """The matrix in the coordinates ``at`` (nq,), by default in the posture in which all are at home."""
    q = np.array(chain.home if at is None else at, float)
    every = groups(chain)
    shown = [_html(group) for group in every]
    M = Numeric(chain).mass_matrix(q) if chain.nv <= MANY else np.zeros((0, 0))
    scale = np.sqrt(np.outer(np.diag(M), np.diag(M)))
    entries = [[_number(x, s) for x, s in zip(row, sizes, strict=True)] for row, sizes in zip(M, scale, strict=True)]
    return MassMatrix(shown, [[_cell(chain, a, b) for b in every] for a in every], words(chain), entries, _posture(at))


def _posture(at: Sequence[float] | None) -> str:
    if at is None:
        return "all coordinates at home, joints at 0 and links straight; --at gives another posture"
    return "q = " + ", ".join(f"{x:g}" for x in at)


def _html(group: Group) -> str:
    letter = {"joint": "q", "modes": "η", "rotors": "ϑ"}[group.kind]
    return letter if group.kind == "rotors" else f"{letter}{group.link + 1}"


def _cell(chain: Chain, a: Group, b: Group) -> BlockCell:
    formula = (
        "" if not related(chain, a, b) else "own" if a.link == b.link or "rotors" in (a.kind, b.kind) else "carried"
    )
    return BlockCell(_html(a), _html(b), f"{a.size} × {b.size}", formula, a.first > b.first)


def _number(value: float, scale: float) -> str:
    return "0" if abs(value) <= ZERO * scale else f"{value:.5g}"


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
