"""A sensor that the product does not contain, whose angle begins again after a whole turn: the roll of a tip."""

import numpy as np
import pytest
from helpers import QUICK, arm, link, model_of, relative

from screwgen import ScrewgenError, UsageError
from screwgen.algorithms.measurement import CyclicAngle, atan2
from screwgen.identification.signals import signal
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.estimator import Estimator
from screwgen.spec.columns import Column

ABOUT = "turn of the last tip about its own x, from where its y is level"


def rolled(f, q):
    """From -pi to pi."""
    R, _ = f.poses(q)[1][f.chain.last]
    down = [sum(R[3 * i + k] * f.gravity[i] for i in range(3)) for k in range(3)]
    return [atan2(-down[1], -down[2])]


ROLL = CyclicAngle("roll", "q", rolled, lambda chain: ["about x"], "rad", ABOUT)
TAU, W_EXT = np.zeros(2), np.zeros((2, 6))


def model(gravity=-9.81):
    return model_of(arm(link("upper", 0.5, "y"), link("fore", 0.5, "x"), gravity=(0.0, 0.0, gravity), sensors=(ROLL,)))


def filters(of, turn):
    made = CompiledEstimator(of, measurements=["roll"], flags=QUICK), Estimator(of, measurements=["roll"])
    for e in made:
        e.start([0.0, turn], [0.0, 0.0], 0.1, 0.1, Noise(1e-3, roll=1e-4))
    return made


@pytest.mark.parametrize("turn", [3.12, -3.12, 0.4])
def test_an_angle_is_compared_without_whole_turns(turn):
    """Beside half a turn what is told has the other sign, and the tip turns by the short way."""
    short = np.sign(turn) * 0.05
    told = np.remainder(turn + short + np.pi, 2 * np.pi) - np.pi
    both = filters(model(), turn)
    for e in both:
        e.update(TAU, W_EXT, roll=[told])
        assert e.innovations["roll"].value == pytest.approx([short], rel=1e-9)
        assert e.state[0][1] == pytest.approx(turn + short, abs=1e-4)
    assert relative(*(np.concatenate(e.state) for e in both)) < 1e-12


def test_where_gravity_has_no_direction_updates_say_so():
    """The angle of the origin is 0, without a derivative: an error, and the estimate stays."""
    for e in filters(model(0.0), 0.4):
        before = e.state, e.covariance
        with pytest.raises(ScrewgenError):
            e.update(TAU, W_EXT, roll=[0.1])
        assert np.array_equal(e.state, before[0]) and np.array_equal(e.covariance, before[1])


def test_what_does_not_know_it_says_so():
    with pytest.raises(UsageError, match="roll: an angle of whole turns has no scale; leave 'calibrated' out"):
        Estimator(model(), measurements=["roll calibrated"])
    with pytest.raises(UsageError, match="box: roll begins again after a whole turn, which is not compared yet; leave"):
        signal(model(), Column(name="box", measures="roll"))
