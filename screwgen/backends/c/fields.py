"""The structs of the generated C: their members, with unit, frame and meaning."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType

from ...algorithms.axis_terms import MEANINGS
from ...algorithms.columns import link_columns, robot_columns, width
from ...algorithms.fused import OF_FORCES
from ...algorithms.scope import AT_TIP, derived, own_label
from ...algorithms.signals import AXES, INPUTS, NODE, ROBOT, STORE, Signal, is_node
from ...algorithms.station_names import plain
from ...elements import STOP
from ...ir.block import NamedSignal as Constant
from ...ir.program import Program
from ...spec.link_class import LinkClass
from ...spec.markers import TIP, carried_at
from ...spec.parents import parents
from ...topology.chain import Chain
from . import inputs, tendons
from .code import entries, literal
from .curved import turns

SLIDING = {"rad": "m", "rad/s": "m/s", "rad/s^2": "m/s^2", "N*m": "N"}
"""The units of joint coordinates and their forces: of an axis that turns, of one that slides."""


@dataclass(frozen=True)
class StructMember:
    """One member of a struct; a scalar has no dimensions. Sizes of the robot are named as in the header."""

    name: str
    shape: tuple[int | str, ...]
    comment: str

    @property
    def declarator(self) -> str:
        return self.name + "".join(f"[{length(n)}]" for n in self.shape)

    def reals(self, sizes: Mapping[str, int] = MappingProxyType({})) -> int:
        """The numbers in it."""
        return math.prod(max(sizes[n], 1) if isinstance(n, str) else n for n in self.shape)


def length(n: int | str) -> str:
    """The length of an array in C; an empty one has length 1."""
    return {"NLINKS": "$$_NLINKS"}.get(n, f"$$_LENGTH($$_{n})") if isinstance(n, str) else str(n)


def structs(chain: Chain) -> dict[str, list[StructMember]]:
    """The members of the structs that hold the robot's signals.

    Without coupled coordinates NINERTIA is NGIVEN. In the DAE form the rotors of elastic drives stand before the modes.
    """
    inertia = "NINERTIA" if chain.coupled else "NGIVEN"
    inner = "NINNER" if chain.n_added else "NMODES"

    def field(struct: str, name: str, s: Signal) -> StructMember:
        axes = "NAXES" if chain.other_inputs else "NTAU"
        sizes: dict[int | str, str] = {"NINERTIA": inertia, "NAXES": axes}
        sizes |= {} if chain.n_internal else {"NVZ": "NV"}
        sizes |= {} if chain.base_v else {"NRATES": axes}
        sizes |= {} if chain.n_redundant != chain.n_joints else {"NREDUNDANT": axes}
        sizes |= {"NMODES": inner} if struct.startswith("dae") else {}
        comment = joint_comment(s, chain.sliding) + (effort(chain) + inputs.note(chain)) * (name == "tau")
        comment += ", then internal states" * (name == "v" and chain.n_internal > 0)
        shape = tuple(sizes.get(n, n) for n in s.shape)
        return StructMember(name, shape, ROTORS[name] if "NINNER" in shape else comment)

    more: dict[str, Signal] = inputs.scratch(chain)
    more |= {"start_rate": START_RATE} if has_axis_terms(chain) else {}
    more |= {"qrate": COORDINATE_RATE} if chain.n_redundant != chain.n_joints else {}
    more |= {"zdot": INTERNAL_RATE} if chain.n_internal else {}
    own = ROBOT | {"dae_state": ROBOT["dae_state"] | ({"z": INTERNAL} if chain.n_internal else {})}
    own |= {"dae_work": ROBOT["dae_work"] | more, "work": ROBOT["work"] | inputs.scratch(chain)}
    return {struct: [field(struct, n, s) for n, s in members.items()] for struct, members in own.items()}


def has_axis_terms(chain: Chain) -> bool:
    """Whether there are forces of axes besides springs and dampers: of gears and laws."""
    return bool(chain.n_added or chain.laws)


INTERNAL = Signal(("NINTERNAL",), "rad, m", "-", "internal states")
INTERNAL_RATE = Signal(("NINTERNAL",), "rad/s, m/s", "-", "rates of the internal states")
COORDINATE_RATE = Signal(("NREDUNDANT",), "rad/s, 1/s", "-", "rates of the joint coordinates")
START_RATE = Signal(AXES, "rad/s", "-", "joint rates at the start of a step")
ROTORS = {
    "eta": "rad, m: coordinates of the rotors or their gears, then modal ones",
    "etadot": "rad/s, m/s: their rates",
    "etaddot": "rad/s^2, m/s^2: their accelerations",
}
"""The comments of members that hold rotors as well."""


def joint_comment(signal: Signal, sliding: bool) -> str:
    """The comment of a signal; one of joint coordinates names the units of slides, if the robot has any."""
    unit = SLIDING.get(signal.unit)
    if not sliding or unit is None or not {"q", "m", "a", "NRATES", "NREDUNDANT", *INPUTS, *AXES} & set(signal.shape):
        return signal.comment
    slides = signal._replace(unit=f"{signal.unit}, of slides {unit}").comment
    return slides.replace("torque about each joint axis", "torque about, or force along, each joint axis")


def effort(chain: Chain) -> str:
    """What is added to the comment of torques where drives have transmissions."""
    return "".join(kind.EFFORT_NOTE for kind in chain.travel_kinds)


def fused_place(name: str, k: int) -> str:
    """The C expressions of the fused function's inputs and outputs; the modes' inertia is a parameter of its own."""
    link, _, what = name.partition(":")
    if what:
        return f"c->links[{link}].{what[2:]}"
    if name.startswith(OF_FORCES):
        return f"c->{name}"
    struct = next((struct for struct, own in ROBOT.items() if name in own and name != "m_eta"), "")
    if not struct:
        return f"{name}[{k}]"
    sizes = map(int, ROBOT[struct][name].shape[1:])
    return entries(f"{'c' if struct == 'constants' else struct}->{name}", *sizes)(k)


def constant_fields(chain: Chain, labels: Iterable[str], stated: Mapping[str, str]) -> list[StructMember]:
    """The members of ``ella_link_constants``, documented by the steps that define them.

    ``stated``: the comments of parameters of the robot file by their labels.
    """
    signals, given = _signals_of_labels(chain.classes), {**stated, **tendons.offset_comments(chain)}
    return [StructMember(name, (), _comment(signals, given, name)) for name in sorted(labels)]


def _comment(signals: Mapping[str, Constant], stated: Mapping[str, str], label: str) -> str:
    """The comment of a constant; where it is of a station, what it is at the tip."""
    own = own_label(label)
    if own in signals:
        return f"{signals[own].unit}: {signals[own].meaning}" + "; of a station" * (own != label)
    known = stated.get(label) or MEANINGS.get(label.rstrip("0123456789").removesuffix("_"))
    if known is None:
        raise LookupError(f"the constant '{label}' has no unit and meaning; state them in axis_terms.MEANINGS")
    return known


def _signals_of_labels(classes: Sequence[LinkClass]) -> dict[str, Constant]:
    """The signal that every label of the classes' blocks belongs to; the first that has it."""
    out: dict[str, Constant] = {}
    own = [block for key in classes for block in derived(key).values()]
    stations = [key.station(k) for key in classes for k in range(len(key.stations_at))]
    for block in (*own, *(derived(key)[name] for key in stations for name in AT_TIP)):
        for step in block.steps.values():
            for symbol, _ in step.assignments:
                out.setdefault(symbol.name, step.signal)
        for signal in block.inputs.values():
            for _, text in signal.labels():
                out.setdefault(text, signal)
    return out


