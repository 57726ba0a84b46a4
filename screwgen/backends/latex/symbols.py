"""The symbols of a document, gathered from the signals of its blocks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ...algebra.expression import Symbol
from ...algebra.notation import latex
from ...ir.block import Binding, Block, NamedSignal
from .content import Named, frame, unit, words
from .steps import BlockView

CONSTANT, PARAMETER, STATE = Binding

TWIST, WRENCH = "rad/s, m/s", "N*m, N"
ALL = r"(6 + r_i) × (6 + r_i)"
SYSTEM: tuple[Named, ...] = (
    (r"\mathcal{F}_i", "frame of link $i$", "-", "-", "-", STATE),
    (r"\xi", "place on the centreline, from the origin of F_i", "m", "1", "F_i", None),
    (r"s", "place on the centreline from base to tip, 0 to 1", "-", "1", "-", None),
    (r"\mathbf{V}_i", "twist of F_i", TWIST, "6", "F_i", STATE),
    (r"\boldsymbol{\nu}_i", "twist and modal rates", TWIST, "6 + r_i", "F_i", STATE),
    (r"\mathbf{w}_i", "wrench of link $i-1$ on link $i$ at the joint point", WRENCH, "6", "F_i", STATE),
    (r"\boldsymbol{\mathcal{W}}^*_i", "wrench on the link", WRENCH, "6", "F_i", STATE),
    (r"\mathbf{f}^*_i", "forces on the modes", "N", "r_i", "-", STATE),
    (r"\mathbf{D}^*_i", "what the deformation's inertia adds to the twist rows", WRENCH, "6", "F_i", STATE),
    (r"\mathbf{M}_i", "inertia of twist and modes together", "kg, kg*m, kg*m^2", ALL, "F_i", STATE),
    (r"\mathbf{h}_i", "bias of twist and modal rows together", WRENCH, "6 + r_i", "F_i", STATE),
    (r"\mathbf{J}_T", "takes twist and modal rates to the tip's twist", "1, m, 1/m", "6 × (6 + r_i)", "tip", STATE),
    (r"\boldsymbol{\mathcal{W}}_{ext,i}", "external wrench on the tip section", WRENCH, "6", "tip", STATE),
    (r"\boldsymbol{\tau}_i", "torques of the joint's motors", "N*m", "n_{q,i}", "-", STATE),
    (r"\mathbf{b}_T", "rate of the tip's twist that the velocities cause", "rad/s^2, m/s^2", "6", "tip", STATE),
    (r"\mathbf{X}_i", "takes the parent tip's twist to the joint point", "1, m", "6 × 6", "F_i", STATE),
    (r"\mathbf{J}_B", "takes the twist of F_i to the joint point", "1, m", "6 × 6", "F_i", PARAMETER),
    (r"\mathbf{r}_B", "joint point", "m", "3", "F_i", PARAMETER),
    (r"\mathbf{r}_M", "joint point from the parent's tip point", "m", "3", "parent's tip", PARAMETER),
    (r"\boldsymbol{\beta}_i", "joint's rate of the twist due to velocities", "rad/s^2, m/s^2", "6", "F_i", STATE),
    (r"\mathbf{P}_i", "projector onto the directions that the joint constrains", "-", "6 × 6", "F_i", STATE),
    (r"\mathbf{A}_i^{+}", "pseudo-inverse of the joint's axes", "-", "n_{q,i} × 3", "F_i", STATE),
    (r"m_T", "mass of the bodies at the tip", "kg", "1", "-", PARAMETER),
    (r"\mathbf{s}_T", "first moment of the bodies at the tip", "kg*m", "3", "tip", PARAMETER),
    (r"\mathbf{I}_T", "inertia of the bodies at the tip about the tip point", "kg*m^2", "3 × 3", "tip", PARAMETER),
    (r"\mathbf{h}_{T\tau}", "bias moment of the bodies at the tip", "N*m", "3", "tip", STATE),
    (r"\mathbf{h}_{TF}", "bias force of the bodies at the tip", "N", "3", "tip", STATE),
    (
        r"\boldsymbol{\beta}_{\omega}",
        "angular part of the joint's rate due to velocities",
        "rad/s^2",
        "3",
        "F_i",
        STATE,
    ),
    (r"\boldsymbol{\beta}_{v}", "linear part of the joint's rate due to velocities", "m/s^2", "3", "F_i", STATE),
    (r"\mathbf{b}_{\omega}", "angular part of the tip's rate due to velocities", "rad/s^2", "3", "tip", STATE),
    (r"\mathbf{b}_{v}", "linear part of the tip's rate due to velocities", "m/s^2", "3", "tip", STATE),
    (r"\mathbf{M}_T", "inertia of the bodies at the tip", "kg, kg*m, kg*m^2", "6 × 6", "tip", PARAMETER),
    (r"\mathbf{h}_T", "bias of the bodies at the tip", WRENCH, "6", "tip", STATE),
    (r"\mathbf{J}_m", "armature, rotor inertias seen at the axes", "kg*m^2", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{D}_q", "damping of the joint", "N*m*s/rad", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{K}_q", "stiffness of the joint", "N*m/rad", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{g}", "free fall", "m/s^2", "3", "inertial", PARAMETER),
)
"""The symbols of the text."""

SLIDING: tuple[Named, ...] = (
    (r"\boldsymbol{\tau}_i", "torques of the joint's drives, of slides forces", "N*m, N", "n_{q,i}", "-", STATE),
    (r"\mathbf{S}_i^{+}", "pseudo-inverse of the joint's motion subspace", "-", "n_{q,i} × 6", "F_i", STATE),
    (r"\mathbf{J}_m", "armature, of the drives at the axes", "kg*m^2, kg", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{D}_q", "damping of the joint", "N*m*s/rad, N*s/m", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{K}_q", "stiffness of the joint", "N*m/rad, N/m", "n_{q,i} × n_{q,i}", "-", PARAMETER),
)
"""Symbols of robots whose joints slide, in place of those above."""

TIMES = r"\times"
COUNTED = ("n_{q,i}", "r_i")
"""The numbers of joint rates and of modes of a link."""
Counted = tuple[NamedSignal, tuple[int, int]]
"""A signal, and these numbers in the class of links whose block has it."""


@dataclass(frozen=True)
class Entry:
    """One line of the table of symbols."""

    display: str
    meaning: str
    unit: str
    frame: str
    shape: str
    binding: Binding | None


def entries(blocks: Iterable[tuple[Block, BlockView]], named: Iterable[Named] = ()) -> list[Entry]:
    """The symbols of the text and those ``named`` beside, then those of the steps: constants, parameters, state.

    A symbol that is ``named`` replaces that of the text.
    """
    found: dict[str, list[Counted]] = {}
    for block, view in blocks:
        for signal in _signals(block, view):
            found.setdefault(written(signal), []).append((signal, view.counts))
    steps = [_entry(display, known) for display, known in found.items()]
    steps.sort(key=lambda e: Binding.CONSTANT if e.binding is None else e.binding)
    text = {symbol[0]: symbol for symbol in (*SYSTEM, *named)}
    return [*(e for e in _text(text.values()) if e.display not in found), *steps]


def written(signal: NamedSignal) -> str:
    """A signal as the formulas have it."""
    return latex(Symbol(signal.name, signal.shape, signal.display))


def _text(symbols: Iterable[Named]) -> Iterator[Entry]:
    for display, meaning, unit_, shape, frame_, binding in symbols:
        yield Entry(display, words(meaning), unit(unit_), frame(frame_), _shape_text(shape), binding)


def _signals(block: Block, view: BlockView) -> Iterator[NamedSignal]:
    """The signals that the shown steps define or use."""
    defined = {s.name for s in view.defined}
    yield from (s for s in view.defined if not s.display.startswith("-"))
    for used in view.used:
        if used.name in block.inputs or (used.name in block.steps and used.name not in defined):
            yield block.signal(used.name)
        elif used.name in block.along:
            yield block.along[used.name]


def _entry(display: str, known: list[Counted]) -> Entry:
    first, _ = known[0]
    rows, cols = (_size([(s.shape[d], counts) for s, counts in known]) for d in (0, 1))
    binding = max(s.binding for s, _ in known)
    shape = _shape_text(rows if cols == "1" else f"{rows} × {cols}")
    return Entry(display, words(first.meaning), unit(first.unit), frame(first.frame), shape, binding)


def _size(sizes: list[tuple[int, tuple[int, int]]]) -> str:
    """A dimension: a number, or where links differ the letter of what it is the number of in each of them."""
    found = sorted({size for size, _ in sizes})
    letters = (letter for k, letter in enumerate(COUNTED) if all(counts[k] == size for size, counts in sizes))
    return str(*found) if len(found) == 1 else next(letters, r"\text{ or }".join(map(str, found)))


def _shape_text(shape: str) -> str:
    return "" if shape == "-" else ", ".join(f"${part.replace('×', TIMES)}$" for part in shape.split(", "))
