"""The floating base: the first link's pose and twist are state, and its motion subspace is the identity."""

from __future__ import annotations

import sympy as sp

from ..algebra.expression import Expression, Symbol, hat, identity, inverse, number, stack
from ..ir.block import Block


def free_block(b: Block) -> Block:
    """The rates of the pose; ``omega, v`` is the twist of F_i in its own axes."""
    R = free_posture(b)
    Q = b.entries(b.symbol("quaternion"))
    omega, v = b.input("omega", (3, 1)), b.input("v", (3, 1))
    u = stack(*Q[1:])
    turning = stack(-(u.T @ omega), Q[0] @ omega + hat(u) @ omega)
    half = number(sp.Rational(1, 2))
    step, meaning = b.step, "rate of the quaternion, half its product with [0, ω]"
    step("quaternion_rate", half @ turning, r"\dot{\mathbf{Q}}_i", unit="1/s", frame="-", meaning=meaning)
    shown, meaning = r"\dot{\mathbf{r}}_{oi}", "rate of the position"
    step("position_rate", R @ v, shown, unit="m/s", frame="inertial", meaning=meaning)
    return b


def free_motion_block(b: Block) -> Block:
    """The acceleration of the origin of F_i, a material point, while its twist's components keep their values."""
    omega, v, a_R = b.input("omega", (3, 1)), b.input("v", (3, 1)), b.input("a_R", (3, 1))
    b.step("a", a_R + hat(omega) @ v)
    return b


def free_posture(b: Block) -> Symbol:
    """``R_rel``: the rotation from F_i to the inertial frame by a quaternion of any length."""
    words = (r"\mathbf{Q}_i", "-", "-", "rotation of F_i, quaternion (w, x, y, z)")
    Q = b.input("quaternion", (4, 1), *words)
    w, *vector = b.entries(Q)
    cross = hat(stack(*vector))
    scale: Expression = number(2) @ inverse(Q.T @ Q)
    R = identity(3) + scale @ (w @ cross + cross @ cross)
    return b.step("R_rel", R, r"\mathbf{R}_{oi}", meaning="rotation of F_i to the inertial frame")
