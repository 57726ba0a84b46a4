"""The signals that the phases exchange, with shape, unit, frame and meaning.

Signals of a node are shared by a link and the links that it carries, those of the store are kept by a link between
phases, others are of a call. In a shape ``q`` counts joint coordinates, ``m`` their rates, ``f`` given rates, ``a``
torques, ``k`` brakes, ``t`` rotors, ``r`` modes, ``b`` their coupled pairs, ``g`` their directions, ``z`` internal
states, ``h`` those of held laws, ``c`` pieces of tendons, ``p`` points of exact rods. Angular parts first;
accelerations less free fall.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from ..ir.names import component
from ..spec.link_class import LinkClass
from .station_names import plain

F_I, TIP, INERTIAL, CARRIER = "F_i", "tip frame", "inertial frame", "F_i of the node's link"
TWIST, ACCELERATION, WRENCH, INERTIA = "rad/s, m/s", "rad/s^2, m/s^2", "N*m, N", "kg*m^2, kg*m, kg"
MODAL, MIXED, NEXT = "m (torsion: rad)", "various units", "F_i of the next link"


class Signal(NamedTuple):
    """The type of a signal."""

    shape: tuple[int | str, ...]
    unit: str
    frame: str
    meaning: str
    at: str = ""
    """Where a call of the generated C has it, if that is not a member of its name; i is the link, e its first mode."""
    parts: tuple[str, ...] = ()
    """The names of the entries along its last axis, if those of its shape are others."""

    def size_of(self, key: LinkClass) -> tuple[int, ...]:
        """The shape for a link class."""
        counts: dict[Any, Any] = {"q": key.joint.nq, "m": key.joints, "a": key.torques, "t": len(key.added_axes)}
        counts |= {"c": len(key.tendons), "r": key.modes, "b": len(key.coupled), "z": len(key.internal)}
        counts |= {"h": len(key.remembering)}
        counts |= {"g": len({d for d, _ in key.directions}), "k": len(key.brakes), "f": 6 * key.joint.given}
        return tuple(counts.get(n, n) if isinstance(n, str) else n for n in self.shape)

    def place(self, index: tuple[int, ...], shape: tuple[int, ...]) -> str:
        """The place of an entry of an array of ``shape``: letters along the axes of a frame, numbers elsewhere."""
        if self.shape == (6,) == shape:
            return component(self.unit, index[0])
        axes = self.shape if len(self.shape) == len(shape) and self.frame != "-" else (0,) * len(shape)
        parts = ["xyz"[i] if n == 3 else str(i + 1) for i, n in zip(index, axes, strict=True)]
        return ("_" if max(shape) > 9 else "").join(parts)

    @property
    def comment(self) -> str:
        """Unit, meaning and frame, as a header states them."""
        unit = "" if self.unit == "-" else f"{self.unit}: "
        axes = self.frame if self.frame.startswith("F_i") else f"the {self.frame}"
        return unit + self.meaning + ("" if self.frame == "-" else f", in {axes}")


NODE = {
    "omega": Signal((3,), "rad/s", CARRIER, "angular velocity of the tip section"),
    "v": Signal((3,), "m/s", CARRIER, "velocity of the tip point"),
    "acc_0": Signal((6,), ACCELERATION, CARRIER, "acceleration while no joint and no mode accelerates"),
    "delta": Signal((6,), ACCELERATION, CARRIER, "part of the acceleration due to joints and modes"),
    "R_T": Signal((3, 3), "-", CARRIER, "rotation of the tip frame, row by row"),
    "Lambda": Signal((21,), INERTIA, CARRIER, "articulated inertia of the links carried, upper triangle"),
    "p": Signal((6,), WRENCH, CARRIER, "bias force of the links carried; in inverse dynamics the wrench on them"),
    "omega_T": Signal((3,), "rad/s", TIP, "angular velocity of the tip section"),
    "v_T": Signal((3,), "m/s", TIP, "velocity of the tip point"),
    "b": Signal((6,), ACCELERATION, TIP, "velocity-dependent acceleration of the tip section"),
    "acc": Signal((6,), ACCELERATION, TIP, "acceleration of the tip section"),
    "Lambda_T": Signal((21,), INERTIA, TIP, "articulated inertia at the tip, upper triangle row by row"),
    "f": Signal((6,), WRENCH, TIP, "wrench on the links carried"),
    "Gamma": Signal((6, 3), "N*m*s, N*s", TIP, "derivative of f with the angular velocity"),
    "R": Signal((3, 3), "-", INERTIAL, "rotation of the tip frame, row by row"),
    "r": Signal((3,), "m", INERTIAL, "position of the tip point"),
    "rdot": Signal((3,), "m/s", INERTIAL, "velocity of the tip point"),
    "Q": Signal((4,), "-", INERTIAL, "rotation of the tip frame, unit quaternion (w, x, y, z)"),
    "R_m": Signal((3, 3), "-", INERTIAL, "rotation of the tip frame before projection, row by row"),
    "r_m": Signal((3,), "m", INERTIAL, "position of the tip point before projection"),
    "omega_m": Signal((3,), "rad/s", TIP, "angular velocity of the tip section before projection"),
    "v_m": Signal((3,), "m/s", TIP, "velocity of the tip point before projection"),
    "strain": Signal(("g",), "1, 1/m, rad/m", "-", "strains of the section"),
    "X": Signal((6, 6), "-, m", NEXT, "map from the twist of the tip to that of the next joint point"),
    "PX": Signal((6, 6), MIXED, NEXT, "next joint's rows, columns of the tip's twist rate"),
}
"""Of a node: the tip section of a link, or the base."""

M_SYS = {
    "joint_w": Signal((6, 6), MIXED, F_I, "joint's rows, columns of its wrench"),
    "joint_V": Signal((6, 6), MIXED, F_I, "joint's rows, columns of the link's twist rate"),
    "V_w": Signal((6, 6), "-, m", F_I, "twist rows, columns of the joint's wrench"),
    "V_V": Signal((6, 6), INERTIA, F_I, "twist rows, columns of the twist rate"),
    "V_eta": Signal((6, "r"), "kg*m, kg", F_I, "twist rows, columns of the modal accelerations"),
    "V_next": Signal((6, 6), "-, m", F_I, "twist rows, columns of the next joint's wrench"),
    "eta_V": Signal(("r", 6), "kg*m, kg", F_I, "modal rows, columns of the twist rate"),
    "eta_eta": Signal(("r", "r"), "kg", "-", "modal rows, columns of the modal accelerations"),
    "eta_next": Signal(("r", 6), "-, 1/m", F_I, "modal rows, columns of the next joint's wrench"),
    "next_V": Signal((6, 6), MIXED, NEXT, "next joint's rows, columns of the twist rate"),
    "next_eta": Signal((6, "r"), MIXED, NEXT, "next joint's rows, columns of the modal accelerations"),
}
"""The blocks of M_sys that a link computes, by rows and columns."""

PER_CHILD = frozenset({"next_V", "next_eta", "V_next", "eta_next"})
"""What a phase computes for each link that is carried."""

H_SYS = {
    "joint_H": Signal((6,), MIXED, F_I, "joint's rows, bias", "H + 12 * i"),
    "joint_W": Signal((6,), MIXED, F_I, "joint's rows, torques", "W + 12 * i"),
    "V_H": Signal((6,), WRENCH, F_I, "twist rows, bias", "H + 12 * i + 6"),
    "V_W": Signal((6,), WRENCH, F_I, "twist rows, external wrench", "W + 12 * i + 6"),
    "eta_H": Signal(("r",), "N", "-", "modal rows, bias", "H + 12 * $$_NLINKS + e"),
    "eta_W": Signal(("r",), "N", "-", "modal rows, external wrench", "W + 12 * $$_NLINKS + e"),
}
"""The parts of H_sys and W_sys that a link computes."""

CALL: dict[str, Signal] = {
    "q": Signal(("q",), "rad", "-", "joint coordinates"),
    "qdot": Signal(("m",), "rad/s", "-", "joint rates"),
    "qddot": Signal(("m",), "rad/s^2", "-", "joint accelerations"),
    "new_q": Signal(("q",), "rad", "-", "projected joint coordinates"),
    "tau": Signal(("a",), "N*m", "-", "joint torques"),
    "tension": Signal(("c",), "N", "-", "tensions of the tendons along the link"),
    "brake": Signal(("k",), "-", "-", "how far the brakes of the joint are closed, from 0 to 1"),
    "base_rate": Signal(("f",), ACCELERATION, F_I, "rate of the twist of a base whose motion is given", at="base_rate"),
    "m_q": Signal(("a",), "kg*m^2", "-", "inertia of the joint coordinates"),
    "f_q": Signal(("a",), "N*m", "-", "force of springs and dampers of the joint"),
    "force": Signal(("m",), "N*m", "-", "force of the joint coordinates"),
    "theta": Signal(("t",), "rad", "-", "angles of the rotors"),
    "thetadot": Signal(("t",), "rad/s", "-", "rates of the rotors"),
    "thetaddot": Signal(("t",), "rad/s^2", "-", "accelerations of the rotors"),
    "z": Signal(("z",), "rad, m", "-", "internal states, as deflections of bristles of friction"),
    "zdot": Signal(("z",), "rad/s, m/s", "-", "rates of the internal states"),
    "memory": Signal(("h",), "various units", "-", "internal states of what a step makes of inputs"),
    "memory_gain": Signal(("h",), "various units", "-", "their rates, but for the decay"),
    "memory_decay": Signal(("h",), "1/s", "-", "decay of these states"),
    "m_theta": Signal(("t",), "kg*m^2", "-", "inertia of the rotors"),
    "f_theta": Signal(("t",), "N*m", "-", "force of gear and friction on the rotors"),
    "m_gear": Signal(("t",), "kg*m^2", "-", "inertia that couples rotor and joint"),
    "force_theta": Signal(("t",), "N*m", "-", "force of the rotors"),
    "eta": Signal(("r",), MODAL, "-", "modal coordinates"),
    "etadot": Signal(("r",), "m/s (torsion: rad/s)", "-", "modal rates"),
    "etaddot": Signal(("r",), "m/s^2 (torsion: rad/s^2)", "-", "modal accelerations"),
    "m_eta": Signal(("r",), "kg (torsion: kg*m^2)", "-", "inertia of the modes"),
    "m_below": Signal(("b",), "kg (torsion: kg*m^2)", "-", "inertia of coupled modes, below the diagonal"),
    "f_eta": Signal(("r",), "N (torsion: N*m)", "-", "stress and damping of the modes"),
    "force_eta": Signal(("r",), "N (torsion: N*m)", "-", "force of the modal coordinates"),
    "gravity": Signal((3,), "m/s^2", INERTIAL, "acceleration of free fall"),
    "w_ext": Signal((6,), WRENCH, TIP, "external wrench on the tip section"),
    "wrench": Signal((6,), WRENCH, F_I, "wrench of the joint on the link, at the joint point"),
    "alpha": Signal((6,), ACCELERATION, F_I, "acceleration of F_i"),
    "Vdot": Signal((6,), ACCELERATION, F_I, "rate of the twist"),
    "twist": Signal((6,), TWIST, F_I, "angular velocity of F_i and velocity of its origin"),
    "new_twist": Signal((6,), TWIST, F_I, "projected twist"),
    "quaternion": Signal((4,), "-", INERTIAL, "rotation of F_i, quaternion (w, x, y, z)"),
    "new_quaternion": Signal((4,), "-", INERTIAL, "projected rotation of F_i, unit quaternion"),
    "quaternion_rate": Signal((4,), "1/s", INERTIAL, "rate of the quaternion"),
    "position": Signal((3,), "m", INERTIAL, "position of the origin of F_i"),
    "new_position": Signal((3,), "m", INERTIAL, "projected position of the origin of F_i"),
    "position_rate": Signal((3,), "m/s", INERTIAL, "rate of the position"),
    "R": Signal((3, 3), "-", INERTIAL, "rotation of F_i, row by row"),
    "r": Signal((3,), "m", INERTIAL, "position of the origin of F_i"),
    "tip_twist": Signal((6,), TWIST, INERTIAL, "angular velocity of the tip section and velocity of the tip point"),
    "motion": Signal((4,), "rad/s, rad/s, m/s^2, N", F_I, "angular velocity about y and z, axial motion and force"),
    "measures": Signal((4,), "-", "-", "deflection, slope, axial load and rotation against the model's limits"),
    "levers": Signal(("a",), "m", "-", "travel of the cylinder per unit of each axis, 1 without one"),
    "cylinder_length": Signal(("a",), "m", "-", "length of the cylinder of each axis, 0 without one"),
    "power": Signal(("a",), "W", "-", "power that each drive gives to the arm"),
    "held": Signal(("a",), "N*m", "-", "joint torques as a step holds them"),
    "tendon_length": Signal(("c",), "m", "-", "lengths of the pieces of tendons along the link"),
    "tendon_power": Signal(("c",), "W", "-", "power that the tension of each piece gives to the link"),
    "pull": Signal(("c", "r"), "-", "-", "derivatives of the lengths of the pieces with the modes, row by row"),
    "strain": Signal(("g",), "1, 1/m, rad/m", "-", "strains of the section at the base"),
    "mass": Signal((1,), "kg", "-", "mass of the link with its bodies"),
    "mass_moment": Signal((3,), "kg*m", INERTIAL, "first moment of that about the origin"),
    "momentum": Signal((6,), "kg*m^2/s, kg*m/s", INERTIAL, "angular about the origin, and linear"),
    "kinetic": Signal((1,), "J", "-", "kinetic energy"),
    "potential": Signal((1,), "J", "-", "potential of stress, springs and weight"),
}
CALL |= M_SYS | H_SYS
"""Of a call, for one link."""

STORE = {
    "omega": Signal((3,), "rad/s", F_I, "angular velocity"),
    "acc_0": Signal((6,), ACCELERATION, F_I, "acceleration of F_i while no joint and no mode accelerates"),
    "delta": Signal((6,), ACCELERATION, F_I, "part of the acceleration of F_i due to joints and modes"),
    "R_rel": Signal((3, 3), "-", "parent's tip frame", "rotation of F_i"),
    "R_P": Signal((3, 3), "-", "parent's F_i", "rotation of F_i"),
    "lever": Signal((3,), "m", F_I, "from the parent's tip point to the origin of F_i"),
    "S": Signal((6, "m"), "-, m", F_I, "motion subspace of the joint at the origin of F_i"),
    "r_T": Signal((3,), "m", F_I, "position of the tip point"),
    "R_T": Signal((3, 3), "-", F_I, "rotation of the tip frame"),
    "J_l": Signal((3, 3), "-", F_I, "left Jacobian of the tip section's rotation vector"),
    "Psi_c": Signal((3, "r"), "1/m", F_I, "rotation of the tip section per unit of each mode"),
    "Phi_c": Signal((3, "r"), "-", F_I, "displacement of the tip point per unit of each mode"),
    "own_axial": Signal(("r+7",), "kg, N", F_I, "factors of (delta, etaddot, 1) in the link's own axial force"),
    "load_axial": Signal((7,), "kg, N", F_I, "factors of (delta, 1) in the axial force of what the tip carries"),
    "twist": Signal((6,), TWIST, F_I, "angular velocity of F_i and velocity of its origin"),
    "modes_L": Signal(("r", "r"), "-", "-", "unit lower factor L of the modal inertia"),
    "modes_W": Signal(("r", 6), "1/m", F_I, "factor W in etaddot = -L^-T (w + W delta)"),
    "modes_w": Signal(("r",), "m/s^2", "-", "term w in etaddot = -L^-T (w + W delta)"),
    "reach": Signal((6, 6), "-, m", F_I, "acceleration of the unloaded tip per unit of delta"),
    "carried": Signal((6, 6), INERTIA, F_I, "inertia of the tip load in series with the modes' compliance"),
    "p_carried": Signal((6,), WRENCH, F_I, "bias force of the tip load in series with the modes' compliance"),
    "h_phi": Signal(("r",), "N", "-", "bias force of the modal rows"),
    "M_D": Signal((6, "r"), "kg*m, kg", F_I, "inertial coupling of twist and modal rows"),
    "joint_L": Signal(("m", "m"), "-", "-", "unit lower factor L of the joint's inertia"),
    "joint_W": Signal(("m", 6), "-, 1/m", F_I, "factor W in qddot = L^-T (w - W delta), delta of the parent"),
    "braked_rate": Signal(("m",), "rad/s", "-", "joint rates, which brakes stop"),
    "joint_w": Signal(("m",), "rad/s^2", "-", "term w in qddot = L^-T (w - W delta)"),
    "rotor_W": Signal(("t",), "-", "-", "factor W in thetaddot = w - W qddot"),
    "rotor_w": Signal(("t",), "rad/s^2", "-", "term w in thetaddot = w - W qddot; of the gear of a cylinder in m/s^2"),
    "crank_slope": Signal(("m",), "m", "-", "travel of the cylinder per unit of each axis, 1 without one"),
    "crank_inertia": Signal(("m",), "kg*m^2", "-", "inertia of each axis that moves with its cylinder"),
    "crank_force": Signal(("m",), "N*m", "-", "friction of each cylinder and what the change of its lever costs"),
    "crank_bias": Signal(("m",), "N", "-", "the same along the travel of each cylinder"),
    "gear_M": Signal(("t",), "kg*m", "-", "inertia that couples each elastic gear of a cylinder with its axis"),
    "gear_q": Signal(("t",), "N", "-", "derivative of each such gear's force with the axis"),
    "gear_qdot": Signal(("t",), "N*s", "-", "the same with the rate of the axis"),
    "gear_back": Signal(("t",), "N*s", "-", "derivative of the axis' force with the gear's rate"),
    "gear_own": Signal(("t",), "N*s/m", "-", "derivative of each such gear's force with its own rate"),
    "Lambda_i": Signal((6, 6), INERTIA, F_I, "articulated inertia of the link and all that it carries"),
    "p_i": Signal((6,), WRENCH, F_I, "bias force of the link and all that it carries"),
    "M_V": Signal((6, 6), INERTIA, F_I, "inertia in the twist rows"),
    "M_T": Signal((6, 6), INERTIA, TIP, "inertia of the bodies at the tip"),
    "h_V": Signal((6,), WRENCH, F_I, "bias force of the twist rows"),
    "h_T": Signal((6,), WRENCH, TIP, "bias force of the bodies at the tip"),
    "h_eta": Signal(("r",), "N", "-", "gyroscopic force and weight on the modes"),
    "M_bent": Signal(("r", "r"), "kg", "-", "modal inertia less that of the straight link"),
    "rod_R": Signal(("p", 3, 3), "-", F_I, "rotations of the sections along an exact rod"),
    "rod_theta_eta": Signal(("p", 3, "r"), "-", "-", "derivatives of their turns from the sections before"),
    "rod_W": Signal(("p", 3, "r"), "-", F_I, "turns of these sections by each mode of unit length"),
    "rod_w": Signal(("p", 3), "rad/s", F_I, "their angular velocities relative to F_i"),
    "rod_bend": Signal(("p", 3), "rad/s^2", F_I, "rates of these at constant modal rates"),
    "rod_t": Signal(("p", 3), "m", F_I, "tangents of the centreline there, times the length"),
    "rod_t_eta": Signal(("p", 3, "r"), "m", F_I, "derivatives of the tangents with each mode of unit length"),
    "rod_tdot": Signal(("p", 3), "m/s", F_I, "rates of the tangents relative to F_i"),
    "rod_t_bend": Signal(("p", 3), "m/s^2", F_I, "second rates of the tangents at constant modal rates"),
    "rod_G": Signal(("p", 3, 3), "-", F_I, "turns of these sections by turns from those before"),
    "b_T": Signal((6,), ACCELERATION, TIP, "velocity-dependent acceleration of the tip section"),
    "omega_i": Signal((3,), "rad/s", F_I, "angular velocity"),
    "acc_i": Signal((6,), ACCELERATION, F_I, "acceleration of F_i"),
    "a_J": Signal((3,), "m/s^2", F_I, "acceleration of the joint point"),
    "omega_J": Signal((3,), "rad/s", F_I, "angular velocity relative to the parent's tip"),
    "omega_s": Signal((3,), "rad/s", F_I, "angular velocity of the tip section relative to F_i"),
    "udot_T": Signal((3,), "m/s", F_I, "velocity of the tip point relative to F_i"),
    "r_B": Signal((3,), "m", F_I, "position of the joint point"),
    "r_J": Signal((3,), "m", "parent's tip frame", "joint point relative to the parent's tip point"),
    "v_J": Signal((3,), "m/s", "parent's tip frame", "velocity of the joint point relative to the parent's tip"),
    "axes": Signal((6, "m"), "-, m", F_I, "motion subspace of the joint at the origin of F_i"),
    "E": Signal((6, "r"), "1/m, -", F_I, "motion of the tip section per unit of each mode"),
    "u_q": Signal((9, "m"), "-", F_I, "derivative of the motion of F_i with the joint coordinates"),
    "u_qdot": Signal((9, "m"), "-", F_I, "derivative of the motion of F_i with the joint rates"),
    "tip_eta": Signal((9, "r"), "-", F_I, "derivative of the tip's motion with the modes"),
    "tip_etadot": Signal((9, "r"), "-", F_I, "derivative of the tip's motion with the modal rates"),
    "answer": Signal((6, 9), "-", F_I, "derivative of the wrench with the motion of F_i"),
    "w_J": Signal((6,), WRENCH, F_I, "wrench of the joint, at the joint point"),
    "rows_q": Signal(("m", 9), "-", F_I, "derivative of the joint's forces with the motion of F_i"),
    "rows_eta": Signal(("r", 9), "-", F_I, "derivative of the modal forces with the motion of F_i"),
    "F_q": Signal((6, "m"), WRENCH, F_I, "derivative of the wrench with the joint coordinates"),
    "F_qdot": Signal((6, "m"), WRENCH, F_I, "derivative of the wrench with the joint rates"),
    "F_eta": Signal((6, "r"), WRENCH, F_I, "derivative of the wrench with the modes"),
    "F_etadot": Signal((6, "r"), WRENCH, F_I, "derivative of the wrench with the modal rates"),
    "f_q": Signal(("m", "m"), "N*m", "-", "derivative of the joint's forces with its coordinates"),
    "f_qdot": Signal(("m", "m"), "N*m*s", "-", "derivative of the joint's forces with its rates"),
    "f_eta": Signal(("r", "r"), "N/m", "-", "derivative of the modal forces with the modes"),
    "f_etadot": Signal(("r", "r"), "N*s/m", "-", "derivative of the modal forces with the modal rates"),
    "M_eta_eta": Signal(("r", "r"), "kg", "-", "modal inertia of the tip load"),
    "inward": Signal((), MIXED, "-", "factors of columns of forces on their way to the base"),
    "outward": Signal((), MIXED, "-", "factors of columns of accelerations on their way to the tips"),
}
"""Of a link's own store."""

