"""What phases need of a joint: its rotation, its points, and the inertia and forces of its coordinates."""

from __future__ import annotations

from ..ir.program import Array
from . import matrices as mx
from .scope import Scope


def rotation(s: Scope) -> Array:
    """``R_rel``: the rotation of F_i relative to the parent's tip frame, or of a floating base."""
    given = {"quaternion": s.read("quaternion")} if s.key.free else {"q": s.read("q")}
    return s.lower("posture", given, "R_rel")[0]


def joint_point(s: Scope) -> Array:
    """The joint point in F_i."""
    return mx.array([-s.constant("frame_at"), 0.0, 0.0]) if s.key.frame_at else mx.zeros(3)


def joint_offset(s: Scope, q: Array) -> Array:
    """The joint point relative to the parent's tip point, in the parent's tip frame."""
    if s.key.slides:
        return s.lower("posture", {"q": q}, "r_J")[0]
    return mx.array([s.constant(f"mount_xyz_{a}") for a in "xyz"]) if s.key.mount_xyz else mx.zeros(3)


def _per_axis(s: Scope, present: bool, label: str) -> Array:
    return mx.array([s.constant(f"{label}_{j + 1}") if present else 0.0 for j in range(s.key.joints)], (s.key.joints,))


def armature(s: Scope) -> Array:
    """The rotor inertias seen at the joint."""
    return _per_axis(s, s.key.armature, "armature")


def stiffness(s: Scope) -> Array:
    return _per_axis(s, s.key.stiffness, "joint_stiffness")


def own_inertia(s: Scope) -> Array:
    """The inertia of the joint coordinates: the armature, or the given one of a sprung joint."""
    if s.key.free:
        return mx.zeros(6)
    return s.read("m_q") if s.key.sprung else armature(s)


def own_force(s: Scope) -> Array:
    """The generalised forces of the joint's damper and spring."""
    return s.read("f_q") if s.key.sprung else mx.zeros(s.key.freedoms)


def drive(s: Scope) -> Array:
    """The sum of the generalised forces of motor, damper and spring."""
    return (mx.zeros(6) if s.key.free else s.read("tau")) - own_force(s)
