"""Programs as tables: operations that do not depend on each other side by side, a few at a time.

Compilers of arrays take minutes over thousands of scalar operations. A table of them is run by one short loop: every
row reads operands by their places in a file of registers and writes as many results behind those before it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .program import Node, Program

ARITHMETIC = ("add", "sub", "mul")
"""What one row may mix; of all else a row has one kind."""

WIDTHS = (8, 16, 24, 32, 48, 64, 96, 128)
PER_ROW = 12
"""What a row costs beside its operations, in operations."""


@dataclass(frozen=True)
class Levels:
    """A program in rows of ``width`` operations.

    Registers are the ``literals``, then all inputs in their order, then the results of the rows. ``kind`` (rows,):
    place in ``kinds``, of which the first is arithmetic; ``op``, ``a``, ``b`` (rows, width): of arithmetic, the place
    in ``ARITHMETIC``, and the registers of the operands; ``count``: of every kind the largest number of operations in
    a row, which stand first. ``outputs``: the registers of every output; ``guards``: those of the guards.
    """

    literals: np.ndarray
    inputs: dict[str, int]
    width: int
    kinds: tuple[str, ...]
    count: tuple[int, ...]
    kind: np.ndarray
    op: np.ndarray
    a: np.ndarray
    b: np.ndarray
    outputs: dict[str, np.ndarray]
    guards: np.ndarray


def levels(program: Program, epsilon: float) -> Levels:
    """The rows of a program; ``epsilon``: the spacing of the numbers that it is run on."""
    operations = [n for n in program.nodes if n.op not in ("input", "epsilon")]
    order = _Order(operations)
    rows = min((order.rows(width) for width in WIDTHS), key=_cost)
    return _table(program, epsilon, *rows)


def _cost(found: tuple[list[list[Node]], int]) -> int:
    rows, width = found
    return len(rows) * (width + PER_ROW)


def _kind(node: Node) -> str:
    return "" if node.op in ARITHMETIC or node.op == "neg" else node.op


class _Order:
    """Which operations use which, and how many each waits for."""

    def __init__(self, operations: list[Node]):
        self._operations, self._ahead = operations, _ahead(operations)
        self._users: dict[int, list[Node]] = {n.id: [] for n in operations}
        self._missing = {n.id: 0 for n in operations}
        for node in operations:
            for before in {a.id for a in node.args if isinstance(a, Node) and a.id in self._missing}:
                self._users[before].append(node)
                self._missing[node.id] += 1
        self._rank = {n.id: (-self._ahead[n.id], n.id) for n in operations}

    def rows(self, width: int) -> tuple[list[list[Node]], int]:
        """Rows of operations of one kind whose operands stand in rows before; the longest way to the end first."""
        ahead, users, missing, rank = self._ahead, self._users, self._missing.copy(), self._rank
        ready: dict[str, list[Node]] = {}
        grown = _sort_in(ready, [n for n in self._operations if not missing[n.id]])
        rows = []
        while ready:
            for kind in grown:
                ready[kind].sort(key=lambda n: rank[n.id])
            kind = max(ready, key=lambda kind: (ahead[ready[kind][0].id], kind))
            row, rest = ready[kind][:width], ready[kind][width:]
            ready[kind] = rest
            if not rest:
                del ready[kind]
            rows.append(row)
            for node in row:
                for user in users[node.id]:
                    missing[user.id] -= 1
            later = {user.id: user for node in row for user in users[node.id] if not missing[user.id]}
            grown = _sort_in(ready, list(later.values()))
        return rows, width


def _ahead(operations: list[Node]) -> dict[int, int]:
    """The number of operations on the longest way from each to the end."""
    ahead = {n.id: 0 for n in operations}
    for node in reversed(operations):
        for a in node.args:
            if isinstance(a, Node) and a.id in ahead:
                ahead[a.id] = max(ahead[a.id], ahead[node.id] + 1)
    return ahead


def _sort_in(ready: dict[str, list[Node]], nodes: list[Node]) -> set[str]:
    """Adds nodes to those of their kinds, and says which kinds these are."""
    for node in nodes:
        ready.setdefault(_kind(node), []).append(node)
    return {_kind(node) for node in nodes}


def _table(program: Program, epsilon: float, rows: list[list[Node]], width: int) -> Levels:
    literals: dict[float, int] = {-1.0: 0}
    values = [v for row in rows for n in row for v in n.args]
    values += [v for entries in program.outputs.values() for v in entries]
    for v in [epsilon, *(float(v) for v in values if not isinstance(v, Node))]:
        literals.setdefault(v, len(literals))
    first, starts = len(literals), {}
    for name, size in program.inputs.items():
        starts[name], first = first, first + size
    place = {n.id: first + r * width + k for r, row in enumerate(rows) for k, n in enumerate(row)}
    for n in program.nodes:
        if n.op == "input":
            place[n.id] = starts[n.args[0]] + n.args[1]
        elif n.op == "epsilon":
            place[n.id] = literals[epsilon]
    at = lambda v: place[v.id] if isinstance(v, Node) else literals[float(v)]  # noqa: E731
    kinds = ("", *sorted({_kind(row[0]) for row in rows} - {""}))
    count = tuple(max((len(row) for row in rows if _kind(row[0]) == kind), default=0) for kind in kinds)
    op, a, b = (np.zeros((len(rows), width), np.int32) for _ in range(3))
    for r, row in enumerate(rows):
        for k, n in enumerate(row):
            a[r, k], b[r, k] = at(n.args[0]), at(n.args[1]) if len(n.args) > 1 else 0
            op[r, k] = ARITHMETIC.index(n.op) if n.op in ARITHMETIC else ARITHMETIC.index("mul")
    return Levels(
        literals=np.array(list(literals)),
        inputs=dict(program.inputs),
        width=width,
        kinds=kinds,
        count=count,
        kind=np.array([kinds.index(_kind(row[0])) for row in rows], np.int32),
        op=op,
        a=a,
        b=b,
        outputs={name: np.array([at(v) for v in entries], np.int32) for name, entries in program.outputs.items()},
        guards=np.array([at(g) for g in program.guards], np.int32),
    )
