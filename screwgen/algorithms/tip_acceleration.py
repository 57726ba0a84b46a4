"""The proper acceleration of the last tip, and its partial derivatives, in one program."""

from __future__ import annotations

from collections.abc import Sequence

from ..ir.derivative import columns, tangents
from ..ir.program import Node, Value
from .functions import Functions
from .fused import Outputs, program


@program("q v vdot", constants="constants")
def tip_acceleration(f: Functions, **x: Sequence) -> Outputs:
    """``(q, v, vdot) -> (a, a_q, a_v, a_vdot)``: the derivatives (3, nv) column by column, each at the others held.

    Those with the pose of a floating base are along ``pose exp(delta)``.
    """
    a = f.tip_acceleration(**x)
    slopes = {n: columns(a, values[f.chain.base_q :] if n == "q" else values) for n, values in x.items()}
    slopes["q"] = [tangents(a, change) for change in _changes(f, x["q"])] + slopes["q"]
    return {"a": a} | {f"a_{n}": [s for column in found for s in column] for n, found in slopes.items()}


def _changes(f: Functions, q: Sequence[Value]) -> list[dict[Node, Value]]:
    """What the entries of a floating base's pose change by with turns and shifts in its axes."""
    first, nv = f.chain.base_q, f.chain.nv
    units = [[float(i == k) for i in range(nv)] for k in range(f.chain.base_v)]
    rates = (f.coordinate_rates(q, unit)[:first] for unit in units)
    return [{x: r for x, r in zip(q, rate, strict=False) if isinstance(x, Node)} for rate in rates]
