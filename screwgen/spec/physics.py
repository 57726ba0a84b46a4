"""Physical consistency of related numbers: the inertia of one body."""

from typing import Any

from .ranges import several
from .values import refuse

ROUNDING = 1e-6  # of the trace: what the printed digits of an inertia may miss


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
