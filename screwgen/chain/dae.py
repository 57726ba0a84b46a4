"""The phases of the DAE form: twists are state, the joints hold by projection, M_sys can be assembled.

State of a link: unit quaternion and position of F_i, eta, twist, etadot, and the joint coordinates as
memory.  ``qdot = A^+ (omega_i - R_rel^T omega_T)``; the rest is the block elimination of the joint form.
"""

from __future__ import annotations

import numpy as np

from ..lower.program import Array, Tracer
from . import matrices as mx
from .phases import armature, joint_point, keep_joint, link_terms, mount, passive
from .scope import Scope


def dae_kinematics(s: Scope) -> None:
    """Base to tip: the joint's rates from the twists, then biases and inertia at the link's own twist."""
    twist = s.read("twist", 6)
    _joint_from_twist(s, twist)
    link_terms(s, twist[:3], twist[3:])


def _joint_from_twist(s: Scope, twist: Array) -> Array:
    """The joint's rates, its rows' ingredients stored."""
    q, omega_P = s.read("q", s.key.joints), s.read("base.omega", 3)
    R, A = s.lower("posture", {"q": q}, "R_rel", "A")
    qdot = mx.multiply(pseudo_inverse(A, s.tracer), twist[:3] - mx.multiply(R.T, omega_P))
    s.write("qdot", qdot)
    state = {"q": q, "qdot": qdot, "omega_P": omega_P, "v_P": s.read("base.v", 3)}
    R, A, beta_omega, beta_v = s.lower("joint", state, "R_rel", "A", "beta_omega", "beta_v")
    keep_joint(s, R, A, np.concatenate([beta_omega, beta_v]))
    return qdot


def pseudo_inverse(A: Array, tracer: Tracer) -> Array:
    """``A^+ = (A^T A)^-1 A^T`` of the joint's axes; a singular posture fails the guard."""
    L, inverse = mx.factorise(mx.congruence(A, mx.identity(3)), tracer, tracer.epsilon() * 64.0)
    columns = mx.scale_rows(mx.forward(L, A.T), inverse)
    return mx.backward(L, columns)


def twist_rates(s: Scope) -> None:
    """The rate of the link's twist: the free fall that the elimination left out is added."""
    R = quaternion_matrix(s.read("quaternion", 4))
    fall = mx.multiply(R.T, s.read("gravity", 3))
    alpha = s.read("alpha", 6)
    s.write("Vdot", np.concatenate([alpha[:3], alpha[3:] + fall]))


def pose_rates(s: Scope) -> None:
    """``d/dt`` of the pose: quaternion ``Q omega / 2`` and position ``R v``."""
    Q, twist = s.read("quaternion", 4), s.read("twist", 6)
    s.write("quaternion_rate", 0.5 * quaternion_product(Q, np.concatenate([mx.zeros(1), twist[:3]])))
    s.write("position_rate", mx.multiply(quaternion_matrix(Q), twist[3:]))


# ------------------------------------------------------------------------------------------ projection


def project(s: Scope) -> None:
    """Base to tip: two Gauss-Newton corrections of q from the poses, then forward kinematics."""
    q, twist, eta, etadot = s.read("q", s.key.joints), s.read("twist", 6), *_modal(s)
    R_raw = quaternion_matrix(s.read("quaternion", 4))
    measured = mx.multiply(s.read("base.R_m", 3, 3).T, R_raw)
    for _ in range(2):
        R, A = s.lower("posture", {"q": q}, "R_rel", "A")
        q = q + mx.multiply(pseudo_inverse(A, s.tracer), _half_skew(mx.multiply(R.T, measured)))
    R, A = s.lower("posture", {"q": q}, "R_rel", "A")
    qdot = mx.multiply(pseudo_inverse(A, s.tracer), twist[:3] - mx.multiply(R.T, s.read("base.omega_m", 3)))
    s.write("new_q", q)
    _measured_tip(s, R_raw, twist, eta, etadot)
    _place(s, q, qdot, eta, etadot)


def forward_kinematics(s: Scope) -> None:
    """Base to tip: poses and twists of the DAE form from q and qdot."""
    _place(s, s.read("q", s.key.joints), s.read("qdot", s.key.joints), *_modal(s))


def _modal(s: Scope) -> tuple[Array, Array]:
    return s.read("eta", s.key.modes), s.read("etadot", s.key.modes)


