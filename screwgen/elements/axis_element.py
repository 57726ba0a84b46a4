"""The contract of an element of a joint axis that a robot file states: its keys, its force, its energy.

An element is a frozen dataclass whose fields are its keys. A file states ``elements = { spring = { stiffness = 80.0,
rest = 0.4 } }`` on an axis, which makes ``Spring(80.0, 0.4)``. Its numbers are parameters that may change at run time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import MISSING, dataclass, field, fields
from functools import cache
from typing import Any, ClassVar

from .law import Bristle, Key, Secant, Value


def key(unit: str, sliding: str, meaning: str, symbol: str, default: Any = MISSING, **more: Any) -> Any:
    """A field of an element; the rest as of :class:`Key`. Without a default a file must state it."""
    return field(default=default, metadata={"key": Key(unit, sliding, meaning, symbol, **more)})


@dataclass(frozen=True)
class AxisElement:
    """An element of one joint axis, to be inherited. Forces are N·m, of slides N; they act against the coordinate.

    ``KIND``: the key of a robot file; ``WORDS``: what it is called in comments; ``FORMULA``: the force in LaTeX;
    ``RATE``: that of its state, if it has one.
    """

    KIND: ClassVar[str]
    WORDS: ClassVar[str]
    FORMULA: ClassVar[str]
    RATE: ClassVar[str]

    @staticmethod
    def force(t: Any, x: Value, w: Value, *values: Value) -> Value:
        """The force at coordinate ``x`` and rate ``w``, with the ``values`` of the keys in their order."""
        raise NotImplementedError

    @staticmethod
    def energy(t: Any, x: Value, *values: Value) -> Value:
        """The potential, J; none by default."""
        return 0.0

    secant: ClassVar[Callable[..., Secant] | None] = None
    """``(t, x, w, there, h, *values)``: what implicit methods take, see :class:`.law.Law`; None: the tangents,
    where the force falls without its part of the accelerations."""

    state: ClassVar[Key | None] = None
    """Unit and meaning of a state of first order that it has on its axis, as friction that remembers; None: none."""
    bristle: ClassVar[Callable[..., Bristle] | None] = None
    """``(t, x, w, z, *values)``: of an element with a state z, in place of a force; see :class:`.law.Bristle`."""

    @classmethod
    @cache
    def table(cls) -> Mapping[str, Key]:
        """The keys by name."""
        return {one.name: one.metadata["key"] for one in fields(cls)}

    @classmethod
    def equations(cls) -> str:
        """Its section of text in documents."""
        symbols = ", ".join(f"{one.meaning} ${one.symbol}$" for one in cls.table().values())
        taken = rf"\tau_q &\leftarrow \tau_q - \tau_e, & \quad \tau_e &= {cls.FORMULA}"
        if cls.state is not None:
            letter = cls.state.symbol
            taken += rf", & \quad \dot{{{letter}}} &= {cls.RATE}"
            symbols = f"the internal state ${letter}$, {cls.state.meaning}, and {symbols}"
        return f"From what acts on an axis with {cls.WORDS} their force is taken,\n\n$$\n{taken}\n$$\n\nwith {symbols}."

    @property
    def values(self) -> tuple[float, ...]:
        """Their values."""
        return tuple(getattr(self, name) for name in self.table())


@dataclass(frozen=True)
class ElementLaw:
    """The law of a kind of element."""

    kind: type[AxisElement]
    positional: bool = True
    beside: ClassVar[bool] = False

    @property
    def name(self) -> str:
        return self.kind.KIND

    @property
    def words(self) -> str:
        return self.kind.WORDS

    @property
    def table(self) -> Mapping[str, Key]:
        return {column(self.kind, name): own for name, own in self.kind.table().items()}

    @property
    def constants(self) -> tuple[str, ...]:
        return tuple(self.table)

    @property
    def notes(self) -> tuple[str, str]:
        return "", ""

    def prepared(self, *numbers: Value) -> tuple[Value, ...]:
        return numbers

    def force(self, t: Any, side: Value, x: Value, w: Value, *constants: Value) -> Value:
        return self.kind.force(t, x, w, *constants)

    def energy(self, t: Any, side: Value, x: Value, *constants: Value) -> Value:
        """Twice the potential."""
        return 2.0 * self.kind.energy(t, x, *constants)

    @property
    def secant(self) -> Callable[..., Secant] | None:
        own = self.kind.secant
        return None if own is None else lambda t, side, *rest: own(t, *rest)

    @property
    def bristle(self) -> Callable[..., Bristle] | None:
        own = self.kind.bristle
        return None if own is None else lambda t, side, *rest: own(t, *rest)

    @property
    def state(self) -> Key | None:
        return self.kind.state

    @property
    def state_name(self) -> str:
        return f"{self.kind.KIND}_state"


PREFIX = "element_"


def column(kind: type[AxisElement], name: str) -> str:
    """The robot's column that holds a key of all elements of a kind."""
    return f"{PREFIX}{kind.KIND}_{name}"
