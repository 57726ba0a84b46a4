"""The phases of the DAE form: twists as states, projection onto the joint constraints, assembly of M_sys.

The state of a link is the unit quaternion and position of F_i, eta, the twist and etadot. The joint coordinates are
redundant; the motion subspace is evaluated at them, and the projection starts from them. Joint rates follow from the
twists, ``qdot = A^+ (omega_i - R_rel^T omega_T)`` for revolute joints; the rest is the joint form's elimination.
"""

from __future__ import annotations

import numpy as np

from ..ir.program import Array
from ..joints.exponential import Series
from . import brakes
from . import matrices as mx
from .axis_terms import joint_torque
from .joint_terms import joint_offset, joint_point, rotation
from .phases import joint_motion, motion_in_space, relative_posture, tip_motion, tip_state
from .quaternions import (
    joint_quaternion,
    quaternion_matrix,
    quaternion_product,
    tip_quaternion,
    unit_coordinates,
    unit_quaternion,
)
from .scope import Scope
from .signals import PER_CHILD
from .tendons import pulled


def dae_kinematics(s: Scope) -> None:
    """Base to tip: the joint's rates from the twists, then the motion as in the joint form."""
    if s.key.floats:
        motion_in_space(s, stated_pose(s), s.read("twist"))
        s.write("qdot", mx.zeros(0))
    else:
        _joint_kinematics(s)
    for section in s.sections:
        tip_motion(section)
        section.write("tip.v", section.lower("tip_motion", tip_state(s, s.read("twist")), "v_t")[0])


def stated_pose(s: Scope) -> Array:
    """The coordinates of a floating base, which this form states as position and quaternion."""
    return np.concatenate([s.read("position"), s.read("quaternion")])


def _joint_kinematics(s: Scope) -> None:
    q, twist, omega_R, v_R = s.read("q"), s.read("twist"), relative_posture(s), mx.zeros(3)
    if s.key.slides:
        mounted = mx.multiply(s.kept("R_rel").T, joint_offset(s, q))
        v_R = mx.multiply(s.kept("R_P").T, s.read("base.v")) + mx.cross(omega_R, mounted)
    qdot = mx.multiply(pseudo_inverse(s, q), _difference(s, twist, omega_R, v_R))
    s.write("qdot", qdot)
    joint_motion(s, q, qdot, omega_R)


def _relative_twist(s: Scope, q: Array, R: Array, twist: Array, omega: str, v: str) -> Array:
    """The joint's relative twist in F_i axes; ``omega`` and ``v`` are the names of the parent's tip twist."""
    omega_P, v_R = s.read(f"base.{omega}"), mx.zeros(3)
    if s.key.slides:
        v_R = mx.multiply(R.T, s.read(f"base.{v}") + mx.cross(omega_P, joint_offset(s, q)))
    return _difference(s, twist, mx.multiply(R.T, omega_P), v_R)


def _difference(s: Scope, twist: Array, omega_R: Array, v_R: Array) -> Array:
    """The link's twist at the joint point less that of the parent there; a joint that only turns has no linear part."""
    turning = twist[:3] - omega_R
    if not s.key.slides:
        return turning
    return np.concatenate([turning, twist[3:] + mx.cross(twist[:3], joint_point(s)) - v_R])


def pseudo_inverse(s: Scope, q: Array) -> Array:
    """``S^+ = (S^T S)^-1 S^T`` of the motion subspace at the joint point; a singular posture fails the guard.

    Twists are multiplied by their components in rad/s and m/s. A revolute joint has rows of three, because the linear
    part of its motion subspace is zero.
    """
    S = motion_subspace(s, q)
    L, inverse = mx.factorise(mx.congruence(S, mx.identity(S.shape[0])), s.tracer, s.tracer.epsilon() * 64.0)
    columns = mx.scale_rows(mx.forward(L, S.T), inverse)
    return mx.backward(L, columns)


