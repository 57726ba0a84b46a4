"""The proper acceleration of the last tip, and its partial derivatives, in one program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..ir.derivative import columns
from ..ir.program import Program, Value
from ..topology.chain import Chain
from . import given_motion
from .functions import Functions
from .fused import fuse
from .schedule import OUTWARD, Algorithm, Phase

MOTION: Algorithm = (Phase(given_motion.motion, OUTWARD),)


class Accelerometer(Functions):
    """The functions of a robot, with the acceleration of its last tip."""

    def tip_acceleration(self, q, v, vdot) -> list[Value]:
        """The proper acceleration (3) of the last tip point, inertial minus free fall, in tip-frame components."""
        motion = self.chain.split(vdot, "qddot", "etaddot")
        _, places = self._run(MOTION, self._state(q, v), motion)
        return places[self.chain.tree.tip(self.chain.last)]["acc"][3:]


def tip_acceleration(chain: Chain, constants="constants") -> Program:
    """``(q, v, vdot) -> (a, a_q, a_v, a_vdot)``: the derivatives (3, nq) column by column, each at the others held."""

    def body(f: Accelerometer, x: Mapping[str, Sequence[Value]]) -> dict[str, Sequence[Value]]:
        a = f.tip_acceleration(x["q"], x["v"], x["vdot"])
        slopes = {f"a_{n}": [s for column in columns(a, x[n]) for s in column] for n in ("q", "v", "vdot")}
        return {"a": a} | slopes

    sizes = {"q": chain.nq, "v": chain.nv, "vdot": chain.nv}
    return fuse(chain, "tip_acceleration", sizes, body, constants, Accelerometer)
