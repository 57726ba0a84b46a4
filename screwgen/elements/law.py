"""The contract of a force on single coordinates that is not linear.

An example: dry friction ``F = c w / sqrt(w² + s²)`` at a rate w. Three things are needed of it. The dynamics need F.
An implicit method takes it as the damping ``c / sqrt(w² + s²)`` at the rates of a stage, times the rate after the
step. The derivative of that step needs the slopes of both. A law states the first two, or the first alone; the rest is
derived, and every back end replays or prints it: :mod:`..algorithms.law_programs`.

A law computes with values of any kind. Of the tracer ``t`` it uses ``t.call(name, x)`` for functions, ``sqrt``,
``sin``, ``atan2`` of two, ``on`` (1 where x > 0, else 0), and ``t.named(name, x)``, which names a value in generated
code.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from typing import Any, NamedTuple, Protocol

Value = Any


class Key(NamedTuple):
    """A number that an element states: its unit on an axis that turns and on one that slides, meaning and range.

    ``symbol``: as the element's formula has it. The number is 0 or of a size between ``least`` and ``most``; ``sign``:
    ``positive``, ``non-negative`` or ``any``.
    """

    unit: str
    sliding: str
    meaning: str
    symbol: str
    sign: str = "any"
    least: float = 0.0
    most: float = 1e18


class Secant(NamedTuple):
    """A law as the linear force ``stiffness (x - rest) + damping w + constant`` over a step."""

    stiffness: Any
    damping: Any
    rest: Any
    constant: Any = 0.0


class Bristle(NamedTuple):
    """A state of first order z that a law remembers, ``zdot = gain w - decay z``, and its force
    ``stiffness z + damping zdot``.

    An example: bristles between two bodies that stick. They bend as these move, and stop bending where they slip. Over
    a step of length h they are taken at its end, ``(z + h gain w) / (1 + h decay)``, which is linear in the rate w.
    ``sticks``: the gain while nothing slips; the energy ``stiffness z² / (2 sticks)`` is stored.
    """

    stiffness: Any
    damping: Any
    gain: Any
    decay: Any
    sticks: Any = 1.0


class Law(Hashable, Protocol):
    """A kind of force on single coordinates, on the left of the equations of motion.

    ``side``: +1 or -1, which of two ends it acts at; ``x``, ``w``: the coordinate (rad or m) and its rate.
    """

    @property
    def name(self) -> str:
        """A word for generated code."""

    @property
    def words(self) -> str:
        """What it is called in comments."""

    @property
    def constants(self) -> tuple[str, ...]:
        """The robot's columns that hold its constants, one entry for each coordinate: the names of ``table``."""

    @property
    def table(self) -> Mapping[str, Key]:
        """Unit, meaning and sign of each of them."""

    @property
    def notes(self) -> tuple[str, str]:
        """What comments say of how a step takes it, at length and in short; empty where it is the tangents."""

    @property
    def beside(self) -> bool:
        """Whether it depends besides on the axis that drives its coordinate, a rotor's by an elastic gear.

        The coordinate of that axis then stands before the constants.
        """

    @property
    def positional(self) -> bool:
        """Whether it depends on the coordinate, not on the rate alone."""

    def prepared(self, *numbers: Value) -> tuple[Value, ...]:
        """The constants out of the numbers of a robot file."""

    def force(self, t: Any, side: Value, x: Value, w: Value, *constants: Value) -> Value:
        """The force in a state; of a law with a `bristle` that has it."""

    def energy(self, t: Any, side: Value, x: Value, *constants: Value) -> Value:
        """Twice the potential, J; 0 where there is none."""

    @property
    def secant(self) -> Callable[..., Secant] | None:
        """``(t, side, x, w, there, h, *constants)``: what implicit methods take ``h`` after ``x`` and ``w``.

        ``there``: the rate at the stage. None: the tangents in the state.
        """

    @property
    def bristle(self) -> Callable[..., Bristle] | None:
        """``(t, side, x, w, z, *constants)``: the state that it has on every coordinate, in place of a force; None:
        it has none."""

    @property
    def state(self) -> Key | None:
        """Unit and meaning of that state."""

    @property
    def state_name(self) -> str:
        """What stands behind the link in its name, as in `arm.friction_state[0]`."""
