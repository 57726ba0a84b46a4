"""The slopes of the inverse dynamics in C by recursion: a function per class and phase, and loops over pairs.

The text grows with the classes of links, not with their number; see :mod:`...algorithms.pair_slopes`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from ...algorithms import pair_slopes
from ...algorithms.acting_programs import tips_acted_on
from ...algorithms.pair_slopes import PARTS
from ...algorithms.station_names import at_station, plain
from ...algorithms.structure import Passage
from ...topology.chain import Chain
from ...topology.tree import TIP
from . import inertia_solve, inputs, pair_ranges
from .acting import rate_of
from .columns_loop import over_columns, starts
from .fields import node_fields, store_fields
from .links import Places
from .runs import CFunction

CHANGES = {
    "U": ("U_q", "U_eta"),
    "by_q": ("by_q", "by_eta"),
    "by_v": ("by_qdot", "by_etadot"),
    "rows": ("rows_q", "rows_eta"),
    "F_q": ("F_q", "F_eta"),
    "F_v": ("F_qdot", "F_etadot"),
    "F_a": ("F_a_q", "F_a_eta"),
    "r_c": ("r_q", "r_eta"),
    "v_c": ("v_q", "v_eta"),
}
"""The arrays with a column for every rate, and the signals that fill those of a joint's and of the modes' rates."""
COLUMN = {name: (of, part) for of, names in CHANGES.items() for name, part in zip(names, PARTS, strict=True)}
MOVED: dict[str, str | tuple[int, str]] = {"U": (3, "a"), "by_q": (6, "c_q"), "by_v": (6, "c_v")}
"""From which entry on a change is taken at the origin of the link that answers, and where that stands."""
AT_LINK: dict[str, str | tuple[int, str]] = {name: f"moved->{name}[{{}}][j]" for name in ("a", "c_q", "c_v")}
"""What a change is there."""
POINTS = ("origin", "velocity")
"""The arrays with three entries for every link."""
BLOCKS = {"M": "work->M", "f_q": "out->vdot_q", "f_v": "out->vdot_v"}
"""The matrices that hold the blocks of single links."""
OF_JOINT = {"q": "out->wrench_q[i][{}]", "v": "out->wrench_v[i][{}]", "vdot": "work->by_vdot[6 * i + {}]"}
"""The rows of a joint's wrench in its derivatives."""
GEARS = {
    "gear_M": ("M", "gear", "axis"),
    "gear_q": ("f_q", "gear", "axis"),
    "gear_qdot": ("f_v", "gear", "axis"),
    "gear_back": ("f_v", "axis", "gear"),
    "gear_own": ("f_v", "gear", "gear"),
}
"""What an elastic gear of a transmission adds, by the names of its slopes: matrix, row and column."""
FIRST = {"q": "joint", "eta": "mode"}
"""The parameters that say where the rates of a joint and of the modes begin."""


@dataclass(frozen=True)
class Matter:
    """What is differentiated: the run, what it finds, and the types in which it works."""

    run: str
    results: frozenset[str]
    work: str
    out: str

    @property
    def table(self) -> dict[str, CFunction]:
        said = "The slopes of every link."
        return {self.run: CFunction(pair_slopes.SLOPES, said, self.results, apart=True, each_tip=True)}

    def of(self, chain: Chain) -> Matter:
        """The same of a robot: at all its stations, and where anything acts on tips these too."""
        carried = [f"change.{signal}" for array in CARRIED for signal in CHANGES[array]]
        most = max(chain.tree.stations, default=0)
        further = {at_station(name, k) for name in carried for k in range(most)} | (
            TIPS if tips_acted_on(chain) else frozenset()
        )
        return replace(self, results=self.results | further)


def _changes(*arrays: str) -> list[str]:
    return [f"change.{signal}" for array in arrays for signal in CHANGES[array]]


POINTS_FOUND = [f"change.{name}" for name in POINTS]
CARRIED = ("U", "by_q", "by_v", "r_c", "v_c")
"""The arrays that have columns for what stations carry, behind those of the rates."""
TIPS = frozenset(("tip.R", "tip.r", "tip.rdot"))
FORCES = Matter(
    "slopes",
    frozenset(
        _changes(*(name for name in CHANGES if name != "F_a"))
        + POINTS_FOUND
        + [f"block.{matrix}_{a}_{b}" for matrix in BLOCKS for a in PARTS for b in PARTS]
        + [f"block.{name}" for name in GEARS]
    ),
    "linearise_work",
    "derivatives",
)
WRENCHES = Matter(
    "wrenches",
    frozenset(
        _changes(*(name for name in CHANGES if name != "rows"))
        + POINTS_FOUND
        + [f"of_joint.{part}_{kind}" for part in PARTS for kind in OF_JOINT]
        + [f"of_joint.{name}" for name in ("rows", "R", "point", "wrench")]
    ),
    "wrench_work",
    "wrench_derivatives",
)


