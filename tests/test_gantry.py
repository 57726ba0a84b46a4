"""The gantry of the examples, three slides and a swivel: units and names in all that users see, and its motions."""

import csv
from functools import partial

import numpy as np
import pytest
from helpers import QUICK, example, quick
from latex_documents import WHOLE

from screwgen import PD, NoEquilibriumError, equilibrium, simulate
from screwgen.backends.latex import document as latex
from screwgen.cli.main import main
from screwgen.plotting import plot
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.runtime.stepper import CompiledStepper
from screwgen.simulation.controllers import Holding
from screwgen.simulation.linearised import speed

GOALS = (1.6, 0.8, 0.5, 1.2)
WEIGHT = 9.81 * (25.0 + 2700.0 * np.pi / 4 * (0.06**2 - 0.054**2) * 1.8)
"""N: of boom and payload."""


@pytest.fixture(scope="module")
def model():
    return example("gantry")


def law(model, **more):
    return PD((9e3, 4e3, 4e3, 60.0), (2.5e3, 1e3, 900.0, 25.0), GOALS, gravity=Holding(model), **more)


@pytest.fixture(scope="module")
def run(model):
    control = law(model, duration=0.9, tau_max=(2e3, 400.0, 800.0, 40.0))
    form = partial(CompiledStepper, quick(model))
    return simulate(model, 2.0, 2e-3, controller=control, form=form, integrator="modal_midpoint"), control


def test_a_control_law_drives_the_slides_to_goals_in_metres(run):
    assert np.allclose(run[0].q[-1, :4], GOALS, atol=0.03)
    assert np.allclose(run[0].tip_position[-1], (1.6, 0.8, 0.1), atol=0.06)  # the boom still sways
    assert run[0].tau[-1, 2] == pytest.approx(-WEIGHT, rel=0.05)


def test_a_table_of_a_run_names_forces_of_slides(run, tmp_path):
    run[0].save(tmp_path / "run.csv")
    with open(tmp_path / "run.csv") as stream:
        head = next(csv.reader(stream))
    assert head[:5] == ["t", "bridge.slide[0]", "trolley.slide[0]", "boom.slide[0]", "swivel.joint[0]"]
    assert {"boom.slide_rate[0]", "swivel.joint_rate[0]", "trolley.force[0]", "swivel.torque[0]"} < set(head)


def test_a_figure_of_a_run_has_panels_in_metres_and_newtons(run, model):
    figure = plot.figure(run[0], model, run[1])
    panels = {axes.get_title(loc="left") or axes.get_title(): axes for axes in figure.axes}
    labels = {title: axes.get_ylabel() for title, axes in panels.items()}
    assert labels["Slides"] == "q (m)" and labels["Forces on slides"] == "f (N)"
    assert labels["Joint angles"] == "q (rad)" and labels["Joint torques"] == "τ (N·m)"
    drawn = [len(panels[title].lines) for title in ("Slides", "Joint angles")]
    assert drawn == [6, 2]  # each coordinate with its set point
    legends = [axes.get_legend() for axes in figure.axes if axes.get_legend()]
    assert "limit of the drive" in [text.get_text() for legend in legends for text in legend.texts]


def test_an_equilibrium_states_the_forces_that_hold_slides(model, capsys):
    held = equilibrium(model, GOALS, hold=True)
    assert held.tau == pytest.approx([0, 0, -WEIGHT, 0], abs=1e-9) and "of slides force, N" in held._repr_html_()
    with pytest.raises(NoEquilibriumError, match=r"^boom\.slide\[0\]: no posture found balances its load;"):
        equilibrium(model)
    with pytest.raises(NoEquilibriumError, match=r"^bridge\.slide\[0\]: .* its force of 5 N;"):
        equilibrium(model, tau=[5.0, 0.0, -WEIGHT, 0.0])
    assert main(["equilibrium", "examples/gantry.toml", "--hold"]) == 0
    text = capsys.readouterr().out
    assert "joint coordinates, held\n  bridge.slide[0]                       0 m\n" in text
    assert "torques and forces that hold them\n  bridge.force[0]                       0 N\n" in text


