"""The rows of the assembled system that a joint contributes, (58)-(63)."""

from __future__ import annotations

from collections.abc import Sequence

from ..algebra.expression import Diagonal, Expression, identity, matrix, stack, zeros
from ..algebra.screw import diagonal_blocks, shift, twice
from ..ir.block import Block
from ..spec.link_class import LinkClass

LINK = "F_i"
TIP = "parent's tip frame"
MIXED = "rad/s^2, m/s^2, N*m"
UNITS = {"d": "N*m*s/rad", "k": "N*m/rad"}
SUBSPACE = {3: r"\mathbf{A}_i", 6: r"\mathbf{S}_i"}
"""The LaTeX of the motion subspace; for a revolute joint it is the angular part, the axes."""


def joint_rows_block(key: LinkClass) -> Block:
    """The six completed rows of a joint: the projected acceleration constraint, and the balance of the motor torques.

    ``P (J_B Vdot_i - X Vdot_T - J_B beta) + S S^+ w - S^+T (tau - J_m qddot - b qdot - k q) = 0``
    with ``qddot = S^+ (J_B Vdot_i - X Vdot_T - J_B beta)``. An axis whose acceleration ``a`` is given has ``qddot = a``
    in place of its balance, along its column of ``S``. Of the balance of one with a brake a ``share`` is left, and
    ``grip (qddot - stop)`` is added, see :mod:`.brakes`. The projector ``P`` (43) has rank 6 - m; the torque
    balance completes the six rows.
    """
    b = Block("joint_rows", "Rows of the joint")
    if key.floats:
        return _rows_in_space(b, key.joint.given)
    m = key.joints
    R = b.input("R_rel", (3, 3))
    size = 6 if key.slides else 3
    S = b.input("S", (size, m), SUBSPACE[size])
    S_plus = b.input("S_plus", (m, size), rf"{SUBSPACE[size]}^{{+}}")
    beta = b.input("beta", (6, 1))
    b_P = b.input("b_P", (6, 1))
    tau = b.input("tau", (m, 1))
    X = b.step("X", twice(R.T) @ shift(_offset(b, key)))
    J_B = b.step("J_B", shift(joint_point(b, key)))
    N = b.step("N", S @ S_plus if m else zeros(size, size))
    b.step("P", _whole(identity(size) - N, identity(3)))
    balance: Expression = S_plus.T
    borne: Expression = N
    inert, driven = identity(size) - N, balance
    if given := [axis for axis in key.prescribed if axis not in key.added_axes]:
        leads = _selection(m, given)
        balance = S_plus.T @ (identity(m) - leads)
        inert, borne, driven = inert + S @ leads @ S_plus, balance @ S.T, balance + S @ leads
    grip = b.input("grip", (m, 1)) if braked(key) else None
    if grip is not None:
        balance = balance @ Diagonal(b.input("share", (m, 1)))
        inert, borne = inert + S_plus.T @ Diagonal(grip) @ S_plus, balance @ S.T
        driven = balance + S @ leads if given else balance
    if key.has_constant_inertia or key.has_travelling_inertia:
        J_m = b.input("J_m", (m, 1)) if key.has_travelling_inertia else b.parameter("armature", (m, 1))
        inert = inert + balance @ Diagonal(J_m) @ S_plus
    P_c = b.step("P_c", _whole(inert, identity(3)))
    b.step("joint_w", _whole(borne, zeros(3, 3)))
    b.step("joint_V", P_c @ J_B)
    PX = b.step("PX", P_c @ X)
    passive = _passive(b, key)
    bias = -(P_c @ J_B @ beta) - PX @ b_P
    if grip is not None:
        bias = bias - _column(S_plus.T @ Diagonal(grip) @ b.input("stop", (m, 1)))
    b.step("joint_H", bias + _column(balance @ passive) if passive is not None else bias)
    b.step("joint_W", _column(driven @ tau) if m else zeros(6))
    return b


def braked(key: LinkClass) -> list[int]:
    """The axes whose own row a brake changes."""
    return [axis for axis in key.brakes if axis not in key.added_axes]


def _selection(m: int, axes: Sequence[int]) -> Expression:
    """(m, m): one on the diagonal of the given axes, zero elsewhere."""
    rows = [[int(i == j and i in axes) for j in range(m)] for i in range(m)]
    return matrix(rows, (m, m), r"\mathbf{E}_i")


def _rows_in_space(b: Block, given: bool) -> Block:
    """Of a floating base: nothing acts at its joint, ``w = 0``. These are the rows with ``S = I``, thus ``P = 0``.

    Where its motion is given, ``Vdot = a``.
    """
    rest, one = zeros(6, 6), identity(6)
    b.step("joint_w", rest if given else one)
    b.step("joint_V", one if given else rest)
    b.step("joint_H", zeros(6))
    b.step("joint_W", b.input("base_rate", (6, 1)) if given else zeros(6))
    return b


def _whole(a: Expression, rest: Expression) -> Expression:
    """A 6 x 6 matrix: ``a``, or ``a`` in the angular part and ``rest`` in the linear one."""
    return a if a.shape == (6, 6) else diagonal_blocks(a, rest)


def _column(a: Expression) -> Expression:
    """A column of six: ``a``, or ``a`` with nothing in the linear part."""
    return a if a.shape == (6, 1) else stack(a, zeros(3))


def _passive(b: Block, key: LinkClass) -> Expression | None:
    """``b qdot + k q``: the generalised forces of damper and spring, or None without them."""
    total: Expression | None = None
    slides = not all(screw.turn for screw in key.screws)
    for present, name, letter, state, display in (
        (key.has_dampers, "joint_damping", "d", "qdot", r"\dot{\mathbf{q}}_i"),
        (key.has_springs, "joint_stiffness", "k", "q", r"\mathbf{q}_i"),
    ):
        if present:
            column = b.parameter(
                name,
                (key.joints, 1),
                rf"\mathbf{{{letter}}}_q",
                UNITS[letter] + slides * f", of slides {UNITS[letter].replace('N*m', 'N').replace('rad', 'm')}",
                "-",
                name.replace("_", " "),
                numbered=(0,),
            )
            unit = "rad, rad/s" + slides * ", of slides m, m/s"
            motion = b.input(state, (key.joints, 1), display, unit, "-", "joint coordinates or rates", numbered=(0,))
            term = Diagonal(column) @ motion
            total = term if total is None else total + term
    return total


def _offset(b: Block, key: LinkClass) -> Expression:
    if key.slides:
        return b.input("r_J", (3, 1))
    if not key.mount_xyz:
        return zeros(3)
    return b.parameter("mount_xyz", (3, 1))


def joint_point(b: Block, key: LinkClass) -> Expression:
    """The joint point in F_i; of a base whose motion is given its origin."""
    if not key.frame_at or key.joint.given:
        return zeros(3)
    f = b.parameter("frame_at", (1, 1))
    return stack(-f, zeros(1), zeros(1))
