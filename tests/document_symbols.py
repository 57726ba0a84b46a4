"""The symbols of a document: what its steps, formulas and tables say that they are."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import sympy as sp
from document_steps import FieldSymbol, computed, evaluated, integrates, sized
from latex_formula import SYMBOL, ZERO, Value, Zero, value

from screwgen.algebra import expression as ex
from screwgen.backends.latex.content import Display, Document, DocumentTable, Heading, Paragraph, StepEquation

APART = (r"Link, its angular", r"Motion of", r"Energy", r"Posture", r"Limits", r"Section at", r"Section of the rod")
APART += ("Mass of the rod", "Inertia of a section", "Load of a section", "Tendon at")
"""Headings whose steps are other forms of the equations, or of one point of several."""
IDENTITY = re.compile(r"\\mathbf\{R\}|\\mathbf\{J\}_l$")
"""What is the identity where a class has no step for it."""
UNTURNED = (r"\mathbf{R}_T", r"\mathbf{J}_l")
"""Of a link whose modes do not turn its tip."""
THEORY = ("Conventions", "Algorithm")
"""The sections that the algorithm needs; the derivation is none of them."""


class Undefined(Exception):
    """A printed step uses a symbol that nothing in the document defines."""


def plain(name: str) -> str:
    """A symbol's LaTeX in one spelling."""
    name = re.sub(r"\\dot\{(\\mathrm\{\w\}|[A-Za-z])_(\w+|\{\w+\})\}", r"\\dot{\1}_\2", name.strip())
    return re.sub(r"_\{(\\?\w)\}", r"_\1", name)


# ------------------------------------------------------------------------------------- what is printed


def equations(formula) -> Iterator[tuple[str, str, str]]:
    """Left side, sign and right side of every equation of a display; lines that go on belong to the one before."""
    found: list[list[str]] = []
    for row in formula:
        cells = [re.sub(r"^\\q?quad", "", cell.strip()).strip() for cell in row]
        for left, right in zip(cells[::2], [*cells[1::2], ""], strict=False):
            if right.startswith(r"\text{("):
                continue  # the number of a line
            sign = next((s for s in ("=", r"\leftarrow") if right.startswith(s)), "")
            body = right.removeprefix(sign).strip().removesuffix(",").removesuffix(r"\,").strip()
            if sign and left:
                found.append([plain(left), sign, body])
            elif found and not sign:
                found[-1][2] += " " + re.sub(r"^\\q?quad", "", body)
    yield from map(tuple, found)


@dataclass
class Part:
    """What stands below a heading."""

    title: str
    steps: dict[str, list] = field(default_factory=dict)
    equations: list[tuple[str, str, str]] = field(default_factory=list)
    inline: list[tuple[str, str, str]] = field(default_factory=list)
    """Those within text."""
    tables: list[DocumentTable] = field(default_factory=list)
    text: str = ""
    said: list[tuple[str, list[tuple[str, str, str]]]] = field(default_factory=list)
    """Paragraphs, each with the equations of the displays that follow."""


def parts(section) -> list[Part]:
    out = [Part("")]
    for item in section.items:
        if isinstance(item, Heading):
            out.append(Part(item.text))
        elif isinstance(item, Paragraph):
            out[-1].text += item.text + "\n"
            out[-1].said.append((item.text, []))
            for inline in re.findall(r"\$([^$]* = [^$]*)\$", item.text):
                out[-1].inline += equations([(inline.split(" = ", 1)[0], "= " + inline.split(" = ", 1)[1])])
        elif isinstance(item, Display):
            out[-1].equations += (found := list(equations(item.formula)))
            if out[-1].said:
                out[-1].said[-1][1].extend(found)
        elif isinstance(item, StepEquation):
            name = plain(item.step.formula[0][0])
            out[-1].steps.setdefault(name, item.step.definition)
        elif isinstance(item, DocumentTable):
            out[-1].tables.append(item)
    return out


def listed(names: str, parts: list[Part]) -> list[Part]:
    """The parts whose titles stand in a list of titles; the title of one may hold commas."""
    out, known = [], sorted(parts, key=lambda part: -len(part.title))
    while names:
        out.append(next(part for part in known if part.title and names.startswith(part.title.lower())))
        names = names[len(out[-1].title) :].removeprefix(", ")
    return out


