"""The equations of a robot as a document: LaTeX, PDF, HTML, and in a notebook."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import replace
from fractions import Fraction
from math import factorial
from typing import Any

import numpy as np

from ...algebra.components import Array
from ...algorithms.scope import derived
from ...ir.block import Block
from ...notebook import markdown_table, plain, steps_table
from ...plugins import Plugin, merged
from ...spec.link_class import EXACT, LinkClass
from ...spec.robot import Robot
from ...topology.chain import Chain
from ...version import __version__
from ..numpy.loop_rows import choose_rows
from ..templates import render
from . import algorithm, check_value, coordinates, elements, forces, inputs, motion, numbers, tables, text
from .algorithm import ALGORITHM
from .at_rest import at_rest
from .blocks import LETTERS
from .content import (
    CITATION,
    MODES,
    PARAMETERS,
    SYMBOLS,
    Document,
    DocumentSection,
    Heading,
    Item,
    Paragraph,
    parse,
)
from .drawing_writers import picture
from .joints import joints
from .layout import one_line
from .link_class import PrintedClasses, class_section, ordered
from .notation import Notation, respelled
from .occurring import occurring
from .page import extras as extras
from .page import math_font as math_font
from .page import page as page
from .parameter_symbols import with_symbols
from .pattern import pattern
from .printed import USUAL, WHOLE_ROWS, is_short, printed, room
from .robot_tables import besides
from .sketch import figure
from .steps import KEY_STEPS, BlockView, Seen, block_view
from .style import DocumentStyle
from .symbols import entries
from .text_symbols import SLIDING, THEORY

PLAIN = DocumentStyle()
TENSION = r" - \sum\limits_c T_c\,\begin{bmatrix} \mathbf{0} \\ \partial\boldsymbol{\ell}_c \end{bmatrix}"
"""What the tensions of tendons do to the rows of a link."""
DERIVATION = "Derivation"
BEYOND = 9
"""Where Stumpff functions have check values: beyond the range of their series."""
BIASES = ("beta_omega", "beta_v")
"""The steps of the accelerations that velocities cause at a joint."""
NAMED = {"tip": ("b_omega", "b_v"), "tip_body": ("m_T", "S_T", "I_T", "h_T_tau", "h_T_F")}
"""By block: the steps that lines of the algorithm ask for, of which it is said where they are zero."""


def document(
    robot: Robot, plugins: Sequence[Plugin] = (), style: DocumentStyle = PLAIN, notation: Notation | None = None
) -> str:
    """A LaTeX document with the equations of ``robot``; needs amsmath, booktabs and longtable alone."""
    return tex(content(robot, plugins, notation), style)


def html(robot: Robot, plugins: Sequence[Plugin] = (), notation: Notation | None = None) -> str:
    """The same document as one HTML page with MathML, which needs nothing else; it shows the lines of generated C."""
    return page(content(robot, plugins, notation), extras(chain_of(robot)))


def chain_of(robot: Robot) -> Chain:
    """The links of a robot, with the rows of its loops that bear forces."""
    chain = Chain(robot)
    choose_rows(chain)
    return chain


def tex(shown: Document, style: DocumentStyle = PLAIN) -> str:
    """A document in LaTeX, or a fragment of one."""
    template = "latex/fragment.tex.jinja" if style.fragment else "latex/document.tex.jinja"
    values = {"text": text.tex, "rows": text.tex_rows, "picture": picture, "is_short": is_short, "room": room}
    return render(
        template, document=printed(shown, style.whole), style=style, usual=USUAL, whole_rows=WHOLE_ROWS, **values
    )


def notebook(robot: Robot) -> str:
    """A short piece of Markdown: the robot's links and the blocks of each class, for notebooks."""
    chain = Chain(robot)
    table = tables.links(chain)
    cells = (tuple(map(text.in_markdown, row)) for row in (table.head, *table.rows))
    parts = [f"**{plain(robot.name)}**: {plain(robot.summary)}\n", markdown_table(next(cells), cells)]
    alike: dict[str, list[str]] = {}
    for number, key in enumerate(chain.classes, 1):
        steps = [s for s in block_view(derived(key)["link"]).steps if s.name in KEY_STEPS]
        rows = [(s.name, one_line(s.formula), s.unit, s.frame, s.meaning, s.equation) for s in steps]
        alike.setdefault(steps_table(rows), []).append(str(number))
    parts += [f"Class {' and '.join(numbers)}: the blocks of its equations\n\n{it}" for it, numbers in alike.items()]
    return "\n".join(parts)


# -------------------------------------------------------------------------------------------- content


