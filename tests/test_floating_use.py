"""Floating bases, as users meet them: C, names, runs, figures, and what is refused in one line."""

import copy
import re
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from floating_robots import SATELLITE
from helpers import example, example_file, model_of, quick
from latex_documents import WHOLE
from random_robots import to_toml

from screwgen import PD, SingularError, UsageError, derive, simulate
from screwgen.backends.latex import document as latex
from screwgen.errors import RobotFileError
from screwgen.plotting import plot
from screwgen.runtime.stepper import CompiledStepper
from screwgen.simulation.controller_files import read_pd
from screwgen.simulation.controllers import Holding
from screwgen.simulation.motion import centrelines
from screwgen.spec import load
from screwgen.spec.base import TWIST
from screwgen.spec.parameters import coordinate_units
from screwgen.studies.modes import natural_frequencies
from screwgen.studies.stiffness import stiffness_matrix


@pytest.fixture(scope="module")
def satellite():
    return model_of(SATELLITE)


def test_the_header_of_the_c_counts_the_pose(satellite, tmp_path):
    satellite.write(tmp_path / "out", targets=("c",))
    header = (tmp_path / "out" / "c" / "satellite.h").read_text()
    assert "SATELLITE_NPOSE = 7" in header and "q[7], v[6]  left.joint[0]" in header


def test_names_and_units_begin_with_the_base(satellite):
    assert satellite.q_names[:8] == [*(f"base.{x}" for x in ("x", "y", "z", "qw", "qx", "qy", "qz")), "left.joint[0]"]
    assert satellite.v_names[:7] == [*(f"base.{x}" for x in TWIST), "left.joint_rate[0]"]
    assert satellite.tau_names[0] == "left.torque[0]" and satellite.wrench_names[0] == "hull.tau_x"
    assert (satellite.nq, satellite.nv, satellite.chain.n_tau) == (17, 16, 4)
    assert coordinate_units(satellite.robot)[:8] == ["m", "m", "m", "1", "1", "1", "1", "rad"]


def test_a_run_starts_at_the_joints_alone_and_a_law_moves_them(satellite):
    law = PD((4.0, 1.0, 1.0, 0.02), (3.5, 0.6, 0.6, 0.015), (0.2, -0.1, 0.1, 0.2))
    form = partial(CompiledStepper, quick(satellite))
    run = simulate(satellite, 6.0, 4e-3, [0.1] * 4, None, law, form=form, integrator="modal_midpoint")
    assert np.allclose(run.q[0, :11], [0, 0, 0, 1, 0, 0, 0, 0.1, 0.1, 0.1, 0.1])
    assert np.allclose(run.q[-1, 7:11], law.q_des, atol=5e-3)
    titles = [axes.get_title(loc="left") for axes in plot.figure(run, satellite, law).axes]
    assert "Base, inertial frame" in titles and "Turn of the base" in titles
    assert 1e-3 < np.linalg.norm(run.q[-1, :3]) < 0.2
    place = centrelines(satellite, run.q[-1], [0.0, 1.0])
    assert np.allclose(place[0], run.q[-1, :3]) and np.linalg.norm(place[2, 1] - place[0, 0]) > 0.8


def test_the_space_arm_of_the_examples_moves_by_its_law_and_keeps_its_momentum_at_zero():
    model = example("space_arm")
    law = replace(read_pd(example_file("space_arm").with_name("space_arm_law.toml"), model), waypoints=())
    law = replace(law, duration=0.4)
    assert law.through(model.chain, model.parameter_values).ahead == 1 and (model.nq, model.n_tau) == (31, 6)
    form = partial(CompiledStepper, quick(model))
    run = simulate(model, 0.4, 1e-3, controller=law, form=form, integrator="rk4")
    M, v = model.numpy().mass_matrix(run.q[-1]), run.v[-1]
    assert np.abs(run.q[-1, 7:13]).max() > 0.1 and np.linalg.norm(run.q[-1, :3]) > 1e-3
    assert np.all(np.abs((M @ v)[:6]) < 1e-8 * (np.abs(M) @ np.abs(v))[:6])


