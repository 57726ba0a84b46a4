"""Loops of rollouts: which scenarios start with open loops, or open them on the way."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..algorithms import tip_programs
from ..backends.numpy.closing import OPENED, extent
from ..backends.numpy.python import NAMESPACE
from ..ir.replay import run
from ..robot_model import RobotModel

START = {np.dtype(np.float64): 1e-6, np.dtype(np.float32): 1e-5}
"""Mismatch, m or rad, at which loops count as open in the beginning, by the type of the numbers."""
BLOCK = 1 << 14
"""States that are looked at together."""
STRIDE = 64
"""How far apart the samples are that are looked at first."""
ARRAYS: dict[str, Callable] = {name: np.vectorize(function, otypes=[float]) for name, function in NAMESPACE.items()}
ARRAYS |= {
    "sin": np.sin,
    "cos": np.cos,
    "sqrt": np.sqrt,
    "atan2": np.arctan2,
    "neg": np.negative,
    "on": lambda x: (x > 0) * 1.0,
}


def opened(model: RobotModel, parameters: np.ndarray, q: np.ndarray) -> np.ndarray:
    """(batch,): the first sample of each scenario at which a loop is open, or how many samples there are.

    `parameters` (batch or 1, n), `q` (batch, samples, nq). One sample in STRIDE is looked at, the first and the last
    among them, and all samples of scenarios that are open at one of these.
    """
    batch, samples, _ = q.shape
    if not model.chain.closing.junctions or not batch:
        return np.full(batch, samples)
    most = np.array([OPENED * extent(model.numpy(parameters[0]), q[0, 0]), OPENED])
    some = np.unique(np.append(np.arange(0, samples, STRIDE), samples - 1))
    worse = np.flatnonzero(_open(model, parameters, q[:, some], most).any(axis=1))
    out = np.full(batch, samples)
    if len(worse):
        own = parameters[worse] if len(parameters) > 1 else parameters
        out[worse] = np.argmax(_open(model, own, q[worse], most), axis=1)
    return out


def _open(model: RobotModel, parameters: np.ndarray, q: np.ndarray, most: np.ndarray) -> np.ndarray:
    """(batch, samples) of bool: where a loop is open by over `most`, m and rad; at the first sample by START."""
    batch, samples, _ = q.shape
    program = model.once("openings", lambda: tip_programs.openings(model.chain))
    out = np.zeros((batch, samples), bool)
    for first in range(0, batch, step := max(1, BLOCK // samples)):
        part = slice(first, first + step)
        p = parameters[part] if len(parameters) > 1 else parameters
        with np.errstate(invalid="ignore", over="ignore"):  # a scenario that stopped may hold an infinite state
            given = {"q": list(np.moveaxis(q[part].astype(float), 2, 0)), "p": list(p.T[..., None])}
            found = run(program, given, lambda op, *x: ARRAYS[op](*x))[0]["openings"]
            apart = np.stack([np.broadcast_to(x, q[part].shape[:2]) for x in found]).astype(float)
        apart = np.sqrt(apart).reshape(-1, 2, *q[part].shape[:2])
        out[part] = (apart > most[:, None, None]).any(axis=(0, 1))
        out[part, 0] = (apart[..., 0] > START[q.dtype]).any(axis=(0, 1))
    return out
