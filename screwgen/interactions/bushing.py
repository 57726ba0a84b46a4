"""A bushing: springs and dampers in all six directions, along and about the axes of the first frame.

Both frames coincide where it is relaxed. With the displacement ``d`` and the turn ``2 e``, of the unit quaternion
``(h, e)`` of the second frame in the first, its potential is ``(dᵀ K d + 4 eᵀ K_t e)/2``: for small turns that of the
rotation vector. It is meant for turns well below half of one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .interaction import Interaction, Relative, Value, Vector, Wrench, number
from .vectors import cross

AXES = ("along x", "along y", "along z", "about x", "about y", "about z")


@dataclass(frozen=True)
class Bushing(Interaction):
    """A spring and a damper in each of six directions."""

    KIND = "bushing"
    WORDS = "bushings"

    stiffness: tuple[float, ...] = number(
        "N/m, N·m/rad", "stiffness", "K", sign="non-negative", least=1e-9, most=1e18, entries=AXES
    )
    damping: tuple[float, ...] | None = number(
        "N·s/m, N·m·s/rad", "damping", "C", default=None, sign="non-negative", least=1e-12, most=1e18, entries=AXES
    )

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> Wrench:
        K, C = keys["stiffness"], keys["damping"]
        h, e = _quaternion(t, x)
        stressed = [K[3 + k] * e[k] for k in range(3)]
        across = cross(e, stressed)
        force = [-(K[k] * x.d[k] + C[k] * x.v[k]) for k in range(3)]
        torque = [-(2.0 * (h * stressed[k] + across[k]) + C[3 + k] * x.omega[k]) for k in range(3)]
        return Wrench(torque, force)

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        K, (_, e) = keys["stiffness"], _quaternion(t, x)
        along = sum(K[k] * (x.d[k] * x.d[k]) for k in range(3))
        return 0.5 * along + 2.0 * sum(K[3 + k] * (e[k] * e[k]) for k in range(3))


def _quaternion(t: Any, x: Relative) -> tuple[Value, Vector]:
    """The unit quaternion of the second frame in the first, of turns below half of one."""
    R = x.R
    h = t.named("half_cosine", 0.5 * t.call("sqrt", 1.0 + R[0][0] + R[1][1] + R[2][2]))
    quarter = 0.25 / h
    return h, [quarter * (R[b][a] - R[a][b]) for a, b in ((1, 2), (2, 0), (0, 1))]
