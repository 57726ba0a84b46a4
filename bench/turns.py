"""Contenders measured in turns: each round runs all of them, and the best round of each counts."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from table import Row, spread

ROUNDS, LEAST = 25, 4e-3
"""Rounds, and the processor seconds that a contender's part of one takes at least."""


def rows_of(
    heading: str, sides: Mapping[str, Callable[[int], float]], calls: int = 0, rounds: int = ROUNDS
) -> list[Row]:
    """A row for each side: the best seconds of a call, and their ratio to those of the first side.

    A side runs so many calls and returns the processor seconds that they took. ``calls``: that many in each round; by
    default as many as take LEAST.
    """
    counts = {title: calls or _calls(side) for title, side in sides.items()}
    times: dict[str, list[float]] = {title: [] for title in sides}
    for _ in range(rounds):
        for title, side in sides.items():
            times[title].append(side(counts[title]) / counts[title])
    first = min(next(iter(times.values())))
    return [Row(heading, title, min(found), min(found) / first, spread(found)) for title, found in times.items()]


def _calls(side: Callable[[int], float]) -> int:
    """How many calls take LEAST."""
    calls = 1
    while (seconds := side(calls)) < LEAST:
        if seconds < 0:
            raise SystemExit("peers: a contender has no dynamics at the state where it is measured")
        calls = max(2 * calls, math.ceil(calls * LEAST / max(seconds, 1e-6)) if seconds > 1e-4 else 10 * calls)
    return calls