def _half_skew(E: Array) -> Array:
    """The axis times the sine of the angle of a rotation."""
    return 0.5 * mx.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]])


def _measured_tip(s: Scope, R: Array, twist: Array, eta: Array, etadot: Array) -> None:
    """Rotation and angular velocity of the tip as the unprojected state has them."""
    state = {"omega": twist[:3], "v": twist[3:], "eta": eta, "etadot": etadot}
    s.write("tip.omega_m", s.lower("tip", state, "omega_T")[0])
    s.write("tip.R_m", mx.multiply(R, _tip_rotation(s, eta)))


def _tip_rotation(s: Scope, eta: Array) -> Array:
    return s.lower("tip_pose", {"eta": eta}, "R_T")[0] if s.key.section_rotation else mx.identity(3)


def _place(s: Scope, q: Array, qdot: Array, eta: Array, etadot: Array) -> None:
    parent = {"omega_P": s.read("base.omega", 3), "v_P": s.read("base.v", 3)}
    R_rel, omega, v = s.lower("joint", {"q": q, "qdot": qdot, **parent}, "R_rel", "omega", "v")
    s.write("new_twist", np.concatenate([omega, v]))
    R = mx.multiply(s.read("base.R", 3, 3), R_rel)
    r = s.read("base.r", 3) + mx.multiply(s.read("base.R", 3, 3), mount(s)) - mx.multiply(R, joint_point(s))
    Q = quaternion_product(s.read("base.Q", 4), _joint_quaternion(s, q))
    s.write("new_quaternion", Q)
    s.write("new_position", r)
    state = {"omega": omega, "v": v, "eta": eta, "etadot": etadot}
    r_T, omega_T, v_T = s.lower("tip", state, "r_T", "omega_T", "v_T")
    s.write("tip.omega", omega_T)
    s.write("tip.v", v_T)
    s.write("tip.R", mx.multiply(R, _tip_rotation(s, eta)))
    s.write("tip.r", r + mx.multiply(R, r_T))
    s.write("tip.Q", quaternion_product(Q, _tip_quaternion(s, eta)))


# ----------------------------------------------------------------------------------------- quaternions


def quaternion_product(a: Array, b: Array) -> Array:
    """The quaternion product, (w, x, y, z)."""
    scalar = a[0] * b[0] - mx.dot(a[1:], b[1:])
    return np.concatenate([mx.array([scalar]), a[0] * b[1:] + b[0] * a[1:] + mx.cross(a[1:], b[1:])])


def quaternion_matrix(Q: Array) -> Array:
    """The rotation of a quaternion of any length."""
    scale = 2.0 / mx.dot(Q, Q)
    w, u = Q[0], Q[1:]
    square = mx.symmetric(3, lambda i, j: u[i] * u[j] - (mx.dot(u, u) if i == j else 0.0))
    return mx.identity(3) + scale * (w * mx.hat(u) + square)


def _axis_quaternion(s: Scope, axis, angle) -> Array:
    half = 0.5 * angle
    sine = s.tracer.call("sin", half)
    return mx.array([s.tracer.call("cos", half), *(sine * a for a in axis)])


def _joint_quaternion(s: Scope, q: Array) -> Array:
    """The quaternion of ``R_rel``: the mount, then every axis."""
    turns = []
    if s.key.mount_rpy:
        turns += [_axis_quaternion(s, mx.identity(3)[k], s.constant(f"mount_rpy_{'xyz'[k]}")) for k in (2, 1, 0)]
    turns += [_axis_quaternion(s, axis, angle) for axis, angle in zip(s.key.axes, q, strict=True)]
    total = mx.array([1.0, 0.0, 0.0, 0.0])
    for turn in turns:
        total = quaternion_product(total, turn)
    return total


def _tip_quaternion(s: Scope, eta: Array) -> Array:
    """``exp(theta)`` as a quaternion: ``[c_0(x/4), c_1(x/4) theta / 2]``, regular at rest."""
    if not s.key.section_rotation:
        return mx.array([1.0, 0.0, 0.0, 0.0])
    (theta,) = s.lower("tip_pose", {"eta": eta}, "theta")
    quarter = 0.25 * mx.dot(theta, theta)
    c2 = 0.5 - quarter * s.tracer.call("c4", quarter)
    c3 = 1.0 / 6.0 - quarter * s.tracer.call("c5", quarter)
    return np.concatenate([mx.array([1.0 - quarter * c2]), (0.5 * (1.0 - quarter * c3)) * theta])