def motion_subspace(s: Scope, q: Array) -> Array:
    """The motion subspace at the joint point in F_i axes: the angular part, then the linear part if there is one."""
    if not s.key.slides:
        return s.lower("posture", {"q": q}, "A")[0]
    return np.vstack(s.lower("posture", {"q": q}, "A", "T"))


def twist_rates(s: Scope) -> None:
    """The rate of the link's twist in F_i components; the elimination's accelerations are less free fall.

    That of a floating base is what the elimination solves for.
    """
    if s.key.floats:
        s.write("Vdot", s.read("qddot"))
        return
    R = quaternion_matrix(s.read("quaternion"))
    fall = mx.multiply(R.T, s.read("gravity"))
    alpha, twist = s.read("alpha"), s.read("twist")
    s.write("Vdot", np.concatenate([alpha[:3], alpha[3:] + fall - mx.cross(twist[:3], twist[3:])]))


def pose_rates(s: Scope) -> None:
    """``d/dt`` of the pose: quaternion ``Q omega / 2`` and position ``R v``."""
    Q, twist = s.read("quaternion"), s.read("twist")
    s.write("quaternion_rate", 0.5 * quaternion_product(Q, np.concatenate([mx.zeros(1), twist[:3]])))
    s.write("position_rate", mx.multiply(quaternion_matrix(Q), twist[3:]))


# ------------------------------------------------------------------------------------------ projection


def project(s: Scope) -> None:
    """Base to tip: two Gauss-Newton corrections of q from the poses, then forward kinematics.

    Of a floating base only the length of the quaternion is corrected.
    """
    q, twist, eta, etadot = _redundant(s), s.read("twist"), *_modal(s)
    R_raw = quaternion_matrix(s.read("quaternion"))
    if s.key.floats:
        s.write("new_q", q)
        _measured_tip(s, R_raw, twist, eta, etadot)
        _place(s, q, q, eta, etadot)
        return
    R_P = s.read("base.R_m")
    measured = mx.multiply(R_P.T, R_raw)
    r_raw = s.read("position") + mx.multiply(R_raw, joint_point(s)) if s.key.slides else None
    for _ in range(2):
        (R,) = s.lower("posture", {"q": q}, "R_rel")
        error = _half_skew(mx.multiply(R.T, measured))
        if r_raw is not None:
            gap = mx.multiply(R_P.T, r_raw - s.read("base.r_m")) - joint_offset(s, q)
            error = np.concatenate([error, mx.multiply(R.T, gap)])
        q = s.key.joint.integrate(q, mx.multiply(pseudo_inverse(s, q), error), series_of(s))
    q = unit_coordinates(s, q)
    (R,) = s.lower("posture", {"q": q}, "R_rel")
    qdot = mx.multiply(pseudo_inverse(s, q), _relative_twist(s, q, R, twist, "omega_m", "v_m"))
    s.write("new_q", q)
    _measured_tip(s, R_raw, twist, eta, etadot)
    _place(s, q, qdot, eta, etadot)


def series_of(s: Scope) -> Series:
    """The Stumpff functions of what a phase records."""
    return Series(lambda x: s.tracer.call("c4", x), lambda x: s.tracer.call("c5", x))


def _redundant(s: Scope) -> Array:
    """The joint coordinates beside the poses; a floating base has none."""
    return mx.zeros(0) if s.key.floats else s.read("q")


def forward_kinematics(s: Scope) -> None:
    """Base to tip: poses and twists of the DAE form from q and qdot."""
    q = _redundant(s)
    _place(s, q, q if s.key.floats else s.read("qdot"), *_modal(s))


def _modal(s: Scope) -> tuple[Array, Array]:
    return s.read("eta"), s.read("etadot")


def _half_skew(E: Array) -> Array:
    """The axis times the sine of the angle of a rotation."""
    return 0.5 * mx.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]])


