"""How the innovations of a measurement change with parameters of the robot, for a filter that finds these."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..ir.derivative import tangents
from ..ir.program import Node, Program, Value
from ..spec.parameters import parameters
from ..topology.chain import Chain
from .felt import expected, reads
from .functions import Functions
from .fused import Outputs, fuse, inputs
from .measurement import Columns, Further, Measurement
from .parameter_slopes import ConstantSlopes


def expected_along(row: Measurement, chain: Chain, chosen: Sequence[int]) -> Program:
    """``(inputs, measured, numbers, p, d_p, d_vdot) -> (slope)``: what is expected along a change of parameters.

    ``d_p``: the change of the chosen parameters, ``d_vdot`` (nvz): that of the accelerations, of rows that read these.
    """
    given = inputs(chain, reads(row, chain)) | {x.keyword: x.size(chain) for x in row.numbers if x.stated}
    derived = {x.keyword: x.start for x in row.numbers if callable(x.start)}
    moved = {"p": chosen, **({"vdot": range(chain.nvz)} if "vdot" in given else {})}

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
        follow = {name: start(chain, x["p"]) for name, start in derived.items()}
        found = expected(row, f, {name: x[name] for name in given} | follow)
        seeds = [(x[name][k], d) for name, own in moved.items() for k, d in zip(own, x[f"d_{name}"], strict=True)]
        slopes = tangents(row.innovation(x["measured"], found), {a: d for a, d in seeds if isinstance(a, Node)})
        return {"slope": [-x for x in slopes]}

    sizes = given | {"measured": row.n_values(chain), "p": len(parameters(chain.robot))}
    sizes |= {f"d_{name}": len(own) for name, own in moved.items()}
    return fuse(chain, f"{row.name}_along", sizes, body, algorithms=row.algorithms)


def by_chosen(row: Measurement, chosen: Sequence[int], slopes: ConstantSlopes) -> Further:
    """The derivatives of what is expected with chosen parameters, at prepared constants and numbers of the sensor."""

    def columns(f: Functions, x: Mapping[str, Sequence[Value]], expected: Sequence[Value]) -> Columns:
        rest, own = row.innovation(x["measured"], expected), {n.name: x[n.keyword] for n in row.numbers}
        ways = [slopes.along(f, k, number, x["slope"], own) for k, number in enumerate(chosen)]
        return [[-slope for slope in tangents(rest, way)] for way in ways]

    return Further({"slope": slopes.count}, columns)
