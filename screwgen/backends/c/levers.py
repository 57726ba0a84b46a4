"""The levers of the C back end: what the torque of each axis is multiplied by where cylinders drive joints."""

from __future__ import annotations

from ...algorithms import fused
from ...topology.chain import Chain
from .code import Place
from .pieces import piece_place, pieces


def content(chain: Chain, baked: bool, place: Place) -> dict | None:
    """The templates' context; ``place`` is that of the fused function. None where no drive has a transmission."""
    if not chain.cranked:
        return None
    program = fused.levers(chain, "baked" if baked else "constants")
    return pieces(program, piece_place(chain, "kept", {}, place), ("c", "state", "levers"))
