"""The sketch of a robot: what has a label, where labels stand, and what SVG and LaTeX make of them."""

import os
import re
import subprocess
import sys
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from document_robots import FOUR_BAR, arm, branched, coupled, joint, looped, of, tendons, varying
from helpers import example_file

from screwgen import Robot, load
from screwgen.backends.latex.document import chain_of
from screwgen.backends.latex.drawing import Drawing, DrawnLabel, Stroke, dashes, outside
from screwgen.backends.latex.drawing_writers import picture, svg
from screwgen.backends.latex.label_places import Wish, overlaps, placed
from screwgen.backends.latex.sketch import figure, sketch
from screwgen.backends.latex.sketch_pen import Pen
from screwgen.backends.latex.sketch_pose import drawn as numeric_of
from screwgen.backends.latex.sketch_pose import drawn_lengths, poses
from screwgen.backends.latex.sketch_view import views
from screwgen.spec.parameters import coordinate_names

EXAMPLES = """balanced_arm bucket crane crane_loop elastic_joint ella finger_on_wall flexible_arm gantry parallelogram
    six_link ship_crane soft_gripper space_arm tentacle""".split()
GEAR = {"ratio": 50.0, "rotor_inertia": 1e-3, "stiffness": 90.0}
CHANGES = {
    "ball": [joint(1, axes="ball")],
    "screw": [joint(1, axes=[{"screw": "z", "pitch": 0.1}, "y"])],
    "gear": [joint(0, drives=[GEAR]), joint(1, drives=[{"transmission": {"four_bar": FOUR_BAR}}])],
    "segments": [of(0, segments=5), varying, tendons],
    "tree": [branched, coupled, looped("fore.eye", "x", "y", "z")],
}


@cache
def robot(name: str) -> Robot:
    if name not in CHANGES:
        return load(example_file(name))
    stated = arm()
    for change in CHANGES[name]:
        change(stated)
    return Robot.model_validate(stated)


@cache
def drawn(name: str) -> Drawing:
    return sketch(chain_of(robot(name)))


@pytest.mark.parametrize("name", ["gantry", "elastic_joint", "screw"])
def test_axes_are_those_about_which_joints_move_what_they_carry(name):
    """A small change of a coordinate moves the link's tip as a screw about the axis that is drawn."""
    chain, h = chain_of(robot(name)), 1e-6
    numeric, pose = numeric_of(chain, drawn_lengths(chain)), poses(chain)[1]
    for part in pose.parts:
        for k, (axis, screw) in enumerate(zip(part.axes, chain.keys[part.number].screws, strict=True)):
            step = h * np.eye(chain.nq)[chain.q_offset[part.number] + k]
            there, back = (numeric.tip_poses(pose.q + s * step)[1][part.number] for s in (1, -1))
            moved = screw.turn * np.cross(axis, part.tip - part.joint) + screw.travel * axis
            assert (there - back) / (2 * h) == pytest.approx(moved, abs=1e-8)


@pytest.mark.parametrize("name", [*EXAMPLES, *CHANGES])
def test_every_coordinate_has_a_label_that_one_can_read(name):
    drawing = drawn(name)
    said = [x for label in drawing.labels for x in label.names]
    rates = [x.replace("_rate", "") for x in coordinate_names(robot(name)).v]
    stated = [x for x in rates if not x.startswith("base.")]
    assert len(set(said)) == len(said) and set(stated) <= set(said)
    assert list(overlaps(drawing.labels)) == []
    (width, height), corners = drawing.size, [p for stroke in drawing.strokes for p in stroke.points]
    corners += [corner for label in drawing.labels for corner in (label.box[:2], label.box[2:])]
    assert all(0 <= x <= width and 0 <= y <= height for x, y in corners)


