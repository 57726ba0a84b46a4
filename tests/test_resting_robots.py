"""A short slice of the sweep over random robots at rest; the rest of it: `python tests/resting_robots.py 0 500`."""

import pytest
import resting_robots as rr
from conftest import swept

PULLED = 2001
"""Held joints, a tendon and two springs between frames."""


@pytest.mark.parametrize("seed", [*swept(range(1, 10), 1, 9), PULLED])
def test_random_robots_rest_where_their_energy_is_lowest(seed):
    said, text, _ = rr.outcome(seed)
    assert said == "found", text


def test_a_link_that_all_but_balances_about_an_axis_comes_to_rest():
    """Its stiffness along a roll is 3e-6 of the others, and steps of a fixed share did not reach the bottom."""
    said, text, lower = rr.outcome(55)
    assert said == "found" and lower < 1e-9, text


def test_what_falls_for_ever_is_refused():
    """A slide without a spring, along which gravity pulls."""
    said, text, _ = rr.outcome(150)
    assert said == "refused" and "link_0.slide[0]: no posture found balances its load" in text
