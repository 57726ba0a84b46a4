"""URDFs read: trees against Pinocchio, side files, names, rotors, what is merged, welded, left out and said."""

import tomllib
import warnings
from itertools import pairwise

import numpy as np
import pinocchio as pin
import pytest
from conftest import swept
from random_urdfs import random_urdf
from scipy.spatial.transform import Rotation
from urdf_judge import Pair
from urdf_texts import ARM, BODY, joint, robot

import screwgen
from screwgen import Link
from screwgen.cli.main import main
from screwgen.errors import RobotFileError, UsageError
from screwgen.interchange.load import import_urdf
from screwgen.interchange.rigid import pose
from screwgen.interchange.tree import Options

FLAT = {"bending_y": 1, "bending_z": 1}


@pytest.fixture
def file(tmp_path):
    """Writes a URDF, or a side file, and returns its path."""

    def write(text: str, name: str = "bot.urdf"):
        (tmp_path / name).write_text(text, encoding="utf-8")
        return tmp_path / name

    return write


# ------------------------------------------------------------------------------ against Pinocchio


@pytest.mark.parametrize("floating", [False, True])
@pytest.mark.parametrize("seed", swept(range(8), 0))
def test_random_trees_equal_pinocchios(file, seed, floating):
    pair = Pair(file(random_urdf(seed)), floating=floating)
    assert len(pair.columns) == pair.pin.nv
    assert pair.misfit() < 1e-12


@pytest.mark.parametrize("seed", swept([1, 2], 1))
def test_kept_fixed_joints_change_no_motion(file, seed):
    path = file(random_urdf(seed))
    pair = Pair(path, keep_fixed=True)
    assert len(pair.found.robot.links) == 8 > len(import_urdf(path).robot.links)
    assert pair.misfit() < 1e-12


def test_the_robot_file_has_the_same_numbers_to_the_last_bit(file, tmp_path):
    path, out = file(random_urdf(1, 6)), tmp_path / "bot.toml"
    assert main(["import", str(path), "-o", str(out), "--quiet"]) == 0
    with pytest.warns(screwgen.ImportNote):
        direct = screwgen.load(path)
    written = screwgen.load(out)
    assert written == direct and len(written.links) > 3
    q = np.linspace(-1, 1, (model := screwgen.derive(written)).nq)
    assert np.array_equal(model.numpy().mass_matrix(q), screwgen.derive(direct).numpy().mass_matrix(q))
    assert max(map(len, out.read_text().splitlines()[10:])) <= 120


def test_a_planar_joint_moves_in_the_plane_across_its_axis(file):
    """Two slides and a turn about the axis: Pinocchio's are joined by links without mass."""
    flat = robot(joint("flat", "base", "upper", "planar", axis="0.6 0 0.8"), joint("elbow", "upper", "fore"))
    found = import_urdf(file(flat))
    slides = [np.array(axis.axis) for axis in found.robot.links[0].joint.axes[:2]]
    links = "base s1 s2 upper fore"
    chain = (
        robot(
            joint("flat_0", "base", "s1", "prismatic", axis=" ".join(map(repr, slides[0].tolist()))),
            joint("flat_1", "s1", "s2", "prismatic", xyz="0 0 0", axis=" ".join(map(repr, slides[1].tolist()))),
            joint("flat_2", "s2", "upper", "continuous", xyz="0 0 0", axis="0.6 0 0.8"),
            joint("elbow", "upper", "fore"),
            links=links,
        )
        .replace(f'<link name="s1">{BODY}', '<link name="s1">')
        .replace(f'<link name="s2">{BODY}', '<link name="s2">')
    )
    pair = Pair(file(chain, "chain.urdf"))
    assert pair.misfit() < 1e-12
    q = np.array([0.3, -0.2, 0.7, 0.4])
    M = screwgen.derive(found.robot).numpy().mass_matrix(q)
    assert np.allclose(M, pair.model.numpy().mass_matrix(q), rtol=0, atol=1e-13)
    assert abs(slides[0] @ slides[1]) < 1e-15 and np.allclose(np.cross(*slides), [0.6, 0, 0.8])


