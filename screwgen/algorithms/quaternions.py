"""Unit quaternions (w, x, y, z) of the DAE form: those of joints, of tip sections and of small turns."""

from __future__ import annotations

import numpy as np

from ..ir.program import Array, Value, Vector
from ..spec.link_class import EXACT
from . import matrices as mx
from .rod_sections import turns_to
from .scope import Scope


def quaternion_product(a: Array, b: Array) -> Array:
    """The quaternion product, (w, x, y, z)."""
    scalar = a[0] * b[0] - mx.dot(a[1:], b[1:])
    return np.concatenate([mx.array([scalar]), a[0] * b[1:] + b[0] * a[1:] + mx.cross(a[1:], b[1:])])


def quaternion_matrix(Q: Array) -> Array:
    """The rotation of a quaternion of any length."""
    scale = 2.0 / mx.dot(Q, Q)
    w, u = Q[0], Q[1:]
    square = mx.symmetric(3, lambda i, j: u[i] * u[j] - (mx.dot(u, u) if i == j else 0.0))
    return mx.identity(3) + scale * (w * mx.hat(u) + square)


def unit_quaternion(s: Scope, Q: Array) -> Array:
    """``Q / |Q|``."""
    return Q * (1.0 / s.tracer.call("sqrt", mx.dot(Q, Q)))


def unit_coordinates(s: Scope, q: Array) -> Array:
    """A joint's coordinates, those that are a quaternion scaled to length one."""
    return s.key.joint.unit(q, lambda x: s.tracer.call("sqrt", x))


def axis_quaternion(s: Scope, axis: Vector, angle: Value) -> Array:
    half = 0.5 * angle
    sine = s.tracer.call("sin", half)
    return mx.array([s.tracer.call("cos", half), *(sine * a for a in axis)])


def joint_quaternion(s: Scope, q: Array) -> Array:
    """The quaternion of ``R_rel``: the mount, then every axis."""
    turns = []
    if s.key.mount_rpy:
        turns += [axis_quaternion(s, mx.identity(3)[k], s.constant(f"mount_rpy_{'xyz'[k]}")) for k in (2, 1, 0)]
    if s.key.joint.turn_at is not None:
        turns.append(unit_coordinates(s, q)[s.key.joint.turn_at :][:4])
    turns += [axis_quaternion(s, screw.axis, x) for screw, x in zip(s.key.screws, q, strict=False) if screw.turn]
    total = mx.array([1.0, 0.0, 0.0, 0.0])
    for turn in turns:
        total = quaternion_product(total, turn)
    return total


def tip_quaternion(s: Scope, eta: Array) -> Array:
    """The quaternion of ``R_T``: the turn of the section, then the axes of the tip of a body from a file."""
    if not s.key.section_rotation:
        return mx.array([1.0, 0.0, 0.0, 0.0])
    if s.key.order == EXACT:
        total = mx.array([1.0, 0.0, 0.0, 0.0])
        for theta in turns_to(s, {"eta": eta}):
            total = quaternion_product(total, turn_quaternion(s, theta))
        return total
    turn = turn_quaternion(s, s.lower("tip_pose", {"eta": eta}, "theta")[0])
    axes = np.eye(3) if s.key.elastic is None else np.array(s.key.elastic.tip.axes)
    return turn if np.array_equal(axes, np.eye(3)) else quaternion_product(turn, quaternion_of(axes))


def quaternion_of(R: np.ndarray) -> Array:
    """The quaternion of a rotation by its largest component, which has no cancellation."""
    symmetric, trace = R + R.T, np.trace(R)
    squares = np.block(
        [[np.eye(1) * (1 + trace), np.zeros((1, 3))], [np.zeros((3, 1)), symmetric + (1 - trace) * np.eye(3)]]
    )
    squares[0, 1:] = squares[1:, 0] = R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]
    largest = squares[np.argmax(np.diag(squares))]
    return mx.array((largest / np.linalg.norm(largest)).tolist())


def turn_quaternion(s: Scope, theta: Array) -> Array:
    """``exp(theta)`` as a quaternion: ``[c_0(x/4), c_1(x/4) theta / 2]``, regular at rest."""
    quarter = 0.25 * mx.dot(theta, theta)
    c2 = 0.5 - quarter * s.tracer.call("c4", quarter)
    c3 = 1.0 / 6.0 - quarter * s.tracer.call("c5", quarter)
    return np.concatenate([mx.array([1.0 - quarter * c2]), (0.5 * (1.0 - quarter * c3)) * theta])
