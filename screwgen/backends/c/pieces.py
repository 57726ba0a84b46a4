"""Long programs as several C functions, with one array for the values that they hand on."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ...algorithms.columns import link_columns, robot_columns
from ...algorithms.schedule import is_column
from ...ir.program import Program
from ...ir.split import KEPT, split
from ...topology.chain import Chain
from .code import Fail, Place, Writer, with_unused
from .routines import Routines

PIECE = 4000
"""Operations of a C function: compilers take more than twice as long for twice as many."""


def pieces(
    program: Program,
    place: Place,
    pointers: tuple[str, ...],
    longest: int = PIECE,
    fail: Fail | None = None,
    outline: bool = False,
) -> dict:
    """A program as the templates print it: ``operations``, the bodies of its functions, and how many values are kept.

    ``pointers`` are the functions' parameters, ``longest`` the most operations of a program in one piece. With
    ``outline`` what recurs is called, and ``routines`` are the functions for that; else there are none.
    """
    routines = Routines([program] if outline else [])
    writer = lambda piece: Writer(piece, place, fail, {*pointers, KEPT}, apart=True)  # noqa: E731
    made = bodies(writer, routines.calling(program) if outline else program, pointers, longest)
    return made | {"operations": program.operation_count, "routines": routines.functions}


def bodies(
    writer: Callable[[Program], Writer], program: Program, pointers: tuple[str, ...], longest: int = PIECE
) -> dict:
    """The same with a writer of one's own."""
    count = program.operation_count
    parts, kept = split(program, -(-count // PIECE) if count > longest else 1)
    lines = [with_unused(pointers, writer(part).lines()) for part in parts]
    return {"operations": count, "pieces": lines, "kept": max(kept, 1)}


def piece_place(chain: Chain, kept: str, own: Mapping[str, Callable[[int], str]], place: Place) -> Place:
    """The C expressions of a piece's signals: in the array of values ``kept`` by earlier pieces, in the columns of the
    constants, in ``own`` (by name, then by entry), else at ``place``.
    """

    def placed(signal: str, k: int) -> str | None:
        owner, _, what = signal.partition(":")
        if owner == KEPT:
            return f"{kept}[{int(what or 0) + k}]"
        for part, span in chain.coordinate_spans(int(owner)).items() if is_column(what) else ():
            names = link_columns(part)
            if what in names:
                return f"c->{robot_columns(part)[names.index(what)]}[{span.start + k}]"
        return own[signal](k) if signal in own else place(signal, k)

    return placed
