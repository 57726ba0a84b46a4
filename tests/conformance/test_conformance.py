"""Every feature in every check, and every pair of features in every check: see `features`, `checks`, `refusals`."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import swept
from helpers import model_of
from pydantic import ValidationError

from conformance.arms import LOOPS, arm_of
from conformance.arrays import covering, few, random_rows
from conformance.cases import case_of
from conformance.checks import CHECKS, outcome
from conformance.features import FACTOR_OF, FACTORS, FEATURES, IMPOSSIBLE, features, pairs, possible, possible_pairs
from conformance.forgotten import drawn
from conformance.refusals import REFUSALS
from conformance.table import page

ROWS = covering()
SHORT = [ROWS.index(row) for row in few()]
DRAWN = random_rows(48)
LONG = (
    *("JAX, gradients", "mock-up unit", "C folder", "commands", "derivatives by parameters", "estimator of parameters"),
    *("C, float", "lanes, float", "plan", "predictive control", "JAX"),
    *("C, baked", "identification", "DAE runs", "URDF"),
)
"""Checks that try each feature, but not each pair: they take long, compile a text again in another form, or put
together what checks of all pairs try: JAX CasADi's programs, runs of the DAE form its steps, identification slopes."""
QUICK = tuple(name for name in CHECKS if name not in LONG)
SOME = ("judge", "DAE form", "CasADi", "C, fused", "derivatives of steps", "document")
OTHERS = [(k, name) for k in range(len(ROWS)) for name in QUICK if k not in SHORT]


def of(row, seed, drawn=False):
    return case_of(tuple(row.items()), seed, drawn)


@pytest.mark.parametrize("row, check", [(k, name) for k in SHORT for name in QUICK])
def test_every_feature_meets_every_check(row, check):
    outcome(check, of(ROWS[row], row))


@pytest.mark.parametrize("row, check", [(k, name) for k in SHORT for name in LONG])
def test_every_feature_meets_every_long_check(row, check):
    outcome(check, of(ROWS[row], row))


@pytest.mark.parametrize("row, check", OTHERS)
def test_every_pair_of_features_meets_every_check(row, check):
    outcome(check, of(ROWS[row], row))


@pytest.mark.parametrize("check", [*SOME, pytest.param("commands", marks=pytest.mark.long)])
@pytest.mark.parametrize("row", swept(range(len(DRAWN)), *range(6)))
def test_random_features_and_numbers(check, row):
    outcome(check, of(DRAWN[row], 1000 + row, drawn=True))


def test_all_pairs_that_can_stand_together_stand_in_a_row():
    assert all(possible(row) for row in ROWS)
    held = set().union(*(pairs(features(row)) for row in ROWS))
    assert possible_pairs() <= held
    assert set(FEATURES) == {name for row in few() for name in features(row)}


@pytest.mark.parametrize("pair", IMPOSSIBLE, ids=" and ".join)
def test_what_cannot_stand_together_is_refused(pair):
    """In one line."""
    row = {factor: next(iter(levels)) for factor, levels in FACTORS.items()} | {FACTOR_OF[x]: x for x in pair}
    if row["base"] == "afloat" and FACTOR_OF[pair[1]] == "turn":
        return  # the joint of a base that floats is left out: there is no file that states both
    robot = arm_of(row)
    if row["closing"] in LOOPS:
        robot["loops"] = [{"between": ["fore.tip", "post.tip"], "joint": {"axes": LOOPS[row["closing"]]}}]
    with pytest.raises(ValidationError) as caught:
        model_of(robot)
    assert len(caught.value.errors()[0]["msg"].splitlines()) == 1


def test_every_refusal_stands_in_a_row():
    for refusal in REFUSALS:
        assert any(set(refusal.features) <= set(features(row)) for row in ROWS), refusal


def test_every_mutant_of_forgetting_finds_its_place():
    """A table that the product has outgrown tries nothing; `mutants` says whether each is noticed."""
    for mutant in drawn():
        text = (Path(__file__).parents[2] / mutant.file).read_text(encoding="utf-8")
        assert mutant.applied(text) != text


def test_the_page_of_features_is_made_from_the_tables():
    found = (Path(__file__).parents[2] / "docs" / "features.md").read_text(encoding="utf-8")
    assert found == page(found), "run `make generated`"
