"""Bases: mode shapes of bending, stretching, torsion and shear.

A basis is data: functions psi on s in [0, 1], orthonormal there, with diagonal stiffness, closed-form
integrals, tip value and tip slope, all dimensionless. It has shapes of two orders: 2 for bending, where curvature
stores energy, and 1 for stretching, torsion and shear, where the first derivative does.

A basis is a function ``(count, order) -> Shapes``. Those of the product have names, `BASES`; a function of one's own
may stand wherever a name may.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from .clamped_free import clamped_free
from .polynomial import polynomial
from .shapes import Family, Shapes, integrals, products

__all__ = ["BASES", "DEFAULT", "NATURAL", "ORDER", "Basis", "Family", "Shapes", "integrals", "products", "shapes"]

Basis = Callable[[int, int], Shapes]
"""The shapes of a number of modes, of order 1 or 2."""

BASES: dict[str, Basis] = {
    "polynomial": polynomial,
    "clamped_free": clamped_free,
}

DEFAULT = "polynomial"
"""The basis of a robot file that names none."""

NATURAL = "clamped_free"
"""The basis of the bare link's own modes, to which measured frequencies belong."""

ORDER = {"axial": 1, "bending_y": 2, "bending_z": 2, "torsion": 1, "shear_y": 1, "shear_z": 1}
"""Order of the derivative that stores energy, by direction of deflection, in the order of the modal coordinates."""


def shapes(basis: str | Basis, direction: str, count: int) -> Shapes:
    """The `count` modes of a basis, or of the one of that name, in a direction of `ORDER`; no mode at all is allowed.

    Raises ValueError for an unknown basis, an unknown direction or a negative count.
    """
    if direction not in ORDER:
        raise ValueError(f"unknown direction {direction!r}: choose one of {', '.join(ORDER)}")
    return of_order(basis, ORDER[direction], count)


@cache
def of_order(basis: str | Basis, order: int, count: int) -> Shapes:
    """The `count` modes of a basis of order 1 or 2; made once, so that equal shapes are one object."""
    if isinstance(basis, str) and basis not in BASES:
        raise ValueError(f"unknown basis {basis!r}: choose one of {', '.join(sorted(BASES))}")
    if count < 0:
        raise ValueError(f"the number of modes must not be negative, got {count}")
    return (BASES[basis] if isinstance(basis, str) else basis)(count, order)
