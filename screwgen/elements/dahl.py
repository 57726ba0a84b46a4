"""Bristles that bend as metal does, Dahl's model: with the share ``u = 1 - F/F_w`` of the friction that is left,
``dF/dx = σ u`` where they bend further, and ``dF/dx = σ u²`` of what is ductile.

Dahl writes ``dF/dx = σ u^i``. Of a ductility b it is ``σ u (1 - b + b u)`` here: i = 1 where b = 0, i = 2 where b = 1.
From 0 the first comes within 5 % of F_w over three lengths ``F_w/σ``, the second over nineteen.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from .friction import SIZE_SYMBOL
from .law import Bristle, Key, Value
from .lugre import BristleFriction, Z


class DahlFriction(BristleFriction):
    """The law, which a robot file states as ``dahl`` of ``friction``."""

    KIND = "dahl"
    KEYS: ClassVar = {
        "stiffness": Key("N·m/rad", "N/m", "stiffness of friction that holds", r"\sigma_d", "positive", 1e-9, 1e24),
        "ductility": Key("1", "1", "ductility of this friction", r"\delta_d", "non-negative", 1e-12, 1.0),
    }
    SYMBOLS = (
        Z,
        (r"\sigma_d", "stiffness of these bristles where they are not bent, of slides in N/m", "N*m/rad", False),
        (r"\delta_d", "their ductility, from 0 to 1", "1", False),
        SIZE_SYMBOL,
    )
    FORCE = r"\sigma_d\,z"
    RATE = (
        r"\left( 1 - \delta_d + \delta_d\,\left| 1 - \frac{\sigma_d\,z\,w}{F_w\,\left| w \right|} \right| \right)"
        r"\,\left( w - \frac{\sigma_d\,\left| w \right|}{F_w}\,z \right)"
    )
    SAID = r"""Where the bodies begin to move this is a spring. Where they slip at a steady rate, $\dot{z} = 0$ and
the dry part is $F_w$ against the motion. The potential $\sigma_d\,z^2/2$ is stored.
"""
    words = "Dahl's friction"

    @staticmethod
    def bent(t: Any, w: Value, z: Value, speed: Value, size: Callable[[], Value], *values: Value) -> Bristle:
        stiffness, ductility = values
        on, limit = (lambda value: t.call("on", value)), size()
        left = t.named("left", 1.0 - stiffness * z * (on(w) - on(-w)) / limit)
        share = t.named("share", 1.0 - ductility + ductility * left * (on(left) - on(-left)))
        return Bristle(stiffness, 0.0, share, t.named("decay", share * stiffness * speed / limit))
