"""The phases of the Z-form: its state becomes that of the DAE form, and rows and rates come back in Z.

Between them the phases of the DAE form run as they are.
"""

from __future__ import annotations

import math

from ..algorithms import matrices as mx
from ..algorithms.quaternions import quaternion_matrix, turn_quaternion
from ..algorithms.scope import Scope
from .z_form_blocks import z_form_block, z_rows_block

FULL_TURN = (2.0 * math.pi) ** 2 * (1.0 - 1e-10)
"""From this squared angle on there is no inverse Jacobian: |theta| = 2 pi, less what rounding makes of it."""

CHANGED = (
    ("joint_V", "joint_Z"),
    ("V_V", "Z_Z"),
    ("eta_V", "eta_Z"),
    ("next_V", "next_Z"),
    ("joint_H", "joint_H_Z"),
    ("V_H", "V_H_Z"),
    ("eta_H", "eta_H_Z"),
)
"""Blocks of the assembled system with their counterparts in the Z-form."""

H_MS = ("joint_h_Ms", "V_h_Ms")
"""``h_Ms`` of the dynamic rows, (HMs)."""


def z_state(s: Scope) -> None:
    """Attitude and twist of the link from ``theta_i``, ``r_i`` and ``Z_i``; what changes unknowns to ``Zdot``."""
    theta, Z = s.read("theta", 3), s.read("Z", 6)
    given = {"r": s.read("r", 3), "omega": Z[:3], "rdot": Z[3:]}
    V, T, gamma_star = s.lower(z_form_block(), given, "V", "T_gamma", "gamma_star")
    s.write("quaternion", turn_quaternion(s, theta))
    s.write("twist", V)
    s.write("T_gamma", T)
    s.write("gamma_star", gamma_star)


def z_rows(s: Scope) -> None:
    """Base to tip: the link's rows and columns in ``Zdot``; what the next joint's rows gain is handed on."""
    rows = {"joint_V": 6, "V_V": 6, "eta_V": s.key.modes, "next_V": 6}
    given = {name: s.read(name, size, 6) for name, size in rows.items()}
    given |= {"joint_H": s.read("joint_H", 6), "V_H": s.read("V_H", 6), "eta_H": s.read("eta_H", s.key.modes)}
    given |= {
        "T_gamma": s.read("T_gamma", 6, 6),
        "gamma_star": s.read("gamma_star", 6),
        "h_base": s.read("base.h_M", 6),
    }
    block = z_rows_block(s.key)
    for (old, _), value in zip(CHANGED, s.lower(block, given, *(new for _, new in CHANGED)), strict=True):
        s.write(old, value)
    for name, value in zip(H_MS, s.lower(block, given, *H_MS), strict=True):
        s.write(name, value)
    s.write("tip.h_M", s.lower(block, given, "h_next")[0])


def z_rates(s: Scope) -> None:
    """``J(theta_i)^-1`` and the solution's ``Zdot_i``."""
    theta, Z = s.read("theta", 3), s.read("Z", 6)
    given = {"theta": theta, "r": s.read("r", 3), "omega": Z[:3], "rdot": Z[3:], "Vdot_solved": s.read("Vdot", 6)}
    J_inverse, Zdot = s.lower(z_form_block(), given, "J_inverse", "Zdot_solved")
    s.write("J_inverse", J_inverse)
    s.write("Zdot", Zdot)
    s.write("margin", [FULL_TURN - mx.dot(theta, theta)])


def z_place(s: Scope) -> None:
    """``r_i`` and ``Z_i`` where forward kinematics has put the link."""
    R, V = quaternion_matrix(s.read("new_quaternion", 4)), s.read("new_twist", 6)
    r = mx.multiply(R.T, s.read("new_position", 3))
    (gamma,) = s.lower(z_form_block(), {"r": r, "omega": V[:3]}, "gamma")
    s.write("r", r)
    s.write("Z", V - gamma)
