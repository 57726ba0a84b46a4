"""Programs of which some inputs are columns, parted: what does not depend on these is found once for all columns."""

from __future__ import annotations

from collections.abc import Iterable

from .names import OperationGroup
from .program import Node, Program, Tracer, Value, give_label
from .replay import BINARY


def dependents(program: Program, inputs: Iterable[str]) -> set[int]:
    """The numbers of the nodes that depend on some inputs."""
    names, found = frozenset(inputs), set()
    for node in program.nodes:
        moves = (
            node.args[0] in names
            if node.op == "input"
            else any(isinstance(a, Node) and a.id in found for a in node.args)
        )
        if moves:
            found.add(node.id)
    return found


def parted(program: Program, moving: frozenset[str], kept: str) -> tuple[Program, Program]:
    """The program without what depends on the inputs ``moving``, and the rest, which reads what the former keeps.

    Outputs named in ``moving`` are the rest's. The former hands values on as ``kept``, unless they are of a link's
    store.
    """
    cut = _Cut(program, moving, kept)
    outputs = {n: [cut.value(v) for v in values] for n, values in program.outputs.items() if n in moving}
    own = {n: values for n, values in program.outputs.items() if n not in moving}
    own |= {kept: cut.handed} if cut.handed else {}
    fixed = Program(program.name, {}, own, program.guards, program.sections, program.origins)
    read = {n.args[0] for n in fixed.nodes if n.op == "input"}
    fixed.inputs = {n: size for n, size in program.inputs.items() if n in read}
    rest = cut.tracer.program(program.name, {}, outputs)
    sizes = program.inputs | {n: len(values) for n, values in own.items()}
    rest.inputs = {n: sizes[n] for n in dict.fromkeys(x.args[0] for x in rest.nodes if x.op == "input")}
    return fixed, rest


class _Cut:
    """The replay of what depends on the moving inputs."""

    def __init__(self, program: Program, moving: frozenset[str], kept: str):
        self.tracer, self.kept = Tracer(), kept
        self.tracer.sections = [OperationGroup(group.title) for group in program.sections]
        self.handed: list[Value] = []
        self._values: dict[int, Value] = {}
        self._places = {
            v.id: (name, k)
            for name, values in program.outputs.items()
            if name not in moving and name.startswith("w.")
            for k, v in enumerate(values)
            if isinstance(v, Node)
        }
        self._sizes = program.inputs | {n: len(values) for n, values in program.outputs.items()}
        self._moved = dependents(program, moving)
        for node in program.nodes:
            if node.id in self._moved:
                self.tracer._section = node.section
                self._values[node.id] = value = self._made(node)
                if node.label is not None:
                    give_label(value, node.label)

    def value(self, v: Value) -> Value:
        """A value of the program in the rest."""
        if not isinstance(v, Node):
            return v
        if v.id not in self._values:
            self._values[v.id] = self._handed(v)
        return self._values[v.id]

    def _made(self, node: Node) -> Value:
        if node.op == "input":
            return self._input(*node.args)
        values = [self.value(a) for a in node.args]
        if node.op in BINARY:
            return getattr(self.tracer, node.op)(*values)
        return self.tracer.neg(*values) if node.op == "neg" else self.tracer.call(node.op, *values)

    def _handed(self, v: Node) -> Value:
        """What the first part hands on; negatives are made of what they negate."""
        if v.op == "neg":
            return self.tracer.neg(self.value(v.args[0]))
        if v.op == "input" and v.args[0].startswith("w."):
            return self._input(*v.args)
        if v.id in self._places:
            return self._input(*self._places[v.id])
        self.handed.append(v)
        return self._input(self.kept, len(self.handed) - 1)

    def _input(self, name: str, k: int) -> Node:
        return self.tracer.input(name, k + 1)[k]
