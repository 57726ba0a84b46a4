"""The phases of the algorithms: what one link does on the way out to the tip or back to the base.

Block elimination of M_sys, tip to base: with the next link's reaction written as ``w = Lambda Vdot_T + p``
(tip frame), every link folds it in, eliminates its modal accelerations, then its joint coordinates, and
hands ``Lambda, p`` to its parent.  Base to tip follow the accelerations and the joint wrenches.

Gravity enters as an acceleration ``-g`` of the base, so that no block carries its weight.
"""

from __future__ import annotations

import numpy as np

from ..lower.program import Array
from . import matrices as mx
from .modes import eliminate_modes, modal_accelerations
from .scope import Scope

STATE = ("omega", "v")


def kinematics(s: Scope) -> None:
    """Base to tip: twists, biases and the deformed link's inertia, from q, qdot, eta, etadot."""
    q, qdot = s.read("q", s.key.joints), s.read("qdot", s.key.joints)
    parent = {"omega_P": s.read("base.omega", 3), "v_P": s.read("base.v", 3)}
    R, A, omega, v, beta_omega, beta_v = s.lower(
        "joint", {"q": q, "qdot": qdot, **parent}, "R_rel", "A", "omega", "v", "beta_omega", "beta_v"
    )
    keep_joint(s, R, A, np.concatenate([beta_omega, beta_v]))
    s.keep("twist", np.concatenate([omega, v]))
    link_terms(s, omega, v)


def keep_joint(s: Scope, R: Array, A: Array, beta: Array) -> None:
    """Store the joint; a column of A becomes six: the joint point may lie off the origin of F_i."""
    s.keep("R_rel", R)
    s.keep("A", np.vstack([A, mx.multiply(mx.hat(joint_point(s)), A)]))
    s.keep("beta", beta)


def link_terms(s: Scope, omega: Array, v: Array, g: Array | None = None) -> None:
    """Inertia and bias of the link and of its tip section at the twist ``omega, v``.

    ``g`` is the free fall in F_i, for blocks that carry their weight.
    """
    g = mx.zeros(3) if g is None else g
    eta, etadot = s.read("eta", s.key.modes), s.read("etadot", s.key.modes)
    state = {"omega": omega, "v": v, "g": g, "eta": eta, "etadot": etadot}
    I, S, M_D, h_V, h_eta = s.lower("link", state, "I", "S", "M_D", "h_V", "h_eta")
    m = s.lower("link", state, "m")[0].item()
    s.keep("M_V", mx.blocks(I, mx.hat(S), mx.identity(3) * m))
    s.keep("M_D", M_D)
    s.keep("h_V", h_V)
    s.keep("h_eta", h_eta)
    tip_terms(s, {"omega": omega, "v": v, "eta": eta, "etadot": etadot}, g)


def tip_terms(s: Scope, state: dict, g: Array) -> None:
    names = ["r_T", "omega_T", "v_T", "b_omega", "b_v", "Phi_c"]
    turned = ["R_T", "J_l", "Psi_c"] if s.key.section_rotation else []
    values = dict(zip(names + turned, s.lower("tip", state, *names, *turned), strict=True))
    s.keep("r_T", values["r_T"])
    s.keep("R_T", values.get("R_T", mx.identity(3)))
    G = mx.identity(6)
    if turned:
        G[:3, :3] = values["J_l"]
    s.keep("G", G)
    s.keep("E", np.vstack([values.get("Psi_c", mx.zeros(3, s.key.modes)), values["Phi_c"]]))
    s.keep("b_T", np.concatenate([values["b_omega"], values["b_v"]]))
    s.write("tip.omega", values["omega_T"])
    s.write("tip.v", values["v_T"])
    tip_bodies(s, values["omega_T"], values["v_T"], mx.multiply(s.kept("R_T").T, g))


def tip_bodies(s: Scope, omega: Array, v: Array, g: Array) -> None:
    state = {"omega_T": omega, "v_T": v, "g_T": g}
    m, S, I, tau, F = s.lower("tip_body", state, "m_T", "S_T", "I_T", "h_T_tau", "h_T_F")
    s.keep("M_T", mx.blocks(I, mx.hat(S), mx.identity(3) * m.item()))
    s.keep("h_T", np.concatenate([tau, F]))


def eliminate(s: Scope) -> None:
    """Tip to base: fold the tip's reaction in, eliminate modes and joint, hand the rest up."""
    M, h = eliminate_modes(s, *tip_reaction(s))
    Lambda, p = eliminate_joint(s, M, h)
    r_B, R = joint_point(s), s.kept("R_rel")
    s.keep("Lambda_i", Lambda)
    s.keep("p_i", p)
    with s.step("handed up: inertia and bias that the joint shows to the parent's tip (49)"):
        handed = mx.shift(mount(s), mx.rotate(R, mx.shift(-r_B, Lambda)))
        wrench = mx.shift_wrench(mount(s), mx.rotate_wrench(R, mx.shift_wrench(-r_B, p)))
        s.write("base.Lambda", mx.pack(handed))
        s.write("base.p", wrench)


