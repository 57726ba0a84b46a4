"""Rods of order "exact" around the dynamics: what files may say of them, their points, control, what documents show."""

import re

import numpy as np
import pytest
from helpers import QUICK, arm, link, model_of, quick, relative
from test_mpc import PLAIN
from test_reduced import arm_of, free_cloud

from screwgen import Robot, RobotFileError
from screwgen.backends.latex import document
from screwgen.bodies.collocation import collocation
from screwgen.simulation.motion import centrelines, displacements
from screwgen.spec.load import loads
from screwgen.viewer.scene import scene
from screwgen.viewer.solids import Bend

GOOD = """name = "arm"
gravity = [0, 0, -9.81]
order = "exact"
[[links]]
name = "rod"
length = 1.0
section = { rhoA = 1.0, EIz = 1.0 }
modes = { bending_y = 2 }
joint = { axes = ["z"] }
"""


def bent(modes: int = 3, **more):
    """A rod of unit length and stiffness without gravity, clamped."""
    section = {"EIy": 1.0, "EIz": 1.0}
    rod = link("rod", 1.0, [], 1.0, {"bending_y": modes}, section=section, **more)
    return model_of(arm(rod, gravity=(0, 0, 0), order="exact"))


CURVED = [{"at": 0.0, "bending_y": 1.0, "torsion": 0.5}, {"at": 1.0, "bending_y": 2.0, "torsion": 0.8}]
ORDER, SECTION = 'order = "exact"', "section = { rhoA = 1.0, EIz = 1.0 }\n"
MODES, JOINT = "modes = { bending_y = 2 }\n", 'joint = { axes = ["z"] }\n'
REST = "rest = { bending_y = 1.0 }\n"
STEP = "rest = [{ at = 0.0, bending_y = 0.0 }, { at = 0.5, bending_y = 0.0 }, { at = 0.5, bending_y = 2.0 }, "
STEP += "{ at = 1.0, bending_y = 0.0 }]\n"
WRONG = [
    (ORDER, 'order = "exakt"', 'order: is "exakt"; it must be 1, 2 or "exact"'),
    (ORDER, "order = 3", 'order: is 3; it must be 1, 2 or "exact"'),
    (ORDER, f"{ORDER}\nsection_rotation = false", "order: .*but its sections turn; leave one of them out"),
    ("= 2 }", "= 2, points = 2 }", "points .*: is 2; it must be at least 3"),
    ("= 2 }", "= 2, points = 99 }", "points .*: is 99; it must be a whole number from 2 to 40"),
    ("= 2 }", "= 2, points = true }", "points .*: is true; it must be a whole number"),
    (JOINT, f'{JOINT}order = "Exact"\n', r'links\[0\].order \(link rod\): is "Exact"; it must be 1, 2 or "exact"'),
    (MODES, 'order = "exact"\n', "order .link rod.: is stated for a rigid link; state modes with it"),
    (MODES, "modes = { points = 5 }\n", "modes.points .link rod.: is stated for a rigid link; state modes with it"),
    (SECTION, "", "section .link rod.: is missing; state the section"),
    (", EIz = 1.0", "", "section.EIz .link rod.: is missing, but modes.bending_y needs it; it must be > 0"),
    ("length = 1.0\n", "", "length .link rod.: is missing; state the length of the centreline, m"),
    ("= 2 }", "= 2, points = 5.5 }", "modes.points .link rod.: is 5.5; it must be a whole number from 2 to 40"),
    ("= 2 }", '= 2, points = "5" }', 'modes.points .link rod.: is "5"; it must be a whole number from 2 to 40'),
    ("= 2 }", "= 2, points = -3 }", "modes.points .link rod.: is -3; it must be a whole number from 2 to 40"),
    ("= 2 }", "= 2, point = 5 }", r"modes.point .link rod.: is an unknown key; did you mean points\?"),
    (JOINT, f"{JOINT}points = 5\n", "points .link rod.: is an unknown key here; it belongs in modes"),
    ("= 2 }", "= 2, points = 5 }\norder = 1", "modes.points .link rod.: is stated of a link that is not of order"),
    (GOOD, GOOD.replace(ORDER, "order = 2").replace("= 2 }", "= 2, points = 6 }"), "points .*: is stated of a link"),
    (JOINT, f"{JOINT}rest = {{}}\n", "rest .link rod.: states nothing; state bending_y, bending_z or torsion"),
    (
        JOINT,
        f"{JOINT}rest = {{ bending_x = 1.0 }}\n",
        r"rest.bending_x .link rod.: is an unknown key; did you mean ben",
    ),
    (JOINT, f"{JOINT}rest = {{ bending_y = 1e7 }}\n", "rest.bending_y .link rod.: is 10000000.0; it must be from -1e"),
    (JOINT, f"{JOINT}rest = [{{ at = 0.0, torsion = 1.0 }}]\n", "rest .link rod.: has 1 stations; it must have from 2"),
    (JOINT, f"{JOINT}rest = 2.0\n", "rest .link rod.: is 2.0; it must be a table of bending_y, bending_z, torsion"),
    (JOINT, f"{JOINT}{STEP}", r"rest\[2\].at .link rod.: is 0.5 again, a step within a segment of the link; state seg"),
    (JOINT, f"{JOINT}{STEP.replace('2.0 }', '2.0, torsion = 1.0 }')}", r"rest\[0\].torsion .*: is missing; station 2"),
    (JOINT, f"{JOINT}{REST}frame_at = 0.1\n", "rest .link rod.: is stated beside frame_at, but the frame of a curved"),
    (GOOD, GOOD.replace(ORDER, "") + REST, 'rest .link rod.: is stated of a link of order 1, .* state order = "exact"'),
    (MODES, REST, "rest .link rod.: is stated for a rigid link; state modes with it, or leave it out"),
    (
        ", EIz = 1.0 }\nmodes = { bending_y = 2 }",
        f" }}\nmodes = {{ bending_y = 1, frequencies = {{ bending_y = [2.0] }} }}\n{REST}",
        "rest .link rod.: is stated beside modes.frequencies, but measured frequencies are those of a straight rod",
    ),
    (JOINT, f"{JOINT}damping = {{}}\n", "damping .link rod.: states nothing; state ratio or time"),
    (JOINT, f"{JOINT}damping = {{ time = -1 }}\n", "damping.time .link rod.: is -1; it must be >= 0"),
]
"""What replaces a part of the good file, and what is said."""


