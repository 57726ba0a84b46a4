"""Drives in phases: the constants of a joint's axes and of what gears add, and the elimination of the latter.

What a gear does to its axis and to the coordinate that it adds stands in :mod:`..elements.gear`. It couples both
symmetrically, ``-k/N`` and ``-d/N``; an implicit method adds ``m_gear = -(h d + h^2 k)/N`` to their inertia. The
elastic gear of a transmission has a coordinate of another kind in the place of theta, see :mod:`.elastic_travels`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..elements import gear
from ..ir.program import Array, Value
from ..spec.drive_class import DriveClass
from ..spec.link_class import LinkClass
from . import brakes
from . import elastic_travels as et
from . import matrices as mx
from . import travels as tm
from .axis_laws import axis_energy, axis_forces
from .scope import Scope

NONE = DriveClass()
TERMS = {
    "armature": ("axis", "inertia"),
    "joint_damping": ("axis", "damping"),
    "joint_stiffness": ("axis", "stiffness"),
    "rotor_inertia": ("added", "inertia"),
    "rotor_damping": ("added", "damping"),
    "rotor_stiffness": ("added", "stiffness"),
    "gear_inertia": ("between", "inertia"),
    "gear_damping": ("between", "damping"),
    "gear_stiffness": ("between", "stiffness"),
}
"""The constants that follow from what acts linearly on an axis, see :class:`..elements.Linear`."""
COLUMNS = {
    "q": {"M_q": "armature", "K_q": "joint_stiffness", "D_q": "joint_damping"},
    "theta": {"M_theta": "rotor_inertia", "K_theta": "rotor_stiffness", "D_theta": "rotor_damping"},
    "between": {"M_gear": "gear_inertia", "K_gear": "gear_stiffness", "D_gear": "gear_damping"},
}
"""The columns of joint coordinates, of those that elements add, and between both, with the constants that they hold."""
MEANINGS = {
    "rotor_inertia": "kg*m^2, behind cylinders kg: inertia that moves with the coordinate of the rotor",
    "rotor_damping": "N*m*s/rad, behind cylinders N*s/m: damping of the rotor's coordinate, of gear and friction",
    "rotor_stiffness": "N*m/rad, behind cylinders N/m: stiffness of the gear as the rotor's coordinate feels it",
    "gear_inertia": "kg*m^2, of slides kg*m: inertia between rotor and joint",
    "gear_damping": "N*m*s/rad, of slides N*s/rad: damping of the gear between rotor and joint, less than 0",
    "gear_stiffness": "N*m/rad, of slides N/rad: stiffness of the gear between rotor and joint, less than 0",
    "spring": "N*m/rad, of slides N/m: stiffness of the joint's own spring, without that of a gear",
    tm.INERTIA: "kg*m^2, of cylinders kg: inertia of the rotor, times the square of the ratio, along the travel",
}
"""Units and meanings of those that no key of the robot file states under these names."""
OTHERS = ("spring", tm.INERTIA)
"""The stiffness of the joint's own spring, and the inertia of a rotor along a travel."""


def drive_of(key: LinkClass, axis: int) -> DriveClass:
    """What the drive of an axis states."""
    return key.drives[axis] if key.drives else NONE


def constant(s: Scope, name: str, axis: int) -> Value:
    """One of these constants of an axis, recorded from the parameters; 0 where the axis has none."""
    drive = drive_of(s.key, axis)
    read = lambda label: s.read(f"p.{label}_{axis + 1}", 1)[0]  # noqa: E731
    stated = lambda what: read(f"drive_{what}") if getattr(drive, what) else float(what == "ratio")  # noqa: E731
    joint = {"armature": s.key.armature, "joint_damping": s.key.joint_damping, "joint_stiffness": s.key.stiffness}
    if name == "spring":
        return read("joint_stiffness") if s.key.stiffness else 0.0
    if name == tm.INERTIA:
        return gear.travelling(stated)
    part, term = TERMS[name]
    own = read(name) if joint.get(name) else 0.0
    return own + getattr(getattr(gear.linear(drive.elastic, drive.travel), part), term)(stated)


