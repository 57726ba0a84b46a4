"""The derivatives of what a step holds of its inputs, derived by the tracer."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from ..ir.derivative import columns
from ..ir.program import Node, Program, Value
from ..topology.chain import Chain
from . import fused
from .functions import HOLD, Functions

Place = tuple[int, int]


class HeldSlopes(NamedTuple):
    """``(q, v, tau) -> (by_tau, by_motion)``: the slope of each input held with itself, and those with the motion.

    ``places``: of each of the latter its input, and its column among changes [δ; δv] (nv + nvz) of the state.
    """

    program: Program
    places: tuple[Place, ...]


def held_slopes(chain: Chain, constants: str = "parameters") -> HeldSlopes:
    """Those of a robot; an input depends on no other."""
    places: list[Place] = []

    def body(f: Functions, x: Mapping[str, Sequence]) -> fused.Outputs:
        held = f.held(x["q"], x["v"], x["tau"])
        by_tau = [columns([out], [given])[0][0] for out, given in zip(held, x["tau"], strict=True)]
        motion = list(_changes(f.chain, x))
        found = [(k, column, columns([out], [y])[0][0]) for k, out in enumerate(held) for column, y in motion]
        found = [one for one in found if isinstance(one[2], Node)]
        places.extend((k, column) for k, column, _ in found)
        return {"by_tau": by_tau, "by_motion": [slope for *_, slope in found]}

    program = fused.fuse(chain, "held_slopes", fused.inputs(chain, "q v tau"), body, constants, algorithms=(HOLD,))
    return HeldSlopes(program, tuple(places))


def _changes(chain: Chain, x: Mapping[str, Sequence]) -> Iterator[tuple[int, Value]]:
    """The coordinates that add up and all rates, each with its column; held laws read no others."""
    for column, place in zip(chain.flat_v.tolist(), chain.flat_q.tolist(), strict=True):
        yield column, x["q"][place]
    for column, rate in enumerate(x["v"], chain.nv):
        yield column, rate
