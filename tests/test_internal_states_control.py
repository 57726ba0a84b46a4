"""Predictive control of robots with internal states: an arm that sticks, and a controller that knows that or not."""

from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from false_samples import LOAD, rubbing, turning
from helpers import QUICK, arm, model_of

import screwgen
from screwgen import UsageError
from screwgen.elements import AxisElement, Bristle, Key, key
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.studies.predictive import fitted

CONTROL = """
[horizon]
intervals = 8
step = 0.02
substeps = 4
[goal]
joints = [-0.4, 0.6]
[cost]
joints = 100.0
joint_rates = 20.0
torques = 1e-4
terminal = { riccati = true }
[bounds]
torques = [60.0, 30.0]
joint_rates = 2.0
"""
VISCOUS = {"drives": [{"friction": {"viscous": 0.2}}]}


def two_links(*joints):
    upper, fore = joints
    return model_of(arm(turning("up", 0.6, 0.2, joint=upper), turning("fore", 0.5, 0.1, joint=fore, bodies=LOAD)))


@cache
def model(knows: bool):
    """With friction that sticks at 6 N·m and 3 N·m, or with its viscous part alone."""
    return two_links(rubbing(4.0), rubbing(2.0)) if knows else two_links(VISCOUS, VISCOUS)


@pytest.fixture(params=[True, False])
def control(request, tmp_path):
    """Whether a controller knows of dry friction, and it."""
    (tmp_path / "mpc.toml").write_text(CONTROL)
    return request.param, model(request.param).mpc(tmp_path / "mpc.toml", flags=QUICK, projection=np.eye(2))


def test_an_arm_that_sticks_is_brought_to_its_goal(control):
    """Within 4 mrad; without bristles in its model the controller leaves tenths of a radian."""
    knows, controller = control
    run = screwgen.simulate(model(True), 3.0, 1e-3, controller=controller)
    off = np.abs(run.q[run.t > 2.5] - [-0.4, 0.6])
    assert off.max() < 4e-3 if knows else off.max(axis=0).min() > 0.1
    assert np.all(np.abs(run.tau) <= [60.0, 30.0]) and controller.refused == 0


def test_a_slow_motion_does_not_stick_and_slip(control):
    """At 50 mrad/s, where friction falls with the rate."""
    (knows, controller), rates = control, np.array([-0.05, 0.05])

    def law(t, q, v):
        for k, stage in enumerate(controller.reference, 1):
            stage["q"][:], stage["v"][:2] = rates * (t + 0.02 * k), rates
        return controller(t, q, v)

    run = screwgen.simulate(model(True), 2.5, 1e-3, controller=law)
    late = run.t > 1.0
    off, slow = np.abs(run.q[late] - np.outer(run.t[late], rates)), np.abs(run.v[late, :2]) < 5e-3
    assert (off.max() < 1e-3 and not slow.any()) if knows else (off.max() > 0.1 and slow.mean(axis=0).max() > 0.5)


def test_a_filter_knows_how_far_bristles_are_bent(tmp_path):
    """From encoders alone, of 10 µrad; the torques are those of the filter's state."""
    (tmp_path / "mpc.toml").write_text(CONTROL)
    arm, rng = model(True), np.random.default_rng(0)
    controller, step = arm.mpc(tmp_path / "mpc.toml", flags=QUICK), arm.compile(flags=QUICK).step
    e, q, v, still = CompiledEstimator(arm, measurements=["encoder"], flags=QUICK), np.zeros(2), np.zeros(4), []
    e.start(q, v, 1e-4, [1e-2, 1e-2, 1e-5, 1e-5], Noise([1.0, 1.0, 1e-10, 1e-10], encoder=1e-5))
    for k in range(2500):
        inputs = controller(k * 1e-3, *e.state), np.zeros((2, 6))
        q, v = step(q, v, *inputs, 1e-3, "modal_midpoint")
        e.predict(*inputs, 1e-3)
        e.update(*inputs, encoder=q + 1e-5 * rng.normal(size=2))
        still += [np.abs(q - [-0.4, 0.6]).max()]
    assert max(still[-300:]) < 0.01


def test_the_cost_to_go_is_that_of_the_arm_that_slips(tmp_path):
    """With viscous friction alone; what bristles are bent by costs nothing."""
    (tmp_path / "mpc.toml").write_text(CONTROL)
    found, other = (fitted(model(knows), tmp_path / "mpc.toml") for knows in (True, False))
    assert np.array_equal(found.terminal[:4, :4], other.terminal) and not found.terminal[4:].any()


@dataclass(frozen=True)
class Remembering(AxisElement):
    """A force of a state that decays as fast as the axis moves, or at no rate."""

    KIND, WORDS, FORMULA, RATE = "remembering", "a force of a state", "c z", "\\dot{q} - s z"
    state = Key("rad", "m", "a state", "z")
    fading: float = key("1/rad", "1/m", "decay per travel", "s", sign="non-negative")

    @staticmethod
    def bristle(t, x, w, z, fading):
        return Bristle(100.0, 0.0, 1.0, fading * (w * (t.call("on", w) - t.call("on", -w))))


@pytest.mark.parametrize(("element", "expected"), [(Remembering(50.0), 0.04), (Remembering(0.0), 1e10)])
def test_how_far_internal_states_may_be_from_where_they_are_expected(tmp_path, element, expected):
    """Of bristles from F_s / σ on one side to the other; as far as they like where they never decay."""
    (tmp_path / "mpc.toml").write_text(CONTROL)
    found = fitted(two_links({"elements": element}, rubbing(2.0)), tmp_path / "mpc.toml")
    assert found.scatter[4:] == pytest.approx([expected, 2 * 3.0 / 4e3])
    assert found.scatter[:4] == pytest.approx([2e-3, 2e-3, 0.1, 0.1])


def test_internal_states_belong_to_a_measured_state(tmp_path):
    """They may be left out at the start alone; those of a plant with others have no meaning."""
    (tmp_path / "mpc.toml").write_text(CONTROL)
    controller = model(True).mpc(tmp_path / "mpc.toml", flags=QUICK)
    controller.initialise(np.zeros(2), np.zeros(2))
    assert controller.states.shape == (9, 6)
    with pytest.raises(UsageError, match="v"):
        controller.feedback(np.zeros(2), np.zeros(2))
    with pytest.raises(UsageError, match="1 internal states and the controller's model 2"):
        controller(0.0, np.zeros(2), np.zeros(3))
    controller(0.0, np.zeros(2), np.zeros(2))
