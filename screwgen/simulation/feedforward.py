"""Feedforward of joint motions: the efforts that they take, with the bending that they cause.

A copy of the robot has the motion of all axes given, so its modes alone are integrated, implicitly, as its joints go
where they are told. Efforts follow from the inverse dynamics of what it does over a step, so they are the means that
a drive is to hold until the next sample.
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from itertools import count
from typing import NamedTuple

import numpy as np

from ..arguments import Given, Numbers, array, seconds
from ..errors import UsageError
from ..integrators.method import Method, Move, Stage
from ..planning.limits import motion_limits
from ..planning.members import Still
from ..planning.refusals import PLANNED, refuse_robot
from ..planning.track import check_limits
from ..robot_model import RobotModel
from ..spec.joint import MOTION, TORQUE
from ..spec.robot import Robot
from .integrate import CasadiEvaluator, JointState, JointStepper

METHOD = Method(
    "iterated_midpoint",
    2,
    (Stage(implicit="1/2"), Stage(["1/2"], "new", implicit="1/2"), Stage([0, "1/2"], "new", implicit="1/2")),
    Move([0, 0, 1], "mean"),
    "modal_midpoint with its middle found once more",
)
"""The integrator of the modes, in Python and in C.

The middle that the start predicts is rough where modes are much faster than the clock: in ELLA at a millisecond it
costs twenty times what the midpoint rule itself does.
"""
NAME = "{}_feedforward"
"""Of the copy, of the robot's own: the prefix of its C."""


class FedMotion(NamedTuple):
    """Efforts along a motion, and the coordinates that go with them."""

    tau: np.ndarray
    """(N − 1, n_joints): means of the efforts from each sample to the next, N·m, of slides N; of elastic drives times
    the ratio."""
    q: np.ndarray
    """(N, nq): coordinates at the samples, those of joints, of elastic drives of the rotors, as given."""
    v: np.ndarray
    """(N, nv): their rates."""


def feedforward(model: RobotModel, q: Numbers, v: Numbers, step: float, parameters: Given = None) -> FedMotion:
    """The efforts with which joints move as given, and the bending that comes with it.

    `q`, `v` (N, n_joints): coordinates, rad, of slides m, and rates of the joints at N samples, `step` seconds apart.
    The arm begins at rest with the joints at `q[0]`, bent as gravity bends it. Of a joint behind an elastic gear all is
    said of the rotor: its angle over the ratio, its effort times the ratio.

    A held joint damps no bending: what the motion excites goes on, and the efforts hold against it. So this belongs to
    motions that leave no vibration, such as those of :func:`plan`, and under a joint law.

    Raises UsageError on other shapes, on numbers that are not finite, on a start that moves, on rates that are not
    those of the coordinates, on a motion beyond the limits of joints and drives in the robot file, and for robots whose
    efforts do not follow from the motion of joints alone, as those with loops or on floating bases.
    """
    m, step = model.n_joints, seconds(step, "the step")
    ahead = Feedforward(model, parameters)
    q = array(q, "q: of joints at samples:", (len(np.atleast_1d(np.asarray(q, dtype=object))), m))
    v = array(v, "v: of joints at samples:", (len(q), m))
    if len(q) < 2:
        raise UsageError(f"q: of joints has {len(q)} sample; a motion has two at least")
    check_rates(q, v, step)
    states = [ahead.at_rest(q[0])]
    tau = []
    for there, rate in zip(q[1:], v[1:], strict=True):
        state, effort = ahead.next(states[-1], there, rate, step)
        states.append(state)
        tau.append(effort)
    check_limits("q", q, np.array(tau), motion_limits(model, {}, headroom=1.0), model.q_names[:m])
    return FedMotion(np.array(tau), np.array([s.q for s in states]), np.array([s.v for s in states]))


ROUNDING, LEAST, MISSED = 1e-7, 1e-12, 0.05
"""How far sums of rates may miss the way of a joint: by its coordinate, rad or m, and by the largest way of a step."""
STILL = 1e-6
"""Up to which share of its largest rate a joint is at rest."""


