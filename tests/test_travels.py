"""What every kind of transmission states: slopes that are those of its travel, and names, units and text."""

import numpy as np
import pytest
from four_bar_robots import LINKAGE

from screwgen.algorithms.travels import relation
from screwgen.elements import ADDED, TRAVELS
from screwgen.ir.replay import run
from screwgen.spec.fields import FIELDS

NUMBERS = {"cylinder": {"crank": 0.4, "base": 1.2, "angle": -1.5}, "four-bar linkage": LINKAGE}


def numbers(kind):
    return [NUMBERS[kind.WORD][name] for name in kind.KEYS]


@pytest.mark.parametrize("kind", TRAVELS, ids=repr)
def test_slopes_are_those_of_the_travel(kind):
    """Central differences of l, and of l', at five coordinates within reach."""
    given, step = numbers(kind), 1e-4
    slopes = lambda q: run(relation(kind), {"q": [q], "given": given}, call, 2.0**-52)[0]["relation"]  # noqa: E731
    for q in (-0.3, -0.1, 0.05, 0.2, 0.35):
        assert kind.reach(*given)[0] < q < kind.reach(*given)[1]
        slope, curve = slopes(q)
        ends = [kind.travel(q + x, *given) for x in (-step, step)]
        assert slope == pytest.approx((ends[1] - ends[0]) / (2 * step), rel=1e-6)
        before, after = (slopes(q + x)[0] for x in (-step, step))
        assert curve == pytest.approx((after - before) / (2 * step), rel=1e-5, abs=1e-6)


def call(op, x):
    return -x if op == "neg" else getattr(np, op)(x)


@pytest.mark.parametrize("kind", TRAVELS, ids=repr)
def test_a_kind_states_what_others_ask(kind):
    for name, key in kind.KEYS.items():
        field = FIELDS[f"joint.drives.transmission.{kind.TABLE}{name}"]
        assert (field.unit, field.description) == (key.unit, key.meaning)
    travel, effort = kind.LETTERS
    assert {travel, effort} <= {symbol for symbol, *_ in kind.SYMBOLS} and f"${travel}" in kind.EQUATIONS
    assert (kind.EFFORT_UNIT, kind.ADDED.unit) in {("N", "m"), ("N·m", "rad")}
    assert kind.ADDED in ADDED


def test_added_coordinates_have_names_of_their_own():
    assert len({one.name for one in ADDED}) == len(ADDED) == len({one.title for one in ADDED})
