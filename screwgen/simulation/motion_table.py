"""Given motions from a table: a CSV file of `t` and of the coordinates of axes and of a base that move as is given."""

from __future__ import annotations

import os

import numpy as np

from ..errors import UsageError
from ..lazily import interpolate
from ..robot_model import RobotModel
from ..spec.load import one_line
from .input_table import read_table
from .prescribed_motion import BASE, Curve, given_axes

TURN = tuple(f"{BASE}.r{axis}" for axis in "xyz")
"""The names of a rotation vector in place of a quaternion."""


def read_motion(path: str | os.PathLike[str], model: RobotModel) -> dict[str, Curve]:
    """What `simulate(motion=…)` takes, cubic splines through the rows of the CSV file at `path`.

    Its head names `t`, s, and coordinates as `model.q_names` has them, of axes with `actuation = "motion"`, rad or m,
    and of a moving base: all seven of its pose, or its place and a rotation vector, ``base.rx`` to ``base.rz``, rad.
    A run's own CSV file is such a table where other columns are left out. Raises UsageError, also where a rotation
    vector changes by more than half a turn between rows.
    """
    chain, file = model.chain, one_line(os.fsdecode(path))
    if not (chain.prescribed or chain.moving):
        raise UsageError(f'{file}: nothing of this robot moves as is given; state actuation = "motion" of an axis')
    pose = model.q_names[:7] if chain.moving else []
    axes = given_axes(model)
    names = [*axes, *pose, *(TURN if pose else ())]
    t, columns = read_table(path, names)
    if len(t) < 2:
        raise UsageError(f"{file}: has one row; a motion needs two or more")
    curves = {name: interpolate.CubicSpline(t, columns[name]) for name in axes if name in columns}
    if given := [name for name in columns if name not in axes]:
        turned = pose[:3] + list(TURN)
        if set(given) not in ({*pose}, {*turned}):
            said = f"{file}: of the base it has {', '.join(given)}"
            raise UsageError(f"{said}; give all of {', '.join(pose)}, or of {', '.join(turned)}")
        whole = np.transpose([columns[name] for name in (pose if len(given) == 7 else turned)])
        if len(given) == 6:
            _refuse_turns(file, whole[:, 3:])
        curves[BASE] = interpolate.CubicSpline(t, _continuous(whole) if len(given) == 7 else whole)
    return curves


def _refuse_turns(file: str, turn: np.ndarray) -> None:
    """Refuse rotation vectors (k, 3) that jump between rows, as those that are kept within half a turn."""
    way = np.linalg.norm(np.diff(turn, axis=0), axis=1)
    if (way > np.pi).any():
        k = int(np.argmax(way > np.pi))
        said = (
            f"{file}: {', '.join(TURN)} change by {way[k]:.3g} rad from row {k + 1} to the next, more than half a turn"
        )
        raise UsageError(f"{said}; let them grow beyond pi, give more rows, or a quaternion")


def _continuous(pose: np.ndarray) -> np.ndarray:
    """Poses (k, 7) whose quaternions change their sign nowhere."""
    out, turn = pose.copy(), pose[:, 3:]
    sign = np.cumprod(np.append(1.0, np.where((turn[1:] * turn[:-1]).sum(axis=1) < 0, -1.0, 1.0)))
    out[:, 3:] *= sign[:, None]
    return out
