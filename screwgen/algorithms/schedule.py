"""Phases and algorithms: how they are traced, and how they are run over the links."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from ..elements.axis_element import PREFIX
from ..ir.block import Binding, Block
from ..ir.lower import lower
from ..ir.program import Program, Tracer, Value
from ..spec.drive_class import LAWS_OF_KEYS
from ..spec.link_class import EXACT, LinkClass
from ..topology.chain import Chain
from .axis_laws import columns_of
from .axis_terms import COLUMNS as OF_AXES
from .axis_terms import constant, labelled
from .modal_elimination import COMPLIANCE, FACTOR, WAYS
from .scope import AT_TIP, Layout, Scope, derived, owner_of
from .signals import is_node

OUTWARD, INWARD = +1, -1
COLUMNS = {
    "eta": ("M_eta", "K", "D"),
    **{part: tuple(own) for part, own in OF_AXES.items()},
    "below": ("M_below", "K_below", "D_below"),
}
"""Inertia, stiffness and damping of a link: of its modal coordinates, of its joint coordinates if forces act on these,
of what elements add, the entries that couple these with their axes,
and those below the diagonal where modes are coupled (``LinkClass.coupled``); those of laws are not listed."""


def is_column(name: str) -> bool:
    """Whether a name is that of a column, not of a constant of a link."""
    return name.startswith(PREFIX) or any(name in names for names in (*COLUMNS.values(), *BUILT_IN))


BUILT_IN = tuple(law.constants for law in LAWS_OF_KEYS)
"""The columns of laws whose names have no prefix."""
FEW, MANY = 3, 12
"""With fewer than FEW modes the r x r factor always needs fewer operations, with more than MANY never."""


@dataclass(frozen=True)
class Phase:
    """The computations of every link in one pass along the chain: from base to tip, or from tip to base."""

    work: Callable[[Scope], None]
    direction: int
    per_child: bool = False
    """Whether the phase depends on each of the links that a link carries, not on their sum."""
    at_markers: bool = False
    """Whether the phase runs at all markers of a link, not only where it carries others."""

    @property
    def name(self) -> str:
        return self.work.__name__

    @property
    def eliminates(self) -> bool:
        """Whether the phase solves for modal accelerations."""
        return self.name == "eliminate"


Algorithm = tuple[Phase, ...]


@cache
def trace(key: LinkClass, algorithm: Algorithm) -> tuple[Program, ...]:
    """The programs of a link class, one per phase of an algorithm; links of a class share them.

    Of the methods to eliminate modes the one with the fewest operations is taken.
    """
    ways = _ways(key) if any(phase.eliminates for phase in algorithm) else (FACTOR,)
    traced = [_traced(key, algorithm, way)[0] for way in ways]
    return min(traced, key=lambda programs: sum(p.operation_count for p in programs))


def _ways(key: LinkClass) -> tuple[str, ...]:
    """The methods worth tracing. Only the factor holds where the tip shapes may lose rank.

    That is to second order, when a link is straight; where sections that turn without inertia have rank at the tip
    alone; where the shapes are the numbers of a file; and where several sections carry links.
    """
    if (
        key.order in (2, EXACT)
        or key.has_inertialess_section_modes
        or key.modes < FEW
        or key.elastic is not None
        or key.stations_at
    ):
        return (FACTOR,)
    return WAYS if key.modes <= MANY else (COMPLIANCE,)


@cache
def _traced(key: LinkClass, algorithm: Algorithm, way: str) -> tuple[tuple[Program, ...], dict[str, Layout]]:
    """The programs by one method, and the layouts of the link's store; algorithms share those of equal first phases."""
    if not algorithm:
        return (), {}
    *before, phase = algorithm
    method = way if any(earlier.eliminates for earlier in before) else FACTOR
    programs, layouts = _traced(key, tuple(before), method)
    scope = Scope(key, Tracer(), dict(layouts), way)
    phase.work(scope)
    return (*programs, scope.program(phase.name)), scope.layouts


@cache
def preparation(key: LinkClass, labels: tuple[str, ...]) -> Program:
    """The parameter slice of the blocks: constants by label, and the ``COLUMNS`` of modes and sprung joints."""
    tracer = Tracer()
    scope = Scope(key, tracer, {})
    blocks = derived(key)
    for label in labels:
        if (value := labelled(scope, label)) is not None:
            scope.write(label, [value])
            continue
        section, own = owner_of(key, label)
        places = blocks.values() if section is key else (derived(section)[name] for name in AT_TIP)
        owner = next((b for b in places if any(s.name == own for s in b.bindings)), None)
        scope.write(label, [scope.read(f"p.{label}", 1)[0] if owner is None else _prepared(scope, owner, own)])
    inputs = _parameters(scope, derived(key)["link"])
    for part, size in (("eta", key.modes), ("below", len(key.coupled))):
        for name in COLUMNS[part] if size or part == "eta" else ():
            damped = key.damping or not name.startswith("D")
            values = lower(derived(key)["link"], inputs, (name,), tracer)[name] if damped else [0.0] * size
            scope.write(name, values)
    joints = range(key.joints) if key.has_axis_forces else ()
    for part, own_columns in OF_AXES.items():
        for name, label in own_columns.items():
            if axes := joints if part == "q" else key.added_axes:
                scope.write(name, [constant(scope, label, axis) for axis in axes])
    for name, entries in columns_of(scope):
        scope.write(name, entries)
    return scope.program("prepare")