def content(robot: Robot, plugins: Sequence[Plugin] = (), notation: Notation | None = None) -> Document:
    """The document of a robot, independent of the output format, in the paper's letters or in a ``notation``."""
    chain = chain_of(robot)
    plugins = [p for p in plugins if p.trees or (chain.serial and not chain.n_added)]
    chapters = [chapter for p in plugins if (chapter := p.chapter(chain)) is not None]
    blocks = {key: class_blocks(key, plugins) for key in chain.classes}
    if alone(chain):
        blocks = {key: at_rest(own) for key, own in blocks.items()}
    carrying = {chain.keys[parent] for parent in chain.tree.parents if parent >= 0}
    told = {block: names for block, names in NAMED.items() if block != "tip_body" or algorithm.bodies(chain)}
    views = {key: class_views(key, blocks[key], key in carrying, told) for key in chain.classes}
    known = [(blocks[key][view.name], view) for key in chain.classes for view in views[key]]
    named = [
        *THEORY,
        *(SLIDING if chain.slides else ()),
        *elements.symbols(chain),
        *forces.symbols(chain),
        *inputs.symbols(chain),
        *(symbol for chapter in chapters for symbol in chapter.symbols),
    ]
    symbols = entries(known, named)
    further = [pair for chapter in chapters for pair in chapter.views]
    symbols += [e for e in entries(further) if e.display not in {entry.display for entry in symbols}]
    sections = [_robot(robot, chain), _conventions(robot, chain), motion.motion(chain)]
    lines = algorithm.lines(chain, any(step.name in BIASES for own in views.values() for v in own for step in v.steps))
    parts = {key: algorithm.parted(lines, views[key], key) for key in chain.classes}
    given = algorithm.items(lines, [view for key in chain.classes for view in parts[key][0]], chain.classes)
    sections.append(DocumentSection(ALGORITHM, [*given, *check_value.items(chain)]))
    sections.append(motion.mass_matrix(chain))
    shown_steps: dict[LinkClass, dict] = {key: {} for key in chain.classes}
    sections += _classes(chain, parts, shown_steps, appendix=False)
    sections += filter(None, [joints(chain)])
    sections.append(_derivation(robot, chain))
    sections += [s for chapter in chapters for s in chapter.sections]
    sections += _classes(chain, parts, shown_steps, appendix=True)
    if (table := numbers.modes(chain)) is not None:
        sections.append(DocumentSection(MODES, [Paragraph(numbers.about(numbers.ALONE, chain)), table]))
    sections += [
        DocumentSection(SYMBOLS, [tables.symbols(occurring(symbols, sections))]),
        DocumentSection(PARAMETERS, [tables.parameters(with_symbols(chain))]),
    ]
    shown = Document(robot.name, __version__, tuple(sections))
    if notation is None:
        return shown
    own = [block for block, _ in (*known, *further)]
    signals = [s for block in own for s in (*block.inputs.values(), *(x.signal for x in block.steps.values()))]
    return respelled(shown, notation, signals)


def _classes(
    chain: Chain, parts: Mapping[LinkClass, Sequence[list[BlockView]]], shown: Mapping[LinkClass, dict], appendix: bool
) -> Iterator[DocumentSection]:
    """The sections of the classes: what the algorithm needs, or the further forms of their equations."""
    printed = PrintedClasses()
    for number, key in enumerate(chain.classes, 1):
        members = [name for name, k in zip(chain.names, chain.keys, strict=True) if k == key]
        yield class_section(number, key, members, parts[key][appendix], printed, shown[key], appendix)


def class_blocks(key: LinkClass, plugins: Sequence[Plugin] = ()) -> dict[str, Block]:
    """The blocks that the section of a class shows."""
    return merged("block", derived(key), *(p.blocks(key) for p in plugins))


def alone(chain: Chain) -> bool:
    """Whether a robot is one link on a base at rest."""
    return chain.n == 1 and not chain.floating


def class_views(
    key: LinkClass, blocks: Mapping[str, Block], carrying: bool = True, told: Mapping[str, Sequence[str]] = NAMED
) -> tuple[BlockView, ...]:
    """The blocks of a class in a reader's order; a step that an earlier block has is not shown again.

    ``carrying``: whether a link of the class carries another. ``told``: as `NAMED`.
    """
    seen: dict[str, Seen] = {}
    letters = [LETTERS[direction] for direction, _ in key.directions if direction in LETTERS]
    parts = tuple(Counter(letters).items())
    next_joint = {} if carrying else {"X": np.zeros((6, 6), dtype=int), "PX": np.zeros((6, 6), dtype=int)}
    given = (tables.named_axes(key), structure(key, blocks) | next_joint, (key.joints, key.modes), parts)
    out: list[BlockView] = []
    for name in ordered(blocks):
        out.append(block_view(blocks[name], seen, *given, told=told.get(name, ())))
        if name == "tip":
            out += station_views(key, seen, given, {step.name for step in out[-1].steps})
    return tuple(out)


