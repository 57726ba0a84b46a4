"""A function of a robot at the samples of many scenarios, one scenario per lane."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from ...algorithms.robot_function import RobotFunction, shape
from ...ir.program import Node, Program, Value
from ...ir.split import KEPT
from ...topology.chain import Chain
from .batch import LONGEST, LaneWriter, angles_of
from .code import ATOM, entries
from .fields import fused_place
from .pieces import bodies, piece_place


class _SampleWriter(LaneWriter):
    """Results may be numbers that no state changes, which C does not make lanes of."""

    def _value(self, value: Value) -> tuple[str, int]:
        text, precedence = super()._value(value)
        return (text, precedence) if isinstance(value, Node) else (f"{self.prefix}_all({text})", ATOM)


def content(row: RobotFunction, wanted: Sequence[str], chain: Chain) -> dict:
    """The context of the template: of the results `wanted` of a function of coordinates and rates alone."""
    whole = row.program(chain, "constants")
    outputs = {name: whole.outputs[name] for name in wanted}
    program = Program(row.name, whole.inputs, outputs, whole.guards, whole.sections, whole.origins)
    angles = angles_of(program)
    pointers = ("c", "state", *("sin_q", "cos_q") * bool(angles), KEPT, *wanted)
    placed = piece_place(chain, KEPT, {name: entries(name) for name in wanted}, fused_place)
    found = bodies(
        lambda piece: _SampleWriter(piece, placed, None, {*pointers, "bad"}, True), program, pointers, LONGEST
    )
    sizes = [prod(shape(row.results[name], chain)) for name in wanted]
    results = [{"name": name, "first": sum(sizes[:k])} for k, name in enumerate(wanted)]
    own = {"name": row.name, "results": results, "total": sum(sizes)}
    return found | own | {"angles": angles}
