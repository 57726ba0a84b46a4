"""The levers of the C back end: what the torque of each axis is multiplied by where drives have transmissions."""

from __future__ import annotations

from ...algorithms.robot_programs import levers
from ...elements import TRAVELS
from ...topology.chain import Chain
from .code import Place
from .pieces import piece_place, pieces


def content(chain: Chain, baked: bool, place: Place) -> dict | None:
    """The templates' context; ``place`` is that of the fused function. None where no drive has a transmission."""
    if not chain.travels:
        return None
    program = levers(chain, "baked" if baked else "constants")
    made = pieces(program, piece_place(chain, "kept", {}, place), ("c", "state", "levers"), fail=_beyond)
    there = {kind.SHORT for kind in chain.travel_kinds}
    return made | {f"{kind.SHORT}s": kind.SHORT in there for kind in TRAVELS}


def _beyond(test: str, _: int) -> str:
    """The statement of a guard: a transmission does not reach its link."""
    return f"if ({test}) {{ return $$_SINGULAR; }}"
