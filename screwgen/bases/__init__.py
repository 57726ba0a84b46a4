"""Bases: the shapes in which a link bends, stretches and twists.

A basis is data: functions psi on s in [0, 1], orthonormal there, with diagonal stiffness, closed-form
integrals, tip value and tip slope, all dimensionless. A robot file names the *bending* shapes; stretching and
torsion always use sines.

A further basis is one more small file with a function ``count -> Shapes`` and one more line in
`BENDING_BASES`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from screwgen.bases.clamped_free import clamped_free
from screwgen.bases.polynomial import polynomial
from screwgen.bases.shapes import Family, Shapes, products
from screwgen.bases.sine import sine

__all__ = ["BENDING_BASES", "Family", "Shapes", "axial", "bending", "products"]

BENDING_BASES: dict[str, Callable[[int], Shapes]] = {
    "clamped_free": clamped_free,
    "polynomial": polynomial,
}


@cache
def bending(name: str, count: int) -> Shapes:
    """The `count` bending modes of the basis called `name`; no mode at all is allowed.

    Raises ValueError for an unknown name or a negative count.
    """
    if name not in BENDING_BASES:
        raise ValueError(f"unknown bending basis {name!r}: choose one of {', '.join(sorted(BENDING_BASES))}")
    return BENDING_BASES[name](_checked(count))


@cache
def axial(count: int) -> Shapes:
    """The first `count` modes of stretching, which are those of torsion too.

    Raises ValueError for a negative count.
    """
    return sine(_checked(count))


def _checked(count: int) -> int:
    if count < 0:
        raise ValueError(f"the number of modes must not be negative, got {count}")
    return count
