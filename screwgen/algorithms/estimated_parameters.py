"""Parameters of a robot that a filter finds as states: which there may be, and how far down their values may go."""

from __future__ import annotations

from collections.abc import Sequence

from ..errors import UsageError
from ..topology.chain import Chain
from .robot_programs import held_inputs

LEAST = 1e-6
"""Of a parameter that must not be negative: the least value that it is given, over that at the start."""


def check_estimated(chain: Chain, places: Sequence[int]) -> None:
    """Raises UsageError where loops close the tree, and for parameters, at these places, of what a step holds.

    Derivatives are those at inputs as they are held.
    """
    chain.refuse_loops("filter of parameters", "leave the parameters out")
    nodes = held_inputs(chain).nodes if chain.holds else ()
    held = {node.args[1] for node in nodes if node.op == "input" and node.args[0] == "p"}
    for place in places:
        if place in held:
            said = f"a filter does not find {chain.parameters.names[place]}: it decides what a step holds of its inputs"
            raise UsageError(f"{said}, of which there is no derivative; state it in the robot file")