def columns(chain: Chain, i: int, text: Callable[[str, str, int], str]) -> str:
    """Call arguments for a link's columns; those of its joint are on a separate line.

    ``text`` of a column's name, of the robot's column that holds it, and of its place there.
    """
    out = ""
    for part, span in chain.coordinate_spans(i).items():
        pairs = zip(link_columns(part), robot_columns(part), strict=True)
        arguments = [text(own, name, span.start) for own, name in pairs]
        if width(span):
            out += (",\n        " if part == "q" else ", ") + ", ".join(arguments)
    return out


def given_coordinates(chain: Chain) -> dict[str, object]:
    """Sizes and places of the coordinates whose inertia and force an integrator gives, for the templates.

    ``inertia``: the number of entries of their inertia; ``coupled``: row and column, among all modes, of those below
    the diagonal of the modes' matrices; ``added_joints``: the joint coordinate of each that a gear adds;
    ``ranges``: lower and upper stop of axes with both;
    ``elastic_travels``: joint, number among those added and place in ``v`` of the elastic gears of transmissions;
    ``laws``: whether forces depend on the rates at a stage; ``inner``: the number of rotors and modes.
    """
    modes, ends = zip(chain.eta_offset, chain.keys, strict=False), chain.acted(STOP)
    coupled = [(e + i, e + j) for e, key in modes for i, j in key.coupled]
    parts = [text for text, there in (("of coupled modes", coupled), ("of gears", chain.n_added)) if there]
    return {
        "tendons": tendons.content(chain),
        "inputs": inputs.content(chain, fused_place),
        "axes": "$$_NAXES" if chain.other_inputs else "$$_NTAU",
        "n_given": chain.n_given,
        "n_inertia": chain.n_inertia,
        "inertia": "$$_NINERTIA" if parts else "$$_NGIVEN",
        "coupled": coupled,
        "below": f"; at the end the entries below the diagonal, {' and '.join(parts)}" if parts else "",
        "below_offset": chain.below_offset[:-1],
        "n_added": chain.n_added,
        "inner": "$$_NINNER" if chain.n_added else "$$_NMODES",
        "added_joints": chain.added_joints,
        "driven": chain.effort_places,
        "elastic_travels": [
            (joint, chain.added_joints.index(joint), place) for joint, place in chain.elastic_travels.items()
        ],
        "ranges": [(k, k + 1) for k, (a, b) in enumerate(pairwise(ends)) if a.coordinate == b.coordinate],
        "laws": bool(chain.laws),
        "axis_terms": has_axis_terms(chain),
        "theta_offset": chain.theta_offset[:-1],
    }


