"""Rows of features such that every pair that can stand together does so in one: a covering array of strength 2.

The rows stand in `rows.txt`, a robot a line, so that those that are there stay as they are when a feature comes:
`python tests/conformance/arrays.py` adds rows that hold its pairs. With `--anew` all are chosen again: fewer rows
where many features came one after the other.
"""

from __future__ import annotations

import random
import sys
from functools import cache
from pathlib import Path

if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).parents[1])  # in place of this file's folder, whose modules have names of others

from conformance.features import FACTOR_OF, FACTORS, FEATURES, Row, conditions, features, possible

PLACE = Path(__file__).with_name("rows.txt")
LIGHT = (7, 10, 15, 16, 17, 21, 23, 26, 35, 46, 49, 60, 77)
"""Rows in which every feature stood when they were chosen, and 615 pairs of features.

Of rows with as many they are those whose checks take least. Nine rows that were chosen one after the other, each for
how many features it adds, have 589 pairs and take longer, half of it two robots with the most code of all. The limits
of row 60 bear on slopes of units, which larger robots do not have; row 77 has an accelerated base. With `--anew` these
are to be chosen again."""
SALTS = 12
"""The orders of the search that are tried; that with the fewest rows is taken."""


@cache
def covering() -> tuple[Row, ...]:
    """Rows that hold all pairs of levels that can stand together."""
    return tuple(row_of(line) for line in PLACE.read_text(encoding="utf-8").splitlines())


def row_of(line: str) -> Row:
    """The row of a line: its features, separated by commas; other factors are plain."""
    return {factor: next(iter(own)) for factor, own in FACTORS.items()} | {FACTOR_OF[x]: x for x in line.split(", ")}


def chosen(kept: tuple[Row, ...]) -> list[Row]:
    """Rows that hold all pairs, those that are kept first."""
    import covertable

    levels = {factor: list(own) for factor, own in FACTORS.items()}
    found = []
    for salt in map(str, range(SALTS)):
        rows = covertable.make(levels, constraints=conditions(), salt=salt, presets=[dict(row) for row in kept])
        found.append([*kept, *(row for row in rows if row not in kept)])
        print(f"{len(found)} of {SALTS}: {len(found[-1])} rows", flush=True)
    return min(found, key=len)


@cache
def few() -> tuple[Row, ...]:
    """Some of these rows, until every feature stands in one: those of LIGHT, and for features that came later others,
    chosen one after the other."""
    out = [covering()[k] for k in LIGHT]
    left = set(FEATURES) - {name for row in out for name in features(row)}
    while left:
        out.append(max(covering(), key=lambda row: len(left & set(features(row)))))
        left -= set(features(out[-1]))
    return tuple(out)


def random_rows(count: int, seed: int = 0) -> tuple[Row, ...]:
    """Rows at random, for triples that no pair asks for."""
    rng, out = random.Random(seed), []
    while len(out) < count:
        row = {factor: rng.choice(list(levels)) for factor, levels in FACTORS.items()}
        out += [row] if possible(row) else []
    return tuple(out)


if __name__ == "__main__":
    rows = chosen(() if "--anew" in sys.argv else covering())
    lines = [", ".join(features({factor: row[factor] for factor in FACTORS})) for row in rows]
    PLACE.write_text("\n".join(lines) + "\n", encoding="utf-8")
