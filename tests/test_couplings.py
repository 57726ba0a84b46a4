"""Couplings of two axes: against elimination by hand, Pinocchio, energy."""

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
import random_robots as rr
from helpers import arm, link, model_of, relative

from screwgen import OpenLoopError, RobotFileError, UsageError, assemble, dump, load, simulate
from screwgen.cli.main import main
from screwgen.interchange.load import import_urdf
from screwgen.interchange.tree import Options
from screwgen.interchange.urdf_write import export_urdf
from screwgen.model import derive


def geared() -> dict:
    """A wheel that drives a rack through a pinion of 0.05 m, and a second wheel by a belt."""
    spin = lambda name, inertia: {  # noqa: E731
        "name": name,
        "parent": "world",
        "joint": {"axes": ["z"]},
        "bodies": [{"at": "base", "mass": 1.0, "inertia": [inertia, inertia, inertia, 0.0, 0.0, 0.0]}],
    }
    rack = {"name": "rack", "parent": "world", "joint": {"axes": [{"slide": "x"}]}}
    rack["bodies"] = [{"at": "base", "mass": 2.0}]
    couplings = [
        {"axis": "rack.slide[0]", "of": "wheel.joint[0]", "ratio": 0.05},
        {"axis": "other.joint[0]", "of": "wheel.joint[0]", "ratio": -3.0},
    ]
    return arm(spin("wheel", 0.01), rack, spin("other", 0.002)) | {"couplings": couplings}


def test_a_rack_and_a_belt_by_hand():
    """The reduced inertia is J + m r² + 9 J_2; the torque of 1 N·m on the wheel moves all of it."""
    model = model_of(geared())
    reduced = 0.01 + 2.0 * 0.05**2 + 9 * 0.002
    vdot, _ = model.numpy().forward_dynamics(np.zeros(3), np.zeros(3), [1.0, 0.0, 0.0], None)
    assert np.allclose(vdot, np.array([1.0, 0.05, -3.0]) / reduced, rtol=1e-13)
    torques = model.numpy().coupling_torques(np.zeros(3), np.zeros(3), [1.0, 0.0, 0.0], None)
    assert np.allclose(torques[1:], [2.0 * 0.05 / reduced, -3.0 * 0.002 / reduced], rtol=1e-12)
    assert torques[0] == pytest.approx(0.01 / reduced - 1.0, rel=1e-12)


def swinging() -> dict:
    """A flexible arm whose wrist turns half as much as its shoulder, the other way, and two fingers."""
    first = link("upper", 0.8, "y", 1.2, modes={"bending_z": 1}, section={"EIy": 400.0, "EIz": 400.0})
    finger = lambda name, y: {  # noqa: E731
        "name": name,
        "parent": "wrist",
        "joint": {"axes": [{"slide": [0.0, y, 0.0]}]},
        "bodies": [{"at": "base", "mass": 0.1, "com": [0.05, 0.02 * y, 0.0]}],
    }
    couplings = [
        {"axis": "wrist.joint[0]", "of": "upper.joint[0]", "ratio": -0.5},
        {"axis": "right.slide[0]", "of": "left.slide[0]"},
    ]
    robot = arm(first, link("wrist", 0.3, "y", 0.9), finger("left", 1.0), finger("right", -1.0))
    return robot | {"couplings": couplings}


@pytest.mark.parametrize("form", ["joint", "dae"])
def test_energy_is_kept_and_the_axes_stay_coupled(form):
    model = model_of(swinging())
    run = simulate(model, 1.0, 5e-4, form=form, integrator="rk4" if form == "joint" else "modal_midpoint")
    energy, size = run.energy.sum(axis=1), np.ptp(run.energy[:, 0])
    assert np.max(np.abs(energy - energy[0])) < (1e-8 if form == "joint" else 2e-5) * size
    at = model.q_names.index
    assert np.max(np.abs(run.q[:, at("wrist.joint[0]")] + 0.5 * run.q[:, at("upper.joint[0]")])) < 1e-8
    assert np.ptp(run.q[:, at("upper.joint[0]")]) > 0.5


def test_a_start_that_is_not_coupled_is_refused_and_assemble_mends_it():
    model, q = model_of(swinging()), np.zeros(5)
    q[0] = 0.4
    with pytest.raises(UsageError, match=r"coupling\[0\] is open by 0\.2 rad"):
        simulate(model, 0.01, 1e-3, q)
    found = assemble(model, q, hold=["upper.joint[0]"])
    assert found[0] == 0.4 and found[1] == pytest.approx(-0.2)
    simulate(model, 0.01, 1e-3, found)


def test_axes_that_two_couplings_hold_apart_cannot_close():
    robot = swinging()
    robot["couplings"] += [robot["couplings"][1] | {"offset": 0.1}]
    with pytest.raises((OpenLoopError, UsageError), match=r"coupling\[\d\].*stays open by 0\.1"):
        model_of(robot)


BAD = (
    ({"axis": "wrist.joint[0]"}, "couplings[0].of: is missing"),
    ({"axis": "wrist.joint[0]", "of": "wrist.joint[0]"}, "couplings[0].of: couples an axis with itself"),
    ({"axis": "wrist", "of": "upper.joint[0]"}, "couplings[0].axis: is"),
    ({"axis": "hand.joint[0]", "of": "upper.joint[0]"}, "which is no link; choose"),
    ({"axis": "wrist.joint[1]", "of": "upper.joint[0]"}, "but that joint has 1 axes"),
    ({"axis": "left.joint[0]", "of": "upper.joint[0]"}, "but that axis slides; call it 'left.slide[0]'"),
    ({"axis": "wrist.joint[0]", "of": "upper.joint[0]", "ratio": "2"}, "couplings[0].ratio: is"),
    ({"axis": "wrist.joint[0]", "of": "upper.joint[0]", "ratio": 1e9}, "it must be from -1e+06 to 1e+06"),
    ({"axis": "wrist.joint[0]", "of": "upper.joint[0]", "gain": 1.0}, "couplings[0].gain"),
)


