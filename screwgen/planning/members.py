"""A model as a plan sees it: residuals of its inverse dynamics at its parameters, its rests, its slow modes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import casadi as ca
import numpy as np

from ..algorithms import fused
from ..algorithms.functions import Functions
from ..backends.casadi.expressions import expressions
from ..backends.casadi.functions import symbols
from ..backends.numpy.travel_numbers import efforts
from ..errors import SingularError, UsageError
from ..lazily import linalg
from ..robot_model import RobotModel
from ..spec.dry_friction import without_dry_friction
from ..spec.limit import OF_LAWS
from ..spec.parameters import parameters
from .drive_coordinates import DriveCoordinates
from .task import JointLaw, Task

STEPS, SETTLED = 50, 1e-11
LIMITS = (".lower", ".upper", *(f".{name}" for name in OF_LAWS))
"""The ends of the names of limits that motions keep."""


@dataclass(frozen=True)
class AtRest:
    """A model at rest: coordinates (n,), and the efforts of drives (n_joints,) that hold it, its law's included."""

    q: np.ndarray
    effort: np.ndarray


@fused.program("q v vdot w_ext", "joint_wrenches")
def _joint_wrenches(f: Functions, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence) -> fused.Outputs:
    """``(q, v, vdot, w_ext) -> (wrench)``: what the joints transmit in a given motion."""
    return {"wrench": f.loads(q, v, vdot, w_ext)[1]}


