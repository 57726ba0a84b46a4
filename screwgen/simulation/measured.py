"""What sensors measure along motions: the functions of markers at many samples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..algorithms.robot_function import is_matrix, shape
from ..algorithms.robot_functions import BY_NAME, SENSORS, known
from ..robot_model import RobotModel
from ..spec.robot import Robot

STRAIN = "strain"


def is_measured(name: str, robot: Robot | None = None) -> bool:
    """Whether a function is what a sensor measures, the product's or one that the robot holds."""
    own = robot.sensors if robot is not None else ()
    return BY_NAME[name].c_file == SENSORS if name in BY_NAME else any(x.name == name and x.told for x in own)


def measured(
    model: RobotModel, name: str, samples: Mapping[str, np.ndarray], p: Sequence[float] | np.ndarray
) -> np.ndarray | tuple[np.ndarray, ...]:
    """The results of a function at N samples, with N in front of their shapes; a tuple where they are several.

    ``samples``: its arguments by name, ``q`` (N, nq), ``v`` (N, nv), ``tau`` (N, n_tau), ``w_ext`` (N, n, 6).
    """
    if name == STRAIN:
        return strain(model, samples["q"], p)
    row, count = known(model.chain)[name], len(samples["q"])
    given = [samples[x].reshape(-1, samples[x].shape[-1]).T for x in row.names]
    found = model.casadi()[name].map(count).call([*given, np.tile(p, (count, 1)).T])
    sizes = [(1,) * is_matrix(signal) + shape(signal, model.chain) for signal in row.results.values()]
    out = [_apart(x.full(), count, size) for x, size in zip(found, sizes, strict=True)]
    found = [x[:, 0] if is_matrix(signal) else x for x, signal in zip(out, row.results.values(), strict=True)]
    return tuple(found) if len(found) > 1 else found[0]


def strain(model: RobotModel, q: np.ndarray, p: Sequence[float] | np.ndarray) -> np.ndarray:
    """The strains (…, strains) at coordinates (…, nq): they are linear in those of the modes."""
    slopes = model.numpy(np.asarray(p)).strain_slopes()
    if q.ndim < 3:
        return np.asarray(q[..., model.chain.eta_q :] @ slopes.T)
    side_by_side = q.transpose(1, 2, 0)[:, model.chain.eta_q :]  # scenarios, as rollouts keep them
    return np.matmul(slopes, side_by_side).transpose(2, 0, 1)


def _apart(columns: np.ndarray, count: int, size: tuple[int, ...]) -> np.ndarray:
    """Samples that stand side by side, as rows: of each its rows as columns, or its matrices side by side."""
    if len(size) < 3:
        return columns.T.reshape(count, *size)
    rows, across = size[-2:]
    return columns.reshape(rows, count, -1, across).transpose(1, 2, 0, 3)
