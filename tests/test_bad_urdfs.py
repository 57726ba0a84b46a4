"""Wrong URDFs and side files: one line with file, line, element or key, fault and remedy; nothing is written."""

import warnings

import pytest

from screwgen.cli.main import main
from screwgen.errors import RobotFileError
from screwgen.interchange.load import import_urdf

GOOD = """\
<?xml version="1.0"?>
<robot name="bot">
  <link name="base"/>
  <link name="upper">
    <inertial>
      <origin xyz="0.1 0 0" rpy="0 0 0"/>
      <mass value="2"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <link name="fore">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.2" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.2"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="upper"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="5" velocity="2"/>
    <dynamics damping="0.1" friction="0.2"/>
  </joint>
  <joint name="elbow" type="continuous">
    <parent link="upper"/>
    <child link="fore"/>
    <origin xyz="0.5 0 0" rpy="0 0 0"/>
  </joint>
  <transmission name="gear">
    <joint name="elbow"/>
    <actuator name="m"><mechanicalReduction>100</mechanicalReduction><rotorInertia>1e-4</rotorInertia></actuator>
  </transmission>
</robot>
"""
MASS, TENSOR = '<mass value="2"/>', '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>'
LIMIT, DYNAMICS = '<limit lower="-1" upper="1" effort="5" velocity="2"/>', '<dynamics damping="0.1" friction="0.2"/>'
LAST = "</robot>"
MORE = '<link name="hand"/>'