class SlopePlaces(Places):
    """The C expressions of the signals of these phases: what they find has a column for every rate of the robot."""

    links: SlopeLinks

    def place(self, name: str, k: int) -> str | None:
        where, _, what = name.partition(".")
        if where == "change" and what in POINTS:
            return f"change->{what}[i][{k}]"
        if where == "change":
            array, part = COLUMN[plain(what)]
            return self._entry(
                f"change->{array}", k, part, int(what.rpartition("_at")[2]) if plain(what) != what else TIP
            )
        if where == "block" and what in GEARS:
            return self._of_gear(what, k)
        if where == "block":
            matrix, rows, part = _block(what)
            row, column = divmod(k, self._count(part))
            return f"{BLOCKS[matrix]}[{FIRST[rows]} + {row}][{FIRST[part]} + {column}]"
        if where == "of_joint":
            return self._of_joint(what, k)
        return super().place(name, k)

    def _of_joint(self, what: str, k: int) -> str:
        part, _, kind = what.partition("_")
        if kind:
            row, column = divmod(k, self._count(part))
            return f"{OF_JOINT[kind].format(row)}[{FIRST[part]} + {column}]"
        if what == "wrench":
            return f"out->wrench[i][{k}]"
        return f"work->joint[i].{what}" + (f"[{k // 9}][{k % 9}]" if what == "rows" else f"[{k}]")

    def _entry(self, array: str, k: int, part: str, station: int = TIP) -> str:
        count = self._count(part)
        row, column = divmod(k, count)
        if station != TIP:
            return f"{array}[{row}][carried + {station * count + column}]"
        return f"{array}[{row}][{FIRST[part]} + {column}]"

    def _of_gear(self, what: str, k: int) -> str | None:
        """What an elastic gear of a transmission adds to its row, or to its column in the row of the axis."""
        key = self.links.chain.keys[self.passage.link]
        if key.added_axes[k] not in key.elastic_travels:
            return None
        matrix, row, column = GEARS[what]
        places = {"gear": f"gear + {k}", "axis": f"joint + {key.added_axes[k]}"}
        return f"{BLOCKS[matrix]}[{places[row]}][{places[column]}]"

    def _count(self, part: str) -> int:
        """How many rates the link's joint or its modes have."""
        key = self.links.chain.keys[self.passage.link]
        return key.joints if part == "q" else key.modes

    def names(self) -> set[str]:
        return super().names() | {"change", "i", "joint", "mode", "carried", "gear", "work", "out"}

    def arguments(self) -> tuple[list[str], list[str]]:
        arguments, values = super().arguments()
        text = " ".join(p for n, v in self.program.outputs.items() for k in range(len(v)) if (p := self.place(n, k)))
        matter, begin = self.links.matter, "v" if self.links.chain.curved else "q"
        offered = {
            "change": ("$_changes *restrict change", "&work->change"),
            "work": (f"$_{matter.work} *work", "work"),
            "out": (f"$_{matter.out} *out", "out"),
            "i": ("int i", "i"),
            "joint": ("int joint", begin),
            "mode": ("int mode", "$$_NV - $$_NMODES + e"),
            "carried": ("int carried", "CARRIED[i]"),
            "gear": ("int gear", "$$_NV - $$_NINNER + t"),
        }
        used = [pair for name, pair in offered.items() if re.search(rf"\b{name}\b(?!\[i)", text)]
        return arguments + [a for a, _ in used], values + [b for _, b in used]


def _block(name: str) -> tuple[str, str, str]:
    """Matrix, rows and columns of a block from its name, as ``f_q_eta_q``."""
    matrix = next(matrix for matrix in BLOCKS if name.startswith(f"{matrix}_"))
    rows, columns = name[len(matrix) + 1 :].split("_")
    return matrix, rows, columns


@dataclass
class SlopeLinks(inertia_solve.SolvingLinks):
    """The functions of these phases, and of those that solve with the inertia."""

    matter: Matter = FORCES

    def places(self, passage: Passage, run: str, entries: tuple) -> Places:
        return (Places if run == inertia_solve.RUN else SlopePlaces)(self, passage, run, entries)


def is_offered(chain: Chain) -> bool:
    """Whether the slopes of a robot can be found so."""
    return not (chain.closing.overconstrained or chain.braked)


PAIRS = 128
"""Up to this many pairs of coordinates of which one carries the other's link ``auto`` writes straight lines: at about
11 bytes an operation they stay in a second-level cache of 256 KiB."""


def is_chosen(chain: Chain, layout: str) -> bool:
    """Whether they are found so in the ``layout`` that is asked for."""
    if layout == "fused" or not is_offered(chain):
        return False
    return layout == "modular" or pair_ranges.count_pairs(chain) > PAIRS