def station_views(
    key: LinkClass, seen: Mapping[str, Seen], given: tuple[Any, Any, Any, Any], told: Set[str]
) -> Iterator[BlockView]:
    """The steps of the sections before the tip at which links are carried, where they differ from those of the tip.

    ``told``: the names of the steps of the tip.
    """
    for number, place in enumerate(key.stations_at):
        block = derived(key.station(number))["tip"]
        yield replace(block_view(block, dict(seen), *given, told=told), title=f"Section at $s = {place:.6g}$")


def structure(key: LinkClass, blocks: Mapping[str, Block]) -> dict[str, Array]:
    """The inputs of the assembled rows from other blocks; zeros and identities among them are not displayed."""
    tip, joint, r = blocks["tip"].values, blocks["joint"].values, key.modes
    still = {"R_T": np.eye(3, dtype=int), "J_l": np.eye(3, dtype=int), "Psi_c": np.zeros((3, r), dtype=int)}
    bare = {} if key.bodies_at("tip") else {"M_T": np.zeros((6, 6), dtype=int), "h_T": np.zeros((6, 1), dtype=int)}
    return {"R_rel": joint["R_rel"], "Phi_c": tip["Phi_c"]} | {n: tip.get(n, v) for n, v in still.items()} | bare


def _robot(robot: Robot, chain: Chain) -> DocumentSection:
    links = f"{len(robot.links)} link{'s' if len(robot.links) > 1 else ''}"
    pieces = sum(link.pieces for link in robot.links)
    links += f" of {pieces} segments" if pieces > len(robot.links) else ""
    markers = chain.n - pieces
    links += f", {forces.markers(chain, markers)}" if markers else ""
    joints = f"{chain.n_joints} joint coordinate{'s' if chain.n_joints != 1 else ''}"
    joints += f", {chain.n_added} of rotors" if chain.n_added else ""
    tendons = f", {chain.n_tensions} tendon{'s' * (chain.n_tensions > 1)}" if chain.n_tensions else ""
    count = f"{links}, {f'a {chain.robot.base} base, ' * chain.floating}{joints}, {chain.n_modes} modal{tendons}"
    items: list[Item] = [
        figure(chain),
        Paragraph(f"`{robot.name}`: {count}. Links of one class share their equations."),
        *coordinates.tables(chain),
        Heading("Links"),
        Paragraph(
            "A link sits on the tip of the one above it, the first on the base, unless its remarks name another; "
            "`world` is the base. A link carries those that sit on it and no others."
        ),
        tables.links(chain),
        *besides(chain),
    ]
    return DocumentSection("The robot", items)


def _conventions(robot: Robot, chain: Chain) -> DocumentSection:
    gravity = ", ".join(f"{g:g}" for g in robot.gravity)
    text = render(
        "latex/conventions.tex.jinja",
        gravity=rf"[{gravity}]^{{\top}}".replace(", ", r",\ "),
        own_fall=inputs.OWN_FALL if chain.falls else inputs.FALL,
        stated=f" {inputs.STATED}" * chain.falls,
        citation=CITATION,
        assumptions=chain.assumptions("`"),
        placed=any(key.frame_at for key in chain.keys),
        modes=bool(chain.n_modes),
        turning=robot.section_rotation and any(key.modes for key in chain.keys),
        beyond=BEYOND,
        values=", ".join(tables.exact(stumpff(k, BEYOND)) for k in range(1, 6)),
    )
    return DocumentSection("Conventions", parse(text))


def stumpff(k: int, x: int) -> float:
    """A Stumpff function to the last digit: its series, in fractions."""
    return float(sum(Fraction((-x) ** j, factorial(k + 2 * j)) for j in range(40)))


def _derivation(robot: Robot, chain: Chain) -> DocumentSection:
    """How the equations of a link, of its tip and of its joint come about."""
    exact = any(key.order == EXACT for key in chain.keys)
    text = render(
        "latex/equations.tex.jinja",
        section_rotation=robot.section_rotation,
        unknowns=12 * chain.n + chain.n_modes,
        pattern=pattern(chain, "V"),
        several=chain.n > 1,
        slides=chain.slides,
        tree=not chain.tree.is_chain,
        stations=any(chain.tree.stations),
        floating=chain.floating,
        moving=chain.moving,
        own_fall=inputs.OWN_FALL if chain.falls else inputs.FALL,
        effort=elements.effort(chain),
        first_order=all(key.order == 1 for key in chain.keys),
        exact=exact,
        M_eta=r"\mathbf{M}_{\eta,i}" if exact else r"\mathbf{M}_{W\phi,i}",
        tendons=bool(chain.n_tensions),
        tension=TENSION if chain.n_tensions else "",
        S=r"\mathbf{S}_i\," if chain.slides else r"\begin{bmatrix} \mathbf{A}_i \\ \mathbf{0} \end{bmatrix} ",
    )
    return DocumentSection(DERIVATION, parse(text), appendix=True)
