"""Plans of robots with inputs besides torques: given motions by closed forms, brakes and tendons by robots without."""

import numpy as np
import pytest
from helpers import arm, link, model_of
from test_tracking import eased

import screwgen
from screwgen import UsageError

SECTION = {"rhoA": 0.6, "EIy": 60.0, "EIz": 60.0}


def boom(modes=2, **more):
    """A rod with a load, which turns about z without gravity."""
    load = [{"at": "tip", "mass": 1.0}]
    own = {"axes": "z", "length": 1.2, "section": SECTION, "modes": {"bending_y": modes}, "bodies": load}
    return model_of(arm(link("boom", **(own | more)), order=2, gravity=[0.0, 0.0, 0.0]))


def moved(**more):
    """The same, whose joint moves as is given."""
    return boom(**({"joint": {"actuation": "motion"}} | more))


def test_of_a_given_motion_the_acceleration_is_planned():
    model = moved()
    law = screwgen.PD((20.0,), (8.0,), (0.0,))
    for fast in (False, True):
        plan = screwgen.plan(model, [0.0], [1.0], 1.2, gains=law, fast=fast)
        assert np.abs(plan.tau - plan.vdot).max() < 1e-6 * np.abs(plan.tau).max()
        arrived = screwgen.play(model, plan)
        assert arrived.residual < 2e-4 and np.abs(arrived.joints).max() < 1e-4
        assert np.abs(arrived.effort - plan.effort).max() < 0.05 * plan.effort.max()
    swung = screwgen.simulate(moved(), 2.2, 1e-3, controller=least_jerk(1.2))
    assert np.ptp(swung.tip_position[1201:, 1]) > 100 * arrived.residual


def least_jerk(time):
    """The acceleration of a path of least jerk by one radian."""
    at = lambda s: (60 * s - 180 * s**2 + 120 * s**3) / time**2 * (s < 1)  # noqa: E731
    return lambda t, q, v: np.array([at((t + 5e-4) / time)])


def test_a_driven_joint_and_a_given_one_go_the_same_way():
    """What moves the joint is left to the drive: the motion that leaves the rod at rest needs no torque of it."""
    plan = screwgen.plan(moved(), [0.0], [1.0], 1.2, fast=True)
    torques = screwgen.plan(boom(joint={"armature": [0.3]}), [0.0], [1.0], 1.2, fast=True)
    run = screwgen.play(moved(), plan).run
    assert run.tau[:-1, 0].max() == pytest.approx(plan.effort[0], rel=0.05)
    assert np.abs(plan.q - torques.q).max() < 0.1 and np.abs(plan.tau - torques.tau).max() > 1.0


def test_the_shortest_given_motion_is_bang_bang():
    """Of an acceleration of at most `a`, linear over the intervals `h = T / 24`, the way is `a T (T / 2 - h) / 2`."""
    most, way = 4.0, 0.8
    plan = screwgen.plan(
        boom(modes=0, joint={"actuation": "motion"}), [0.0], [way], "shortest", limits={"efforts": [most]}
    )
    time = np.sqrt(way / (0.97 * most) / (1 / 4 - 1 / 48))
    assert 1.0 <= plan.time / time < 1.003 and plan.effort[0] <= most


def test_behind_an_elastic_gear_the_input_is_the_acceleration_of_the_rotor():
    model = moved(joint={"actuation": "motion", "drives": {"ratio": 50.0, "rotor_inertia": 1e-4, "stiffness": 900.0}})
    plan = screwgen.plan(model, [0.0], [0.6], 1.0, fast=True)
    arrived = screwgen.play(model, plan, step=2.5e-4)
    assert arrived.effort == pytest.approx(plan.effort, rel=0.02)
    assert np.abs(arrived.run.tau).max() == pytest.approx(50.0 * plan.effort[0], rel=0.02)
    assert np.abs(arrived.joints).max() < 1e-4 and arrived.residual < 1e-3 * 1.2 * 0.6


def test_brakes_stand_open_and_tendons_slack():
    """Gains, a plan, a path of the tip and a place of it are those of the robot without them, and are played so."""
    plain = boom(joint={"armature": [0.3]})
    braked = boom(joint={"armature": [0.3], "brake": {"inertia": 0.3, "time": 0.05}})
    pulled = boom(
        joint={"armature": [0.3]},
        tendons=[{"name": "flexor", "at": [[0.0, 0.02, 0.0], [0.0, 0.02, 0.0]]}],
    )
    law, turn = screwgen.PD((100.0,), (30.0,), (0.0,)), np.array([0.3])
    for model, same in ((braked, plain), (pulled, plain)):
        kp, kd = zip(*((x.kp[0], x.kd[0]) for x in (screwgen.gains(y, [[0.0]]) for y in (model, same))), strict=True)
        assert kp[0] == kp[1] and kd[0] == kd[1]
        own, other = (screwgen.plan(x, [0.0], [1.0], 1.2, gains=law, fast=True) for x in (model, same))
        assert np.abs(own.tau - other.tau).max() < 1e-9 * np.abs(own.tau).max()
        arrived = screwgen.play(model, own)
        assert arrived.residual < 2e-4 and not arrived.run.tau[:, 1:].any()
        place = same.numpy().tip_pose(np.append(turn, np.zeros(same.nq - 1)))[1]
        assert np.allclose(screwgen.inverse_kinematics(model, place), turn, atol=1e-9)


def test_inputs_that_are_not_known_are_one_line():
    with pytest.raises(UsageError, match="has axes whose motion is given, for which there is no search for gains yet"):
        screwgen.gains(moved(), [[0.0]])
    with pytest.raises(UsageError, match="has axes whose motion is given, for which there is no scheduled shaper"):
        screwgen.shape(moved(), [-1.0], [1.0])


def test_a_tip_is_on_its_path_by_a_given_motion():
    """Its joint goes as that of a driven arm does, and what is planned is how it accelerates."""
    sweep = lambda t: 1.2 * np.stack([np.cos(eased(t / 1.2)), np.sin(eased(t / 1.2)), 0 * t], axis=-1)  # noqa: E731
    law = screwgen.PD((100.0,), (20.0,), (0.0,))
    given, driven = (
        screwgen.track(x, sweep, 1.2, step=2e-3, gains=law) for x in (moved(), boom(joint={"armature": [0.3]}))
    )
    assert np.abs(given.q - driven.q).max() < 1e-9 and np.abs(given.tau - given.vdot).max() < 1e-9 * given.effort[0]
    assert np.abs(given.tau - driven.tau).max() > 0.1 * driven.effort[0]
    run = screwgen.play(moved(), given).run
    goal = sweep(np.clip(run.t - 0.1, 0.0, 1.2))
    ahead = np.stack([-goal[:, 1], goal[:, 0], 0 * goal[:, 0]], axis=1) / 1.2
    assert np.abs(((run.tip_position - goal) * ahead).sum(axis=1)).max() < 2e-5
