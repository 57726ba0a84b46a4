"""How drives and loops share the forces that a motion needs.

An example: a four-bar linkage in the plane has three joints and one freedom. A motion needs torques f (3,) on the axes
of its open tree. Of these its one drive exerts the first, and nothing acts on the two others but the loop, with two
rows: their forces λ follow from ``f_passive = J_passiveᵀ λ``, and the drive's torque is ``f_driven − J_drivenᵀ λ``.

Where passive axes leave λ free in part, it is such that nothing acts on modes, nor on axes behind elastic gears, whose
torque is part of f; and where that leaves it free, such that the efforts are smallest. A motion that the robot cannot
make needs forces where nothing acts: on passive axes none as far as rows can bear them, and little elsewhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np

from ..ir.program import Array, Program, Tracer
from . import matrices as mx
from .loops import COMPLIANCE, LEAST

CHEAP = 1e-4
"""What the square of a force counts on a coordinate of the second rank, beside one of the first; on the third again."""
DOUBLED, REPEATED = 5, 2
"""Doublings of the number of corrections, and corrections behind them for what rounding left. One leaves a small part
of an error, but a half where modes move a loop by a hundredth of what driven axes do."""


class Shared(NamedTuple):
    """What is shared: the generalised forces (nv,) that remain for drives and modes, the forces of the rows of the
    loops, and their wrenches on all tips (6 n,)."""

    force: Sequence
    rows: Sequence
    wrenches: Sequence


@cache
def sharing(ranks: tuple[int, int, int], rows: int, dependent: bool) -> Program:
    """``(J, f) -> (x)``: the forces of the rows; ``ranks``: the numbers of passive axes, of what moves without them,
    and of driven axes.

    ``J`` (rows, coordinates): what a unit force of each row exerts on the coordinates, rank by rank; ``f``: what these
    need; ``dependent``: whether rows may depend on each other, and then share what they bear.
    """
    tracer, size = Tracer(), sum(ranks)
    J, f = mx.array(tracer.input("J", rows * size), (rows, size)), mx.array(tracer.input("f", size), (size,))
    weight = [CHEAP**rank for rank, count in enumerate(ranks) for _ in range(count)]
    weighted = mx.array([[w * x for w, x in zip(weight, row, strict=True)] for row in J], (rows, size))
    A = mx.multiply(weighted, J.T)
    whole = sum((A[k, k] for k in range(1, rows)), A[0, 0])
    if dependent:
        A = A + mx.diagonal([COMPLIANCE * (A[k, k] + LEAST * whole) for k in range(rows)])
    factor = mx.factorise(A, tracer, tracer.epsilon() * 8.0 * whole)
    x = mx.solve(factor, mx.multiply(weighted, f))
    x = x + mx.solve(factor, mx.multiply(weighted, f - mx.multiply(J.T, x)))  # what rounding in the squares left

    def without(x: Array, last: int) -> Array:
        """The solution that leaves nothing on the first coordinates, if there is one."""
        if not last:
            return x
        own, exerted = weighted[:, :last], J[:, :last].T
        correction = lambda x: mx.solve(factor, mx.multiply(own, f[:last] - mx.multiply(exerted, x)))  # noqa: E731
        # n corrections in a row add (1 + E + … + Eⁿ⁻¹) times the first, E what one of them leaves of an error
        left, added = mx.diagonal([1.0] * rows) - mx.solve(factor, mx.multiply(own, exerted)), correction(x)
        for _ in range(DOUBLED):
            added, left = added + mx.multiply(left, added), mx.multiply(left, left)
        x = x + added
        for _ in range(REPEATED):
            x = x + correction(x)
        return x

    x = without(without(x, ranks[0] + ranks[1]), ranks[0])
    return tracer.program("shared_loads", {"J": rows * size, "f": size}, {"x": np.ravel(x).tolist()})
