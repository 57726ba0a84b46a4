"""The links: their classes, the tree that they form, and the offsets of coordinates, modes and parameters.

A link that is split into segments stands here as so many links; see :mod:`..spec.segments`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import accumulate
from typing import Any

import numpy as np

from ..arguments import Parameters, array
from ..errors import SingularError
from ..spec.link_class import link_class
from ..spec.parameters import turning
from ..spec.parents import parents
from ..spec.robot import Robot
from ..spec.segments import Segment, segments
from .parameters import labels
from .tree import BASE, Tree

ROTOR = {"q": "theta", "qdot": "thetadot", "qddot": "thetaddot", "force": "force_theta"}
"""The signal of a link's rotors by that of its joint."""


class Chain:
    """A robot as the algorithms see it: one class and one set of offsets per link."""

    def __init__(self, robot: Robot):
        self.robot = robot
        self.segments = segments(robot)
        kind = lambda s: link_class(robot.links[s.link], robot.section_rotation, robot.order, s.number)  # noqa: E731
        self.keys = [kind(segment) for segment in self.segments]
        self.tree = Tree(_carriers(robot, self.segments))
        self.classes = list(dict.fromkeys(self.keys))
        self.q_offset = list(accumulate((k.joints for k in self.keys), initial=0))
        self.eta_offset = list(accumulate((k.modes for k in self.keys), initial=0))
        self.theta_offset = list(accumulate((len(k.motors) for k in self.keys), initial=0))
        self.dry_offset = list(accumulate((len(k.rubbed) for k in self.keys), initial=0))
        self.below_offset = list(accumulate((len(k.coupled) for k in self.keys), initial=0))

    @cached_property
    def parameters(self) -> Parameters:
        """The robot's parameters, and the checks of their values."""
        return Parameters(self.robot)

    @property
    def n(self) -> int:
        return len(self.keys)

    @property
    def n_joints(self) -> int:
        """The number of joint coordinates, the first of `q`."""
        return self.q_offset[-1]

    @property
    def n_tau(self) -> int:
        """The number of torques, one per axis."""
        return self.n_joints

    @property
    def n_modes(self) -> int:
        return self.eta_offset[-1]

    @property
    def n_motors(self) -> int:
        """The number of rotors with a coordinate of their own, those of elastic drives."""
        return self.theta_offset[-1]

    @property
    def n_inner(self) -> int:
        """The number of coordinates behind those of the joints: rotors and modes."""
        return self.n_motors + self.n_modes

    @property
    def nq(self) -> int:
        """The number of coordinates: joints, then rotors, then modes."""
        return self.n_joints + self.n_inner

    @property
    def nv(self) -> int:
        """The number of their rates."""
        return self.nq

    @property
    def eta_q(self) -> int:
        """The index of the first modal coordinate in `q`."""
        return self.nq - self.n_modes

    @property
    def eta_v(self) -> int:
        """The index of its rate in `v`."""
        return self.nv - self.n_modes

    @cached_property
    def sprung(self) -> bool:
        """Whether springs, dampers or friction act in any joint."""
        return any(key.sprung for key in self.keys)

    @cached_property
    def geared(self) -> list[int]:
        """The joint coordinate, as an index in `v`, that each rotor drives."""
        return [self.q_offset[i] + axis for i, key in enumerate(self.keys) for axis in key.motors]

    @cached_property
    def driven(self) -> list[int]:
        """The coordinate, as an index in `v`, on which each torque acts: the joint's, or that of its rotor."""
        out, first = (
            list(range(self.nv - self.n_inner - self.n_tau, self.nv - self.n_inner)),
            self.eta_v - self.n_motors,
        )
        for k, joint in enumerate(self.geared):
            out[out.index(joint)] = first + k
        return out

    def ratios(self, p: Any) -> list:
        """The ratio of each rotor's gear out of the parameters `p`, numbers or symbols."""
        axes = [(self.parameter_labels[i], axis) for i, key in enumerate(self.keys) for axis in key.motors]
        places = [labels.get(f"drive_ratio_{axis + 1}") for labels, axis in axes]
        return [1.0 if place is None else p[place] for place in places]

    def relaxed(self, q: Any, p: Any) -> np.ndarray:
        """Joint coordinates or rates (n_joints, ...), and those of the rotors that leave their gears without load."""
        q = np.asarray(q, float)
        shape = (self.n_motors, *(1 for _ in q.shape[1:]))
        return np.concatenate([q, np.reshape(self.ratios(p), shape) * q[self.geared]])

    def filled(self, joints: Any, p: Any) -> np.ndarray:
        """All coordinates or rates (nq,) out of those of the joints: gears without load, modes zero."""
        return np.append(self.relaxed(joints, p), np.zeros(self.n_modes))

    def at_rotors(self, tau: Any, p: Any) -> np.ndarray:
        """Torques (n_tau,) where they act, of those at the joints: on rotors they are less by the ratio."""
        out = np.array(tau, float)
        out[[joint - (self.nv - self.n_inner - self.n_tau) for joint in self.geared]] /= np.array(self.ratios(p))
        return out

    @cached_property
    def dry(self) -> list[int]:
        """The coordinates, as indices in `v`, with dry friction."""
        axes = [self.q_offset[i] + axis for i, key in enumerate(self.keys) for axis in key.rubbed]
        places = dict(zip(range(self.n_joints), self.driven, strict=True))
        return [places[axis] for axis in axes]

    def singular(self, link: int) -> SingularError:
        """The error of a link that cannot be solved for."""
        return SingularError(f"the joint of link '{self.names[link]}' is singular in this posture{self.caution}")

    @property
    def caution(self) -> str:
        """What else than a posture may make the mass matrix singular, for the end of a message."""
        if all(key.order == 1 for key in self.keys):
            return ""
        bent = "a link of order 2 bends so far that its mass matrix is no longer positive definite"
        return f", or {bent}; then give it more segments"

    @property
    def slides(self) -> bool:
        """Whether any joint moves its link along an axis."""
        return any(key.slides for key in self.keys)

    @property
    def sliding(self) -> bool:
        """Whether any joint has a coordinate in m."""
        return not all(turning(self.robot))

    @property
    def n_given(self) -> int:
        """The number of coordinates, the last of q, whose inertia and force an integrator gives."""
        return self.nv if self.sprung else self.n_modes

    def given(self, i: int) -> dict[str, slice]:
        """The slices of these coordinates that hold ``eta`` and, if the robot is sprung, ``q`` and ``theta`` of a link.

        ``below``: the slice of the entries below the diagonal of their inertia, if modes are coupled; ``gear``: of
        those, behind them, that couple rotors and joints; ``dry``: the link's part of the axes with dry friction.
        """
        before, key = self.n_given - self.n_modes, self.keys[i]
        part = lambda first, offsets: slice(*(first + e for e in offsets[i : i + 2]))  # noqa: E731
        parts = {"eta": part(before, self.eta_offset)}
        if key.coupled:
            parts["below"] = part(self.n_given, self.below_offset)
        if key.sprung:
            parts["q"] = part(0, self.q_offset)
        if key.motors:
            parts["theta"] = part(before - self.n_motors, self.theta_offset)
            parts["gear"] = part(self.n_given + self.below_offset[-1], self.theta_offset)
        return parts | ({"dry": part(0, self.dry_offset)} if key.rubbed else {})

    @cached_property
    def coupled(self) -> list[tuple[int, int]]:
        """Row and column, among these coordinates, of the entries of their inertia below the diagonal."""
        first = [self.given(i)["eta"].start for i in range(self.n)]
        modes = [(f + i, f + j) for f, key in zip(first, self.keys, strict=True) for i, j in key.coupled]
        return modes + [(self.eta_v - self.n_motors + k, joint) for k, joint in enumerate(self.geared)]

    @property
    def n_inertia(self) -> int:
        """The number of entries of their inertia, stiffness or damping: the diagonal, then those below it."""
        return self.n_given + self.below_offset[-1] + self.n_motors

    def modal_product(self, A, x):
        """A symmetric matrix of these coordinates, by its entries (n_inertia, ...), times ``x`` (n_given, ...)."""
        out = A[: self.n_given] * x
        for k, (i, j) in enumerate(self.coupled, self.n_given):
            out[i] += A[k] * x[j]
            out[j] += A[k] * x[i]
        return out

    def split(self, q: Sequence, joint: str, modal: str) -> list[dict[str, list]]:
        """``[joint coordinates; rotors; modal coordinates]`` as one mapping per link."""
        qs, es, m = self.q_offset, self.eta_offset, len(q) - self.n_modes
        out = [{joint: list(q[qs[i] : qs[i + 1]]), modal: list(q[m + es[i] : m + es[i + 1]])} for i in range(self.n)]
        if self.n_motors:
            ts, t = self.theta_offset, m - self.n_motors
            for i, link in enumerate(out):
                link[ROTOR[joint]] = list(q[t + ts[i] : t + ts[i + 1]])
        return out

    def join(self, links: Sequence[Mapping[str, list]], joint: str, modal: str) -> list:
        """The inverse of :meth:`split`."""
        parts = [joint, *([ROTOR[joint]] if self.n_motors else []), modal]
        return [x for part in parts for link in links for x in link.get(part, ())]

    @cached_property
    def parameter_labels(self) -> list[dict[str, int]]:
        """For every link: the label of each of its parameters and its place in the parameter vector."""
        own = labels(self.robot)
        return [own[s.link] for s in self.segments]

    @property
    def names(self) -> list[str]:
        """The names of the links, in messages and tables; of segments `boom[2]`."""
        return [s.name for s in self.segments]

    @property
    def identifiers(self) -> list[str]:
        """The names of the links in code; of segments `boom_2`."""
        return [s.identifier for s in self.segments]

    def tip_wrenches(self, given, name: str) -> np.ndarray:
        """Wrenches on the tips (n, 6) from those given, of all segments or on the tips of the robot's links alone."""
        links = len(self.robot.links)
        if links == self.n or not (hasattr(given, "__len__") and len(given) == links):
            return array(given, name, (self.n, 6))
        out = np.zeros((self.n, 6))
        out[self.lasts] = array(given, name, (links, 6))
        return out

    @property
    def firsts(self) -> list[int]:
        """Where in the chain each link of the robot begins: its only or its first segment."""
        return [i for i, s in enumerate(self.segments) if s.first]

    @property
    def lasts(self) -> list[int]:
        """Where in the chain each link of the robot ends."""
        return [i for i, s in enumerate(self.segments) if s.last]


def _carriers(robot: Robot, pieces: Sequence[Segment]) -> tuple[int, ...]:
    """The number of the segment that carries each segment: the one before it, or the last of the link's parent."""
    carriers, last = parents(robot.links), {BASE: BASE}
    out = []
    for place, segment in enumerate(pieces):
        out.append(last[carriers[segment.link]] if segment.first else place - 1)
        last[segment.link] = place
    return tuple(out)
