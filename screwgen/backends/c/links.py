"""The modular layout in C: one function per phase and link class, and how it addresses its arrays."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from ...algorithms import fused
from ...algorithms.dae_functions import block_places, edge_places
from ...algorithms.schedule import OUTWARD, SUMMED, further_children
from ...algorithms.signals import CALL, M_SYS, is_node
from ...algorithms.station_names import plain
from ...algorithms.structure import Applied, Passage, passages, specialised_phases
from ...ir.program import Program
from ...topology.chain import Chain
from .code import Writer, trimmed
from .curved import offset
from .routines import Routines
from .runs import RUNS, CFunction
from .written import once

OPTIONAL = {"wrench": "wrench", "motion": "motion"}
"""Signals that a caller may leave out by a null pointer, with the test for it."""
WITHIN = {"motion": "wrench"}  # output: the output that it requires
WATCHED = frozenset({"motion"})  # outputs that only the validity measures need


@dataclass
class Function:
    """One C function: a phase of a class."""

    name: str
    comment: str
    signature: str
    lines: list[str]
    call: str
    program: Program


@dataclass
class Links:
    """All functions of the chain for a robot."""

    chain: Chain
    baked: Sequence[dict] | None
    joint_form: bool = True
    table: Mapping[str, CFunction] = field(default_factory=lambda: RUNS)
    store: str = "link_store"
    node: str = "node"
    """The types of a link's store and of a node, without the robot's name."""
    functions: dict[tuple, Function] = field(default_factory=dict)
    names: set[str] = field(default_factory=set)
    _phases: dict[str, Applied] = field(default_factory=dict)
    _passages: dict[tuple[str, frozenset[str]], list[Passage]] = field(default_factory=dict)
    _written: dict[tuple, Function] = field(default_factory=dict)
    _printed: dict[str, Sequence[dict]] = field(default_factory=dict)

    @property
    def runs(self) -> dict[str, CFunction]:
        return {n: r for n, r in self.table.items() if self.joint_form or n != "joint_dynamics"}

    def passages(self, run: str, unread: frozenset[str] = frozenset()) -> list[Passage]:
        """The phases of a run, link by link, specialised to the links, without the results in ``unread``."""
        r = self.table[run]
        if run not in self._phases:
            self._phases[run] = specialised_phases(self.chain, r.algorithm, self.baked, r.zero)
        if (run, unread) not in self._passages:
            self._passages[run, unread] = passages(self.chain, self._phases[run], r.results - unread, r.each_tip)
        return self._passages[run, unread]

    @cached_property
    def routines(self) -> Routines:
        """What recurs in the phases."""
        return Routines(passage.program for run in self.runs for passage in self.passages(run))

    @cached_property
    def matrix_entries(self) -> Mapping[tuple[int, int | None], tuple[tuple[str, int], ...]]:
        """The structural nonzeros of M_sys that a link contributes, and an edge, in the order of their programs."""
        out: dict[tuple[int, int | None], tuple[tuple[str, int], ...]] = {}
        for p in sorted(self.passages("assembly"), key=lambda p: p.phase):
            out[p.link, p.edge] = (*out.get((p.link, p.edge), ()), *_nonzeros(p.program))
        return out

    def phases(self, run: str) -> Sequence[dict]:
        """The phases of a run, each with its functions and the function of every link."""
        if run not in self._printed:
            self._printed[run] = self._print(run)
        return self._printed[run]

    def _print(self, run: str) -> list[dict]:
        out: list[dict] = []
        for number, phase in enumerate(self.table[run].algorithm):
            own = (p for p in self.passages(run) if p.phase == number and p.edge is None)
            way = sorted(own, key=lambda p: p.link)
            functions = [self.function(p, run, phase.name) for p in way]
            distinct = list({f.name: f for f in functions}.values())
            out.append(
                {
                    "name": f"{run}_{phase.name}",
                    "outward": phase.direction == OUTWARD,
                    "condition": self.table[run].skipped.get(phase.name),
                    "classes": distinct,
                    "of_link": [distinct.index(f) for f in functions],
                }
            )
        return out

    def parts(self, run: str) -> list[dict]:
        """The C functions of a run: name, comment, phases, and whether they set the acceleration of the base."""
        phases, first = self.phases(run), [p for p in self.passages(run) if p.link == 0]
        out: list[dict] = []
        shares = (
            (self.chain.needs_rates_first and self.table[run].parts_if_sprung)
            or self.table[run].parts
            or ((run, len(phases)),)
        )
        for name, count in shares:
            own, phases = phases[:count], phases[count:]
            accelerating = not out and any("base.acc_0" in p.program.inputs for p in first)
            part = {"name": name, "comment": self.table[run].comment, "phases": own, "accelerating": accelerating}
            out.append(part | {"edges": []})
        out[-1]["edges"] = self.edges(run)
        return out

    def edges(self, run: str) -> list[dict]:
        """The functions of a run that compute the blocks of a carried link besides the last one of its node."""
        algorithm, found = self.table[run].algorithm, [p for p in self.passages(run) if p.edge is not None]
        edges = list(dict.fromkeys(p.edge for p in found if p.edge is not None))
        return [
            {
                "child": self.chain.identifiers[edge],
                "steps": [
                    {"link": p.link, "call": self.function(p, run, algorithm[p.phase].name).call}
                    for p in found
                    if p.edge == edge
                ],
            }
            for edge in edges
        ]

    def function(self, passage: Passage, run: str, phase: str) -> Function:
        """The C function of a phase at one link; equal texts are one function, called after their first link."""
        entries = self.matrix_entries[passage.link, passage.edge] if run == "assembly" else ()
        known = (run, id(passage.program), passage.wanted, entries, passage.adds, passage.edge is None)
        if known not in self._written:
            self._written[known] = self._function(passage, run, phase, entries)
        return self._written[known]

    def _function(self, passage: Passage, run: str, phase: str, entries: tuple) -> Function:
        program, places = passage.program, self.places(passage, run, entries)
        fail = lambda test, _: f"if ({test}) {{ return $$_SINGULAR; }}"  # noqa: E731
        adding, calling = SUMMED if passage.adds else frozenset(), self.routines.calling(program)
        writer = Writer(calling, places.place, fail, places.names(), self.table[run].apart, OPTIONAL, WITHIN, adding)
        lines = trimmed(writer.lines())
        arguments, values = places.arguments()
        signature = ", ".join(arguments or ["void"])
        key = (phase, signature, passage.edge is None, tuple(lines))
        if key not in self.functions:
            link = self.chain.identifiers[passage.link]
            name = self.unique(f"{phase}_{link}")
            title = f"{phase.replace('_', ' ')}, links like {link}: {program.operation_count} operations"
            self.functions[key] = Function(name, title, signature, lines, f"{name}({', '.join(values)})", program)
        return self.functions[key]

    def places(self, passage: Passage, run: str, entries: tuple) -> Places:
        """Where a phase's function has its signals."""
        return Places(self, passage, run, entries)

    def unique(self, name: str) -> str:
        """The name, or a numbered one that no function has yet."""
        number, out = 1, name
        while out in self.names:
            number += 1
            out = f"{name}_{number}"
        self.names.add(out)
        return out


