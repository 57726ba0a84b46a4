"""Robots with a floating base, judged by the oracle's robot of other coordinates: three slides and three turns.

The base of the package has a quaternion and a twist; that of the oracle has Cartesian places and Euler angles. States
and accelerations are mapped by the oracle's own kinematics.
"""

from __future__ import annotations

import copy
from typing import NamedTuple

import numpy as np
import random_robots as rr
from helpers import model_of
from oracle import Oracle, part_error
from scipy.spatial.transform import Rotation

from screwgen import Model

JOINTS = [{"slide": "x"}, {"slide": "y"}, {"slide": "z"}, "z", "y", "x"]
ANGLE = 1.2
"""The Euler angles stay away from the singular ones."""


class FloatingCase(NamedTuple):
    """A robot in a state: `given` q, v, tau, w_ext as the package takes them, `state` those of the oracle."""

    robot: dict
    model: Model
    oracle: Oracle
    state: dict
    given: tuple

    @property
    def tolerance(self) -> float:
        return self.oracle.tolerance(self.state["q"])

    def expected(self) -> tuple[np.ndarray, np.ndarray]:
        """Rates of v, with that of the base's twist, and joint wrenches."""
        q, v = self.state["q"], self.state["v"]
        vdot, wrench = self.oracle.forward_dynamics(**self.state)
        return np.append(self.oracle.link_twist_rates(q, v, vdot)[0], vdot[6:]), wrench

    def twist_map(self) -> np.ndarray:
        """(nv, nv): the oracle's rates to those of the package."""
        out = np.eye(self.oracle.nv)
        for k in range(6):
            out[:6, k] = self.oracle.link_twists(self.state["q"], np.eye(self.oracle.nv)[k])[0]
        return out

    def errors(self, vdot, wrench) -> dict[str, float]:
        """Errors of base, joints, modes, moments and forces, each over the reference's largest entry of its kind.

        A part that all but vanishes is measured against 1e-4 of all accelerations or wrenches. The base has no wrench.
        """
        given, (expected, W) = (vdot, np.reshape(wrench, (-1, 6))), self.expected()
        split = lambda x: (x[:6], *np.split(x[6:], [self.oracle.n_joint - 6]))  # noqa: E731
        names = zip(("base", "joints", "modes"), split(expected), split(given[0]), strict=True)
        found = {name: part_error(a, b, expected) for name, a, b in names}
        found["wrench on the base"] = float(np.any(given[1][0] != 0.0))
        for name, part in (("tau", np.s_[:3]), ("F", np.s_[3:])):
            found[name] = part_error(W[1:, part], given[1][1:, part], W[1:])
        return found


def floating(robot: dict) -> dict:
    """The robot with its first link set free; what was on the world is on the first link."""
    robot = copy.deepcopy(robot)
    first = robot["links"][0]
    first["joint"] = {"axes": []}
    for link in robot["links"][1:]:
        if link.get("parent") == "world":
            link["parent"] = first["name"]
    return robot | {"base": "floating"}


def twin(robot: dict) -> dict:
    """The same robot with a fixed base, whose first link has all six freedoms by its joint."""
    robot = copy.deepcopy(robot)
    del robot["base"]
    robot["links"][0]["joint"] = {"axes": JOINTS}
    return robot


def coordinates(oracle: Oracle, q, v) -> tuple[np.ndarray, np.ndarray]:
    """The oracle's coordinates and rates as those of a floating base."""
    poses = oracle.poses(q)
    Q = Rotation.from_matrix(poses["R"][0]).as_quat(scalar_first=True)
    return np.concatenate([poses["origin"][0], Q, q[6:]]), np.append(oracle.link_twists(q, v)[0], v[6:])


def case_of(robot: dict, state: dict, oracle: Oracle | None = None) -> FloatingCase:
    """A floating robot in a state of its twin."""
    oracle = oracle or Oracle(twin(robot))
    state = {name: np.array(x) for name, x in state.items()}
    state["tau"][:6] = 0.0
    q, v = coordinates(oracle, state["q"], state["v"])
    return FloatingCase(robot, model_of(robot), oracle, state, (q, v, state["tau"][6:], state["w_ext"]))


def draw(seed: int, n_links: int, **limits) -> FloatingCase:
    """A random robot with a regular mass matrix; that of a link of order 2 that bends too far may be indefinite."""
    rng = np.random.default_rng(seed)
    for _ in range(200):
        robot = floating(rr.random_robot(rng, n_links, **limits))
        state = rr.random_state(rng, twin(robot))
        state["q"][3:6] = list(rng.uniform(-ANGLE, ANGLE, 3))
        oracle = Oracle(twin(robot))
        if oracle.condition(state["q"]) <= 1e8 and np.linalg.eigvalsh(oracle.mass_matrix(state["q"]))[0] > 0:
            return case_of(robot, state, oracle)
    raise RuntimeError("no robot with a regular mass matrix in 200 draws")
