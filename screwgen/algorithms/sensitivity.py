"""The phases of the derivatives: first-order changes of a link's motion and loads at given accelerations.

The rows ``f(q, v, vdot) = 0`` of the inverse dynamics are differentiated with vdot held; then
``d vdot = -M^-1 df``.  The wrench of a body depends on velocities only through omega, if the acceleration of its
origin is the inertial one, ``a = vdot + omega x v``.  The motion of a node is therefore ``[omega; omegadot; a]``, nine
numbers.  A change of it acts on everything behind the node through two matrices: the inertia ``Lambda``, and
``Gamma`` (6 x 3), the derivative with omega.  Both are accumulated from tip to base.

If a body is turned by the small angle sigma (in its own axes), ``d omega = sigmadot + omega x sigma``, and
``d omegadot`` is its rate.  So joints and tip sections need the rates of their axes only; no rotation matrix is
differentiated.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..ir.derivative import columns
from ..ir.program import Array
from ..spec.link_class import EXACT
from . import elastic_travels
from . import matrices as mx
from .given_motion import Motion, tip_motion_in_link, tip_point, tip_rotation
from .joint_terms import joint_offset, joint_point, rotation
from .phases import link_load
from .rows import columns_cross, cross_columns, rotated_columns, shifted, swing, to_parent
from .scope import Scope
from .subspace_changes import subspace_rates, turned_rows
from .tendons import pulled_slopes
from .tip_turning import Turning, held_load, shape_rates, turned_moment, turning

# ------------------------------------------------------------------------------------------- the link


@dataclass
class Load:
    """Wrench of a motion at a point, inertia, and derivative (6 x 3) with the angular velocity; F_i axes."""

    wrench: Array
    Lambda: Array
    Gamma: Array

    def with_load(self, r: Array, load: Load, with_omega: Array) -> Load:
        """The sum with a load at the point ``r``, whose derivative with the link's angular velocity is given."""
        Gamma = self.Gamma + shifted(r, with_omega)
        wrench = self.wrench + mx.shift_wrench(r, load.wrench)
        return Load(wrench, self.Lambda + mx.shift(r, load.Lambda), Gamma)


def answers(s: Scope) -> None:
    """Tip to base: the wrench of a link and all that it carries, and its first-order changes."""
    joint_answers(s, link_answers(s))


def link_answers(s: Scope) -> Load:
    """Wrench at F_i, inertia and derivative with omega, of a link and all that it carries.

    Stored for the blocks of two links: the derivatives of wrench, modal forces and tip motion with eta and etadot, and
    those of the modal forces with the link's motion.
    """
    link = Motion(s.read("w.omega_i"), *np.split(s.read("w.acc_i"), 2))
    loaded = [Loaded.of(section) for section in s.sections]
    own, slopes = link_wrench(s, link)
    with s.step("link: wrench at F_i that the motion needs, its inertia and its change with omega"):
        carried = Load(own["wrench"], own["M_V"], slopes["omega"][:6])
        rows, coupling, inertia = slopes["omega"][6:], own["M_D"], own["M_bent"]
        for x in loaded:
            reach = np.vstack([-mx.hat(x.t.omega_s), swing(link.omega, x.r_T, x.udot)])
            with_omega = x.load.Gamma + mx.multiply(x.load.Lambda, reach)
            carried = carried.with_load(x.r_T, x.load, with_omega)
            coupling = coupling + shifted(x.r_T, mx.multiply(x.load.Lambda, x.E))
            rows = rows + mx.multiply(x.E.T, with_omega)
            inertia = inertia + mx.congruence(x.E, x.load.Lambda)
        s.write("w.rows_eta", np.hstack([rows, coupling.T]))
        s.write("w.M_eta_eta", inertia)
    changes = [_changes(x, link) for x in loaded]
    with s.step("link: change of wrench and modal forces with the modes and their rates"):
        held = [x.held() for x in loaded]
        for k, name in enumerate(("eta", "etadot")):
            d_wrench, d_force = slopes[name][:6], slopes[name][6:]
            for x, u, (turned, arm) in zip(loaded, changes, held, strict=True):
                d_load = mx.multiply(x.load.Gamma, u[k][:3]) + mx.multiply(x.load.Lambda, u[k][3:])
                d_load = d_load + (mx.zeros(6, s.key.modes) if k else turned)
                d_wrench = d_wrench + shifted(x.r_T, d_load)
                d_force = d_force + mx.multiply(x.E.T, d_load)
                d_wrench = d_wrench if k else d_wrench + arm
            s.write(f"w.F_{name}", d_wrench)
            for x in () if k else loaded:
                moment, force = np.split(x.load.wrench, 2)
                d_force = d_force + (turned_moment(x.section, moment) + held_load(x.section, moment, force))
            s.write(f"w.f_{name}", d_force if k else d_force + pulled_slopes(s))
    for x in loaded:
        x.write()
    return carried


