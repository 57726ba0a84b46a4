"""Robots written as URDF: Pinocchio and our own reading of the file have the dynamics of the rigid robot."""

from xml.etree import ElementTree

import numpy as np
import pinocchio as pin
import pytest
import random_robots as rr
from conftest import swept
from helpers import arm, link, model_of
from urdf_judge import Pair

from screwgen.cli.main import main
from screwgen.interchange.load import import_urdf
from screwgen.interchange.urdf_write import export_urdf

RIGID = {"rigid": 1.0, "material": 0.0, "branching": 0.4, "armature": 1.0, "bodies": 0.8, "no_gravity": 0.0}
SIDE = "gravity = {}\n"


def rigid_robot(seed: int) -> dict:
    """A tree of rigid links with slides and several axes in a joint, without screws and springs."""
    rng = np.random.default_rng([17, seed])
    while True:
        robot, _, _ = rr.draw_regular(rng, 4, sliding=0.3, **RIGID)
        for table in robot["links"]:
            table["joint"].pop("stiffness", None)
        if not any("screw" in axis for table in robot["links"] for axis in table["joint"]["axes"]):
            return robot


def joints_of(link: dict) -> list[str]:
    """The names of a link's joints in the URDF, one for each axis."""
    count = len(link["joint"]["axes"])
    return [f"{link['name']}_joint" + (f"_{k}" if count > 1 else "") for k in range(count)]


@pytest.mark.parametrize("seed", swept(range(6), 0))
def test_export_and_import_keep_the_dynamics(tmp_path, seed):
    robot = rigid_robot(seed)
    model = model_of(robot)
    urdf, side = tmp_path / "bot.urdf", tmp_path / "side.toml"
    urdf.write_text(export_urdf(model.robot).text)
    side.write_text(SIDE.format(robot["gravity"]))
    pair = Pair(urdf, side)
    rng = np.random.default_rng(seed)
    names = [name for link in robot["links"] for name in joints_of(link)]
    assert len(names) == model.nv == pair.model.nv
    q, v, a = rng.uniform(-1, 1, (3, model.nv))
    order = [pair.model.q_names.index(pair.found.joints[name][0]) for name in names]
    back = np.argsort(order)
    rest = np.zeros((model.n_links, 6)), np.zeros((pair.model.n_links, 6))
    M = model.numpy().mass_matrix(q)
    size = np.sqrt(np.diag(M))
    other = pair.model.numpy().mass_matrix(q[back])[np.ix_(order, order)]
    assert np.max(np.abs(other - M) / np.outer(size, size)) < 1e-12
    tau = model.numpy().inverse_dynamics(q, v, a, rest[0])
    other = pair.model.numpy().inverse_dynamics(q[back], v[back], a[back], rest[1])[order]
    assert np.allclose(other, tau, rtol=0, atol=1e-11 * np.max(np.abs(tau)))
    # Pinocchio reads no rotors.
    columns, their_q = [], pin.neutral(pair.pin)
    for k, name in enumerate(names):
        joint = pair.pin.joints[pair.pin.getJointId(name)]
        columns.append(joint.idx_v)
        their_q[joint.idx_q : joint.idx_q + joint.nq] = (np.cos(q[k]), np.sin(q[k])) if joint.nq == 2 else (q[k],)
    upper = np.triu(pin.crba(pair.pin, pair.data, their_q))
    theirs = (upper + np.triu(upper, 1).T)[np.ix_(columns, columns)]
    armature = np.concatenate([link["joint"].get("armature", [0.0] * len(joints_of(link))) for link in robot["links"]])
    assert np.max(np.abs(theirs + np.diag(armature) - M) / np.outer(size, size)) < 1e-12


ARM = {
    "name": "arm",
    "gravity": [0.0, 0.0, -9.81],
    "base": "floating",
    "links": [
        {"name": "hull", "joint": {"axes": []}, "bodies": [{"at": "base", "mass": 9.0, "inertia": [1, 1, 1, 0, 0, 0]}]},
        {
            "name": "boom",
            "length": 0.8,
            "section": {"rhoA": 1.5, "rhoIp": 0.01, "EIy": 90.0, "EIz": 70.0},
            "modes": {"bending_y": 2, "bending_z": 1},
            "segments": 2,
            "joint": {"axes": ["z", {"slide": "x"}], "stiffness": [3.0, 0.0], "limits": [{"lower": -1.0}, {}]},
            "bodies": [{"at": "tip", "mass": 2.0, "com": [0.1, 0.0, 0.05]}],
        },
        {"name": "jib", "length": 0.5, "at": {"s": 0.5}, "section": {"rhoA": 1.0}, "joint": {"axes": ["y"]}},
    ],
}


