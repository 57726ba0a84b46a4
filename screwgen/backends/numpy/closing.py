"""Postures in which loops are closed, and the rows of loops that are independent there."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...arguments import Numbers
from ...errors import ScrewgenError
from ...joints.constraints import Distance
from ...topology.chain import Chain
from ...topology.loops import Closure
from .numeric import Numeric

ROUNDS = 60
CLOSED = 1e-12
"""Gap, in m or as a cosine, below which a loop counts as closed."""
RANK = 1e-7
"""A row counts as dependent where less than this part of it is new."""
SEEDS = 8
SPREAD = 0.6
"""rad or m: how far the random postures spread from which the search for a closed one begins."""


class OpenLoopError(ScrewgenError):
    """No posture was found in which the loops are closed; `nearest` is where the search ended."""

    def __init__(self, message: str, nearest: np.ndarray):
        super().__init__(message)
        self.nearest = nearest


def jacobian(numeric: Numeric, q: np.ndarray) -> np.ndarray:
    """(rows, nv): the rates of the gaps by the rates of the coordinates."""
    return np.array([numeric.gaps(q, unit)[1] for unit in np.eye(numeric.chain.nv)]).T


def closed(numeric: Numeric, q: Numbers, held: Sequence[bool] | None = None) -> np.ndarray:
    """The posture near `q` (nq,) in which the loops are closed; `held` coordinates stay. Raises OpenLoopError.

    Newton's method with the smallest change of the coordinates that may move; a step is halved until the gaps shrink.
    """
    q, free = np.array(q, float), np.ones(numeric.chain.nv, bool) if held is None else ~np.asarray(held, bool)
    gap = numeric.gaps(q, None)[0]
    for _ in range(ROUNDS):
        if np.max(np.abs(gap), initial=0.0) < CLOSED:
            return q
        step = np.zeros(len(q))
        step[free] = -np.linalg.lstsq(jacobian(numeric, q)[:, free], gap, rcond=1e-10)[0]
        part = min(1.0, 0.5 / max(np.max(np.abs(step)), 1e-300))
        while part > 1e-6:
            found = numeric.gaps(q + part * step, None)[0]
            if np.linalg.norm(found) < np.linalg.norm(gap):
                break
            part /= 2
        else:
            break
        q, gap = q + part * step, found
    worst = int(np.argmax(np.abs(gap)))
    closure = numeric.chain.closures[worst]
    unit = "m" if isinstance(closure.row, Distance) else "rad"
    remedy = "start from a posture nearer to a closed one"
    raise OpenLoopError(f"{closure.name} stays open by {abs(gap[worst]):.3g} {unit}; {remedy}", q)


def moving(numeric: Numeric, q: np.ndarray, v: Numbers) -> np.ndarray:
    """The rates nearest to `v` (nv,) that keep the loops closed at `q`."""
    v = np.array(v, float)
    return v - np.linalg.lstsq(jacobian(numeric, q), numeric.gaps(q, v)[1], rcond=1e-10)[0]


def independent(chain: Chain) -> tuple[Closure, ...]:
    """The rows of the loops that do not follow from those before them.

    A planar loop in space, for one, has three rows that its joints satisfy by themselves. Judged where the loops are
    closed, at the posture that allows the most rows; where none is found, at those where the search for one ended.
    """
    numeric, rng = Numeric(chain), np.random.default_rng(0)
    shut, open_ = [], []
    for seed in range(SEEDS):
        start = np.zeros(chain.nq)
        start[: chain.eta_q] = SPREAD * (seed > 0) * rng.standard_normal(chain.eta_q)
        try:
            shut.append(_independent(jacobian(numeric, closed(numeric, start))))
        except OpenLoopError as error:
            open_.append(_independent(jacobian(numeric, error.nearest)))
    return tuple(chain.closures[k] for k in max(shut or open_, key=len))


def _independent(G: np.ndarray) -> list[int]:
    """The numbers of the rows that are independent of those before them."""
    basis: list[np.ndarray] = []
    chosen = []
    largest = np.max(np.abs(G), initial=0.0)
    for k, row in enumerate(G):
        rest = row - sum((b * (b @ row) for b in basis), np.zeros(len(row)))
        rest -= sum((b * (b @ rest) for b in basis), np.zeros(len(row)))
        if np.linalg.norm(rest) > RANK * max(np.linalg.norm(row), RANK * largest):
            basis.append(rest / np.linalg.norm(rest))
            chosen.append(k)
    return chosen
