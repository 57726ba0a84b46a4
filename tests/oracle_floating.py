"""Robots with a floating base or ball joints, judged by the oracle's robot of other coordinates: slides and turns.

The base of the package has a quaternion and a twist; that of the oracle has Cartesian places and Euler angles. States
and accelerations are mapped by the oracle's own kinematics. A ball joint is three turns there.
"""

from __future__ import annotations

import copy

import numpy as np
from oracle import Oracle
from scipy.spatial.transform import Rotation

JOINTS = [{"slide": "x"}, {"slide": "y"}, {"slide": "z"}, "z", "y", "x"]
TURNS = ["z", "y", "x"]
ANGLE = 1.2
"""The Euler angles stay away from the singular ones."""


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


def columns(angles: np.ndarray) -> np.ndarray:
    """(3, 3): the axes of three turns in axes of the link, which take their rates to its angular velocity."""
    later, last = Rotation.from_rotvec([0, angles[1], 0]), Rotation.from_rotvec([angles[2], 0, 0])
    return np.column_stack([(later * last).inv().apply([0, 0, 1]), last.inv().apply([0, 1, 0]), [1, 0, 0]])


def column_rates(axes: np.ndarray, rates: np.ndarray) -> np.ndarray:
    """Their rates times those of the angles: later turns carry the axes of earlier ones."""
    a, b, c = axes.T
    return rates[0] * np.cross(a, b * rates[1] + c * rates[2]) + rates[1] * np.cross(b, c * rates[2])
