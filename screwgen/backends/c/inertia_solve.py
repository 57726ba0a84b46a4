"""Solving with the inertia in C by the elimination's own factors: functions per class in loops over columns.

See :mod:`...algorithms.inertia_solve`. Without a factor of the whole mass matrix nobody needs that matrix.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

from ...algorithms import inertia_solve
from ...algorithms.inertia_solve import FORCES, SOLVE, Parted
from ...algorithms.schedule import OUTWARD, SUMMED
from ...algorithms.signals import is_node
from ...algorithms.structure import Passage
from ...ir.program import Program
from ...topology.chain import Chain
from .code import Writer, trimmed
from .fields import StructMember, store_fields
from .links import Function, Links, Places
from .runs import CFunction

RUN = "solving"
FUNCTION = CFunction(SOLVE, "The factors.", frozenset(FORCES.values()), apart=True, zero=inertia_solve.ZERO)
ROWS = {"force": "q", "qddot": "q", "force_theta": "theta", "thetaddot": "theta", "f_eta": "eta", "etaddot": "eta"}
"""The rows of columns that hold a signal: those of a joint, of its rotors, of the modes."""
IN_PLACE = {"joint_w": "q", "rotor_w": "theta", "modes_w": "eta"}
"""What a link keeps between the passes in these rows."""
GAIN = 0.8
"""The part of a dense solver's operations up to which the elimination takes no longer: its loops are shorter."""
LEAST = 17
"""The coordinates from which on a robot is asked for its counts: solves of fewer are written out."""


def is_offered(chain: Chain) -> bool:
    """Whether a robot's inertia can be solved with so; loops have rows of their own to solve for."""
    return inertia_solve.is_offered(chain) and not chain.closing.rows


def columns(chain: Chain) -> int:
    """The columns that are solved for: by coordinates, rates and inputs."""
    return chain.nv + chain.nvz + chain.n_tau


def dense(chain: Chain) -> int:
    """The operations of a dense factor of the inertia and of the solves with it, loops included."""
    nv, rows = chain.nv, len(chain.closing.rows)
    loops = rows * (nv * rows + (4 * nv + 2 * rows) * (2 * nv + chain.n_tau))
    return nv**3 // 3 + 2 * nv * nv * (2 * nv + chain.n_tau + rows) + loops


def count(chain: Chain, parts: Parted) -> int:
    """The operations of the elimination's solves."""
    return columns(chain) * inertia_solve.operations(parts.columns)


def is_chosen(chain: Chain, parts: Parted) -> bool:
    """Whether the elimination costs less."""
    return chain.nv >= LEAST and inertia_solve.operations(parts.fixed) + count(chain, parts) < GAIN * dense(chain)


class SolvingLinks(Links):
    """Functions of links among which are those of the phases that solve with the inertia."""

    @cached_property
    def parted(self) -> Parted:
        """What these find once, and what each column costs."""
        return inertia_solve.part(super().passages(RUN))

    def passages(self, run: str, unread: frozenset[str] = frozenset()) -> list[Passage]:
        return self.parted.fixed if run == RUN else super().passages(run, unread)