class Still:
    """The forces of a model that rests, and how it vibrates about a rest, in the coordinates that drives have."""

    def __init__(self, model: RobotModel, p: np.ndarray):
        self.model, self.p = model, p
        _check_limits(model, p)
        found = model.once("forces at rest", partial(_forces_at_rest, model))
        self.joints, self.drives = model.n_joints, DriveCoordinates(model.chain, p)
        z = [ca.SX.sym(name, model.nq) for name in "qva"]
        force = model.casadi()["inverse_dynamics"](*self.drives.motion(*z), ca.DM.zeros(6, model.n_links), p)
        forces = self.drives.with_accelerations(self.drives.forces(force, z[0]), z[2])
        self.residual = ca.Function("residual", z, [forces])
        levers = self.drives.levers(z[0])
        self.levers = ca.Function("levers", z[:1], [levers])
        self.lever_slopes = ca.Function("lever_slopes", z[:1], [ca.diag(ca.jacobian(levers, z[0][: self.joints]))])
        slipping = without_dry_friction(model.robot, p, bend=False)
        self.statics, self.damping, self.inertia = (
            partial(_at, f, own) for f, own in zip(found, (p, slipping, p), strict=True)
        )

    @cached_property
    def wrenches(self) -> ca.Function:
        """``(q, v, vdot) -> (6 n_links,)``: the joint wrenches of a motion."""
        given = symbols(self.model.chain, "q v vdot w_ext p")
        wrench = expressions(_joint_wrenches(self.model.chain), given)["wrench"]
        whole, motion = ca.Function("wrenches", [*given.values()], [wrench]), [given[x] for x in ("q", "v", "vdot")]
        moved = self.drives.motion(*motion)
        return ca.Function("wrenches", motion, [whole(*moved, ca.DM.zeros(6, self.model.n_links), self.p)])

    @cached_property
    def strains(self) -> ca.Function:
        """``(q) -> (n_strains,)``: the strains of the centrelines."""
        q = ca.SX.sym("q", self.model.nq)
        return ca.Function("strains", [q], [self.model.casadi()["strain"](self.drives.to_robot(q), self.p)])

    def held(self, joints: np.ndarray, near: np.ndarray | None = None) -> AtRest:
        """The rest with the drives where they are said to be; refuses joints that have no inertia there."""
        q = np.zeros(self.model.nq) if near is None else near.copy()
        q[: self.joints] = joints
        q = self._newton(q, np.zeros(self.joints), np.zeros(self.joints), np.full(self.joints, np.inf))
        idle = np.diag(np.array(self.inertia(q)))[: self.joints] <= 0.0
        idle[self.drives.given] = False
        if idle.any():
            link = self.model.q_names[int(idle.argmax())].partition(".")[0]
            raise self.model.chain.unresisted(self.model.chain.names.index(link))
        return AtRest(q, self.bearing(q))

    def bearing(self, q: np.ndarray) -> np.ndarray:
        """(n_joints,): what drives bear at rest. Raises UsageError where a transmission is in a dead centre."""
        torque = np.array(self.statics(q)[0]).ravel()[: self.joints]
        torque[self.drives.given] = 0.0
        return self.efforts_behind(torque, q)

    def efforts_behind(self, torques: np.ndarray, q: np.ndarray) -> np.ndarray:
        """(n_joints,): what drives give for torques at joints. Raises UsageError in a dead centre."""
        try:
            return efforts(self.model.chain, torques, q[: self.joints], self.p)
        except SingularError as error:
            raise UsageError(str(error)) from None

    def levers_at(self, q: np.ndarray) -> np.ndarray:
        """(n_joints, …): the levers of drives at coordinates (nq, …), 1 of those without a transmission."""
        return np.array(self.levers.map(q[0].size)(q.reshape(len(q), -1))).reshape(self.joints, *q.shape[1:])

    def efforts(self, motion: Any) -> np.ndarray:
        """(n_joints, points): what drives give in a motion of coordinates, rates and accelerations (n, points) each."""
        force = np.array(self.residual.map(motion.q.shape[1])(motion.q, motion.v, motion.a))
        return force[: self.joints] / self.levers_at(motion.q)

    def under(self, law: JointLaw, reference: np.ndarray, effort: np.ndarray, near: np.ndarray) -> AtRest:
        """The rest under an effort and a joint law about a reference."""
        q = self._newton(near.copy(), effort, law.kp * reference, law.kp)
        return AtRest(q, effort + law.kp * (reference - q[: self.joints]) / self.levers_at(q))

    def _newton(self, q: np.ndarray, effort: np.ndarray, load: np.ndarray, kp: np.ndarray) -> np.ndarray:
        """The rest under efforts where joints bear `load − kp q` besides; those with an infinite `kp` stay."""
        m, held = self.joints, np.isinf(kp)
        held[self.drives.given] = True
        free = np.append(~held, np.ones(len(q) - m, bool))
        gain = np.where(held, 0.0, kp)
        for _ in range(STEPS):
            force = np.array(self.statics(q)[0]).ravel()
            force[:m] -= self.levers_at(q) * effort + load - gain * q[:m]
            K = self.stiffness(q, effort)
            K[range(m), range(m)] += gain
            step = np.linalg.solve(K[np.ix_(free, free)], -force[free]) if free.any() else np.zeros(0)
            q[free] += step
            if np.abs(step).max(initial=0.0) <= SETTLED * (1.0 + np.abs(q).max()):
                return q
        raise UsageError("no rest was found at an end of the motion; choose another posture, or larger gains")

    def matrices(self, rest: AtRest) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Inertia, damping and stiffness of small motions about a rest under its efforts, joints free and slipping.

        Dry friction is no damping: its slope at rest holds up to the rate alone that smooths it.
        """
        return np.array(self.inertia(rest.q)), np.array(self.damping(rest.q)), self.stiffness(rest.q, rest.effort)

    def rigid_inertia(self, q: np.ndarray) -> np.ndarray:
        """(n_joints, n_joints): the inertia that drives move where nothing bends or twists, 1 of given motions."""
        M, given = np.array(self.inertia(q))[: self.joints, : self.joints], self.drives.given
        M[given, :] = M[:, given] = 0.0
        M[given, given] = 1.0
        return M

    def stiffness(self, q: np.ndarray, effort: np.ndarray) -> np.ndarray:
        """(n, n): of small displacements from a rest under efforts (n_joints,), whose levers change with posture."""
        K, joints = np.array(self.statics(q)[1]), range(self.joints)
        K[joints, joints] -= np.array(self.lever_slopes(q)).ravel() * effort
        return K

    def energy(self, rest: AtRest, kp: np.ndarray) -> np.ndarray:
        """(2 n, 2 n): of displacements from a rest and rates, twice their energy; joints on springs `kp`."""
        M, K = np.array(self.inertia(rest.q)), self.stiffness(rest.q, rest.effort)
        K[range(self.joints), range(self.joints)] += kp
        return linalg.block_diag((K + K.T) / 2, (M + M.T) / 2)


def _forces_at_rest(model: RobotModel) -> tuple[ca.Function, ...]:
    """Functions of coordinates and parameters: forces at rest with their slopes, damping, inertia."""
    whole, n = model.casadi()["inverse_dynamics"], model.nq
    q, v, a = (ca.SX.sym(name, n) for name in "qva")
    p = ca.SX.sym("p", len(model.parameter_values))
    drives = DriveCoordinates(model.chain, ca.vertsplit(p))
    force = drives.forces(whole(*drives.motion(q, v, a), ca.DM.zeros(6, model.n_links), p), q)
    rest = lambda x: ca.substitute(x, ca.vertcat(v, a), ca.DM.zeros(2 * n))  # noqa: E731
    still, damping, inertia = rest(force), rest(ca.jacobian(force, v)), rest(ca.jacobian(force, a))
    return (
        ca.Function("statics", [q, p], [still, ca.jacobian(still, q)]),
        ca.Function("damping", [q, p], [damping]),
        ca.Function("inertia", [q, p], [inertia]),
    )


def _check_limits(model: RobotModel, p: np.ndarray) -> None:
    """Refuse parameters (n,) whose limits of joints are not those of the file, which plans and laws keep."""
    for one, value in zip(parameters(model.robot), p, strict=True):
        if ".limits" in one.name and one.name.endswith(LIMITS) and value != one.value:
            said = f"parameters: {one.name} is {value:g}, in the file {one.value:g}"
            raise UsageError(f"{said}; motions keep the limits of the file: change these there, or state tighter ones")


def _at(function: ca.Function, p: np.ndarray, q: np.ndarray) -> Any:
    return function(q, p)


@dataclass(frozen=True)
class PlannedModel:
    """One of the models that share a motion."""

    still: Still
    start: AtRest
    goal: AtRest
    energy: np.ndarray
    """(2 n, 2 n): of displacements from the goal and rates, twice what the arm has left to vibrate with, J."""
    force_scale: Any
    """What residuals are measured in."""


def member(still: Still, task: Task, first: PlannedModel | None) -> PlannedModel:
    """A model in a task; `first` is the model that is planned for, None for itself."""
    start, goal = still.held(task.start), still.held(task.goal)
    if first is not None:
        start, goal = (
            still.under(task.law, reference, planned.effort, near.q)
            for reference, planned, near in ((task.start, first.start, start), (task.goal, first.goal, goal))
        )
    return PlannedModel(still, start, goal, still.energy(goal, task.law.kp), task.force_scale)