MODES, INPUTS, AXES, RATES = ("NMODES",), ("NTAU",), ("NAXES",), "rad/s^2, m/s^2"
GIVEN = {
    "m_eta": Signal(("NINERTIA",), "kg, kg*m^2", "-", "inertia of modes and sprung joints, implicit over a step"),
    "f_eta": Signal(("NGIVEN",), "N, N*m", "-", "stress and damping of modes and sprung joints"),
}
ROBOT = {
    "constants": {"gravity": CALL["gravity"]},
    "state": {
        "q": Signal(("NQ",), "rad, m", "-", "coordinates"),
        "v": Signal(("NVZ",), "rad/s, m/s", "-", "rates of the coordinates"),
    },
    "input": {
        "tau": Signal(INPUTS, "N*m", "-", "torque about each joint axis, in the order of q"),
        "w_ext": Signal(("NLINKS", 6), WRENCH, TIP, "[tau; F] on each tip section"),
    },
    "output": {
        "vdot": Signal(("NVZ",), RATES, "-", "rate of v"),
        "wrench": Signal(("NLINKS", 6), WRENCH, F_I, "of the joint on link i, at the joint point"),
        "tip_rotation": Signal((3, 3), "-", INERTIAL, "rotation of the last tip frame"),
        "tip_position": Signal((3,), "m", INERTIAL, "last tip point"),
    },
    "motion": {
        "rotation": Signal(("NLINKS", 3, 3), "-", INERTIAL, "rotation of F_i"),
        "position": Signal(("NLINKS", 3), "m", INERTIAL, "origin of F_i"),
        "tip_rotation": Signal(("NLINKS", 3, 3), "-", INERTIAL, "rotation of the tip frame of each link"),
        "tip_position": Signal(("NLINKS", 3), "m", INERTIAL, "tip point of each link"),
        "tip_twist": Signal(("NLINKS", 6), TWIST, INERTIAL, "[omega; v] of tip section and tip point"),
    },
    "dae_state": {
        "quaternion": Signal(("NLINKS", 4), "-", INERTIAL, "rotation of F_i, (w, x, y, z)"),
        "position": Signal(("NLINKS", 3), "m", INERTIAL, "origin of F_i"),
        "eta": Signal(MODES, MODAL, "-", "modal coordinates"),
        "twist": Signal(("NLINKS", 6), TWIST, F_I, "[omega; v]"),
        "etadot": Signal(MODES, "m/s (torsion: rad/s)", "-", "modal rates"),
        "q": Signal(("NREDUNDANT",), "rad", "-", "joint coordinates"),
    },
    "work": GIVEN | {"motion": Signal(("NLINKS", 4), *CALL["motion"][1:4])},
    "dae_work": GIVEN
    | {
        "qdot": Signal(AXES, "rad/s", "-", "joint rates"),
        "qddot": Signal(("NRATES",), "rad/s^2", "-", "joint accelerations"),
        "etaddot": Signal(MODES, "m/s^2 (torsion: rad/s^2)", "-", "modal accelerations"),
        "alpha": Signal(("NLINKS", 6), ACCELERATION, F_I, "acceleration of F_i"),
        "Vdot": Signal(("NLINKS", 6), ACCELERATION, F_I, "rate of the twist"),
        "wrench": Signal(("NLINKS", 6), WRENCH, F_I, "of the joint on link i, at the joint point"),
    },
}
"""Of the whole robot, by the struct of the generated C that holds them; sizes are its constants."""

UNTYPED = Signal((), "-", "-", "")
"""The type of values that no phase hands on: their entries are numbered."""


def is_node(where: str) -> bool:
    """Whether the prefix of a signal is that of a node: the base's, the tip's, or a station's."""
    return where in ("base", "tip") or (where[:2] == "at" and where[2:].isdigit())


def type_of(name: str) -> Signal:
    """The type of a signal, its prefix left out where it is clear; ``UNTYPED`` if there is none of the name."""
    where, _, what = name.rpartition(".")
    tables = (NODE,) if is_node(where) else {"w": (STORE,)}.get(where, (STORE, CALL, NODE))
    return next((table[plain(what)] for table in tables if plain(what) in table), UNTYPED)


def signal(name: str) -> Signal:
    """The type of the signal that a phase calls ``name``."""
    where, _, what = name.rpartition(".")
    return NODE[what] if is_node(where) else {"w": STORE, "": CALL}[where][plain(what)]
