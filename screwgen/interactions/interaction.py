"""The contract of a force between two frames: its keys in a robot file, its wrench, its energy.

A spring of 400 N/m between the tip of a boom and a hook on the wall pulls both towards each other. What it needs to
know is how the second frame lies and moves as seen from the first; what it says is the wrench on the second frame. The
first takes the opposite at the same point. All back ends replay or print that one statement, and the tracer derives its
slopes.

An interaction is a frozen dataclass. Its numbers are run-time parameters, its choices (true or false) are structure.
A number without a default must be stated; one whose default is None is zero by structure where a file omits it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields
from functools import cache
from math import log10
from typing import Any, ClassVar, NamedTuple

Value = Any
Vector = Any
"""Entries in a row, such as a list or an array."""


class Number(NamedTuple):
    """A number that an interaction states: unit, meaning, letter in its formula, and range.

    It is 0 or of a size between ``least`` and ``most``; ``sign``: ``positive``, ``non-negative`` or ``any``;
    ``entries``: what the entries of an array of numbers are called. Where these have two units, half have each.
    """

    unit: str
    meaning: str
    symbol: str
    sign: str = "any"
    least: float = 0.0
    most: float = 1e18
    entries: tuple[str, ...] = ()

    def unit_of(self, entry: int) -> str:
        """The unit of an entry of the array."""
        units = self.unit.split(", ")
        return units[entry * len(units) // len(self.entries)]


class ReportedQuantity(NamedTuple):
    """A number that runs report of an interaction: unit and meaning."""

    unit: str
    meaning: str


class ForceInput(NamedTuple):
    """An entry of ``tau`` that acts on an interaction: unit, meaning, letter in its formula.

    ``adds_to``: the number to which it is added, if it is no key of its own. At zero a force is that of the file.
    """

    unit: str
    meaning: str
    symbol: str
    adds_to: str = ""


class ForceState(NamedTuple):
    """A state of first order that an interaction remembers: unit, meaning, letter in its formula.

    ``size``: how large it usually is; it scales optimal control and the states at which generated code checks itself.
    """

    unit: str
    meaning: str
    symbol: str
    size: float

    @property
    def rate_symbol(self) -> str:
        """The letter of its rate."""
        letter, _, index = self.symbol.partition("_")
        return rf"\dot{{{letter}}}" + f"_{index}" * bool(index)


class StateRate(NamedTuple):
    """How a state z changes: ``zdot = gain - decay z``, with a decay that is not negative.

    Implicit steps of length h take ``(z + h gain)/(1 + h decay)``, which is stable for any of them.
    """

    gain: Value
    decay: Value


def number(unit: str, meaning: str, symbol: str, default: Any = MISSING, **more: Any) -> Any:
    """A field with a number; the rest as of :class:`Number`."""
    return field(default=default, metadata={"number": Number(unit, meaning, symbol, **more)})


def choice(meaning: str) -> Any:
    """A field that is true or false, and false where a file omits it."""
    return field(default=False, metadata={"choice": meaning})


class Relative(NamedTuple):
    """The second frame as seen from the first, in the first's axes.

    ``d`` (3,) m: its origin; ``R`` (3, 3): its rotation; ``v`` (3,) m/s: the rate of ``d`` as the first frame sees it;
    ``omega`` (3,) rad/s: its angular velocity relative to the first.
    """

    d: Vector
    R: Any
    v: Vector
    omega: Vector


class SoftRow(NamedTuple):
    """A number of the two frames, their ``gap``, that a spring and a damper pull back to ``rest``.

    The force against it is ``stiffness (gap - rest) + damping (rate - speed)``; of one that is ``slack`` only where
    stretch and force are positive. Implicit steps take it at their end, however stiff it is.
    """

    stiffness: Value
    damping: Value
    rest: Value = 0.0
    speed: Value = 0.0
    slack: bool = False


ROWS = "rows"
"""The key of the gaps that implicit steps take at their end, among what programs of a force are made from."""


class WrenchOnSecond(NamedTuple):
    """What acts on the second frame at its origin, in the first frame's axes: N·m and N, (3,) each."""

    torque: Vector
    force: Vector


TORQUE, FORCE, POTENTIAL = r"\boldsymbol{\tau}_{AB}", r"\mathbf{F}_{AB}", "U"
"""The LaTeX of the parts of a wrench, and of the potential."""


