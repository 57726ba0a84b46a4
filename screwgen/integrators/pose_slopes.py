"""How ``pose exp(u)`` changes with u and with the pose before it: for the derivatives of a step."""

from __future__ import annotations

import numpy as np

from ..algorithms import matrices as mx
from ..ir.derivative import columns
from ..ir.program import Array, Program, Tracer, Value
from ..joints.exponential import Series, exponential


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


def _turned(w: Value, b: Array) -> Array:
    """The rotation of a unit quaternion."""
    square = mx.symmetric(3, lambda i, j: b[i] * b[j] - (mx.dot(b, b) if i == j else 0.0))
    return mx.identity(3) + 2.0 * (w * mx.hat(b) + square)


def _conjugate(w: Value, b: Array) -> Array:
    """(3, 4): the vector of the conjugate of a quaternion times another."""
    return np.hstack([-b[:, None], mx.identity(3) * w - mx.hat(b)])
