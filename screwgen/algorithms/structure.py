"""Specialisation of an algorithm to the links of a chain: known inputs folded in, unused outputs removed.

Some inputs of a phase are known numbers: the base is at rest, the last tip carries no load, and a joint transmits no
torque about a free axis.  Every phase of every link is specialised to them.  Links with equal known inputs share one
program.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeGuard

from ..ir.program import Node, Program, Value
from ..ir.replay import bind
from ..topology.chain import Chain
from .functions import nodes
from .schedule import SUMMED, Algorithm, execute, trace, visits
from .signals import PER_CHILD, is_node
from .station_names import edge_name


class Unknown:
    """An entry whose value is not known before the call."""

    def __neg__(self) -> Unknown:
        return self

    def __add__(self, _: object) -> Unknown:
        return self

    __radd__ = __add__


UNKNOWN = Unknown()
Entry = float | Unknown
Known = tuple[tuple[str, tuple[float | None, ...]], ...]
"""The inputs of a program of which some entries are numbers; None stands for the others."""


@dataclass(frozen=True)
class Passage:
    """One phase of one link: its program, reduced to the outputs that are used, and the list of these entries."""

    phase: int
    link: int
    program: Program
    wanted: frozenset[tuple[str, int]]
    adds: bool = False
    """Whether what it hands to the node that carries the link is added to what is there."""
    edge: int | None = None
    """The carried link whose blocks it computes, see :func:`.schedule.visits`."""


Applied = Sequence[tuple[int, int, int | None, Program]]
"""Phase, link, edge and program in the order of execution."""


def specialised_phases(
    chain: Chain,
    algorithm: Algorithm,
    constants: Sequence[Mapping[str, list]] | None,
    zero: frozenset[str] = frozenset(),
) -> Applied:
    """Every phase of every link, specialised to the known entries of its inputs.

    ``constants`` are the links' numbers (``c.*``) where they are baked in; ``zero`` the signals that are zero.
    """
    specialised: dict[tuple, Program] = {}
    run: list[Program] = []

    def apply(i: int, number: int, program: Program, given: Mapping[str, list]) -> Mapping[str, list]:
        known = _known(given)
        key = (id(program), known)
        if key not in specialised:
            specialised[key] = bind(program, dict(known)) if known else program
        run.append(specialised[key])
        return {name: [_entry(v) for v in values] for name, values in specialised[key].outputs.items()}

    places = nodes(chain, [0.0 if "gravity" in zero else UNKNOWN] * 3)
    execute(chain, algorithm, _inputs(chain, algorithm, constants, zero), places, apply)
    return [(*visit, program) for visit, program in zip(visits(chain, algorithm), run, strict=True)]


def _inputs(
    chain: Chain, algorithm: Algorithm, constants: Sequence[Mapping[str, list]] | None, zero: frozenset[str]
) -> list[dict[str, list]]:
    """The signals of every link that no phase computes."""
    out = []
    for i, key in enumerate(chain.keys):
        sizes = {n: size for p in trace(key, algorithm) for n, size in p.inputs.items()}
        own = {n: [UNKNOWN] * size for n, size in sizes.items()}
        own |= {n: v for n, v in (constants[i] if constants else {}).items() if n.startswith("c.")}
        out.append(own | {n: [0.0] * len(own[n]) for n in zero & own.keys()})
    return out


def _known(given: Mapping[str, list]) -> Known:
    partial = {n: tuple(None if isinstance(v, Unknown) else float(v) for v in values) for n, values in given.items()}
    return tuple((n, values) for n, values in sorted(partial.items()) if any(v is not None for v in values))


def _entry(value: Value) -> Entry:
    return float(value) if _structural(value) else UNKNOWN


def _structural(value: Value) -> TypeGuard[float]:
    """Whether an entry is passed on as a number: zeros and ones recur from link to link, sums of masses do not."""
    return not isinstance(value, Node) and abs(value) in (0.0, 1.0)


def passages(chain: Chain, run: Applied, results: Iterable[str], each_tip: bool = False) -> list[Passage]:
    """The phases, reduced to the outputs that a later phase or the caller uses.

    ``results`` are the signals that a caller reads: of every link, or, for a node (``tip.*``), of the last tip, or of
    ``each_tip``.
    """
    results = frozenset(results)
    count = max(chain.tree.stations, default=0)
    named_at = {edge_name(name, station) for name in results & PER_CHILD for station in range(count)}
    read: set[tuple[str, str, int, int]] = set()
    out, cache = [], {}
    siblings = chain.tree.children
    for number, i, edge, program in reversed(run):
        together, adds = len(siblings[chain.tree.base(i)]) > 1, i != siblings[chain.tree.base(i)][-1]
        asked = results | named_at if edge is None else {edge_name(n, chain.tree.at(edge)) for n in results & PER_CHILD}
        wanted = frozenset(
            (name, k)
            for name, values in program.outputs.items()
            for k, v in enumerate(values)
            if (name in asked and (each_tip or not name.startswith("tip.") or i == chain.last))
            or ((*_place(chain, name, i), k) in read and _written(v, together and name in SUMMED, adds))
        )
        key = (id(program), wanted)
        if key not in cache:
            cache[key] = _with_outputs(program, wanted)
        kept = cache[key]
        read |= {(*_place(chain, n.args[0], i), n.args[1]) for n in kept.nodes if n.op == "input"}
        out.append(Passage(number, i, kept, wanted, adds and any(name in SUMMED for name, _ in wanted), edge))
    return out[::-1]


def _written(value: Value, summed: bool, adds: bool) -> bool:
    """Whether an entry that somebody reads is written; the first link of a sum writes zeros and ones too."""
    if summed:
        return not adds or not (isinstance(value, float) and value == 0.0)
    return not _structural(value)


def _place(chain: Chain, name: str, i: int) -> tuple[str, str, int]:
    """The place of a signal of link i: its store, or a node."""
    where, _, what = name.partition(".")
    if is_node(where):
        return "node", what, chain.tree.places(i)[where]
    return "link", name, i


def _with_outputs(program: Program, wanted: frozenset[tuple[str, int]]) -> Program:
    names = [n for n in program.outputs if any(n == name for name, _ in wanted)]
    outputs = {n: [v if (n, k) in wanted else 0.0 for k, v in enumerate(program.outputs[n])] for n in names}
    kept = Program(program.name, {}, outputs, program.guards, program.sections, program.origins)
    read = {n.args[0] for n in kept.nodes if n.op == "input"}
    kept.inputs = {n: size for n, size in program.inputs.items() if n in read}
    return kept
