"""How a joint's motion subspace ``S = [A; T]`` changes, its columns in F_i axes: for derivatives of a link's motion.

A change of the joint is ``delta`` along its rates, by :meth:`.JointKind.integrate`; the link then moves by ``S delta``.
Of a product of screws the changes follow from the columns themselves. Those of other kinds are traced.
"""

from __future__ import annotations

from typing import NamedTuple

from ..ir.derivative import tangents
from ..ir.program import Array, Node, Value
from ..joints.product import ScrewProduct
from . import matrices as mx
from .scope import Scope


class SubspaceRates(NamedTuple):
    """Rates of ``A delta`` and ``T delta`` by ``delta``, all (3, m), in a motion whose rates ``v`` do not change."""

    Adot: Array
    Addot: Array
    Tdot: Array
    Tddot: Array
    bend: Array
    """``d(A v)'/dv``, what the accelerations of the link's turn change by with the rates."""
    lost: Array
    """How much less than ``2 Tdot`` those of the joint point change by with them; none where coordinates add up."""


def subspace_rates(s: Scope, A: Array, T: Array, qdot: Array, qddot: Array) -> SubspaceRates:
    """The rates at given joint rates and accelerations."""
    if isinstance(s.key.joint, ScrewProduct):
        Adot, Addot, Tdot, Tddot = _of_screws(A, T, qdot, qddot)
        return SubspaceRates(Adot, Addot, Tdot, Tddot, 2.0 * Adot, mx.zeros(*T.shape))
    turning, C = _traced(s, A, qdot, qddot)
    shifting, _ = _traced(s, T, qdot, qddot)
    return SubspaceRates(*turning[:2], *shifting[:2], turning[2] + turning[0], mx.multiply(T, C))


def _traced(s: Scope, S: Array, v: Array, a: Array) -> tuple[tuple[Array, Array, Array], Array]:
    """``(S delta)'`` and ``(S delta)''`` by delta, the rate of S itself, and the matrix C of ``delta' = C delta``."""
    joint, q = s.key.joint, s.read("q")
    C, C_rate = mx.array(joint.carried(v).tolist(), (len(v),) * 2), joint.carried(a)
    moving = dict(zip(q, joint.coordinate_rates(q, v), strict=True))
    Sdot = _along(S, moving)
    Sddot = _along(Sdot, moving | dict(zip(v, a, strict=True)))
    second = mx.multiply(S, mx.multiply(C, C) + C_rate)
    return (Sdot + mx.multiply(S, C), Sddot + 2.0 * mx.multiply(Sdot, C) + second, Sdot), C


def _along(values: Array, moving: dict[Value, Value]) -> Array:
    """The rates of values, those of the inputs that move given."""
    seeds = {x: rate for x, rate in moving.items() if isinstance(x, Node)}
    return mx.array(tangents(list(values.flat), seeds), values.shape)


def _of_screws(A: Array, T: Array, qdot: Array, qddot: Array) -> tuple[Array, Array, Array, Array]:
    """``Adot, Addot, Tdot, Tddot``: later screws move the columns of the earlier ones in F_i."""
    m = A.shape[1]
    Adot, Addot, Tdot, Tddot = (mx.zeros(3, m) for _ in range(4))
    omega, alpha, v, a = (mx.zeros(3) for _ in range(4))
    for k in reversed(range(m)):
        Adot[:, k] = mx.cross(A[:, k], omega)
        Addot[:, k] = mx.cross(Adot[:, k], omega) + mx.cross(A[:, k], alpha)
        Tdot[:, k] = mx.cross(T[:, k], omega) + mx.cross(A[:, k], v)
        Tddot[:, k] = (
            mx.cross(Tdot[:, k], omega) + mx.cross(T[:, k], alpha) + mx.cross(Adot[:, k], v) + mx.cross(A[:, k], a)
        )
        omega, v = omega + A[:, k] * qdot[k], v + T[:, k] * qdot[k]
        alpha = alpha + A[:, k] * qddot[k] + Adot[:, k] * qdot[k]
        a = a + T[:, k] * qddot[k] + Tdot[:, k] * qdot[k]
    return Adot, Addot, Tdot, Tddot


def turned_rows(s: Scope, A: Array, T: Array, w: Array) -> Array:
    """(m, m): how the joint's rows ``S^T w`` change by delta as its columns do, at the wrench ``w`` in F_i axes."""
    m, joint = A.shape[1], s.key.joint
    if isinstance(joint, ScrewProduct):
        return mx.array([[_later(A, T, w, l, k) for k in range(m)] for l in range(m)], (m, m))
    q, rows = s.read("q"), mx.multiply(A.T, w[:3]) + mx.multiply(T.T, w[3:])
    units = [dict(zip(q, joint.coordinate_rates(q, unit), strict=True)) for unit in mx.identity(m)]
    return mx.array([tangents(list(rows), moving) for moving in units], (m, m)).T


def _later(A: Array, T: Array, w: Array, l: int, k: int) -> Value:
    """``d(S_l . w)/d q_k``: the columns before screw k depend on its coordinate."""
    if k <= l:
        return 0.0
    moved = mx.cross(T[:, l], A[:, k]) + mx.cross(A[:, l], T[:, k])
    return mx.dot(mx.cross(A[:, l], A[:, k]), w[:3]) + mx.dot(moved, w[3:])
