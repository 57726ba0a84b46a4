"""Closed loops: the wrenches on tips that keep them closed.

A row g of a loop (:mod:`..joints.constraints`) acts on its two tips by unit wrenches W, so `ġ = Σ Wᵀ V` over both tips,
and `g̈ = Σ Wᵀ a + γ` with the accelerations `a` of the tips and γ of the velocities. With `M⁻¹` applied by the elimination,
once for every row, the rows' forces λ follow from `(J M⁻¹ Jᵀ) λ = −(J v̇ + γ + 2 c ġ + c² g)`, where `v̇` are the accelerations
of the open tree and `c` is the loop's stabilisation. All vectors are in inertial axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from ..ir.program import Array, Program, Tracer, Value
from ..joints.constraints import Distance, Row
from ..topology.loops import Closure
from . import matrices as mx


@dataclass(frozen=True)
class Tip:
    """Pose and twist of a tip section: `R` (3, 3), `r` (3,) in m, `omega` (3,) in rad/s, `v` (3,) of the point."""

    R: Array
    r: Array
    omega: Array
    v: Array

    @property
    def twist(self) -> Array:
        return np.concatenate([self.omega, self.v])


@dataclass(frozen=True)
class Condition:
    """A row in a state: its `gap`, the unit wrenches (6,) on both tips, and γ, the part of g̈ without accelerations."""

    gap: Value
    first: Array
    second: Array
    gamma: Value

    def power(self, first: Array, second: Array) -> Value:
        """The work of the unit wrenches at twists, or its rate at accelerations, of both tips."""
        return mx.dot(self.first, first) + mx.dot(self.second, second)


def condition(row: Row, a: Tip, b: Tip) -> Condition:
    """A row between the tips A and B."""
    return _distance(row.normal, a, b) if isinstance(row, Distance) else _angle(row, a, b)


def _distance(normal: Sequence[float], a: Tip, b: Tip) -> Condition:
    """``g = n · (r_B − r_A)`` with n fixed in A."""
    n, d, rate = mx.multiply(a.R, mx.array(normal)), b.r - a.r, b.v - a.v
    n_rate = mx.cross(a.omega, n)
    gamma = mx.dot(n_rate, rate) - mx.dot(a.omega, mx.cross(rate, n) + mx.cross(d, n_rate))
    return Condition(
        mx.dot(n, d), np.concatenate([-mx.cross(d, n), -n]), np.concatenate([mx.zeros(3), n]), gamma
    )


def _angle(row, a: Tip, b: Tip) -> Condition:
    """``g = x · y − c`` with x fixed in A and y in B."""
    x, y = mx.multiply(a.R, mx.array(row.first)), mx.multiply(b.R, mx.array(row.second))
    c = mx.cross(x, y)
    c_rate = mx.cross(mx.cross(a.omega, x), y) + mx.cross(x, mx.cross(b.omega, y))
    turn = np.concatenate([c, mx.zeros(3)])
    return Condition(mx.dot(x, y) - row.cosine, turn, -turn, mx.dot(a.omega - b.omega, c_rate))


def conditions(closures: Sequence[Closure], tips: Sequence[Tip]) -> list[Condition]:
    """The rows in a state of all tips."""
    return [condition(c.row, tips[c.first], tips[c.second]) for c in closures]


def wrenches(closures: Sequence[Closure], found: Sequence[Condition], forces: Sequence[Value], tips: Sequence[Tip]):
    """The wrenches on all tips, in their tip frames, of forces of the rows: a flat list, six numbers for each tip."""
    total = [mx.zeros(6) for _ in tips]
    for closure, row, force in zip(closures, found, forces, strict=True):
        total[closure.first] = total[closure.first] + row.first * force
        total[closure.second] = total[closure.second] + row.second * force
    return [x for tip, w in zip(tips, total, strict=True) for x in mx.rotate_wrench(tip.R.T, w)]


@cache
def solver(count: int) -> Program:
    """``(A, b) -> (x)`` with ``A x = b``; A by its upper triangle, row by row. Pivots are guarded by rounding errors."""
    tracer = Tracer()
    A = mx.unpack(tracer.input("A", count * (count + 1) // 2), count)
    b = mx.array(tracer.input("b", count), (count,))
    scale = tracer.epsilon() * 64.0 * sum((A[k, k] for k in range(1, count)), A[0, 0])
    x = mx.solve(mx.factorise(A, tracer, scale), b)
    return tracer.program("loops", {"A": count * (count + 1) // 2, "b": count}, {"x": list(x)})
