"""The motion of links and tip sections at given accelerations, of which derivatives are taken: the outward phase."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..ir.program import Array
from ..spec.link_class import EXACT
from . import matrices as mx
from .joint_terms import joint_point, rotation
from .phases import swing, tip_state
from .scope import Scope
from .tip_turning import Turning, turning


@dataclass
class Motion:
    """Motion of a frame in its own components: angular velocity and rate, inertial acceleration of the origin."""

    omega: Array
    omegadot: Array
    a: Array

    @property
    def stacked(self) -> Array:
        return np.concatenate([self.omegadot, self.a])


def motion(s: Scope) -> None:
    """Base to tip: the motion of every link and tip section at given accelerations."""
    link, a_J = link_motion(s)
    s.write("w.omega_i", s.name("omega", link.omega))
    s.write("w.acc_i", s.name("acc", link.stacked, "acc_i"))
    s.write("w.a_J", a_J)
    for section in s.sections:
        tip = tip_motion(section, link)
        section.write("tip.omega_T", tip.omega)
        section.write("tip.acc", tip.stacked)


def link_motion(s: Scope) -> tuple[Motion, Array]:
    """The motion of F_i, and the acceleration of its joint point."""
    if s.key.floats:
        return motion_in_space(s)
    q, qdot, qddot = (s.read(name) for name in ("q", "qdot", "qddot"))
    (R,) = s.lower("posture", {"q": q}, "R_rel")
    with s.step("motion: that of the parent's tip in F_i axes"):
        parent = mx.rotate_wrench(R.T, s.read("base.acc"))
        omega_R = mx.multiply(R.T, s.read("base.omega_T"))
    given = {"q": q, "qdot": qdot, "omega_R": omega_R, "alpha_R": parent[:3], "a_R": parent[3:]}
    A, omega, alpha, a_J = s.lower("joint_motion", given, "A", "omega", "alpha", "a_J")
    with s.step("motion: angular acceleration, inertial acceleration of the origin of F_i against free fall"):
        omegadot = alpha + mx.multiply(A, qddot)
        if s.key.slides:
            a_J = a_J + mx.multiply(s.lower("joint_motion", given, "T")[0], qddot)
        return Motion(omega, omegadot, a_J - swing(omegadot, omega, joint_point(s))), a_J


def tip_motion(s: Scope, link: Motion) -> Motion:
    """The tip section's motion, in tip-frame components."""
    at_tip, R = tip_motion_in_link(s, link, turning(s)), tip_rotation(s)
    with s.step("tip motion: that of the tip section in its own components"):
        return Motion(*(mx.multiply(R.T, x) for x in (at_tip.omega, at_tip.omegadot, at_tip.a)))


def tip_motion_in_link(s: Scope, link: Motion, t: Turning) -> Motion:
    """The tip section's motion in F_i components."""
    given, etaddot = tip_state(s, mx.zeros(6)), s.read("etaddot")
    given |= {"omega": link.omega, "alpha": link.omegadot, "a": link.a}
    if s.key.order == EXACT:  # the rod's sections carry modal accelerations to the tip
        return Motion(*s.lower("tip_motion", given | {"etaddot": etaddot}, "omega_t", "alpha_t", "a_t"))
    omega, alpha, a, Phi = s.lower("tip_motion", given, "omega_t", "alpha_t", "a_t", "Phi_c")
    with s.step("tip motion: that of the tip section in F_i components (accconst1b)"):
        return Motion(omega, alpha + mx.multiply(t.phi, etaddot), a + mx.multiply(Phi, etaddot))


def tip_point(s: Scope) -> list[Array]:
    return s.lower("tip", tip_state(s, mx.zeros(6)), "r_T", "Phi_c", "udot_T")


def tip_rotation(s: Scope) -> Array:
    return s.lower("tip", tip_state(s, mx.zeros(6)), "R_T")[0] if s.key.section_rotation else mx.identity(3)


def motion_in_space(s: Scope) -> tuple[Motion, Array]:
    """The motion of a floating base, and its part that the posture makes: the acceleration against free fall."""
    twist, rates = s.read("qdot"), s.read("qddot")
    a_R = mx.multiply(rotation(s, s.read("q")).T, s.read("base.acc")[3:])
    (a,) = s.lower("joint_motion", {"omega": twist[:3], "v": twist[3:], "a_R": a_R}, "a")
    return Motion(twist[:3], rates[:3], a + rates[3:]), a_R
