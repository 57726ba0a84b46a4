"""Programs as readable C statements; ``$_`` stands for the robot's prefix, ``$$_`` for that in capitals.

Named values keep their names. A value that is used once is written where it is used. Every section has a comment. The
grouping of the program is kept, so C and the NumPy back end round alike.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from itertools import count
from typing import ClassVar

from ...ir.program import Node, Program, Value, live
from ...ir.replay import BINARY
from ...ir.routines import CALL, FOUND, GIVEN, RESULT
from ...ir.signs import signed
from .copies import array, copied

Place = Callable[[str, int], str | None]
"""The C expression of entry k of an input or output; None for an output that is not stored."""
Fail = Callable[[str, int], str]
"""The statement for a guard: of the test for its failure, and of its link."""

SYMBOL = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
PRECEDENCE = {"add": 1, "sub": 1, "mul": 2, "div": 2, "neg": 3}
ATOM = 4
WIDTH = 96
KEYWORDS = frozenset(
    "auto break case char const continue default do double else enum extern float for goto if inline int long "
    "register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while "
    "sin cos sqrt exp atan2 y0 y1 yn j0 j1 jn gamma real REAL NULL k".split()  # k counts in loops
)


def literal(value: float) -> str:
    """A number in the target's precision; whole numbers as integers."""
    if value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return f"$$_REAL({value!r})"