def _measured_tip(s: Scope, R: Array, twist: Array, eta: Array, etadot: Array) -> None:
    """Pose and twist of the tip as the unprojected state has them."""
    state = {"omega": twist[:3], "v": twist[3:], "eta": eta, "etadot": etadot}
    for section in s.sections:
        omega_T, v_T, r_T = section.lower("tip", state, "omega_T", "v_T", "r_T")
        section.write("tip.omega_m", omega_T)
        section.write("tip.v_m", v_T)
        section.write("tip.R_m", mx.multiply(R, _tip_rotation(section, eta)))
        section.write("tip.r_m", s.read("position") + mx.multiply(R, r_T))


def _tip_rotation(s: Scope, eta: Array) -> Array:
    return s.lower("tip_pose", {"eta": eta}, "R_T")[0] if s.key.section_rotation else mx.identity(3)


def _place(s: Scope, q: Array, qdot: Array, eta: Array, etadot: Array) -> None:
    if s.key.floats:
        omega, v = np.split(s.read("twist"), 2)
        pose = stated_pose(s)
        R, r, Q = rotation(s, pose), pose[:3], unit_quaternion(s, pose[3:])
    else:
        parent = {"omega_P": s.read("base.omega_T"), "v_P": s.read("base.v_T")}
        R_rel, omega, v = s.lower("joint", {"q": q, "qdot": qdot, **parent}, "R_rel", "omega", "v")
        R = mx.multiply(s.read("base.R"), R_rel)
        r = s.read("base.r") + mx.multiply(s.read("base.R"), joint_offset(s, q)) - mx.multiply(R, joint_point(s))
        Q = quaternion_product(s.read("base.Q"), joint_quaternion(s, q))
    s.write("new_twist", np.concatenate([omega, v]))
    s.write("new_quaternion", Q)
    s.write("new_position", r)
    state = {"omega": omega, "v": v, "eta": eta, "etadot": etadot}
    for section in s.sections:
        r_T, omega_T, v_T = section.lower("tip", state, "r_T", "omega_T", "v_T")
        section.write("tip.omega_T", omega_T)
        section.write("tip.v_T", v_T)
        section.write("tip.R", mx.multiply(R, _tip_rotation(section, eta)))
        section.write("tip.r", r + mx.multiply(R, r_T))
        section.write("tip.Q", quaternion_product(Q, tip_quaternion(section, eta)))


# ------------------------------------------------------------------------------------------- assembly


JOINT_ROWS = ("joint_w", "joint_V", "joint_H", "joint_W")
LINK_ROWS = (
    "next_V",
    "next_eta",
    "V_w",
    "V_V",
    "V_eta",
    "V_next",
    "eta_V",
    "eta_eta",
    "eta_next",
    "V_H",
    "eta_H",
    "V_W",
    "eta_W",
)


def joint_rows(s: Scope) -> None:
    """Base to tip: the six rows of the joint, (accconst4) completed by the torque balance; of a floating base w = 0,
    or where its motion is given Vdot = a."""
    twist, q = s.read("twist"), _redundant(s)
    if s.key.floats:
        _free_terms(s, twist)
        _write_biases(s)
        _write_rows(s, {"base_rate": s.read("base_rate")} if s.key.joint.given else {})
        return
    parent = {"omega_P": s.read("base.omega_T"), "v_P": s.read("base.v_T")}
    (R,) = s.lower("posture", {"q": q}, "R_rel")
    S_plus = pseudo_inverse(s, q)
    qdot = mx.multiply(S_plus, _relative_twist(s, q, R, twist, "omega_T", "v_T"))
    beta = s.lower("joint", {"q": q, "qdot": qdot, **parent}, "beta_omega", "beta_v")
    _free_terms(s, twist)
    tau, inertia = joint_torque(s, q, qdot)
    given = {
        "R_rel": R,
        "S": motion_subspace(s, q),
        "S_plus": S_plus,
        "r_J": joint_offset(s, q),
        "beta": np.concatenate(beta),
        "b_P": s.read("base.b"),
        "tau": tau,
        "J_m": inertia,
        "qdot": qdot,
        "q": q,
    }
    if s.key.brakes:
        given |= brakes.by_axis(s, qdot)
    _write_rows(s, given)
    X, PX = s.lower("joint_rows", given, "X", "PX")
    s.write("base.X", X)
    s.write("base.PX", PX)
    _write_biases(s)


