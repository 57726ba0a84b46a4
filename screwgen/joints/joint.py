"""The joint block: how a link's twist follows from its parent's tip twist and the joint's motion."""

from __future__ import annotations

from functools import reduce

import sympy as sp

from ..algebra.expression import Expression, Rotation, Symbol, block, hat, identity, stack, unit, vector, zeros
from ..algebra.notation import axis_latex
from ..algebra.rate import rate
from ..ir.block import Block
from ..spec.link_class import LinkClass

TIP = "parent's tip frame"
LINK = "F_i"


def joint_block(key: LinkClass) -> Block:
    """Compatibility of the joint at velocity and acceleration level, (43)-(45) and (accconst4).

    ``omega, v`` is the link's twist in F_i; ``beta_omega, beta_v`` is what remains of its rate when
    the parent's tip and the joint coordinates do not accelerate.
    """
    b = Block("joint", "Joint")
    q = b.input("q", (key.joints, 1), r"\mathbf{q}_i", "rad", "-", "joint coordinates, in the order of the axes")
    qdot = b.input("qdot", (key.joints, 1), r"\dot{\mathbf{q}}_i", "rad/s", "-", "joint rates")
    omega_P = b.input("omega_P", (3, 1), r"\boldsymbol{\omega}_P", "rad/s", TIP, "angular velocity of the parent's tip")
    v_P = b.input("v_P", (3, 1), r"\mathbf{v}_P", "m/s", TIP, "velocity of the parent's tip point")
    turns, angles, speeds = rotations(key, b, q, qdot)
    r_m, r_B = joint_points(key, b)

    R = relative_rotation(key, b, turns)
    A = b.step(
        "A",
        axes_matrix(key, turns),
        r"\mathbf{A}_i",
        unit="-",
        frame=LINK,
        equation="43",
        meaning="columns: the joint's axes",
        numbered=(1,),
    )
    omega_J = b.step(
        "omega_J",
        A @ qdot,
        r"\boldsymbol{\omega}_J",
        unit="rad/s",
        frame=LINK,
        meaning="angular velocity of the link relative to its parent's tip",
    )
    omega_R = b.step(
        "omega_R",
        R.T @ omega_P,
        r"\boldsymbol{\omega}_R",
        unit="rad/s",
        frame=LINK,
        meaning="angular velocity of the parent's tip",
    )
    omega = b.step(
        "omega",
        omega_R + omega_J,
        r"\boldsymbol{\omega}_i",
        unit="rad/s",
        frame=LINK,
        equation="45",
        meaning="angular velocity of the link",
    )
    v_R = b.step(
        "v_R",
        R.T @ (v_P + hat(omega_P) @ r_m),
        r"\mathbf{v}_R",
        unit="m/s",
        frame=LINK,
        meaning="velocity of the joint point",
    )
    b.step(
        "v",
        v_R - hat(omega) @ r_B,
        r"\mathbf{v}_i",
        unit="m/s",
        frame=LINK,
        equation="45",
        meaning="velocity of the origin of F_i",
    )
    axis_rate = _axis_rate(key, turns, angles, speeds)
    beta = b.step(
        "beta_omega",
        axis_rate - hat(omega_J) @ omega_R,
        r"\boldsymbol{\beta}_{\omega}",
        unit="rad/s^2",
        frame=LINK,
        equation="accconst4",
        meaning="angular acceleration that the velocities cause at the joint",
    )
    b.step(
        "beta_v",
        -hat(omega_J) @ v_R - hat(beta) @ r_B,
        r"\boldsymbol{\beta}_{v}",
        unit="m/s^2",
        frame=LINK,
        equation="accconst4",
        meaning="acceleration that the velocities cause at the joint",
    )
    return b


def _axis_rate(key: LinkClass, turns, angles, speeds) -> Expression:
    """``Adot qdot``: later rotations turn the earlier axes in F_i."""
    if key.joints < 2:
        return zeros(3)
    rates = dict(zip((a.name for a in angles), speeds, strict=True))
    return rate(axes_matrix(key, turns) @ stack(*speeds), rates)


def posture_block(key: LinkClass) -> Block:
    """The relative rotation and the joint's axes alone, as functions of q (DAE form, poses)."""
    b = Block("posture", "Posture of the joint")
    q = b.input("q", (key.joints, 1), r"\mathbf{q}_i", "rad", "-", "joint coordinates, in the order of the axes")
    turns, _, _ = rotations(key, b, q, q)
    joint_points(key, b)
    relative_rotation(key, b, turns)
    b.step(
        "A",
        axes_matrix(key, turns),
        r"\mathbf{A}_i",
        unit="-",
        frame=LINK,
        equation="43",
        meaning="columns: the joint's axes",
        numbered=(1,),
    )
    return b


def rotations(key: LinkClass, b: Block, q: Symbol, qdot: Symbol):
    """One elementary rotation per axis, with its angle and its rate."""
    angles, speeds = b.entries(q), b.entries(qdot)
    exact = [tuple(sp.Integer(int(x)) if x == int(x) else sp.Float(x) for x in axis) for axis in key.axes]
    return [Rotation(axis, angle) for axis, angle in zip(exact, angles, strict=True)], angles, speeds


def relative_rotation(key: LinkClass, b: Block, turns: list[Rotation]) -> Symbol:
    """``R_rel = R_mount exp(a1 q1) exp(a2 q2) ...``: components in F_i to the parent's tip frame."""
    chain: list[Expression] = list(turns)
    if key.mount_rpy:
        rpy = b.parameter("mount_rpy", (3, 1), r"\boldsymbol{\alpha}_m", "rad", TIP, "roll, pitch, yaw of the mount")
        roll, pitch, yaw = b.entries(rpy)
        axes = [tuple(sp.Integer(int(i == j)) for i in range(3)) for j in range(3)]
        R_m = b.step(
            "R_m",
            Rotation(axes[2], yaw) @ Rotation(axes[1], pitch) @ Rotation(axes[0], roll),
            r"\mathbf{R}_m",
            unit="-",
            frame=TIP,
            meaning="rotation of the mount",
        )
        chain.insert(0, R_m)
    return b.step(
        "R_rel",
        reduce(lambda x, y: x @ y, chain, identity(3)),
        r"\mathbf{R}_{(i-1)i}",
        unit="-",
        frame=TIP,
        meaning="rotation of F_i relative to the parent's tip frame",
    )


def axes_matrix(key: LinkClass, turns: list[Rotation]) -> Expression:
    """``[(R_2 ... R_m)^T a_1, ..., a_m]``: every axis as the rotations after it leave it, in F_i."""
    if not turns:
        return zeros(3, 0)
    columns = []
    for i, turn in enumerate(turns):
        column: Expression = vector(turn.axis, axis_latex(turn.axis))
        for later in turns[i + 1 :]:
            column = later.T @ column
        columns.append(column)
    return block(columns)


def joint_points(key: LinkClass, b: Block) -> tuple[Expression, Expression]:
    """The mount's offset (parent's tip frame) and the joint point in F_i."""
    r_m: Expression = zeros(3)
    r_B: Expression = zeros(3)
    if key.mount_xyz:
        r_m = b.parameter(
            "mount_xyz", (3, 1), r"\mathbf{r}_m", "m", TIP, "joint point relative to the parent's tip point"
        )
    if key.frame_at:
        frame_at = b.parameter("frame_at", (1, 1), "f_i", "m", LINK, "place of F_i on the centreline, from the joint")
        r_B = b.step(
            "r_B", -frame_at @ unit(0), r"\mathbf{r}_B", unit="m", frame=LINK, equation="47", meaning="joint point"
        )
    return r_m, r_B
