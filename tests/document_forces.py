"""What acts on tips from outside and between frames, by the formulas and tables of a document."""

from __future__ import annotations

import re

import numpy as np
from document_symbols import Printed, number, plain, sized, vector
from latex_formula import Value, value

PART = "What acts on the tips"
W = r"\boldsymbol{\mathcal{W}}_{ext,"
ENTRY = re.compile(r"(?P<letter>.*)_\{AB,(?P<place>[xyz]+)\}")
BOLD = {
    "d": r"\mathbf{d}_{AB}",
    "R": r"\mathbf{R}_{AB}",
    "v": r"\mathbf{v}_{AB}",
    r"\omega": r"\boldsymbol{\omega}_{AB}",
}
WRENCH = {r"\tau": r"\boldsymbol{\tau}_{AB}", "F": r"\mathbf{F}_{AB}"}


class Acting:
    """The wrenches on all tips in a state of a document: those given, turned where they are stated in world axes, and
    those of forces between frames."""

    def __init__(self, document: Printed, state):
        self.document, self.scopes, self.energy, self.tau = document, state.scopes, 0.0, state.tau
        self.remembered, self.rates, w_ext = state.remembered, {}, state.w_ext
        self.wrenches = [row[:, None] for row in w_ext]
        part = next((p for p in document.sections["Algorithm"] if p.title == PART), None)
        self.equations = part.equations if part else []
        self.laws = {}
        for text, lines in part.said if part else []:
            if named := re.fullmatch(r"\S.*, of (`.*`):", text):
                self.laws |= dict.fromkeys(re.findall("`([^`]*)`", named[1]), lines)
        for row in document.table("push"):
            if row[3] == "the world":
                self._turn(int(re.search(r"ext,(\d+)", row[1])[1]) - 1)
        for row in document.table("acting"):
            self._act(row)

    def _formula(self, left: str) -> str:
        """The right side of the one line that is not of a law."""
        return next(right for x, _, right in self.equations if x == plain(left))

    def _turn(self, i: int) -> None:
        known = {W + "i}": self.wrenches[i], r"\mathbf{R}_{oT}": self.scopes[i](r"\mathbf{R}_{oT}")}
        self.wrenches[i] = value(self._formula(W + "i}"), lambda name: known[name])

    def _act(self, row: tuple[str, ...]) -> None:
        name, *cells, _, numbers = row
        name, known = name.strip("`"), {}
        ends = [self._end(cell, letter, known) for cell, letter in zip(cells, "AB", strict=True)]
        cells = re.split(r"(?:^|, )\$(\S+) =\$ ", numbers)[1:]
        stated = {plain(symbol): _number(text) for symbol, text in zip(cells[::2], cells[1::2], strict=True)}
        listed = [one for own, one in self.document.parameters.items() if re.match(rf"{name}\.(?!world)", own)]
        assert [x for _, x in listed] == [y for x in stated.values() for y in x.ravel()], f"{name}: {numbers}, {listed}"
        known |= stated | {symbol: np.full((1, 1), x) for symbol, x in listed} | self._inputs(name)
        states = {plain(symbol): np.full((1, 1), x) for (own, symbol), x in self.remembered.items() if own == name}
        known |= states
        for left in (r"\mathbf{R}_{AB}", r"\mathbf{d}_{AB}", r"\boldsymbol{\omega}_{AB}", r"\mathbf{v}_{AB}"):
            known[left] = self._read(self._formula(left), known)
        known |= {x: np.zeros((3, 1)) for x in WRENCH.values()} | {"U": np.zeros((1, 1))}
        for left, _, right in self.laws[name]:
            self._assign(left, self._read(right, known), known)
        self.energy += known["U"].item()
        for symbol in states:
            letter, line, index = symbol.partition("_")
            self.rates[name, symbol] = known[rf"\dot{{{letter}}}{line}{index}"].item()
        for letter, i in zip("AB", ends, strict=True):
            if i is not None:
                known[W + letter + "}"] = self.wrenches[i]
                self.wrenches[i] = self._read(self._formula(W + letter + "}"), known)

    def _inputs(self, force: str) -> dict[str, Value]:
        """The inputs of a force by their symbols, from the table of inputs."""
        rows = (row for row in self.document.table(r"in $\mathbf{u}$") if row[3].startswith(f"`{force}`:"))
        return {plain(row[1].strip("$")): np.full((1, 1), self.tau[int(row[0]) - 1]) for row in rows}

    def _end(self, cell: str, letter: str, known: dict) -> int | None:
        """The number of a tip, None for a point of the world; how it lies and moves."""
        link = re.search(r", link (\d+)$", cell)
        i = int(link[1]) - 1 if link else None
        scope = (lambda name: sized(self.scopes[i](name), SIZES[name])) if link else at_rest(vector(cell)).__getitem__
        twist = scope(r"\mathbf{V}_T")
        known[rf"\mathbf{{R}}_{{o{letter}}}"] = scope(r"\mathbf{R}_{oT}")
        known[rf"\mathbf{{r}}_{{o{letter}}}"] = scope(r"\mathbf{r}_{oT}")
        known[rf"\boldsymbol{{\omega}}_{{T,{letter}}}"], known[rf"\mathbf{{v}}_{{T,{letter}}}"] = twist[:3], twist[3:]
        return i

    def _read(self, text: str, known: dict[str, Value]) -> Value:
        def symbol(name: str) -> Value:
            name = plain(name)
            if name in known:
                return known[name]
            if (match := ENTRY.fullmatch(name)) and match["letter"] in BOLD:
                place = tuple("xyz".index(x) for x in match["place"])
                return np.full((1, 1), known[BOLD[match["letter"]]][place if len(place) > 1 else (*place, 0)])
            raise AssertionError(f"{name}: nothing in the document defines it")

        return value(text, symbol)

    @staticmethod
    def _assign(left: str, found: Value, known: dict[str, Value]) -> None:
        if match := ENTRY.fullmatch(left):
            known[WRENCH[match["letter"]]]["xyz".index(match["place"])] = found.item()
        elif left.startswith("["):
            for name, part in zip(left.strip("[]").split(";"), np.split(found, 2), strict=True):
                known[plain(name.removeprefix("\\ "))] = part
        else:
            known[left] = found


SIZES = {r"\mathbf{R}_{oT}": (3, 3), r"\mathbf{r}_{oT}": (3, 1), r"\mathbf{V}_T": (6, 1)}


def _number(text: str) -> np.ndarray:
    """A number of a table, or several in brackets, as a column."""
    return vector(text) if "[" in text or r"\mathbf" in text else np.full((1, 1), number(text.split("$")[1]))


def at_rest(place: np.ndarray) -> dict[str, np.ndarray]:
    """The tip frame of a point of the world."""
    return {r"\mathbf{R}_{oT}": np.eye(3), r"\mathbf{r}_{oT}": place, r"\mathbf{V}_T": np.zeros((6, 1))}
