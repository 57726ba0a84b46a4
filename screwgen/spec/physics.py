"""Physical consistency of related numbers: the axes of one joint, the inertia of one body."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from .ranges import several
from .screw import Screw
from .values import Path, array, numbers, refuse, shown

Vector = tuple[float, float, float]

LETTERS: dict[str, Vector] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}

MAX_AXES = 3
PARALLEL = 1e-6  # sine of the angle below which two axes count as parallel
UNIT = 4 * 2.0**-52  # a vector this near to unit length stays as it is, so that dump and load agree
ROUNDING = 1e-6  # of the trace: what the printed digits of an inertia may miss


def axes(value: Any) -> tuple[Vector | Screw, ...]:
    """At most three unit vectors or screws, none parallel to the one before it."""
    stated = array(value, 'an array of axes, as ["y", "z"]')
    if len(stated) > MAX_AXES:
        raise refuse(f"has {len(stated)} axes; at most {MAX_AXES} are allowed")
    units = tuple(axis(entry, at=(i,)) for i, entry in enumerate(stated))
    for i in range(1, len(units)):
        if parallel(units[i - 1], units[i]):
            raise refuse("is parallel to the axis before it; the two must differ in direction", at=(i,))
    return units


def parallel(a: Vector | Screw, b: Vector | Screw) -> bool:
    """Whether two motions are the same but for their size."""
    first, second = (x if isinstance(x, Screw) else Screw(x) for x in (a, b))
    alike = first.turn == second.turn and (first.travel == second.travel or not first.turn)
    return alike and math.hypot(*cross(first.axis, second.axis)) < PARALLEL


def axis(value: Any, *, at: Path) -> Vector | Screw:
    """A letter or a vector, as the unit vector that it stands for; a screw with its axis at length 1."""
    if isinstance(value, Screw):
        return replace(value, axis=unit(numbers(value.axis, 3, at=at), at=at))
    if isinstance(value, str):
        if value not in LETTERS:
            raise refuse(f'is {shown(value)}; it must be "x", "y", "z" or an array of 3 numbers', at)
        return LETTERS[value]
    return unit(numbers(value, 3, at=at), at=at)


def unit(a: Sequence[float], *, at: Path) -> Vector:
    """`a`, normalised."""
    largest = max(map(abs, a))
    if largest == 0:
        raise refuse("is the zero vector; an axis needs a direction", at)
    x, y, z = a
    if abs(math.hypot(*a) - 1) <= UNIT:
        return x, y, z
    length = math.hypot(x / largest, y / largest, z / largest)
    return x / largest / length, y / largest / length, z / largest / length


def cross(a: Vector, b: Vector) -> Vector:
    """a × b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def inertia(value: Any) -> tuple[float, ...]:
    """[xx, yy, zz, xy, xz, yz] of a tensor that some body has (kg·m²); products are the tensor's entries."""
    entries = several("inertia", 6)(value)
    if not some_body_has(entries):
        raise refuse(
            "is an inertia that no body has; no principal moment may be negative, nor exceed the sum of the other two"
        )
    return entries


def some_body_has(entries: tuple[float, ...]) -> bool:
    """Whether ∫ r rᵀ dm = ½ tr(I) 1 − I is positive semidefinite, up to rounding.

    That is the same as: principal moments are non-negative and obey the triangle inequality.
    """
    largest = max(map(abs, entries))
    if largest == 0:
        return True
    xx, yy, zz, xy, xz, yz = (x / largest for x in entries)
    trace = xx + yy + zz
    half = trace * (0.5 + ROUNDING)
    return trace > 0 and definite(half - xx, half - yy, half - zz, -xy, -xz, -yz)


def definite(xx: float, yy: float, zz: float, xy: float, xz: float, yz: float) -> bool:
    """Whether a symmetric 3×3 matrix is positive definite: its leading minors are positive (Sylvester)."""
    minor = xx * yy - xy * xy
    determinant = zz * minor - xx * yz * yz - yy * xz * xz + 2 * xy * xz * yz
    return xx > 0 and minor > 0 and determinant > 0
