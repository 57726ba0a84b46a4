"""The phases of the joint form's algorithms: the computations of one link in an outward or inward pass.

Forward dynamics is a block elimination of M_sys from tip to base.  The reaction of the next link is written as
``w = Lambda delta_T + p`` with the articulated inertia ``Lambda`` and the bias force ``p``.  Every link adds it to its
equations, eliminates its modal accelerations, then its joint accelerations, and passes ``Lambda, p`` to its parent.
The accelerations and the joint wrenches follow from base to tip.

The acceleration of a point is split in two: ``acc_0`` is its value while no joint and no mode accelerates, known
after the outward pass; ``delta`` is the contribution of the joint and modal accelerations.  Accelerations are those of
material points in the inertial frame, so they need angular velocities but no linear ones.  Gravity enters as an
acceleration ``-g`` of the base.  Signals of a node are in the axes of the parent's F_i, at its tip point, so a link
rotates its contribution only once.
"""

from __future__ import annotations

import numpy as np

from ..ir.program import Array, Value
from ..spec.link_class import EXACT
from . import brakes
from . import matrices as mx
from .axis_terms import Condensed, accelerate_added, added_forces, condense, own_force, own_inertia, prescribed
from .elastic_travels import carrying_along
from .joint_terms import joint_point, rotation
from .modal_elimination import eliminate_modes, modal_accelerations
from .scope import Scope
from .tendons import pulled
from .travels import store
from .validity import axial_motion


def kinematics(s: Scope) -> None:
    """Base to tip: angular velocity and ``acc_0`` of F_i and of the tip, from q, qdot, eta, etadot."""
    q, qdot = s.read("q"), s.read("qdot")
    if s.key.floats:
        motion_in_space(s, q, qdot)
    else:
        omega_R = relative_posture(s)
        joint_motion(s, q, qdot, omega_R)
    for section in s.sections:
        tip_motion(section)


def motion_in_space(s: Scope, q: Array, twist: Array) -> None:
    """The same of a floating base, from its pose and twist; the motion subspace is the identity."""
    R = rotation(s, q)
    a_R = mx.multiply(R.T, s.read("base.acc_0")[3:])
    (a,) = s.lower("joint_motion", {"omega": twist[:3], "v": twist[3:], "a_R": a_R}, "a")
    s.keep("R_rel", R)
    s.keep("S", mx.identity(6))
    s.keep("omega", twist[:3])
    s.keep("acc_0", np.concatenate([mx.zeros(3), a]))


def relative_posture(s: Scope) -> Array:
    """Store the pose of F_i relative to its parent; returns the angular velocity of the parent's tip in F_i axes."""
    R_rel = rotation(s, s.read("q"))
    s.keep("R_rel", R_rel)
    with s.step("R: rotation of F_i relative to the parent's F_i (Ad)"):
        R = s.name("R_P", mx.multiply(s.read("base.R_T"), R_rel))
        s.keep("R_P", R)
        return s.name("omega_R", mx.multiply(R.T, s.read("base.omega")), "omega")


def joint_motion(s: Scope, q: Array, qdot: Array, omega_R: Array) -> None:
    """Store angular velocity, ``acc_0`` and the motion subspace at the origin of F_i."""
    with s.step("acceleration of the parent's tip in F_i axes"):
        parent = mx.rotate_wrench(s.kept("R_P").T, s.read("base.acc_0"))
    given = {"q": q, "qdot": qdot, "omega_R": omega_R, "alpha_R": parent[:3], "a_R": parent[3:]}
    names = ("S", "lever", "omega", "alpha", "a")
    S, lever, omega, alpha, a = s.lower("joint_motion", given, *names)
    s.keep("S", S)
    s.keep("lever", lever)
    s.keep("omega", omega)
    s.keep("acc_0", np.concatenate([alpha, a]))
    store(s, q, qdot)
    if s.key.brakes:
        s.keep("braked_rate", qdot)