def labelled(s: Scope, label: str) -> Value | None:
    """The constant with the label of an axis, such as ``armature_1``; None if it is no such constant."""
    name, _, number = label.rpartition("_")
    return constant(s, name, int(number) - 1) if s.key.drives and name in (*TERMS, *OTHERS) else None


# ------------------------------------------------------------------------------------------ elimination


def armature(s: Scope) -> Array:
    """The rotor inertias seen at the joint."""
    return mx.array(
        [s.constant(f"armature_{j + 1}") if s.key.has_constant_inertia else 0.0 for j in range(s.key.joints)]
    )


def own_inertia(s: Scope) -> Array:
    """The inertia of the joint coordinates: the armature, or the given one of a sprung joint.

    That of the rotors of transmissions is added.
    """
    own = s.read("m_q") if s.key.has_axis_forces else armature(s)
    return own + tm.kept(s).inertia if s.key.has_travelling_inertia else own


def own_force(s: Scope) -> Array:
    """The generalised forces of the joint's damper and spring, and of transmissions."""
    own = s.read("f_q") if s.key.has_axis_forces else mx.zeros(s.key.joints)
    return own + tm.kept(s).force if s.key.travels else own


Condensed = Callable[[Scope], tuple[Array, Array]]
"""What finds the inertia and the driving force of a joint's axes, as :func:`condense`."""


def condense(s: Scope) -> tuple[Array, Array]:
    """Eliminate the rotors' accelerations from the joint's rows: the inertia that remains, and the driving force.

    The driving force of an axis without a rotor is ``tau - f_q``; that of an elastic one is
    ``-f_q - m_gear / m_theta (tau - f_theta)``, and the inertia ``m_q - m_gear^2 / m_theta``.
    """
    inertia, force = own_inertia(s).copy(), own_force(s)
    effort = tau = s.read("tau") if s.key.torques else mx.zeros(s.key.joints)
    if s.key.travels:
        tau = effort * tm.kept(s).slope
    if not s.key.added_axes:
        return inertia, tau - force
    m, f, coupling = s.read("m_theta"), s.read("f_theta"), s.read("m_gear")
    follows, alone, braked = mx.zeros(len(m)), mx.zeros(len(m)), brakes.on_rotors(s)
    driving = np.where([axis in s.key.added_axes for axis in range(s.key.joints)], -force, tau - force)
    for k, axis in enumerate(s.key.added_axes):
        if axis in s.key.prescribed:  # the rotor's acceleration is given, the axis feels it by the gear
            follows[k], alone[k] = 0.0, effort[axis]
            driving[axis] = driving[axis] - coupling[k] * effort[axis]
            continue
        grip = braked.get(axis, brakes.FREE)
        inverse = grip.mobility(m[k])
        if axis in s.key.elastic_travels:
            found = et.condensed(s, axis, effort[axis], m[k], f[k], inverse)
            follows[k], alone[k], inertia[axis], driving[axis] = found
            continue
        follows[k] = coupling[k] * inverse
        alone[k] = grip.stop + (tau[axis] - f[k] - m[k] * grip.stop) * inverse
        inertia[axis] = inertia[axis] - coupling[k] * follows[k]
        driving[axis] = driving[axis] - coupling[k] * alone[k]
    s.keep("rotor_W", follows)
    s.keep("rotor_w", alone)
    return inertia, driving


def prescribed(s: Scope) -> list[int]:
    """The axes of the joint whose acceleration is given; where the drive is elastic that is the rotor's."""
    return [axis for axis in s.key.prescribed if axis not in s.key.added_axes]


def accelerate_added(s: Scope, qddot: Array) -> None:
    """The rotors' accelerations from those of the joint."""
    W, w = s.kept("rotor_W"), s.kept("rotor_w")
    s.write("thetaddot", [w[k] - W[k] * qddot[axis] for k, axis in enumerate(s.key.added_axes)])


def added_forces(s: Scope, qddot: Array) -> None:
    """Inverse dynamics of the rotors; gears act through the forces alone, but for those of transmissions."""
    force = s.read("m_theta") * s.read("thetaddot") + s.read("f_theta")
    if s.key.elastic_travels:
        force = force + et.carried_along(s, qddot)
    s.write("force_theta", force)