class Printed:
    """A document by its parts."""

    def __init__(self, document: Document):
        self.classes: dict[int, list[Part]] = {}
        self.sections: dict[str, list[Part]] = {}
        for section in document.sections:
            if section.appendix:
                continue
            own = parts(section)
            if section.link_class:
                for number, names in re.findall(r"As for class (\d+): (.*)\.", own[0].text):
                    own += listed(names, self.classes[int(number)])
                self._steps_of_others(own)
                self.classes[section.link_class] = own
            else:
                self.sections[section.title] = own
        theory = [part for title in THEORY for part in self.sections[title]]
        self.theory = [eq for part in theory for eq in part.equations]
        inline = [(left, right) for part in theory for left, sign, right in part.inline if sign == "="]
        self.inline = dict(reversed(inline))

    def _steps_of_others(self, own: list[Part]) -> None:
        """Steps that a part only names, where an earlier one has them, of an earlier class or of its own."""
        for part in own:
            for title, number, names in re.findall(r"As under “(.*)”(?: of class (\d+))?: (.*)\.\n", part.text):
                other = next(p for p in (self.classes[int(number)] if number else own) if p.title == title)
                for name in map(plain, re.findall(r"\$([^$]*)\$", names)):
                    part.steps.setdefault(name, other.steps[name])

    def table(self, first: str) -> list[tuple[str, ...]]:
        """The rows of the table whose head begins so; none if there is no such table."""
        tables = [t for own in self.sections.values() for part in own for t in part.tables]
        return next((list(t.rows) for t in tables if t.head[0] == first), [])

    @cached_property
    def symbols(self) -> set[str]:
        return {plain(row[0].strip("$")) for row in self.table("symbol")}

    @cached_property
    def parameters(self) -> dict[str, tuple[str, float]]:
        """Symbol and value by name."""
        return {row[0].strip("`"): (plain(row[1].strip("$")), number(row[2])) for row in self.table("parameter")}


def number(text: str) -> float:
    return float(text.strip("$ ").replace(r"\times 10^{", "e").rstrip("}"))


def vector(text: str) -> np.ndarray:
    """A direction of a table: a letter's unit vector, or three numbers."""
    if match := re.search(r"\\mathbf\{e\}_(\w)", text):
        return np.eye(3)["xyz".index(match[1])][:, None]
    inner = text.replace("$", "").partition("[")[2].partition("]")[0]
    return np.array([[number(x)] for x in inner.split(",")])


# ----------------------------------------------------------------------------------------------- steps


SHAPES: dict[str, tuple] = {
    r"\boldsymbol{\phi}_c": (3, "r"),
    r"\boldsymbol{\Psi}_c": (3, "r"),
    r"\mathbf{M}_{D,i}": (6, "r"),
    r"\mathbf{M}_{D\phi,i}": ("r", 6),
    r"\mathbf{M}_{W\phi,i}": ("r", "r"),
    r"\mathbf{M}_{\eta,i}": ("r", "r"),
    r"\mathbf{h}_{\phi,i}": ("r", 1),
    r"\mathbf{h}_V": (6, 1),
    r"\mathbf{M}^*_i": (6, 6),
    r"\mathbf{M}_{D\Psi,i}": (6, 6),
    r"\mathbf{A}_i": (3, "n"),
    r"\mathbf{J}_{T\eta}": (6, "r"),
    r"\mathbf{M}_{VV,i}": (6, 6),
    r"\mathbf{M}_{V\eta,i}": (6, "r"),
    r"\mathbf{M}_{\eta V,i}": ("r", 6),
    r"\mathbf{M}_{\eta\eta,i}": ("r", "r"),
    r"\mathbf{H}_{V,i}": (6, 1),
    r"\mathbf{H}_{\eta,i}": ("r", 1),
    r"\boldsymbol{\beta}_{\omega}": (3, 1),
    r"\mathbf{T}_i": (3, "n"),
}
"""The sizes of what a link without modes has none of."""