def test_a_floating_joint_of_the_root_is_a_floating_base(file):
    text = robot(joint("free", "base", "upper", "floating", xyz="0 0 0"), joint("elbow", "upper", "fore"))
    pair = Pair(file(text), mimic="free")
    assert pair.found.robot.base == "floating" and len(pair.found.robot.links) == 2
    other = Pair(file(robot(joint("elbow", "upper", "fore"), links="upper fore"), "other.urdf"), floating=True)
    assert pair.found.robot.links == other.found.robot.links and other.misfit() < 1e-12


# ------------------------------------------------------------------------------ side files

SIDE = """
gravity = [0.0, 0.0, -1.62]

[[links]]
name = "upper"
section = { rhoA = 3.0, rhoIp = 0.01, EIy = 1e9, EIz = 1e9, GJ = 1e9 }
modes = { bending_y = 1, bending_z = 1, torsion = 1 }
"""


def rod(length: float, along) -> pin.Inertia:
    """A rod of 3 kg/m along a unit vector, with an inertia of 0.01 kg·m about it."""
    along = np.array(along)
    across = 3.0 * length**3 / 12 * (np.eye(3) - np.outer(along, along))
    return pin.Inertia(3.0 * length, along * length / 2, across + 0.01 * length * np.outer(along, along))


def test_a_flexible_link_runs_to_the_joint_that_it_carries(file):
    """Undeformed it is a rod from joint to joint: the rigid part of the mass matrix is Pinocchio's of that rod."""
    pair = Pair(file(ARM), file(SIDE, "side.toml"))
    pair.pin.inertias[1] = rod(0.5, [0.0, 0.6, 0.8])
    link = pair.found.robot.links[0]
    assert link.length == 0.5 and link.joint.mount.xyz == (0.0, 0.0, 0.5)
    assert pair.found.robot.gravity == (0.0, 0.0, -1.62)
    assert pair.misfit() < 1e-12
    said = "link 'upper': a beam of 0.5 m, 36.9° askew to its z axis (tip = [0.0, 0.0, 0.4] lays it along); "
    said += "its section takes the place of the inertial, 2 kg, and weighs 1.5 kg; "
    assert any(note.startswith(said) for note in pair.found.notes)


def test_the_tip_that_a_note_proposes_lays_the_beam_along_its_axis(file):
    """The joint behind it stays where it was: beside the tip, for which the mount has the offset."""
    found = import_urdf(file(ARM), file(SIDE.replace('"upper"', '"upper"\ntip = [0.0, 0.0, 0.4]'), "side.toml"))
    upper, fore = found.robot.links[:2]
    assert upper.length == 0.4 and np.linalg.norm(fore.joint.mount.xyz) == pytest.approx(0.3)
    assert any(note.startswith("link 'upper': a beam of 0.4 m along its z axis; ") for note in found.notes)


@pytest.mark.parametrize("between, weight", [("linear", 1.5), ("polynomial", 4 / 3)])
def test_a_note_weighs_sections_that_vary(file, between, weight):
    """ρA of 2, 3 and 4 kg/m at s = 0, 1/2, 1 over 0.5 m, and the parabola through 2, 3 and 2."""
    last = 4.0 if between == "linear" else 2.0
    rows = ", ".join(f"{{ at = {s}, rhoA = {x}, EIy = 50.0 }}" for s, x in ((0, 2.0), (0.5, 3.0), (1, last)))
    side = '[[links]]\nname = "upper"\nmodes = { bending_z = 1 }\n'
    side += f'section = {{ stations = [{rows}], between = "{between}" }}\n'
    found = import_urdf(file(ARM), file(side, "side.toml"))
    assert any(f"and weighs {weight:.6g} kg; " in note for note in found.notes), found.notes


def test_a_right_angle_of_twelve_digits_leaves_no_digits_in_mounts(file):
    """With the beam's own turn it would leave 5e-12 rad in angles that are zero; no other angle changes."""
    found = import_urdf(file(ARM.replace('xyz="0 0 0.5"', 'rpy="0 1.57079632679 0"')), file(SIDE, "side.toml"))
    assert found.robot.links[0].joint.mount.rpy
    angles = [x for link in found.robot.links for x in link.joint.mount.rpy or ()]
    assert all(x == 0 or abs(x) > 1e-3 for x in angles), angles