def check_rates(q: np.ndarray, v: np.ndarray, step: float) -> None:
    """Refuse a start that is not at rest, and rates whose means over steps are not the ways of the coordinates.

    Coordinates that jump are such.
    """
    if (moving := np.abs(v[0]) > LEAST + STILL * np.abs(v).max(axis=0)).any():
        j = int(moving.argmax())
        raise UsageError(f"v: joint {j} begins with the rate {v[0, j]:.4g}; begin at rest, as the arm does")
    way, passed = np.diff(q, axis=0), step * (v[1:] + v[:-1]) / 2
    for j, off in enumerate(np.abs(way - passed).T):
        largest = step * np.abs(v[:, j]).max()
        if off.max() > LEAST + ROUNDING * np.abs(q[:, j]).max() + MISSED * largest:
            k = int(off.argmax())
            rates = f"rates {v[k, j]:.4g}, {v[k + 1, j]:.4g}"
            said = f"joint {j} goes {way[k, j]:.4g} from sample {k} to the next, with {rates}"
            raise UsageError(f"v: {said}; give the rates of the coordinates, and coordinates that do not jump")


class Feedforward:
    """Efforts sample by sample; a state is that of the arm whose joints have moved as they were told."""

    def __init__(self, model: RobotModel, parameters: Given = None):
        p = model.chain.parameters.vector(parameters)
        copy = moved_model(model)
        self.joints, self.still = model.n_joints, Still(model, p)
        self.places, self.ratios = self.still.drives.places, np.array(self.still.drives.ratios)
        self.stepper, self.p = JointStepper(copy, METHOD, p), p
        self.inverse = CasadiEvaluator(copy.casadi()["inverse_dynamics"])
        self.free = np.zeros((model.n_links, 6))

    def at_rest(self, joints: np.ndarray) -> JointState:
        """The arm at rest with its joints where they are said to be, (n_joints,)."""
        q = self.still.drives.to_robot(self.still.held(joints).q)
        return self.stepper.initial(q, np.zeros_like(q))

    def next(self, state: JointState, q: np.ndarray, v: np.ndarray, step: float) -> tuple[JointState, np.ndarray]:
        """The state a step later, with the joints at `q`, `v` (n_joints,), and the mean efforts (n_joints,) until then.

        Raises DivergedError or SingularError where the arm cannot move so.
        """
        given = self.ratios * q, self.ratios * v
        later = self.stepper.step(state, (given[1] - state.v[self.places]) / step, self.free, step)
        later.q[self.places], later.v[self.places] = given
        middle = (state.q + later.q) / 2, (state.v + later.v) / 2
        force = self.inverse(*middle, (later.v - state.v) / step, self.free, self.p)[0]
        return later, self.ratios * force[self.places]

    def along(self, references: Iterator[tuple[np.ndarray, np.ndarray]], step: float) -> Iterator[np.ndarray]:
        """The mean efforts between references `(q, v)` at samples, from rest at the first, as they are asked for."""
        state = self.at_rest(next(references)[0])
        for q, v in references:
            state, tau = self.next(state, q, v, step)
            yield tau


def moved_model(model: RobotModel) -> RobotModel:
    """The model of the robot whose axes all move as given, at the same parameters; refuses loops."""
    refuse_robot(model, "feedforward", "use a joint law alone", PLANNED)
    return model.once("feedforward", lambda: RobotModel(moved(model.robot)))


def moved(robot: Robot, axes: Container[int] | None = None) -> Robot:
    """The robot whose axes, by default all, or those of these numbers, move as given, under a name of its own."""
    links, numbers = [], count()
    for link in robot.links:
        own = [axes is None or next(numbers) in axes for _ in link.joint.axes]
        joint = link.joint.model_copy(update={"actuation": tuple(MOTION if x else TORQUE for x in own)})
        links.append(link.model_copy(update={"joint": joint}) if any(own) else link)
    return robot.model_copy(update={"name": NAME.format(robot.name), "links": tuple(links)})
