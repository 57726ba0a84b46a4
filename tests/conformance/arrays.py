"""Rows of features such that every pair that can stand together does so in one: a covering array of strength 2."""

from __future__ import annotations

import random
from functools import cache

import covertable

from conformance.features import APART, FACTOR_OF, FACTORS, FEATURES, LATER, Row, conditions, features, possible


@cache
def covering() -> tuple[Row, ...]:
    """Rows that hold all pairs of levels that can stand together."""
    levels = {factor: [x for x in levels if x not in LATER] for factor, levels in FACTORS.items()}
    plain = {factor: own[0] for factor, own in levels.items()}
    apart = ({**plain, **more, **{FACTOR_OF[x]: x for x in pair}} for pair, more in APART.items())
    first = (*covertable.make(levels, strength=2, constraints=conditions()), *apart)
    return (*first, *(row for level, factor in LATER.items() for row in beside(level, factor)))


def beside(level: str, factor: str) -> list[Row]:
    """Rows that hold a level beside all others that it can stand with, by factor one after the other; then it alone."""
    later = list(LATER)[list(LATER).index(level) :]
    others = {name: [x for x in own if x not in later] for name, own in FACTORS.items() if name != factor}
    plain, out = {name: own[0] for name, own in others.items()} | {factor: level}, []
    left = {(name, x) for name, own in others.items() for x in own[1:] if possible({factor: level, name: x})}
    while left:
        row, held = dict(plain), len(left)
        for name, x in sorted(left):
            if row[name] == plain[name] and possible({**row, name: x}):
                row[name] = x
        left -= set(row.items())
        assert len(left) < held, f"beside {level}: no row for {left}"
        out.append({name: row[name] for name in FACTORS})
    return [*out, {name: plain[name] for name in FACTORS}]


@cache
def few() -> tuple[Row, ...]:
    """Some of these rows, chosen one after the other until every feature stands in one."""
    left, out = set(FEATURES), []
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
