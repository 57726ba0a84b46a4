"""Change of reference: rows that act on a motion ``[omega; omegadot; a]``, and wrenches, at another node."""

from __future__ import annotations

import numpy as np

from ..ir.program import Array
from . import matrices as mx


def to_parent(
    rows: Array, R: Array, omega: Array, omega_J: Array, omega_P: Array, r_B: Array, r_J: Array, v_J: Array
) -> Array:
    """Rows (k, 9) on the motion of F_i, converted to rows on the motion of the parent's tip, in tip-frame components.

    ``r_J`` is the joint point relative to the parent's tip and ``v_J`` its relative velocity, both in that frame.
    """
    rows = offset(rows, omega, -r_B, mx.zeros(3))
    rows = np.hstack([rows[:, :3] + cross_rows(omega_J, rows[:, 3:6]), rows[:, 3:]])
    return offset(rotated_rows(R, rows), omega_P, r_J, v_J)


def to_link(rows: Array, R_T: Array, r_T: Array, udot: Array, omega_s: Array, omega: Array) -> tuple[Array, Array]:
    """Rows on the tip section's motion in F_i axes: at the tip point, and converted to rows on the motion of F_i."""
    tip = rotated_rows(R_T, rows)
    moved = offset(tip, omega, r_T, udot)
    return tip, np.hstack([moved[:, :3] + cross_rows(omega_s, tip[:, 3:6]), moved[:, 3:]])


def offset(rows: Array, omega: Array, r: Array, udot: Array) -> Array:
    """Rows on the motion of the point ``r``, of relative velocity ``udot``, converted to rows on that of the origin."""
    a = rows[:, 6:]
    return np.hstack([rows[:, :3] + mx.multiply(a, swing(omega, r, udot)), rows[:, 3:6] + cross_rows(r, a), a])


def rotated_rows(R: Array, rows: Array) -> Array:
    return np.hstack([mx.multiply(rows[:, k : k + 3], R.T) for k in range(0, rows.shape[1], 3)])


def rotated_columns(R: Array, wrenches: Array) -> Array:
    return np.vstack([mx.multiply(R, wrenches[:3]), mx.multiply(R, wrenches[3:])])


def shifted(r: Array, wrenches: Array) -> Array:
    """Wrenches at the point ``r``, one per column, expressed about the origin."""
    return np.vstack([wrenches[:3] + mx.multiply(mx.hat(r), wrenches[3:]), wrenches[3:]])


def cross_columns(a: Array, columns: Array) -> Array:
    """``a x`` every column."""
    return mx.multiply(mx.hat(a), columns)


def columns_cross(columns: Array, b: Array) -> Array:
    """Every column ``x b``."""
    return -mx.multiply(mx.hat(b), columns)


def cross_rows(a: Array, rows: Array) -> Array:
    """``a x`` every row."""
    return mx.multiply(rows, mx.hat(a).T)


def swing(omega: Array, r: Array, udot: Array) -> Array:
    """Derivative of ``omega x (omega x r) + 2 omega x udot`` with omega."""
    turned = mx.hat(mx.cross(omega, r) + 2.0 * udot)
    return -turned - mx.multiply(mx.hat(omega), mx.hat(r))
