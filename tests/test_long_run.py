"""Bounded energy and joints that hold in 200,000 steps of 1 ms, a million in `make test-long`; rest that stays.

`make long-run` takes ten million.
"""

import numpy as np
import pytest
from long_run import run

every_length = pytest.mark.parametrize("steps", [200_000, pytest.param(10**6, marks=pytest.mark.long)])


@every_length
@pytest.mark.parametrize("name", ["free swing", "free swing, DAE form"])
def test_the_free_swing_stays_bounded(name, steps):
    """The step conserves no energy exactly; none enters or leaves that a swing could show."""
    drift = run(name, steps)
    assert drift.gained < 2e-4
    assert drift.lost < 2e-4
    assert drift.violation < 1e-13
    assert drift.moved > 1


@pytest.mark.parametrize(
    ("name", "allowed", "steps"),
    [
        ("damped", 1e-15, 600_000),
        ("damped, float", 1e-6, 200_000),
        pytest.param("damped", 1e-15, 10**6, marks=pytest.mark.long),
        pytest.param("damped, float", 1e-6, 10**6, marks=pytest.mark.long),
    ],
)
def test_a_damped_arm_comes_to_rest_and_stays(name, allowed, steps):
    """Hanging down, all of the swing's energy gone; then nothing moves for half of the steps."""
    drift = run(name, steps)
    assert drift.moved <= allowed
    assert drift.lost == pytest.approx(1, abs=1e-3)
    q_y, q_z, elbow = drift.posture[:3]
    assert [np.cos(q_y), np.sin(q_z), np.sin(elbow)] == pytest.approx([0, 0, 0], abs=1e-5)
