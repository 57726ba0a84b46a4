"""What a log moves: axes and a base whose motion is given, where readings put them and no input drives them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import UsageError
from ..joints.free import MOVING
from ..robot_model import RobotModel
from ..spec.base import BASE_MOTION
from ..spec.columns import UNITS, Columns
from . import smoothing
from .logs import Log

POSE, TURN = 7, slice(3, 7)
"""The coordinates of a base, place and quaternion, and those of its turn among them."""
UNEVEN = 0.1
"""By how much the length of a quaternion that was measured may differ from 1."""


@dataclass(frozen=True)
class MovedPlaces:
    """The places of what a log moves, those of a base first: as many of rates as of inputs, which accelerate them."""

    sensors: tuple[int, ...] = ()
    """The columns that say where they are, one of each coordinate."""
    of_q: tuple[int, ...] = ()
    of_v: tuple[int, ...] = ()
    of_tau: tuple[int, ...] = ()

    @property
    def base(self) -> bool:
        """Whether a base is among them."""
        return len(self.of_q) > len(self.of_v)

    def names(self, columns: Columns) -> frozenset[str]:
        """The columns that say where they are, by name."""
        return frozenset(columns.sensors[k].name for k in self.sensors)


@dataclass(frozen=True, eq=False)
class LoggedMotion:
    """Coordinates (N, of q), rates (N, of v) and, between samples, accelerations (N - 1, of v) of what a log moves."""

    q: np.ndarray
    v: np.ndarray
    vdot: np.ndarray


def moved_places(model: RobotModel, columns: Columns) -> MovedPlaces:
    """The places of what columns move of a robot: axes whose motion is given, and a base of which all of the pose is
    measured; not what inputs accelerate.

    Raises UsageError where only a part of the pose of a base is measured, and no input accelerates it.
    """
    chain = model.chain
    measured = {str(column.measures): k for k, column in enumerate(columns.sensors)}
    driven = [model.tau_names.index(str(column.drives)) for column in columns.inputs]
    rows = list[tuple[Sequence[int], ...]]()
    if chain.moving and not set(of_base := range(chain.n_tau)[chain.inputs[BASE_MOTION]]) & set(driven):
        pose = model.q_names[:POSE]
        there = [name for name in pose if name in measured]
        if there and len(there) < POSE:
            said = f"identify: of the base's pose columns measure {', '.join(there)}"
            raise UsageError(f"{said}; measure all of {', '.join(pose)}, or drive {model.tau_names[of_base.start]} …")
        if there:
            base_v = range(len(of_base))
            rows.append(([measured[name] for name in pose], range(POSE), base_v, of_base))
    for joint in chain.prescribed:
        place = chain.held_places[joint]
        at = chain.place_in_q(place)
        if joint not in driven and (name := model.q_names[at]) in measured:
            rows.append(([measured[name]], [at], [place], [joint]))
    return MovedPlaces(*(tuple(x for part in parts for x in part) for parts in zip(*rows, strict=True)))


def logged_motion(places: MovedPlaces, log: Log, columns: Columns, readings: np.ndarray, reach: int) -> LoggedMotion:
    """The motion of what a log moves, by cubics through its readings (N, sensors) within `reach` samples."""
    q, v = (np.zeros((len(log), len(places.sensors))) for _ in range(2))
    for k, sensor in enumerate(places.sensors):
        column = columns.sensors[sensor]
        q[:, k] = (readings[:, sensor] - column.offset) / column.scale * UNITS[column.unit]
        if np.isnan(q[:, k]).any():
            what = "the base" if places.base and k < POSE else "an axis"
            raise UsageError(f"{log.name}: {column.name} moves {what} and lacks readings; cut the log there")
    if places.base:
        q[:, TURN] = _continuous(log.name, q[:, TURN])
    for k, values in enumerate(q.T.copy()):
        q[:, k], v[:, k] = smoothing.motion(values, log.step, reach)
    if places.base:
        size = np.linalg.norm(q[:, TURN], axis=1, keepdims=True)
        q[:, TURN], v[:, TURN] = q[:, TURN] / size, v[:, TURN] / size
        twist = [MOVING.rates_of(*rows) for rows in zip(q[:, :POSE], v[:, :POSE], strict=True)]
        v = np.hstack([np.array(twist), v[:, POSE:]])
    return LoggedMotion(q, v, np.diff(v, axis=0) / log.step)


def _continuous(name: str, turn: np.ndarray) -> np.ndarray:
    """Quaternions (N, 4) of the same turns, whose sign changes nowhere."""
    size = np.linalg.norm(turn, axis=1)
    if (wrong := np.flatnonzero(np.abs(size - 1) > UNEVEN)).size:
        said = f"row {wrong[0] + 1}: the base has a quaternion (w, x, y, z) of length {size[wrong[0]]:.3g}"
        raise UsageError(f"{name}: {said}; it must be 1, check what its columns measure")
    along = np.sum(turn[1:] * turn[:-1], axis=1)
    return turn * np.cumprod(np.append(1.0, np.where(along < 0, -1.0, 1.0)))[:, None]