def content(chain: Chain, baked: Sequence[dict] | None) -> dict:
    """The templates' context for the slopes of the generalised forces."""
    own: dict = {name: f"{name}[{{}}]" for name in ("rows", "F_q", "F_v", "r", "v")}
    solving = solves_by_elimination(chain, baked)
    made, moved, pair = _phases(chain, baked, FORCES, solving), pair_slopes.moved(), pair_slopes.entries(not solving)
    carried = sum(map(pair_ranges.width, pair_ranges.carrying(chain)))
    made["operations"] += carried * moved.operation_count + pair_ranges.count_pairs(chain) * pair.operation_count
    return made | {
        "moved": over_columns(moved, own | AT_LINK),
        "entries": over_columns(pair, own | MOVED, column=rate_of(chain)),
    }


def wrenches(chain: Chain, baked: Sequence[dict] | None) -> dict:
    """The same for those of the joint wrenches."""
    own: dict = {name: f"{name}[{{}}]" for name in ("rows", "R", "p", "r", "v")}
    rates = "$$_NVZ" if chain.n_internal else "$$_NV"
    own_columns: dict = {
        name: f"{name}[{{}} * {size} + j]"
        for name, size in (("with_q", "$$_NV"), ("with_v", rates), ("by_vdot", "$$_NV"))
    }
    made, moved = _phases(chain, baked, WRENCHES), pair_slopes.moved()
    row, columns, behind = pair_slopes.wrench_rows(), pair_slopes.wrench_columns(), pair_ranges.behind(chain)
    carried, carrying = (sum(map(pair_ranges.width, ranges)) for ranges in (pair_ranges.carrying(chain), behind))
    made["operations"] += carried * (moved.operation_count + 6 * row.operation_count)
    made["operations"] += carrying * columns.operation_count
    return made | {
        "behind": [pair for pairs in behind for pair in pairs],
        "behind_at": starts(behind),
        "moved": over_columns(moved, own | AT_LINK),
        "rows": over_columns(row, own | MOVED, column=rate_of(chain)),
        "columns": over_columns(columns, own | own_columns | {"r_F": "work->r_F[{}][j]"}),
    }


def _links(chain: Chain, baked: Sequence[dict] | None, matter: Matter, solving: bool) -> SlopeLinks:
    """The functions; ``solving``: those that solve with the inertia too, and none of its blocks."""
    matter = matter.of(chain)
    if solving:
        kept = {name for name in matter.results if not name.startswith(("block.M_", "block.gear_M"))}
        matter = replace(matter, results=frozenset(kept))
    table = matter.table | ({inertia_solve.RUN: inertia_solve.FUNCTION} if solving else {})
    store, node = f"{matter.run}_link", f"{matter.run}_node"
    return SlopeLinks(chain, baked, table=table, store=store, node=node, matter=matter)


def solves_by_elimination(chain: Chain, baked: Sequence[dict] | None) -> bool:
    """Whether the elimination's factors solve with the inertia, no dense ones."""
    if not inertia_solve.is_offered(chain):
        return False
    return inertia_solve.is_chosen(chain, _links(chain, baked, FORCES, True).parted)


def _phases(chain: Chain, baked: Sequence[dict] | None, matter: Matter, solving: bool = False) -> dict:
    """The phases of links, and the ranges of rates over which loops over pairs run."""
    links = _links(chain, baked, matter, solving)
    matter = links.matter
    phases = links.phases(matter.run)
    solution = inertia_solve.content(links) if solving else None
    programs = [c.program for phase in phases for c in phase["classes"]]
    in_chain = programs + (solution["distinct"] if solution else [])
    columns = pair_ranges.carried(chain)
    carrying, own = pair_ranges.carrying(chain), [pair_ranges.own(chain, i) for i in range(chain.n)]
    return {
        "phases": phases,
        "programs": list(links.functions.values()),
        "routines": links.routines.functions,
        "node": node_fields(in_chain),
        "store": store_fields(in_chain, chain),
        "solving": solution,
        "carrying": [pair for pairs in carrying for pair in pairs],
        "carrying_at": starts(carrying),
        "columns": f"$$_NV + {columns[-1] - chain.nv}" if columns[-1] > chain.nv else "$$_NV",
        "carried": columns[:-1],
        "stations": bool(any(chain.tree.stations)),
        "own": [pair for pairs in own for pair in pairs],
        "own_at": starts(own),
        "gathers": bool(inputs.scratch(chain)),
        "sparse": bool(not chain.tree.is_chain or chain.n_added),
        "operations": sum(p.program.operation_count for p in links.passages(matter.run))
        + (solution["operations"] if solution else 0),
        "distinct": in_chain,
    }
