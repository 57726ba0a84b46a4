"""The equation of motion of a robot as a whole: its terms, and the blocks of its mass matrix."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from ...topology.chain import Chain
from ..templates import render
from . import inputs
from .algorithm import axis_terms, joint_terms
from .content import DocumentSection, Item, Paragraph, parse
from .forces import BORNE
from .layout import PAGE, matrix, width

MOTION, MASS = "Equation of motion", "Mass matrix"
SHOWN = 2
"""Of a matrix that is too wide the blocks of that many links are written."""


class Group(NamedTuple):
    """The coordinates that share a block: of the ``joint`` or the ``modes`` of a link, or of the ``rotors``."""

    kind: str
    link: int
    first: int
    """The place of the first of them in `v`."""
    size: int

    @property
    def symbol(self) -> str:
        letter = {"joint": "q", "modes": r"\eta", "rotors": r"\vartheta"}[self.kind]
        return letter if self.kind == "rotors" else f"{letter}_{self.link + 1}"


def groups(chain: Chain) -> list[Group]:
    """In the order of `v`."""
    joints = [Group("joint", i, at, chain.v_offset[i + 1] - at) for i, at in enumerate(chain.v_offset[:-1])]
    rotors = [Group("rotors", 0, chain.eta_v - chain.n_added, chain.n_added)]
    modes = [Group("modes", i, chain.eta_v + chain.eta_offset[i], key.modes) for i, key in enumerate(chain.keys)]
    return [group for group in (*joints, *rotors, *modes) if group.size]


def related(chain: Chain, a: Group, b: Group) -> bool:
    """Whether the block of two groups has entries: one of their links carries the other, or they are of one."""
    if "rotors" in (a.kind, b.kind):
        other = a if b.kind == "rotors" else b
        ahead = [chain.added_joints.index(k) for k in chain.elastic_travels] if chain.n_added else []
        return a.kind == b.kind or (other.kind == "joint" and any(_axis_of(chain, k) == other.link for k in ahead))
    return a.link in _carriers(chain, b.link) or b.link in _carriers(chain, a.link)


def _axis_of(chain: Chain, added: int) -> int:
    """The link of the axis of an added coordinate."""
    joint = chain.added_joints[added]
    return next(i for i in range(chain.n) if chain.tau_offset[i] <= joint < chain.tau_offset[i + 1])


def _carriers(chain: Chain, link: int) -> list[int]:
    """A link and all that carry it."""
    out = []
    while link >= 0:
        out.append(link)
        link = chain.tree.parents[link]
    return out


def pattern(chain: Chain) -> tuple[str, bool]:
    """The LaTeX of the mass matrix by blocks, and whether links are left out."""
    every = groups(chain)
    if len(every) < PAGE:  # a column takes an em at least
        text = _matrix(chain, every)
        if width(text) <= PAGE - 6.0:
            return text, False
    few: list[Group | None] = []
    for kind in ("joint", "rotors", "modes"):
        own = [g for g in every if g.kind == kind]
        few += [*own[:SHOWN], *([None] if len(own) > SHOWN else [])]
    return _matrix(chain, few), True


def _matrix(chain: Chain, shown: Sequence[Group | None]) -> str:
    return matrix([[_cell(chain, a, b) for b in shown] for a in shown])


def _cell(chain: Chain, a: Group | None, b: Group | None) -> str:
    if a is None or b is None:
        return r"\ddots" if a is b else r"\vdots" if a is None else r"\cdots"
    return block(a, b) if related(chain, a, b) else r"\mathbf{0}"


def block(a: Group, b: Group) -> str:
    """The LaTeX of a block; of one below the diagonal that of its mirror image, transposed."""
    if a.first <= b.first:
        return rf"\mathbf{{M}}_{{{a.symbol}{b.symbol}}}"
    return rf"\mathbf{{M}}_{{{b.symbol}{a.symbol}}}^{{\top}}"


def motion(chain: Chain) -> DocumentSection:
    """The equation of motion as one formula, and what it is made of."""
    besides = ", the slope of a transmission where one lies between" * bool(chain.travel_kinds)
    besides += (
        r", and $-\partial\boldsymbol{\ell}_c$, the derivative of a tendon's length, where its tension meets the modes"
    ) * bool(chain.n_tensions)
    flexible, has = [key for key in chain.keys if key.modes], [name for name, *_ in axis_terms(chain)]
    own = ["stiffness"] * bool(flexible) + ["damping"] * any(key.damping for key in flexible)
    terms = [name for name in ("stiffness", "damping") if name in has]
    acting = ["velocities", "weight", *dict.fromkeys((*own, *terms))]
    modal = rf"The rows of the modes balance the {' and the '.join(own)} of the links, in $\mathbf{{h}}_i$."
    values = {
        "loops": bool(chain.closing.rows),
        "joined": bool(chain.robot.rigid_loops),
        "modal": modal * bool(flexible),
        "acting": f"{', '.join(acting[:-1])} and {acting[-1]}",
        "terms": " and ".join(terms),
        "armatures": "armature" in has,
        "bodies": any(k.bodies_at("tip") for k in chain.keys),
        "besides": besides,
        "borne": BORNE * bool(chain.forces) + inputs.said(chain),
    }
    items = parse(render("latex/motion.tex.jinja", **values))
    return DocumentSection(MOTION, [_sought(item) for item in items])


SOUGHT = {
    "Gravity enters": "gravity, weight, where it enters",
    "a payload among them": "payload in the mass matrix, load, bodies at the tip",
}
"""By a part of a paragraph: the words of readers who look for what it says."""


def _sought(item: Item) -> Item:
    """An item with these words."""
    if not isinstance(item, Paragraph):
        return item
    return replace(item, sought=", ".join(words for part, words in SOUGHT.items() if part in item.text))


def mass_matrix(chain: Chain) -> DocumentSection:
    """The mass matrix by blocks, each with its formula."""
    shown, elided = pattern(chain)
    travels = [kind.LETTERS[0] for kind in chain.travel_kinds] if chain.elastic_travels else []
    values = {
        "pattern": shown,
        "elided": elided,
        "several": chain.n > 1,
        "jointed": any(not key.floats for key in chain.keys),
        "floating": chain.floating,
        "moving": chain.moving,
        "rotors": bool(chain.n_added),
        "ahead": bool(travels),
        "slope": f"{travels[0]}'" if travels else "",
        **joint_terms(chain),
    }
    return DocumentSection(MASS, parse(render("latex/mass_matrix.tex.jinja", **values)))