def test_of_many_links_the_first_are_drawn():
    link = {"length": 0.3, "section": {"rhoA": 1.0, "rhoIp": 1e-3}, "joint": {"axes": ["y"]}}
    stated = {"name": "arm", "gravity": [0.0, 0.0, -9.81], "links": [{"name": f"l{k}", **link} for k in range(14)]}
    found = figure(chain_of(Robot.model_validate(stated)))
    texts = [label.text for label in found.drawing.labels]
    assert "…" in texts and "$q_{12}$" in texts and "$q_{13}$" not in texts
    assert found.caption.startswith("The first 12 links of the robot")


OTHER = """
import sys
from test_latex_sketch import drawn, picture
print(picture(drawn(sys.argv[1])))
"""


def test_the_rounding_errors_of_another_processor_change_nothing():
    """Where a loop leaves a joint free a search that rounds otherwise ends elsewhere; OpenBLAS acts that processor."""
    other = os.environ | {"OPENBLAS_CORETYPE": "Prescott", "PYTHONHASHSEED": "3"}
    command = [sys.executable, "-c", OTHER, "crane_loop"]
    done = subprocess.run(command, cwd=Path(__file__).parent, env=other, capture_output=True, text=True, check=True)
    assert done.stdout == picture(drawn("crane_loop")) + "\n"


@pytest.mark.parametrize("name", ["flexible_arm", "tree"])
def test_both_languages_have_the_same_labels_and_one_decimal(name):
    first = drawn(name)
    texts = ElementTree.fromstring(svg(first)).findall(".//{http://www.w3.org/2000/svg}text")
    assert len(texts) == picture(first).count(r"\makebox") == len(first.labels)
    numbers = re.findall(r"[-\d.]+", " ".join(re.findall(r'(?: d| x| y|cx|cy)="([^"]*)"', svg(first))))
    assert numbers and all(float(x) == round(float(x), 1) >= 0 for x in numbers)


def test_names_that_mean_something_to_a_language_are_written_as_they_are():
    label = DrawnLabel("link", "`a<&_%`: x<y & 5 % of_it", (50.0, 10.0), (90.0, 12.0), ('"<b>',))
    drawing = Drawing((100.0, 20.0), (Stroke("axis", ((0.0, 0.0), (9.0, 9.0))),), (), (label,))
    root = ElementTree.fromstring(svg(drawing))
    assert "".join(root[-1].itertext()) == '"<b>a<&_%: x<y & 5 % of_it'
    assert r"a<\&\_\%}: x<y \& 5 \% of\_it" in picture(drawing).replace(r"\cut{}", "")


@pytest.mark.parametrize("axis", [*np.eye(3).tolist(), [-0.3, 0.8, -0.5]])
def test_the_arc_of_a_turn_goes_counterclockwise_about_an_axis_towards_the_reader(axis):
    for view in views([0.0, 0.0, -9.81]):
        assert np.cross(view.right, view.up) == pytest.approx(view.towards)
        x, y = Pen(view, 100.0).flat(Pen(view, 100.0).circle(np.zeros(3), np.array(axis), 8.0)).T
        area = float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))
        assert np.sign(area) == np.sign(np.dot(axis, view.towards))


def test_labels_that_are_needed_find_a_place_in_any_crowd():
    labels, _ = placed([Wish("q", f"$q_{{{k}}}$", (5.0, 0.0)) for k in range(200)], [], [])
    assert [label.text for label in labels] == [f"$q_{{{k}}}$" for k in range(200)]
    assert list(overlaps(labels)) == []


def test_solids_hide_what_is_behind_them():
    square = np.array([[2.0, -1.0], [4.0, -1.0], [4.0, 1.0], [2.0, 1.0]])
    pieces = list(outside(np.array([[0.0, 0.0], [6.0, 0.0]]), [square]))
    assert [piece.tolist() for piece in pieces] == [[[0.0, 0.0], [2.0, 0.0]], [[4.0, 0.0], [6.0, 0.0]]]


def test_dashes_cover_their_share_of_a_line():
    found = list(dashes(((0.0, 0.0), (9.0, 0.0), (9.0, 9.0)), 2.0, 1.0))
    assert len(found) == 6
    assert sum(np.linalg.norm(np.diff(dash, axis=0), axis=1).sum() for dash in found) == pytest.approx(12.0, abs=0.6)