ELBOW, GEAR, AT_8 = "line 24: joint 'elbow': ", "line 29: transmission 'gear': ", "line 8: link 'upper': "
AXIS, LOWER = "line 20: joint 'shoulder': axis xyz: ", "line 21: joint 'shoulder': limit lower: "
DRY, WEIGHT = "line 22: joint 'shoulder': dynamics ", "line 7: link 'upper': mass value: "
WRONG = [
    ("</robot>", "", "line 34: is not valid XML (no element found); mend it there"),
    ('<link name="base"/>', '<link name="base">', "line 33: is not valid XML (mismatched tag); mend it there"),
    ("<robot", "<!DOCTYPE robot><robot", "line 2: <!DOCTYPE> is not read; leave it out"),
    (GOOD[22:], GOOD[22:].replace("robot", "model"), "line 2: <model>: is the root of the file; a URDF has <robot"),
    (' name="bot"', "", "line 2: <robot>: name: is missing or empty; state name="),
    ("<link name=", "<xacro:arm/><link name=", "line 3: <xacro:arm>: is to be expanded by xacro; run `xacro "),
    ('xyz="0.5 0 0"', 'xyz="${l} 0 0"', "line 27: joint 'elbow': origin: is to be expanded by xacro; run `xacro "),
    ('<link name="base"/>', "<link/>", "line 3: link '': name: is missing or empty; state name="),
    ('name="fore"', 'name="upper"', "line 11: link 'upper': name: has the name of an earlier one; give each its own"),
    ('joint name="elbow"', 'joint name="shoulder"', "line 24: joint 'shoulder': name: has the name of an earlier one"),
    ('type="continuous"', 'type="hinge"', ELBOW + 'type: is "hinge"; it must be revolute, continuous'),
    ('type="continuous"', "", ELBOW + "type: is missing or empty; state type="),
    ('<parent link="upper"/>', "", ELBOW + "has no <parent>; state <parent link="),
    ('<parent link="upper"/>', "<parent/>", "line 25: joint 'elbow': parent link: is missing or empty; state link="),
    ('<child link="fore"/>', '<child link="for"/>', "line 26: joint 'elbow': child link: is \"for\", which is no link"),
    ('<child link="fore"/>', '<child link="upper"/>', ELBOW + "carries link 'upper', as joint 'shoulder'"),
    (
        LAST,
        f"{MORE}{LAST}",
        "line 33: link 'hand': has no joint that carries it, as link 'base', the root; join the two",
    ),
    ('<parent link="base"/>', '<parent link="fore"/>', "line 4: link 'upper': hangs on itself: its joints go round"),
    (MASS, "", "line 5: link 'upper': inertial: has no <mass>; state <mass value="),
    (MASS, "<mass/>", WEIGHT + "is missing; state value="),
    (MASS, '<mass value="-2"/>', WEIGHT + "is -2.0; it must be >= 0"),
    (MASS, '<mass value="2 kg"/>', WEIGHT + 'is "2 kg"; it must be a number, 0, or from 1e-12'),
    (MASS, '<mass value="two"/>', WEIGHT + 'is "two"; it must be a number'),
    (MASS, f"{MASS}{MASS}", "line 7: link 'upper': mass: is stated twice; leave one of them out"),
    (TENSOR, "", "line 5: link 'upper': inertial: has no <inertia>; state <inertia ixx="),
    (TENSOR, TENSOR.replace(' izz="0.1"', ""), AT_8 + "inertia izz: is missing; state izz="),
    (TENSOR, TENSOR.replace('izz="0.1"', 'izz="nan"'), AT_8 + "inertia izz: is nan; it must be a finite"),
    (
        TENSOR,
        TENSOR.replace('izz="0.1"', 'izz="0.3"'),
        AT_8 + "inertia: is one that no body has, principal moments 0.1, 0.1, 0.3 kg·m²: none",
    ),
    ('rpy="0 0 0"', 'rpy="0 0"', "line 6: link 'upper': origin rpy: is \"0 0\"; it must be 3 numbers"),
    ('xyz="0.5 0 0"', 'xyz="0,5 0 0"', "line 27: joint 'elbow': origin xyz: is \"0,5\"; it must be a number"),
    ('<axis xyz="0 1 0"/>', '<axis xyz="0 0 0"/>', AXIS + "is the zero vector; an axis"),
    ('<axis xyz="0 1 0"/>', "<axis/>", AXIS + "is missing; state xyz="),
    (LIMIT, LIMIT.replace('"-1"', '"2"'), LOWER + "is 2.0; it must be less than upper"),
    (LIMIT, LIMIT.replace('"-1"', '"pi"'), LOWER + 'is "pi"; it must be a number'),
    (DYNAMICS, DYNAMICS.replace('"0.1"', '"-0.1"'), DRY + "damping: is -0.1; it must be >= 0"),
    (DYNAMICS, DYNAMICS.replace('"0.2"', '"1e20"'), DRY + "friction: is 1e+20; it must be 0"),
    (DYNAMICS, '<mimic joint="elbows"/>', "line 22: joint 'shoulder': mimic joint: names \"elbows\", which is no"),
    ('type="continuous"', 'type="floating"', ELBOW + "type: is floating, which only the joint of the"),
    ('<joint name="elbow"/>', "", GEAR + "has no <joint>; state <joint name="),
    ('<joint name="elbow"/>', '<joint name="el"/>', GEAR + 'names the joint "el", which is not'),
    (">1e-4<", "><", "line 31: transmission 'gear': rotorInertia: is \"\"; it must be a number, from 1e-12"),
    (">100<", ">0<", "line 31: transmission 'gear': mechanicalReduction: is 0.0; it must be > 0"),
]
SINGULAR = (
    GOOD.replace("<rotorInertia>1e-4</rotorInertia>", "")
    .replace('ixx="0.2"', 'ixx="0"')
    .replace('iyy="0.2"', 'iyy="0"')
)
SINGULAR = SINGULAR.replace('izz="0.2"', 'izz="0"')
FIXED = GOOD.replace('type="revolute"', 'type="fixed"').replace('type="continuous"', 'type="fixed"')
CIRCLE = GOOD.replace('<link name="base"/>', "").replace('<parent link="base"/>', '<parent link="fore"/>')
WHOLE = [
    (f"\n\n{GOOD}".replace(MASS, "<mass/>").encode(), "line 9: link 'upper': mass value: is missing"),
    (b"", "line 1: is not valid XML (no element found); mend it there"),
    (b"name = 'bot'", "line 1: is not valid XML"),
    (GOOD.replace('"bot"', '"b\xf6t"').encode("latin-1"), "line 2: is not valid XML (not well-formed (invalid token))"),
    (GOOD.replace('"1.0"', '"1.0" encoding="klingon"').encode(), "unknown encoding"),
    (b"<robot name='bot'/>", "line 1: <robot>: has no <link>; a robot needs at least one"),
    (b"<a>" * 100, "line 1: <a>: is nested too deeply"),
    (CIRCLE.encode(), "line 2: <robot>: has no root link: its joints go round in a circle; let one link be no child"),
    (FIXED.encode(), "line 2: <robot>: has no joint that moves, and its base is fixed; --floating"),
    (
        GOOD.replace("rotorInertia>", "other>")
        .replace("<inertial>", "<other>")
        .replace("</inertial>", "</other>")
        .encode(),
        "line 4: link 'upper': has no mass, nor has what it carries; give it an <inertial>, or bodies in a side file",
    ),
    (SINGULAR.encode(), "line 24: joint 'elbow': moves nothing that resists it: link 'fore' and what it carries"),
]

