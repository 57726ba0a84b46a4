"""States in which windows of robots with loops begin: independent coordinates are chosen, the others follow them."""

from __future__ import annotations

import numpy as np

from ..backends.numpy.closing import OpenLoopError
from ..errors import UsageError
from ..robot_model import RobotModel
from ..simulation.mobility import OPEN, closing, motions
from ..studies.equilibrium import closed_start

ROUNDS, CLOSED = 20, 1e-12
"""Steps of Newton's method at most, and the gaps, m or cosines, at which it ends."""
RANK = 1e-10
APART = 0.05
"""rad or m: how far joints move at a time where others follow them."""


def closed_near(model: RobotModel, x: np.ndarray, p: np.ndarray, kept: np.ndarray, name: str) -> np.ndarray:
    """The state near `x` (nq + nvz,) with closed loops in which joints that are `kept` (n_joints,) of bool stay.

    A base that floats stays too. Raises UsageError, about the log `name`, where loops do not close there.
    """
    n = model.nq
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

    That is Newton's method on these alone. `follow`: places in v; no loop moves a base, whose turn does not add up.
    """
    x, n = x.copy(), model.nq
    for _ in range(ROUNDS):
        gap, J = _gaps(model, x, p)
        if not np.max(np.abs(gap), initial=0.0) > CLOSED:
            break
        x[follow + n - model.nv] -= np.linalg.lstsq(J[:, follow], gap, rcond=RANK)[0]
        if not np.isfinite(x).all():
            return x
    return _staying(model, x, p, n + follow)


def walked(
    model: RobotModel, x: np.ndarray, p: np.ndarray, places: np.ndarray, rows: np.ndarray, kept: np.ndarray
) -> np.ndarray:
    """The state at the end of a walk from `x` (nq + nvz,) with coordinates at `places` through `rows` (N, places).

    The others follow in steps of APART, `kept` (n_joints,) of bool last; where they cannot, the walk leaps there.
    """
    x = x.copy()
    for k, row in enumerate(rows):
        if k < len(rows) - 1 and np.max(np.abs(row - x[places]), initial=0.0) < APART:
            continue
        there = x.copy()
        there[places] = row
        follow = np.setdiff1d(np.arange(model.nv), independent(model, x, p, kept)[0])
        there = closed(model, there, p, follow)
        if not np.max(np.abs(_gaps(model, there, p)[0])) < OPEN:
            break
        x = there
    x[places] = rows[-1:].ravel() if len(rows) else x[places]
    return x


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
