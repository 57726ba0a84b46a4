"""The scope of a phase: named signals of the link, of its two nodes, and of the call.

A chain of n links has n + 1 *nodes*: node 0 is the base, node i + 1 is the tip of link i.  A phase of
link i reads and writes signals. The prefix of a signal's name says where it is stored:

``base.*``, ``tip.*``  node i and node i + 1: twists, poses, accelerations, reactions
``at0.*``, ``at1.*``   the nodes of the stations, other sections at which the link carries links: :class:`StationScope`
``w.*``                the link's store, which later phases of the same link read
``c.*``                constants of the link, prepared from its parameters
anything else          inputs and outputs of the call (``q``, ``eta``, ``tau``, ``wrench`` ...)
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from functools import cache, cached_property, partial
from math import prod

import numpy as np

from ..bodies.energy import energy_block
from ..bodies.exact import element_block, link_block, load_block, section_block, spin_block
from ..bodies.joint import joint_block, motion_block, posture_block
from ..bodies.tendon import tendon_block
from ..bodies.tip import tip_block, tip_body_block, tip_motion_block, tip_pose_block
from ..bodies.validity import validity_block
from ..ir.block import Binding, Block
from ..ir.lower import lower
from ..ir.names import Label
from ..ir.program import Array, Node, Program, Tracer, Value, Vector, give_label
from ..spec.link_class import EXACT, LinkClass
from . import matrices as mx
from .joint_rows import joint_rows_block
from .link_rows import link_rows_block
from .rod_sections import RodMotion, along_rod
from .signals import PER_CHILD, signal, type_of
from .station_names import at_station

BLOCKS: dict[str, Callable[[LinkClass], Block]] = {
    "joint": joint_block,
    "posture": posture_block,
    "joint_motion": motion_block,
    "link": link_block,
    "tip": tip_block,
    "tip_motion": tip_motion_block,
    "tip_pose": tip_pose_block,
    "tip_body": tip_body_block,
    "joint_rows": joint_rows_block,
    "validity": validity_block,
    "turning_link": partial(link_block, turning=True),
    "energy": energy_block,
    "link_rows": link_rows_block,
    "section": section_block,
    "element": element_block,
    "section_spin": spin_block,
    "section_load": load_block,
    "tendon": tendon_block,
}
"""The blocks of a link class by name."""
OTHERS = ("turning_link", "energy", "link_rows", "section", "element", "section_spin", "section_load", "tendon")
"""Blocks without constants of their own."""


class Derived(Mapping):
    """The blocks of a link class, each derived when it is first asked for."""

    def __init__(self, key: LinkClass):
        self.key = key
        self._made: dict[str, Block] = {}

    def __getitem__(self, name: str) -> Block:
        if name not in self._made:
            self._made[name] = BLOCKS[name](self.key)
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(BLOCKS)

    def __len__(self) -> int:
        return len(BLOCKS)


@cache
def derived(key: LinkClass) -> Mapping[str, Block]:
    """The blocks of a link class; derived once, however many links share it."""
    return Derived(key)


@cache
def repeated(key: LinkClass) -> dict[str, tuple[float, str]]:
    """The constants of a class that equal another one for all parameters, each with that one's sign and label.

    Examples are a section that is the same about both axes, or a mode shape of two directions. Equal constants are
    prepared and stored once, and their products are computed once.
    """
    first: dict[int, tuple[float, str]] = {}
    out: dict[str, tuple[float, str]] = {}
    tracer = Tracer()
    for block in (derived(key)[name] for name in BLOCKS if name not in OTHERS):
        given = {n: s for n, s in block.inputs.items() if s.binding <= Binding.PARAMETER}
        inputs = {n: [tracer.input(symbol.name, 1)[0] for symbol in block.values[n].flat] for n in given}
        names = [n for n, step in block.steps.items() if step.signal.binding <= Binding.PARAMETER]
        for name, values in lower(block, inputs, names, tracer).items():
            for symbol, value in zip(block.values[name].flat, values.flat, strict=True):
                if isinstance(value, Node) and symbol.is_Symbol:
                    sign, node = (-1.0, value.args[0]) if value.op == "neg" else (1.0, value)
                    owner = first.setdefault(node.id, (sign, symbol.name))
                    out[symbol.name] = sign * owner[0], owner[1]
    return {label: alias for label, alias in out.items() if alias[1] != label}


def of_station(label: str, number: int) -> str:
    """The label of a constant of a station."""
    return f"at{number}_{label}"


OF_STATION = re.compile(r"at(\d+)_(.+)")


def owner_of(key: LinkClass, label: str) -> tuple[LinkClass, str]:
    """The class whose blocks define a constant, the link's or that of a station, and its label there."""
    found = OF_STATION.fullmatch(label)
    return (key.station(int(found[1])), found[2]) if found else (key, label)


