"""The arm of the paper's Section 7, its task, and what the paper leaves open and we choose."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import screwgen
from screwgen import PD, Body, Joint, Link, Model, Modes, Mount, Robot, Section
from screwgen.simulation.motion import displacements, modal_columns

FILE = Path(__file__).resolve().parents[1] / "ella_paper.toml"

# what the paper states
SET_POINTS = (-0.4928, 0.6922, 0.4270)
"""Joint angles at the end of the motion, rad: theta_y1, theta_z1, theta_z2."""
TIP_DISPLACEMENT = (-0.02, 0.0065, -0.0083)
"""Initial displacement of the tip of link 2, m, inertial components."""
STEP = 1e-3
"""Table 1: forward Euler with this step, s."""
PRINTED_BOUND = 10.04e-3
"""The step bound that the paper prints below (stability), s."""

# what it does not state
MOVE = 2.0
"""Duration of the minimum-jerk references, s."""
STIFFNESS = 2.0
"""Hz: the gains kp hold each joint of the straight rigid arm as a spring of this frequency would."""


@dataclass(frozen=True)
class Arm:
    """The arm with its modes as the paper keeps them, and what is made of it."""

    robot: Robot

    @cached_property
    def axial(self) -> Model:
        """One mode per direction, as the paper: axial, bending in y, bending in z."""
        return screwgen.derive(self.robot)

    @cached_property
    def bending(self) -> Model:
        """The same without the axial modes."""
        return screwgen.derive(with_modes(self.robot, bending_y=1, bending_z=1))

    @cached_property
    def rigid(self) -> Model:
        return screwgen.derive(with_modes(self.robot))

    @cached_property
    def locked(self) -> Model:
        """The arm without axial modes, its joints welded in the posture of the set points."""
        return screwgen.derive(welded(self.bending.robot, SET_POINTS))

    @cached_property
    def gains(self) -> tuple[np.ndarray, np.ndarray]:
        """kp, N·m/rad, and kd, N·m·s/rad, of the three joints; see `choose_gains`."""
        return choose_gains(self.rigid, self.bending)

    def law(self, moving: bool = True, damping: float = 1.0) -> PD:
        """The PD law: along the references from q = 0, or holding the set points; kd times `damping`."""
        kp, kd = (tuple(map(float, x)) for x in (self.gains[0], damping * self.gains[1]))
        return PD(kp, kd, SET_POINTS, duration=MOVE, q_start=(0.0,) * 3) if moving else PD(kp, kd, SET_POINTS)


def load() -> Arm:
    return Arm(screwgen.load(FILE))


def with_modes(robot: Robot, rotation: bool = True, **modes) -> Robot:
    """The robot with other modes in every link, the paper's shapes if none are named; `rotation`: the next link follows
    the tip's slope."""
    modes = Modes(**{"basis": "clamped_free"} | modes)
    links = tuple(link.model_copy(update={"modes": modes}) for link in robot.links)
    return robot.model_copy(update={"links": links, "section_rotation": rotation})


def welded(robot: Robot, angles) -> Robot:
    """The robot with its joints frozen at `angles`, one per axis, as mounts without axes."""
    rest, links = list(angles), []
    for link in robot.links:
        turn = Rotation.identity()
        for axis in link.joint.axes:
            turn = turn * Rotation.from_rotvec(rest.pop(0) * np.array(axis))
        yaw, pitch, roll = turn.as_euler("ZYX")
        links.append(link.model_copy(update={"joint": Joint(axes=(), mount=Mount(rpy=(roll, pitch, yaw)))}))
    return robot.model_copy(update={"links": tuple(links)})


def bodies_beyond_the_joints(robot: Robot) -> Robot:
    """The same arm with each tip body on the far side of the next joint, the payload on a massless stub.

    A point mass at the tip of a link is one at the base of the next. In this form it reaches the modes of the link
    before through the joint wrench alone, as in the paper's synthesis, which has no bodies of its own (E34).
    """
    stub = Link(name="stub", length=1e-3, section=Section(rhoA=1e-9), joint=Joint(axes=()))
    links, carried = [], ()
    for link in (*robot.links, stub):
        links.append(link.model_copy(update={"bodies": carried}))
        carried = tuple(Body(at="base", mass=body.mass) for body in link.bodies)
    return robot.model_copy(update={"links": tuple(links)})


def choose_gains(rigid: Model, flexible: Model) -> tuple[np.ndarray, np.ndarray]:
    """kp from the rigid arm, kd from what a torque held over a step can bear; rounded to two digits.

    kp = M_jj (2π f)², M the mass matrix of the straight rigid arm, f = `STIFFNESS`. kd = J_j / T_s with
    J_j = 1 / (M⁻¹)_jj of the flexible arm at the set points: the inertia that the motor feels while everything else
    gives way. Held over T_s, twice this kd would turn the joint's rate round at every step.
    """
    M = np.array(rigid.casadi()["mass_matrix"](np.zeros(3), rigid.parameter_values))
    kp = np.diag(M) * (2 * np.pi * STIFFNESS) ** 2
    q = np.append(SET_POINTS, np.zeros(flexible.nq - 3))
    M = np.array(flexible.casadi()["mass_matrix"](q, flexible.parameter_values))
    kd = 1 / np.diag(np.linalg.inv(M))[:3] / STEP
    return tuple(np.array([float(f"{x:.2g}") for x in gains]) for gains in (kp, kd))


def start(model: Model, axial: bool = False, scale: float = 1.0) -> np.ndarray:
    """The coordinates (nq,) of the paper's start: q = 0, link 1 straight, the tip of link 2 displaced.

    `axial`: with the printed component along the link too. At q = 0 with link 1 straight F_2 has inertial axes.
    """
    q = np.zeros(model.nq)
    for k, direction in enumerate(("axial", "bending_y", "bending_z")):
        if columns := modal_columns(model, model.n_links - 1, direction) if axial or k else []:
            unit = np.zeros((1, model.nq))
            unit[0, columns[0]] = 1.0
            tip = displacements(model, unit, model.n_links - 1, [1.0])[0, 0, k]
            q[columns[0]] = scale * TIP_DISPLACEMENT[k] / tip
    return q
