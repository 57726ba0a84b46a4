"""Rows of features such that every pair that can stand together does so in one: a covering array of strength 2."""

from __future__ import annotations

import random
from collections.abc import Callable, Collection
from functools import cache

import covertable

from conformance.features import (
    FACTOR_OF,
    FACTORS,
    FEATURES,
    LATER,
    LATER_PAIRS,
    LATEST,
    NEEDS,
    Row,
    conditions,
    features,
    pairs,
    possible,
    possible_pairs,
    usual,
)

SALT = "17"
"""What the order of the search is drawn from: of twenty that were tried, that with the fewest rows."""

TURNED = 4
"""The level with which the rows of `beside` begin: of six that were tried, the first with regular states of all."""


@cache
def covering() -> tuple[Row, ...]:
    """Rows that hold all pairs of levels that can stand together."""
    levels = {factor: [x for x in own if x not in LATER | LATEST] for factor, own in FACTORS.items()}
    first = tuple(covertable.make(levels, strength=2, constraints=conditions(), salt=SALT))
    before = (*first, *later(first, LATER, set(LATEST)), *beside())
    return (*before, *later(before, LATEST))


def later(before: tuple[Row, ...], new: dict[str, str], newer: Collection[str] = ()) -> tuple[Row, ...]:
    """Rows for new levels: beside all others but newer ones, pair after pair as they fit; then each alone."""
    held = set().union(*(pairs(features(row)) for row in before), map(frozenset, LATER_PAIRS))
    plain = {name: next(iter(own)) for name, own in FACTORS.items()}
    out = [plain | row for row in packed({x for x in possible_pairs() - held if x.isdisjoint(newer)}, usual)]
    return (*out, *({**plain, factor: level} for level, factor in new.items()))


def beside() -> tuple[Row, ...]:
    """Rows for the pairs of `LATER_PAIRS`; of the other factors they have one level after the other."""
    out = []
    for number, row in enumerate(packed(set(map(frozenset, LATER_PAIRS)), possible)):
        for k, factor in enumerate(FACTORS):
            own = [x for x in FACTORS[factor] if x not in LATEST]
            turned = (own[(number + k + n + TURNED) % len(own)] for n in range(len(own)))
            row.setdefault(factor, next(x for x in turned if possible(row | {factor: x})))
        out.append({factor: row[factor] for factor in FACTORS})
    return tuple(out)


def packed(wanted: set[frozenset[str]], fits: Callable[[Row], bool]) -> list[dict[str, str]]:
    """Rows of some factors that hold these pairs, pair after pair as they fit."""
    left, out = sorted(wanted, key=sorted), list[dict[str, str]]()
    while left:
        row: dict[str, str] = {}
        for pair in left:
            more = {FACTOR_OF[x]: x for x in pair}
            if all(row.get(factor, x) == x for factor, x in more.items()) and fits(row | more):
                row |= more
        for level, needed in NEEDS.items():
            if level in row.values():
                row.setdefault(FACTOR_OF[needed[0]], needed[0])
        out.append(row)
        left = [pair for pair in left if not pair <= set(row.values())]
    return out


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
        out += [row] if usual(row) else []
    return tuple(out)