def test_names_that_changed_are_those_of_links_that_remain(file):
    text = robot(joint("a", "world", "upper"), joint("b", "upper", "fore-arm"), links="world upper fore-arm")
    notes = import_urdf(file(text)).notes
    assert "names that became C identifiers: fore-arm -> fore_arm" in notes


def test_what_hangs_between_the_ends_is_carried_there(file):
    """A joint, and a welded link, at 0.4 of the length; a welded one at the tip is part of the body there."""
    text = robot(
        joint("shoulder", "base", "upper"),
        joint("elbow", "upper", "fore", xyz="0 0.3 0.4"),
        joint("hook", "upper", "hoist", xyz="0.1 0.12 0.16"),
        joint("lamp", "upper", "light", "fixed", xyz="0 0.12 0.16"),
        joint("plate", "upper", "flange", "fixed", xyz="0.02 0.3 0.4"),
        links="base upper fore hoist light flange",
    )
    pair = Pair(file(text), file(SIDE.replace('"upper"', '"upper"\ntip = "elbow"'), "side.toml"))
    at = {link.name: link.at for link in pair.found.robot.links}
    assert at["fore"] == "tip" and at["hoist"].s == pytest.approx(0.4) and at["light"].s == pytest.approx(0.4)
    assert [body.at for body in pair.found.robot.links[0].bodies] == ["tip"]
    whole = rod(0.5, [0.0, 0.6, 0.8])
    lamp, plate = (pin.SE3(np.eye(3), np.array(xyz)) for xyz in ([0, 0.12, 0.16], [0.02, 0.3, 0.4]))
    body = pin.Inertia(2.0, np.array([0.1, 0.0, 0.0]), 0.1 * np.eye(3))
    pair.pin.inertias[1] = whole + lamp.act(body) + plate.act(body)
    assert pair.misfit() < 1e-12


def test_a_section_without_mass_spreads_that_of_the_inertial(file):
    side = SIDE.replace("rhoA = 3.0, ", "")
    found = import_urdf(file(ARM), file(side, "side.toml"))
    assert found.robot.links[0].section.rhoA == 2.0 / 0.5
    assert any("its 2 kg are spread over the section" in note for note in found.notes)


def test_other_keys_of_a_link_are_added_to_the_urdfs(file):
    side = '[[links]]\nname = "fore"\njoint.armature = [0.3]\nbodies = [{ at = "base", mass = 1.0 }]\n'
    link = import_urdf(file(ARM), file(side, "side.toml")).robot.links[1]
    assert link.joint.armature == (0.3,) and link.joint.limits is not None
    assert [body.mass for body in link.bodies] == [2.0, 1.0]


def test_the_y_axis_of_the_section_is_what_the_side_file_says(file):
    side = SIDE.replace('"upper"', '"upper"\ntip = [0.0, 0.0, 0.4]\ny = [1.0, 0.0, 0.3]')
    link = import_urdf(file(ARM), file(side, "side.toml")).robot.links[0]
    R = pose((0, 0, 0), link.joint.mount.rpy).R
    assert np.allclose(R[:, 0], [0, 0, 1]) and np.allclose(R[:, 1], [1, 0, 0])
    assert link.length == 0.4 and np.allclose(R @ link.joint.axes[0], [0, 1, 0])


def test_a_body_from_finite_elements_stands_as_the_side_file_says(file, tmp_path):
    """Its file is named from the folder of the side file, in the robot file from there; x runs along the URDF's z."""
    boom = Link(name="boom", length=0.5, section={"rhoA": 3.0, "EIy": 9e3, "EIz": 9e3}, modes=FLAT, joint={"axes": []})
    (tmp_path / "parts").mkdir()
    (tmp_path / "out").mkdir()
    screwgen.write_sid(boom, tmp_path / "parts" / "boom.sid")
    side = '[[links]]\nname = "upper"\nbody = { sid = "boom.sid" }\nrpy = [0.0, -1.5707963267948966, 0.0]\n'
    urdf = file(robot(joint("shoulder", "base", "upper"), joint("elbow", "upper", "fore", xyz="0.02 0 0.5")))
    found = import_urdf(urdf, file(side, "parts/side.toml"))
    upper, fore = found.robot.links
    assert upper.length is None and np.allclose(fore.joint.mount.xyz, [0, 0, -0.02], rtol=0, atol=1e-9)
    (tmp_path / "out" / "bot.toml").write_text(text := found.text(tmp_path / "out"))
    assert 'body = { sid = "../parts/boom.sid" }' in text
    again = screwgen.load(tmp_path / "out" / "bot.toml")
    assert again.links[0].body.data == upper.body.data and again.links[1] == fore