def joint_places(chain: Chain) -> dict[str, object]:
    """Where the joints behind a pose begin in ``q`` and ``v``, as text.

    ``past``, ``from``: offsets of pointers and of indices; ``begin``: the first; ``ahead``: of coordinates over rates,
    behind the joints; ``added``: where the coordinates that gears add begin.
    """
    first = {"q": "$$_NPOSE", "v": "$$_NTWIST"} if chain.base_v else {}
    balls = any(not part.joint.in_space for part in chain.curved)
    added = {"q": "$$_NQ - $$_NINNER", "K": "$$_NGIVEN - $$_NINNER"}
    return {
        "first_q": chain.base_q,
        "first_v": chain.base_v,
        "past": {x: f" + {first[x]}" if first else "" for x in "qv"},
        "begin": {x: first.get(x, "0") for x in "qv"},
        "ahead": " + ($$_NQ - $$_NV)" if balls else " + ($$_NPOSE - $$_NTWIST)" if first else "",
        "from": {x: f"{first[x]} + " if first else "" for x in "qv"},
        "added": added if chain.curved else {"q": "ROTOR", "K": "ROTOR"},
        "ends": {"own": "$$_NGIVEN" if first else "$$_NV"},
    }


def last_tip(chain: Chain) -> dict[str, str]:
    """The link whose tip is that of the robot, and the node of that tip, as C."""
    if chain.last == chain.n - 1:
        return {"last_link": "$$_NLINKS - 1", "last_node": "$$_NLINKS"}
    return {"last_link": str(chain.last), "last_node": str(chain.tree.tip(chain.last))}


def topology(chain: Chain) -> dict[str, object]:
    """Of a tree, the nodes that carry its segments and the names of what carries its links; empty for a chain."""
    if chain.tree.is_chain:
        none = {"bases": [], "stations": [], "carriers": [], "markers": False}
        return {**joint_places(chain), **last_tip(chain), **none}
    links = chain.robot.links
    names = ["no other link" if chain.base_v else "the base", *(link.name for link in links)]
    bases = [chain.tree.base(i) for i in range(chain.n)]
    stations = [chain.tree.station(i, 0) for i in range(chain.n)] if any(chain.tree.stations) else []
    carried = zip(parents(links), carried_at(links), strict=True)
    carriers = [names[parent + 1] + (f" at s = {s:g}" if s != TIP else "") for parent, s in carried]
    more = {"bases": bases, "stations": stations, "n_stations": sum(chain.tree.stations), "carriers": carriers}
    more |= {"markers": any(segment.marker is not None for segment in chain.segments)}
    return {**joint_places(chain), **last_tip(chain), **more}


