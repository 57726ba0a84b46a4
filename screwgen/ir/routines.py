"""Routines: what recurs in programs, printed once and called.

A rod of five points has the same operations from each section to the next. :meth:`.Tracer.routine` marks them when they
are recorded; every other use of a program runs them like all operations. :func:`outlined` takes them out for a back end
that prints code: a node ``call`` runs a routine on the values that it reads, nodes ``result`` are the values that the
rest of the program uses.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import count

from .names import OperationGroup
from .program import Node, Program, Value

CALL, RESULT = "call", "result"
GIVEN, FOUND = "given", "found"
"""The input and the output of a routine."""
SHORTEST = 40
"""The fewest operations of a routine: of fewer a call with its arguments is no shorter."""
FREE = ("input", "epsilon")
"""What is there without an operation."""

Shape = tuple[tuple, ...]
"""The operations of a part of a program, but for their numbers: equal shapes are one routine."""


@dataclass(eq=False)
class Routine:
    """A program that others call: its one input is an array of values, its one output another."""

    name: str
    program: Program
    calls: int
    reads: list[str]
    """What the first call reads, by the names of quantities; "" of one without a name."""


@dataclass
class _Part:
    """The operations of a program that are one call."""

    name: str
    nodes: list[Node]
    sections: list[OperationGroup]
    used: set[int]
    """The numbers of the nodes that operations outside the part, or outputs, use."""
    given: list[Node] = field(init=False)
    """What it reads, in the order in which it does."""
    numbers: list[float] = field(init=False)
    shape: Shape = field(init=False)

    def __post_init__(self) -> None:
        own = {n.id: k for k, n in enumerate(self.nodes)}
        read = dict.fromkeys(a for n in self.nodes for a in n.args if isinstance(a, Node) and a.id not in own)
        places = {a.id: (GIVEN, k) for k, a in enumerate(read)}
        operand = lambda a: own.get(a.id, places.get(a.id)) if isinstance(a, Node) else "number"  # noqa: E731
        self.given = list(read)
        self.numbers = [a for n in self.nodes for a in n.args if not isinstance(a, Node)]
        self.shape = tuple((n.op, *map(operand, n.args)) for n in self.nodes)

    def follows_what_it_reads(self) -> bool:
        """Whether all that it reads is known before its first operation."""
        return all(n.op in FREE or n.id < self.nodes[0].id for n in self.given)


@dataclass
class _Call:
    """A call: the routine, the numbers among its arguments, and the places of its results among the operations."""

    routine: Routine
    numbers: list[float]
    found: list[int]


def outlined(programs: Sequence[Program]) -> tuple[list[Program], list[Routine]]:
    """The programs with calls in place of what recurs in them, and the routines that are called.

    Parts are one routine if they differ in numbers alone, and in which values are used; numbers that differ are
    arguments.
    """
    parts = [_parts(p) for p in programs]
    alike: dict[tuple[str, Shape], list[_Part]] = defaultdict(list)
    for part in (part for own in parts for part in own):
        alike[part.name, part.shape].append(part)
    names, calls = _Names(), dict[int, _Call]()
    for (name, _), same in alike.items():
        if len(same) > 1:
            varying, found, order = _varying(same), _found(same), _order(same[0])
            for part in same:
                part.given = [part.given[k] for k in order]
            slots = dict.fromkeys(varying.values())
            reads = [*map(_quantity, same[0].given), *("number" for _ in slots)]
            routine = Routine(names(name), _body(same[0], varying, found), len(same), reads)
            calls |= {id(part): _Call(routine, [part.numbers[k] for k in slots], found) for part in same}
    routines = list(dict.fromkeys(call.routine for call in calls.values()))
    return [_calling(p, own, calls) for p, own in zip(programs, parts, strict=True)], routines


class _Names:
    """Names that are not yet taken."""

    def __init__(self) -> None:
        self.taken: dict[str, count] = defaultdict(lambda: count(1))

    def __call__(self, stem: str) -> str:
        number = next(self.taken[stem])
        return stem if number == 1 else f"{stem}_{number}"


def _parts(program: Program) -> list[_Part]:
    """The parts of a program that were marked, but short ones and those with guards."""
    marked: dict[tuple[str, str], list[Node]] = defaultdict(list)
    for node in program.nodes:
        _, routine, call = program.sections[node.section]
        if routine and node.op not in FREE:
            marked[routine, call].append(node)
    home = {n.id: called for called, nodes in marked.items() for n in nodes}
    used = {v.id for values in program.outputs.values() for v in values if isinstance(v, Node)}
    for node in program.nodes:
        used |= {a.id for a in node.args if isinstance(a, Node) and home.get(a.id) != home.get(node.id)}
    guards = {g.id for g in program.guards}
    long = {
        r: nodes for r, nodes in marked.items() if len(nodes) >= SHORTEST and guards.isdisjoint(n.id for n in nodes)
    }
    parts = [_Part(routine, nodes, program.sections, used) for (routine, _), nodes in long.items()]
    return [part for part in parts if part.follows_what_it_reads()]


def _found(parts: Sequence[_Part]) -> list[int]:
    """The places of the operations whose values are used behind one of the parts."""
    return [k for k, same in enumerate(zip(*(p.nodes for p in parts), strict=True)) if _any_used(same, parts)]


def _quantity(node: Node) -> str:
    """The name of the quantity that a value is an entry of."""
    return str(node.args[0]) if node.op == "input" else node.label.quantity if node.label else ""


def _order(part: _Part) -> list[int]:
    """The places of what a part reads, as it is recorded: entries of an array follow each other."""
    return sorted(range(len(part.given)), key=lambda k: part.given[k].id)


def _any_used(nodes: Sequence[Node], parts: Sequence[_Part]) -> bool:
    return any(n.id in part.used for n, part in zip(nodes, parts, strict=True))


def _varying(parts: Sequence[_Part]) -> dict[int, int]:
    """The numbers of a shape, by their places, that are not the same in all parts; with the first place of an equal."""
    first: dict[tuple[float, ...], int] = {}
    out = {}
    for k, values in enumerate(zip(*(p.numbers for p in parts), strict=True)):
        if len(set(values)) > 1:
            out[k] = first.setdefault(values, k)
    return out


def _body(part: _Part, varying: dict[int, int], found: list[int]) -> Program:
    """The program of a routine: first the values that it reads, then the numbers that vary."""
    order, numbers, tracer = count(), count(), part.nodes[0].tracer
    copy = lambda old, op, *args: Node(tracer, op, args, next(order), old.section)  # noqa: E731
    made = {n.id: copy(part.nodes[0], "input", GIVEN, k) for k, n in enumerate(part.given)}
    slots = {k: len(part.given) + i for i, k in enumerate(dict.fromkeys(varying.values()))}
    arguments = {k: copy(part.nodes[0], "input", GIVEN, slot) for k, slot in slots.items()}

    def operand(value: Value) -> Value:
        if isinstance(value, Node):
            return made[value.id]
        k = next(numbers)
        return arguments[varying[k]] if k in varying else value

    for node in part.nodes:
        made[node.id] = copy(node, node.op, *map(operand, node.args))
        made[node.id].label = node.label
    results: dict[str, list[Value]] = {FOUND: [made[part.nodes[k].id] for k in found]}
    return Program(part.name, {GIVEN: len(part.given) + len(slots)}, results, [], part.sections)


def _calling(program: Program, parts: Sequence[_Part], calls: dict[int, _Call]) -> Program:
    """The program with calls in place of its parts that are routines."""
    order = count()
    home = {n.id: part for part in parts if id(part) in calls for n in part.nodes}
    if not home:
        return program
    copy = lambda old, op, *args: Node(old.tracer, op, args, next(order), old.section)  # noqa: E731
    made: dict[int, Node] = {n.id: copy(n, n.op, *n.args) for n in program.nodes if n.op in FREE}
    pick = lambda v: made[v.id] if isinstance(v, Node) else v  # noqa: E731
    for node in program.nodes:
        if node.id in made:
            continue
        if (part := home.get(node.id)) is None:
            made[node.id] = copy(node, node.op, *map(pick, node.args))
            made[node.id].label = node.label
        elif node is part.nodes[0]:
            of = calls[id(part)]
            call = copy(node, CALL, of.routine, *map(pick, part.given), *of.numbers)
            made |= {part.nodes[place].id: copy(node, RESULT, call, k) for k, place in enumerate(of.found)}
    outputs = {name: [pick(v) for v in values] for name, values in program.outputs.items()}
    guards = [made[g.id] for g in program.guards]
    return Program(program.name, program.inputs, outputs, guards, program.sections, program.origins)
