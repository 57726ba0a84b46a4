"""The joint block: how a link's twist follows from its parent's tip twist and the joint's motion."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..algebra.expression import Expression, Rotation, Symbol, hat, identity, stack, unit, zeros
from ..algebra.rate import acceleration, rate
from ..algebra.scalar import Scalar
from ..ir.block import Block
from ..joints.exponential import rate_expressions
from ..joints.kind import Kinematics
from ..lazily import sp
from ..spec.link_class import LinkClass

LINK = "F_i"


def joint_block(key: LinkClass) -> Block:
    """Compatibility of the joint at velocity and acceleration level, (43)-(45) and (accconst4).

    ``omega, v`` is the link's twist in F_i.  The bias acceleration ``beta_omega, beta_v`` is its rate while the
    parent's tip and the joint coordinates do not accelerate.
    """
    b = Block("joint", "Joint" if not key.floats else "Floating base")
    if key.floats:
        return _pose_rates(key, b, _coordinates(b, key, rates=False)[0])
    q, qdot = _coordinates(b, key)
    omega_P = b.input("omega_P", (3, 1))
    v_P = b.input("v_P", (3, 1))
    motion, r_m, r_B, R = posture(key, b, q)
    rates = _rates(key, b, q, qdot)
    omega_J = _relative_turn(b, qdot)
    omega_R = b.step("omega_R", R.T @ omega_P)
    omega = _turn(b, omega_R, omega_J)
    r_J = b.symbol("r_J") if key.slides else r_m
    v_R = b.step("v_R", R.T @ (v_P + hat(omega_P) @ r_J))
    v_J, slipping = _slip(key, b, motion, qdot, rates, omega_R)
    b.step("v", v_R + v_J - hat(omega) @ r_B)
    axis_rate = _axis_rate(b, motion, qdot, rates)
    beta = b.step("beta_omega", axis_rate - hat(omega_J) @ omega_R)
    b.step("beta_v", -hat(omega_J) @ v_R + slipping - hat(beta) @ r_B)
    return b


def _slip(
    key: LinkClass, b: Block, motion: Kinematics, qdot: Symbol, rates: Mapping[str, Expression], omega_R: Symbol
) -> tuple[Expression, Expression]:
    """For sliding joints: the joint point's velocity relative to the parent, and its contribution to ``beta_v``."""
    if not key.slides:
        return zeros(3), zeros(3)
    v_J = b.step("v_J", b.symbol("T") @ qdot)
    slip_rate = b.step("slip_rate", rate(motion.linear @ stack(*b.entries(qdot)), rates))
    return v_J, slip_rate + hat(omega_R) @ v_J


def _rates(key: LinkClass, b: Block, q: Symbol, qdot: Symbol) -> dict[str, Expression]:
    """The rate of each coordinate by its name."""
    given, speeds = (np.array([Scalar(x) for x in b.entries(part)], dtype=object) for part in (q, qdot))
    found = key.joint.coordinate_rates(given, speeds)
    return {c.name: rate.e for c, rate in zip(b.entries(q), found, strict=True)}


def _axis_rate(b: Block, motion: Kinematics, qdot: Symbol, rates: Mapping[str, Expression]) -> Expression:
    """``Adot qdot``: of screws, later ones turn the axes of the earlier ones."""
    speeds = b.entries(qdot)
    return rate(motion.angular @ stack(*speeds), rates) if len(speeds) > 1 else zeros(3)


def _relative_turn(b: Block, qdot: Symbol) -> Symbol:
    return b.step("omega_J", b.symbol("A") @ qdot)


def _turn(b: Block, omega_R: Symbol, omega_J: Symbol) -> Symbol:
    return b.step("omega", omega_R + omega_J)


def motion_block(key: LinkClass) -> Block:
    """The link's motion from that of the parent's tip without joint accelerations, (accconst4); all in F_i axes.

    Accelerations are those of material points in the inertial frame. ``S`` is the motion subspace at the origin of F_i.
    """
    b = Block("joint_motion", "Motion of the link")
    if key.floats:
        return _motion_in_space(b)
    q, qdot = _coordinates(b, key)
    omega_R = b.input("omega_R", (3, 1))
    alpha_R = b.input("alpha_R", (3, 1))
    a_R = b.input("a_R", (3, 1))
    motion, r_m, r_B, R = posture(key, b, q)
    A, rates = b.symbol("A"), _rates(key, b, q, qdot)
    T = b.symbol("T") if key.slides else zeros(3, key.joints)
    b.step("S", stack(A, T + hat(r_B) @ A))
    omega_J = _relative_turn(b, qdot)
    omega = _turn(b, omega_R, omega_J)
    axis_rate = _axis_rate(b, motion, qdot, rates)
    alpha = b.step("alpha", alpha_R - hat(omega_J) @ omega_R + axis_rate)
    r_R = b.step("r_R", R.T @ (b.symbol("r_J") if key.slides else r_m))
    b.step("lever", r_R - r_B)
    seen: dict[str, Expression] = {"omega_R": alpha_R}
    if key.slides:
        v_J, _ = _slip(key, b, motion, qdot, rates, omega_R)
        seen |= {"r_R": v_J, "v_J": b.symbol("slip_rate") + hat(omega_J) @ v_J}
    a_J = b.step("a_J", a_R + acceleration(r_R, omega_R, seen))
    b.step("a", a_J - acceleration(r_B, omega, {"omega": alpha}))
    return b