def test_a_flexible_floating_robot_is_written_as_its_rigid_shape(tmp_path):
    """The rigid part of its mass matrix at rest is Pinocchio's, and a line says each thing that is left out."""
    model = model_of(ARM)
    found = export_urdf(model.robot)
    (tmp_path / "arm.urdf").write_text(found.text)
    pair = Pair(tmp_path / "arm.urdf", floating=True)
    q = np.zeros(model.nq)
    q[3] = 1.0
    rigid = slice(0, 9)
    M = model.numpy().mass_matrix(q)[rigid, rigid]
    other = pair.model.numpy().mass_matrix(np.array([0, 0, 0, 1, 0, 0, 0, 0, 0, 0.0]))
    assert np.allclose(other, M, rtol=0, atol=1e-12 * np.abs(M).max()) and pair.misfit() < 1e-12
    said = "\n".join(found.notes)
    for text in ("the base floats", "boom: is flexible", "boom.joint.stiffness", "no upper limit", "no lower limit"):
        assert text in said


def test_viewers_get_shapes_of_the_robots_size():
    root = ElementTree.fromstring(export_urdf(model_of(ARM).robot).text)
    link = next(link for link in root.iter("link") if link.get("name") == "boom")
    cylinder = next(v for v in link.iter("visual") if v.find("geometry/cylinder") is not None)
    assert float(cylinder.find("geometry/cylinder").get("length")) == 0.8
    assert cylinder.find("origin").get("xyz") == "0.4 0.0 0.0"
    assert cylinder.find("material").get("name") == "flexible"
    assert {link.get("name") for link in root.iter("link")} == {"hull", "boom", "boom_axis_0", "jib"}


def test_limits_of_efforts_are_those_at_the_joints(tmp_path):
    """Of an elastic gear the motor's times the ratio; Pinocchio reads them, and so do we, but for what means none."""
    gear = {"ratio": 50.0, "rotor_inertia": 1e-4, "stiffness": 900.0}
    links = [
        link("hub", 0.3, ("z",), joint={"limits": {"effort": 30.0}}),
        link("arm", 0.4, ("y",), joint={"limits": {"lower": -1.0, "effort": 0.5}, "drives": gear}),
        link("rod", 0.4, [{"slide": "x"}], joint={"limits": {"upper": 0.2, "effort": 7.0}}),
        link("hand", 0.3, ("y",), joint={"limits": {"lower": -1.0, "upper": 1.0}}),
    ]
    path = tmp_path / "arm.urdf"
    path.write_text(export_urdf(model_of(arm(*links)).robot).text)
    assert pin.buildModelFromUrdf(str(path)).upperEffortLimit.tolist() == [30.0, 25.0, 7.0, 1e6]
    found = import_urdf(path)
    assert [one.joint.limits[0].effort for one in found.robot.links] == [30.0, 25.0, 7.0, None]
    assert any("joint 'hand_joint': effort 1e6 counts as no limit" in note for note in found.notes)


def test_a_screw_is_refused_in_one_line(tmp_path, capsys):
    text = 'name = "a"\ngravity = [0, 0, 0]\n[[links]]\nname = "b"\nbodies = [{ at = "base", mass = 1.0 }]\n'
    (tmp_path / "a.toml").write_text(text + 'joint.axes = [{ screw = "x", pitch = 0.01 }]\n')
    out = tmp_path / "a.urdf"
    assert main(["export", str(tmp_path / "a.toml"), "-o", str(out)]) == 2
    assert (
        f"{tmp_path}/a.toml: links[0].joint.axes[0] (link b): is a screw, and URDF has no joint"
        in capsys.readouterr().err
    )
    assert not out.exists()


def test_the_command_writes_what_pinocchio_reads(tmp_path, capsys):
    text = 'name = "a"\ngravity = [0, 0, -1.62]\n[[links]]\nname = "base"\nlength = 1.0\n'
    text += 'section.rhoA = 1.0\njoint.axes = ["y"]\n'
    (tmp_path / "a.toml").write_text(text)
    out = tmp_path / "a.urdf"
    assert main(["export", str(tmp_path / "a.toml"), "-o", str(out)]) == 0
    printed = capsys.readouterr()
    assert printed.out == f"{out}\n" and "gravity = [0.0, 0.0, -1.62] is left out" in printed.err
    shapes = pin.buildGeomFromUrdf(pin.buildModelFromUrdf(str(out)), str(out), pin.GeometryType.VISUAL)
    assert shapes.ngeoms == 2
    assert [link.name for link in import_urdf(out).robot.links] == ["base"]
