"""Signs of intermediate values: named negatives become the values themselves where that takes no operation.

A sign may move from a value to its uses: ``a - x`` is ``a + y`` with ``y = -x``. The search is local and takes no
operation more; rounding is symmetric, so results stay.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import count
from typing import Any

from .program import Node, Program, Value
from .replay import BINARY

IMPOSSIBLE = 1000
"""The cost of a sign before the argument of a function."""
STEPS = 30
"""The trials of flips per value: a bound on the time for large programs."""


def signed(program: Program) -> Program:
    """The program with as few named negatives as a local search finds; it has no more operations."""
    signs = _Signs(program)
    for node in program.nodes:
        if node.label and node.label.negative and signs.of(node) > 0:
            signs.flip(node)
    return _rebuilt(program, signs)


class _Signs:
    """The values of a program that are replaced by their negatives."""

    def __init__(self, program: Program):
        self.flipped: set[int] = set()
        self._users: dict[int, list[Node]] = defaultdict(list)
        for node in program.nodes:
            for a in node.args if node.op != "input" else ():
                if isinstance(a, Node):
                    self._users[a.id].append(node)
        self._results = {v.id for values in program.outputs.values() for v in values if isinstance(v, Node)}
        self._guards = {g.id for g in program.guards}

    def of(self, value: Value) -> int:
        return -1 if isinstance(value, Node) and value.id in self.flipped else 1

    def flip(self, node: Node) -> None:
        """Flip a value, and others with it, unless that takes operations."""
        self._left = STEPS
        if self._free(node):
            self._extended({}, node)

    def _extended(self, costs: Mapping[Node, int], new: Node) -> bool:
        """Whether a group of flips with one more, or a larger one, takes no operation; if not, that is undone.

        `costs`: of the values that the group is or that use it.
        """
        self._left -= 1
        self.flipped.add(new.id)
        costs = {**costs, **{u: self._cost(u) for u in (new, *self._users[new.id])}}
        if sum(costs.values()) <= 0:
            return True
        worst = max(costs, key=costs.__getitem__)
        for candidate in (worst, *worst.args):
            if self._left > 0 and self._free(candidate) and self._extended(costs, candidate):
                return True
        self.flipped.discard(new.id)
        return False

    def _free(self, value: Value) -> bool:
        """Whether a value may be flipped: no input, function or guard, and not one that has its name already."""
        if not isinstance(value, Node) or value.op not in BINARY:
            return False
        if value.id in self.flipped or value.id in self._guards:
            return False
        return value.label is None or value.label.negative

    def _cost(self, node: Node) -> int:
        """The operations that a value takes beyond those of the program as it was."""
        own = self.of(node)
        signs = [own * self.of(a) for a in node.args] if node.op != "input" else []
        if node.op == "neg":
            return -(signs[0] < 0)
        if node.op == "add":
            wrong = max(signs) < 0
        elif node.op == "sub":
            wrong = signs[0] < 0 < signs[1]
        elif node.op in BINARY:
            wrong = own * signs[0] * signs[1] < 0
        else:
            wrong = any(s < 0 for s in signs)
        return (1 if node.op in BINARY else IMPOSSIBLE) * wrong + (own < 0 and node.id in self._results)


def _rebuilt(program: Program, signs: _Signs) -> Program:
    """The program with the flipped values."""
    made: dict[int, Node] = {}
    numbers = count()

    def node(of: Node, op: str, *args: Any) -> Node:
        return Node(of.tracer, op, args, next(numbers), of.section)

    def pick(value: Value) -> Value:
        return made[value.id] if type(value) is Node else value

    def result(value: Value) -> Value:
        if isinstance(value, Node) and value.id in signs.flipped:
            return node(value, "neg", made[value.id])
        return pick(value)

    flipped = signs.flipped
    for old in program.nodes:
        if old.id not in flipped and not any(type(a) is Node and a.id in flipped for a in old.args):
            made[old.id] = node(old, old.op, *map(pick, old.args))
            made[old.id].label = old.label
            continue
        op, args, negated = _operation(old, signs)
        if op == "same":
            made[old.id] = made[args[0].id]
            continue
        made[old.id] = node(old, op, *map(pick, args))
        if negated:
            made[old.id] = node(old, "neg", made[old.id])
        if old.label:
            made[old.id].label = old.label._replace(negative=old.label.negative != (signs.of(old) < 0))
    outputs = {name: [result(v) for v in values] for name, values in program.outputs.items()}
    guards = [made[g.id] for g in program.guards]
    return Program(program.name, program.inputs, outputs, guards, program.sections, program.origins)


def _operation(node: Node, signs: _Signs) -> tuple[str, Sequence, bool]:
    """Operation and operands of a value as it is stored, and whether its negative is."""
    coefficients = [signs.of(node) * signs.of(a) for a in node.args]
    if node.op in ("add", "sub"):
        a, b = node.args
        first, second = coefficients[0], coefficients[1] * (1 if node.op == "add" else -1)
        if first == second:
            return "add", (a, b), first < 0
        return "sub", (a, b) if first > 0 else (b, a), False
    if node.op == "neg" and coefficients[0] < 0:
        return "same", node.args, False
    return node.op, node.args, node.op in BINARY and signs.of(node) * coefficients[0] * coefficients[1] < 0