@dataclass
class Loaded:
    """A section with what it carries: its turn, the load, its place and how the modes move it; F_i axes."""

    section: Scope
    t: Turning
    load: Load
    r_T: Array
    Phi: Array
    udot: Array
    E: Array

    @classmethod
    def of(cls, s: Scope) -> Loaded:
        t, load, (r_T, Phi, udot) = turning(s), tip_load(s), tip_point(s)
        return cls(s, t, load, r_T, Phi, udot, np.vstack([t.phi, Phi]))

    def held(self) -> tuple[Array, Array]:
        """The change, with the modes, of a load that turns with the section, and of its arm."""
        moment, force = np.split(self.load.wrench, 2)
        turned = np.vstack([columns_cross(self.t.phi, moment), columns_cross(self.t.phi, force)])
        return turned, np.vstack([columns_cross(self.Phi, force), mx.zeros(3, self.Phi.shape[1])])

    def write(self) -> None:
        """Store what the blocks of two links need."""
        s, t = self.section, self.t
        kept = {"R_T": tip_rotation(s), "r_T": self.r_T, "udot_T": self.udot, "omega_s": t.omega_s, "E": self.E}
        for name, value in kept.items():
            s.write(f"w.{name}", value)


def _changes(x: Loaded, link: Motion) -> tuple[Array, Array]:
    """The derivatives of a section's motion with the modes and with their rates, which are stored."""
    s, t, Phi = x.section, x.t, x.Phi
    z = tip_motion_in_link(s, link, t)
    Phidot, Phiddot = shape_rates(s, "Phi2dot")
    with s.step("link: change of the tip's motion with the modes and their rates, in F_i components"):
        if s.key.order == EXACT:
            u_eta, u_etadot = traced_changes(s, z, t.phi)
        else:
            u_eta = changed_by_modes(link, z, t, Phi)
            u_eta[6:] = u_eta[6:] + Phiddot + 2.0 * cross_columns(link.omega, Phidot)
            u_etadot = changed_by_rates(link, t, Phi)
            u_etadot[6:] = u_etadot[6:] + 2.0 * Phidot
        s.write("w.tip_eta", u_eta)
        s.write("w.tip_etadot", u_etadot)
    return u_eta, u_etadot


def tip_load(s: Scope) -> Load:
    omega, acc = s.read("tip.omega_T"), s.read("tip.acc")
    state = {"omega_T": omega, "v_T": mx.zeros(3), "g_T": mx.zeros(3)}
    m, S, I, tau, F = s.lower("tip_body", state, "m_T", "S_T", "I_T", "h_T_tau", "h_T_F")
    bias, R = np.concatenate([tau, F]), tip_rotation(s)
    with s.step("tip load: the next link, bodies and external wrench, in F_i axes at the tip point"):
        M_T = mx.blocks(I, mx.hat(S), mx.identity(3) * m.item())
        wrench = s.read("tip.f") + mx.multiply(M_T, acc) + bias - s.read("w_ext")
        Gamma = s.read("tip.Gamma") + mx.array(columns(bias, omega)).T
        Lambda = mx.rotate(R, mx.unpack(s.read("tip.Lambda_T")) + M_T)
        return Load(mx.rotate_wrench(R, wrench), Lambda, rotated_columns(R, mx.multiply(Gamma, R.T)))