# ------------------------------------------------------------------------------------------- assembly


def joint_rows(s: Scope) -> None:
    """Base to tip: the completed rows of the joint, (accconst4) with what the motors supply."""
    twist, eta, etadot = s.read("twist", 6), *_modal(s)
    qdot = _joint_from_twist(s, twist)
    g = mx.multiply(quaternion_matrix(s.read("quaternion", 4)).T, s.read("gravity", 3))
    link_terms(s, twist[:3], twist[3:], g)
    _completed_rows(s, qdot)
    s.write("tip.b", s.kept("b_T"))


def _completed_rows(s: Scope, qdot: Array) -> None:
    R, A, r_B = s.kept("R_rel"), s.kept("A")[:3], joint_point(s)
    plus = pseudo_inverse(A, s.tracer)
    motor = mx.multiply(A, plus)
    free = mx.identity(3) - motor
    operator = mx.identity(6)
    operator[:3, :3] = free + mx.chain(plus.T, armature(s), plus)
    X = mx.multiply(_twice(R.T), _lever(mount(s)))
    from_parent = mx.multiply(operator, X)
    bias = -mx.chain(operator, _lever(r_B), s.kept("beta")) - mx.multiply(from_parent, s.read("base.b", 6))
    joint = mx.zeros(6, 6)
    joint[:3, :3] = motor
    s.write("joint_w", joint)
    s.write("joint_V", mx.multiply(operator, _lever(r_B)))
    s.write("joint_H", bias + np.concatenate([mx.multiply(plus.T, passive(s, qdot)), mx.zeros(3)]))
    s.write("joint_W", np.concatenate([mx.multiply(plus.T, s.read("tau", s.key.joints)), mx.zeros(3)]))
    s.write("base.X", X)
    s.write("base.PX", from_parent)


def link_rows(s: Scope) -> None:
    """Tip to base: the link's six rows and its modal rows, and its columns in the next joint's rows."""
    X, PX, r = s.read("tip.X", 6, 6), s.read("tip.PX", 6, 6), s.key.modes
    turn = _twice(s.kept("R_T").T)
    J_V, J_eta = mx.multiply(turn, _lever(s.kept("r_T"))), mx.chain(turn, s.kept("G"), s.kept("E"))
    M_T, M_D = s.kept("M_T"), s.kept("M_D")
    carried = mx.multiply(M_T, s.kept("b_T")) + s.kept("h_T")
    rigid, coupled = mx.congruence(J_V, M_T), mx.chain(J_V.T, M_T, J_eta) + M_D
    elastic, m_eta = mx.congruence(J_eta, M_T), s.read("m_eta", r)
    s.write("next_V", -mx.multiply(PX, J_V))
    s.write("next_eta", -mx.multiply(PX, J_eta))
    s.write("V_w", -_lever(joint_point(s)).T)
    s.write("V_V", s.kept("M_V") + rigid)
    s.write("V_eta", coupled)
    s.write("V_next", mx.multiply(J_V.T, X.T))
    s.write("eta_V", coupled.T)
    s.write("eta_eta", mx.symmetric(r, lambda i, j: elastic[i, j] + (m_eta[i] if i == j else 0.0)))
    s.write("eta_next", mx.multiply(J_eta.T, X.T))
    s.write("V_H", s.kept("h_V") + mx.multiply(J_V.T, carried))
    s.write("eta_H", s.kept("h_eta") + s.read("f_eta", r) + mx.multiply(J_eta.T, carried))
    w_ext = s.read("w_ext", 6)
    s.write("V_W", mx.multiply(J_V.T, w_ext))
    s.write("eta_W", mx.multiply(J_eta.T, w_ext))


def _lever(r: Array) -> Array:
    """``[[I, 0], [-hat(r), I]]``: the twist of the point ``r`` from that of the origin."""
    out = mx.identity(6)
    out[3:, :3] = -mx.hat(r)
    return out


def _twice(R: Array) -> Array:
    out = mx.zeros(6, 6)
    out[:3, :3] = out[3:, 3:] = R
    return out
