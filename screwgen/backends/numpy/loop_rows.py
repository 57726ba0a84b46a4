"""The rows of loops that bear forces: those that are independent, or where none can be left out, rows that share."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from ...errors import UsageError
from ...joints.constraints import Distance
from ...spec.parameters import turning
from ...topology.chain import Chain
from .closing import TOLERANCES, OpenLoopError, closed, jacobian, modes, nearest
from .numeric import Numeric

APART = 1e-9
"""Gap from which a loop counts as one that cannot be closed."""
RANK = 1e-7
"""A row counts as dependent where less than this part of it is new."""
SEEDS = 3
SPREAD = 0.6
"""rad or m: how far the random postures spread from which the search for a closed one begins."""
STROLL, BEND = 0.1, 0.02
"""How far a motion goes that must keep closed what follows from other rows: joints, rad or lengths; modes, lengths."""
AT_FIRST = (
    "opens by {} in a motion that keeps the other rows closed, from which it follows only at first; "
    "give links axial modes, or a joint that lets the loop move"
)
NOWHERE = "stays open by {} wherever the other rows are closed; move a mount so that both ends meet"


def choose_rows(chain: Chain) -> None:
    """Leave in `chain.closing` the rows that bear forces, those that no motion changes, and whether rows share forces.

    A row that follows from others wherever the robot is, such as the three that the joints of a planar loop in space
    satisfy by themselves, is left out. Where the loops are closed rows may depend on each other that do not elsewhere,
    as in a linkage of four skew hinges that moves all the same; from which others a row then follows changes with the
    posture, so all rows that any motion changes are kept, and share what they bear.

    Judged at postures of straight links with closed loops; where none is found, of bent links; else at postures without
    pattern. These are of bent links too: what straight ones cannot change at first, such as the length of a rod without
    axial modes, bent ones can. Where a search ends with open loops is no place to judge: rows depend on each other
    there. Raises UsageError where a row that is left out stays open although those that remain are closed, and where
    the robot cannot go on in any motion that its rows allow at first.
    """
    closing = chain.closing
    if not closing.rows:
        return
    numeric, rng = Numeric(chain), np.random.default_rng(0)
    starts = _starts(chain, rng)
    slopes = [jacobian(numeric, posture) for posture in (*starts, *_bent(numeric, starts))]
    rows = max(map(_independent, slopes), key=len)
    places = _closed_places(numeric, starts)
    ranks = [_independent(jacobian(numeric, place)) for place in places]
    if not places:
        _refuse_apart(numeric, rows, starts, modes(chain), NOWHERE)
    singular = [(k, place) for k, place in zip(ranks, places, strict=True) if len(k) < len(rows)]
    overconstrained = any(_goes_on(numeric, *found) for found in singular)
    sizes = np.max(np.abs(slopes), axis=(0, 2), initial=0.0)
    moved = sizes > RANK * np.max(sizes, initial=0.0)
    if overconstrained:
        rows = np.flatnonzero(moved).tolist()
    elif places:
        best, place = max(zip(ranks, places, strict=True), key=lambda found: len(found[0]))
        if len(best) < len(closing.rows):
            steps, reach = _motions(numeric, place, best)
            mixed = rng.standard_normal((SEEDS, len(steps))) @ steps
            _refuse_apart(numeric, best, _farther(chain, place, mixed, reach), None, AT_FIRST)
        rows = best
    idle = tuple(row for row, moves in zip(closing.rows, moved, strict=True) if not moves)
    chosen = tuple(closing.rows[k] for k in rows)
    chain.closing = replace(closing, rows=chosen, idle=idle, overconstrained=overconstrained)


def closed_postures(numeric: Numeric) -> list[np.ndarray]:
    """Some postures with closed loops, among them that near home where there is one."""
    return _closed_places(numeric, _starts(numeric.chain, np.random.default_rng(0)))


def _starts(chain: Chain, rng: np.random.Generator) -> np.ndarray:
    """Postures (SEEDS, nq) of straight links: that at home, and others without pattern."""
    out, joints = np.tile(np.array(chain.home), (SEEDS, 1)), slice(chain.base_q, chain.eta_q)
    out[1:, joints] = SPREAD * rng.standard_normal((SEEDS, chain.eta_q - chain.base_q))[1:]
    return out


def _bent(numeric: Numeric, starts: np.ndarray) -> np.ndarray:
    """The same postures with bent links, without pattern too; none where no link bends."""
    bending, rng = modes(numeric.chain), np.random.default_rng(1)
    if not bending.any():
        return starts[:0]
    return starts + BEND * _size(numeric, starts[0]) * bending * rng.standard_normal(starts.shape)


def _size(numeric: Numeric, q: np.ndarray) -> float:
    """The length of the longest link, m; 1 where no link has a length."""
    return float(np.max(np.abs(numeric.tip_poses(q)[1] - numeric.link_pose(q)[1]), initial=0.0)) or 1.0


def _closed_places(numeric: Numeric, starts: np.ndarray) -> list[np.ndarray]:
    """Postures with closed loops near `starts`, of straight links or, where none is found, of bent ones."""
    found: list[np.ndarray] = []
    for held in (modes(numeric.chain), None):
        for start in starts:
            with suppress(OpenLoopError):
                found.append(closed(numeric, start, held, hasty=True))
        if found:
            break
    return found


def _motions(numeric: Numeric, q: np.ndarray, rows: list[int]) -> tuple[np.ndarray, np.ndarray]:
    """The motions (m, n) from `q` that at first keep the `rows` closed, one in each direction, and the reach (n,) of
    the coordinates, over which they are stated."""
    chain, own = numeric.chain, slice(numeric.chain.base_v, None)
    size = _size(numeric, q)
    reach = np.where(modes(chain), BEND * size, STROLL)[chain.base_q :]
    reach[: chain.n_joints] *= np.where(turning(chain.robot), 1.0, size)
    slopes = jacobian(numeric, q)[rows][:, own] * reach
    return np.linalg.svd(slopes)[2][len(rows) :], reach


def _farther(chain: Chain, q: np.ndarray, steps: np.ndarray, reach: np.ndarray) -> np.ndarray:
    """The postures some way from `q` along motions."""
    out = np.tile(q, (len(steps), 1))
    out[:, chain.base_q :] += reach * steps / np.max(np.abs(steps), axis=1, initial=1e-3, keepdims=True)
    return out


def _goes_on(numeric: Numeric, rows: list[int], q: np.ndarray) -> bool:
    """Whether the robot can go on from `q`, with all loops closed, in every motion that the `rows` allow at first.

    Some way along it the loops must close again, no part of the motion taken back.
    """
    steps, reach = _motions(numeric, q, rows)
    ends = [_going(numeric, there, steps / reach) for there in _farther(numeric.chain, q, steps, reach)]
    return len(steps) > 0 and max(np.max(np.abs(numeric.offsets(end))) for end in ends) < APART


def _going(numeric: Numeric, there: np.ndarray, motions: np.ndarray) -> np.ndarray:
    """Where the loops close near `there`, as far along every one of the `motions` as that is.

    A search of the loops alone would wander: along what they leave free, nothing holds it.
    """
    from scipy.optimize import least_squares

    first, rates = numeric.chain.base_q, slice(numeric.chain.base_v, None)
    at = lambda x: np.append(there[:first], x)  # noqa: E731
    apart = lambda x: np.append(numeric.offsets(at(x)), motions @ (x - there[first:]))  # noqa: E731
    slopes = lambda x: np.vstack([numeric.offset_slopes(at(x))[:, rates], motions])  # noqa: E731
    return at(least_squares(apart, there[first:], slopes, x_scale="jac", **TOLERANCES).x)


def _refuse_apart(
    numeric: Numeric, rows: list[int], starts: Sequence[np.ndarray] | np.ndarray, held: np.ndarray | None, said: str
) -> None:
    """Refuse loops of which another row is open where the `rows` are closed, near any of `starts`."""
    stated, movable = numeric.chain.closing.rows, np.arange(numeric.chain.nq) >= numeric.chain.base_q
    gaps, movable = np.zeros(len(stated)), movable if held is None else movable & ~held
    for start in starts:
        found = np.abs(numeric.gaps(nearest(numeric, start, movable, True, rows), None)[0])
        if np.max(found[rows], initial=0.0) < APART:
            gaps = np.maximum(gaps, found)
    worst = int(np.argmax(gaps))
    if gaps[worst] > APART:
        row, name = stated[worst], numeric.chain.robot.name
        size = f"{gaps[worst]:.3g}{' m' if isinstance(row.row, Distance) else ', as a cosine'}"
        raise UsageError(f"robot '{name}': {row.text}: {said.format(size)}")


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
