"""The document of a robot, read in a state: links and their sections with their symbols."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from document_axes import Axis, axes_of
from document_points import exact_rod
from document_symbols import Part, Printed, Scope, Undefined, plain
from latex_formula import Value

WORLD, WELDED, BALL, NONE = "world", "welded", "ball", "–"
FREE = ("free", "moving")
"""Joints of bases in space."""


@dataclass
class Link:
    """A row of the table of links."""

    number: int
    name: str
    parts: list[Part]
    parent: int
    station: float | None
    segment: tuple[int, int]
    """Which of how many segments."""
    sizes: tuple[int, int, int]
    """The numbers of joint coordinates, joint rates and modes."""
    floats: bool
    axes: list[Axis] = field(default_factory=list)


class Reading:
    """The document of a robot, read."""

    def __init__(self, document: Printed):
        self.document = document
        self.links = list(self._links())
        self.names = [link.name for link in self.links]
        names = {link.name.partition("[")[0]: None for link in self.links}
        self.gravity = np.array([[document.parameters[f"gravity[{k}]"][1]] for k in range(3)])
        self.axes = [axis for link in self.links for axis in link.axes]
        self.parameters = {(name, first): self._parameters(name, first) for name in names for first in (True, False)}

    def _links(self) -> Iterator[Link]:
        before = -1
        for row in self.document.table("link"):
            first, last = (int(row[0].split("–")[end]) for end in (0, -1))
            name, classes = row[1].strip("`"), [int(x) for x in row[2].split(",")]
            for k in range(last - first + 1):
                parts = self._class(name, k, last - first + 1, classes)
                parent, station = (before, None) if k == 0 else (first + k - 2, None)
                if k == 0 and (on := re.search(r"on `([^`]*)`(?:, link (\d+)(?: at \$s =\$ \$([^$]*)\$)?)?", row[6])):
                    parent = -1 if on[1] == WORLD else int(on[2]) - 1
                    station = float(on[3]) if on[3] else None
                floats = k == 0 and row[4] in FREE
                sizes = (*(joint_sizes(row[4]) if k == 0 else (0, 0)), modes(row[5]))
                own = name if last == first else f"{name}[{k}]"
                axes = axes_of(self.document, name, sizes[1]) if k == 0 and not floats else []
                yield Link(first + k - 1, own, parts, parent, station, (k, last - first + 1), sizes, floats, axes)
            before = last - 1

    def _class(self, name: str, k: int, count: int, classes: Sequence[int]) -> list[Part]:
        """The class of a segment: the first paragraph of a class names its members."""
        own = f"`{name}`" if count == 1 else f"`{name}[{k}]`"
        return next(parts for n, parts in self.document.classes.items() if n in classes and own in parts[0].text)

    def _parameters(self, name: str, first: bool) -> dict[str, float]:
        """By symbol: those of a link; a segment that is not the first is welded, and has none of a joint."""
        apart = r"joint\.(drives|limits|elements)|tendons" if first else r"\.joint\.|tendons"
        own: dict[str, float] = {}
        for full, (symbol, x) in self.document.parameters.items():
            if full.startswith(f"{name}.") and symbol != "–" and not re.search(apart, full):
                own.setdefault(symbol, x)
        return own

    def own(self, link: Link) -> dict[str, float]:
        """The parameters of a row of the table of links; a marker has none."""
        return {} if "." in link.name else self.parameters[link.name.partition("[")[0], link.segment[0] == 0]


def joint_sizes(said: str) -> tuple[int, int]:
    """The numbers of coordinates and rates of a joint by the cell of the table of links."""
    if said in (WELDED, *FREE, BALL):
        return {WELDED: (0, 0), BALL: (4, 3)}.get(said, (7, 6))
    entries = re.sub(r"\([^)]*\)", "axis", said).split(", ")
    count = sum(entry != "sliding" and not entry.endswith("m/rad") for entry in entries)
    return count, count


def modes(said: str) -> int:
    return sum(int(x) for x in re.findall(r"\d+", said.partition("`")[0]))


def plain_values(scope: Scope, part: Part) -> Iterator[tuple[str, Value]]:
    """What the text of a section says to be zero or the identity there."""
    for what, symbols in re.findall(r"(Zero|The identity) at this section: (.*)\.", part.text):
        for name in map(plain, re.findall(r"\$([^$]*)\$", symbols)):
            yield name, scope.nothing(name) if what == "Zero" else np.eye(3)


class State:
    """A reading in a state: scopes for all links and their sections."""

    def __init__(self, reading: Reading, q, v, tau, w_ext):
        self.reading, self.links, self.w_ext, self.tau = reading, reading.links, w_ext, tau
        self.remembered: dict[tuple[str, str], float] = {}
        self._split(q, v, tau)
        self.scopes: list[Scope] = []
        self.stations: dict[tuple[int, float], Scope] = {}
        for link in self.links:
            self.scopes.append(self._scope(link))

    def _split(self, q, v, tau) -> None:
        links, axes = self.links, self.reading.axes
        self.q, self.v, self.eta, self.rate = {}, {}, {}, {}
        self.given_base: dict[str, Value] = {}
        at_q = at_v = 0
        for link in links:
            nq, nv, _ = link.sizes
            self.q[link.number], self.v[link.number] = q[at_q : at_q + nq], v[at_v : at_v + nv]
            at_q, at_v = at_q + nq, at_v + nv
        for axis in axes:
            if axis.elastic:
                axis.added, axis.added_rate, at_q, at_v = q[at_q], v[at_v], at_q + 1, at_v + 1
        for link in links:
            r = link.sizes[2]
            self.eta[link.number], self.rate[link.number] = q[at_q : at_q + r], v[at_v : at_v + r]
            at_q, at_v = at_q + r, at_v + r
        self.internal = self._internal(at_v, v)
        at_v += len(self.internal)
        if (at_q, at_v) != (len(q), len(v)):
            raise Undefined(f"the document has {at_q} coordinates and {at_v} rates, the robot {len(q)} and {len(v)}")
        for link in links:
            for k, axis in enumerate(link.axes):
                axis.q, axis.qdot = self.q[link.number][k], self.v[link.number][k]
        for axis, x in zip(axes, tau, strict=False):
            axis.tau = x
        self.tensions = tau[len(axes) :]
        for row in self.reading.document.table(r"in $\mathbf{u}$"):
            if row[2].startswith("`base.twist_rate"):
                first, last = (int(x) for x in row[0].split("–"))
                self.given_base = {row[1].strip("$"): np.reshape(tau[first - 1 : last], (-1, 1))}
            for axis in axes:
                if row[2] == f"`{axis.name}.brake[{axis.number}]`":
                    axis.brake[plain(row[1].strip("$"))] = tau[int(row[0]) - 1]

    def _internal(self, first: int, v) -> list[tuple[Axis | str, str]]:
        """The internal states in their order, by the table of coordinates: whose they are, and of which force; of
        forces between frames their names and symbols."""
        out = []
        for row in self.reading.document.table(r"in $\mathbf{q}$"):
            if row[0] == NONE:
                name, kind, number = re.fullmatch(r"`(.*)\.(\w+)_state\[(\d+)\]`", row[3]).groups()
                if row[4].startswith(f"`{name}`:"):
                    self.remembered[name, plain(row[2].strip("$"))] = v[int(row[1]) - 1]
                    out.append((name, plain(row[2].strip("$"))))
                    continue
                axis = next(x for x in self.reading.axes if (x.name, x.number) == (name, int(number)))
                axis.states[kind] = v[int(row[1]) - 1]
                assert int(row[1]) == first + len(out) + 1, "internal states do not stand behind the rates"
                out.append((axis, kind))
        return out

    def _scope(self, link: Link) -> Scope:
        column = lambda x: np.reshape(x, (-1, 1))  # noqa: E731
        i = link.number
        own, count = self.reading.own(link), link.segment[1]
        given = {
            "parameters": own,
            r"\mathbf{q}_i": column(self.q[i]),
            r"\dot{\mathbf{q}}_i": column(self.v[i]),
            r"\boldsymbol{\eta}_i": column(self.eta[i]),
            r"\dot{\boldsymbol{\eta}}_i": column(self.rate[i]),
            **self._free_fall(),
        }
        if count > 1 and "l_{0,i}" in own:
            given["l_i"] = np.full((1, 1), own["l_{0,i}"] / count)
        if link.floats:
            given |= {r"\boldsymbol{\omega}_i": column(self.v[i][:3]), r"\mathbf{v}_i": column(self.v[i][3:])}
            given |= {r"\mathbf{V}_i": column(self.v[i]), r"\mathbf{r}_{oi}": column(self.q[i][:3])}
            given |= self.given_base
        scope = Scope(self.reading.document, link.parts, given)
        scope.parent = self._carrier(link)
        if any(part.title == "Section of the rod" for part in link.parts):
            scope.given |= {plain(n): x for n, x in exact_rod(scope, link.parts, 1.0, link.segment).items()}
        return scope

    def _free_fall(self) -> dict[str, Value]:
        """That of the robot, or where the algorithm adds inputs to it what it is made of."""
        if not any(left == r"\mathbf{g}" for left, *_ in self.reading.document.theory):
            return {r"\mathbf{g}": self.reading.gravity}
        rows = [row for row in self.reading.document.table(r"in $\mathbf{u}$") if "–" not in row[0]]
        entries = {row[1].strip("$"): np.full((1, 1), self.tau[int(row[0]) - 1]) for row in rows}
        return {r"\mathbf{g}_0": self.reading.gravity} | entries

    def _carrier(self, link: Link) -> Scope:
        if link.parent < 0:
            none = {
                r"\mathbf{R}_{oT}": np.eye(3),
                r"\mathbf{r}_{oT}": np.zeros((3, 1)),
                r"\mathbf{V}_T": np.zeros((6, 1)),
            }
            return Scope(self.reading.document, [], none | {"parameters": {}, r"\mathbf{b}_T": np.zeros((6, 1))})
        return self.scopes[link.parent] if link.station is None else self._station(link.parent, link.station)

    def _station(self, parent: int, s: float) -> Scope:
        """A section of a link before its tip."""
        if (parent, s) not in self.stations:
            link, whole = self.links[parent], self.scopes[parent]
            over = [
                p
                for p in link.parts
                if (m := re.fullmatch(r"Section at \$s = (.*)\$", p.title)) and abs(float(m[1]) - s) < 1e-6
            ]
            scope = Scope(self.reading.document, link.parts, whole.given, over)
            scope.parent = whole.parent
            scope.given |= {name: x for part in over for name, x in plain_values(scope, part)}
            if any(part.title == "Section of the rod" for part in link.parts):
                scope.given = scope.given | {
                    plain(n): x for n, x in exact_rod(scope, link.parts, s, link.segment).items()
                }
            self.stations[parent, s] = scope
        return self.stations[parent, s]