def rotor_accelerations(s: Scope) -> None:
    """The rotors' accelerations by themselves: where no coupling is implicit they need no others."""
    if not s.key.added_axes:
        return
    tau = s.read("tau")
    torque = mx.array([tau[axis] for axis in s.key.added_axes])
    m, braked = s.read("m_theta"), brakes.on_rotors(s)
    force, own = torque - s.read("f_theta"), [braked.get(axis, brakes.FREE) for axis in s.key.added_axes]
    found = mx.array([x.stop + (force[k] - m[k] * x.stop) * x.mobility(m[k]) for k, x in enumerate(own)])
    given = [axis in s.key.prescribed for axis in s.key.added_axes]
    s.write("thetaddot", np.where(given, torque, found))


def drive_power(s: Scope) -> None:
    """The power of the drives of a joint: torque times the rate of joint or rotor, force times that of the travel."""
    if not s.key.torques:
        s.write("power", mx.zeros(0))
        return
    rates = mx.array([driven_rate(s, axis) for axis in range(s.key.torques)])
    s.write("power", s.read("tau") * rates)


def driven_rate(s: Scope, axis: int, guarded: bool = True) -> Value:
    """The rate whose product with the input of an axis is the power of its drive; ``guarded`` as in `travels`."""
    if axis in s.key.travels:
        slope, _ = tm.of_axis(s, axis, s.read("q"), guarded)
        return tm.travel_rate(s, axis, slope, s.read("qdot"))
    added = axis in s.key.added_axes
    return s.read("thetadot")[s.key.added_axes.index(axis)] if added else s.read("qdot")[axis]


def joint_torque(s: Scope, q: Array, qdot: Array) -> tuple[Array, Array]:
    """What acts on the joint's axes besides dampers and springs with one end at rest, and the inertia of the axes.

    That is the torque, or of an elastic drive the part of its gear's torque that the rotor's angle and rate cause. Dry
    friction and stops are included, and what a transmission makes of the drive. Of axes whose motion is given it is
    the acceleration.
    """
    tau, inertia = s.read("tau").copy(), armature(s)
    if s.key.travels:
        found = tm.cranks(s, q, qdot)
        tau, inertia = found.slope * tau - found.force, inertia + found.inertia
    of = lambda name, axis: s.constant(f"{name}_{axis + 1}")  # noqa: E731
    for k, axis in enumerate(s.key.added_axes):
        if axis in s.key.elastic_travels:
            tau[axis], inertia[axis] = (
                et.passed_on(s, axis, k, q),
                of("armature", axis) if s.key.has_constant_inertia else 0.0,
            )
            continue
        tau[axis] = -(of("gear_stiffness", axis) * s.read("theta")[k])
        if drive_of(s.key, axis).damping:
            tau[axis] = tau[axis] - of("gear_damping", axis) * s.read("thetadot")[k]
    for axis, force in axis_forces(s, q, qdot):
        tau[axis] = tau[axis] if axis in prescribed(s) else tau[axis] - force
    return tau, inertia


def spring(s: Scope) -> Array:
    """The stiffness of the joint's own springs, without those of gears."""
    label = "spring" if s.key.drives else "joint_stiffness"
    return mx.array([s.constant(f"{label}_{j + 1}") if s.key.stiffness else 0.0 for j in range(s.key.joints)])


def axis_energies(s: Scope, q: Array, qdot: Array) -> tuple[Value, Value]:
    """Twice the kinetic energy of the rotors' spin; twice the potential of elastic gears, of stops and elements."""
    kinetic = tm.kinetic(s, q, qdot)
    potential: Value = axis_energy(s, q)
    for k, axis in enumerate(s.key.added_axes):
        theta, thetadot = s.read("theta")[k], s.read("thetadot")[k]
        if axis in s.key.elastic_travels:
            potential = potential + s.constant(f"rotor_stiffness_{axis + 1}") * theta * theta
            continue
        ratio = s.constant(f"drive_ratio_{axis + 1}") if drive_of(s.key, axis).ratio else 1.0
        wound = theta - ratio * q[axis]
        kinetic = kinetic + s.constant(f"rotor_inertia_{axis + 1}") * thetadot * thetadot
        potential = potential + s.constant(f"rotor_stiffness_{axis + 1}") * wound * wound
    return kinetic, potential