# ------------------------------------------------------------------------------ what is read, merged and said


def test_rotors_of_transmissions_are_drives(file):
    gear = (
        '<transmission name="t"><type>x</type><joint name="elbow"/><actuator name="m">'
        "<mechanicalReduction>100</mechanicalReduction><drake:rotor_inertia value='2e-5'/></actuator></transmission>"
    )
    found = import_urdf(file(ARM.replace("</robot>", gear + "</robot>")))
    (drive,) = found.robot.links[1].joint.drives
    assert (drive.ratio, drive.rotor_inertia) == (100.0, 2e-5)
    bare = gear.replace("<drake:rotor_inertia value='2e-5'/>", "")
    found = import_urdf(file(ARM.replace("</robot>", bare + "</robot>")))
    assert found.robot.links[1].joint.drives is None
    assert any(note.startswith("transmissions, 1 of them: left out") for note in found.notes)


def test_friction_and_limits_are_those_of_the_joint(file):
    text = ARM.replace("</joint>", '<dynamics damping="0.3" friction="0.7"/></joint>', 1)
    found = import_urdf(file(text))
    stated = found.robot.links[0].joint
    assert stated.damping == (0.3,) and stated.drives[0].friction.coulomb == 0.7
    assert stated.limits[0].bounds == (-1.0, 1.0) and stated.limits[0].effort == 5.0
    assert any("velocity" in note and "[2, 2]" in note for note in found.notes)


def test_names_become_c_identifiers(file):
    links = ("base", "arm.left", "arm-left", "3rd", "while", "_x", "a" * 60, "A" * 60, "world")
    joints = [joint(f"j{i}", a, b) for i, (a, b) in enumerate(pairwise(links))]
    text = robot(*joints, links=" ".join(links), name="main")
    found = import_urdf(file(text))
    names = [link.name for link in found.robot.links]
    assert names[:5] == ["arm_left", "arm_left_2", "link_3rd", "while_2", "link_x"] and names[-1] == "world_2"
    assert names[5] == "a" * 40 and names[6] == "A" * 38 + "_2"
    assert found.robot.name == "main_robot"
    assert any("main -> main_robot, arm.left -> arm_left" in note for note in found.notes)
    assert found.joints["j1"] == ("arm_left_2.joint[0]",)


def test_mimic_is_refused_or_left_out_as_asked(file):
    mimic = joint("finger", "fore", "thumb", "prismatic", '<mimic joint="elbow" offset="0.2"/>')
    path = file(ARM.replace("</robot>", f'<link name="thumb">{BODY}</link>{mimic}</robot>'))
    with pytest.raises(RobotFileError, match=r"line 1: joint 'finger': mimic: couples two joints.*--mimic couple"):
        import_urdf(path, None, Options(mimic="refuse"))
    assert len(import_urdf(path, None, Options(mimic="free")).robot.links) == 3
    welded = import_urdf(path, None, Options(mimic="weld")).robot.links
    assert len(welded) == 2 and welded[1].bodies[0].mass == 4.0
    assert welded[1].bodies[0].com == pytest.approx((0.1, 0.1, 0.25))
    turning = mimic.replace('"prismatic"', '"revolute"')
    path = file(ARM.replace("</robot>", f'<link name="thumb">{BODY}</link>{turning}</robot>'))
    (turned,) = import_urdf(path, None, Options(mimic="weld")).robot.links[1].bodies
    place = np.array([0, 0, 0.5]) + Rotation.from_rotvec([0, 0.2, 0]).apply([0.1, 0, 0])
    assert turned.com == pytest.approx((np.array([0.1, 0, 0]) + place) / 2)
    with pytest.raises(UsageError, match="mimic: there is no 'hold'"):
        import_urdf(path, None, Options(mimic="hold"))


