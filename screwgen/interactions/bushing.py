"""A bushing: springs and dampers in all six directions, along and about the axes of the first frame.

Both frames coincide where it is relaxed. With the displacement ``d`` and the turn ``2 e``, of the unit quaternion
``(h, e)`` of the second frame in the first, its potential is ``(dᵀ K d + 4 eᵀ K_t e)/2``: for small turns that of the
rotation vector. It is meant for turns well below half of one.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

from .interaction import (
    FORCE,
    POTENTIAL,
    TORQUE,
    Interaction,
    LawEquation,
    Relative,
    Value,
    Vector,
    WrenchOnSecond,
    number,
)
from .vectors import cross

AXES = ("along x", "along y", "along z", "about x", "about y", "about z")


@dataclass(frozen=True)
class Bushing(Interaction):
    """A spring and a damper in each of six directions."""

    KIND = "bushing"
    WORDS = "bushings"

    stiffness: tuple[float, ...] = number(
        "N/m, N·m/rad", "stiffness", r"\mathbf{k}_b", sign="non-negative", least=1e-9, most=1e18, entries=AXES
    )
    damping: tuple[float, ...] | None = number(
        "N·s/m, N·m·s/rad",
        "damping",
        r"\mathbf{c}_b",
        default=None,
        sign="non-negative",
        least=1e-12,
        most=1e18,
        entries=AXES,
    )

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> WrenchOnSecond:
        K, C = keys["stiffness"], keys["damping"]
        h, e = _quaternion(t, x)
        stressed = [K[3 + k] * e[k] for k in range(3)]
        across = cross(e, stressed)
        force = [-(K[k] * x.d[k] + C[k] * x.v[k]) for k in range(3)]
        torque = [-(2.0 * (h * stressed[k] + across[k]) + C[3 + k] * x.omega[k]) for k in range(3)]
        return WrenchOnSecond(torque, force)

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        K, (_, e) = keys["stiffness"], _quaternion(t, x)
        along = sum(K[k] * (x.d[k] * x.d[k]) for k in range(3))
        return 0.5 * along + 2.0 * sum(K[3 + k] * (e[k] * e[k]) for k in range(3))

    @staticmethod
    def equations(has: Collection[str]) -> tuple[LawEquation, ...]:
        damped = "damping" in has
        return (
            LawEquation(
                r"[\mathbf{k}_{b,F};\ \mathbf{k}_{b,\tau}]", r"\mathbf{k}_b", "N/m, N*m/rad", "stiffness by axes of A"
            ),
            *[
                LawEquation(
                    r"[\mathbf{c}_{b,F};\ \mathbf{c}_{b,\tau}]",
                    r"\mathbf{c}_b",
                    "N*s/m, N*m*s/rad",
                    "damping by axes of A",
                )
            ]
            * damped,
            LawEquation("h", _COSINE, "-", "cosine of half the turn of B relative to A"),
            LawEquation(r"\mathbf{e}_{AB}", _SINES, "-", "axis of that turn times the sine of its half"),
            LawEquation(
                r"\mathbf{m}_{AB}",
                r"\mathrm{diag}(\mathbf{k}_{b,\tau})\,\mathbf{e}_{AB}",
                "N*m",
                "stiffness about the axes times $\\mathbf{e}_{AB}$",
            ),
            LawEquation(TORQUE, _MOMENT + r" - \mathrm{diag}(\mathbf{c}_{b,\tau})\,\boldsymbol{\omega}_{AB}" * damped),
            LawEquation(FORCE, _LOAD + r" - \mathrm{diag}(\mathbf{c}_{b,F})\,\mathbf{v}_{AB}" * damped),
            LawEquation(POTENTIAL, _STORED),
        )


_COSINE = r"\tfrac{1}{2}\,\sqrt{1 + \operatorname{tr}(\mathbf{R}_{AB})}"
_SINES = (
    r"\frac{1}{4\,h}\,\begin{bmatrix} R_{AB,zy} - R_{AB,yz} \\ R_{AB,xz} - R_{AB,zx} \\ R_{AB,yx} - R_{AB,xy}"
    r" \end{bmatrix}"
)
_MOMENT = r"-2\,\left( h\,\mathbf{m}_{AB} + \mathbf{e}_{AB} \times \mathbf{m}_{AB} \right)"
_LOAD = r"-\mathrm{diag}(\mathbf{k}_{b,F})\,\mathbf{d}_{AB}"
_STORED = (
    r"\tfrac{1}{2}\,\mathbf{d}_{AB}^{\top}\,\mathrm{diag}(\mathbf{k}_{b,F})\,\mathbf{d}_{AB}"
    r" + 2\,\mathbf{e}_{AB}^{\top}\,\mathbf{m}_{AB}"
)


def _quaternion(t: Any, x: Relative) -> tuple[Value, Vector]:
    """The unit quaternion of the second frame in the first, of turns below half of one."""
    R = x.R
    h = t.named("half_cosine", 0.5 * t.call("sqrt", 1.0 + R[0][0] + R[1][1] + R[2][2]))
    quarter = 0.25 / h
    return h, [quarter * (R[b][a] - R[a][b]) for a, b in ((1, 2), (2, 0), (0, 1))]
