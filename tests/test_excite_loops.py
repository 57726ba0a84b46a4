"""Motions that excite robots with loops: some joints lead, the others follow; limits of all of them are kept."""

import numpy as np
import pytest
from identified_arms import fits_of
from test_identify_loops import COLUMNS, START, TRUE, elsewhere, four_bar

import screwgen
from screwgen.errors import UsageError
from screwgen.simulation.played import Played

LIMITS = {"lower": [-1.2, -3.0, -3.2], "upper": [0.3, 1.5, 0.0], "rates": [3.0, 2.0, 3.0], "efforts": [20.0] * 3}
LAW = screwgen.PD((30.0, 0.0, 0.0), (3.0, 0.0, 0.0), (0.0, 0.0, 0.0))
FREE, SECONDS, STEP, FITS = list(TRUE), 2.0, 1e-3, 3


def excited(generations=12, **stated):
    given = {"free": FREE, "sensors": COLUMNS, "limits": LIMITS, "start": START, "time": SECONDS, "gains": LAW} | stated
    return screwgen.excite(four_bar(), bandwidth=5.0, window=0.5, generations=generations, **given)


@pytest.fixture(scope="module")
def found():
    return excited()


def test_the_run_keeps_the_limits_of_all_joints_and_one_that_follows_uses_its_own(found):
    run = found.run
    assert (LIMITS["lower"] <= run.q[:, :3].min(axis=0)).all() and (run.q[:, :3].max(axis=0) <= LIMITS["upper"]).all()
    shares = np.abs(run.v[:, :3]).max(axis=0) / LIMITS["rates"]
    assert 0.7 < shares[1] == shares.max() <= 1.0
    assert np.abs(run.tau[:, 1:]).max() == 0.0 and np.abs(run.tau[:, 0]).max() <= 20.0
    assert np.max(np.abs(four_bar().numpy().gaps(run.q[-1], run.v[-1])[0])) < 1e-6


def test_references_of_joints_that_follow_close_the_loops(found):
    """The run under its law follows them."""
    plan, run = found.plan, found.run
    assert np.abs(plan.q - run.q[:, :3]).max() < 2e-3
    assert np.abs(np.gradient(plan.q, plan.t, axis=0) - plan.v)[1:-1].max() < 1e-2
    assert np.abs(plan.q[-1] - plan.q[0]).max() < 2e-3


def test_intervals_are_narrower_than_by_a_random_motion_and_errors_of_fits_as_large_as_they_say(found):
    own, other = (
        fits_of(found, plan, four_bar(), elsewhere(), TRUE, FITS).error for plan in (found.plan, found.random)
    )
    assert found.narrower > 1.5
    for got, said in ((own, found.deviation), (other, found.deviation_of_random)):
        assert 0.5 < np.sqrt(np.mean((got / said) ** 2)) < 1.7


def test_what_does_not_fit_gets_a_line():
    with pytest.raises(UsageError, match="gains: there are none found for robots with loops"):
        excited(gains=None)
    plan = excited(0, time=1.0).plan
    with pytest.raises(UsageError, match="has loops, for which there is no rest of a plan; state q0"):
        screwgen.simulate(four_bar(), 0.1, STEP, controller=Played.of(plan))
    with pytest.raises(UsageError, match=r"start: \[.*\] is not within the joints' limits"):
        excited(limits=LIMITS | {"upper": [0.3, -0.2, 0.0]})
