"""The pose and velocity of the last tip with their partial derivatives, in one program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..ir.derivative import columns, tangents
from ..ir.program import Node, Program, Value
from ..topology.chain import Chain
from .functions import MOTION, Functions
from .fused import fuse


class TipFunctions(Functions):
    """The functions of a robot, with the velocity of its last tip."""

    def tip_velocity(self, q: Sequence, v: Sequence) -> list[Value]:
        """The velocity (3) of the last tip point, inertial components."""
        links, _ = self._run(MOTION, self._state(q, v))
        return links[self.chain.last]["tip_twist"][3:]


def tip_terms(chain: Chain, turning: bool, moving: bool, constants: str = "constants") -> Program:
    """``(q, v) -> (r, r_q, [R, R_q], [u, u_q])``, inertial components; derivatives column by column, of a pose by its
    changes.

    ``r`` (3) is the position of the last tip, ``R`` (9) its rotation row by row if ``turning``, ``u`` (3) its velocity
    if ``moving``; that with v is ``r_q``.
    """

    def body(f: TipFunctions, x: Mapping[str, Sequence[Value]]) -> dict[str, Sequence[Value]]:
        R, r = f.poses(x["q"])[1][chain.last]
        units = [[float(i == k) for i in range(chain.nv)] for k in range(chain.nv)] if chain.curved else []
        pairs = [zip(x["q"], f.coordinate_rates(x["q"], unit), strict=True) for unit in units]
        ways = [{at: rate for at, rate in pair if isinstance(at, Node)} for pair in pairs]

        def flat(values: Sequence[Value]) -> list[Value]:
            found = [tangents(values, way) for way in ways] if ways else columns(values, x["q"])
            return [s for column in found for s in column]

        out: dict[str, Sequence[Value]] = {"r": r, "r_q": flat(r)}
        if turning:
            out |= {"R": R, "R_q": flat(R)}
        if moving:
            u = f.tip_velocity(x["q"], x["v"])
            out |= {"u": u, "u_q": flat(u)}
        return out

    return fuse(chain, "tip_terms", {"q": chain.nq, "v": chain.nv}, body, constants, TipFunctions)