FORE, UPPER = '[[links]]\nname = "fore"\n', '[[links]]\nname = "upper"\n'
SIDES = [
    ("links = 3", "links: is no array of tables; write [[links]] for each"),
    ("[[links]]\n", "links[0].name: is a Python NoneType, no link of"),
    ('[[links]]\nname = "arm"', 'links[0].name: is "arm", no link of'),
    (FORE * 2, 'links[1].name: is "fore" again; state all of a link in one table'),
    (FORE + 'parent = "base"', "links[0].parent (link fore): is what the URDF states; change it there"),
    (FORE + "rest = { bending_y = 1.0 }", "links[0].rest (link fore): bends the link away from where the URDF has"),
    (FORE + 'joint.axes = ["z"]', "links[0].joint.axes (link fore): is what the URDF states"),
    (FORE + "section = { rhoA = 1 }", "links[0].tip (link fore): is missing, and the link carries 0"),
    (UPPER + 'tip = "wrist"', 'links[0].tip (link upper): is "wrist", no joint that the link carries'),
    (UPPER + "tip = [0, 0]", "links[0].tip (link upper): has length 2; it must be an array of 3"),
    (UPPER + "tip = [0, 0, 0]", "links[0].tip (link upper): is the origin of the link; state another"),
    (UPPER + "y = [1, 0, 0]", "links[0].y (link upper): is along the centreline; state a direction"),
    (UPPER + "rpy = [1, 0, 0]", "links[0].rpy (link upper): is stated without body, whose axes"),
    (UPPER + "lenght = 2", "links[0].lenght (link upper): is an unknown key; did you mean length?"),
    (UPPER + 'modes = { bending_y = 2 }\ntip = "elbow"', "links[0].section (link upper): is missing"),
    (UPPER + 'body = { sid = "none.sid" }', "links[0].body.sid (link upper): none.sid: there is no such"),
    (FORE + "joint.armature = [-1]", "links[0].joint.armature[0] (link fore): is -1; it must be >= 0"),
    (FORE + 'at = "tip"', "links[0].at (link fore): is stated, but its carrier has no length"),
    ('base = "free"', 'base: is "free"; it must be "fixed" or "floating"'),
    ("gravity = 9.81", "gravity: is 9.81; it must be an array of 3 numbers"),
    ("order = 7", 'order: is 7; it must be 1, 2 or "exact"'),
    ("[[links", "line 1: is not valid TOML"),
]


def refusal(path, *more) -> str:
    """The one line with which a URDF is refused."""
    with pytest.raises(RobotFileError) as error:
        import_urdf(path, *more)
    assert "\n" not in str(error.value)
    return str(error.value)


@pytest.mark.parametrize("blank", ["", "\n \n"])
def test_the_good_file_is_good(tmp_path, blank):
    """Also behind blank lines, which XML does not allow before its declaration."""
    (tmp_path / "bot.urdf").write_text(blank + GOOD)
    assert len(import_urdf(tmp_path / "bot.urdf").robot.links) == 2


@pytest.mark.parametrize(("old", "new", "said"), WRONG)
def test_a_wrong_urdf_is_refused_in_one_line(tmp_path, old, new, said):
    assert old in GOOD
    (path := tmp_path / "bot.urdf").write_text(GOOD.replace(old, new, 1))
    assert refusal(path).startswith(f"{path}: {said}")


@pytest.mark.parametrize(("content", "said"), WHOLE)
def test_what_is_no_robot_is_refused_in_one_line(tmp_path, content, said):
    (path := tmp_path / "bot.urdf").write_bytes(content)
    text = refusal(path)
    assert text.startswith(f"{path}: ") and said in text


@pytest.mark.parametrize(("content", "said"), SIDES)
def test_a_wrong_side_file_is_refused_in_one_line(tmp_path, monkeypatch, content, said):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bot.urdf").write_text(GOOD)
    (tmp_path / "side.toml").write_text(content)
    assert refusal("bot.urdf", "side.toml").startswith(f"side.toml: {said}")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ("--mimic hold", "mimic: there is no 'hold'; choose couple, free, weld or refuse"),
        ("--tip wrist", 'tip: bot.urdf has no link "wrist"; name one'),
        ("--flexible none.toml", "none.toml: there is no such file"),
        ("--flexible bad.toml", "bad.toml: links[0].section (link upper): is missing"),
    ],
)
def test_the_command_refuses_in_one_line_and_writes_nothing(tmp_path, capsys, monkeypatch, options, said):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bot.urdf").write_text(GOOD)
    (tmp_path / "bad.toml").write_text('[[links]]\nname = "upper"\nlength = 1.0\nmodes = { axial = 1 }')
    assert main(["import", "bot.urdf", "-o", "bot.toml", *options.split()]) == 2
    text = capsys.readouterr().err
    assert text.count("\n") == 1 and text.startswith(f"screwgen: error: {said}")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["bad.toml", "bot.urdf"]


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(RobotFileError, match="there is no such file"):
        import_urdf(tmp_path / "none.urdf")


@pytest.mark.parametrize("size", ["1e-308", "5e-324", "1e-200", "1e6"])
def test_an_axis_of_any_length_has_its_direction(tmp_path, size):
    """Without a warning of NumPy: the square of a short one is zero."""
    for name, axis in (("unit", "0 1 0"), ("scaled", f"0 {size} 0")):
        (tmp_path / f"{name}.urdf").write_text(GOOD.replace('<axis xyz="0 1 0"/>', f'<axis xyz="{axis}"/>'))
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        unit, scaled = (import_urdf(tmp_path / f"{name}.urdf").robot for name in ("unit", "scaled"))
    assert unit.links == scaled.links