def test_joints_that_move_no_mass_are_welded_and_said(file):
    path = file(ARM.replace("</robot>", f'<link name="eye"/>{joint("gaze", "fore", "eye")}</robot>'))
    found = import_urdf(path)
    assert "joint 'gaze': moves nothing that has mass; it is welded" in found.notes
    kept = import_urdf(path, None, Options(tip="eye"))
    assert kept.robot.links[-1].name == "eye" and kept.robot.links[-1].joint.axes == ()


def test_links_without_mass_may_stand_between_joints(file):
    text = robot(joint("a", "base", "upper"), joint("b", "upper", "fore", axis="1 0 0", xyz="0 0 0"))
    pair = Pair(file(text.replace(f'<link name="upper">{BODY}', '<link name="upper">')))
    assert pair.found.robot.links[0].bodies[0].mass == 0.0 and pair.misfit() < 1e-12


def test_the_tip_is_the_link_that_is_asked_for(file):
    parts = joint("left", "upper", "l"), joint("right", "upper", "r", xyz="0 0.2 0"), joint("s", "base", "upper")
    tool = joint("hand", "l", "tool", "fixed", xyz="0.3 0 0")
    path = file(robot(*parts, tool, links="base upper l r tool"))
    assert [x.name for x in import_urdf(path).robot.links] == ["upper", "l", "r"]
    pair = Pair(path, tip="tool")
    assert [x.name for x in pair.found.robot.links] == ["upper", "r", "l", "tool"] and pair.misfit() < 1e-12
    with pytest.raises(UsageError, match="carries links that move"):
        import_urdf(path, None, Options(tip="upper"))


def test_a_load_of_a_urdf_warns_of_each_thing_left_out_and_commands_say_it(file, capsys):
    path = file(ARM.replace("</robot>", '<gazebo/><gazebo reference="x"/></robot>').replace(BODY, BODY + "<visual/>"))
    with pytest.warns(screwgen.ImportNote, match="<gazebo> in <robot>, 2 times: left out"):
        screwgen.load(path)
    assert main(["equilibrium", str(path), "--hold"]) == 0
    said = capsys.readouterr().err
    assert "screwgen: note:" in said and "<visual>: left out" in said
    with pytest.raises(UsageError, match=r"is no \.urdf"):
        screwgen.load(path.with_suffix(".toml"), flexible="side.toml")


def test_the_command_writes_a_readable_file_and_says_what_it_has(file, tmp_path, capsys):
    out = tmp_path / "bot.toml"
    urdf, side = file(ARM), file(SIDE, "side.toml")
    assert main(["import", str(urdf), "-o", str(out), "--flexible", str(side)]) == 0
    assert capsys.readouterr().out == f"{out}\n2 links, 2 joint coordinates, flexible: upper\n"
    text = out.read_text()
    assert text.startswith("# From bot.urdf and side.toml, by screwgen ")
    assert '# shoulder: revolute, base -> upper\n[[links]]\nname = "upper"\n' in text
    assert tomllib.loads(text)["links"][1]["joint"]["limits"] == {"lower": -1.0, "upper": 1.0, "effort": 5.0}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert screwgen.load(out) == screwgen.load(urdf, flexible=side)


def test_an_inertia_that_no_body_has_can_be_replaced_by_the_nearest(file):
    text = ARM.replace('izz="0.1"', 'izz="0.4"')
    with pytest.raises(RobotFileError, match=r"principal moments 0\.1, 0\.1, 0\.4.*--nearest-inertia"):
        import_urdf(file(text))
    pair = Pair(file(text), nearest_inertia=True)
    assert pair.misfit() < 1e-10
    said = "line 1: link '{}': no body has its principal moments 0.1, 0.1, 0.4 kg·m²; the nearest that one has are "
    assert sorted(note for note in pair.found.notes if "no body" in note) == [
        said.format(link) + "0.2, 0.2, 0.4 kg·m²" for link in ("fore", "upper")
    ]