class Scope:
    """The symbols of a link, or of one of its sections: what is given, then steps, formulas and parameters."""

    def __init__(self, printed: Printed, own: list[Part], given: Mapping[str, Value], over: list[Part] = ()):
        self.printed, self.parts, self.over = printed, own, list(over)
        self.given = {plain(name): x for name, x in given.items()}
        self.memo: dict[str, Value] = {}
        self.main = [*self.over, *(p for p in own if not p.title.startswith(APART))]
        self.theory: dict[str, str] = {}
        self.updates: dict[str, list[str]] = {}
        for left, sign, right in printed.theory:
            if sign == "=":
                self.theory.setdefault(left, right)
            else:
                self.updates.setdefault(left, []).append(right)
        self.parent: Scope | None = None
        self.busy: list[str] = []

    def __call__(self, name: str) -> Value:
        """The value of a symbol."""
        name = plain(name)
        if name in self.given:
            return self.given[name]
        if name not in self.memo:
            if name in self.busy:
                raise Undefined(f"{name} is defined by itself: {self.busy}")
            self.busy.append(name)
            self.memo[name] = self._found(name)
            self.busy.remove(name)
        return self.memo[name]

    def _found(self, name: str) -> Value:
        if ",i-1}" in name and self.parent is not None:
            return self.parent(name.replace(",i-1}", "}"))
        for part in self.main:
            if name in part.steps:
                return self.step(part.steps[name])
        if name in UNTURNED:
            return np.eye(3)
        if name.endswith(",i}") and (alone := plain(name.removesuffix(",i}") + "}")) in self.theory:
            return self(alone)
        if name in self.theory:
            return self._read(self.theory[name])
        for left, right in self.theory.items():
            if left.startswith("[") and name in (
                pieces := [plain(x.replace("\\ ", "")) for x in left[1:].rstrip("]").split(";")]
            ):
                k = pieces.index(name)
                return sized(self._read(right), (6, 1))[3 * k : 3 * k + 3]
        if (found := self.parameter(name)) is not None:
            return found
        if name in self.printed.inline:
            return self._read(self.printed.inline[name])
        if IDENTITY.match(name):
            return np.eye(3)
        if name in self.printed.symbols or name in SHAPES:
            return self.nothing(name)
        raise Undefined(f"{name}: nothing in the document defines it")

    def _read(self, text: str) -> Value:
        """The value of a right side; of several, the last."""
        return value(text.split(" = ")[-1], self)

    def nothing(self, name: str) -> Value:
        """A zero; that of a quantity of the modes has their number, which may be none."""
        of = {"r": r"\boldsymbol{\eta}_i", "n": r"\dot{\mathbf{q}}_i"}
        count = {letter: len(self.given.get(symbol, ())) for letter, symbol in of.items()}
        return np.zeros([count.get(n, n) for n in SHAPES[name]]) if name in SHAPES else ZERO

    def parameter(self, name: str) -> Value | None:
        """A parameter by its symbol, or a vector by the symbols of its entries."""
        own = self.given["parameters"]
        if name in own:
            return np.full((1, 1), own[name])
        head = re.sub(r"\\(?:mathbf|boldsymbol)\{([^{}]*)\}", r"\1", name)
        match = re.fullmatch(r"(.*)_(\{[^{}]*\}|\w)", head)
        letter, below = match.groups() if match else (head, "")
        below = re.sub(r"(^|,)i$", "", below.strip("{}"))
        for places in ("xyz", "123456"):
            row = []
            for place in places:
                inside = ",".join(filter(None, (below, place)))
                entry = plain(f"{letter}_{{{inside}}}")
                if entry not in own:
                    break
                row.append([own[entry]])
            if row:
                return np.array(row)
        return None

    def knows(self, name: str) -> bool:
        """Whether a name of several letters is one symbol."""
        return name in self.given or self.has(name) or name in self.theory or self.parameter(name) is not None

    def has(self, name: str) -> bool:
        """Whether a step defines a symbol."""
        return any(plain(name) in part.steps for part in self.main)

    def entry(self, name: str, k: int) -> Value:
        """An entry of a column, zero if there is no such column."""
        return self(name)[k : k + 1] if self.has(name) else ZERO

    def step(self, definition, local: Mapping[str, Value] | None = None) -> Value:
        """What a step defines; ``local`` has further symbols."""

        def symbol(name: str) -> Value:
            if local and plain(name) in local:
                return local[plain(name)]
            whole = SYMBOL.fullmatch(plain(name)) or self.knows(plain(name))
            return self(name) if whole else value(name, symbol)

        def known(e: ex.Symbol) -> Value:
            if not e.name.endswith("]") and not any(re.fullmatch(rf"{e.name}(_\w+)?", x) for x in definition.labels):
                raise FieldSymbol(e.name)
            if e.name.endswith("]"):
                base, at = e.name[:-1].split("[")
                of = [
                    (len(x), d)
                    for x, (d, i) in definition.labels.items()
                    if i == (int(at), 0) and x.startswith(base + "_")
                ]
                whole = symbol(min(of)[1]) if of else symbol(definition.labels[base][0])
                return ZERO if isinstance(whole, Zero) else whole[int(at) : int(at) + 1]
            return symbol(e.display)

        if not integrates(definition.right):
            try:
                return computed(definition.right, known)
            except (NotImplementedError, FieldSymbol, TypeError):
                pass
        return self.by_entries(definition, symbol)

    def by_entries(self, definition, symbol) -> Value:
        entries, labels = definition.entries, definition.labels
        free = sorted(set().union(*(sp.sympify(x).free_symbols for x in entries.flat)), key=str)
        numbers = []
        for s in free:
            display, index = labels[s.name]
            whole = symbol(display)
            numbers.append(0.0 if isinstance(whole, Zero) else float(whole[index]))
        at = dict(zip(free, numbers, strict=True))
        return np.array([[evaluated(x, at) for x in row] for row in entries]).reshape(entries.shape)