def swing(alpha: Array, omega: Array, r: Array) -> Array:
    """``alpha x r + omega x (omega x r)``: acceleration of the point ``r`` of a body relative to its origin."""
    return mx.cross(alpha, r) + mx.cross(omega, mx.cross(omega, r))


def tip_state(s: Scope, twist: Array) -> dict[str, Array]:
    """The inputs from which the tip blocks compute the motion of the tip section."""
    return {"omega": twist[:3], "v": twist[3:], "eta": s.read("eta"), "etadot": s.read("etadot")}


def tip_motion(s: Scope) -> None:
    """Pose, angular velocity and ``acc_0`` of the tip section, in F_i axes."""
    acc_0 = s.kept("acc_0")
    state = {"eta": s.read("eta"), "etadot": s.read("etadot")}
    state |= {"omega": s.kept("omega"), "alpha": acc_0[:3], "a": acc_0[3:]}
    r_T, Phi_c, omega, alpha, a = s.lower("tip_motion", state, "r_T", "Phi_c", "omega_t", "alpha_t", "a_t")
    R_T, J_l, Psi_c = mx.identity(3), mx.identity(3), mx.zeros(3, s.key.modes)
    if s.key.section_rotation:
        R_T, J_l, Psi_c = s.lower("tip_motion", state, "R_T", "J_l", "Psi_c")
    s.keep("r_T", r_T)
    s.keep("R_T", R_T)
    s.keep("J_l", J_l)
    s.keep("Psi_c", Psi_c)
    s.keep("Phi_c", Phi_c)
    s.write("tip.R_T", R_T)
    s.write("tip.omega", omega)
    s.write("tip.acc_0", np.concatenate([alpha, a]))


def rows(s: Scope) -> tuple[Array, Array, Array, Array]:
    """``M_V, M_D, h_V, h_eta`` of the link alone; the bias forces include the inertial forces of ``acc_0``."""
    acc_0 = s.kept("acc_0")
    state = {"omega": s.kept("omega"), "alpha": acc_0[:3], "v": mx.zeros(3), "g": -acc_0[3:]}
    state |= {"eta": s.read("eta"), "etadot": s.read("etadot")}
    names = ("m", "I", "S", "M_D", "h_V", "h_eta", "M_bent")
    m, I, S, M_D, h_V, h_eta, M_bent = s.lower("turning_link", state, *names)
    s.keep("M_bent", M_bent)
    return mx.blocks(I, mx.hat(S), mx.identity(3) * m.item()), M_D, h_V, h_eta


def no_rows(s: Scope) -> tuple[Array, Array, Array, Array]:
    """The same of a link whose load :func:`link_load` has whole; of its modal inertia that is not the given one."""
    s.keep("M_bent", -s.lower("link", {}, "M_Wphi")[0])
    return mx.zeros(6, 6), mx.zeros(6, s.key.modes), mx.zeros(6), mx.zeros(s.key.modes)


def link_load(s: Scope, omega: Array, acc: Array) -> tuple[Array, Array]:
    """Wrench and modal forces that a link alone needs for an acceleration of F_i and its modal accelerations.

    Of an exact rod, whose inertia need not be formed for that.
    """
    state = {"omega": omega, "alpha": acc[:3], "v": mx.zeros(3), "g": -acc[3:]}
    state |= {name: s.read(name) for name in ("eta", "etadot", "etaddot")}
    wrench, force = s.lower("turning_link", state, "h_V", "h_eta")
    return wrench, force


def tip_bodies(s: Scope) -> tuple[Array, Array, Array]:
    """Mass, first moment and inertia of the bodies at the tip, F_i axes, about the tip point."""
    R, rest = s.kept("R_T"), {"omega_T": mx.zeros(3), "v_T": mx.zeros(3), "g_T": mx.zeros(3)}
    m, S, I = s.lower("tip_body", rest, "m_T", "S_T", "I_T")
    return m.item(), mx.multiply(R, S), mx.congruence(R.T, I)