class LawEquation(NamedTuple):
    """An equation of a law in LaTeX: symbol and right side; of a symbol of the law's own also unit and meaning."""

    symbol: str
    formula: str
    unit: str = "-"
    meaning: str = ""

    @classmethod
    def smallest(cls, square: float, unit: str, what: str) -> LawEquation:
        """What is added to the square of a size, so that a vector without any has a direction."""
        return cls(r"\varepsilon", rf"10^{{{round(log10(square))}}}", unit, f"keeps {what} from 0/0")


@dataclass(frozen=True)
class Interaction:
    """A force between two frames, to be inherited.

    ``KIND``: its key in a robot file; ``WORDS``: what it is called in comments and documents;
    ``QUANTITIES``: what runs report of it, by names that none of its numbers has; ``INPUTS``: what a controller may
    choose of it, entries of ``tau`` as ``rope.paid_out``; ``STATES``: what it remembers, entries of ``v`` behind all
    rates, as ``rope.relaxation_state[0]``.
    """

    KIND: ClassVar[str]
    WORDS: ClassVar[str]
    QUANTITIES: ClassVar[Mapping[str, ReportedQuantity]] = {}
    INPUTS: ClassVar[Mapping[str, ForceInput]] = {}
    STATES: ClassVar[Mapping[str, ForceState]] = {}

    @staticmethod
    def has_inputs(has: Collection[str]) -> bool:
        """Whether a controller chooses its ``INPUTS``; ``has``: numbers that are stated, choices that are true."""
        return True

    @staticmethod
    def has_states(has: Collection[str]) -> bool:
        """Whether it has its ``STATES``."""
        return True

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> WrenchOnSecond:
        """The wrench in a state.

        ``keys``: the numbers and choices, the inputs that are added to no number, the states; what is not stated is 0.
        Of the tracer ``t`` it uses ``t.call(name, x)`` for functions, and ``t.named(name, x)``, which names a value in
        generated code. Functions are ``sqrt``, ``sin``, ``cos``, ``atan2`` and ``on``, 1 where x > 0, else 0; all stand
        in :data:`..ir.program.FUNCTIONS`. A root of what may vanish needs a small number below it.
        """
        raise NotImplementedError

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        """The potential, J; none by default."""
        return 0.0

    @staticmethod
    def soft_row(row: Any, **keys: Any) -> SoftRow:
        """The law of a gap ``row`` that implicit steps take at their end; of a kind whose shape has ``ROWS``."""
        raise NotImplementedError

    @staticmethod
    def rates(t: Any, x: Relative, **keys: Any) -> Mapping[str, StateRate]:
        """How each of ``STATES`` changes; must be stated of a kind that has any."""
        raise NotImplementedError

    @staticmethod
    def power(t: Any, x: Relative, **keys: Any) -> Mapping[str, Value]:
        """The power that each of ``INPUTS`` gives to the robot, W; must be stated of a kind that has any."""
        raise NotImplementedError

    @staticmethod
    def equations(has: Collection[str]) -> tuple[LawEquation, ...]:
        r"""The same law for documents, in the order of evaluation, ending with ``TORQUE``, ``FORCE``, ``POTENTIAL``,
        then the rates of states under their ``rate_symbol``.

        What has no equation is zero. ``has``: the numbers that are stated, and the choices that are true.

        Of :class:`Relative` the letters are ``\mathbf{d}_{AB}``, ``\mathbf{R}_{AB}``, ``\mathbf{v}_{AB}``,
        ``\boldsymbol{\omega}_{AB}``; ``\mathrm{H}`` is the function ``on``. With no equation at all a document prints
        what :meth:`wrench` and :meth:`energy` compute, entry by entry.
        """
        return ()

    @property
    def fault(self) -> tuple[str, str] | None:
        """A key, or an empty text, and what is wrong with numbers that are each in their range, with the remedy."""
        return None

    @staticmethod
    def drawn(has: Collection[str]) -> str:
        """How pictures draw it between its ends: as a ``spring``, as a ``rope``, which hangs where it is longer than
        its way, or as a ``line``; sketches alone join them with ``none``, and with ``contact``, which touches."""
        return "line"

    @staticmethod
    def outputs(t: Any, x: Relative, **keys: Any) -> Mapping[str, Value]:
        """The values of ``QUANTITIES`` in a state."""
        return {}

    @classmethod
    @cache
    def table(cls) -> Mapping[str, Number]:
        """The numbers by name."""
        return {one.name: one.metadata["number"] for one in fields(cls) if "number" in one.metadata}

    @classmethod
    @cache
    def choices(cls) -> Mapping[str, str]:
        """The choices by name, with their meanings."""
        return {one.name: one.metadata["choice"] for one in fields(cls) if "choice" in one.metadata}

    @property
    def numbers(self) -> dict[str, Any]:
        """The numbers that are stated, by name; several are a tuple."""
        found = {name: getattr(self, name) for name in self.table()}
        return {name: value for name, value in found.items() if value is not None}

    @property
    def shape(self) -> InteractionClass:
        """All but its numbers."""
        chosen = tuple((name, getattr(self, name)) for name in self.choices())
        return InteractionClass(type(self), tuple(self.numbers), chosen)