def _write_biases(s: Scope) -> None:
    for section in s.sections:
        section.write("tip.b", section.kept("b_T"))


def _write_rows(s: Scope, given: dict[str, Array]) -> None:
    for name, value in zip(JOINT_ROWS, s.lower("joint_rows", given, *JOINT_ROWS), strict=True):
        s.write(name, value)


def _free_terms(s: Scope, twist: Array) -> None:
    """Store inertia and bias force of the link, of its tip section and of the tip bodies, weight included."""
    g = mx.multiply(quaternion_matrix(s.read("quaternion")).T, s.read("gravity"))
    state = {"omega": twist[:3], "v": twist[3:], "g": g}
    state |= {"eta": s.read("eta"), "etadot": s.read("etadot")}
    names = ("I", "S", "M_D", "h_V", "h_eta", "m", "M_bent")
    I, S, M_D, h_V, h_eta, m, M_bent = s.lower("link", state, *names)
    s.keep("M_bent", M_bent)
    s.keep("M_V", mx.blocks(I, mx.hat(S), mx.identity(3) * m.item()))
    s.keep("M_D", M_D)
    s.keep("h_V", h_V)
    s.keep("h_eta", h_eta)
    for section in s.sections:
        _tip_terms(section, state, g)


def _tip_terms(s: Scope, state: dict[str, Array], g: Array) -> None:
    """The same of a section: its pose, its Jacobian and the bodies there."""
    names = ["r_T", "omega_T", "v_T", "b_omega", "b_v", "Phi_c"]
    turned = ["R_T", "J_l", "Psi_c"] if s.key.section_rotation else []
    values = dict(zip(names + turned, s.lower("tip", state, *names, *turned), strict=True))
    for name, absent in (("R_T", mx.identity(3)), ("J_l", mx.identity(3)), ("Psi_c", mx.zeros(3, s.key.modes))):
        s.keep(name, values.get(name, absent))
    s.keep("r_T", values["r_T"])
    s.keep("Phi_c", values["Phi_c"])
    s.keep("b_T", np.concatenate([values["b_omega"], values["b_v"]]))
    s.write("tip.omega_T", values["omega_T"])
    s.write("tip.v_T", values["v_T"])
    state = {"omega_T": values["omega_T"], "v_T": values["v_T"], "g_T": mx.multiply(s.kept("R_T").T, g)}
    m, S, I, tau, F = s.lower("tip_body", state, "m_T", "S_T", "I_T", "h_T_tau", "h_T_F")
    s.keep("M_T", mx.blocks(I, mx.hat(S), mx.identity(3) * m.item()))
    s.keep("h_T", np.concatenate([tau, F]))


def link_rows(s: Scope) -> None:
    """Tip to base: the link's six rows and its modal rows, and its columns in the next joint's rows."""
    given = {name: s.kept(name) for name in ("M_V", "M_D", "M_T", "h_V", "h_T", "b_T", "R_T", "r_T")}
    given |= {name: s.kept(name) for name in ("J_l", "Psi_c", "Phi_c")}
    given |= {
        "m_eta": s.modal_inertia() if s.key.full_inertia else s.read("m_eta"),
        "h_phi": s.kept("h_eta") + s.read("f_eta") + pulled(s),
        "w_ext": s.read("w_ext"),
    }
    given |= {"X": s.read("tip.X"), "PX": s.read("tip.PX")}
    for name, value in zip(LINK_ROWS, s.lower("link_rows", given, *LINK_ROWS), strict=True):
        s.write(name, value)
    for station in s.stations:
        given = {name: station.kept(name) for name in ("R_T", "r_T", "J_l", "Psi_c", "Phi_c")}
        given |= {"X": station.read("tip.X"), "PX": station.read("tip.PX")}
        names = [name for name in LINK_ROWS if name in PER_CHILD]
        for name, value in zip(names, s.lower("link_rows", given, *names), strict=True):
            station.write(name, value)