def link_wrench(s: Scope, link: Motion) -> tuple[dict[str, Array], dict[str, Array]]:
    """Wrench and modal force of the link alone, and their derivatives with omega, eta and etadot."""
    eta, etadot, etaddot = (s.read(name) for name in ("eta", "etadot", "etaddot"))
    state = {"omega": link.omega, "v": mx.zeros(3), "g": mx.zeros(3), "eta": eta, "etadot": etadot}
    names = ("I", "S", "M_D", "h_V", "h_eta", "m", "M_bent")
    I, S, M_D, h_V, h_eta, m, M_bent = s.lower("link", state, *names)
    M_V = mx.blocks(I, mx.hat(S), mx.identity(3) * m.item())
    with s.step("link: wrench and modal forces of the link alone, and their slopes"):
        if s.key.order == EXACT:
            wrench, force = link_load(s, state["omega"], link.stacked)
        else:
            wrench = mx.multiply(M_V, link.stacked) + mx.multiply(M_D, etaddot) + h_V
            force = mx.multiply(M_D.T, link.stacked) + h_eta
        both = [*wrench, *force]
        variables = {"omega": link.omega, "eta": eta, "etadot": etadot}
        shape = lambda x: (len(x), 6 + s.key.modes)  # noqa: E731
        slopes = {n: mx.array(columns(both, x), shape(x)).T for n, x in variables.items()}
    return {"M_V": M_V, "M_D": M_D, "M_bent": M_bent, "wrench": wrench}, slopes


def changed_by_modes(link: Motion, z: Motion, t: Turning, Phi: Array) -> Array:
    """Derivative of the tip section's ``[omega; omegadot; a]``, which is ``z``, with eta: (9, r), F_i components."""
    psi = t.phidot + cross_columns(link.omega, t.phi)
    rate = t.phiddot + cross_columns(link.omegadot, t.phi) + cross_columns(link.omega, t.phidot)
    moved = cross_columns(link.omegadot, Phi) + cross_columns(link.omega, cross_columns(link.omega, Phi))
    return np.vstack([psi, rate - cross_columns(t.omega_s, psi), moved + cross_columns(z.a, t.phi)])


def traced_changes(s: Scope, z: Motion, phi: Array) -> tuple[Array, Array]:
    """Both derivatives where the kinematics are not expanded: of the recorded motion, and by the section's own turn."""
    motion, size = np.concatenate([z.omega, z.stacked]), (s.key.modes, 9)
    by_modes, by_rates = (mx.array(columns(motion, s.read(x)), size).T for x in ("eta", "etadot"))
    return by_modes + np.vstack([cross_columns(x, phi) for x in (z.omega, z.omegadot, z.a)]), by_rates


def changed_by_rates(link: Motion, t: Turning, Phi: Array) -> Array:
    """The derivative of the tip section's motion with etadot."""
    rate = 2.0 * t.phidot + cross_columns(link.omega - t.omega_s, t.phi)
    return np.vstack([t.phi, rate, 2.0 * cross_columns(link.omega, Phi)])


# ------------------------------------------------------------------------------------------ the joint


def joint_answers(s: Scope, carried: Load) -> None:
    """The joint's rows, their derivatives with the joint's coordinates, and the load passed to the parent."""
    if s.key.floats:
        answers_in_space(s, carried)
        return
    m, omega_P = s.key.joints, s.read("base.omega_T")
    q, qdot = s.read("q"), s.read("qdot")
    R, A = s.lower("posture", {"q": q}, "R_rel", "A")
    T = s.lower("posture", {"q": q}, "T")[0] if s.key.slides else mx.zeros(3, m)
    omega, acc = s.read("w.omega_i"), s.read("w.acc_i")
    r_B, r_J = joint_point(s), joint_offset(s, q)
    with s.step("joint: change of the link's motion with the joint's coordinates and rates"):
        omega_J, v_J = mx.multiply(A, qdot), mx.multiply(R, mx.multiply(T, qdot))
        u_q, u_qdot = joint_changes(s, A, T, Motion(omega, acc[:3], s.read("w.a_J")), r_B)
    with s.step("joint: its rows and their changes; what is handed to the parent"):
        axes = np.vstack([A, T + mx.multiply(mx.hat(r_B), A)])
        answer = np.hstack([carried.Gamma, carried.Lambda])
        rows = mx.multiply(axes.T, answer)
        w = mx.shift_wrench(-r_B, carried.wrench)
        turned = np.vstack([columns_cross(A, w[:3]) + columns_cross(T, w[3:]), columns_cross(A, w[3:])])
        F_q = mx.multiply(answer, u_q)
        travel_q, travel_qdot = elastic_travels.answers(s)
        s.write("w.f_q", mx.multiply(axes.T, F_q) + turned_rows(s, A, T, w) + travel_q)
        F_qdot = mx.multiply(answer, u_qdot)
        s.write("w.f_qdot", mx.multiply(axes.T, F_qdot) + travel_qdot)
        s.write("w.F_q", F_q + shifted(r_B, turned))
        s.write("w.F_qdot", F_qdot)
        s.write("base.f", mx.shift_wrench(r_J, mx.rotate_wrench(R, w)))
        handed = mx.shift(r_J, mx.rotate(R, mx.shift(-r_B, carried.Lambda)))
        s.write("base.Lambda_T", mx.pack(handed))
        passed = to_parent(answer, R, omega, omega_J, omega_P, r_B, r_J, v_J)[:, :3]
        s.write("base.Gamma", shifted(r_J, rotated_columns(R, shifted(-r_B, passed))))
    for name, value in {"u_q": u_q, "u_qdot": u_qdot, "rows_q": rows, "axes": axes, "answer": answer, "w_J": w}.items():
        s.write(f"w.{name}", value)
    for name, value in {"R_rel": R, "omega_J": omega_J, "r_B": r_B, "r_J": r_J, "v_J": v_J}.items():
        s.write(f"w.{name}", value)


