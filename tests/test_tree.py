"""Trees: what several links hand to one node is summed, in every back end and form."""

import tomllib

import numpy as np
import pytest
from conformance import slopes
from helpers import model_of
from latex_documents import WHOLE
from matplotlib.text import Text
from mixed_arms import case_of
from random_robots import random_state

from screwgen import Robot, UsageError, derive, simulate
from screwgen.algorithms.fused import forward_dynamics
from screwgen.backends.latex import document as latex
from screwgen.plotting import mode_plot, plot
from screwgen.simulation.motion import centrelines
from screwgen.spec import dump
from screwgen.studies.modes import mode_shapes
from screwgen.topology.tree import Tree

SECTION = {"rhoA": 1.5, "EIy": 900.0, "EIz": 700.0}
BRANCHES = [
    {"axes": ["z"], "mount": {"xyz": [0.1, 0.0, 0.0]}},
    {"axes": ["y"], "mount": {"xyz": [0.0, -0.2, 0.1], "rpy": [0.3, 0.0, 0.2]}},
]


def rod(name: str, joint: dict, length=0.7, **more) -> dict:
    modes = {"bending_y": 2, "bending_z": 1}
    return {"name": name, "length": length, "section": SECTION, "modes": modes, "joint": joint, **more}


def tree(*links: dict) -> dict:
    return {"name": "tree", "gravity": [0.0, 1.0, -9.81], "links": list(links)}


def arm(*links: dict):
    return model_of(tree(*links))


FORK = tree(
    rod("trunk", {"axes": ["y"]}),
    *(rod(name, joint, parent="trunk") for name, joint in zip(("left", "right"), BRANCHES, strict=True)),
)
"""A trunk with two branches at its tip."""


@pytest.fixture
def forked():
    return model_of(FORK)


def test_a_child_must_come_after_its_parent():
    with pytest.raises(ValueError, match="must come after"):
        Tree((-1, 2, 0))


@pytest.mark.parametrize("check", [slopes.dynamics, slopes.wrenches])
def test_derivatives_are_those_of_differences(check):
    check(case_of(FORK, random_state(np.random.default_rng(5), FORK)))


# -------- the robot file, and what users see


def test_arms_on_the_world_do_not_know_of_each_other():
    alone = arm(rod("left", BRANCHES[0]), rod("fore", {"axes": ["z"]}))
    twin = [rod("right", BRANCHES[0], parent="world"), rod("other", {"axes": ["z"]})]
    both = arm(rod("left", BRANCHES[0]), rod("fore", {"axes": ["z"]}), *twin)
    assert both.chain.tree.parents == (-1, 0, -1, 2)
    rng = np.random.default_rng(6)
    joints, modes = (rng.normal(size=2), 1e-2 * rng.normal(size=6)), rng.normal(size=(2, 6))
    one = [np.append(x, y) for x, y in ((joints[0], joints[1]), (joints[0], modes[0]))]
    two = [np.concatenate([x[:2], x[:2], x[2:], x[2:]]) for x in one]
    expected, _ = alone.numpy().forward_dynamics(*one, np.ones(2), np.zeros((2, 6)))
    found, _ = both.numpy().forward_dynamics(*two, np.ones(4), np.zeros((4, 6)))
    assert np.allclose(found, np.concatenate([expected[:2], expected[:2], expected[2:], expected[2:]]), rtol=1e-12)
    counts = [forward_dynamics(m.chain).operation_count for m in (alone, both)]
    assert counts[1] <= 2.02 * counts[0]


def test_a_tree_survives_its_file(forked):
    text = dump(forked.robot)
    assert text.count('parent = "trunk"') == 2 and "at" not in tomllib.loads(text)["links"][1]
    again = Robot.model_validate(tomllib.loads(text))
    assert again == forked.robot and derive(again).chain.tree.parents == (-1, 0, 0)


def test_pictures_draw_every_branch_from_the_tip_that_carries_it(forked):
    run = simulate(forked, 0.01, 1e-3)
    figure = plot.figure(run, forked)
    space = next(axes for axes in figure.axes if hasattr(axes, "get_zlim"))
    starts = [np.array(line.get_data_3d()).T[0] for line in space.lines if len(line.get_data_3d()[0]) == 18]
    tip = centrelines(forked, run.q[-1], [1.0])[0, 0]
    assert len(starts) == 15 and np.allclose(starts[-3:], [np.zeros(3), tip, tip]) and np.linalg.norm(tip) > 0.6
    assert any("path of its tip, right" in text.get_text() for text in figure.findobj(Text))
    found = mode_shapes(forked, np.zeros(forked.nq), "locked")
    drawn = next(a for a in mode_plot.figure(forked, np.zeros(forked.nq), found).axes if hasattr(a, "get_zlim"))
    assert sum(line.get_marker() == "D" for line in drawn.lines) == 4  # two tips, at rest and moved


def test_the_header_and_the_document_of_a_tree_name_its_parents(forked, tmp_path):
    forked.write(tmp_path / "out", targets=("c",), layout="modular")
    header = (tmp_path / "out" / "c" / "tree.h").read_text()
    assert "TREE_LINK_RIGHT = 2 /* on trunk */" in header and "TREE_LINK_TRUNK = 0, /* on the base */" in header
    text = latex.document(forked.robot, (), WHOLE)
    assert "The links form a tree." in text and r"on \texttt{trunk}" in text and "Z-form" not in text
    assert r"\mathbf{P}_{\mathcal{W},3}" in text


def test_what_is_of_chains_alone_is_refused_on_trees(forked):
    assert "assemble_z" not in forked.casadi()
    with pytest.raises(UsageError, match="the Z-form is that of a chain on a fixed base"):
        _ = forked.cauchy_names
    with pytest.raises(UsageError, match="the paper's arm is a chain; leave out parent, or the formulation"):
        derive(forked.robot, formulation="printed")
