"""Parameters of a robot that a filter finds as states: what they change of loops, and how far down they may go."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..ir.program import Value
from ..joints.constraints import Alignment
from ..topology.chain import Chain
from .functions import Functions
from .fused import Outputs, inputs
from .parameter_slopes import Differentiable

LEAST = 1e-6
"""Of a parameter that must not be negative: the least value that it is given, over that at the start."""


def gaps(chain: Chain) -> Differentiable:
    """The gaps of the rows of loops and their rates, as they change with the lengths of links."""
    shapes = dict.fromkeys(("gap", "rate"), (len(chain.closing.rows),))
    body = lambda f, x: dict(zip(shapes, f.gaps(x["q"], x["v"]), strict=True))  # noqa: E731
    return Differentiable("gaps", inputs(chain, "q v"), shapes, body)


def offsets(chain: Chain) -> Differentiable:
    """How far loops are from closed, in all that they demand, whichever of their rows bear forces."""
    demanded = [demand for junction in chain.closing.junctions for demand in junction.demands]
    shapes = {"offset": (sum(3 if isinstance(demand, Alignment) else 1 for demand in demanded),)}

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
        found = f.offsets(x["q"], [0.0] * chain.nv)
        return {"offset": [x for loop in found for x in (*loop.places, *loop.turns)]}

    return Differentiable("offsets", inputs(chain, "q"), shapes, body)