@pytest.mark.parametrize("old, new, said", WRONG)
def test_wrong_files_are_refused_in_a_line(old, new, said):
    loads(GOOD, "arm.toml", ".")
    with pytest.raises(RobotFileError, match=f"^arm.toml: .*{said}") as error:
        loads(GOOD.replace(old, new), "arm.toml", ".")
    assert "\n" not in str(error.value)


def test_bodies_from_files_are_not_exact(tmp_path):
    with pytest.raises(RobotFileError, match=r'order.*: is "exact", which only rods are; leave it out beside body'):
        Robot(**arm_of(tmp_path, free_cloud(3), order="exact"))


def test_a_link_that_loses_its_modes_is_no_longer_exact():
    model = bent(3, order="exact")
    rigid = model.robot.without("bending_y")
    assert rigid.links[0].order is None and Robot.model_validate(rigid.model_dump()) == rigid


def test_the_line_of_a_bent_rod_ends_at_its_tip():
    """Where plots and tables put the centreline and where the dynamics puts the tip are one place."""
    for model in (bent(), bent(frame_at=0.2), bent(segments=2), bent(rest=CURVED), bent(rest=CURVED, segments=2)):
        q = np.random.default_rng(3).normal(size=model.nq) * 0.2
        assert np.allclose(centrelines(model, q, [0.0, 1.0])[0, 1], model.numpy().tip_pose(q)[1], atol=1e-14)
        still = np.zeros((1, model.nq))
        assert np.abs(displacements(model, still, 0, [0.0, 0.3, 1.0])).max() < 1e-15


def test_a_circle_with_one_mode():
    """The strain of one mode is constant: with a slope of 2 pi at the tip the rod is a circle."""
    model = bent(1)
    slope = model.chain.keys[0].shapes("bending_y").tip_slope[0]
    R, _ = model.numpy().tip_pose([2 * np.pi / slope])
    assert np.abs(R - np.eye(3)).max() < 1e-14
    section = {"EIz": 1.0}
    rod = link("rod", 1.0, [], 1.0, {"bending_y": 1, "points": 14}, section=section)
    _, place = model_of(arm(rod, gravity=(0, 0, 0), order="exact")).numpy().tip_pose([2 * np.pi / slope])
    assert np.linalg.norm(place) < 1e-9


