"""Files and arms whose loops are refused: each in one line that names what is wrong."""

import pytest
from bad_robot_files import GOOD, refused
from helpers import arm, link, model_of

from screwgen import UsageError

LOOP = '[[loops]]\nbetween = ["upper.tip", "fore.tip"]\njoint = { axes = ["y"] }\n'
WRONG = (
    ('["upper.tip", "fore.tip"]', '["upper.tip"]', "loops[0].between", "has 1 entries; it must name two markers"),
    ('["upper.tip", "fore.tip"]', '"upper.tip"', "loops[0].between", "must be an array of two markers"),
    ('"upper.tip"', '"upper"', "loops[0].between[0]", "must be the name of a link with that of its marker"),
    ('"upper.tip"', '"upper.hook"', "loops[0].between[0]", 'no marker of link \'upper\'; choose "base" or "tip"'),
    ('"upper.tip"', '"world.tip"', "loops[0].between[0]", "anchor the loop by a link with axes = [] whose parent is"),
    ('"upper.tip"', '"lower.tip"', "loops[0].between[0]", 'which is no link; choose "upper" or "fore"'),
    ('"upper.tip"', '"fore.tip"', "loops[0].between", "joins a link with itself"),
    ('axes = ["y"]', 'axes = ["y"], armature = [1.0]', "loops[0].joint.armature", "nothing drives a loop's joint"),
    ('axes = ["y"]', 'axes = ["y"], mount = {}', "loops[0].joint.mount", "sits at its first marker"),
    ('["y"]', '[{ screw = "y", pitch = 0.1 }]', "loops[0].joint.axes[0]", "is a screw, which no loop can have"),
    ('["y"]', '["y", { slide = "x" }]', "loops[0].joint.axes[1]", "put it first"),
    ("joint =", "stabilisation = -1.0\njoint =", "loops[0].stabilisation", "must be"),
    ("joint =", "damping = 1.0\njoint =", "loops[0].damping", "is an unknown key"),
    ("[[loops]]", "[loops]", "loops", "must be an array"),
    ("[[loops]]", "[[loop]]", "loop", "is an unknown key; did you mean loops?"),
    ('between = ["upper.tip", "fore.tip"]\n', "", "loops[0].between", "is missing; state the markers"),
    ('joint = { axes = ["y"] }', "", "loops[0].joint", "is missing; state the motions that the loop leaves free"),
    ('{ axes = ["y"] }', '["y"]', "loops[0].joint", "is an array of 1; it must be a table of axes"),
    ('"upper.tip"', "3", "loops[0].between[0]", "is 3; it must be the name of a link with that of its marker"),
    ('"fore.tip"', '"world.tip"', "loops[0].between[1]", "is a place of the world; anchor the loop by a link"),
    ('["y"]', '["q"]', "loops[0].joint.axes[0]", 'is "q"; it must be "x", "y", "z", an array'),
    ('["y"]', '["y", "y"]', "loops[0].joint.axes[1]", "is parallel to the axis before it"),
    ('["y"]', '["x", "y", "z", { slide = "x" }]', "loops[0].joint.axes", "has 4 axes; at most 3 are allowed"),
    ("joint =", 'stabilisation = "fast"\njoint =', "loops[0].stabilisation", 'is "fast"; it must be a number'),
    ("joint =", "stabilization = 20.0\njoint =", "loops[0].stabilization", "did you mean stabilisation?"),
)


@pytest.mark.parametrize(("old", "new", "where", "fragment"), WRONG)
def test_wrong_loops_are_refused_in_one_line(tmp_path, old, new, where, fragment):
    refused(tmp_path, GOOD + LOOP.replace(old, new, 1), where, fragment)


@pytest.mark.parametrize("axes", [["y"], ["x", "y", "z"]])
def test_a_loop_that_no_motion_closes_is_refused(axes):
    """A planar linkage whose two halves lie side by side: the row that its joints cannot change is open."""
    bars = [link("crank", 0.3, "y"), link("coupler", 0.9, "y"), link("rocker", 0.6, "y") | {"parent": "world"}]
    loop = {"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": axes}}
    bars[2]["joint"]["mount"] = {"xyz": [0.8, 0.0, 0.0]}
    assert len(model_of(arm(*bars) | {"loops": [loop]}).chain.closing.rows) == 2
    bars[2]["joint"]["mount"] = {"xyz": [0.8, 0.1, 0.0]}
    with pytest.raises(UsageError, match=r"^robot 'arm': loop\[0\], distance along y: stays open by 0.1 m"):
        model_of(arm(*bars) | {"loops": [loop]})


def test_welded_links_that_do_not_meet_are_refused():
    apart = link("b", 0.3, []) | {"parent": "world"}
    apart["joint"]["mount"] = {"xyz": [0.0, 0.2, 0.0]}
    weld = {"between": ["a.tip", "b.tip"], "joint": {"axes": []}}
    with pytest.raises(UsageError, match=r"stays open by 0\.2 m wherever the other rows are closed; move a mount"):
        model_of(arm(link("a", 0.3, []), apart) | {"loops": [weld]})