def own_label(label: str) -> str:
    """The label of a constant in the block that defines it, without the number of the station that has it."""
    found = OF_STATION.fullmatch(label)
    return found[2] if found else label


@dataclass
class Layout:
    """The layout of an array in the link's store, which has places for computed entries only.

    ``entries`` holds, for every entry, a float, or the sign and place of a stored value, or the sign
    and label of a constant.
    """

    shape: tuple[int, ...]
    entries: list[float | tuple[float, int] | tuple[float, str]]
    size: int


@dataclass
class Scope:
    """One link class, one tracer: the world of a phase."""

    key: LinkClass
    tracer: Tracer
    layouts: dict[str, Layout]
    way: str = ""
    """The method by which modal accelerations are eliminated, see :mod:`.modal_elimination`."""
    inputs: dict[str, list[Value]] = field(default_factory=dict)
    outputs: dict[str, list[Value]] = field(default_factory=dict)
    fresh: dict[str, Array] = field(default_factory=dict)
    swept: dict[tuple, RodMotion] = field(default_factory=dict)
    """The motion along the rod by the modal coordinates and rates that it was found for."""

    def read(self, name: str, *shape: int) -> Array:
        """An input signal; ``shape`` is needed if it has no type in :mod:`.signals`."""
        shape = shape or signal(name).size_of(self.key)
        return np.array(self._entries(name, prod(shape)), dtype=object).reshape(shape)

    def _entries(self, name: str, size: int) -> list[Value]:
        if name not in self.inputs:
            self.inputs[name] = list(self.tracer.input(name, size))
        return self.inputs[name]

    def modal_inertia(self) -> Array:
        """The (r, r) inertia of the link's modes: as given, and what bending adds, which an earlier step has kept."""
        below = self.read("m_below") if self.key.coupled else ()
        return mx.coupled(self.read("m_eta"), self.key.coupled, below) + self.kept("M_bent")

    def write(self, name: str, values: Vector) -> None:
        """An output signal."""
        self.name(name.rpartition(".")[2], values, name)
        self.outputs[name] = list(np.asarray(values, dtype=object).ravel())

    def name(self, name: str, values: Vector, like: str = "") -> Array:
        """Name the entries that have no name yet, like those of a signal (default: ``name``); returns the array."""
        values, kind = np.asarray(values, dtype=object), type_of(like or name)
        for index, value in np.ndenumerate(values):
            give_label(value, Label(name, kind.place(index, values.shape)))
        return values

    def step(self, title: str) -> AbstractContextManager[None]:
        """Operations recorded inside form a section with this title."""
        return self.tracer.section(title)

    def routine(self, name: str) -> AbstractContextManager[None]:
        """Operations recorded inside recur, see :mod:`..ir.routines`."""
        return self.tracer.routine(name)

    @property
    def rod(self) -> Scope:
        """The scope of the link to which this section belongs."""
        return self

    @property
    def sections(self) -> list[Scope]:
        """The tip, which is this scope itself, and the stations."""
        return [self, *self.stations]

    @cached_property
    def stations(self) -> list[Scope]:
        """The other sections at which the link carries links."""
        return [StationScope(self, number) for number in range(len(self.key.stations_at))]

    def constant(self, label: str) -> Value:
        """A constant of the link, by the label of the step that prepares it."""
        sign, label = repeated(self.key).get(label, (1.0, label))
        (value,) = self._entries(f"c.{label}", 1)
        return value if sign > 0 else -value

    def lower(self, block: str | Block, inputs: Mapping[str, Array], *outputs: str) -> list[Array]:
        """Record a block (or the class's block of that name) and return outputs; columns are flat arrays."""
        owner = block if isinstance(block, Block) else derived(self.key)[block]
        if self.key.order == EXACT:
            inputs = along_rod(self, owner.name, inputs)
        values = lower(owner, inputs, outputs, self.tracer, self.constant)
        flat = [owner.signal(n).shape[1] == 1 and 1 not in owner.signal(n).numbered for n in outputs]
        return [values[n][:, 0] if column else values[n] for n, column in zip(outputs, flat, strict=True)]

    def keep(self, name: str, values: Array) -> None:
        """Store an array for later phases of the same link."""
        self.fresh[name] = values
        self.name(name, values, f"w.{name}")
        slots: dict[int, int] = {}
        stored: list[Value] = []
        entries: list[float | tuple[float, int] | tuple[float, str]] = []
        for value in np.asarray(values, dtype=object).ravel():
            sign, node = (-1.0, value.args[0]) if isinstance(value, Node) and value.op == "neg" else (1.0, value)
            if not isinstance(node, Node):
                entries.append(float(node))
            elif node.op == "input" and node.args[0].startswith("c."):
                entries.append((sign, node.args[0][2:]))
            else:
                if node.id not in slots:
                    slots[node.id] = len(stored)
                    stored.append(node)
                entries.append((sign, slots[node.id]))
        self.layouts[name] = Layout(np.shape(values), entries, len(stored))
        if stored:
            self.outputs[f"w.{name}"] = stored

    def kept(self, name: str) -> Array:
        """An array that this or an earlier phase stored, with its float entries."""
        if name in self.fresh:
            return self.fresh[name]
        layout = self.layouts[name]
        stored = self.read(f"w.{name}", layout.size) if layout.size else mx.zeros(0)
        values = [self._entry(e, stored) for e in layout.entries]
        return np.fromiter(values, object).reshape(layout.shape)

    def _entry(self, entry: float | tuple[float, int] | tuple[float, str], stored: Array) -> Value:
        if isinstance(entry, float):
            return entry
        sign, place = entry
        value = self.constant(place) if isinstance(place, str) else stored[place]
        return value if sign > 0 else -value

    def program(self, name: str) -> Program:
        """The recorded operations as a program."""
        return self.tracer.program(name, {k: len(v) for k, v in self.inputs.items()}, self.outputs)


