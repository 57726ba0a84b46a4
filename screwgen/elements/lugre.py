"""Dry friction that remembers: bristles that bend before they slip, the model called LuGre.

Two bodies that rub touch by bristles, whose mean deflection is z. At a rate w they bend by ``zdot = w - σ |w| z / g``,
and exert ``F = σ z + d zdot``. While both stick this is a spring of the stiffness σ with a damper d. Where they slip
at a steady rate, ``zdot = 0`` and ``F = g sign w``: Coulomb's friction g, which may fall with the rate by Stribeck's
curve ``g = F_c + (F_s - F_c) exp(-(w/w_s)²)``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from .friction import PLAIN, SIZE_SYMBOL, Size, unstated, written_size
from .law import Bristle, Key, Value


@dataclass(frozen=True)
class BristleFriction:
    """The law, called LuGre's, of friction of a size that may fall with the rate or grow with load. Its state is z."""

    size: Size = PLAIN

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
        return f"bristles{self.size.suffix}"

    @property
    def table(self) -> Mapping[str, Key]:
        """In columns of its own name, for both may stand in one robot."""
        stiffness = Key("N·m/rad", "N/m", "stiffness of the bristles of friction", "\\sigma_0", "positive")
        damping = Key("N·m·s/rad", "N·s/m", "damping of these bristles", "\\sigma_1", "non-negative")
        keys = {"stiffness": stiffness, "damping": damping}
        keys |= {"coulomb": Key("N·m", "N", "dry friction while they slip", "c", "positive")} | dict(self.size.keys)
        return {f"{self.name}_{key}": own for key, own in keys.items()}

    @property
    def constants(self) -> tuple[str, ...]:
        return tuple(self.table)

    def prepared(self, *numbers: Value) -> tuple[Value, ...]:
        return *numbers[:3], *self.size.prepared(*numbers[3:])

    def force(self, t: Any, side: Value, x: Value, w: Value, *constants: Value) -> Value:
        """It has `bristle` in its place."""
        raise NotImplementedError

    def bristle(self, t: Any, side: Value, x: Value, w: Value, z: Value, *constants: Value) -> Bristle:
        axis, (stiffness, damping, *size) = constants[: self.beside], constants[self.beside :]
        rate = t.named("speed", w * (t.call("on", w) - t.call("on", -w)))
        return Bristle(
            stiffness, damping, 1.0, t.named("decay", stiffness * rate / self.size.at(t, x, w, *axis, *size))
        )

    def energy(self, t: Any, side: Value, x: Value, *constants: Value) -> Value:
        """None of the coordinate; that of the bristles is theirs."""
        return 0.0


LETTERS = {"memory.stiffness": r"\sigma_0", "memory.damping": r"\sigma_1"}
"""The letters of the keys of this friction in formulas."""

SYMBOLS = (
    (r"z", "mean deflection of the bristles of friction, an internal state, of slides in m", "rad", True),
    (r"\sigma_0, \sigma_1", "stiffness and damping of these bristles", "N*m/rad, N*m*s/rad", False),
    SIZE_SYMBOL,
)
"""Symbol, meaning, unit of what documents name, and whether it is a state."""


def equations(size: Size, bends: bool) -> str:
    """Its section in documents; ``size``: of any of it; ``bends``: whether any friction does."""
    text = EQUATIONS.replace("BEND", r" + \frac{c_b\,w}{\sqrt{w^2 + v_b^2}}" * bends)
    return text.replace("SIZE", written_size(size)) + f"{unstated(size).lstrip()}. " * size.falls + STORED


EQUATIONS = (
    r"""
Dry friction with $\sigma_0$ remembers. Between both bodies stand bristles, whose mean deflection $z$ is an internal
state, of first order. Of such a drive $\tau_f$ is not that above, but with the same rate $w$

$$
\tau_f &= b\,w + \sigma_0\,z + \sigma_1\,\dot{z}BEND, & \quad \dot{z} &= w -"""
    r""" \frac{\sigma_0\,\left| w \right|}{F_w}\,z, & \quad F_w &= SIZE
$$

"""
)
STORED = r"""While the bodies stick this is a spring with a damper. Where they slip at a steady rate, $\dot{z} = 0$ and
the dry part is $F_w$ against the motion. The potential $\sigma_0\,z^2/2$ is stored.
"""
