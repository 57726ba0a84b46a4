"""What closes the loops of a robot in generated C."""

from __future__ import annotations

from functools import partial
from typing import Any

from ...algorithms import tip_programs
from ...algorithms.loop_functions import ROUNDS
from ...algorithms.loops import COMPLIANCE, LEAST, SHARES
from ...topology.chain import Chain
from .code import Place, entries, literal, singular
from .pieces import piece_place, pieces

OPEN = 1e-5
"""m, or of cosines: the gap of such a row from which parameters count as those of another robot."""
LOOPS = ("loops", "loops_in_derivatives", "loops_in_estimator", "loops_in_runs")
"""What loops write in the files of every robot, as :class:`..template_places.TemplatePlaces` finds it."""


def features(chain: Chain) -> tuple[str, ...]:
    """What loops, couplings, rows that share forces, and rows that no motion changes write."""
    written = LOOPS * bool(chain.closing.rows) + ("idle_rows",) * bool(chain.closing.idle)
    return written + ("couplings",) * bool(chain.closing.couplings) + ("shared_rows",) * chain.closing.overconstrained


def loops(chain: Chain, baked: bool, place: Place) -> dict[str, Any]:
    """Their wrenches on the tips, the correction of an open state, and how far they are open, as programs."""
    own = {
        "m_eta": lambda k: f"m_eta[{k}]",
        "f_eta": lambda k: f"f_eta[{k}]",
        "closed": lambda k: f"work->input.w_ext[{k // 6}][{k % 6}]",
        "closed_tau": lambda k: f"work->input.tau[{k}]",
        "borne": lambda k: f"work->borne[{k}]",
        "new_q": lambda k: f"work->state.q[{k}]",
        "new_v": lambda k: f"work->state.v[{k}]",
        "openings": lambda k: f"mismatch[{k // 2}][{k % 2}]",
    }
    placed, constants = piece_place(chain, "work->kept", own, place), "baked" if baked else "constants"
    made = {
        name: pieces(make(chain, constants), placed, ("c", "state", *more), fail=singular)
        for name, make, more in (
            ("wrenches", tip_programs.loop_wrenches, ("input", "m_eta", "f_eta", "work")),
            ("correction", tip_programs.correction, ("input", "m_eta", "f_eta", "work")),
            ("openings", tip_programs.openings, ("work", "mismatch")),
        )
    }
    kept = max(part["kept"] for part in made.values())
    return made | {
        "kept": kept,
        "rounds": ROUNDS,
        "count": len(chain.closing.junctions),
        "rows": [row.text for row in chain.closing.rows],
        "couplings": bool(chain.closing.couplings),
        "sharing": _sharing() if chain.closing.overconstrained else None,
        "last_link": chain.closing.rows[-1].second,
        "stabilisations": [literal(row.stabilisation) for row in chain.closing.rows],
        "gaps": partial(_gaps, chain, constants, place),
    }


def _sharing() -> dict:
    """How rows that may depend on each other share what they bear, as :func:`...algorithms.loops.sharing_solver`."""
    return {"compliance": literal(COMPLIANCE), "least": literal(LEAST), "times": SHARES}


def _gaps(chain: Chain, constants: str, place: Place) -> list[list[str]]:
    """The functions of an estimator that find the gaps of the rows, in one piece as they are short."""
    placed = piece_place(chain, "work->kept", {"gap": entries("work->gap")}, place)
    program = tip_programs.gaps(chain, constants)
    return pieces(program, placed, ("c", "state", "work"), program.operation_count, fail=singular)["pieces"]


def idle_rows(chain: Chain, place: Place) -> dict[str, object]:
    """The statements that find their gaps in ``gap``."""
    placed = piece_place(chain, "kept", {"gaps": lambda k: f"gap[{k}]"}, place)
    (lines,) = pieces(tip_programs.idle_gaps(chain, "constants"), placed, ("c",))["pieces"]
    return {"count": len(chain.closing.idle), "lines": lines, "limit": literal(OPEN**2)}
