"""What the letters of equations in scalars mean: coordinates, forces, matrices and parameters, as tables."""

from __future__ import annotations

from collections.abc import Iterator

from ...spec.inputs import efforts, input_units
from ...spec.parameters import Parameter, coordinate_names, coordinate_units
from ...topology.chain import Chain
from ..latex import coordinate_symbols
from ..latex.content import DocumentTable
from ..latex.sketch_acting import masses
from ..latex.tables import DIRECTION, NONE, axis_text, decimal
from .equations import Equations
from .names import coordinate_names as letters
from .names import effort_names

MATRICES = {
    "M": "inertia matrix",
    "C": "matrix of Coriolis and centrifugal forces",
    "D": "damping matrix",
    "K": "stiffness matrix",
    "g": "forces of weight, and what else acts at rest",
}
Row = tuple[str, str, str, str]
"""Symbol, meaning, unit, and the name in the robot file, in states and in results."""


def coordinates(chain: Chain, equations: Equations) -> DocumentTable:
    """The coordinates in their order, the forces, the matrices and the common parts."""
    rows = [*_coordinates(chain), *_efforts(chain), *_matrices(chain, equations), *_parts(equations)]
    cells = tuple(tuple(cell or NONE for cell in row) for row in rows)
    return DocumentTable(("symbol", "meaning", "unit", "name"), (0.12, 0.5, 0.1, 0.28), cells)


def parameters(equations: Equations) -> DocumentTable:
    """The parameters that occur, with their values in the robot file."""
    rows = [
        (f"${name.latex}$", _described(p, value), p.unit, f"`{p.name}`", decimal(value))
        for name, value, p in equations.stated
    ]
    head = ("symbol", "meaning", "unit", "name in the robot file", "value")
    return DocumentTable(head, (0.12, 0.33, 0.11, 0.32, 0.12), tuple(rows))


def sketched(chain: Chain, equations: Equations) -> dict[str, str]:
    """The letters of coordinates, efforts, masses and gravity by those that a sketch has of its own."""
    own = [
        *coordinate_symbols.axes(chain),
        *coordinate_symbols.rotors(chain).values(),
        *coordinate_symbols.modes(chain),
    ]
    known = [*own, *coordinate_symbols.inputs(chain)]
    out = dict(zip(known, (name.latex for name in (*letters(chain), *effort_names(chain))), strict=True))
    stated = {(p.link, p.index[0]): name.latex for name, _, p in equations.stated if p.field == "bodies.mass"}
    return out | {letter: stated.get(body, "") for body, letter in masses(chain).items()} | {r"\mathbf{g}": "g"}


def _described(p: Parameter, value: float) -> str:
    """What a parameter is; gravity against an axis is stated by its size."""
    return p.description if value == p.value else f"acceleration of free fall, along −{'xyz'[p.index[0]]}"


def _coordinates(chain: Chain) -> Iterator[Row]:
    known = zip(letters(chain), coordinate_names(chain.robot).q, coordinate_units(chain.robot), strict=True)
    for meaning, (letter, name, unit) in zip(_meanings(chain), known, strict=True):
        yield f"${letter.latex}$", meaning, unit, f"`{name}`"
    yield r"$\mathbf{q}$", "column of the coordinates, in this order", "", ""


def _meanings(chain: Chain) -> Iterator[str]:
    """What each coordinate is, in words: of joints, rotors and modes."""
    for i, key in enumerate(chain.keys):
        for screw in key.screws:
            what, along = ("angle", "about") if screw.turn else ("travel", "along")
            yield f"{what} of the joint of {_link(chain, i)} {along} {axis_text(screw).removesuffix(', sliding')}"
    names = letters(chain)
    for joint in chain.added_joints:
        yield f"angle of the rotor whose drive turns ${names[joint].latex}$"
    for i, key in enumerate(chain.keys):
        for direction, k in key.directions:
            yield f"mode {k + 1} of {_link(chain, i).removesuffix(',')}, {DIRECTION[direction]}"


def _link(chain: Chain, i: int) -> str:
    return f"link {i + 1}, `{chain.names[i]}`," if chain.n > 1 else f"`{chain.names[i]}`"


def _efforts(chain: Chain) -> Iterator[Row]:
    known = zip(effort_names(chain), coordinate_names(chain.robot).tau, input_units(chain.robot), strict=True)
    for axis, ((letter, name, unit), (_, _, word, _)) in enumerate(zip(known, efforts(chain.robot), strict=True)):
        on = letters(chain)[chain.effort_places[axis]]
        yield f"${letter.latex}$", f"{word} of the drive, on ${on.latex}$", unit, f"`{name}`"
    yield r"$\boldsymbol{\tau}$", "column of the forces of the drives, in the rows on which they act", "", ""


def _matrices(chain: Chain, equations: Equations) -> Iterator[Row]:
    for letter, meaning in MATRICES.items():
        if equations.has(letter):
            size = rf"{chain.nv} \times {1 if letter == 'g' else chain.nv}"
            yield rf"$\mathbf{{{letter}}}$", f"{meaning}, ${size}$", "", ""


def _parts(equations: Equations) -> Iterator[Row]:
    for name, (meaning, unit) in equations.meanings:
        yield f"${name.latex}$", meaning, unit, ""