def test_a_spring_holds_a_slide_where_its_force_is_the_weight(model):
    boom = model.robot.links[2]
    joint = boom.joint.model_copy(update={"stiffness": (2e4,)})
    links = [*model.robot.links[:2], boom.model_copy(update={"joint": joint}), model.robot.links[3]]
    sprung = type(model)(model.robot.model_copy(update={"links": tuple(links)}))
    rest = equilibrium(sprung, hold=True)
    assert rest.q[2] == pytest.approx(WEIGHT / 2e4) and rest.passive == ("boom.slide[0]",)


def test_a_linear_model_has_units_of_slides(model):
    linear = model.linearise(np.zeros(4), outputs=["joint_angles", "joint_rates"], inputs=["boom.tau", "swivel.tau"])
    assert linear.input_names == ("boom.force[0]", "swivel.torque[0]") and linear.input_units == ("N", "N·m")
    assert linear.output_units == ("m", "m", "m", "rad", "m/s", "m/s", "m/s", "rad/s")


def test_an_analysis_takes_rates_of_slides_for_no_turning(model):
    v = np.zeros(model.nq)
    v[:4] = (3.0, 2.0, 1.0, 0.25)
    assert speed(model, v) == 0.25


def test_the_header_of_the_generated_c_states_units(model, tmp_path):
    model.write(tmp_path / "out", targets=("c", "casadi"), estimator=True)
    header = (tmp_path / "out" / "c" / "gantry.h").read_text()
    for line in (
        " *   q[0], v[0]  bridge.slide[0] (m)\n",
        " *   q[3], v[3]  swivel.joint[0] (rad)\n",
        "armature[1]; /* kg*m^2, of slides kg: rotor inertia seen at the joint axis */",
        "damping[1]; /* N*m*s/rad, of slides N*s/m: viscous damping about the joint axis */",
        "/* N*m, of slides N: torque about, or force along, each joint axis, in the order of q */",
        "/* rad, of slides m: joint coordinates */",
    ):
        assert line in header
    measured = (tmp_path / "out" / "c" / "gantry_estimator.h").read_text()
    assert "encoder (rad, of slides m): the coordinates of axes" in measured
    assert "forces of slides" in (tmp_path / "out" / "casadi" / "README.md").read_text()
    text = latex.document(model.robot, (), WHOLE)
    assert r"\mathbf{I}_6 - \mathbf{S}_i\mathbf{S}_i^{+}" in text and r"\mathbf{A}_i^{+}\,\boldsymbol{\tau}" not in text


@pytest.mark.parametrize("binding", ["runtime", "baked"])
def test_the_estimator_finds_a_payload_that_sways_below_encoders_in_metres(model, binding):
    truth = simulate(model, 0.6, 1e-3, controller=lambda t, q, v: (400.0 * np.cos(8 * t), 0.0, -WEIGHT, 0.0))
    noise = Noise(np.r_[np.full(4, 1.0), np.full(5, 0.1)], 1e-12, encoder=1e-4, strain=2e-6, fibre=0.03)
    estimator = CompiledEstimator(model, binding=binding, flags=QUICK)
    still = np.zeros((4, 6))
    wrong = np.r_[np.full(4, 0.02), 0.01, np.zeros(4)]
    estimator.start(wrong, np.zeros(model.nq), np.full(model.nq, 0.05), np.full(model.nq, 0.05), noise)
    for tau, q in zip(truth.tau[:-1], truth.q[1:], strict=True):
        estimator.predict(tau, still, 1e-3)
        estimator.update(tau, still, encoder=q[:4])
    assert np.allclose(estimator.state[0][:4], truth.q[-1, :4], atol=1e-4)
    assert np.allclose(estimator.state[0][4:8], truth.q[-1, 4:8], atol=2e-4)
