"""How a move by u changes with u and with the coordinates before it: for the derivatives of a step."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..algorithms import matrices as mx
from ..algorithms.joint_moves import traced
from ..ir.derivative import columns, tangents
from ..ir.program import Array, Program, Tracer, Value
from ..joints.exponential import Series, exponential
from ..joints.kind import JointKind


def pose_slopes() -> Program:
    """``(u) -> (turned, carried)``: both (6, 6), row by row, applied to changes [turn; shift].

    With ``g = pose exp(u)``, a change du of u is ``g exp(turned du)``, and a change delta of the pose, ``pose
    exp(delta)``, is ``g exp(carried delta)``.
    """
    tracer = Tracer()
    u = tracer.input("u", 6)
    series = Series(lambda x: tracer.call("c4", x), lambda x: tracer.call("c5", x))
    moved = exponential(mx.array([1.0, *[0.0] * 6]), mx.array(u), series)
    slopes = mx.array(columns(list(moved), u), (6, 7)).T
    w, b, shift = moved[0], moved[1:4], moved[4:]
    back = _turned(w, b).T
    turn = 2.0 * (mx.multiply(_conjugate(w, b), slopes[:4]))
    turned = np.vstack([turn, mx.multiply(back, slopes[4:])])
    arm = -mx.multiply(back, mx.hat(shift))
    carried = np.vstack([np.hstack([back, mx.zeros(3, 3)]), np.hstack([arm, back])])
    return tracer.program("pose_slopes", {"u": 6}, {"turned": list(turned.flat), "carried": list(carried.flat)})


def move_slopes(joint: JointKind) -> Program:
    """``(q, u) -> (turned, carried)``: the same of a kind of joint, both (nv, nv), row by row, applied to changes.

    With ``g = integrate(q, u)``, a change du of u is ``integrate(g, turned du)``, and a change delta of the
    coordinates, ``integrate(q, delta)``, is ``integrate(g, carried delta)``.
    """

    def turned(q: Array, u: Array, series: Series) -> list[Value]:
        moved = joint.integrate(q, u, series)
        return _side_by_side([joint.rates_of(moved, mx.array(x)) for x in columns(list(moved), list(u))])

    def carried(q: Array, u: Array, series: Series) -> list[Value]:
        moved = joint.integrate(q, u, series)
        units = [dict(zip(q, joint.coordinate_rates(q, unit), strict=True)) for unit in mx.identity(joint.nv)]
        return _side_by_side([joint.rates_of(moved, mx.array(tangents(list(moved), x))) for x in units])

    return traced("move_slopes", {"q": joint.nq, "u": joint.nv}, turned=turned, carried=carried)


def rate_slopes(joint: JointKind) -> Program:
    """``(u, v) -> (by_u, by_v)``: the derivatives of :meth:`.JointKind.rate`, (nv, nv), row by row."""

    def by(place: int) -> Callable[..., list[Value]]:
        return lambda *x: _side_by_side(columns(list(joint.rate(*x[:2])), list(x[place])))

    return traced("rate_slopes", {"u": joint.nv, "v": joint.nv}, by_u=by(0), by_v=by(1))


def _side_by_side(found: Sequence[Sequence[Value]]) -> list[Value]:
    """A matrix row by row out of its columns."""
    return [column[i] for i in range(len(found[0])) for column in found]


def _turned(w: Value, b: Array) -> Array:
    """The rotation of a unit quaternion."""
    square = mx.symmetric(3, lambda i, j: b[i] * b[j] - (mx.dot(b, b) if i == j else 0.0))
    return mx.identity(3) + 2.0 * (w * mx.hat(b) + square)


def _conjugate(w: Value, b: Array) -> Array:
    """(3, 4): the vector of the conjugate of a quaternion times another."""
    return np.hstack([-b[:, None], mx.identity(3) * w - mx.hat(b)])
