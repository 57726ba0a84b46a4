"""Loops and lines that give way in generated C: what their rows bear at the end of an implicit step."""

from __future__ import annotations

import re
from typing import Any

from ...algorithms.tip_programs import row_terms, row_wrenches, settled_rows
from ...integrators.traced import stage_slopes
from ...ir.program import Program
from ...ir.split import KEPT, split_before
from ...topology.chain import Chain
from .batch import LONGEST, LaneWriter, angles_of
from .code import Place, Writer, entries, singular, with_unused
from .pieces import PIECE, bodies, piece_place, pieces

CONSTANT = re.compile(r"= (-?(?:\d+|\$\$_REAL\([-+.e\d]+\)));$")
"""The assignment of a number."""
COMPLIANT = ("compliant",)
"""What they write in the files of every robot, as :class:`..template_places.TemplatePlaces` finds it."""
FILE = "rows.c"
POINTERS = {"terms": ("c", "state", "work"), "wrenches": ("c", "state", "input", "m_eta", "f_eta", "ahead", "work")}
POINTERS["settled"] = "c", "state", "input", "work"

LANES = ("terms", "wrenches")
"""What lanes have too: they report no wrenches."""

OWN = {
    "h": lambda k: "work->dt",
    "ahead": lambda k: "ahead",
    "terms": lambda k: f"work->terms[{k}]",
    "acted": lambda k: f"work->input.w_ext[{k // 6}][{k % 6}]",
    "m_eta": lambda k: f"m_eta[{k}]",
    "f_eta": lambda k: f"f_eta[{k}]",
}
"""Where the programs find what they read, and put what they write: in the C of one scenario."""
OF_LANES = {
    "h": lambda k: "over[0]",
    "ahead": lambda k: "over[1]",
    "terms": lambda k: f"terms[{k}]",
    "acted": lambda k: f"acted[{k}]",
    "m_eta": lambda k: f"work->m_eta[{k}]",
    "f_eta": lambda k: f"work->f_eta[{k}]",
}
"""The same in the C of lanes."""


def content(chain: Chain, baked: bool, at: Place) -> dict[str, object]:
    """The templates' context: the statements that find the terms at the start of a step and the wrenches on tips, of
    numbers and of lanes, and those that runs report under; None without such loops."""
    if not chain.compliant:
        return {"compliant": None}
    made, lanes = {}, {}
    for name, make in (("terms", row_terms), ("wrenches", row_wrenches), ("settled", settled_rows)):
        program = make(chain, "baked" if baked else "constants")
        place = piece_place(chain, "work->kept", OWN, at)
        made[name] = pieces(program, place, POINTERS[name], fail=singular)
        if name in LANES:
            lanes[name] = _lanes(chain, program, at)
    kept = max(part["kept"] for part in made.values())
    return {"compliant": made | {"kept": kept, "count": 2 * len(chain.compliant), "lanes": lanes}}


OF_STAGE = {
    "q_start": entries("from->q"),
    "v_start": entries("from->v"),
    "h": lambda k: "dt",
    "ahead": lambda k: "(from != state)",
    "weights": lambda k: f"(row == {k})",
    "vdot": entries("out->vdot"),
    "by_q": lambda k: f"work->slopes.vdot_q[row][{k}]",
    "by_v": lambda k: f"work->slopes.vdot_v[row][{k}]",
    "by_tau": lambda k: f"out->vdot_tau[row][{k}]",
    "by_q_start": lambda k: f"out->vdot_q[row][{k}]",
    "by_v_start": lambda k: f"out->vdot_v[row][{k}]",
}
"""The same of the accelerations of a stage and of the derivatives of one of them."""
OF_SLOPES = ("c", "from", "state", "input", "dt", "work", "out")


def slopes(chain: Chain, baked: bool, at: Place) -> dict[str, Any] | None:
    """The templates' context of the derivatives of implicit stages; None without such loops.

    ``first``: the functions of the accelerations, ``more``: those that run for each of them; ``count``: the operations.
    """
    if not chain.compliant:
        return None
    program = stage_slopes(chain, "baked" if baked else "constants")
    place = piece_place(chain, "work->stage_kept", OF_STAGE, at)
    first, more, kept = split_before(program, "weights", PIECE)

    def written(parts: list[Program], *own: str) -> list[list[str]]:
        given = (*OF_SLOPES, *own)
        return [with_unused(given, Writer(part, place, singular, {*given, KEPT}, apart=True).lines()) for part in parts]

    again = sum(part.operation_count for part in more)
    count = program.operation_count + (chain.nvz - 1) * again
    return {
        "first": written(first),
        "more": written(more, "row"),
        "kept": max(kept, 1),
        "program": program,
        "count": count,
    }


class _RowWriter(LaneWriter):
    """Writes results that are one number in all lanes, as the gap of a row that no motion changes."""

    def _outputs(self) -> list[str]:
        return [CONSTANT.sub(rf"= {self.prefix}_all(\1);", line) for line in super()._outputs()]


def _lanes(chain: Chain, program: Program, at: Place) -> dict[str, object]:
    """The same statements of a batch, with the coordinates whose sines they need."""
    angles = angles_of(program)
    pointers = ("c", "state", "input", "work", "terms", "over", *("sin_q", "cos_q") * bool(angles), KEPT, "acted")
    placed = piece_place(chain, KEPT, OF_LANES, at)
    writer = lambda piece: _RowWriter(piece, placed, None, {*pointers, "bad"}, True)  # noqa: E731
    return bodies(writer, program, pointers, LONGEST) | {"angles": angles}


def scratch(chain: Chain, content: dict) -> dict[str, int]:
    """How many structs of a name a call keeps, and of numbers under an empty name."""
    if not chain.compliant:
        return {}
    own = content["compliant"]
    return {"input": 1, "state": 1, "": 2 + own["kept"] + own["count"]}
