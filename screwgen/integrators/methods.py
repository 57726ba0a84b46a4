"""The time steps of the joint form: functions of accelerations, on anything that has +, − and ×.

NumPy arrays and CasADi's symbols go through the same lines. The torques and external wrenches are held over a step.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

Motion = tuple[Any, Any]
"""Coordinates (nq,) and rates (nq,)."""


class Accelerations(Protocol):
    """`vdot` (nq,) while torques and external wrenches are held."""

    def explicit(self, q: Any, v: Any) -> Any:
        """That at `q, v`."""

    def implicit(self, q: Any, v: Any, h: Any, there: Motion | None = None) -> Any:
        """That with the elastic forces that it leads to `h` after `q, v`; all else is that at `there`."""


Method = Callable[[Accelerations, Any, Any, Any], Motion]


def euler(a: Accelerations, q: Any, v: Any, h: Any) -> Motion:
    """Forward Euler, order 1: amplifies every undamped mode; for comparison."""
    return q + h * v, v + h * a.explicit(q, v)


def semi_implicit(a: Accelerations, q: Any, v: Any, h: Any) -> Motion:
    """Symplectic Euler, order 1: rates first, coordinates with the new rates; stable below 2 / omega_max."""
    new = v + h * a.explicit(q, v)
    return q + h * new, new


def modal_implicit(a: Accelerations, q: Any, v: Any, h: Any) -> Motion:
    """Symplectic Euler with the forces of modes, joint springs and dampers at the step's end, order 1.

    Stable for any stiffness and damping of these; damps what is stiff. The rest is taken at the step's start: where
    joints turn at a rate r, slow swings gain up to about h r² / 2 per second. Steps should turn joints by some 0.02 rad
    at most.
    """
    new = v + h * a.implicit(q, v, h)
    return q + h * new, new


def modal_midpoint(a: Accelerations, q: Any, v: Any, h: Any) -> Motion:
    """The midpoint rule with the forces of modes, joint springs and dampers implicit, order 2.

    Stable for any stiffness and damping of these; damps nothing that has no damper. The rest is taken in the middle of
    the step, as the start predicts it: turning, weight and torques must change little over a step.
    """
    middle = v + h / 2 * a.implicit(q, v, h / 2)
    new = v + h * a.implicit(q, v, h / 2, (q + h / 2 * middle, middle))
    return q + h / 2 * (v + new), new


def rk4(a: Accelerations, q: Any, v: Any, h: Any) -> Motion:
    """The classical Runge-Kutta method, order 4; stable below 2.8 / omega_max."""
    k1 = a.explicit(q, v)
    v2 = v + h / 2 * k1
    k2 = a.explicit(q + h / 2 * v, v2)
    v3 = v + h / 2 * k2
    k3 = a.explicit(q + h / 2 * v2, v3)
    v4 = v + h * k3
    k4 = a.explicit(q + h * v3, v4)
    return q + h / 6 * (v + 2 * v2 + 2 * v3 + v4), v + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


METHODS: dict[str, Method] = {
    "euler": euler,
    "semi_implicit": semi_implicit,
    "modal_implicit": modal_implicit,
    "modal_midpoint": modal_midpoint,
    "rk4": rk4,
}