def tip_reaction(s: Scope) -> tuple[Array, Array]:
    """``Lambda, p`` of all that the tip section carries, in F_i axes at the tip point, bias folded in."""
    with s.step("tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46)"):
        Lambda = mx.unpack(s.read("tip.Lambda", 21)) + s.kept("M_T")
        p = s.read("tip.p", 6) + s.kept("h_T") - s.read("w_ext", 6) + mx.multiply(Lambda, s.kept("b_T"))
        R = s.kept("R_T")
        return s.name("Lambda_T", mx.rotate(R, Lambda)), s.name("p_T", mx.rotate_wrench(R, p))


def eliminate_joint(s: Scope, M: Array, h: Array) -> tuple[Array, Array]:
    """Solve the joint's rows ``A^T w = tau - J_m qddot - b qdot - k q`` for qddot."""
    with s.step("joint: its accelerations eliminated from its rows (43)"):
        A = s.kept("A")
        U = s.name("U", mx.multiply(M, A))
        bias = s.name("bias", h + mx.multiply(M, s.kept("beta")))
        inertia = s.name("joint_inertia", mx.multiply(A.T, U) + armature(s))
        scale = s.tracer.epsilon() * 8.0 * (M[0, 0] + M[1, 1] + M[2, 2])
        L, inverse = mx.factorise(inertia, s.tracer, scale)
        Z = mx.forward(L, U.T)
        W = mx.scale_rows(Z, s.name("joint_inverse", inverse))
        torque = mx.forward(L, drive(s) - mx.multiply(A.T, bias))
        w = mx.scale_rows(torque, inverse)
        s.keep("joint_L", L)
        s.keep("joint_W", W)
        s.keep("joint_w", w)
        return s.name("Lambda_i", mx.subtract_product(M, Z, W)), s.name("p_i", bias + mx.multiply(Z.T, w))


def accelerate(s: Scope) -> None:
    """Base to tip: qddot, etaddot, the joint wrench, and the acceleration of the tip."""
    r_B, R = joint_point(s), s.kept("R_rel")
    with s.step("joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48)"):
        at_joint = mx.shift_twist(mount(s), s.read("base.alpha", 6))
        carried = s.name("carried", mx.shift_twist(-r_B, mx.rotate_wrench(R.T, at_joint)))
        qddot = mx.backward(s.kept("joint_L"), s.kept("joint_w") - mx.multiply(s.kept("joint_W"), carried))
        s.write("qddot", qddot)
        wrench = mx.multiply(s.kept("Lambda_i"), carried) + s.kept("p_i")
        s.write("wrench", mx.shift_wrench(-r_B, wrench))
    with s.step("link: acceleration of F_i, modal accelerations (83)"):
        alpha = carried + mx.multiply(s.kept("A"), qddot) + s.kept("beta")
        s.write("alpha", alpha)
        etaddot = modal_accelerations(s, alpha)
        s.write("etaddot", etaddot)
    with s.step("tip: acceleration of the tip section (accconst1b)"):
        s.name("alpha_T", tip_acceleration(s, alpha, etaddot))
        s.write("tip.alpha", tip_acceleration(s, alpha, etaddot))


def tip_acceleration(s: Scope, alpha: Array, etaddot: Array) -> Array:
    """``J_T nudot + b_T`` in tip-frame components."""
    elastic = mx.chain(s.kept("G"), s.kept("E"), etaddot)
    moved = mx.shift_twist(s.kept("r_T"), alpha) + elastic
    return mx.rotate_wrench(s.kept("R_T").T, moved) + s.kept("b_T")


# ---------------------------------------------------------------------------------- inverse dynamics


def inverse_outward(s: Scope) -> None:
    """Base to tip: accelerations that qddot and etaddot prescribe."""
    qddot, etaddot = s.read("qddot", s.key.joints), s.read("etaddot", s.key.modes)
    at_joint = mx.shift_twist(mount(s), s.read("base.alpha", 6))
    carried = mx.shift_twist(-joint_point(s), mx.rotate_wrench(s.kept("R_rel").T, at_joint))
    alpha = carried + mx.multiply(s.kept("A"), qddot) + s.kept("beta")
    s.keep("alpha", alpha)
    tip = tip_acceleration(s, alpha, etaddot)
    s.keep("alpha_T", tip)
    s.write("tip.alpha", tip)


def inverse_inward(s: Scope) -> None:
    """Tip to base: the wrenches that the accelerations need, and the generalised forces."""
    qddot, etaddot, alpha = s.read("qddot", s.key.joints), s.read("etaddot", s.key.modes), s.kept("alpha")
    at_tip = mx.multiply(s.kept("M_T"), s.kept("alpha_T")) + s.kept("h_T") - s.read("w_ext", 6) + s.read("tip.p", 6)
    load = mx.rotate_wrench(s.kept("R_T"), at_tip)
    M_D = s.kept("M_D")
    needed = mx.multiply(s.kept("M_V"), alpha) + mx.multiply(M_D, etaddot) + s.kept("h_V")
    total = needed + mx.shift_wrench(s.kept("r_T"), load)
    modal = mx.multiply(M_D.T, alpha) + s.read("m_eta", s.key.modes) * etaddot
    s.write(
        "force_eta",
        modal + s.kept("h_eta") + s.read("f_eta", s.key.modes) + mx.chain(s.kept("E").T, s.kept("G").T, load),
    )
    s.write(
        "force",
        mx.multiply(s.kept("A").T, total) + mx.multiply(armature(s), qddot) + passive(s, s.read("qdot", s.key.joints)),
    )
    at_joint = mx.rotate_wrench(s.kept("R_rel"), mx.shift_wrench(-joint_point(s), total))
    s.write("base.p", mx.shift_wrench(mount(s), at_joint))


