"""States in which windows of robots with loops begin: independent coordinates are chosen, the others follow them."""

from __future__ import annotations

import numpy as np

from ..backends.numpy.closing import OpenLoopError
from ..errors import UsageError
from ..robot_model import RobotModel
from ..simulation.mobility import closing, motions
from ..studies.equilibrium import closed_start

ROUNDS, CLOSED = 20, 1e-12
"""Steps of Newton's method at most, and the gaps, m or cosines, at which it ends."""
RANK = 1e-10


def closed_near(model: RobotModel, x: np.ndarray, p: np.ndarray, kept: np.ndarray, name: str) -> np.ndarray:
    """The state near `x` (nq + nvz,) with closed loops in which joints that are `kept` (n_joints,) of bool stay.

    Raises UsageError, about the log `name`, where loops do not close there or the robot is none of these.
    """
    chain, n = model.chain, model.nq
    if chain.floating or chain.curved:
        what = "robots with loops are identified on a fixed base without ball joints; hold the base, or cut the loop"
        raise UsageError(f"identify: {what}")
    try:
        q = closed_start(model, p, x[:n], True, kept)[0]
    except OpenLoopError as error:
        raise UsageError(f"{name}: where its readings begin {error}") from None
    return np.append(q, x[n:])


def independent(model: RobotModel, x: np.ndarray, p: np.ndarray, kept: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The places of independent entries among changes of a state (nv + nvz,), and T: all changes by those of these."""
    chain, n = model.chain, model.nq
    size = chain.nv + chain.nvz
    if not chain.closing.rows:
        return np.arange(size), np.eye(size)
    q, rest = x[:n], x[n + chain.nv :]
    own, T = motions(model, q, np.append(_staying(model, x, p)[n : n + chain.nv], rest), p, kept)
    places = np.concatenate([own, chain.nv + own, np.arange(2 * chain.nv, size)])
    out = np.eye(size)[:, places]
    out[: 2 * chain.nv, : 2 * len(own)] = T
    return places, out


def closed(model: RobotModel, x: np.ndarray, p: np.ndarray, follow: np.ndarray) -> np.ndarray:
    """The state (nq + nvz,) whose coordinates `follow`, with their rates, close the loops; open where none do.

    That is Newton's method on these alone; on a fixed base places in q are those in v.
    """
    x, n = x.copy(), model.nq
    for _ in range(ROUNDS):
        gap, J = _gaps(model, x, p)
        if not np.max(np.abs(gap), initial=0.0) > CLOSED:
            break
        x[follow] -= np.linalg.lstsq(J[:, follow], gap, rcond=RANK)[0]
        if not np.isfinite(x).all():
            return x
    return _staying(model, x, p, n + follow)


def _staying(model: RobotModel, x: np.ndarray, p: np.ndarray, places: np.ndarray | None = None) -> np.ndarray:
    """The state with rates under which loops stay closed; of these those at `places` change, by default all."""
    x, n = x.copy(), model.nq
    at = np.arange(n, n + model.nv) if places is None else places
    _, J = _gaps(model, x, p)
    x[at] -= np.linalg.lstsq(J[:, at - n], J @ x[n : n + model.nv], rcond=RANK)[0]
    return x


def _gaps(model: RobotModel, x: np.ndarray, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The gaps (rows,) and their Jacobian (rows, nv)."""
    none = np.zeros(len(model.chain.closing.rows))
    gap, J, *_ = closing(model)(x[: model.nq], np.zeros(model.nv), none, p)
    return np.array(gap)[:, 0], np.array(J)
