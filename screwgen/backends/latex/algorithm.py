"""The algorithm of forward dynamics: numbered lines in the order of evaluation, and what they take as given."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from functools import lru_cache
from itertools import count
from typing import NamedTuple

import sympy as sp

from ...algebra.notation import latex
from ...algebra.rewrite import symbols
from ...joints.constraints import Angle, Distance
from ...spec.link_class import LinkClass
from ...topology.chain import Chain
from ..templates import render
from . import elements, forces, inputs
from .content import Display, DocumentTable, Item, Paragraph, parse
from .layout import Row
from .link_class import FIELD, pointwise, prose_of_field, said_of_field
from .steps import BlockView, StepView

ALGORITHM = "Algorithm"
NUMBER = re.compile(r"\(A#\)")
LABEL = r"\text{"
GIVEN = "@@given"
"""What stands in the template where the table of given symbols goes."""
ALONE = r"(?<![\\A-Za-z_])(?<!_\{)(?<!\w,)(?<!mathbf\{)"
"""What stands before a symbol: a letter that is bold or an index is another symbol or none."""
TENSION = r" + \sum\limits_c T_c\,\begin{bmatrix} \mathbf{0} \\ \partial\boldsymbol{\ell}_c \end{bmatrix}"
"""What the tensions of tendons do to the rows of a link."""
MAIN = ("section", "element", "section_spin", "section_load", "link", "tip", "tip_body", "joint", "link_rows", "tendon")
"""The blocks that the algorithm needs; the others are further forms of the equations."""
SPARE = "No line needs these, which the sections of the classes print for what they say:"
SHARED = ("tip", "link_rows")
"""Those of them with steps for further forms, too."""


def lines(chain: Chain, biased: bool) -> list[Item]:
    """The text and the numbered lines; a place is left for the table of what they take as given.

    ``biased``: whether the velocities cause accelerations at a joint.
    """
    number = count(1)
    text = NUMBER.sub(lambda _: f"(A{next(number)})", render("latex/algorithm.tex.jinja", **_values(chain, biased)))
    return parse(text)


def items(lines: Sequence[Item], views: Iterable[BlockView], keys: Collection[LinkClass]) -> Iterator[Item]:
    """The content of the section. ``views``: the blocks that the lines need, of all classes, the ``keys``."""
    for item in lines:
        if isinstance(item, Paragraph) and item.text == GIVEN:
            yield from _given(lines, views, keys)
        else:
            yield item


class SymbolSource(NamedTuple):
    """What gives a symbol: the part of a class, the symbol as it is printed, and all that it is made of."""

    part: str
    symbol: str
    text: str


def _given(lines: Sequence[Item], views: Iterable[BlockView], keys: Collection[LinkClass]) -> Iterator[Item]:
    """The symbols that lines and other parts of a class take from a part of it, each with the line that first needs it.

    A line needs what it uses, and what that is made of. Then the symbols that no line needs.
    """
    sources = _sources(views, keys, defined(lines))
    uses = {name: [x for x in sources if x != name and occurs(x, own.text)] for name, own in sources.items()}
    taken = {x for name, own in uses.items() for x in own if sources[x].part != sources[name].part}
    first: dict[str, str] = {}
    for row in (row for row in _rows(lines) if row[-1].startswith(LABEL)):
        needed = [x for x in sources if occurs(x, row[1])]
        taken.update(needed)
        while needed:
            if (name := needed.pop()) not in first:
                first[name] = row[-1].removeprefix(LABEL).removesuffix("}")
                needed += uses[name]
    rows: dict[str, list[str]] = {}
    numbers = list(dict.fromkeys(first.values()))
    for name in sorted(taken & first.keys(), key=lambda x: (numbers.index(first[x]), list(sources).index(x))):
        rows.setdefault(sources[name].part, []).append(f"${sources[name].symbol}$ {first[name]}")
    head = ("part of a class", "what lines and other parts take from it, and the line that first needs it")
    order = dict.fromkeys(source.part for source in sources.values())
    yield DocumentTable(head, (0.2, 0.8), tuple((t, ", ".join(rows[t])) for t in order if t in rows), essential=True)
    prose = " ".join(map(prose_of_field, keys))
    spared = [x for name, x in sources.items() if name not in first and x.part != FIELD and whole(x.symbol)]
    spared = [x for x in spared if not occurs(x.symbol, prose)]
    if spare := ", ".join(f"${own.symbol}$" for own in spared):
        yield Paragraph(f"{SPARE} {spare}.")


def whole(symbol: str) -> bool:
    """Whether it is a symbol of its own: no quotient, no part ``dI`` of an integral."""
    return "/" not in symbol and r"\mathrm{d}" not in symbol


def _sources(views: Iterable[BlockView], keys: Collection[LinkClass], known: Set[str]) -> dict[str, SymbolSource]:
    """By symbol: the steps of all classes, and what the text on a kinematic field says; not what is ``known``."""
    found: dict[str, SymbolSource] = {}
    for symbol, text in (pair for key in keys if pointwise(key) for pair in said_of_field(key)):
        found.setdefault(plain(symbol), SymbolSource(FIELD, symbol, text))
    for view in views:
        for step in view.steps:
            symbol = step.formula[0][0]
            other = found.get(plain(symbol), SymbolSource(view.title, symbol, ""))
            found[plain(symbol)] = other._replace(text=f"{other.text} {_text(step)}")
    return {name: source for name, source in found.items() if name not in known}


def defined(lines: Sequence[Item]) -> set[str]:
    """The symbols that lines define, each by itself or as a part of a column."""
    lefts = [plain(row[0]) for row in _rows(lines)]
    return {plain(part) for left in lefts for part in re.split(r";(?:\\ )?", left.strip("[]"))}


def _rows(lines: Sequence[Item]) -> list[Row]:
    return [row for item in lines if isinstance(item, Display) for row in item.formula]


@lru_cache(maxsize=4096)
def plain(formula: str) -> str:
    """A formula with single letters below others not in braces, without tildes of skew matrices, a space after sums."""
    formula = re.sub(r"(\\sum_\w)", r"\1 ", formula)
    formula = re.sub(r"\\(?:wide)?tilde\{((?:[^{}]|\{[^{}]*\})*)\}", r"\1", formula)
    return re.sub(r"_\{(\\?\w+)\}", r"_\1", formula.strip())


def occurs(symbol: str, formula: str) -> bool:
    """Whether a formula uses a symbol."""
    own, text = plain(symbol), plain(formula)
    return own in text and re.search(ALONE + re.escape(own) + r"(?!\}?[\w{]|\}_)", text) is not None


def parted(
    lines: Sequence[Item], views: Sequence[BlockView], key: LinkClass
) -> tuple[list[BlockView], list[BlockView]]:
    """The steps that the lines need, and all others: further forms of the equations.

    What lines define needs no step, but for a link that floats. Of a link whose blocks are evaluated at points along it
    all steps are needed but those of `SHARED`.
    """
    text = " ".join(plain(cell) for row in _rows(lines) for cell in row[1:])
    known = set() if key.floats else defined(lines)
    left = [step for view in views if view.name in MAIN for step in view.steps]
    left = [step for step in left if plain(step.formula[0][0]) not in known]
    along = {step for view in views if pointwise(key) and view.name not in SHARED for step in view.steps}
    kept = along & set(left)
    text += "".join(map(_text, kept))
    left = [step for step in left if step not in kept]
    while found := [step for step in left if occurs(step.formula[0][0], text)]:
        kept |= set(found)
        left = [step for step in left if step not in found]
        text = "".join(map(_text, found))
    main, others = [], []
    for view in views:
        needed_steps, rest = (tuple(s for s in view.steps if (s in kept) == needed) for needed in (True, False))
        if view.name in MAIN:
            main.append(replace(view, steps=needed_steps))
        if rest:
            others.append(replace(view, steps=rest, zeros=(), identities=()))
    return main, others


def _text(step: StepView) -> str:
    """All that a step says, but for its symbol, and the symbols of which it is made."""
    cells = [cell for row in (*step.formula, *step.components) for cell in row]
    own = step.definition
    labels = sorted({s.name for e in own.entries.flat for s in sp.sympify(e).free_symbols})
    made = [own.labels[name][0] for name in labels] + [latex(symbol) for symbol in symbols(own.right)]
    return " ".join(map(plain, ["", *cells[1:], *made, ""]))


AXES = (
    ("armature", r"\mathbf{J}_m", r"\mathbf{j}_m", r"\ddot{\mathbf{q}}_i"),
    ("damping", r"\mathbf{D}_q", r"\mathbf{d}_q", r"\dot{\mathbf{q}}_i"),
    ("stiffness", r"\mathbf{K}_q", r"\mathbf{k}_q", r"\mathbf{q}_i"),
)
"""What acts on axes linearly: its name, its diagonal matrix, the vector of that, and what it acts with."""
INPUT = r"\boldsymbol{\tau}_i"
BIAS = r" + \hat{\mathbf{M}}_i\,\boldsymbol{\beta}_i"


def _values(chain: Chain, biased: bool) -> Mapping[str, object]:
    keys, loops, several = chain.keys, bool(chain.closing.rows), chain.n > 1
    return {
        "several": several,
        "carrying": several or loops or chain.floating or forces.acting(chain),
        "floating": chain.floating,
        "moving": chain.moving,
        "jointed": any(not key.floats for key in keys),
        "welded": any(not key.floats and not key.joints for key in keys),
        "bodies": bodies(chain),
        "slides": chain.slides,
        "rigid": any(not key.modes for key in keys),
        "stations": any(chain.tree.stations),
        "biased": biased,
        "bias": BIAS if biased else "",
        "carried_bias": r" + \boldsymbol{\beta}_i" if biased else "",
        "tension": TENSION if chain.n_tensions else "",
        "effort": elements.effort(chain),
        "acting": elements.acting(chain),
        "elements": elements.equations(chain),
        "internal": bool(chain.internal),
        "forces": forces.lines(chain),
        "inputs": _inputs(chain),
        "fall": inputs.fall(chain),
        "loops": loops,
        "joined": bool(chain.robot.rigid_loops),
        "distances": any(isinstance(closing.row, Distance) for closing in chain.closing.rows),
        "angles": any(isinstance(closing.row, Angle) for closing in chain.closing.rows),
        "couplings": bool(chain.robot.couplings),
        "markers": any(segment.marker is not None for segment in chain.segments),
        "relations": bool(chain.closing.related),
        "shared": chain.closing.overconstrained,
        **joint_terms(chain),
        **_driving(chain),
        **_held(chain),
        "braked": chain.braked,
    }


def _held(chain: Chain) -> Mapping[str, str]:
    """What brakes make of the rows of axes: what stands before a row and behind it, and before what it is made of."""
    if not chain.braked:
        return dict.fromkeys(("held", "held_inertia", "held_force", "share"), "")
    return {
        "held": rf"{SHARE}\,\left( ",
        "held_inertia": rf" \right) + {GRIP}",
        "held_force": rf" \right) + {GRIP}\,\ddot{{\mathbf{{q}}}}_{{b,i}}",
        "share": rf"{SHARE}\,",
    }


SHARE, GRIP = r"\boldsymbol{\Sigma}_{b,i}", r"\mathbf{J}_{b,i}"


def _driving(chain: Chain) -> Mapping[str, object]:
    """What drives the axes, and what of their motion is free: of axes whose motion is given, nothing."""
    terms = joint_terms(chain)
    free, bias, effort = rf"{terms['S']}_i", r"\hat{\mathbf{h}}_i", f"{elements.effort(chain)}{terms['resisting']}"
    if not (given := elements.moved_axes(chain)):
        return {"given": given, "S_f": free, "S_f_T": rf"{free}^{{\top}}", "h_f": bias, "driving": effort}
    masked = (
        rf"\bar{{\mathbf{{E}}}}_i\,\left( {effort} \right)"
        if terms["resisting"]
        else rf"\bar{{\mathbf{{E}}}}_i\,{effort}"
    )
    return {
        "given": given,
        "S_f": r"\mathbf{S}^f_i",
        "S_f_T": r"{\mathbf{S}^f_i}^{\top}",
        "h_f": r"\hat{\mathbf{h}}^a_i",
        "driving": effort if effort == INPUT else rf"{masked} + \mathbf{{E}}_i\,{INPUT}",
        "armature": (rf"{terms['armature']}\,\bar{{\mathbf{{E}}}}_i" if terms["armature"] else "") + r" + \mathbf{E}_i",
    }


def bodies(chain: Chain) -> bool:
    """Whether the lines have bodies at tips."""
    return any(key.bodies_at("tip") for key in chain.keys)


def axis_terms(chain: Chain) -> list[tuple[str, str, str, str]]:
    """What acts linearly on axes of a robot."""
    keys = [key for key in chain.keys if not key.floats]
    stated = {
        "armature": any(key.armature for key in keys),
        "damping": any(key.joint_damping for key in keys),
        "stiffness": any(key.stiffness for key in keys),
    }
    return [term for term in AXES if stated[term[0]] or elements.driven(chain)]


def joint_terms(chain: Chain) -> Mapping[str, object]:
    """What formulas have of joints: what no joint of a robot has, they are written without."""
    keys, terms = [key for key in chain.keys if not key.floats], axis_terms(chain)
    mounted, placed = chain.slides or any(key.mount_xyz for key in keys), any(key.frame_at for key in keys)
    said = [f"the {name} ${vector}$" for name, _, vector, _ in terms]
    said += [r"the point $\mathbf{r}_M$ of its mount on the section that carries it"] if mounted else []
    said += [r"the angles $\boldsymbol{\alpha}_M$ of its mount"] if any(key.mount_rpy for key in keys) else []
    said += [r"its point $\mathbf{r}_B$ in $\mathcal{F}_i$"] if placed else []
    return {
        "mounted": mounted,
        "placed": placed,
        "point": "J" if chain.slides else "M",
        "of_joints": " and ".join(filter(None, (", ".join(said[:-1]), *said[-1:]))),
        "axis_terms": [{"matrix": matrix, "vector": vector} for _, matrix, vector, _ in terms],
        "armature": r" + \mathbf{J}_m" if AXES[0] in terms else "",
        "resisting": "".join(rf" - {matrix}\,{with_}" for _, matrix, _, with_ in terms if matrix != AXES[0][1]),
        "S": r"\bar{\mathbf{S}}" if placed else r"\mathbf{S}",
        "back_k": r"\mathbf{J}_{B,k}^{-1}\," if placed else "",
        "back": r"\mathbf{J}_B^{-1}\," if placed else "",
        "back_wrench": r"\mathbf{J}_B^{-\top}\," if placed else "",
    }


def _inputs(chain: Chain) -> str:
    if elements.acting(chain):
        return r"$\boldsymbol{\tau}_{q,i}$ what acts on the axes of joint $i$, by the last section"
    if elements.moved_axes(chain):
        return rf"${INPUT}$ the inputs of joint $i$, the entries of $\mathbf{{u}}$ that act on it"
    slides = ", of slides forces" * chain.slides
    return rf"${INPUT}$ the torques of joint $i${slides}, the entries of $\mathbf{{u}}$ that act on it"
