"""Programs: straight-line scalar operations, made by tracing.

A :class:`Program` is a list of scalar operations in which every value is assigned once.  It is made
by *tracing*: ordinary Python functions run on arrays of :class:`Node`, and every operation is
recorded, numbered by its value (equal operations are one node) and simplified where an operand is
zero or one.  Entries that are plain floats are structure: a zero costs no operation.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, TypeGuard

import numpy as np

from ..lazily import mpmath
from ..notebook import program_text
from .names import Label, OperationGroup

Array = np.ndarray

FUNCTIONS = frozenset({"sqrt", "sin", "cos", "exp", "on", "atan2", "c4", "c5", "c6", "c7", "c8", "c9"})
"""Primitives; ``c4`` and ``c5`` are the Stumpff functions from which the others follow (c6 to c9: slopes).

``on`` is 1 where its argument is > 0, else 0; ``atan2(y, x)``, of two, is 0 at the origin, without a slope there.
"""


class Node:
    """One value of a program: an operation on nodes and floats, or an input entry."""

    __slots__ = ("args", "id", "label", "op", "section", "tracer")

    def __init__(self, tracer: Tracer, op: str, args: tuple, number: int, section: int):
        self.tracer, self.op, self.args, self.id, self.section = tracer, op, args, number, section
        self.label: Label | None = None

    def __add__(self, other: Value) -> Value:
        return NotImplemented if isinstance(other, np.ndarray) else self.tracer.add(self, other)

    def __radd__(self, other: Value) -> Value:
        return self.tracer.add(other, self)

    def __sub__(self, other: Value) -> Value:
        return NotImplemented if isinstance(other, np.ndarray) else self.tracer.sub(self, other)

    def __rsub__(self, other: Value) -> Value:
        return self.tracer.sub(other, self)

    def __mul__(self, other: Value) -> Value:
        return NotImplemented if isinstance(other, np.ndarray) else self.tracer.mul(self, other)

    def __rmul__(self, other: Value) -> Value:
        return self.tracer.mul(other, self)

    def __truediv__(self, other: Value) -> Value:
        return NotImplemented if isinstance(other, np.ndarray) else self.tracer.div(self, other)

    def __rtruediv__(self, other: Value) -> Value:
        return self.tracer.div(other, self)

    def __neg__(self) -> Value:
        return self.tracer.neg(self)

    @property
    def called(self) -> tuple[str, str]:
        """The routine and the call of it that the operation belongs to; empty where it is none."""
        return self.tracer.sections[self.section][1:]

    def __repr__(self) -> str:
        return f"<{self.label or self.op} {self.id}>"


Value = Node | float
Vector = Sequence[Value] | np.ndarray
"""Entries of which some are nodes, in a list or in an array of objects."""


class Tracer:
    """Records operations; equal operations on equal values are recorded once.

    Operands are values; the quick test `type(x) is Node` tells a type checker nothing, so they are declared as Any.
    """

    def __init__(self) -> None:
        self._table: dict[tuple, Node] = {}
        self.sections: list[OperationGroup] = [OperationGroup("")]
        self._section = 0
        self._call = ("", "")
        self.guards: list[Node] = []
        self.origins: list[int] = []
        self._count = 0

    @contextmanager
    def section(self, title: str) -> Iterator[None]:
        """Operations recorded inside belong to a section of this title."""
        before = self._section
        self.sections.append(OperationGroup(title, *self._call))
        self._section = len(self.sections) - 1
        try:
            yield
        finally:
            self._section = before

    @contextmanager
    def routine(self, name: str) -> Iterator[None]:
        """Operations recorded inside recur: back ends may print them once and call them, see :mod:`.routines`."""
        before, new = self._call, (name, str(len(self.sections)))
        self._call = before if before[0] else new
        try:
            with self.section(self.sections[self._section].title):
                yield
        finally:
            self._call = before

    def _node(self, op: str, *args: Any) -> Node:
        key = (op, *args)
        node = self._table.get(key)
        return self._recorded(key, op, args) if node is None else node

    def _sum_or_product(self, op: str, a: Value, b: Value) -> Node:
        """The node of an operation whose operands commute: numbers of nodes rise in its key, floats come last."""
        later = type(a) is not Node or (type(b) is Node and b.id < a.id)
        key = (op, b, a) if later else (op, a, b)
        node = self._table.get(key)
        return self._recorded(key, op, (a, b)) if node is None else node

    def _recorded(self, key: tuple, op: str, args: tuple) -> Node:
        node = self._table[key] = Node(self, op, args, self._count, self._section)
        self._count += 1
        return node

    def input(self, name: str, size: int) -> list[Node]:
        """The entries of an input."""
        return [self._node("input", name, i) for i in range(size)]

    def program(self, name: str, inputs: dict[str, int], outputs: dict[str, list[Value]]) -> Program:
        """The recorded operations that the outputs depend on."""
        self._table = {}
        return Program(name, inputs, outputs, list(self.guards), self.sections, list(self.origins))

    def epsilon(self) -> Node:
        """The spacing of the floating-point numbers of the target."""
        return self._node("epsilon")

    def guard(self, value: Value, origin: int = 0) -> None:
        """Require ``value > 0``: a program whose guard fails has no result; ``origin`` numbers the link."""
        if isinstance(value, Node) and not any(value is g for g in self.guards):
            self.guards.append(value)
            self.origins.append(origin)

    def named(self, name: str, value: Value) -> Value:
        """The value, called so in generated code."""
        give_label(value, Label(name))
        return value

    def add(self, a: Any, b: Any) -> Value:
        first, second = type(a) is Node, type(b) is Node
        if not (first and second):
            if not (first or second):
                return a + b
            if (b if first else a) == 0.0:
                return a if first else b
        if second and b.op == "neg":
            return self.sub(a, b.args[0])
        if first and a.op == "neg":
            return self.sub(b, a.args[0])
        if second and b.op == "sub" and b.args[1] is a:
            return b.args[0]  # a + (b - a)
        if first and a.op == "sub" and a.args[1] is b:
            return a.args[0]
        return self._sum_or_product("add", a, b)

    def sub(self, a: Any, b: Any) -> Value:
        first, second = type(a) is Node, type(b) is Node
        if not (first and second):
            if not (first or second):
                return a - b
            if (b if first else a) == 0.0:
                return a if first else self.neg(b)
        if a is b:
            return 0.0
        if second and b.op == "neg":
            return self.add(a, b.args[0])
        if first and a.op == "neg":
            return self.neg(self.add(a.args[0], b))
        if second and b.op == "sub" and b.args[0] is a:
            return b.args[1]  # a - (a - b)
        if second and first and a.op == "add" and any(x is b for x in a.args):
            return a.args[1] if a.args[0] is b else a.args[0]  # (a + b) - b
        return self._node("sub", a, b)

    def mul(self, a: Any, b: Any) -> Value:
        if type(a) is not Node:
            if type(b) is not Node:
                return a * b
            a, b = b, a
        if type(b) is not Node:
            if b == 0.0:
                return 0.0
            if abs(b) == 1.0:
                return a if b > 0 else self.neg(a)
            return self.neg(self.mul(a.args[0], b)) if a.op == "neg" else self._scaled(a, b)
        minus, other = a.op == "neg", b.op == "neg"
        if minus or other:
            product = self.mul(a.args[0] if minus else a, b.args[0] if other else b)
            return product if minus and other else self.neg(product)
        for x, y in ((a, b), (b, a)):
            rest = _without_inverse(x, y) if x.op in ("mul", "div") else None
            if rest is not None:
                return rest  # (x * (1 / d)) * d
        return self._sum_or_product("mul", a, b)

    def _scaled(self, a: Node, number: float) -> Value:
        """A node times a number, its sign outside and numbers taken together."""
        if number < 0:
            return self.neg(self._scaled(a, -number))
        if a.op == "mul" and not isinstance(a.args[1], Node):
            return self.mul(a.args[0], a.args[1] * number)
        return self._sum_or_product("mul", a, number)

    def div(self, a: Value, b: Value) -> Value:
        if not isinstance(a, Node) and not isinstance(b, Node):
            return a / b
        if _is(a, 0.0) or _is(b, 1.0):
            return a
        if not isinstance(b, Node):
            return self.mul(a, 1.0 / b)
        if _negated(a) or _negated(b):
            quotient = self.div(_positive(a), _positive(b))
            return self.neg(quotient) if _negated(a) != _negated(b) else quotient
        return self._node("div", a, b)

    def neg(self, a: Value) -> Value:
        if not isinstance(a, Node):
            return -a if a else 0.0
        return a.args[0] if a.op == "neg" else self._node("neg", a)

    def call(self, function: str, a: Any, *more: Any) -> Value:
        """A primitive of its arguments."""
        known = not any(isinstance(x, Node) for x in (a, *more))
        if known and function in ("sin", "cos", "sqrt", "exp", "atan2"):
            return float(getattr(mpmath, function)(a, *more))  # the same on every machine
        if known and function == "on":
            return float(a > 0)
        if _negated(a) and function in ("sin", "cos"):
            inner = self.call(function, a.args[0])
            return inner if function == "cos" else self.neg(inner)
        return self._node(function, a, *more)


def _without_inverse(product: Node, d: Value) -> Value | None:
    """``x`` if ``product`` is ``x * (1 / d)`` or ``1 / d`` itself, else None."""
    if _inverse(product, d):
        return 1.0
    if product.op == "mul":
        for x, y in (product.args, product.args[::-1]):
            if _inverse(y, d):
                return x
    return None


def _inverse(a: Value, d: Value) -> bool:
    """Whether ``a`` is ``1 / d``."""
    return isinstance(a, Node) and a.op == "div" and a.args[1] is d and _is(a.args[0], 1.0)


def _is(a: Value, value: float) -> bool:
    return not isinstance(a, Node) and a == value


def _negated(a: Value) -> TypeGuard[Node]:
    return isinstance(a, Node) and a.op == "neg"


def _positive(a: Value) -> Value:
    return a.args[0] if _negated(a) else a


@dataclass
class Program:
    """A traced function: named inputs and outputs (flat lists of entries) and guards.

    ``outputs`` maps a name to its entries, nodes or floats; ``nodes`` are the live operations in an
    order in which they can be run; ``sections`` are those that nodes refer to, ``origins`` the links
    that guards belong to.
    """

    name: str
    inputs: dict[str, int]
    outputs: dict[str, list[Value]]
    guards: list[Node]
    sections: list[OperationGroup]
    origins: list[int] = field(default_factory=list)
    nodes: list[Node] = field(init=False)

    def __post_init__(self) -> None:
        values = [v for entries in self.outputs.values() for v in entries] + self.guards
        self.nodes = live(values)
        self._computed = [n for n in self.nodes if n.op not in ("input", "epsilon")]

    @property
    def operations(self) -> Counter:
        """The number of operations of each kind."""
        return Counter(n.op for n in self._computed)

    @property
    def operation_count(self) -> int:
        return len(self._computed)

    def __repr__(self) -> str:
        return f"<Program {self.name}: {self.operation_count} operations, {len(self.guards)} guards>"

    def _repr_markdown_(self) -> str:
        results = {name: len(entries) for name, entries in self.outputs.items()}
        return program_text(
            repr(self), self.inputs, results, Counter(self.sections[n.section].title for n in self._computed)
        )


def give_label(value: Value, label: Label) -> None:
    """Name a computed value, or its operand if it is a negative, unless it has a name.

    The name of a negative gives way to that of the value itself.
    """
    if isinstance(value, Node) and value.op == "neg":
        value, label = value.args[0], label._replace(negative=not label.negative)
    if not isinstance(value, Node) or value.op in ("input", "epsilon"):
        return
    if value.label is None or (value.label.negative and not label.negative):
        value.label = label


def live(values: Iterable[Value]) -> list[Node]:
    """The nodes that ``values`` depend on, in the order in which they were recorded."""
    found = {v.id: v for v in values if type(v) is Node}
    stack = [*found.values()]
    while stack:
        for a in stack.pop().args:
            if type(a) is Node and a.id not in found:
                found[a.id] = a
                stack.append(a)
    return [found[number] for number in sorted(found)]
