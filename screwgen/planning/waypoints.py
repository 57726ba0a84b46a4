"""Joint coordinates that a motion goes through, and when."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..arguments import array
from ..errors import UsageError
from ..spec.plan import SHORTEST


class Waypoint(NamedTuple):
    """Joint coordinates (n_joints,) at a share of the time."""

    share: float
    joints: np.ndarray


def waypoints(
    given: Sequence[Mapping[str, Any]], start: np.ndarray, goal: np.ndarray, time: float | str
) -> tuple[Waypoint, ...]:
    """Waypoints of tables of `q`, and `t` where the time is stated; raises UsageError.

    Those without a time share that between their neighbours by the lengths of the ways.
    """
    joints, shares = [start], [0.0]
    for i, point in enumerate(given):
        at = f"through[{i}]:"
        if not (isinstance(point, Mapping) and "q" in point and set(point) <= {"q", "t"}):
            raise UsageError(f"{at} must be a table of q, and t where the time is stated, as {{ q = [0.3], t = 0.5 }}")
        joints.append(array(point["q"], f"{at} q:", start.shape))
        if point.get("t") is None:
            shares.append(np.nan)
            continue
        if time == SHORTEST:
            raise UsageError(f"{at} t: is given, and the time is 'shortest'; leave it out, or state the time")
        shares.append(array(point["t"], f"{at} t:", ()).item() / float(time))
    ways = np.cumsum([np.linalg.norm(step) for step in np.diff([*joints, goal], axis=0)])
    known = [0, *(i for i in range(1, len(shares)) if np.isfinite(shares[i])), len(shares)]
    along, when = np.append(0.0, ways), np.append(shares, 1.0)
    when = np.interp(along, along[known], when[known])
    late = np.flatnonzero(~(np.diff(when) > 0))
    if len(given) and late.size:
        i = min(int(late[0]), len(given) - 1)
        raise UsageError(f"through[{i}]: t must be later than the one before it, before the end, and q another place")
    return tuple(Waypoint(float(s), q) for s, q in zip(when[1:-1], joints[1:], strict=True))
