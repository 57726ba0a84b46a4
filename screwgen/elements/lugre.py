"""Dry friction that remembers: bristles that bend before they slip, the model called LuGre.

Two bodies that rub touch by bristles, whose mean deflection is z. At a rate w they bend by ``zdot = w - σ |w| z / g``,
and exert ``F = σ z + d zdot``. While both stick this is a spring of the stiffness σ with a damper d. Where they slip
at a steady rate, ``zdot = 0`` and ``F = g sign w``: Coulomb's friction g, which may fall with the rate by Stribeck's
curve ``g = F_c + (F_s - F_c) exp(-(w/w_s)²)``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from .friction import PLAIN, SIZE_SYMBOL, Size, unstated, written_size
from .law import Bristle, Key, Value

Z = (r"z", "mean deflection of the bristles of friction, an internal state, of slides in m", "rad", True)
"""The symbol of the state in documents."""


@dataclass(frozen=True)
class BristleFriction:
    """The law, called LuGre's, of friction of a size that may fall with the rate or grow with load. Its state is z."""

    size: Size = PLAIN

    KIND: ClassVar[str] = "bristles"
    """What its columns are called."""
    KEYS: ClassVar[Mapping[str, Key]] = {
        "stiffness": Key(
            *("N·m/rad", "N/m", "stiffness of the bristles of friction", "\\sigma_0", "positive"), least=1e-9, most=1e24
        ),
        "damping": Key("N·m·s/rad", "N·s/m", "damping of these bristles", "\\sigma_1", "non-negative", least=1e-12),
    }
    """The keys of its table of ``friction``; what is left out is zero."""
    SYMBOLS: ClassVar[tuple[tuple[str, str, str, bool], ...]] = (
        Z,
        (r"\sigma_0, \sigma_1", "stiffness and damping of these bristles", "N*m/rad, N*m*s/rad", False),
        SIZE_SYMBOL,
    )
    """Symbol, meaning, unit of what documents name, and whether it is a state."""
    FORCE: ClassVar[str] = r"\sigma_0\,z + \sigma_1\,\dot{z}"
    RATE: ClassVar[str] = r"w - \frac{\sigma_0\,\left| w \right|}{F_w}\,z"
    SAID: ClassVar[str] = r"""While the bodies stick this is a spring with a damper. Where they slip at a steady rate,
$\dot{z} = 0$ and the dry part is $F_w$ against the motion. The potential $\sigma_0\,z^2/2$ is stored.
"""
    """What documents say of that force and of the rate of z."""
    words: ClassVar[str] = "friction of bristles"
    notes: ClassVar[tuple[str, str]] = (
        'Bristles are taken at the end of the step, where they slip at the rates "there".',
        'Bristles slip at the rates "there".',
    )
    positional: ClassVar[bool] = False
    secant: ClassVar[None] = None
    state: ClassVar[Key] = Key("rad", "m", "deflection of the bristles of friction", "z")
    state_name: ClassVar[str] = "friction_state"

    @property
    def beside(self) -> bool:
        return self.size.loaded

    @property
    def name(self) -> str:
        return f"{self.KIND}{self.size.suffix}"

    @property
    def table(self) -> Mapping[str, Key]:
        """In columns of its own name, for several may stand in one robot."""
        coulomb = Key("N·m", "N", "dry friction while they slip", "c", "positive")
        return {f"{self.name}_{key}": own for key, own in {**self.KEYS, "coulomb": coulomb, **self.size.keys}.items()}

    @property
    def constants(self) -> tuple[str, ...]:
        return tuple(self.table)

    def prepared(self, *numbers: Value) -> tuple[Value, ...]:
        first = len(self.KEYS) + 1
        return *numbers[:first], *self.size.prepared(*numbers[first:])

    def force(self, t: Any, side: Value, x: Value, w: Value, *constants: Value) -> Value:
        """It has `bristle` in its place."""
        raise NotImplementedError

    def bristle(self, t: Any, side: Value, x: Value, w: Value, z: Value, *constants: Value) -> Bristle:
        axis, own, first = constants[: self.beside], constants[self.beside :], len(self.KEYS)
        speed = t.named("speed", w * (t.call("on", w) - t.call("on", -w)))
        return self.bent(t, w, z, speed, lambda: self.size.at(t, x, w, *axis, *own[first:]), *own[:first])

    @staticmethod
    def bent(t: Any, w: Value, z: Value, speed: Value, size: Callable[[], Value], *values: Value) -> Bristle:
        """How they act at the rate ``w``, of this ``speed``, where they slip with F_w, which ``size`` finds."""
        stiffness, damping = values
        return Bristle(stiffness, damping, 1.0, t.named("decay", stiffness * speed / size()))

    def energy(self, t: Any, side: Value, x: Value, *constants: Value) -> Value:
        """None of the coordinate; that of the bristles is theirs."""
        return 0.0

    @classmethod
    def equations(cls, size: Size, bends: bool) -> str:
        """Its section in documents; ``size``: of any of it; ``bends``: whether any friction does."""
        text = EQUATIONS.replace("BEND", r" + \frac{c_b\,w}{\sqrt{w^2 + v_b^2}}" * bends).replace("RATE", cls.RATE)
        text = text.replace("FORCE", cls.FORCE).replace("STIFFNESS", cls.KEYS["stiffness"].symbol)
        return text.replace("SIZE", written_size(size)) + f"{unstated(size).lstrip()}. " * size.falls + cls.SAID


EQUATIONS = r"""
Dry friction with $STIFFNESS$ remembers. Between both bodies stand bristles, whose mean deflection $z$ is an internal
state, of first order. Of such a drive $\tau_f$ is not that above, but with the same rate $w$

$$
\tau_f &= b\,w + FORCEBEND, & \quad \dot{z} &= RATE, & \quad F_w &= SIZE
$$

"""
