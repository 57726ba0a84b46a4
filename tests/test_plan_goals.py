"""Plans through waypoints and to places of the tip: played, they are there; what cannot be is one line."""

import numpy as np
import pytest
from helpers import arm, link, model_of
from random_plans import cart, ella, rod
from robot_toml import to_toml

import screwgen
from screwgen import UsageError
from screwgen.cli.main import main

LAW = screwgen.PD((60.0,), (14.0,), (0.0,))


def test_a_plan_passes_its_waypoints_and_arrives_at_rest():
    model = rod()
    through = [{"q": [0.9]}, {"q": [-0.2], "t": 1.3}]
    plan = screwgen.plan(model, [0.0], [0.5], 2.0, gains=LAW, through=through, intervals=40)
    when = 1.3 * 0.9 / (0.9 + 1.1)  # on the way to the one that has a time
    arrived = screwgen.play(model, plan, step=5e-4)
    run = arrived.run
    assert np.interp([when, 1.3], run.t, run.q[:, 0]) == pytest.approx([0.9, -0.2], abs=2e-3)
    assert arrived.residual < 1e-3 and run.q[-1, 0] == pytest.approx(0.5, abs=1e-3)


def test_there_and_back_is_a_plan_and_the_shortest_one_passes_too():
    model = rod()
    back = screwgen.plan(model, [0.0], [0.0], 1.6, gains=LAW, through=[{"q": [0.6]}])
    assert back.reference(0.8)[0] == pytest.approx(0.6, abs=1e-9) and screwgen.play(model, back).residual < 2e-3
    ways = {"gains": LAW, "limits": {"efforts": [40.0]}, "intervals": 30}
    fast, straight = (screwgen.plan(model, [0.0], [0.8], "shortest", through=x, **ways) for x in ([{"q": [1.1]}], []))
    assert fast.time > straight.time
    assert fast.reference(fast.time * 1.1 / 1.4)[0] == pytest.approx(1.1, abs=1e-9)


@pytest.mark.parametrize(
    ("through", "said"),
    [
        ([{"q": [2.0]}], r"through\[0\]: rod\.joint\[0\] is 2; its limits are -inf and 1\.5"),
        ([{"q": [0.5], "t": 1.0}, {"q": [0.7], "t": 0.5}], r"through\[1\]: t must be later"),
        ([{"q": [0.5], "t": 3.0}], r"through\[0\]: t must be later than the one before it, before the end"),
        ([{"q": [0.0]}], r"through\[0\]: .* q another place"),
        ([[0.5]], r"through\[0\]: must be a table of q"),
        ([{"q": [0.5, 0.1]}], r"through\[0\]: q"),
    ],
)
def test_waypoints_that_cannot_be_are_one_line(through, said):
    with pytest.raises(UsageError, match=said) as caught:
        screwgen.plan(rod(), [0.0], [1.0], 2.0, through=through, limits={"upper": [1.5]})
    assert "\n" not in str(caught.value)


def test_the_shortest_time_takes_no_times_of_waypoints():
    with pytest.raises(UsageError, match=r"through\[0\]: t: is given, and the time is 'shortest'"):
        screwgen.plan(rod(), [0.0], [1.0], "shortest", through=[{"q": [0.5], "t": 1.0}])


def test_the_tip_rests_where_inverse_kinematics_says():
    """Equilibrium under the torques that hold the joints there, a study of its own, has the tip at the place."""
    model, place = ella(), np.array([0.95, 1.4, 0.4])
    joints = screwgen.inverse_kinematics(model, place, [-0.4, 0.6, 0.4])
    rest = screwgen.equilibrium(model, joints, hold="all")
    position = model.numpy().tip_pose(rest.q)[1]
    assert np.linalg.norm(position - place) < 1e-7
    rigid = model.numpy().tip_pose(np.append(joints, np.zeros(model.nq - 3)))[1]
    assert np.linalg.norm(rigid - place) > 5e-3  # the links sag


@pytest.mark.parametrize(
    ("place", "said"),
    [
        ([3.0, 0.0, 0.0], r"tip: is out of reach; the closest place found is \(1\.8.*\), 1\.1.* m away"),
        ([0.9, np.nan, 0.0], "tip: "),
    ],
)
def test_places_out_of_reach_are_one_line(place, said):
    with pytest.raises(UsageError, match=said):
        screwgen.inverse_kinematics(ella(), place)


def test_a_stretched_arm_is_singular():
    upper, lower = (link(name, axes=["z"], length=1.0, modes={}, section={"rhoA": 1.0}) for name in ("upper", "lower"))
    model = model_of({**arm(upper, lower), "gravity": [0.0, 0.0, 0.0]})
    with pytest.raises(UsageError, match=r"tip: the arm is singular there, with joints at"):
        screwgen.inverse_kinematics(model, [np.sqrt(2.0), np.sqrt(2.0), 0.0])
    joints = screwgen.inverse_kinematics(model, [1.0, 1.0, 0.0], [0.1, 1.0])
    assert joints == pytest.approx([0.0, np.pi / 2], abs=1e-7)


def test_a_file_asks_for_a_place_of_the_tip(tmp_path, capsys):
    model = cart()
    (tmp_path / "robot.toml").write_text(to_toml(model.robot.model_dump(exclude_unset=True)))
    task = "start = [0.0, 0.0]\ngoal_tip = [1.0, 0.6, 0.0]\ntime = 3.0\nthrough = [{ q = [0.3, 0.0], t = 1.4 }]\n"
    (tmp_path / "plan.toml").write_text(task + "limits = { efforts = [200.0, 10.0] }\n")
    files = [str(tmp_path / name) for name in ("robot.toml", "plan.toml", "plan.npz")]
    assert main(["plan", *files[:2], "-o", files[2], "--quiet"]) == 0
    plan = screwgen.read_plan(files[2])
    place = model.numpy().tip_pose(plan.q[-1])[1]
    assert np.allclose(place, [1.0, 0.6, 0.0], atol=1e-7) and plan.reference(1.4)[0] == pytest.approx([0.3, 0.0])
    (tmp_path / "plan.toml").write_text("goal = [0.1, 0.0]\n" + task)
    assert main(["plan", *files[:2], "-o", files[2], "--quiet"]) == 2
    assert "plan.toml: goal, goal_tip: state one of them" in capsys.readouterr().err
    faults = {
        "goal = [0.1, 90.0]\nstart = [0.0]\ntime = 3.0\n": "plan.toml: start: has 1 numbers; it must have 2",
        task.replace("0.6, 0.0", "0.6, 9.0"): "plan.toml: goal_tip: is out of reach; ",
        task.replace(
            "time = 3.0", "time = " + '"fast"'
        ): 'plan.toml: time: is "fast"; it must be a number of s, or "shortest"',
    }
    for text, said in faults.items():
        (tmp_path / "plan.toml").write_text(text)
        assert main(["plan", *files[:2], "-o", files[2], "--quiet"]) == 2
        *notes, error = capsys.readouterr().err.splitlines()
        assert said in error and ("90 degrees are 1.571" in "".join(notes)) == ("90.0" in text)


def test_a_joint_without_inertia_is_named():
    model = model_of(arm({"name": "rod", "joint": {"axes": ["z"]}, "bodies": [{"at": "base", "mass": 0.0}]}))
    for tool in (lambda: screwgen.plan(model, [0.0], [1.0], 1.0), lambda: screwgen.gains(model, [[0.0]])):
        with pytest.raises(screwgen.SingularError, match="nothing resists the joint of link 'rod'; give the link"):
            tool()
