"""Postures in which loops are closed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress

import numpy as np

from ...arguments import Numbers
from ...errors import ScrewgenError
from ...joints.constraints import Ratio
from ...topology.chain import Chain
from .numeric import Numeric

TOLERANCES = dict.fromkeys(("xtol", "ftol", "gtol"), 1e-15) | {"max_nfev": 200}
COARSE = dict.fromkeys(("xtol", "ftol", "gtol"), 1e-7) | {"max_nfev": 25}
AGAIN = 0.15
"""rad or m: by how much farther every further search begins."""
HALF_A_TURN = 1.999
"""2 sin(θ/2) of frames that are half a turn apart, or nearly so."""
FAR = 1e-3
"""Offset at which a search is given up that has come to a stand by coarse tolerances."""
CLOSED = 1e-12
"""Offset, in m or of directions, below which a loop counts as closed."""
OPENED = 1e-2
"""Mismatch of a loop, over the size of the robot or in rad, at which runs end."""
ATTEMPTS, FEWER = 8, 4
"""How often a search begins; and one that is hasty."""
CORRECTIONS, NEAR, LEAST = 12, 0.5, 1e-6
"""How many of Newton's corrections there may be, the largest of them, rad or m, and the part of the largest slope below
which a direction is not corrected."""
Function = Callable[[np.ndarray], np.ndarray]


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


def closed(
    numeric: Numeric, q: Numbers, held: Sequence[bool] | np.ndarray | None = None, hasty: bool = False
) -> np.ndarray:
    """The posture near `q` (nq,) in which the loops are closed; `held` coordinates stay, and so does a floating base.

    Raises OpenLoopError. Where the search ends with open loops, as in a singular posture or with frames half a turn
    apart, it begins again, farther and farther from `q`. `hasty`: where loops stay open it is not said exactly by how
    much.
    """
    q, chain = np.array(q, float), numeric.chain
    if not chain.closing.junctions:
        return q
    movable = np.ones(chain.nq, bool) if held is None else ~np.asarray(held, bool)
    movable[: chain.base_q] = False
    rng, ends = np.random.default_rng(0), []
    joints = movable & (np.arange(len(q)) < chain.eta_q)
    for attempt in range((FEWER if hasty else ATTEMPTS) if joints.any() else 1):
        start = q + joints * rng.normal(scale=AGAIN * attempt, size=len(q))
        found = unwound(chain, nearest(numeric, start, movable, hasty), q)
        worst = float(np.max(np.abs(numeric.offsets(found)), initial=0.0))
        if worst < CLOSED:
            return found
        ends.append((worst, found))
    raise _open(numeric, min(ends, key=lambda end: end[0])[1])


def unwound(chain: Chain, found: np.ndarray, start: np.ndarray) -> np.ndarray:
    """The same posture with the angles of hinges no more than half a turn from those of `start`.

    A search may leave one that it does not need thousands of turns away, where single precision is of no use. The
    coordinates of screws and of coupled axes are left as they are: whole turns of theirs are other postures.
    """
    coupled = {axis for c in chain.closing.rows if isinstance(c.row, Ratio) for axis in (c.row.axis, c.row.of)}
    screws = [(i, n, screw) for i, key in enumerate(chain.keys) for n, screw in enumerate(key.screws)]
    hinges = [(i, n) for i, n, s in screws if s.turn and not s.slides and chain.tau_offset[i] + n not in coupled]
    out, at = found.copy(), np.array([chain.q_offset[i] + n for i, n in hinges], int)
    out[at] -= 2 * np.pi * np.round((found[at] - start[at]) / (2 * np.pi))
    return out


def closed_softly(numeric: Numeric, q: Numbers, held: Sequence[bool] | np.ndarray) -> np.ndarray:
    """The same with modes that stay as in `q`; where the loops do not close so, modes that are not `held` move too."""
    held, bending = np.asarray(held, bool), modes(numeric.chain)
    try:
        return closed(numeric, q, held | bending)
    except OpenLoopError as error:
        if (held | ~bending).all():
            raise
        with suppress(OpenLoopError):
            return closed(numeric, q, held)
        raise error


def _open(numeric: Numeric, q: np.ndarray) -> OpenLoopError:
    """The error of a search that ended at `q`: it names the loop that is farthest from closed."""
    apart = numeric.mismatch(q)
    loop, kind = divmod(int(np.argmax(apart)), 2)
    size, name = f"{apart[loop, kind]:.3g} {('m', 'rad')[kind]}", numeric.chain.closing.junctions[loop].name
    if kind and apart[loop, 1] > HALF_A_TURN:
        size = "half a turn between its frames"
    remedy = "start from a posture nearer to a closed one, or hold fewer coordinates"
    return OpenLoopError(f"{name} stays open by {size}; {remedy}", q)


def nearest(
    numeric: Numeric, q: np.ndarray, movable: np.ndarray, hasty: bool, rows: list[int] | None = None
) -> np.ndarray:
    """Where least squares of the offsets, or of the gaps of these rows alone, end; coordinates not `movable` stay.

    A search that is `hasty` ends where it comes to a stand far from closed.
    """
    from scipy.optimize import least_squares

    def at(x: np.ndarray) -> np.ndarray:
        out = q.copy()
        out[movable] = x
        return out

    if not movable.any() or rows == []:
        return q
    first, own = numeric.chain.base_v, movable[numeric.chain.base_q :]
    if rows is None:
        apart, by = (lambda x: numeric.offsets(at(x))), numeric.offset_slopes
    else:
        apart, by = (lambda x: numeric.gaps(at(x), None)[0][rows]), lambda q: numeric.gap_slopes(q)[rows]
    slopes = lambda x: by(at(x))[:, first:][:, own]  # noqa: E731
    found = _corrected(apart, slopes, q[movable])
    if found is not None:
        return at(found)
    found = q[movable]
    if hasty:
        found = least_squares(apart, found, slopes, **COARSE).x
        if np.max(np.abs(apart(found))) > FAR:
            return at(found)
    return at(least_squares(apart, found, slopes, **TOLERANCES).x)


def _corrected(apart: Function, slopes: Function, x: np.ndarray) -> np.ndarray | None:
    """Where the least corrections of Newton's method end; None where they do not close the loops, or only far away.

    They leave alone what the loops leave free; a search by least squares wanders there.
    """
    for _ in range(CORRECTIONS):
        gaps = apart(x)
        if np.max(np.abs(gaps)) < 0.1 * CLOSED:
            return x
        step = np.linalg.lstsq(slopes(x), gaps, rcond=LEAST)[0]
        if np.max(np.abs(step)) > NEAR:
            return None
        x = x - step
    return None


def extent(numeric: Numeric, q: Numbers) -> float:
    """The size of a robot in a posture, m: of the box around the frames of its links and their tips; 1 where all of
    them are in one place."""
    places = np.vstack([numeric.link_pose(q)[1], numeric.tip_poses(q)[1]])
    return float(np.max(np.ptp(places, axis=0))) or 1.0


def moving(numeric: Numeric, q: np.ndarray, v: Numbers) -> np.ndarray:
    """The rates nearest to `v` (nvz,) that keep the loops closed at `q`; internal states are left as they are."""
    v = np.array(v, float)
    if numeric.chain.closing.rows:
        v[: numeric.chain.nv] -= np.linalg.lstsq(jacobian(numeric, q), numeric.gaps(q, v)[1], rcond=1e-10)[0]
    return v


def modes(chain: Chain) -> np.ndarray:
    """Which coordinates are modes."""
    return np.arange(chain.nq) >= chain.eta_q
