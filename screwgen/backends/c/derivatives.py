"""The derivatives of the C back end: one straight-line program, cut into functions, and a small dense solver."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ...algorithms.linearise import linearisation
from ...algorithms.schedule import COLUMNS
from ...errors import UsageError
from ...ir.program import Program
from ...ir.split import KEPT, split
from ...topology.chain import Chain
from .code import Writer, with_unused

Place = Callable[[str, int], str]

FILES = ("derivatives.h", "derivatives.c")
"""The files that derivatives add, without the robot's name; their templates have the same names."""

PIECE = 4000
"""Operations of a C function: compilers take more than twice as long for twice as many."""

LIMIT = 45_000
"""Above so many operations gcc -O2 takes more than ten seconds."""

COORDINATES = 32
"""With more coordinates every robot exceeds the limit, so it is refused at once."""


UNROLLED = 16
"""Up to this many coordinates the solver is written out: values in registers, two to three times as fast as loops."""


class PieceWriter(Writer):
    """Writes a piece of a program; the outputs of other pieces are None."""

    def _outputs(self) -> list[str]:
        for name, values in self.program.outputs.items():
            self._written |= {(name, k) for k, v in enumerate(values) if v is None}
        return super()._outputs()


def piece_place(chain: Chain, kept: str, own: Mapping[str, Callable[[int], str]], place: Place) -> Place:
    """The C expressions of a piece's signals: in the array of values ``kept`` by earlier pieces, in the columns of the
    constants, in ``own`` (by name, then by entry), else at ``place``.
    """

    def placed(signal: str, k: int) -> str:
        owner, _, what = signal.partition(":")
        if owner == KEPT:
            return f"{kept}[{int(what or 0) + k}]"
        for part, names in COLUMNS.items():
            if what in names:
                start = chain.given(int(owner))[part].start
                return f"c->{COLUMNS['eta'][names.index(what)]}[{start + k}]"
        return own[signal](k) if signal in own else place(signal, k)

    return placed


def content(chain: Chain, baked: bool, place: Place) -> dict:
    """The templates' context; ``place`` is that of the fused function.

    Raises :class:`UsageError` if the code would be too long to compile.
    """
    check_size(chain, chain.nq, COORDINATES, "coordinates")
    program = linearisation(chain, "baked" if baked else "constants")
    check_size(chain, program.operation_count, LIMIT, "operations")
    pieces, kept = split(program, -(-program.operation_count // PIECE))
    nq = chain.nq
    solve = nq**3 // 3 + 2 * nq * nq * (2 * nq + chain.n_joints)
    return {
        "operations": program.operation_count,
        "solve": solve,
        "pieces": [_lines(piece, chain, place) for piece in pieces],
        "kept": kept,
        "unrolled": UNROLLED,
        "link_of": _owners(chain),
    }


def check_size(chain: Chain, size: int, most: int, what: str) -> None:
    if size > most:
        raise UsageError(
            f"robot '{chain.robot.name}': its derivatives in C would have {size} {what}, more than {most}, and "
            "take too long to compile; leave them out, or give the robot fewer links or modes"
        )


def _lines(program: Program, chain: Chain, place: Place) -> list[str]:
    name, nq = chain.robot.name, chain.nq
    own = {
        "vdot": lambda k: f"out->vdot[{k}]",
        "m_eta": lambda k: f"work->m_eta[{k}]",
        "M": lambda k: "work->M[{}][{}]".format(*_triangle(k)),
        "f_q": lambda k: f"out->vdot_q[{k // nq}][{k % nq}]",
        "f_v": lambda k: f"out->vdot_v[{k // nq}][{k % nq}]",
    }

    fail = lambda test, link: f"if ({test}) {{ work->fault = {link}; return {name.upper()}_SINGULAR; }}"  # noqa: E731
    pointers = ("c", "state", "input", "work", "out")
    placed = piece_place(chain, "work->kept", own, place)
    lines = PieceWriter(program, name, placed, fail, {*pointers, KEPT}, apart=True).lines()
    return with_unused(pointers, lines)


def _triangle(k: int) -> tuple[int, int]:
    """Row and column of entry k of a lower triangle, row by row."""
    i = 0
    while (i + 1) * (i + 2) // 2 <= k:
        i += 1
    return i, k - i * (i + 1) // 2


def _owners(chain: Chain) -> list[int]:
    """The link of every coordinate."""
    joints = [i for i, key in enumerate(chain.keys) for _ in range(key.joints)]
    return joints + [i for i, key in enumerate(chain.keys) for _ in range(key.modes)] or [0]