def tip_load(s: Scope) -> tuple[Array, Array]:
    """``Lambda, p`` of the next links and the tip bodies together, in F_i axes at the tip point."""
    with s.step("tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46)"):
        m, S, I = tip_bodies(s)
        M_T = mx.blocks(I, mx.hat(S), mx.identity(3) * m)
        Lambda = s.name("Lambda_T", mx.unpack(s.read("tip.Lambda")) + M_T)
        outside = mx.rotate_wrench(s.kept("R_T"), s.read("w_ext"))
        bias = body_force(s.read("tip.omega"), s.read("tip.acc_0"), m, S, I)
        return Lambda, s.name("p_T", s.read("tip.p") + bias - outside, "p")


def body_force(omega: Array, alpha: Array, m: Value | Array, S: Array, I: Array) -> Array:
    """Newton-Euler wrench of rigid bodies at an angular velocity and an acceleration of their reference point."""
    turn = mx.cross(S, alpha[3:]) + mx.multiply(I, alpha[:3]) + mx.cross(omega, mx.multiply(I, omega))
    return np.concatenate([turn, m * alpha[3:] + swing(alpha[:3], omega, S)])


def eliminate(s: Scope, condensed: Condensed = condense) -> None:
    """Tip to base: add the tip's reaction, eliminate modes and joint, pass the result to the parent."""
    M_V, M_D, h_V, h_eta = rows(s)
    own = M_V, M_D, h_V, h_eta + pulled(s)
    if s.key.lacks_geometric_stiffness:
        s.keep("own_axial", np.concatenate([own[0][3], own[1][3], own[2][3:4]]))
    loads = [(section, *tip_load(section)) for section in s.sections]
    for station, Lambda, p in loads[1:]:
        station.keep("load_axial", np.concatenate([Lambda[3], p[3:4]]))
    M, h = eliminate_modes(s, own, loads)
    if s.key.joint.given:
        s.keep("p_i", s.name("p_i", h + mx.multiply(M, s.read("base_rate"))))
        return
    Lambda, p = eliminate_joint(s, M, h, condensed)
    if s.key.floats:
        return
    s.keep("Lambda_i", Lambda)
    s.keep("p_i", p)
    with s.step("handed up: inertia and bias that the joint shows to the parent's tip (49)"):
        R, lever = s.kept("R_P"), s.kept("lever")
        s.write("base.Lambda", mx.pack(mx.rotate(R, mx.shift(lever, Lambda))))
        s.write("base.p", mx.rotate_wrench(R, mx.shift_wrench(lever, p)))


def eliminate_joint(s: Scope, M: Array, h: Array, condensed: Condensed = condense) -> tuple[Array, Array]:
    """Eliminate qddot by the joint's rows ``S^T w = tau - m_q qddot - f_q``; ``f_q = b qdot + k q``, or as given.

    The rotors of elastic drives are eliminated before, see :mod:`.axis_terms`. An axis whose acceleration a is given is
    not eliminated: it adds ``M s a`` to the bias and leaves the inertia whole. What a brake does: :mod:`.brakes`.
    """
    with s.step("joint: its accelerations eliminated from its rows (43)"):
        S = s.kept("S")
        own, driving = condensed(s)
        for axis in prescribed(s):
            a = s.read("tau")[axis]
            h = s.name("h_given", h + mx.multiply(M, S[:, axis]) * a, "h_V")
            S, own, driving = without_column(S, axis), with_entry(own, axis, 1.0), with_entry(driving, axis, a)
        if s.key.brakes:
            stop = brakes.stops(s)
            h, driving = h + mx.multiply(M, mx.multiply(S, stop)), driving - own * stop
        U = s.name("U", mx.multiply(M, S))
        inertia = s.name("joint_inertia", mx.multiply(S.T, U) + mx.diagonal(own))
        scale = s.tracer.epsilon() * 8.0 * (M[0, 0] + M[1, 1] + M[2, 2])
        L, inverse = mx.factorise(inertia, s.tracer, scale, brakes.kept(s))
        Z = mx.forward(L, U.T)
        W = mx.scale_rows(Z, s.name("joint_inverse", inverse))
        w = mx.scale_rows(mx.forward(L, driving - mx.multiply(S.T, h)), inverse)
        s.keep("joint_L", L)
        s.keep("joint_W", W)
        s.keep("joint_w", w)
        return s.name("Lambda_i", mx.subtract_product(M, Z, W)), s.name("p_i", h + mx.multiply(Z.T, w))


