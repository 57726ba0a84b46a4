"""Long programs cut into pieces that run one after the other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from .program import Node, Program, Tracer, Value
from .routines import RESULT

KEPT = "kept"
"""The input by which pieces read the values of earlier ones; ``kept:20`` is the output of entries 20, 21, …"""


def split(program: Program, pieces: int) -> tuple[list[Program], int]:
    """The program as ``pieces`` programs of about the same length, and the number of values passed between them.

    A piece has the outputs that are computed in it, with None in place of the others, and one output of the values
    that later pieces use.  The operations and their order are those of the program.
    """
    if pieces < 2:
        return [program], 0
    return _cut(program, [len(program.nodes) * k // pieces for k in range(pieces + 1)], 0)


def split_before(program: Program, name: str, longest: int) -> tuple[list[Program], list[Program], int]:
    """The program as pieces that read nothing of the input ``name``, the others, and the number of values passed.

    The others run again for other values of that input. They have all outputs that are no operations.  A piece has
    at most about ``longest`` operations.
    """
    of_input = lambda a: isinstance(a, Node) and a.op == "input" and a.args[0] == name  # noqa: E731
    count = len(program.nodes)
    reads = (k for k, n in enumerate(program.nodes) if n.op != "input" and any(map(of_input, n.args)))
    place = next(reads, count)
    first, more = (max(1, -(-size // longest)) for size in (place, count - place))
    bounds = [place * k // first for k in range(first)] + [place + (count - place) * k // more for k in range(more + 1)]
    parts, kept = _cut(program, bounds, first + more - 1)
    return parts[:first], parts[first:], kept


def _cut(program: Program, places: Sequence[int], free: int) -> tuple[list[Program], int]:
    """The pieces between places among the nodes; that of number ``free`` has the outputs that are no operations."""
    bounds = [_before_results(program, place) for place in places]
    parts = [program.nodes[a:b] for a, b in pairwise(bounds)]
    home = {node.id: k for k, part in enumerate(parts) for node in part}
    crossing = {a.id for n in program.nodes for a in _computed(n) if home[a.id] != home[n.id]}
    slots = {number: k for k, number in enumerate(sorted(crossing))}
    return [_Piece(program, k, home, slots, k == free).program(part) for k, part in enumerate(parts)], len(slots)


def _before_results(program: Program, place: int) -> int:
    """The place, or the next one that does not part the results of a routine from its call."""
    while place < len(program.nodes) and program.nodes[place].op == RESULT:
        place += 1
    return place


def _computed(node: Node) -> list[Node]:
    """The operands that are operations."""
    return [] if node.op == "input" else [a for a in node.args if isinstance(a, Node) and not _free(a)]


def _free(node: Node) -> bool:
    """Whether a value is available in every piece."""
    return node.op in ("input", "epsilon")


class _Piece:
    """The nodes of one piece, with inputs in place of what earlier ones have computed."""

    def __init__(self, program: Program, number: int, home: dict[int, int], slots: dict[int, int], free: bool):
        self.whole, self.number, self.home, self.slots, self.free = program, number, home, slots, free
        self.tracer = Tracer()
        self.own: dict[int, Node] = {}

    def program(self, part: Sequence[Node]) -> Program:
        """The piece as a program."""
        for node in part:
            if not _free(node):
                self.own[node.id] = self._copy(node)
        outputs = {name: [self._output(v) for v in values] for name, values in self.whole.outputs.items()}
        kept = [node.id for node in part if node.id in self.slots]
        if kept:
            outputs[f"{KEPT}:{self.slots[kept[0]]}"] = [self.own[i] for i in kept]
        pairs = zip(self.whole.guards, self.whole.origins, strict=True)
        guards = [(self._node(g), o) for g, o in pairs if self._here(g.id)]
        return Program(
            f"{self.whole.name}_{self.number + 1}",
            self.whole.inputs | {KEPT: len(self.slots)},
            outputs,  # type: ignore[arg-type]  # None stands for what another piece computes
            [g for g, _ in guards],
            self.whole.sections,
            [o for _, o in guards],
        )

    def _here(self, number: int) -> bool:
        return self.home.get(number) == self.number

    def _copy(self, node: Node) -> Node:
        copy = Node(self.tracer, node.op, tuple(self._operand(a) for a in node.args), node.id, node.section)
        copy.label = node.label
        return copy

    def _operand(self, value: Value) -> Value:
        return self._node(value) if isinstance(value, Node) else value

    def _node(self, value: Node) -> Node:
        if value.id not in self.own:
            kept = not _free(value)
            op, args = ("input", (KEPT, self.slots[value.id])) if kept else (value.op, value.args)
            self.own[value.id] = Node(self.tracer, op, args, value.id, value.section)
        return self.own[value.id]

    def _output(self, value: Value) -> Value | None:
        """An output of this piece; None where it is another's."""
        if not isinstance(value, Node):
            return value if self.free else None
        if _free(value):
            return self._operand(value) if self.free else None
        return self.own[value.id] if self._here(value.id) else None