def links_of(chain: Chain, baked: bool, joint_form: bool) -> Links:
    """The functions of a robot, which projects share by :func:`.written.once`.

    ``baked``: with constants as numbers. With and without those of the joint form the phases that these functions are
    made of are the same.
    """
    if joint_form:
        return Links(chain, once(fused.baked, chain) if baked else None)
    own: dict[str, Any] = {"functions": {}, "names": set(), "_written": {}, "_printed": {}}
    return replace(once(links_of, chain, baked, True), joint_form=False, **own)


@dataclass
class Places:
    """The C expressions of the signals in a phase's function, and its parameters."""

    links: Links
    passage: Passage
    run: str
    entries: tuple[tuple[str, int], ...] = ()
    matrix: dict[tuple[str, int], int] = field(init=False)

    def __post_init__(self) -> None:
        self.matrix = {place: k for k, place in enumerate(self.entries)}

    @property
    def program(self) -> Program:
        return self.passage.program

    def place(self, name: str, k: int) -> str | None:
        """The C expression of entry k of a signal; None if it is not stored."""
        if name in self.program.outputs and (name, k) not in self.passage.wanted:
            return None
        where, _, what = name.partition(".")
        if where == "c" and what:
            return f"c->{what}"
        if where == "w" or is_node(where):
            return f"{'link' if where == 'w' else where}->{what}[{k}]"
        if plain(name) in M_SYS:
            return f"M[place[{self.matrix[name, k]}]]" if (name, k) in self.matrix else None
        return f"{name}[{k}]"

    @property
    def _restrict(self) -> str:
        """The qualifier of a parameter whose memory is not accessed otherwise."""
        return "restrict " if self.links.table[self.run].apart else ""

    def names(self) -> set[str]:
        """The names of the function's parameters and of the file's constants."""
        signals = {n for n in (*self.program.inputs, *self.program.outputs) if "." not in n}
        offsets = {f"{part}_OFFSET" for part in ("M", "Q", "V", "THETA", "BELOW", "TENSION", "BRAKE", "Z")}
        tables = offsets | {"M_PLACE", "BASE", "STATION"}
        nodes = self.links.chain.tree.places(self.passage.link)
        return signals | tables | {"c", "link", "place", "M", *nodes}

    def arguments(self) -> tuple[list[str], list[str]]:
        """Parameters of the function and the arguments of a call."""
        alone, inputs, outputs = self._restrict, self.program.inputs, self.program.outputs
        reads, writes = [n for n, size in inputs.items() if size], [n for n, v in outputs.items() if v]
        out = self._structs(reads, writes)
        out += [(f"const $_real {n}[{alone}{inputs[n]}]", self._address(n, n)) for n in reads if "." not in n]
        for name in writes:
            if "." not in name and plain(name) not in M_SYS:
                address = self._address(name if name.startswith("new_") else f"new_{name}", name)
                out.append((f"$_real {name}[{alone}{len(outputs[name])}]", address))
        if any(plain(n) in M_SYS for n in writes):
            block = "i" if self.passage.edge is None else "m"
            out += [("const int *place", f"M_PLACE + M_OFFSET[{block}]"), ("$_real *M", "call->M")]
        return [a for a, _ in out], [b for _, b in out]

    def _structs(self, reads: list[str], writes: list[str]) -> list[tuple[str, str]]:
        out: list[tuple[str, str]] = []
        if any(n.startswith("c.") for n in reads):
            out.append((f"const $_link_constants *{self._restrict}c", "&c->links[i]"))
        stations = [place for place in self.links.chain.tree.places(self.passage.link) if place not in ("base", "tip")]
        for where, type_, value in (
            ("w", self.links.store, "&chain->links[i]"),
            ("base", self.links.node, f"&chain->nodes[{'i' if self.links.chain.tree.is_chain else 'BASE[i]'}]"),
            ("tip", self.links.node, "&chain->nodes[i + 1]"),
            *((place, self.links.node, f"&chain->nodes[STATION[i] + {k}]") for k, place in enumerate(stations)),
        ):
            if any(n.startswith(f"{where}.") for n in reads + writes):
                const = "" if any(n.startswith(f"{where}.") for n in writes) else "const "
                out.append((f"{const}$_{type_} *{self._restrict}{'link' if where == 'w' else where}", value))
        return out

    def _address(self, member: str, name: str) -> str:
        """The address of a link's part of a signal, which is a member of the call; what is written begins with new_."""
        if CALL[name].at:
            return f"call->{CALL[name].at}"
        match CALL[name].shape:
            case (("q" | "m" | "a") as size,):
                place = f"call->{member} + {offset(self.links.chain, self.run, name, size)}"
            case ("r",):
                place = f"call->{member} + e"
            case ("t",):
                place = f"call->{member} + t"
            case ("c",):
                place = f"call->{member} + TENSION_OFFSET[i]"
            case ("k",):
                place = f"call->{member} + BRAKE_OFFSET[i]"
            case ("z",):
                place = f"call->{member} + Z_OFFSET[i]"
            case ("b",):
                place = f"call->{member} + BELOW_OFFSET[i]"
            case shape:
                place = f"call->{member}" if name == "gravity" else f"call->{member} + {math.prod(shape)} * i"
        return f"call->{member} ? {place} : 0" if member != name in OPTIONAL else place