JOINT, PARENT, MORE = "links[0].joint", "links[{}].parent: is ", {"axes": []}
WRONG = [  # the place of what is stated otherwise, what is stated there, and what the message says
    ("base", "free", 'base: is "free"; it must be "fixed" or "floating"'),
    ("base", True, "base: is true; it must be"),
    ("base", ["floating"], "base: is an array of 1; it must be"),
    ("base", "Floating", 'base: is "Floating"; it must be "fixed" or "floating"'),
    ("base", "", 'base: is ""; it must be "fixed" or "floating"'),
    ("base", {"kind": "floating"}, 'base: is a table; it must be "fixed" or "floating"'),
    ("base", 0, 'base: is 0; it must be "fixed" or "floating"'),
    ("0.joint", {"axes": ["z"]}, f"{JOINT}.axes: is stated for the first link, which a floating base leaves without"),
    ("0.joint", {"axes": [{"slide": "x"}]}, f"{JOINT}.axes: is stated"),
    ("0.joint", MORE | {"mount": {"xyz": [0.0, 0.0, 1.0]}}, f"{JOINT}.mount: is stated for the first link"),
    ("0.joint", MORE | {"armature": [1.0]}, f"{JOINT}.armature"),
    ("0.joint", MORE | {"damping": [0.1]}, f"{JOINT}.damping: has length 1; it must hold one number per axis, 0"),
    ("0.joint", MORE | {"drives": [{}]}, f"{JOINT}.drives: has length 1; it must hold one table per axis, 0"),
    ("0.joint", MORE | {"position": [0.0, 0.0, 1.0]}, f"{JOINT}.position: is an unknown key; known here: axes"),
    ("0.joint", {}, f"{JOINT}.axes: is missing; state the axes in order"),
    ("0.joint", None, f"{JOINT}: is missing"),
    ("0.parent", "hull", PARENT.format(0) + '"hull", which is the link itself'),
    ("0.parent", "left", PARENT.format(0) + '"left", which comes later'),
    ("0.parent", "base", PARENT.format(0) + '"base", which is no link; a link comes after the one that carries it'),
    ("1.parent", "world", PARENT.format(1) + "the world, but of a robot with base"),
    ("2.parent", "world", PARENT.format(2) + "the world, but of a robot with base"),
    ("2.parent", "right", PARENT.format(2) + '"right", which comes later'),
    ("1.base", "floating", "links[1].base: is an unknown key here; it belongs at the top, above links; known"),
]


@pytest.mark.parametrize(("place", "value", "said"), WRONG)
def test_a_wrong_file_is_refused_in_one_line(place, value, said, tmp_path):
    robot = copy.deepcopy(SATELLITE)
    link, _, key = place.rpartition(".")
    table = robot["links"][int(link)] if link else robot
    table[key] = value
    if value is None:
        del table[key]
    (tmp_path / "bot.toml").write_text(to_toml(robot))
    with pytest.raises(RobotFileError) as refused:
        load(tmp_path / "bot.toml")
    message = re.sub(r" \(link \w+\)", "", str(refused.value))
    assert said in message and "\n" not in message


def test_what_needs_a_fixed_base_says_so(satellite):
    calls = {
        "table of modes under loads": lambda: natural_frequencies(satellite, loaded=True),
        "torque that holds it": lambda: Holding(satellite),
    }
    for what, call in calls.items():
        with pytest.raises(
            UsageError, match=f"'satellite' has a floating base, for which there is no {what}.*; "
        ) as said:
            call()
        assert "\n" not in str(said.value)
    with pytest.raises(UsageError, match="Z-form is that of a chain on a fixed base"):
        _ = satellite.cauchy_names
    with pytest.raises(UsageError, match=r"arm is a chain|floating base"):
        derive(satellite.robot, formulation="printed")
    K = stiffness_matrix(satellite)  # which modes of a free robot are found with
    assert K.shape == (16, 16) and not K[:10].any() and np.all(np.diag(K)[10:] > 0)
    assert not {"assemble_z", "cauchy"} & set(satellite.casadi())


def test_states_that_are_no_states_are_refused(satellite):
    for q, said in (
        ([0.0] * 17, "quaternion of length 0"),
        ([1.0] * 17, "quaternion of length 2"),
        ([0.0] * 5, "length 5"),
    ):
        with pytest.raises(UsageError, match=said):
            simulate(satellite, 0.01, 1e-3, q)
    with pytest.raises(UsageError, match="v0 has length 17; it must have 16 numbers, or the 4 of the joints alone"):
        simulate(satellite, 0.01, 1e-3, None, [0.0] * 17)
    point = {**SATELLITE, "links": [{**SATELLITE["links"][0], "bodies": [{"at": "base", "mass": 1.0}]}]}
    model = model_of(point)
    with pytest.raises(SingularError, match=r"has no inertia about some axis .* give link 'hull' a body"):
        model.numpy().forward_dynamics(model.chain.home, np.zeros(6), [], np.zeros((1, 6)))


def test_the_document_shows_the_pose_and_its_rates(satellite):
    text = latex.document(satellite.robot, (), WHOLE)
    assert r"\subsection{Floating base}" in text and r"\dot{\mathbf{Q}}_i" in text
