"""The proper acceleration of the last tip, and its partial derivatives, in one program."""

from __future__ import annotations

from collections.abc import Sequence

from ..ir.derivative import columns, tangents
from ..ir.program import Node, Value
from ..spec.tendons import TENSIONS
from .functions import Functions
from .fused import Outputs, program


@program("q v vdot", constants="constants")
def tip_acceleration(f: Functions, **x: Sequence) -> Outputs:
    """``(q, v, vdot) -> (a, a_q, a_v, a_vdot)``: the derivatives (3, nv) column by column, each at the others held.

    Those with joints whose coordinates do not add up are along :meth:`.JointKind.integrate`.
    """
    if f.chain.falls:
        f.chain.refuse_inputs("filter, whose accelerometer does not know them", "leave them out", TENSIONS)
    a = f.tip_acceleration(**x)
    slopes = {n: columns(a, values) for n, values in x.items() if n != "q"}
    slopes["q"] = along_changes(f, x["q"], a)
    return {"a": a} | {f"a_{n}": [s for column in found for s in column] for n, found in slopes.items()}


def along_changes(f: Functions, q: Sequence[Value], a: Sequence[Value]) -> list[list[Value]]:
    """The derivatives of ``a`` with changes of the posture (nv,), column by column."""
    chain, out = f.chain, {}
    flat = columns(a, [q[k] for k in chain.flat_q])
    out = dict(zip(chain.flat_v.tolist(), flat, strict=True))
    for part in chain.curved:
        for k in range(part.v.start, part.v.stop):
            rates = f.coordinate_rates(q, [float(i == k) for i in range(chain.nv)])[part.q]
            change = {x: r for x, r in zip(q[part.q], rates, strict=True) if isinstance(x, Node)}
            out[k] = tangents(a, change)
    return [out[k] for k in range(chain.nv)]
