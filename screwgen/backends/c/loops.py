"""The loops of the C back end: their wrenches on the tips and the correction of an open state, as programs."""

from __future__ import annotations

from ...algorithms import fused
from ...algorithms.loop_functions import ROUNDS
from ...topology.chain import Chain
from .code import Place, singular
from .pieces import piece_place, pieces

FILES = ("loops.c",)
"""The files that loops add, without the robot's name; their templates have the same names."""


def content(chain: Chain, baked: bool, place: Place) -> dict:
    """The templates' context; ``place`` is that of the fused function."""
    own = {
        "m_eta": lambda k: f"m_eta[{k}]",
        "f_eta": lambda k: f"f_eta[{k}]",
        "closed": lambda k: f"work->input.w_ext[{k // 6}][{k % 6}]",
        "new_q": lambda k: f"work->state.q[{k}]",
        "new_v": lambda k: f"work->state.v[{k}]",
    }
    placed = piece_place(chain, "work->kept", own, place)
    pointers, constants = ("c", "state", "input", "m_eta", "f_eta", "work"), "baked" if baked else "constants"
    programs = {"wrenches": fused.loop_wrenches(chain, constants), "correction": fused.correction(chain, constants)}
    made = {name: pieces(program, placed, pointers, fail=singular) for name, program in programs.items()}
    kept = max(part["kept"] for part in made.values())
    return made | {"rows": [closure.text for closure in chain.closures], "kept": kept, "rounds": ROUNDS}