def node_fields(programs: Iterable[Program]) -> list[StructMember]:
    """The members of a node that the programs read or write."""
    return [StructMember(n, (s,), NODE[n].comment) for n, s in _signals(programs, is_node).items()]


def store_fields(programs: Iterable[Program], chain: Chain) -> list[StructMember]:
    """The members of a link's store."""
    found = _signals(programs, lambda where: where == "w")
    return [StructMember(n, (s,), _travelling(chain, n, STORE[plain(n)]) + _where(n)) for n, s in found.items()]


def _travelling(chain: Chain, name: str, signal: Signal) -> str:
    """The comment of a member, which names what drives move along travels."""
    comment = joint_comment(signal, chain.sliding)
    if not (chain.travel_kinds and name.startswith("crank_")):
        return comment
    first, *others = chain.travel_kinds
    unit = first.LEVER_UNIT + "".join(f", of {kind.SHORT}s {kind.LEVER_UNIT}" for kind in others)
    part = " or ".join(kind.PART for kind in chain.travel_kinds)
    return comment.replace("m:", f"{unit}:", name == "crank_slope").replace("cylinder", part)


def _where(name: str) -> str:
    """What is added to the comment of a member that is of a station."""
    return f"; of station {name.rpartition('_at')[2]}" if plain(name) != name else ""


def _signals(programs: Iterable[Program], there: Callable[[str], bool]) -> dict[str, int]:
    """Name without prefix and largest size of the signals in these places, in order of appearance."""
    out: dict[str, int] = {}
    for program in programs:
        for name, size in [*program.inputs.items(), *((n, len(v)) for n, v in program.outputs.items())]:
            where, _, short = name.partition(".")
            if short and there(where):
                out[short] = max(size, out.get(short, 0))
    return dict(sorted(out.items()))


def scratch(
    c: Chain,
    node: Sequence[StructMember],
    store: Sequence[StructMember],
    states: int,
    modular: bool,
    further: Mapping[str, int],
) -> dict[str, int]:
    """The sizes in bytes of the scratch of both forms in double precision.

    `states`: those that a step keeps; `further`: how many structs of a name are kept besides, and numbers of none.
    """
    sizes = {
        "NLINKS": c.n,
        "NQ": c.nq,
        "NV": c.nv,
        "NVZ": c.nvz,
        "NTAU": c.n_tau,
        "NAXES": c.n_joints,
        "NMODES": c.n_modes,
        "NGIVEN": c.n_given,
    }
    sizes |= {"NINTERNAL": c.n_internal}
    sizes |= {"NINERTIA": c.n_inertia, "NINNER": c.n_inner, "NRATES": c.v_offset[-1], "NREDUNDANT": c.n_redundant}
    total = lambda fields: sum(f.reals(sizes) for f in fields)  # noqa: E731
    own = {name: total(fields) for name, fields in structs(c).items()}
    chain = c.tree.size * total(node) + c.n * total(store)
    more = sum(count * own.get(name, 1) for name, count in further.items())
    work = own["work"] + states * (own["state"] + turns(c)) + own["output"] + chain * modular + more
    dae = own["dae_work"] + states * (own["dae_state"] + 6 * c.n) + chain + more
    return {"work": 8 * (work + 1), "dae_work": 8 * (dae + 1)}


def stumpff_terms(order: int, count: int = 14) -> list[str]:
    """The coefficients ``1 / (order + 2 j)!`` of a Stumpff function."""
    return [literal(1 / math.factorial(order + 2 * j)) for j in range(count)]


def index_type(count: int) -> str:
    """The smallest C type for the numbers below ``count``."""
    return "short" if count <= 2**15 else "int"


def rows(numbers: list[int], width: int = 20) -> list[str]:
    """Numbers of a table, a few per line."""
    return [", ".join(map(str, numbers[i : i + width])) + "," for i in range(0, len(numbers), width)]