@dataclass(frozen=True)
class ColumnLoops:
    """The functions of loops over columns."""

    links: SolvingLinks
    functions: dict[tuple, Function] = field(default_factory=dict)

    @property
    def parts(self) -> Parted:
        return self.links.parted

    def content(self) -> dict:
        """The templates' context: functions, passes along the tree, and what each link keeps of columns besides."""
        made = {(passage.phase, passage.link): self.function(passage) for passage in self.parts.columns}
        phases = []
        for number, phase in enumerate(SOLVE):
            of_link = [made.get((number, i)) for i in range(self.links.chain.n)]
            distinct = list({f.name: f for f in of_link if f}.values())
            if distinct:
                name, outward = f"{RUN}_{_way(phase.direction)}", phase.direction == OUTWARD
                places = [distinct.index(f) if f else len(distinct) for f in of_link]
                phases.append({"name": name, "outward": outward, "classes": distinct, "of_link": places})
        nodes = "2" if self.links.chain.tree.is_chain else str(self.links.chain.tree.size)
        functions = list(self.functions.values())
        return {
            "phases": phases,
            "functions": functions,
            "nodes": nodes,
            "kept": self._kept([f.program for f in functions]),
        }

    def _kept(self, programs: Sequence[Program]) -> list[StructMember]:
        names = {name.removeprefix("w.") for name in self.parts.kept} - IN_PLACE.keys()
        return [field for field in store_fields(programs, self.links.chain) if field.name in names]

    def function(self, passage: Passage) -> Function:
        """The function of one link; equal texts are one function."""
        places = ColumnPlaces(self.links, passage, RUN)
        adding = SUMMED if passage.adds else frozenset()
        writer = Writer(passage.program, places.place, None, places.names(), adding=adding)
        lines = trimmed(writer.lines())
        arguments, values = places.arguments()
        way, signature = _way(SOLVE[passage.phase].direction), ", ".join(arguments)
        key = way, signature, tuple(lines)
        if key not in self.functions:
            link = self.links.chain.identifiers[passage.link]
            name = self.links.unique(f"columns_{way}_{link}")
            title = f"columns {way}, links like {link}: {passage.program.operation_count} operations a column"
            call = f"{name}({', '.join(values)})"
            self.functions[key] = Function(name, title, signature, lines, call, passage.program)
        return self.functions[key]


def content(links: SolvingLinks) -> dict:
    """The templates' context: what is found once, and what columns cost."""
    fixed = [phase for phase in links.phases(RUN) if any(f.signature != "void" for f in phase["classes"])]
    return ColumnLoops(links).content() | {
        "fixed": fixed,
        "distinct": [f.program for phase in fixed for f in phase["classes"]],
        "operations": inertia_solve.operations(links.parted.fixed),
        "solve": count(links.chain, links.parted),
    }


def _way(direction: int) -> str:
    return "outward" if direction == OUTWARD else "inward"


class ColumnPlaces(Places):
    """The C expressions of the signals in a loop over columns l."""

    links: SolvingLinks

    def place(self, name: str, k: int) -> str | None:
        what = name.partition(".")[2]
        if name in self.program.outputs and (name, k) not in self.passage.wanted:
            return None
        array = self._array(name)
        if not array:
            return super().place(name, k)
        return f"kept->{what}[{k}][l]" if array == "kept" else f"{array}[{k}][l]"

    def _array(self, name: str) -> str:
        """The array of columns that a signal is in; none if it is no column."""
        where, _, what = name.partition(".")
        if not what or is_node(where):
            return where if what else ROWS[name]
        return IN_PLACE.get(what, "kept") if name in self.links.parted.kept else ""

    def names(self) -> set[str]:
        return super().names() | {"l", "kept", *ROWS.values()}

    def arguments(self) -> tuple[list[str], list[str]]:
        names = [*self.program.inputs, *self.program.outputs]
        arrays = {array: name for name in names if (array := self._array(name))}
        own = self._structs([name for name in names if not self._array(name)], [])
        tree, begin = self.links.chain.tree, "v" if self.links.chain.curved else "q"
        values = {"q": f"x + {begin}", "theta": "x + ($$_NV - $$_NINNER + t)", "eta": "x + ($$_NV - $$_NMODES + e)"}
        values |= {"kept": "work->kept_columns + i", "base": "nodes[i & 1]", "tip": "nodes[(i + 1) & 1]"}
        if not tree.is_chain:
            values |= {"base": "nodes[BASE[i]]", "tip": "nodes[i + 1]"}
        values |= {name: f"nodes[STATION[i] + {name[2:]}]" for name in arrays if name[:2] == "at"}
        type_ = {"kept": "$_kept_columns *restrict kept"}
        own += [(type_.get(a, f"$_real (*restrict {a})[LANES]"), v) for a, v in values.items() if a in arrays]
        return [a for a, _ in own], [b for _, b in own]
