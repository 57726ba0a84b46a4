"""The phases of a state's motion: poses, twists and energies of one link, base to tip."""

from __future__ import annotations

import numpy as np

from ..ir.program import Array
from . import matrices as mx
from .axis_terms import armature, axis_energies, spring
from .joint_terms import joint_offset, joint_point, rotation
from .scope import Scope


def poses(s: Scope) -> None:
    """Base to tip: rotation and position of F_i and of the tip section in the inertial frame."""
    R_rel = s.kept("R_rel") if "R_rel" in s.layouts else rotation(s, s.read("q"))
    tips = [(section, *_tip_pose(section)) for section in s.sections]
    R_P, r_P = s.read("base.R"), s.read("base.r")
    with s.step("pose: rotation and position of F_i in the inertial frame (Ad)"):
        if s.key.floats:
            R, r = R_rel, s.read("q")[:3]
        else:
            R = mx.multiply(R_P, R_rel)
            joint = r_P + mx.multiply(R_P, joint_offset(s, s.read("q") if s.key.slides else mx.zeros(0)))
            r = joint - mx.multiply(R, joint_point(s))
        s.write("R", R)
        s.write("r", r)
    for section, R_T, r_T in tips:
        with s.step("pose: rotation and position of the tip section in the inertial frame (Ad)"):
            section.write("tip.R", s.name("R_tip", mx.multiply(R, R_T), "R"))
            section.write("tip.r", s.name("r_tip", r + mx.multiply(R, r_T), "r"))


def _tip_pose(s: Scope) -> tuple[Array, Array]:
    """``R_T, r_T``, stored by an earlier phase or computed."""
    if "R_rel" in s.layouts:
        return s.kept("R_T"), s.kept("r_T")
    eta = {"eta": s.read("eta")}
    r_T = s.lower("tip_pose", eta, "r_T")[0]
    R_T = s.lower("tip_pose", eta, "R_T")[0] if s.key.section_rotation else mx.identity(3)
    return R_T, r_T


def velocities(s: Scope) -> None:
    """Base to tip: the twists of F_i and of the tip section, each in its own frame."""
    if s.key.floats:
        omega, v = np.split(s.read("qdot"), 2)
    else:
        parent = {"omega_P": s.read("base.omega_T"), "v_P": s.read("base.v_T")}
        omega, v = s.lower("joint", {"q": s.read("q"), "qdot": s.read("qdot"), **parent}, "omega", "v")
    s.keep("twist", np.concatenate([omega, v]))
    modal = {"eta": s.read("eta"), "etadot": s.read("etadot")}
    for section in s.sections:
        omega_T, v_T = section.lower("tip", {"omega": omega, "v": v, **modal}, "omega_T", "v_T")
        section.write("tip.omega_T", omega_T)
        section.write("tip.v_T", v_T)


def tip_twist(s: Scope) -> None:
    """The twist of the tip section, at the tip point, in inertial axes."""
    R = s.read("tip.R")
    s.write("tip_twist", [*mx.multiply(R, s.read("tip.omega_T")), *mx.multiply(R, s.read("tip.v_T"))])


def energy(s: Scope) -> None:
    """Energies of one link: kinetic, and potential of stress, joint springs and weight."""
    q, qdot, eta = s.read("q"), s.read("qdot"), s.read("eta")
    twist = s.kept("twist")
    state = {"omega": twist[:3], "v": twist[3:], "g": mx.zeros(3), "eta": eta, "etadot": s.read("etadot")}
    kinetic, stress, m, S = s.lower("energy", state, "kinetic", "stress", "m", "S")
    V_T = np.concatenate([s.read("tip.omega_T"), s.read("tip.v_T")])
    still = {"omega_T": V_T[:3], "v_T": V_T[3:], "g_T": mx.zeros(3)}
    m_T, S_T, I_T = s.lower("tip_body", still, "m_T", "S_T", "I_T")
    M_T = mx.blocks(I_T, mx.hat(S_T), mx.identity(3) * m_T.item())
    body = mx.dot(V_T, mx.multiply(M_T, V_T))
    spin, wound = axis_energies(s, q, qdot)
    added = mx.dot(qdot, armature(s) * qdot) + spin
    s.write("kinetic", [kinetic.item() + 0.5 * (body + added)])
    R, r, R_T, r_T = s.read("R"), s.read("r"), s.read("tip.R"), s.read("tip.r")
    moment = m.item() * r + mx.multiply(R, S) + m_T.item() * r_T + mx.multiply(R_T, S_T)
    springs = (mx.dot(q * spring(s), q) if s.key.stiffness else 0.0) + wound
    s.write("potential", [stress.item() + 0.5 * springs - mx.dot(s.read("gravity"), moment)])
