"""Small motions about a state: what accelerations and outputs become when the state and the inputs change."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..ir.derivative import tangents
from ..ir.program import Node, Program, Value
from ..topology.chain import Chain
from . import matrices as mx
from .functions import Functions
from .fused import fuse, inputs
from .marker_functions import STRAINED
from .response import POINT
from .sensors import ALL, marker_motion

OUTPUTS = ("coordinates", "rates", "position", "velocity", "acceleration", "wrench", "strain")
"""Coordinates and rates, the motion of the last tip in the inertial frame, joint wrenches, strains."""


def changes(chain: Chain) -> Program:
    """``OUTPUTS`` and ``vdot``, and as ``…_along`` their derivatives along a direction.

    Of ``(q, v, tau, w_ext, p)`` and the direction ``(d_q, d_v, d_tau, d_w_ext)``. ``d_q`` (nv,) is a change of the
    posture along v: of a floating base a turn and a displacement in axes of F_1.
    """

    def body(f: Functions, x: Mapping[str, Sequence]) -> dict[str, Sequence[Value]]:
        vdot, wrench = f.forward_dynamics(x["q"], x["v"], x["tau"], x["w_ext"])
        found = {
            "vdot": vdot,
            "coordinates": x["q"],
            "rates": x["v"],
            **_tip(f, x, vdot),
            "wrench": wrench,
            "strain": f.strains(x["q"]),
        }
        along = {"q": f.coordinate_rates(x["q"], x["d_q"])} | {name: x[f"d_{name}"] for name in POINT[1:]}
        seeds = {a: b for name in POINT for a, b in zip(x[name], along[name], strict=True) if isinstance(a, Node)}
        slopes = iter(tangents([value for values in found.values() for value in values], seeds))
        return found | {f"{name}_along": [next(slopes) for _ in values] for name, values in found.items()}

    given = inputs(chain, " ".join(POINT))
    given |= {f"d_{name}": size for name, size in given.items()} | {"d_q": chain.nv}
    return fuse(chain, "linear_model", given, body, algorithms=(*ALL, STRAINED))


def _tip(f: Functions, x: Mapping[str, Sequence], vdot: Sequence) -> dict[str, list]:
    """Position, velocity and acceleration of the last tip in the inertial frame."""
    k = [(m.is_tip, m.segment) for m in f.chain.markers].index((True, f.chain.last))
    found = marker_motion.body(f, x["q"], x["v"], vdot)
    R = mx.array(found["R"][9 * k : 9 * k + 9], (3, 3))
    velocity, acceleration = (
        mx.multiply(R, mx.array(found[name][6 * k + 3 : 6 * k + 6])) for name in ("twist", "acceleration")
    )
    return {
        "position": list(found["position"][3 * k : 3 * k + 3]),
        "velocity": list(velocity),
        "acceleration": list(acceleration + mx.array(f.gravity)),
    }