def _nonzeros(program: Program) -> Iterator[tuple[str, int]]:
    """The entries of M_sys that a program computes."""
    for name, values in program.outputs.items():
        if plain(name) in M_SYS:
            yield from ((name, k) for k, v in enumerate(values) if not (isinstance(v, float) and v == 0.0))


def sparsity(links: Links) -> tuple[list[int], list[int], list[int], list[int]]:
    """Row indices and column starts of M_sys by columns, and the places of each link's entries with their offsets."""
    entries: list[tuple[int, int]] = []
    offsets = []
    chain = links.chain
    parts: list[tuple[int, int | None]] = [(i, None) for i in range(chain.n)]
    parts += [(chain.tree.parents[child], child) for child in further_children(chain)]
    for i, edge in parts:
        offsets.append(len(entries))
        blocks = block_places(chain, i) if edge is None else edge_places(chain, edge)
        for name, k in links.matrix_entries.get((i, edge), ()):
            row, col, _, cols = blocks[name]
            entries.append((col + k % cols, row + k // cols))
    order = sorted(entries)
    place = {entry: k for k, entry in enumerate(order)}
    size = 12 * links.chain.n + links.chain.n_modes
    starts = [bisect_left(order, (j,)) for j in range(size + 1)]
    return [row for _, row in order], starts, [place[e] for e in entries], offsets