@dataclass
class Writer:
    """Turns one program into lines of C.

    Without ``fail`` a program has no guards; ``taken`` are the names of the function's parameters.  ``apart``: no
    output shares memory with an input, so outputs may be written as soon as they are known.  ``optional`` maps outputs
    to the C condition on which they are wanted: operations that only they need are inside that condition.  ``within``
    nests one condition in another, so its operations can use the values of the outer one. An entry None of an output is
    not written.
    """

    program: Program
    place: Place
    fail: Fail | None = None
    taken: set[str] = field(default_factory=set)
    apart: bool = False
    optional: Mapping[str, str] = field(default_factory=dict)
    within: Mapping[str, str] = field(default_factory=dict)
    adding: frozenset[str] = frozenset()
    """The outputs that are added to what is in their place."""
    paired: ClassVar[bool] = True
    """Whether sine and cosine of an angle come from one call."""
    prefix: ClassVar[str] = "$"
    """The prefix of the real type and of the functions."""

    def lines(self) -> list[str]:
        """The body of a function: sections of assignments, then the outputs."""
        self.program = signed(self.program)
        self._count_uses()
        self._names: dict[int, str] = {}
        self._numbers = count(1)
        self._pending: dict[int, tuple[str, int]] = {}
        self._written = {
            (n, k) for n, values in self.program.outputs.items() for k, v in enumerate(values) if v is None
        }
        self._guards = {g.id: o for g, o in zip(self.program.guards, self.program.origins, strict=True)}
        always, groups = self._groups()
        out = self._part(always, "")
        for condition in groups:
            if self.within.get(condition) not in groups:
                out += self._conditional(condition, groups)
        return out

    def _conditional(self, condition: str, groups: Mapping[str, list[Node]]) -> list[str]:
        """The lines that depend on a condition, and on those nested in it."""
        block = self._part(groups[condition], condition)
        for inner in (c for c in groups if self.within.get(c) == condition):
            block += self._conditional(inner, groups)
        inside = [f"    {line}" if line else "" for line in block[not block[0] :]]
        return ["", f"if ({condition}) {{", *inside, "}"]

    def _part(self, nodes: Iterable[Node], condition: str) -> list[str]:
        """The assignments, by sections, and the outputs of one condition."""
        self._condition, nodes = condition, list(nodes)
        self._pairs = pairs(nodes) if self.paired else {}
        out: list[str] = []
        section = None
        for node in nodes:
            statements = self._statements(node)
            if node.op == CALL:
                out, section = [*out, ""], None
            elif statements and node.section != section:
                section = node.section
                out += self._heading(section)
            out += statements
        return [*out, *self._outputs()]

    def _groups(self) -> tuple[list[Node], dict[str, list[Node]]]:
        """The nodes that are always needed, and for every condition those that only its outputs need."""
        p, conditions = self.program, dict.fromkeys(c for n, c in self.optional.items() if n in self.program.outputs)
        if not conditions:
            return p.nodes, {}
        values = lambda c: [v for n, e in p.outputs.items() if self.optional.get(n, "") == c for v in e]  # noqa: E731
        common = {n.id for n in live([*values(""), *p.guards])}
        needs = {c: {n.id for n in live(values(c))} for c in conditions}
        outer = {c: needs[c].union(*(needs[d] for d in needs if self.within.get(d) == c)) for c in needs}
        times = Counter(i for c, ids in outer.items() if self.within.get(c) not in needs for i in ids)
        common |= {i for i, count in times.items() if count > 1}
        needs = {c: ids - needs.get(self.within.get(c, ""), set()) - common for c, ids in needs.items()}
        groups = {c: [n for n in p.nodes if n.id in needs[c]] for c in conditions}
        return [n for n in p.nodes if n.id in common], groups

    def _count_uses(self) -> None:
        self._uses: Counter[int] = Counter()
        self._users: dict[int, Node] = {}
        for node in self.program.nodes:
            if node.op != "input":
                for arg in node.args:
                    if isinstance(arg, Node):
                        self._uses[arg.id] += 1
                        self._users[arg.id] = node
        self._results: dict[int, list[tuple[str, int, str]]] = {}  # by value: its outputs, and their sign
        for output, values in self.program.outputs.items():
            for k, v in enumerate(values):
                if isinstance(v, Node):
                    self._uses[v.id] += 2
                    self._results.setdefault(v.id, []).append((output, k, ""))
                    if v.op == "neg":
                        self._results.setdefault(v.args[0].id, []).append((output, k, "-"))

    def _heading(self, section: int) -> list[str]:
        title = self.program.sections[section].title
        return ["", f"/* {title} */"] if title else [""]

    def _statements(self, node: Node) -> list[str]:
        if node.op in ("input", "epsilon", RESULT) or self._served(node):
            return []
        if node.op == CALL:
            return self._call(node)
        if node.id in self._guards and not self._uses[node.id]:
            return [self._guard(node, self._text(node)[0])]
        if node.id in self._pairs:
            return [] if node.id in self._names else self._sine_and_cosine(*self._pairs[node.id])
        text, precedence = self._text(node)
        if self._inlined(node, text):
            self._pending[node.id] = (text, precedence)
            return []
        name = self._name(node)
        lines = [f"const {self.prefix}_real {name} = {text};"]
        if node.id in self._guards:
            lines.append(self._guard(node, name))
        return lines + self._early_outputs(node, name)

    def _call(self, node: Node) -> list[str]:
        """A routine run on an array of values, which is of no use later, and the array of its results."""
        routine, *values = node.args
        self._names[node.id] = name = self._free(routine.name)
        filled = array(f"{self.prefix}_real {GIVEN}", [self._value(v)[0] for v in values], WIDTH - 4)
        inside = [*filled, f"{called(routine.name)}({GIVEN}, {name});"]
        found = f"{self.prefix}_real {name}[{len(routine.program.outputs[FOUND])}];"
        return [found, "{", *(f"    {line}" for line in inside), "}"]

    def _sine_and_cosine(self, sine: Node, cosine: Node) -> list[str]:
        """Both of an angle by one call."""
        names, both = (self._name(sine), self._name(cosine)), self._free("turn")
        angle = self._operand(sine.args[0], 0)
        lines = [f"const {self.prefix}_sincos {both} = {self.prefix}_sine_cosine({angle});"]
        lines.append(f"const {self.prefix}_real {names[0]} = {both}.sine, {names[1]} = {both}.cosine;")
        return lines + self._early_outputs(sine, names[0]) + self._early_outputs(cosine, names[1])

    def _guard(self, node: Node, text: str) -> str:
        assert self.fail is not None, f"{self.program.name} has guards"
        return self.fail(f"!({text} > 0)", self._guards[node.id])

    def _early_outputs(self, node: Node, name: str) -> list[str]:
        """The outputs that equal this value or its negative and may be written now."""
        if not self.apart:
            return []
        lines = []
        for output, k, sign in self._results.get(node.id, ()):
            wanted = self.optional.get(output, "") == self._condition
            if wanted and (output, k) not in self._written and self.place(output, k) is not None:
                self._written.add((output, k))
                lines.append(f"{self.place(output, k)} {self._assign(output)} {sign}{name};")
        return lines

    def _assign(self, output: str) -> str:
        return "+=" if output in self.adding else "="

    def _served(self, node: Node) -> bool:
        """Whether a negative is used only by outputs that were written with its operand."""
        if node.op != "neg" or node.id in self._guards or node.id in self._users:
            return False
        places = [(o, k) for o, values in self.program.outputs.items() for k, v in enumerate(values) if v is node]
        return all(place in self._written for place in places)

    def _inlined(self, node: Node, text: str) -> bool:
        if node.label or self._uses[node.id] != 1 or node.id in self._guards or len(text.replace("$$_", "")) > WIDTH:
            return False
        user = self._users.get(node.id)
        return user is not None and user.section == node.section

    def _name(self, node: Node) -> str:
        if node.label:
            name = self._free(str(node.label))
        else:
            name = next(name for k in self._numbers if (name := f"t{k}") not in self.taken)
            self.taken.add(name)
        self._names[node.id] = name
        return name

    def _free(self, stem: str) -> str:
        """A name that is not taken yet; it is marked as taken."""
        name, number = stem if stem not in KEYWORDS else f"{stem}1", 1
        while name in self.taken:
            number += 1
            name = f"{stem}_{number}"
        self.taken.add(name)
        return name

    def _text(self, node: Node) -> tuple[str, int]:
        if node.op in BINARY:
            return self._binary(node)
        if node.op == "neg":
            inner = self._operand(node.args[0], 3)
            return f"-({inner})" if inner.startswith("-") else f"-{inner}", 3
        return f"{self.prefix}_{node.op}({', '.join(map(self._argument, node.args))})", ATOM

    def _argument(self, value: Value) -> str:
        """What a function is called with."""
        return self._operand(value, 0)

    def _binary(self, node: Node) -> tuple[str, int]:
        own = PRECEDENCE[node.op]
        left, right = self._operand(node.args[0], own), self._operand(node.args[1], own + 1)
        return f"{left} {SYMBOL[node.op]} {right}", own

    def _operand(self, value: Value, precedence: int) -> str:
        text, own = self._value(value)
        return f"({text})" if own < precedence else text

    def _value(self, value: Value) -> tuple[str, int]:
        if not isinstance(value, Node):
            return literal(value), ATOM if value >= 0 else 3
        if value.op == "input":
            text = self.place(*value.args)
            assert text is not None, f"{self.program.name} reads {value.args}"
            return text, ATOM
        if value.op == RESULT:
            call, k = value.args
            return f"{self._names[call.id]}[{k}]", ATOM
        if value.op == "epsilon":
            return f"{self.prefix.replace('$', '$$').upper()}_REAL_EPSILON", ATOM
        return self._pending[value.id] if value.id in self._pending else (self._names[value.id], ATOM)

    def _outputs(self) -> list[str]:
        out: list[str] = []
        for name, values in self.program.outputs.items():
            if self.optional.get(name, "") != self._condition:
                continue
            left = ((k, v) for k, v in enumerate(values) if (name, k) not in self._written)
            placed, assign = [(place, v) for k, v in left if (place := self.place(name, k))], self._assign(name)
            passed = [(p, self._value(v)[0]) for p, v in placed if isinstance(v, Node) and v.op == RESULT]
            out += [
                f"{p} {assign} {self._value(v)[0]};" for p, v in placed if not (isinstance(v, Node) and v.op == RESULT)
            ]
            out += copied(passed, assign)
        return ["", "/* outputs */", *out] if out else []


