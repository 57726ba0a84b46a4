"""The order of a time step, from its coefficients.

A step is a Nyström method for two kinds of accelerations: those that are evaluated at the predicted state of a stage,
and elastic ones, linear in the state, which may be implicit. Its order is p where the Taylor series of step and
solution agree up to h^p; the terms of both series belong to rooted trees. A node of a tree is an acceleration,
differentiated once for every branch: by time through the coordinates, or by an acceleration that acts through the
coordinates or through the rates.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cache
from math import prod
from typing import NamedTuple

Row = tuple[Fraction, ...]

TOLERANCE = 1e-12
"""Coefficients that are irrational come as doubles."""


class StageState(NamedTuple):
    """A state after the step's start: q + reach h v + h² Σ coordinates_j k_j and v + h Σ rates_j k_j."""

    reach: Fraction
    coordinates: Row
    rates: Row


class Branch(NamedTuple):
    """A branch of a tree: `through` the "time", the "coordinates" or the "rates", at the end of which is a tree."""

    through: str
    tree: RootedTree | None


class RootedTree(NamedTuple):
    """An acceleration and its branches."""

    elastic: bool
    branches: tuple[Branch, ...]


def unmet(order: int, stages: Sequence[StageState], elastic: Sequence[StageState], end: StageState) -> int | None:
    """The lowest power of h at which a step that should have an order differs from the solution; None if it has it.

    `stages`: where the accelerations of each stage are evaluated; `elastic`: where their elastic parts are.
    """
    for power in range(1, order + 1):
        for tree in _trees(power - 1):
            weights, exact = _weights(tree, stages, elastic), _exact(tree)
            if _differ(end.rates, weights, exact / power):
                return power
        for tree in _trees(power - 2):
            weights, exact = _weights(tree, stages, elastic), _exact(tree)
            if _differ(end.coordinates, weights, exact / (power * (power - 1))):
                return power
    return None


def _differ(row: Row, weights: Sequence[Fraction], exact: Fraction) -> bool:
    return abs(_product(row, weights) - exact) > TOLERANCE


def _product(row: Row, weights: Sequence[Fraction]) -> Fraction:
    return sum((a * b for a, b in zip(row, weights, strict=True)), Fraction(0))


@cache
def _trees(order: int) -> tuple[RootedTree, ...]:
    """The trees whose acceleration belongs to h to the `order`."""
    if order <= 0:
        return (RootedTree(False, ()),) if order == 0 else ()
    several = tuple(RootedTree(False, branches) for branches in _branches(order, order))
    return several + tuple(RootedTree(True, (branch,)) for branch in _single(order))


def _branches(order: int, largest: int) -> Iterator[tuple[Branch, ...]]:
    """All sets of branches of an order, none of them of a larger one than the one before."""
    if order == 0:
        yield ()
    for size in range(min(order, largest), 0, -1):
        for first in _single(size):
            for rest in _branches(order - size, size):
                if not rest or _order(rest[0]) < size or first <= rest[0]:
                    yield (first, *rest)


def _single(order: int) -> list[Branch]:
    """The branches of an order."""
    time = [Branch("time", None)] if order == 1 else []
    through = (("coordinates", order - 2), ("rates", order - 1))
    return time + [Branch(way, tree) for way, rest in through for tree in _trees(rest)]


def _order(branch: Branch) -> int:
    if branch.tree is None:
        return 1
    return {"coordinates": 2, "rates": 1}[branch.through] + sum(map(_order, branch.tree.branches))


def _weights(tree: RootedTree, stages: Sequence[StageState], elastic: Sequence[StageState]) -> list[Fraction]:
    """What the tree contributes to the acceleration of every stage."""
    places, inner = elastic if tree.elastic else stages, []
    for branch in tree.branches:
        if branch.tree is None:
            inner.append([place.reach for place in places])
        else:
            weights = _weights(branch.tree, stages, elastic)
            inner.append([_product(getattr(place, branch.through), weights) for place in places])
    return [prod((w[i] for w in inner), start=Fraction(1)) for i in range(len(places))]


def _exact(tree: RootedTree) -> Fraction:
    """What it contributes to the solution's, over h to its order."""
    out = Fraction(1)
    for branch in tree.branches:
        if branch.tree is not None:
            n = _order(branch)
            out *= _exact(branch.tree) / (n if branch.through == "rates" else n * (n - 1))
    return out