# -------------------------------------------------------------------------------------- poses, energy


def poses(s: Scope) -> None:
    """Base to tip: rotation and position of F_i and of the tip section in the inertial frame."""
    (R_rel,) = s.lower("posture", {"q": s.read("q", s.key.joints)}, "R_rel")
    R_P, r_P = s.read("base.R", 3, 3), s.read("base.r", 3)
    with s.step("pose: rotation and position of F_i in the inertial frame (Ad)"):
        R = mx.multiply(R_P, R_rel)
        joint = r_P + mx.multiply(R_P, mount(s))
        r = joint - mx.multiply(R, joint_point(s))
        s.write("R", R)
        s.write("r", r)
    eta = {"eta": s.read("eta", s.key.modes)}
    r_T = s.lower("tip_pose", eta, "r_T")[0]
    R_T = s.lower("tip_pose", eta, "R_T")[0] if s.key.section_rotation else mx.identity(3)
    with s.step("pose: rotation and position of the tip section in the inertial frame (Ad)"):
        s.write("tip.R", s.name("R_tip", mx.multiply(R, R_T)))
        s.write("tip.r", s.name("r_tip", r + mx.multiply(R, r_T)))


def energy(s: Scope) -> None:
    """Energies of one link: kinetic, and potential of stress, joint springs and weight."""
    q, qdot, eta = s.read("q", s.key.joints), s.read("qdot", s.key.joints), s.read("eta", s.key.modes)
    twist = s.kept("twist")
    state = {"omega": twist[:3], "v": twist[3:], "g": mx.zeros(3), "eta": eta, "etadot": s.read("etadot", s.key.modes)}
    kinetic, stress, m, S = s.lower("energy", state, "kinetic", "stress", "m", "S")
    V_T = np.concatenate([s.read("tip.omega", 3), s.read("tip.v", 3)])
    body = mx.dot(V_T, mx.multiply(s.kept("M_T"), V_T))
    rotor = mx.dot(qdot, mx.multiply(armature(s), qdot))
    s.write("kinetic", [kinetic.item() + 0.5 * (body + rotor)])
    S_T, m_T = s.lower("tip_body", {"omega_T": V_T[:3], "v_T": V_T[3:], "g_T": mx.zeros(3)}, "S_T", "m_T")
    R, r, R_T, r_T = s.read("R", 3, 3), s.read("r", 3), s.read("tip.R", 3, 3), s.read("tip.r", 3)
    moment = m.item() * r + mx.multiply(R, S) + m_T.item() * r_T + mx.multiply(R_T, S_T)
    spring = mx.dot(q * stiffness(s), q)
    s.write("potential", [stress.item() + 0.5 * spring - mx.dot(s.read("gravity", 3), moment)])


# --------------------------------------------------------------------------------- parts of the joint


def joint_point(s: Scope) -> Array:
    """The joint point in F_i."""
    return mx.array([-s.constant("frame_at"), 0.0, 0.0]) if s.key.frame_at else mx.zeros(3)


def mount(s: Scope) -> Array:
    """The joint point relative to the parent's tip point, in the parent's tip frame."""
    return mx.array([s.constant(f"mount_xyz_{a}") for a in "xyz"]) if s.key.mount_xyz else mx.zeros(3)


def _per_axis(s: Scope, present: bool, label: str) -> Array:
    return mx.array([s.constant(f"{label}_{j + 1}") if present else 0.0 for j in range(s.key.joints)], (s.key.joints,))


def armature(s: Scope) -> Array:
    """The rotor inertias seen at the joint, on a diagonal."""
    values = _per_axis(s, s.key.armature, "armature")
    return mx.symmetric(s.key.joints, lambda i, j: values[i] if i == j else 0.0)


def stiffness(s: Scope) -> Array:
    return _per_axis(s, s.key.stiffness, "joint_stiffness")


def drive(s: Scope) -> Array:
    """``tau - b qdot - k q``: what motor, damper and spring give together."""
    n = s.key.joints
    return s.read("tau", n) - passive(s, s.read("qdot", n))


def passive(s: Scope, qdot: Array) -> Array:
    """``b qdot + k q``: what damper and spring need."""
    total = mx.zeros(s.key.joints)
    if s.key.joint_damping:
        total = total + _per_axis(s, True, "joint_damping") * qdot
    if s.key.stiffness:
        total = total + stiffness(s) * s.read("q", s.key.joints)
    return total