def answers_in_space(s: Scope, carried: Load) -> None:
    """The rows of a floating base, and their derivatives with its twist and with a change delta of its pose.

    The pose becomes ``pose exp(delta)``, delta = [turn; shift] in axes of F_i. That turns what comes from outside in
    F_i: free fall alone.
    """
    omega, v = np.split(s.read("qdot"), 2)
    with s.step("floating base: its rows and their changes with pose and twist"):
        none, one = mx.zeros(3, 3), mx.identity(3)
        u_q = np.vstack([np.hstack([none, none])] * 2 + [np.hstack([mx.hat(s.read("w.a_J")), none])])
        slip = np.hstack([-mx.hat(v), mx.hat(omega)])
        u_qdot = np.vstack([np.hstack([one, none]), np.hstack([none, none]), slip])
        rows = np.hstack([carried.Gamma, carried.Lambda])
        F_q, F_qdot = mx.multiply(rows, u_q), mx.multiply(rows, u_qdot)
    changes = {"u_q": u_q, "u_qdot": u_qdot, "rows_q": rows, "axes": mx.identity(6)}
    changes |= {"F_q": F_q, "F_qdot": F_qdot, "f_q": F_q, "f_qdot": F_qdot, "R_rel": rotation(s, s.read("q"))}
    changes |= {"answer": rows, "w_J": mx.zeros(6)}
    changes |= dict.fromkeys(("omega_J", "r_B", "r_J", "v_J"), mx.zeros(3))
    if s.key.joint.given:  # what moves the base bears its wrench
        changes |= {"w_J": carried.wrench}
    for name, value in changes.items():
        s.write(f"w.{name}", value)


def joint_changes(s: Scope, A: Array, T: Array, joint: Motion, r_B: Array) -> tuple[Array, Array]:
    """Change of ``[omega; omegadot; a]`` of F_i with q and with qdot, (9, m) each; ``joint.a`` is the joint point's.

    With S_k a column of the motion subspace and V the twist, ``dV/dq_k = Sdot_k + ad_V S_k``, and its rate likewise.
    The frame of reference is the one in which the joint point is at rest.
    """
    qdot, qddot = s.read("qdot"), s.read("qddot")
    Adot, Addot, Tdot, Tddot, bend, lost = subspace_rates(s, A, T, qdot, qddot)
    omega, omegadot = joint.omega, joint.omegadot
    d_omega = Adot + cross_columns(omega, A)
    d_rate = Addot + cross_columns(omegadot, A) + cross_columns(omega, Adot)
    d_a = cross_columns(joint.a, A) + _swing_changes(d_omega, d_rate, omega, r_B)
    v_rate, d_v = bend + cross_columns(omega, A), Tdot + cross_columns(omega, T)
    d_a = d_a + Tddot + cross_columns(omegadot, T) + cross_columns(omega, Tdot + d_v)
    slip = 2.0 * d_v - lost + _swing_changes(A, v_rate, omega, r_B)
    return np.vstack([d_omega, d_rate, d_a]), np.vstack([A, v_rate, slip])


def _swing_changes(d_omega: Array, d_rate: Array, omega: Array, r_B: Array) -> Array:
    """Derivative of the origin's acceleration relative to the joint point."""
    d = -mx.multiply(swing(omega, r_B, mx.zeros(3)), d_omega)
    return d + mx.multiply(mx.hat(r_B), d_rate)
