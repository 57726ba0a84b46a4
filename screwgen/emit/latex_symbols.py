"""The symbols of a document, gathered from the signals of its blocks."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from ..algebra.expression import Symbol
from ..algebra.notation import latex
from ..derive.block import Binding, Block, Signal
from .latex_content import frame, unit, words
from .latex_steps import BlockView

FIELDS = {
    "r_b": ("undeformed position of the element at ξ", "m"),
    "rho": ("position of the element at ξ", "m"),
    "u": ("elastic displacement of the element at ξ", "m"),
    "udot": ("rate of the elastic displacement", "m/s"),
    "udot_modal": ("rate of the elastic displacement", "m/s"),
    "Phi": ("displacement shapes, a column for each mode", "-"),
    "phi_row": ("displacement shapes in a row, whatever their direction", "-"),
    "phi_t": ("torsion shapes in a row", "-"),
    "strain": ("strains of each mode: u_x', u_y'', u_z'', rate of twist", "-"),
    "Phi_tip": ("displacement shapes at the tip", "-"),
    "Psi_tip": ("turn of the section at the tip by each mode", "1/m"),
    "x_of": ("axial shapes in a row", "-"),
    "y_of": ("shapes of bending in y in a row", "-"),
    "z_of": ("shapes of bending in z in a row", "-"),
    "ones": ("column of ones", "-"),
}
"""What varies along the link, and has no signal of its own."""

SYSTEM = (
    (r"\mathcal{F}_i", "frame of link $i$", "", ""),
    (r"\xi", "place on the centreline, from the origin of F_i", "m", ""),
    (r"s", "place on the centreline from base to tip, 0 to 1", "-", ""),
    (r"\mathbf{V}_i", "twist of F_i", "rad/s, m/s", "6"),
    (r"\boldsymbol{\nu}_i", "twist and modal rates", "", "6 + r_i"),
    (r"\mathbf{w}_i", "wrench of link $i-1$ on link $i$ at the joint point", "N*m, N", "6"),
    (r"\boldsymbol{\mathcal{W}}^*_i", "wrench on the link", "N*m, N", "6"),
    (r"\mathbf{f}^*_i", "forces on the modes", "N", "r_i"),
    (r"\mathbf{D}^*_i", "what the deformation's inertia adds to the twist rows", "N*m, N", "6"),
    (r"\mathbf{M}_i", "inertia of twist and modes together", "", "6 + r_i, square"),
    (r"\mathbf{h}_i", "bias of twist and modal rows together", "", "6 + r_i"),
    (r"\mathbf{J}_T", "takes twist and modal rates to the tip's twist", "", "6 × (6 + r_i)"),
    (r"\boldsymbol{\mathcal{W}}_{ext,i}", "external wrench on the tip section, tip frame", "N*m, N", "6"),
    (r"\boldsymbol{\tau}_i", "torques of the joint's motors", "N*m", "n_{q,i}"),
    (r"\mathbf{b}_T", "rate of the tip's twist that the velocities cause", "rad/s^2, m/s^2", "6"),
    (r"\mathbf{X}_i", "takes the parent tip's twist to the joint point in F_i", "", "6 × 6"),
    (r"\mathbf{J}_B", "takes the twist of F_i to the joint point", "", "6 × 6"),
    (r"\mathbf{r}_B", "joint point in F_i", "m", "3"),
    (r"\mathbf{r}_m", "joint point from the parent's tip point, parent's tip frame", "m", "3"),
    (r"\boldsymbol{\beta}_i", "rate of the twist that the velocities cause at the joint", "rad/s^2, m/s^2", "6"),
    (r"\mathbf{P}_i", "projector onto what the joint blocks", "-", "6 × 6"),
    (r"\mathbf{A}_i^{+}", "pseudo-inverse of the joint's axes", "-", "n_{q,i} × 3"),
    (r"\mathbf{M}_T", "inertia of the bodies at the tip, tip frame", "", "6 × 6"),
    (r"\mathbf{h}_T", "bias of the bodies at the tip, tip frame", "N*m, N", "6"),
    (r"\mathbf{J}_m", "armature of the joint, rotor inertias seen at its axes", "kg*m^2", "n_{q,i} × n_{q,i}"),
    (r"\mathbf{D}_q,\ \mathbf{S}_q", "damping and stiffness of the joint", "N*m*s/rad, N*m/rad", "n_{q,i} × n_{q,i}"),
    (r"\boldsymbol{\Lambda},\ \mathbf{p}", "inertia and bias of what the tip section carries", "", "6 × 6, 6"),
    (r"\boldsymbol{\Psi},\ \boldsymbol{\Psi}_Z", "joint wrenches with rates of twists, or of Z", "", "12 n"),
    (r"\mathbf{T}_{\gamma},\ \boldsymbol{\Gamma}^{*}", "change from one to the other", "", "12 n × 12 n, 12 n"),
    (r"\mathbf{M}_{dyn},\ \mathbf{h}_{dyn}", "dynamic rows of the Z-form, and their bias", "", "12 n × 12 n, 12 n"),
    (r"\mathbf{h}_{M_s}", "bias of the change to Z in the dynamic rows", "", "12 n"),
    (r"\mathbf{x}_c", "state of the Cauchy form", "", r"12 n + 2 \sum r_i"),
    (r"\mathbf{A}_c,\ \mathbf{g}_c", "matrix and free term of the Cauchy form", "", ""),
    (r"\mathbf{g}", "free fall, inertial frame", "m/s^2", "3"),
)
"""The symbols of the text: LaTeX, meaning, unit, shape."""


@dataclass(frozen=True)
class Entry:
    """One line of the table of symbols."""

    display: str
    meaning: str
    unit: str
    frame: str
    shape: str
    binding: Binding | None


def entries(blocks: Iterable[tuple[Block, BlockView]]) -> list[Entry]:
    """The symbols of the text, then those of the steps: fields, parameters and constants, state."""
    found: dict[str, list[tuple[str, Signal]]] = {}
    for block, view in blocks:
        for signal in _signals(block, view):
            found.setdefault(written(signal), []).append((block.name, signal))
    steps = [_entry(display, [s for _, s in known]) for display, known in found.items()]
    steps.sort(key=lambda e: -1 if e.binding is None else int(e.binding))
    return [*(e for e in _system() if e.display not in found), *steps]


def written(signal: Signal) -> str:
    """A signal as the formulas have it."""
    return latex(Symbol(signal.name, signal.shape, signal.display))


def _system() -> Iterator[Entry]:
    for display, meaning, unit_, shape in SYSTEM:
        yield Entry(display, words(meaning), unit(unit_), "", _shape_text(shape), None)


def _signals(block: Block, view: BlockView) -> Iterator[Signal]:
    """The signals that the shown steps define or use."""
    defined = {s.name for s in view.defined}
    yield from (s for s in view.defined if not s.display.startswith("-"))
    for used in view.used:
        if used.name in block.inputs or (used.name in block.steps and used.name not in defined):
            yield block.signal(used.name)
        elif (key := field_key(used.name)) is not None:
            meaning, unit_ = FIELDS[key]
            frame_ = "F_i" if used.shape[0] == 3 and key != "ones" else "-"
            yield Signal(used.name, used.shape, used.display, unit_, frame_, meaning, binding=None)


def field_key(name: str) -> str | None:
    """The field of that name; shapes of one direction and columns of ones have names of their own."""
    keys = (name, *re.findall(r"^phi_([xyz]_of)_", name), *re.findall(r"_(ones)$", name))
    return next((key for key in keys if key in FIELDS), None)


def _entry(display: str, signals: list[Signal]) -> Entry:
    first = signals[0]
    shape = _shape([s.shape for s in signals], first.name)
    binding = None if first.binding is None else max(s.binding for s in signals)
    return Entry(display, words(first.meaning), unit(first.unit), frame(first.frame), shape, binding)


def _shape(shapes: list[tuple[int, int]], name: str) -> str:
    """The shape, with a letter where links differ."""
    letter = "n_{q,i}" if name in ("q", "qdot", "A") else "r_i"
    if set(shapes) == {(1, 1)}:
        return ""
    sizes = [{s[d] for s in shapes} for d in (0, 1)]
    rows, cols = (str(*size) if len(size) == 1 else letter for size in sizes)
    return _shape_text(rows if cols == "1" else rf"{rows} × {cols}")


def _shape_text(shape: str) -> str:
    formula = shape.replace("×", r"\times").replace(", square", "")
    return f"${formula}$" if shape else ""


def displays(table: Mapping[str, Entry] | Iterable[Entry]) -> set[str]:
    """The symbols that a table explains."""
    return {e.display for e in table}