@dataclass(frozen=True)
class InteractionClass:
    """An interaction without its numbers: what its programs are made from."""

    kind: type[Interaction]
    stated: tuple[str, ...]
    """The names of the numbers that are stated."""
    chosen: tuple[tuple[str, bool], ...]
    structure: tuple[tuple[str, Any], ...] = ()
    """Further keys of its laws that are no numbers, such as the directions of a joint."""

    def wrench(self, t: Any, x: Relative, numbers: Sequence[Value]) -> WrenchOnSecond:
        """The wrench of the numbers that are stated, entry by entry, and of the inputs and states behind them."""
        return self.kind.wrench(t, x, **self.keys(numbers))

    def energy(self, t: Any, x: Relative, numbers: Sequence[Value]) -> Value:
        """The potential, J."""
        return self.kind.energy(t, x, **self.keys(numbers))

    @property
    def has(self) -> tuple[str, ...]:
        """The numbers that are stated, and the choices that are true."""
        return (*self.stated, *(name for name, on in self.chosen if on))

    @property
    def equations(self) -> tuple[LawEquation, ...]:
        """The law in LaTeX, if its kind states it."""
        return self.kind.equations(self.has)

    @property
    def inputs(self) -> Mapping[str, ForceInput]:
        """What a controller chooses of it, by name."""
        return self.kind.INPUTS if self.kind.has_inputs(self.has) else {}

    @property
    def states(self) -> Mapping[str, ForceState]:
        """What it remembers, by name."""
        return self.kind.STATES if self.kind.has_states(self.has) else {}

    @property
    def size(self) -> int:
        """How many values its programs take: numbers that are stated, then inputs, then states."""
        return self.count + len(self.inputs) + len(self.states)

    @property
    def drawn(self) -> str:
        """How pictures draw it."""
        return self.kind.drawn(self.has)

    def outputs(self, t: Any, x: Relative, numbers: Sequence[Value]) -> list[Value]:
        """What runs report, in the order of its kind's ``QUANTITIES``."""
        found = self.kind.outputs(t, x, **self.keys(numbers))
        return [found[name] for name in self.kind.QUANTITIES]

    def power(self, t: Any, x: Relative, numbers: Sequence[Value]) -> list[Value]:
        """The power of its inputs, in their order."""
        found = self.kind.power(t, x, **self.keys(numbers))
        return [found[name] for name in self.inputs]

    def rates(self, t: Any, x: Relative, numbers: Sequence[Value]) -> list[StateRate]:
        """How its states change, in their order."""
        found = self.kind.rates(t, x, **self.keys(numbers)) if self.states else {}
        return [found[name] for name in self.states]

    def keys(self, numbers: Sequence[Value]) -> dict[str, Any]:
        """What its laws take by name, of the numbers that are stated, and of the inputs and states behind them."""
        given: dict[str, Any] = {}
        rest = iter(numbers)
        for name, one in self.kind.table().items():
            of = (lambda: next(rest)) if name in self.stated else (lambda: 0.0)
            given[name] = tuple(of() for _ in one.entries) if one.entries else of()
        for name, entry in self.kind.INPUTS.items():
            value = next(rest) if name in self.inputs else 0.0
            given |= {entry.adds_to: given[entry.adds_to] + value} if entry.adds_to else {name: value}
        given |= {name: next(rest) if name in self.states else 0.0 for name in self.kind.STATES}
        return given | dict(self.chosen) | dict(self.structure)

    @property
    def count(self) -> int:
        """How many numbers are stated, entry by entry."""
        return sum(len(self.kind.table()[name].entries) or 1 for name in self.stated)