def test_points_make_the_mass_of_a_straight_rod_exact():
    """Combinations of tangents give the second moment of the rod, and its centre, with any number of points."""
    for count in (1, 3, 6):
        c = collocation(bent(count).chain.keys[0])
        tangents = np.ones(len(c.places))
        assert abs(np.sum((c.uniform @ tangents) ** 2) - 1 / 3) < 1e-14
        assert abs(c.centre @ tangents - 0.5) < 1e-14 and abs(c.reach(0.3) @ tangents - 0.3) < 1e-14


def test_turns_have_one_cross_product_for_three_modes():
    """Two with five; in a plane none, since its axes are parallel."""

    def products(**modes):
        section = {"EIy": 1.0, "EIz": 1.0, "GJ": 1.0, "rhoIp": 1e-3}
        rod = link("rod", 1.0, [], 1.0, modes, section=section)
        return len(collocation(model_of(arm(rod, order="exact")).chain.keys[0]).turn(0.2, 0.5).crossed)

    assert products(bending_y=3, bending_z=3) == products(bending_y=2, bending_z=3, torsion=2) == 1
    assert products(bending_y=5, bending_z=5, torsion=1) == 2 and products(bending_y=4) == 0


def test_documents_show_the_recursion():
    text = document.tex(document.content(bent().robot))
    for title in ("Section of the rod", "Mass of the rod", "Load of a section on the modes"):
        assert title in text
    assert re.search(r"collocated at the 5\s+Gauss points", text)


@pytest.mark.parametrize("rest", [None, {"bending_y": -2.5, "torsion": 1.0}, CURVED])
def test_the_page_bends_rods_as_far_as_the_model_does(rest):
    """The sections that the page integrates, bent by 0.4 of the length, against the centreline of 12 points."""
    modes, section = {"bending_y": 3, "points": 12}, {"EIy": 1.0, "EIz": 1.0}
    rod = link("rod", 1.0, [], 1.0, modes, section=section, **({"rest": rest} if rest else {}))
    model = model_of(arm(rod, gravity=(0, 0, 0), order="exact"))
    q = np.zeros(model.nq)
    q[model.chain.eta_q :] = [0.4, 0.05, -0.004]
    drawn = Bend(scene(model)["links"][0])
    sections = drawn.sections(q)
    line = centrelines(model, q, drawn.places)[0]
    R, r = (x[0] for x in model.numpy().link_pose(q))
    assert r + (drawn.straight + sections[:, :3]) @ R.T == pytest.approx(line, abs=1e-4)


def soft(section: dict, **joint) -> dict:
    """A rod of two modes on two axes, with a body at its tip."""
    body = {"at": "tip", "mass": 0.4, "com": [0.05, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.0, 0.0, 0.0]}
    more = {"modes": {"bending_y": 1, "bending_z": 1}, "bodies": [body], "damping": {"time": 0.01}}
    return link("boom", 0.8, "yz", section=section, joint={"damping": [0.1, 0.1], **joint}, **more)


def test_predictive_control_reaches_its_goal(tmp_path):
    (tmp_path / "mpc.toml").write_text(PLAIN.replace("[0.3, 0.2, -0.2]", "[0.2, 0.1]").replace(", 4.0]", "]"))
    rod = soft({"EIy": 300.0, "EIz": 500.0}, armature=[0.5, 0.5])
    model = model_of(arm(rod, order="exact", gravity=(0, 0, 0)))
    c, stepper = model.mpc(tmp_path / "mpc.toml", flags=QUICK), quick(model)
    q, v = np.zeros(4), np.zeros(4)
    c.initialise(q, v)
    for _ in range(60):
        c.prepare()
        q, v = stepper.step(q, v, c.feedback(q, v), None, 0.002, "modal_midpoint", 10)
    assert np.abs(q[:2] - [0.2, 0.1]).max() < 0.02


def test_the_place_of_the_tip_in_linear_models_equals_differences():
    """About a bent posture."""
    model, q, e = model_of(arm(soft({"EIy": 2.0, "EIz": 1.5}), order="exact")), np.array([0.6, -0.4, 0.2, -0.2]), 1e-6
    place = lambda s: model.numpy().tip_pose(q + s)[1]  # noqa: E731
    expected = np.array([(place(s) - place(-s)) / (2 * e) for s in e * np.eye(4)]).T
    assert relative(model.linearise(q, outputs=("tip_position",)).C[:, :4], expected) < 1e-8
