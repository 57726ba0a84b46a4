"""Which coordinates carry a link and are carried by it, as ranges over which loops in C run."""

from __future__ import annotations

from collections.abc import Sequence

from ...algorithms.linearise import places
from ...topology.chain import Chain
from ...topology.tree import TIP
from .acting import bears


def count_pairs(chain: Chain) -> int:
    """The pairs of coordinates of which one carries the other's link."""
    return sum(width(own(chain, i)) * width(ranges) for i, ranges in enumerate(carrying(chain)))


def width(ranges: Sequence[tuple[int, ...]]) -> int:
    """How many columns some ranges have together."""
    return sum(end - first for first, end, *_ in ranges)


def own(chain: Chain, i: int) -> list[tuple[int, int]]:
    """First and end of the rates of a link: of its joint and of its modes."""
    return [(part.start, part.stop) for part in places(chain, i) if part.start < part.stop]


def carrying(chain: Chain) -> list[list[tuple[int, int, int]]]:
    """The columns of changes of the coordinates that carry each link, sorted, adjacent ones as one.

    First, end, and how far behind the columns of their rates: what a station carries changes with modes otherwise than
    what the tip carries, and so has columns of its own.
    """
    out: list[list[tuple[int, int, int]]] = []
    at = carried(chain)
    for i in range(chain.n):
        parent, station = chain.tree.parents[i], chain.tree.at(i)
        found: list[tuple[int, int, int]] = []
        if parent >= 0:
            joint, modes = places(chain, parent)
            count = modes.stop - modes.start
            first = modes.start if station == TIP else at[parent] + station * count
            its = (joint.start, joint.stop, 0), (first, first + count, first - modes.start)
            found = sorted([*out[parent], *(one for one in its if one[0] < one[1])])
        out.append(_joined(found))
    return out


def carried(chain: Chain) -> list[int]:
    """Where the columns of a link's stations begin, and the end of all columns."""
    out = [chain.nv]
    for i, stations in enumerate(chain.tree.stations or [0] * chain.n):
        out.append(out[-1] + stations * chain.keys[i].modes)
    return out


def behind(chain: Chain) -> list[list[tuple[int, int]]]:
    """The ranges of the rates of the links that each link carries; none of a floating base, which has no wrench."""
    found: list[list[tuple[int, int]]] = [[] for _ in range(chain.n)]
    for i in reversed(range(chain.n)):
        if (parent := chain.tree.parents[i]) >= 0:
            found[parent] += [*found[i], *own(chain, i)]
    joined = [
        _joined([(*one, 0) for one in sorted(own)]) if bears(key) else []
        for key, own in zip(chain.keys, found, strict=True)
    ]
    return [[(first, end) for first, end, _ in own] for own in joined]


def _joined(ranges: Sequence[tuple[int, int, int]]) -> list[tuple[int, int, int]]:
    """The same columns in fewer ranges: of those that are adjacent and as far behind their rates, one."""
    out: list[tuple[int, int, int]] = []
    for first, end, shift in ranges:
        if out and out[-1][1:] == (first, shift):
            out[-1] = (out[-1][0], end, shift)
        else:
            out.append((first, end, shift))
    return out
