"""Robot files with loops whose joints give way: what they state, what is refused, parameters."""

from __future__ import annotations

import numpy as np
import pytest
from bad_robot_files import GOOD, refused
from helpers import model_of
from test_compliant_loops import ARM, hanging, linkage, pendulum

import screwgen
from screwgen.spec.load import dump
from screwgen.spec.parameters import parameters

LOOP = '[[loops]]\nbetween = ["upper.tip", "fore.tip"]\njoint = { axes = ["y"], stiffness = 1e4, damping = 2.0 }\n'


@pytest.mark.parametrize(
    ("old", "new", "where", "fragment"),
    [
        ("stiffness = 1e4, ", "", "loops[0].joint.damping", "is stated without stiffness"),
        ("stiffness = 1e4", "stiffness = -1.0", "loops[0].joint.stiffness", "is -1.0; it must be > 0"),
        ("stiffness = 1e4", "stiffness = 0.0", "loops[0].joint.stiffness", "is 0.0; it must be > 0"),
        ("damping = 2.0", "damping = -2.0", "loops[0].joint.damping", "is -2.0; it must be >= 0"),
        ("stiffness = 1e4", 'stiffness = "soft"', "loops[0].joint.stiffness", "must be a number"),
        ("stiffness = 1e4", "stiffness = [1e4]", "loops[0].joint.stiffness", "length 1; it must be an array of 2 num"),
        ("stiffness = 1e4", "stiffness = [1e4, 0.0]", "loops[0].joint.stiffness[1]", "is 0.0; it must be > 0"),
        ("damping = 2.0", "damping = [2.0, -1.0]", "loops[0].joint.damping[1]", "is -1.0; it must be >= 0"),
        ("stiffness = 1e4", "stiffness = 1e30", "loops[0].joint.stiffness", "it must be from 1e-09 to 1e+18"),
        ("joint =", "stabilisation = 5.0\njoint =", "loops[0].stabilisation", "whose joint gives way"),
        ("damping = 2.0", "drives = [{}]", "loops[0].joint.drives", "nothing drives a loop's joint"),
    ],
)
def test_wrong_keys_are_refused_in_one_line(tmp_path, old, new, where, fragment):
    refused(tmp_path, GOOD + LOOP.replace(old, new, 1), where, fragment)


@pytest.mark.parametrize(
    ("axes", "fragment"), [(["x", "y", "z"], "turns"), ([{"slide": x} for x in "xyz"], "motion along an axis")]
)
def test_two_numbers_of_a_joint_that_has_no_use_for_one_are_refused(axes, fragment):
    robot = pendulum()
    robot["loops"][0]["joint"] = {"axes": axes, "stiffness": [1e4, 1e3]}
    with pytest.raises(screwgen.ScrewgenError, match=f"blocks no {fragment}; state one number"):
        screwgen.Robot(**robot)


def test_a_link_has_not_the_name_of_such_a_loop():
    robot = pendulum(1e4)
    robot["links"][2]["name"] = "loop_0"
    robot["loops"][0]["between"][0] = "loop_0.tip"
    with pytest.raises(screwgen.ScrewgenError, match="loops\\[0\\]: has the name loop_0 in generated code"):
        screwgen.Robot(**robot)


def test_a_file_that_is_written_and_read_is_the_same(tmp_path):
    robot = screwgen.Robot(**linkage(1e4, 2.0))
    (tmp_path / "linkage.toml").write_text(dump(robot), encoding="utf-8")
    assert screwgen.load(tmp_path / "linkage.toml") == robot
    assert "stiffness = 10000.0" in dump(robot)
    two = screwgen.Robot(**linkage([1e4, 30.0], [2.0, 0.1]))
    (tmp_path / "linkage.toml").write_text(dump(two), encoding="utf-8")
    assert screwgen.load(tmp_path / "linkage.toml") == two
    assert "stiffness = [10000.0, 30.0]" in dump(two)


def test_directions_have_numbers_of_their_own():
    """A weld, turned by 0.2 rad and pulled away: force and torque by closed forms; the energy that is their work."""
    robot = pendulum([1e4, 30.0], [5.0, 0.2])
    robot["gravity"], robot["loops"][0]["joint"]["axes"] = [0.0, 0.0, 0.0], []
    model = model_of(robot)
    numeric, q, v = model.numpy(), hanging(0.2, 3e-3), np.array([0.4, -0.1, 0.0])
    assert sum(numeric.energy(q, 0 * v)) == pytest.approx(0.5 * 1e4 * 9e-6 + 0.5 * 30.0 * np.sin(0.2) ** 2)
    pull = np.array([-1e4 * 3e-3 - 5.0 * 0.4, 0.0, 5.0 * 0.1])
    moment = np.cross(-ARM * np.array([np.cos(0.2), 0.0, -np.sin(0.2)]), pull)[1] - 30.0 * np.sin(0.2) * np.cos(0.2)
    found = numeric.forward_dynamics(q, v, None, None)[0]
    assert found == pytest.approx([pull[0] / 2.0, pull[2] / 2.0, moment / 0.03], rel=1e-9)


def test_one_number_is_that_of_both():
    models = model_of(linkage(1e4, 2.0)), model_of(linkage([1e4, 1e4], [2.0, 2.0]))
    q, v = np.array([1.1, -0.8, 1.3, 0.01]), np.array([0.3, -0.2, 0.5, 0.1])
    one, two = (model.numpy().forward_dynamics(q, v, None, None)[0] for model in models)
    assert one == pytest.approx(two, rel=1e-14)
    robot = linkage(1e4, 2.0)
    robot["loops"][0]["joint"]["axes"] = ["x", "y", "z"]
    assert model_of(robot).parameter_names[-2:] == ["loop_0.stiffness[0]", "loop_0.damping[0]"]


def test_its_numbers_are_parameters():
    model = model_of(linkage(1e4, 2.0))
    assert model.parameter_names[-4:] == [f"loop_0.{name}[{k}]" for name in ("stiffness", "damping") for k in (0, 1)]
    assert [p.unit for p in parameters(model.robot)][-4:] == ["N/m", "N·m/rad", "N·s/m", "N·m·s/rad"]
    new = {"loop_0.stiffness[0]": 3e4, "loop_0.stiffness[1]": 2e2, "loop_0.damping[0]": 7.0, "loop_0.damping[1]": 0.3}
    other = model.chain.parameters.vector(new)
    q, v = np.array([1.1, -0.8, 1.3, 0.01]), np.array([0.3, -0.2, 0.5, 0.1])
    expected = model_of(linkage([3e4, 2e2], [7.0, 0.3])).numpy().forward_dynamics(q, v, None, None)[0]
    assert model.numpy(other).forward_dynamics(q, v, None, None)[0] == pytest.approx(expected, rel=1e-12)
