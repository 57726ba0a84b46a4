"""The loops of the C back end: their wrenches on the tips and the correction of an open state, as programs."""

from __future__ import annotations

from ...algorithms import fused
from ...algorithms.loop_functions import ROUNDS
from ...topology.chain import Chain
from .code import Place, literal, singular
from .pieces import piece_place, pieces

OPEN = 1e-5
"""m, or of cosines: the gap of such a row from which parameters count as those of another robot."""
FILES = ("loops.c",)
"""The files that loops add, without the robot's name; their templates have the same names."""


def content(chain: Chain, baked: bool, place: Place) -> dict:
    """The templates' context; ``place`` is that of the fused function."""
    own = {
        "m_eta": lambda k: f"m_eta[{k}]",
        "f_eta": lambda k: f"f_eta[{k}]",
        "closed": lambda k: f"work->input.w_ext[{k // 6}][{k % 6}]",
        "closed_tau": lambda k: f"work->input.tau[{k}]",
        "new_q": lambda k: f"work->state.q[{k}]",
        "new_v": lambda k: f"work->state.v[{k}]",
        "openings": lambda k: f"mismatch[{k // 2}][{k % 2}]",
    }
    placed, constants = piece_place(chain, "work->kept", own, place), "baked" if baked else "constants"
    made = {
        name: pieces(make(chain, constants), placed, ("c", "state", *more), fail=singular)
        for name, make, more in (
            ("wrenches", fused.loop_wrenches, ("input", "m_eta", "f_eta", "work")),
            ("correction", fused.correction, ("input", "m_eta", "f_eta", "work")),
            ("openings", fused.openings, ("work", "mismatch")),
        )
    }
    kept = max(part["kept"] for part in made.values())
    rows = {"rows": [closure.text for closure in chain.closures], "couplings": bool(chain.couplings)}
    return made | rows | {"kept": kept, "rounds": ROUNDS, "count": len(chain.junctions)}


def rows(chain: Chain, place: Place) -> dict:
    """Whether rows share forces, and of those that no motion changes the statements that find them in `gap`."""
    out: dict = {"shared": chain.overconstrained, "idle": None}
    if chain.idle:
        placed = piece_place(chain, "kept", {"gaps": lambda k: f"gap[{k}]"}, place)
        (lines,) = pieces(fused.idle_gaps(chain, "constants"), placed, ("c",))["pieces"]
        out["idle"] = {"count": len(chain.idle), "lines": lines, "limit": literal(OPEN**2)}
    return out
