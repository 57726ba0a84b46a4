"""The polynomial of order 5 between two points with given values, slopes and curvatures."""

from __future__ import annotations

from typing import Any


def coefficients(q0: Any, q1: Any, v0: Any, v1: Any, a0: Any, a1: Any) -> list[Any]:
    """Of powers of the share of the way, from 0 on; slopes and curvatures by this share."""
    d = q1 - q0
    return [
        q0,
        v0,
        a0 / 2,
        10 * d - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
        -15 * d + 8 * v0 + 7 * v1 + 1.5 * a0 - a1,
        6 * d - 3 * (v0 + v1) - 0.5 * (a0 - a1),
    ]


def hermite(q0: Any, q1: Any, v0: Any, v1: Any, a0: Any, a1: Any, s: Any) -> Any:
    """Its value at a share."""
    return sum(c * s**power for power, c in enumerate(coefficients(q0, q1, v0, v1, a0, a1)))


def slope(q0: Any, q1: Any, v0: Any, v1: Any, a0: Any, a1: Any, s: Any) -> Any:
    """Its slope at a share, by the share."""
    return sum(n * c * s ** (n - 1) for n, c in enumerate(coefficients(q0, q1, v0, v1, a0, a1)) if n)