def _parameters(scope: Scope, block: Block) -> dict:
    """The parameters of a block as inputs of its preparation."""
    out = {}
    for name, signal in block.inputs.items():
        if signal.binding == Binding.PARAMETER:
            entries = [scope.read(f"p.{symbol.name}", 1)[0] for symbol in block.values[name].flat]
            out[name] = entries
    return out


def _prepared(scope: Scope, block: Block, label: str) -> Value:
    """One constant: its step and the steps that it depends on, recorded from the parameters."""
    symbol = next(s for s in block.bindings if s.name == label)
    for name, signal in block.inputs.items():
        if symbol in block.values[name].flat and signal.binding == Binding.PARAMETER:
            return scope.read(f"p.{label}", 1)[0]
    step = next(s for s in block.steps.values() if any(symbol == made for made, _ in s.assignments))
    values = lower(block, _parameters(scope, block), (step.signal.name,), scope.tracer)[step.signal.name]
    place = next(index for index in step.signal.labels() if block.values[step.signal.name][index[0]] == symbol)
    return values[place[0]]


def seen_by(chain: Chain, *algorithms: Algorithm) -> Chain:
    """The chain over which algorithms run: with a node for every marker if one of them measures there."""
    return chain.seen if any(phase.at_markers for a in algorithms for phase in a) else chain


def constant_labels(chain: Chain, i: int, algorithms: Sequence[Algorithm]) -> tuple[str, ...]:
    """The constants of a link that programs ask for, sorted."""
    programs = [p for a in algorithms for p in trace(seen_by(chain, a).keys[i], a)]
    remembered = {label for one in chain.keys[i].remembering for label in one.labels}  # their rates follow all dynamics
    return tuple(sorted({name[2:] for p in programs for name in p.inputs if name.startswith("c.")} | remembered))


SUMMED = frozenset(f"base.{name}" for name in ("Lambda", "p", "f", "Gamma", "Lambda_T"))
"""What a link adds to the node that carries it."""

Apply = Callable[[int, int, Program, Mapping[str, list]], Mapping[str, list]]


def execute(
    chain: Chain,
    algorithm: Algorithm,
    links: Sequence[Mapping[str, list]],
    nodes: Sequence[dict[str, list]],
    apply: Apply,
) -> list[dict[str, list]]:
    """Run an algorithm over the chain: the schedule of every back end.

    ``links`` holds the inputs and constants of every link, ``nodes`` the nodes of the tree with the known values of
    base and leaves; ``apply(link, phase, program, inputs)`` runs one program on values of any algebra.  Returns, for
    every link, all signals that it has read or written.
    """
    stores = [dict(link) for link in links]
    handed: set[tuple[int, int, str]] = set()
    for number, i, edge in visits(chain, algorithm):
        program, base = trace(chain.keys[i], algorithm)[number], chain.tree.base(i)
        places = {where: nodes[node] for where, node in chain.tree.places(i).items()} | {"": stores[i]}
        inputs = {name: _fetch(name, places) for name in program.inputs}
        outputs = _applied(apply, chain, i, number, program, inputs)
        if edge is not None and algorithm[number].per_child:
            stores[edge]["edge"] = outputs  # type: ignore[assignment]
            continue
        for name, values in outputs.items():
            store, what = _place(name, places)
            summed = name in SUMMED
            store[what] = _summed(store[what], values) if summed and (number, base, what) in handed else values
            handed |= {(number, base, what)} if summed else set()
    return stores


Visit = tuple[int, int, int | None]
"""The number of a phase, a link, and the carried link whose edge is meant."""


def visits(chain: Chain, algorithm: Algorithm) -> Iterator[Visit]:
    """Phases and links in the order in which they run.

    What a phase computes ``per_child`` it computes for one link that is carried, the last that wrote to the node. The
    other links of the node follow: each writes its part again, and the phase runs for it.
    """
    for number, phase in enumerate(algorithm):
        order = range(chain.n) if phase.direction == OUTWARD else reversed(range(chain.n))
        yield from ((number, i, None) for i in order)
    if algorithm[-1].per_child:
        for child in further_children(chain):
            yield from ((number, child, child) for number in range(len(algorithm) - 1))
            yield len(algorithm) - 1, chain.tree.parents[child], child


def further_children(chain: Chain) -> list[int]:
    """The links that are carried by another one and are not the last of its node."""
    return [child for carried in chain.tree.children[1:] for child in carried[:-1]]


def _place(name: str, places: Mapping[str, dict]) -> tuple[dict, str]:
    """The mapping that holds a signal, and the signal's name there."""
    where, _, what = name.partition(".")
    return (places[where], what) if is_node(where) else (places[""], name)


def _fetch(name: str, places: Mapping[str, dict]) -> list:
    store, what = _place(name, places)
    if name.startswith("c.") and what not in store:
        said = f"the constant '{name[2:]}' was not prepared, since no algorithm that reads it is named"
        raise LookupError(f"{said}; name its algorithm in the row of the function in robot_functions.FUNCTIONS")
    return store[what]


def _summed(before: Sequence, values: Sequence) -> list:
    """The sum of two links' contributions to the node that carries both."""
    return [a + b for a, b in zip(before, values, strict=True)]


def _applied(apply: Apply, chain: Chain, link: int, number: int, program: Program, inputs: Mapping) -> Mapping:
    try:
        return apply(link, number, program, inputs)
    except ZeroDivisionError:
        raise chain.unresisted(link) from None