def without_column(S: Array, k: int) -> Array:
    """The motion subspace without the motion of an axis."""
    out = S.copy()
    out[:, k] = 0.0
    return out


def with_entry(x: Array, k: int, value: Value) -> Array:
    """A vector with another entry."""
    out = x.copy()
    out[k] = value
    return out


def accelerate(s: Scope) -> None:
    """Base to tip: qddot, etaddot, the joint wrench, and ``delta`` of the tip."""
    with s.step("joint: acceleration that the parent's tip imparts, joint accelerations (48)"):
        carried = s.name("carried", imparted(s), "delta")
        qddot = joint_accelerations(s, carried)
        s.write("qddot", qddot)
        if s.key.added_axes:
            accelerate_added(s, qddot)
    with s.step("joint wrench (48)"):
        s.write("wrench", joint_wrench(s, carried))
    with s.step("link: what is added to the acceleration of F_i, modal accelerations (83)"):
        delta = s.name("delta", carried + mx.multiply(s.kept("S"), qddot))
        alpha = delta + s.kept("acc_0")
        s.write("alpha", alpha)
        etaddot = modal_accelerations(s, delta)
        s.write("etaddot", etaddot)
    at_stations = [_tip_delta(station, delta, etaddot) for station in s.stations]
    if s.key.lacks_geometric_stiffness:
        own = mx.dot(s.kept("own_axial"), np.concatenate([delta, etaddot, [1.0]]))
        for station, delta_T in zip(s.stations, at_stations, strict=True):
            own = own + on_the_way(station) * mx.dot(station.kept("load_axial"), np.concatenate([delta_T, [1.0]]))
        axial_motion(s, s.kept("omega"), alpha[3], own)
    _tip_delta(s, delta, etaddot)


def joint_accelerations(s: Scope, carried: Array) -> Array:
    """Those that the elimination left; of a base whose motion is given the given ones."""
    if s.key.joint.given:
        return s.read("base_rate")
    qddot = mx.backward(s.kept("joint_L"), s.kept("joint_w") - mx.multiply(s.kept("joint_W"), carried))
    return s.name("Vdot" if s.key.floats else "qddot", qddot + brakes.stops(s) if s.key.brakes else qddot)


def joint_wrench(s: Scope, carried: Array) -> Array:
    """The wrench of the joint on the link, at its joint point; a base in space bears one where its motion is given."""
    if s.key.joint.given:
        return s.kept("p_i")
    wrench = mx.zeros(6) if s.key.floats else mx.multiply(s.kept("Lambda_i"), carried) + s.kept("p_i")
    return mx.shift_wrench(-joint_point(s), wrench)


def _tip_delta(s: Scope, delta: Array, etaddot: Array) -> Array:
    """What is added to the acceleration of the tip section, which is written."""
    with s.step("tip: what is added to the acceleration of the tip section (accconst1b)"):
        delta_T = s.name("delta_T", tip_acceleration(s, delta, etaddot), "delta")
        s.write("tip.delta", delta_T)
    return delta_T


def on_the_way(station: Scope) -> float:
    """The part of a station's axial load that is no load at the tip: at s it buckles the link as s² of it there."""
    return 1.0 - station.key.section_at**2


