"""Which parameters of a robot a filter may find: those whose change the inputs of a step and closed loops allow."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...algorithms.estimated_parameters import offsets
from ...algorithms.robot_programs import held_inputs
from ...errors import UsageError
from ...topology.chain import Chain
from .by_p import slopes
from .loop_rows import closed_postures
from .numeric import Numeric

FOLLOWED = 1e-7
"""The part of what a parameter changes of the loops that may be left once all coordinates have followed."""
LEAST = 1e-3
"""What counts as nothing beside: a change of a parameter by its unit, m or of directions."""


def check_estimated(chain: Chain, places: Sequence[int]) -> None:
    """Raises UsageError for parameters, at these places, of what a step holds: derivatives are those at held inputs.

    Also for those that open a loop, whatever else moves.
    """
    nodes = held_inputs(chain).nodes if chain.holds else ()
    held = {node.args[1] for node in nodes if node.op == "input" and node.args[0] == "p"}
    opened, names = opening(chain, places), chain.parameters.names
    for place in places:
        said = f"a filter does not find {names[place]}"
        if place in held:
            said += ": it decides what a step holds of its inputs, of which there is no derivative"
            raise UsageError(f"{said}; state it in the robot file")
        if place in opened:
            raise UsageError(f"{said}: it opens loops, and no motion closes them again; state it in the robot file")


def opening(chain: Chain, places: Sequence[int]) -> list[int]:
    """Of the parameters at these places those that open loops whatever moves, to first order, in any posture found.

    As the height of a planar linkage's mount above its plane: no coordinate takes back what it changes.
    """
    if not chain.closing.junctions:
        return []
    numeric, moving = Numeric(chain), [k for k in range(chain.base_v, chain.nv) if k not in chain.given.values()]
    left, postures = list(places), closed_postures(numeric)
    for q in postures if left else ():
        by_p = slopes(numeric, offsets(chain), {"q": q.tolist()}, left)[0]
        by_q = numeric.offset_slopes(q)[:, moving]
        rest = np.abs(by_p - by_q @ np.linalg.lstsq(by_q, by_p, rcond=FOLLOWED)[0]).max(axis=0, initial=0.0)
        sizes = np.abs(by_p).max(axis=0, initial=0.0)
        left = [k for k, apart, size in zip(left, rest, sizes, strict=True) if apart > FOLLOWED * max(size, LEAST)]
    return left if postures else []
