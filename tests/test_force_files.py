"""Files whose forces between frames are refused: each in one line that names what is wrong."""

from dataclasses import dataclass

import pytest
from bad_robot_files import FORCES, GOOD, refused

from screwgen import RobotFileError, dump
from screwgen.interactions import Interaction, ReportedQuantity, number
from screwgen.spec.forces import Force
from screwgen.spec.load import loads

BOTH, FIRST, LINE = '["upper.tip", "fore.tip"]', '"upper.tip"', "line = { stiffness = 40.0, rest = 0.3 }"
AT, NORMAL, PLACE = 'at = "fore.tip"', "normal = [0.0, 0.0, 1.0]", "forces[0].between"
WRONG = (
    (BOTH, '["upper.tip"]', PLACE, "has 1 entries; it must have two, each the name of a link with that of its marker"),
    (BOTH, FIRST, PLACE, 'is "upper.tip"; it must be an array of two places'),
    (BOTH, '["world", { world = [0.0, 0.0, 1.0] }]', PLACE, "joins the world with itself; name a marker of a link"),
    (FIRST, '"fore.tip"', PLACE, "joins a place with itself; name two places"),
    (FIRST, '"upper"', f"{PLACE}[0]", 'as "boom.tip", or a point as { world = [0.0, 0.0, 2.0] }'),
    (FIRST, "3", f"{PLACE}[0]", "is 3; it must be the name of a link with that of its marker"),
    (FIRST, '"upper.hook"', f"{PLACE}[0]", 'no marker of link \'upper\'; choose "base" or "tip"'),
    (FIRST, '"lower.tip"', f"{PLACE}[0]", 'which is no link; choose "upper" or "fore"'),
    (FIRST, '"world.tip"', f"{PLACE}[0]", "state a point of the world as { world = [0.0, 0.0, 2.0] }"),
    (FIRST, "{ wrld = [0.0, 1.0, 2.0] }", f"{PLACE}[0]", 'has the keys "wrld"; it must be'),
    (FIRST, "{ world = [0.0, 1.0] }", f"{PLACE}[0].world", "has length 2; it must be an array of 3 numbers"),
    (FIRST, "{ world = [0.0, nan, 1.0] }", f"{PLACE}[0].world[1]", "is nan; it must be a finite number"),
    (FIRST, "{ world = [0.0, 0.0, 1e30] }", f"{PLACE}[0].world[2]", "it must be from -1e+06 to 1e+06 m"),
    (f"between = {BOTH}\n", "", PLACE, "is missing; state the two ends"),
    ('name = "spring"\n', "", "forces[0].name", "is missing; state the force's name"),
    ('name = "spring"', 'name = "UPPER"', "forces[0].name", "the name of a link, upper; choose another name"),
    ('name = "spring"', 'name = "my-spring"', "forces[0].name", "must be a C identifier"),
    ('name = "hand"', 'name = "spring"', "pushes[0].name", "the name of an earlier one; choose another name"),
    ('name = "hand"', 'name = "tip"', "pushes[0].name", 'is "tip", a marker of fore; choose another name'),
    (NORMAL, f"{NORMAL}, other = 0.1", "forces[1].contact.other", "is stated beside a normal, of a plane; leave one"),
    (NORMAL, f"{NORMAL}, velocity = 0.1", "forces[1].contact.velocity", "is stated without friction, whose velocity"),
    (LINE, "", "forces[0]", "does not state what acts; state one of line = { … }"),
    (LINE, f"drag = {{ quadratic = 1.0 }}\n{LINE}", "forces[0]", "states line and drag; state one of line"),
    ("line =", "lines =", "forces[0].lines", "is an unknown key; did you mean line? known here: name, between, line"),
    (LINE, f"stiffness = 4.0\n{LINE}", "forces[0].stiffness", "is an unknown key; known here: name, between, line"),
    (LINE, "line = 3", "forces[0].line", "is 3; it must be a table of stiffness, rest, damping, relaxation, relax"),
    (", rest = 0.3", ", winch = true", "forces[0].line.winch", "is stated without rest, the length without any line"),
    ("rest = 0.3", "relaxation = 9.0", "forces[0].line.relaxation_time", "is missing beside the other of relaxation"),
    (
        "rest = 0.3",
        "rest = 0.3, relaxation = 9.0, relaxation_time = 1.0, winch = true",
        "forces[0].line.winch",
        "is stated beside relaxation; a line that relaxes has no winch yet; leave one of them out",
    ),
    (LINE, "law = 3", "forces[0].law", "is 3; it must be an object made in Python; in a file state one of line"),
    (LINE, "law = { foo = 3 }", "forces[0].law", "must be an object made in Python; in a file state one of line"),
    ("stiffness = 40.0, ", "", "forces[0].line.stiffness", "is missing; state the stiffness of the line, N/m"),
    ("stiffness = 40.0", "stiffness = 0.0", "forces[0].line.stiffness", "is 0.0; it must be > 0"),
    ("stiffness = 40.0", "stiffness = 1e30", "forces[0].line.stiffness", "it must be from 1e-09 to 1e+18 N/m"),
    ("stiffness = 40.0", 'stiffness = "4"', "forces[0].line.stiffness", 'is "4"; it must be a number'),
    ("rest = 0.3", "rest = -0.3", "forces[0].line.rest", "is -0.3; it must be >= 0"),
    ("rest = 0.3", "Rest = 0.3", "forces[0].line.Rest", "is an unknown key; did you mean rest? known here: stiffness"),
    ("rest = 0.3", "slack = 1", "forces[0].line.slack", "is 1; it must be true or false"),
    (NORMAL, "normal = [0.0, 0.0, 0.0]", "forces[1].contact.normal", "has no direction; state one that is not zero"),
    (NORMAL, "normal = [0.0, 1.0]", "forces[1].contact.normal", "has length 2; it must be an array of 3 numbers"),
    (LINE, "drag = { }", "forces[0].drag", "states no drag; state linear or quadratic"),
    (LINE, "bushing = { stiffness = [1.0] }", "forces[0].bushing.stiffness", "it must be an array of 6 numbers"),
    (f"{AT}\n", "", "pushes[0].at", 'is missing; state the marker at which it acts, as "boom.tip"'),
    (AT, 'at = "fore"', "pushes[0].at", 'of its marker, as "boom.tip"'),
    (AT, "at = { world = [0.0, 0.0, 1.0] }", "pushes[0].at", "is a place of the world; name a marker of a link"),
    (AT, 'at = "fore.hook"', "pushes[0].at", 'no marker of link \'fore\'; choose "base" or "tip"'),
    ('axes = "marker"', 'axes = "tip"', "pushes[0].axes", 'is "tip"; it must be "world" or "marker"'),
    ('axes = "marker"', "force = [1.0, 0.0, 0.0]", "pushes[0].force", "is an unknown key; known here: name, at, axes"),
    ("[[pushes]]", "[pushes]", "pushes", "is a table; it must be an array of tables"),
    ("[[pushes]]", "[[push]]", "push", "is an unknown key; did you mean pushes?"),
)


