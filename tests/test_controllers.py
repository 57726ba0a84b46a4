"""Control laws: PD along references, and the torques that hold an arm against gravity."""

from dataclasses import replace

import numpy as np
import pytest
from helpers import model_of
from test_simulate import soft_dict

from screwgen import UsageError
from screwgen.simulation.controllers import PD, Holding
from screwgen.simulation.named_controllers import read_controller
from screwgen.simulation.simulate import simulate
from screwgen.studies.equilibrium import equilibrium


def floating() -> dict:
    robot = soft_dict() | {"gravity": [0.0, 0.0, 0.0]}
    for link in robot["links"]:
        link["damping"] = {"ratio": 0.05}
    return robot


def test_pd_brings_the_arm_to_its_set_point():
    goal = (0.3, -0.2, 0.4)
    law = PD((40.0, 40.0, 20.0), (15.0, 15.0, 4.0), goal, duration=1.0, tau_max=(9.0, 9.0, 9.0))
    run = simulate(model_of(floating()), 4.0, 1e-3, controller=law)
    assert np.abs(run.q[-1, :3] - goal).max() < 0.02
    assert np.abs(run.tau).max() <= 9.0
    assert np.abs(run.tau[0]).max() == 0.0  # a minimum-jerk start asks for nothing


def test_minimum_jerk_reference_starts_and_ends_at_rest():
    law = PD((1.0,), (1.0,), (2.0,), duration=0.5).starting_at([1.0, 9.0])
    for t, place in ((0.0, 1.0), (0.25, 1.5), (0.5, 2.0), (0.9, 2.0)):
        assert law.reference(t)[0] == pytest.approx([place])
    h = 1e-6
    for t in (0.0, 0.1, 0.37, 0.5):
        slope = (law.reference(t + h)[0] - law.reference(max(t - h, 0.0))[0]) / (t + h - max(t - h, 0.0))
        assert law.reference(t)[1] == pytest.approx(slope, abs=1e-4)


def test_way_points_are_reached_at_rest_one_after_the_other():
    points = ((0.5, (1.0, -1.0)), (2.0, (0.2, 0.0)))
    law = PD((1.0, 1.0), (1.0, 1.0), points[-1][1], points[-1][0], waypoints=points).starting_at([0.3, 0.1, 9.0])
    assert law.set_points == ((0.0, (0.3, 0.1)), *points)
    for t, q in (*law.set_points, (9.0, points[-1][1]), (1.25, (0.6, -0.5))):
        assert law.reference(t)[0] == pytest.approx(q)
    h = 1e-6
    for t in (0.1, 0.49, 0.5, 0.51, 1.9, 2.0, 3.0):
        slope = (law.reference(t + h)[0] - law.reference(t - h)[0]) / (2 * h)
        assert law.reference(t)[1] == pytest.approx(slope, abs=1e-4)
    with pytest.raises(UsageError, match="last of the waypoints"):
        PD((1.0, 1.0), (1.0, 1.0), (0.0, 0.0), 2.0, waypoints=points)


def test_torques_that_hold_are_those_of_the_equilibrium():
    """Also beside joint springs; one computation goes down the potential energy, the other solves for the modes."""
    robot = soft_dict()
    robot["links"][1]["joint"]["stiffness"] = [3.0] * len(robot["links"][1]["joint"]["axes"])
    model = model_of(robot)
    for q in ([0.0] * 3, [0.3, -0.5, 1.1]):
        assert Holding(model)(q) == pytest.approx(equilibrium(model, q, hold="all").tau, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_gravity_compensation_leaves_no_error_at_rest(backend):
    """PD alone sags under the weight; with the torques that hold the arm it rests at its set point."""
    robot = soft_dict("polynomial")
    for link in robot["links"]:
        link["damping"] = {"ratio": 0.1}
    model, goal = model_of(robot), (0.3, -0.2, 0.4)
    rest = equilibrium(model, goal, hold=True)
    law = PD((40.0, 40.0, 20.0), (15.0, 15.0, 4.0), goal)
    sag, held = (
        np.abs(simulate(model, 0.2, 1e-3, rest.q, controller=x, backend=backend).q[-1, :3] - goal).max()
        for x in (law, replace(law, gravity=Holding(model)))
    )
    assert sag > 1e-2 and held < 1e-9


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"tau_max": (-1.0,)}, r"^PD: tau_max\[0\]: is -1.0; it must be > 0"),
        ({"duration": 0.0}, "^PD: duration: is 0.0; it must be > 0"),
        ({"kp": (-1.0,)}, r"^PD: kp\[0\]: .* >= 0"),
        ({"q_des": (float("nan"),)}, r"^PD: q_des\[0\]: .*finite"),
    ],
)
def test_pd_laws_built_in_python_keep_to_the_rules_of_files(options, message):
    with pytest.raises(UsageError, match=message):
        PD(**({"kp": (1.0,), "kd": (1.0,), "q_des": (0.0,)} | options))


def test_inputs_over_time_come_from_a_table(tmp_path):
    """Linear between rows, held at the ends; columns in any order, others zero; tendons among them."""
    robot = soft_dict()
    robot["links"][1]["tendons"] = [{"name": "cord", "at": [[0.0, 0.03, 0.0], [0.0, 0.02, 0.0]]}]
    model = model_of(robot)
    name = model.tau_names[1]
    path = tmp_path / "inputs.csv"
    path.write_text(f"cord.tension, t, {name}\n10,0.01,1.0\n\n30,0.03,-2.0\n")
    law = read_controller(f"csv:{path}", model)
    wanted = {0.0: (1.0, 10.0), 0.01: (1.0, 10.0), 0.02: (-0.5, 20.0), 0.03: (-2.0, 30.0), 9.0: (-2.0, 30.0)}
    for t, (torque, tension) in wanted.items():
        assert law(t, None, None) == pytest.approx([0.0, torque, 0.0, tension])
    run = simulate(model, 0.04, 1e-3, controller=law)
    assert run.tau[20] == pytest.approx([0.0, -0.5, 0.0, 20.0])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "has no rows; write a head, t,"),
        ("t,elbow\n0,1\n", "column 'elbow' is an unknown key; "),
        ("t,t\n0,1\n", "column 't' is there 2 times; leave one"),
        ("t;upper.torque[0]\n0;1\n", "has semicolons between its columns; write commas"),
        ("upper.torque[0]\n1\n", "has no column 't'"),
        ("t,upper.torque[0]\n0,1\n1\n", "line 3: has 1 entries; it must have 2, as the head"),
        ("t,upper.torque[0]\n0,nan\n", r"line 2: upper.torque\[0\] is 'nan'; it must be a finite number"),
        ("t,upper.torque[0]\n0,1\n\n0,2\n", "line 4: t is 0 s; it must be later than in the row before"),
    ],
)
def test_tables_of_inputs_that_say_nothing_are_refused(tmp_path, text, said):
    path = tmp_path / "inputs.csv"
    path.write_text(text)
    with pytest.raises(UsageError, match=f"inputs.csv: {said}") as error:
        read_controller(f"csv:{path}", model_of(soft_dict()))
    assert "\n" not in str(error.value)


def test_pd_of_unequal_lengths_is_refused():
    with pytest.raises(UsageError, match="kd has length 1"):
        PD((1.0, 2.0), (1.0,), (0.0, 0.0))
