"""What phases need of a joint's place: its rotation and its points."""

from __future__ import annotations

from ..ir.program import Array
from . import matrices as mx
from .scope import Scope


def rotation(s: Scope, q: Array) -> Array:
    """``R_rel``: the rotation of F_i relative to the parent's tip frame, or of a floating base."""
    return s.lower("posture", {"q": q}, "R_rel")[0]


def joint_point(s: Scope) -> Array:
    """The joint point in F_i; of a base whose motion is given its origin."""
    placed = s.key.frame_at and not s.key.joint.given
    return mx.array([-s.constant("frame_at"), 0.0, 0.0]) if placed else mx.zeros(3)


def joint_offset(s: Scope, q: Array) -> Array:
    """The joint point relative to the parent's tip point, in the parent's tip frame."""
    if s.key.slides:
        return s.lower("posture", {"q": q}, "r_J")[0]
    return mx.array([s.constant(f"mount_xyz_{a}") for a in "xyz"]) if s.key.mount_xyz else mx.zeros(3)