def posture_block(key: LinkClass) -> Block:
    """Relative pose and motion subspace alone, as functions of q (DAE form, poses); of a floating base its rotation."""
    b = Block("posture", "Posture of the joint")
    q = _coordinates(b, key, rates=False)[0]
    if key.floats:
        _rotation_in_space(key, b, q)
    else:
        posture(key, b, q)
    return b


def _pose_rates(key: LinkClass, b: Block, q: Symbol) -> Block:
    """The rates of a floating base's pose; ``omega, v`` is the twist of F_i in its own axes."""
    R = _rotation_in_space(key, b, q)
    omega, v = b.input("omega", (3, 1)), b.input("v", (3, 1))
    rate, meaning = rate_expressions(b.entries(q)[key.joint.turn_at :], omega), "half its product with [0, ω]"
    shown = r"\dot{\mathbf{Q}}_i"
    b.step("quaternion_rate", rate, shown, unit="1/s", frame="-", meaning=f"rate of the quaternion, {meaning}")
    shown, meaning = r"\dot{\mathbf{r}}_{oi}", "rate of the position"
    b.step("position_rate", R @ v, shown, unit="m/s", frame="inertial", meaning=meaning)
    return b


def _motion_in_space(b: Block) -> Block:
    """The acceleration of the origin of F_i, a material point, while its twist's components keep their values."""
    omega, v, a_R = b.input("omega", (3, 1)), b.input("v", (3, 1)), b.input("a_R", (3, 1))
    b.step("a", a_R + hat(omega) @ v)
    return b


def _rotation_in_space(key: LinkClass, b: Block, q: Symbol) -> Symbol:
    R = key.joint.kinematics(b.entries(q)).rotation
    return b.step("R_rel", R, r"\mathbf{R}_{oi}", meaning="rotation of F_i to the inertial frame")


def _coordinates(b: Block, key: LinkClass, rates: bool = True) -> tuple[Symbol, Symbol]:
    units = "rad, m" if any(not s.turn for s in key.screws) else "rad"
    meaning = "joint coordinates, in the order of the axes"
    if key.joint.curved:
        units, meaning = ("m, -", "position and ") if key.floats else ("-", "")
        meaning += "quaternion (w, x, y, z) of F_i"
    q = b.input("q", (key.joint.nq, 1), r"\mathbf{q}_i", units, "-", meaning)
    speed = ", ".join(f"{u}/s" for u in units.split(", "))
    return q, b.input("qdot", (key.joints, 1), r"\dot{\mathbf{q}}_i", speed, "-", "joint rates") if rates else q


def posture(key: LinkClass, b: Block, q: Symbol) -> tuple[Kinematics, Expression, Expression, Symbol]:
    """The joint's motion, the mount's offset, the joint point in F_i and ``R_rel``, declared as steps of the block."""
    motion = key.joint.kinematics(b.entries(q))
    r_m, r_B = joint_points(key, b)
    R_m = _mount_rotation(key, b)
    R = b.step("R_rel", R_m @ motion.rotation)
    b.step("A", motion.angular)
    if key.slides:
        b.step("T", motion.linear)
        b.step("r_J", r_m + R_m @ motion.displacement)
    return motion, r_m, r_B, R


def _mount_rotation(key: LinkClass, b: Block) -> Expression:
    """``R_m``: components in the mount's axes to the parent's tip frame."""
    if not key.mount_rpy:
        return identity(3)
    rpy = b.parameter("mount_rpy", (3, 1))
    roll, pitch, yaw = b.entries(rpy)
    axes = [tuple(sp.Integer(int(i == j)) for i in range(3)) for j in range(3)]
    return b.step("R_m", Rotation(axes[2], yaw) @ Rotation(axes[1], pitch) @ Rotation(axes[0], roll))


def joint_points(key: LinkClass, b: Block) -> tuple[Expression, Expression]:
    """The mount's offset (parent's tip frame) and the joint point in F_i."""
    r_m: Expression = zeros(3)
    r_B: Expression = zeros(3)
    if key.mount_xyz:
        r_m = b.parameter("mount_xyz", (3, 1))
    if key.frame_at:
        frame_at = b.parameter("frame_at", (1, 1))
        r_B = b.step("r_B", -frame_at @ unit(0))
    return r_m, r_B
