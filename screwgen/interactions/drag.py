"""Drag: what a fluid at rest in the second frame does to the first frame's point that moves through it.

At the velocity ``u`` of the first origin relative to the second frame, in the first's axes, the first frame feels
``-(c_k u_k + b |u| u_k)`` along each of its axes; ``b`` is half of density, area and drag coefficient multiplied.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

from .interaction import FORCE, TORQUE, Interaction, LawEquation, Relative, WrenchOnSecond, number
from .vectors import cross, dot

SLOWEST = 1e-24
"""(m/s)²: added to the square of the speed, which has no slope at rest."""


@dataclass(frozen=True)
class Drag(Interaction):
    """Linear and quadratic drag on the first frame, relative to the second."""

    KIND = "drag"
    WORDS = "drag"

    linear: tuple[float, ...] | None = number(
        *("N·s/m", "linear drag", r"\mathbf{c}_d"),
        default=None,
        sign="non-negative",
        least=1e-12,
        most=1e18,
        entries=("along x", "along y", "along z"),
    )
    quadratic: float | None = number(
        "N·s²/m²", "quadratic drag", "b_d", default=None, sign="non-negative", least=1e-12, most=1e18
    )

    @property
    def fault(self) -> tuple[str, str] | None:
        return ("", "states no drag; state linear or quadratic") if not self.numbers else None

    @staticmethod
    def drawn(has: Collection[str]) -> str:
        return "none"

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> WrenchOnSecond:
        u = [a - b for a, b in zip(cross(x.omega, x.d), x.v, strict=True)]
        speed = t.call("sqrt", dot(u, u) + SLOWEST)
        force = [(keys["linear"][k] + keys["quadratic"] * speed) * u[k] for k in range(3)]
        # the opposite acts on the first frame at its origin, which is -d from the second
        return WrenchOnSecond(cross(force, x.d), force)

    @staticmethod
    def equations(has: Collection[str]) -> tuple[LawEquation, ...]:
        u, force = r"\mathbf{u}_{AB}", []
        force += [rf"\mathrm{{diag}}(\mathbf{{c}}_d)\,{u}"] * ("linear" in has)
        force += [rf"b_d\,u_d\,{u}"] * ("quadratic" in has)
        speed = LawEquation("u_d", rf"\sqrt{{{u}^{{\top}}\,{u} + \varepsilon}}", "m/s", "its size")
        return (
            LawEquation(
                u,
                r"\boldsymbol{\omega}_{AB} \times \mathbf{d}_{AB} - \mathbf{v}_{AB}",
                "m/s",
                "velocity of point A in the fluid that rests in B, in axes of A",
            ),
            *[LawEquation.smallest(SLOWEST, "m^2/s^2", "the slope of the speed at rest"), speed] * ("quadratic" in has),
            LawEquation(FORCE, " + ".join(force) or r"\mathbf{0}"),
            LawEquation(TORQUE, r"\mathbf{F}_{AB} \times \mathbf{d}_{AB}"),
        )
