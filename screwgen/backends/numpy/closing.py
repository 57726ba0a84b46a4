"""Postures in which loops are closed, and the rows of loops that are independent there."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from copy import copy

import numpy as np

from ...arguments import Numbers
from ...errors import ScrewgenError, UsageError
from ...joints.constraints import Distance
from ...spec.parameters import turning
from ...topology.chain import Chain
from ...topology.loops import Closure
from .numeric import Numeric

TOLERANCES = dict.fromkeys(("xtol", "ftol", "gtol"), 1e-15)
COARSE = dict.fromkeys(("xtol", "ftol", "gtol"), 1e-7)
FAR = 1e-3
"""Gap at which a search is given up that has come to a stand by coarse tolerances."""
CLOSED = 1e-12
"""Gap, in m or as a cosine, below which a loop counts as closed."""
APART = 1e-9
"""Gap from which a loop counts as one that cannot be closed."""
ATTEMPTS = 4
RANK = 1e-7
"""A row counts as dependent where less than this part of it is new."""
SEEDS = 3
SPREAD = 0.6
"""rad or m: how far the random postures spread from which the search for a closed one begins."""
STROLL, BEND = 0.1, 0.02
"""How far a motion goes that must keep closed what follows from other rows: joints, rad or lengths; modes, lengths."""


class OpenLoopError(ScrewgenError):
    """No posture was found in which the loops are closed; `nearest` is where the search ended."""

    def __init__(self, message: str, nearest: np.ndarray):
        super().__init__(message)
        self.nearest = nearest


def jacobian(numeric: Numeric, q: np.ndarray) -> np.ndarray:
    """(rows, nv): the rates of the gaps by the rates of the coordinates; a floating base opens none."""
    out = numeric.gap_slopes(q)
    out[:, : numeric.chain.base_v] = 0.0
    return out


def closed(numeric: Numeric, q: Numbers, held: Sequence[bool] | np.ndarray | None = None, hasty=False) -> np.ndarray:
    """The posture near `q` (nq,) in which the loops are closed; `held` coordinates stay, and so does a floating base.

    Raises OpenLoopError. Where the search ends with open loops, as in a singular posture, it begins again near `q`.
    `hasty`: where loops stay open it is not said exactly by how much.
    """
    q, chain = np.array(q, float), numeric.chain
    if not chain.closures:
        return q
    free = np.ones(chain.nq, bool) if held is None else ~np.asarray(held, bool)
    free[: chain.base_q] = False
    rng, ends = np.random.default_rng(0), []
    for attempt in range(ATTEMPTS):
        start = q + free * (np.arange(len(q)) < chain.eta_q) * rng.normal(scale=0.1 * attempt, size=len(q))
        found, gap = _nearest(numeric, start, free, hasty)
        if np.max(np.abs(gap), initial=0.0) < CLOSED:
            return found
        ends.append((float(np.max(np.abs(gap))), found, gap))
    _, found, gap = min(ends, key=lambda end: end[0])
    closure = chain.closures[int(np.argmax(np.abs(gap)))]
    alike = [c.loop == closure.loop and type(c.row) is type(closure.row) for c in chain.closures]
    size, unit = np.linalg.norm(gap[alike]), "m" if isinstance(closure.row, Distance) else "rad"
    remedy = "start from a posture nearer to a closed one, or hold fewer coordinates"
    raise OpenLoopError(f"{closure.name} stays open by {size:.3g} {unit}; {remedy}", found)


def _nearest(numeric: Numeric, q: np.ndarray, free: np.ndarray, hasty: bool) -> tuple[np.ndarray, np.ndarray]:
    """Where least squares end, and the gaps there; coordinates that are not free stay.

    A search that is `hasty` ends where it comes to a stand far from closed.
    """
    from scipy.optimize import least_squares

    def at(x: np.ndarray) -> np.ndarray:
        out = q.copy()
        out[free] = x
        return out

    gap = lambda x: numeric.gaps(at(x), None)[0]  # noqa: E731
    if not free.any():
        return q, gap(q[free])
    first, own = numeric.chain.base_v, free[numeric.chain.base_q :]
    slopes = lambda x: jacobian(numeric, at(x))[:, first:][:, own]  # noqa: E731
    found = q[free]
    if hasty:
        found = least_squares(gap, found, slopes, **COARSE).x
        if np.max(np.abs(gap(found))) > FAR:
            return at(found), gap(found)
    found = least_squares(gap, found, slopes, **TOLERANCES).x
    return at(found), gap(found)


def moving(numeric: Numeric, q: np.ndarray, v: Numbers) -> np.ndarray:
    """The rates nearest to `v` (nv,) that keep the loops closed at `q`."""
    v = np.array(v, float)
    return v - np.linalg.lstsq(jacobian(numeric, q), numeric.gaps(q, v)[1], rcond=1e-10)[0]


def independent(chain: Chain) -> tuple[Closure, ...]:
    """The rows of the loops that do not follow from those before them.

    A planar loop in space, for one, has three rows that its joints satisfy by themselves. Judged at postures of
    straight links with closed loops, by the one that allows the most rows; where none is found, of bent links; else at
    postures without pattern. Where a search ends with open loops is no place to judge: rows depend on each other there.
    Raises UsageError where a row that is left out stays open although those that remain are closed, or opens when the
    robot moves on from where all are closed.
    """
    numeric, rng = Numeric(chain), np.random.default_rng(0)
    starts, joints = np.tile(np.array(chain.home), (SEEDS, 1)), slice(chain.base_q, chain.eta_q)
    starts[1:, joints] = SPREAD * rng.standard_normal((SEEDS, joints.stop - joints.start))[1:]
    judged: list[tuple[list[int], np.ndarray]] = []  # the rows that are independent, and where
    anywhere = [(_independent(jacobian(numeric, start)), start) for start in starts]
    most = max(len(rows) for rows, _ in anywhere)
    for held in (_modes(chain), None):
        for start in starts:
            if not judged or len(judged[-1][0]) < most:  # closed loops have no more independent rows than open ones
                with suppress(OpenLoopError):
                    place = closed(numeric, start, held, hasty=True)
                    judged.append((_independent(jacobian(numeric, place)), place))
        if judged:
            break
    best, place = max(judged or anywhere, key=lambda found: len(found[0]))
    rows = tuple(chain.closures[k] for k in best)
    if not judged:
        said = "stays open by {} wherever the other rows are closed; move a mount so that both ends meet"
        _refuse_apart(numeric, rows, starts, _modes(chain), said)
    elif len(rows) < len(chain.closures):
        said = "opens by {} in a motion that keeps the other rows closed, from which it follows only at first; "
        said += "give links axial modes, or a joint that lets the loop move"
        _refuse_apart(numeric, rows, _farther(numeric, place, best, rng), None, said)
    return rows


def _farther(numeric: Numeric, q: np.ndarray, rows: list[int], rng: np.random.Generator) -> np.ndarray:
    """Postures (SEEDS, nq) some way from `q` along motions that at first keep the `rows` closed."""
    chain, own = numeric.chain, slice(numeric.chain.base_v, None)
    size = float(np.max(np.abs(numeric.tip_poses(q)[1] - numeric.link_pose(q)[1]), initial=0.0)) or 1.0
    reach = np.where(_modes(chain), BEND * size, STROLL)[chain.base_q :]
    reach[: chain.n_joints] *= np.where(turning(chain.robot), 1.0, size)
    slopes = jacobian(numeric, q)[rows][:, own] * reach
    steps = rng.standard_normal((SEEDS, len(reach)))
    steps -= steps @ np.linalg.pinv(slopes, rcond=1e-10) @ slopes
    out = np.tile(q, (SEEDS, 1))
    out[:, chain.base_q :] += reach * steps / np.max(np.abs(steps), axis=1, initial=1e-3, keepdims=True)
    return out


def _refuse_apart(
    numeric: Numeric, rows: tuple[Closure, ...], starts: np.ndarray, held: np.ndarray | None, said: str
) -> None:
    """Refuse loops of which another row is open where the independent `rows` are closed, near any of `starts`."""
    part, gaps = copy(numeric.chain), np.zeros(len(numeric.chain.closures))
    part.closures = rows
    for start in starts:
        with suppress(OpenLoopError):
            gaps = np.maximum(gaps, np.abs(numeric.gaps(closed(Numeric(part), start, held, hasty=True), None)[0]))
    worst = int(np.argmax(gaps))
    if gaps[worst] > APART:
        row, name = numeric.chain.closures[worst], numeric.chain.robot.name
        size = f"{gaps[worst]:.3g}{' m' if isinstance(row.row, Distance) else ', as a cosine'}"
        raise UsageError(f"robot '{name}': {row.text}: {said.format(size)}")


def _modes(chain: Chain) -> np.ndarray:
    """Which coordinates are modes."""
    return np.arange(chain.nq) >= chain.eta_q


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