@pytest.mark.parametrize(("table", "said"), BAD)
def test_bad_couplings_are_refused_in_one_line(table, said, tmp_path):
    path = tmp_path / "robot.toml"
    entries = ", ".join(f"{key} = {value!r}" for key, value in table.items()).replace("'", '"')
    robot = {key: value for key, value in swinging().items() if key != "couplings"}
    path.write_text(f"couplings = [{{ {entries} }}]\n" + rr.to_toml(robot))
    with pytest.raises(RobotFileError) as caught:
        load(path)
    assert said in str(caught.value).replace('"', "'") and "\n" not in str(caught.value)


def test_axes_behind_elastic_gears_are_refused(tmp_path):
    robot = swinging()
    robot["links"][1]["joint"]["drives"] = [{"ratio": 50.0, "rotor_inertia": 1e-4, "stiffness": 1e3}]
    with pytest.raises(Exception, match="driven through an elastic gear"):
        model_of(robot)


def test_files_read_back(tmp_path):
    robot = model_of(swinging()).robot
    path = tmp_path / "robot.toml"
    path.write_text(dump(robot))
    assert load(path) == robot


MIMIC = """\
<robot name="gripper">
  <link name="base"/>
  {links}
  <joint name="arm" type="continuous"><parent link="base"/><child link="palm"/><axis xyz="0 1 0"/></joint>
  <joint name="left" type="prismatic"><parent link="palm"/><child link="one"/><origin xyz="0.1 0 0"/>
    <axis xyz="0 1 0"/><limit lower="0" upper="0.1" effort="1" velocity="1"/></joint>
  <joint name="right" type="prismatic"><parent link="palm"/><child link="two"/><origin xyz="0.1 0 0"/>
    <axis xyz="0 -1 0"/><limit lower="0" upper="0.1" effort="1" velocity="1"/>
    <mimic joint="left" multiplier="{ratio}" offset="0.01"/></joint>
</robot>
"""


@pytest.fixture
def gripper(tmp_path) -> Path:
    body = '<link name="{}"><inertial><origin xyz="0.05 0.01 0"/><mass value="{}"/><inertia ixx="2e-3" ixy="0" ixz="0" \
iyy="3e-3" iyz="0" izz="4e-3"/></inertial></link>'
    links = "\n  ".join(body.format(name, mass) for name, mass in (("palm", 2.0), ("one", 0.3), ("two", 0.4)))
    path = tmp_path / "gripper.urdf"
    path.write_text(MIMIC.format(links=links, ratio=1.5))
    return path


def test_a_urdf_whose_joint_mimics_another_equals_pinocchios(gripper):
    found = import_urdf(gripper, None, Options())
    (coupling,) = found.robot.couplings
    assert (coupling.axis, coupling.of, coupling.ratio, coupling.offset) == ("two.slide[0]", "one.slide[0]", 1.5, 0.01)
    model, theirs = derive(found.robot), pin.buildModelFromUrdf(str(gripper), mimic=True)
    data, rng = theirs.createData(), np.random.default_rng(3)
    for _ in range(3):
        q, v, tau = rng.uniform(-0.5, 0.5, (3, 2))
        ours = lambda x, offset=0.0: np.array([x[0], x[1], 1.5 * x[1] + offset])  # noqa: E731
        vdot, _ = model.numpy().forward_dynamics(ours(q, 0.01), ours(v), [*tau, 0.0], None)
        turned = np.array([np.cos(q[0]), np.sin(q[0]), q[1]])
        M = np.triu(pin.crba(theirs, data, turned))
        M = M + np.triu(M, 1).T
        expected = np.linalg.solve(M, tau - pin.nonLinearEffects(theirs, data, turned, v))
        assert relative(vdot[:2], expected) < 1e-12 and vdot[2] == pytest.approx(1.5 * vdot[1], rel=1e-12)


def test_exported_couplings_are_read_back(gripper, tmp_path):
    robot = import_urdf(gripper).robot
    again = tmp_path / "again.urdf"
    again.write_text(export_urdf(robot).text)
    assert import_urdf(again).robot.couplings == robot.couplings


def test_a_mimic_of_no_joint_is_refused(gripper):
    gripper.write_text(gripper.read_text().replace('mimic joint="left"', 'mimic joint="thumb"'))
    with pytest.raises(RobotFileError, match=r"joint .right.: mimic joint: names \"thumb\", which is no other joint"):
        import_urdf(gripper)


def test_an_imported_gripper_goes_through_the_commands(gripper, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["import", "gripper.urdf", "-o", "gripper.toml", "--quiet"]) == 0
    assert "[[couplings]]" in Path("gripper.toml").read_text()
    assert main(["assemble", "gripper.toml", "--q=0.3,0.02,0", "--output", "start.json"]) in (0, 2)
    assert main(["generate", "gripper.toml", "-o", "out", "--target", "c", "--layout", "modular", "-q"]) == 0
    assert main(["latex", "gripper.toml", "-o", "equations.html"]) == 0