AT_TIP = ("tip", "tip_motion", "tip_pose", "tip_body")
"""The blocks that describe the tip."""
KEPT = "r_T R_T J_l Psi_c Phi_c b_T M_T h_T load_axial udot_T omega_s E tip_eta tip_etadot"
OF_TIP = frozenset(KEPT.split()) | PER_CHILD
"""What a link keeps of its tip, and writes of what is carried there."""


class StationScope(Scope):
    """The scope of a phase in which a station stands for the tip: its node, its blocks, what is kept of it.

    So what a phase does at the tip is done there by the same lines. Nothing acts on a station but what it carries.
    """

    def __init__(self, link: Scope, number: int):
        super().__init__(link.key.station(number), link.tracer, link.layouts, link.way, link.inputs, link.outputs)
        self.link, self.number = link, number
        self.parameters: set[str] = set()

    @property
    def rod(self) -> Scope:
        return self.link

    def _own(self, name: str) -> str:
        tip = name.startswith("tip.") or name.removeprefix("w.") in OF_TIP
        return at_station(name, self.number) if tip else name

    def read(self, name: str, *shape: int) -> Array:
        return mx.zeros(6) if name == "w_ext" else self.link.read(self._own(name), *shape)

    def write(self, name: str, values: Vector) -> None:
        self.link.write(self._own(name), values)

    def keep(self, name: str, values: Array) -> None:
        self.link.keep(self._own(name), values)

    def kept(self, name: str) -> Array:
        return self.link.kept(self._own(name))

    def lower(self, block: str | Block, inputs: Mapping[str, Array], *outputs: str) -> list[Array]:
        if block not in AT_TIP:
            return self.link.lower(block, inputs, *outputs)
        owner = derived(self.key)[block]
        self.parameters = {symbol.name for name in owner.inputs for symbol in owner.values[name].flat}
        return super().lower(owner, inputs, *outputs)

    def constant(self, label: str) -> Value:
        """A constant of the link, or of the station, whose label tells which."""
        if label in self.parameters:
            return self.link.constant(label)
        return self._entries(f"c.{of_station(label, self.number)}", 1)[0]