def test_a_file_with_forces_is_read_and_written_again():
    robot = loads(GOOD + FORCES, "bot.toml")
    assert [force.law.KIND for force in robot.forces] == ["line", "contact"] and robot.pushes[0].axes == "marker"
    assert loads(dump(robot), "bot.toml") == robot


@pytest.mark.parametrize(("old", "new", "where", "fragment"), WRONG)
def test_wrong_forces_are_refused_in_one_line(tmp_path, old, new, where, fragment):
    assert old in FORCES
    refused(tmp_path, GOOD + FORCES.replace(old, new, 1), where, fragment)


@dataclass(frozen=True)
class Twice(Interaction):
    """A law that reports what is one of its numbers."""

    KIND = "twice"
    WORDS = "laws"
    QUANTITIES = {"length": ReportedQuantity("m", "length")}  # noqa: RUF012

    length: float = number("m", "length", "l")


def test_what_a_law_of_ones_own_states_is_checked():
    between = ("upper.tip", "fore.tip")
    with pytest.raises(RobotFileError, match=r"twice: reports length, which is one of its numbers too; choose another"):
        Force(name="one", between=between, law=Twice(1.0))
    with pytest.raises(RobotFileError, match=r"law: is 3; it must be an object made in Python"):
        Force(name="one", between=between, law=3)