def called(routine: str) -> str:
    """The name of the C function of a routine."""
    return f"compute_{routine}"


def entries(array: str, *sizes: int) -> Callable[[int], str]:
    """The C expressions of the entries of an array by their numbers, row by row; its ``sizes`` but for the first."""

    def text(k: int) -> str:
        places = ""
        for size in reversed(sizes):
            k, places = k // size, f"[{k % size}]{places}"
        return f"{array}[{k}]{places}"

    return text


def trimmed(lines: list[str]) -> list[str]:
    """The body of a function without leading empty lines."""
    return lines[1:] if lines[:1] == [""] else lines


def with_unused(names: Iterable[str], lines: list[str]) -> list[str]:
    """The body of a function, with its unused pointers marked as such."""
    text = "\n".join(lines)
    used = lambda x: any(f"{x}{mark}" in text for mark in ("->", "[")) and re.search(rf"\b{x}(->|\[)", text)  # noqa: E731
    return [f"(void){x};" for x in names if not used(x)] + lines


def pairs(nodes: Iterable[Node]) -> dict[int, tuple[Node, Node]]:
    """Sine and cosine of every angle of which both are among the nodes, by the number of either."""
    found: dict[int, dict[str, Node]] = {}
    for node in nodes:
        if node.op in ("sin", "cos"):
            found.setdefault(node.args[0].id, {})[node.op] = node
    both = [(x["sin"], x["cos"]) for x in found.values() if len(x) == 2]
    return {node.id: pair for pair in both for node in pair}


def singular(test: str, link: int) -> str:
    """The statement of a guard that ends a function with its link in ``work``."""
    return f"if ({test}) {{ work->fault = {link}; return $$_SINGULAR; }}"


def sizes(programs: Iterable[Program]) -> int:
    """The number of operations of several programs."""
    return sum(p.operation_count for p in programs)


def by_kind(counts: Counter[str]) -> dict[str, int]:
    """Counts of operations as tables have them: all, and those of each kind."""
    other = sum(n for op, n in counts.items() if op not in ("mul", "add", "sub", "div", "neg"))
    added = counts["add"] + counts["sub"] + counts["neg"]
    return {"total": counts.total(), "mul": counts["mul"], "add": added, "div": counts["div"], "other": other}
