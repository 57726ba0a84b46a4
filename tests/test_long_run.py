"""A million steps of 1 ms: bounded energy, joints that hold, rest that stays. `make long-run` takes ten million."""

import numpy as np
import pytest
from long_run import run

STEPS = 10**6


@pytest.mark.parametrize("name", ["free swing", "free swing, DAE form"])
def test_the_free_swing_stays_bounded(name):
    """The step is not symplectic, so energy may leave; that it never enters by a tenth is what stability means here.

    Where the motion goes is chaotic and depends on rounding; how much has left after a million steps does not by much.
    """
    drift = run(name, STEPS)
    assert drift.gained < 0.1
    assert drift.lost < 0.5
    assert drift.violation < 1e-13
    assert drift.moved > 1


@pytest.mark.parametrize(("name", "allowed"), [("damped", 1e-15), ("damped, float", 1e-6)])
def test_a_damped_arm_comes_to_rest_and_stays(name, allowed):
    """Hanging down, all of the swing's energy gone; then nothing moves for half a million steps."""
    drift = run(name, STEPS)
    assert drift.moved <= allowed
    assert drift.lost == pytest.approx(1, abs=1e-3)
    q_y, q_z, elbow = drift.posture[:3]
    assert [np.cos(q_y), np.sin(q_z), np.sin(elbow)] == pytest.approx([0, 0, 0], abs=1e-5)