def imparted(s: Scope) -> Array:
    """The part of ``delta`` that the parent's tip imparts; a floating base has no parent."""
    if s.key.floats:
        return mx.zeros(6)
    return mx.shift_twist(s.kept("lever"), mx.rotate_wrench(s.kept("R_P").T, s.read("base.delta")))


def tip_acceleration(s: Scope, delta: Array, etaddot: Array) -> Array:
    """``J_T [delta; etaddot]`` in F_i axes."""
    turn = mx.multiply(s.kept("J_l"), mx.multiply(s.kept("Psi_c"), etaddot))
    elastic = np.concatenate([turn, mx.multiply(s.kept("Phi_c"), etaddot)])
    return mx.shift_twist(s.kept("r_T"), delta) + elastic


# ---------------------------------------------------------------------------------- inverse dynamics


def inverse_outward(s: Scope) -> None:
    """Base to tip: ``delta``, the contribution of qddot and etaddot to the accelerations."""
    qddot, etaddot = s.read("qddot"), s.read("etaddot")
    delta = imparted(s) + mx.multiply(s.kept("S"), qddot)
    s.keep("delta", delta)
    for section in s.sections:
        section.write("tip.delta", tip_acceleration(section, delta, etaddot))


def inverse_inward(s: Scope) -> None:
    """Tip to base: the joint wrenches of given accelerations, and the generalised forces."""
    qddot, etaddot, delta = s.read("qddot"), s.read("etaddot"), s.kept("delta")
    exact = s.key.order == EXACT
    M_V, M_D, h_V, h_eta = no_rows(s) if exact else rows(s)
    load = tip_reaction(s)
    bias, bias_eta = link_load(s, s.kept("omega"), s.kept("acc_0") + delta) if exact else (h_V, h_eta)
    needed = mx.multiply(M_V, delta) + mx.multiply(M_D, etaddot) + bias
    if s.key.lacks_geometric_stiffness:
        own = needed[3]
        for station in s.stations:
            own = own + on_the_way(station) * station.read("tip.p")[3]
        axial_motion(s, s.kept("omega"), s.kept("acc_0")[3] + delta[3], own)
    total = needed + mx.shift_wrench(s.kept("r_T"), load)
    modal = mx.multiply(M_D.T, delta) + mx.multiply(s.modal_inertia(), etaddot)
    turned = mx.multiply(s.kept("Psi_c").T, mx.multiply(s.kept("J_l").T, load[:3]))
    moved = mx.multiply(s.kept("Phi_c").T, load[3:])
    modal = modal + bias_eta + s.read("f_eta") + turned + moved
    for station in s.stations:
        load = station.read("tip.p")
        total = total + mx.shift_wrench(station.kept("r_T"), load)
        turned = mx.multiply(station.kept("Psi_c").T, mx.multiply(station.kept("J_l").T, load[:3]))
        modal = modal + turned + mx.multiply(station.kept("Phi_c").T, load[3:])
    s.write("force_eta", modal)
    force = mx.multiply(s.kept("S").T, total) + own_inertia(s) * qddot + own_force(s)
    if s.key.elastic_travels:
        force = force + carrying_along(s)
    s.write("force", force)
    if s.key.added_axes:
        added_forces(s, qddot)
    s.write("wrench", mx.shift_wrench(-joint_point(s), total))
    if s.key.floats:
        return
    s.write("base.p", mx.rotate_wrench(s.kept("R_P"), mx.shift_wrench(s.kept("lever"), total)))


def tip_reaction(s: Scope) -> Array:
    """The wrench that the motion of all behind the tip needs, in F_i axes at the tip point."""
    m, S, I = tip_bodies(s)
    bodies = body_force(s.read("tip.omega"), s.read("tip.acc_0") + s.read("tip.delta"), m, S, I)
    return bodies - mx.rotate_wrench(s.kept("R_T"), s.read("w_ext")) + s.read("tip.p")
