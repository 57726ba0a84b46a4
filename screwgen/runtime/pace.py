"""Long computations in parts, so that they can report, store and be interrupted in between."""

import time
from collections.abc import Iterator

SLICE = 0.05
"""The approximate duration of one part in seconds."""

FIRST, GROWTH = 256, 4
"""The number of steps of the first part, and the largest factor from one part to the next."""


def slices(count: int, first: int = FIRST) -> Iterator[tuple[int, int]]:
    """`count` steps in parts that take about a slice of time each: pairs of the first step and how many."""
    k, part = 0, first
    while count - k > part:
        clock = time.perf_counter()
        yield k, part
        k += part
        spent = time.perf_counter() - clock
        part = max(1, min(GROWTH * part, int(part * SLICE / max(spent, 1e-9))))
    if k < count:
        yield k, count - k
