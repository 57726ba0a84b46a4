"""Loops of control that are unstable at the step of a run are named, with the step, gain or rotor that would do."""

import re
import warnings
from pathlib import Path

import control_loops as loops
import numpy as np
import pytest
from helpers import arm, example_dict, link, model_of

import screwgen
from screwgen.cli.main import main
from screwgen.errors import DivergedError
from screwgen.simulation.captured_state import CapturedState
from screwgen.simulation.control_loop import ControlLoopWarning
from screwgen.simulation.controller_files import read_pd
from screwgen.simulation.controllers import PD
from screwgen.simulation.validity import ModelValidityWarning
from screwgen.studies.light_joints import SLOW, light_joints, steps_borne


@pytest.mark.parametrize("name", loops.UNSTABLE)
def test_an_unstable_loop_is_named_with_its_longest_step(name):
    """Within a factor of 1.5 of the limit that runs have: they are stable below it, and grow above."""
    case, model = loops.UNSTABLE[name], loops.model_of_case(name)
    (line,) = loops.said(lambda: loops.moved(model, case, case.step))
    assert "\n" not in line and "unstable at a step of" in line
    named = loops.named_step(line)
    assert not loops.grows(model, case, named / 1.5) and loops.grows(model, case, 1.5 * named)


@pytest.mark.parametrize("name", loops.STABLE)
def test_nothing_is_said_of_a_stable_loop_whose_links_bend_far(name):
    case, model = loops.STABLE[name], loops.model_of_case(name)
    with warnings.catch_warnings(record=True, action="always") as noted:
        run = loops.swung(model, case)
    assert not [w for w in noted if issubclass(w.category, ControlLoopWarning)]
    assert not run.validity.holds and [w for w in noted if issubclass(w.category, ModelValidityWarning)]
    assert np.isfinite(run.q).all()


# ------------------------------------------------------------------------------ what is named


def test_a_gain_that_is_named_is_the_largest_that_runs_bear():
    """On a boom's one joint, kd alone."""
    case, model = loops.UNSTABLE["a boom"], loops.model_of_case("a boom")
    (line,) = loops.said(lambda: loops.moved(model, case, case.step))
    kd = loops.named_gains(line)["kd[0]"]
    assert not loops.grows(model, case._replace(kd=(kd / 1.2,)), case.step)
    assert loops.grows(model, case._replace(kd=(1.2 * kd,)), case.step)


def test_a_rotor_that_is_named_is_the_least_that_runs_bear():
    case, model = loops.UNSTABLE["a boom"], loops.model_of_case("a boom")
    (line,) = loops.said(lambda: loops.moved(model, case, case.step))
    rotor = float(re.search(r"the inertia of the rotors?, ([\d.e-]+) kg·m² or more \(joint.armature\)", line)[1])
    with_one = lambda J: model_of(loops.boom({"axes": ["z"], "armature": [J]}))  # noqa: E731
    assert loops.grows(with_one(rotor / 1.5), case, case.step)
    assert not loops.grows(with_one(1.5 * rotor), case, case.step)


def test_an_integrator_that_fails_without_control_is_named_instead():
    case, model = loops.UNSTABLE["a boom"]._replace(integrator="rk4", step=20e-3), loops.model_of_case("a boom")
    (line,) = loops.said(lambda: loops.moved(model, case, case.step))
    assert line.startswith(
        "the integrator 'rk4' is unstable at a step of 20 ms, also without the controller: take modal"
    )
    assert loops.grows(model, case._replace(kp=(0.0,), kd=(0.0,)), case.step)
    assert not loops.grows(model, case, loops.named_step(line) / 1.1)


# ------------------------------------------------------------------------------ functions in Python


def test_a_function_that_remembers_is_as_it_was():
    """Its list, its sum and its array; the run that follows is that of a run without the examination."""
    model = loops.model_of_case("a boom")

    def law(state, seen, sums):
        def torque(t, q, v):
            nonlocal state
            state += 1
            seen.append(t)
            sums[0] += q[0]
            return [-3.0 * q[0] - 0.1 * v[0] - 1e-3 * sums[0]]

        return torque, seen

    torque, seen = law(0, [], np.zeros(1))
    assert CapturedState(torque).admissible
    screwgen.simulate(model, 0.01, 1e-3, q0=[0.2], controller=torque)
    assert seen == pytest.approx([0.0, *np.arange(11) * 1e-3])  # a run asks twice at its start
    assert 12 in [cell.cell_contents for cell in torque.__closure__ if isinstance(cell.cell_contents, int)]


def test_a_function_that_keeps_a_log_is_examined_and_its_log_is_that_of_the_run():
    case, model, log = loops.UNSTABLE["a boom"], loops.model_of_case("a boom"), []

    def torque(t, q, v):
        log.append(t)
        return [-30.0 * q[0] - 6.0 * v[0]]

    (line,) = loops.said(lambda: screwgen.simulate(model, 0.01, 1e-3, controller=torque))
    assert log == pytest.approx([0.0, *np.arange(11) * 1e-3])
    assert loops.named_step(line) < case.step


def test_what_a_function_may_not_see_keeps_it_from_being_asked():
    class Memory:
        called = 0

    memory = Memory()

    def objects(t, q, v):
        memory.called += 1
        return [-30.0 * q[0] - 6.0 * v[0]]

    def noise(t, q, v):
        return [np.random.normal()]

    gains = [3.0, 1.0]
    assert not CapturedState(objects).admissible and not CapturedState(noise).admissible
    assert CapturedState(lambda t, q, v: -gains[0] * q - gains[1] * np.sin(v)).admissible
    model = loops.model_of_case("a boom")
    assert not loops.said(lambda: screwgen.simulate(model, 0.002, 1e-3, controller=objects)) and memory.called == 4


def test_a_run_that_fails_may_ask_any_function():
    """What is named then is the loop about the posture before the failure, and the error keeps the run."""

    class Law:
        def __call__(self, t, q, v):
            return [-30.0 * q[0] - 60.0 * v[0]]

    model = loops.model_of_case("a boom")
    with (
        warnings.catch_warnings(record=True, action="always") as noted,
        pytest.raises(DivergedError, match=r"^t = 0\.\d+ s: the motion diverged: with these gains .*'boom.joint"),
    ):
        screwgen.simulate(model, 2.0, 1e-3, q0=[0.1], controller=Law())
    assert not noted  # no link is blamed for it


def test_a_law_that_is_not_smooth_is_not_spoken_of():
    model = loops.model_of_case("a boom")
    dry = lambda t, q, v: [-30.0 * q[0] - 0.5 * np.sign(v[0])]  # noqa: E731
    assert not loops.said(lambda: screwgen.simulate(model, 0.002, 1e-3, controller=dry))


# ------------------------------------------------------------------------------ what a newcomer meets


def test_the_true_cause_is_named_and_the_run_is_kept(tmp_path, capsys):
    """ELLA without rotors under README's first gains, in the command line; it blamed a link, and kept nothing."""
    goal = "kp = [40.0, 40.0, 20.0]\nkd = [8.0, 8.0, 3.0]\nq_des = [-0.5, 0.7, 0.4]\nduration = 0.5\ngravity = true"
    (tmp_path / "gains.toml").write_text(goal)
    out, law = tmp_path / "run.npz", f"pd:{tmp_path / 'gains.toml'}"
    arguments = ["simulate", "examples/ella.toml", "--duration", "2", "--step", "1e-3", "-o", str(out)]
    pictures = ["--plot", str(tmp_path / "run.png"), "--view", str(tmp_path / "run.html")]
    assert main([*arguments, *pictures, "--controller", law]) == 1
    warning, error = capsys.readouterr().err.splitlines()
    for line in (warning, error):
        assert "unstable at a step of 1 ms: the step may be 0.2" in line
        assert "lower kd[0] to 1.7" in line and "joint.armature" in line and "segments" not in line
    assert re.search(r"error: t = 0\.\d+ s: the motion diverged: with", error) and "run.failed.npz" in error
    names = {"gains.toml", "run.failed.npz", "run.failed.png", "run.failed.html"}
    assert {path.name for path in tmp_path.iterdir()} == names
    with np.load(tmp_path / "run.failed.npz") as kept:
        assert 0.0 < kept["t"][-1] < 2.0 and "unstable" in str(kept["ended"])
    assert main(["view", str(tmp_path / "run.failed.npz"), "-o", str(tmp_path / "seen.html")]) == 0


def test_an_error_has_the_run_until_then():
    case, model = loops.UNSTABLE["a boom"], loops.model_of_case("a boom")
    q = loops.start(model, case) + 0.1
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises(DivergedError) as failed:
            screwgen.simulate(model, 5.0, 1e-3, q0=q[:1], controller=PD((300.0,), (60.0,), (0.0,)))
    run = failed.value.run
    assert len(run.t) > 1 and run.t[-1] < 5.0 and run.ended == str(failed.value) and "ended early" in repr(run)
    with pytest.raises(screwgen.UsageError) as refused:
        screwgen.simulate(model, 1.0, 1e-3, q0=[1.0, 2.0])
    assert refused.value.run is None


def test_the_guides_gains_run_on_ella_with_the_rotors_that_it_states(tmp_path):
    text = Path("docs/commands.md").read_text()
    gains = re.search(r"```toml\n(kp = .*?)```", text, re.DOTALL)[1]
    rotors = [[float(x) for x in found.split(",")] for found in re.findall(r"armature = \[([\d., ]+)\]", text)]
    robot = example_dict("converged")
    for own, armature in zip(robot["links"], rotors, strict=True):
        own["joint"]["armature"] = armature
    model = model_of(robot)
    (tmp_path / "gains.toml").write_text(gains)
    law = read_pd(tmp_path / "gains.toml", model)
    with warnings.catch_warnings(record=True, action="always") as noted:
        run = screwgen.simulate(model, law.duration + 0.5, 1e-3, controller=law)
    assert not [w for w in noted if issubclass(w.category, ControlLoopWarning)]
    for t, q in law.waypoints:
        assert np.abs(run.q[np.searchsorted(run.t, t - 1e-9), :3] - q).max() < 0.08


def test_a_run_without_a_controller_blames_none():
    """A column under a thousand times its buckling load, on a joint that nothing holds."""
    more = {"section": loops.SOFT, "joint": {"mount": {"rpy": [0.0, -np.pi / 2, 0.0]}}, **loops.BENT}
    model = model_of(arm(link("column", axes="xy", bodies=[{"at": "tip", "mass": 1e4}], **more)))
    with pytest.raises(DivergedError) as failed:
        screwgen.simulate(model, 2.0, 1e-3, q0=[1e-3, 0, 0, 0, 0, 0], backend="casadi")
    line = str(failed.value)
    assert "controller" not in line and "at the start link 'column': axial load over buckling load is 1.99e+03" in line


# ------------------------------------------------------------------------------ joints without rotors


def test_joints_without_rotors_are_noted_where_a_slow_loop_needs_short_steps():
    """The step that is named for a loop of 1 Hz is that of runs; arms with rotors, and rigid ones, are not noted."""
    model = loops.model_of_case("a boom")
    (limit,) = steps_borne(model).values()
    M = model.numpy().mass_matrix(np.zeros(model.nq))[0, 0]
    case = loops.UNSTABLE["a boom"]._replace(kp=(SLOW**2 * M,), kd=(2 * SLOW * M,), step=limit)
    assert not loops.grows(model, case, limit / 1.3) and loops.grows(model, case, 1.3 * limit)
    (line,) = light_joints(model)
    assert line.startswith("boom.joint[0]: carries links that bend and states no rotor; a loop of control of 1 Hz")
    for quiet in (loops.RIGID, loops.SAGGING, loops.boom({"axes": ["z"], "drives": [loops.GEAR]})):
        assert not light_joints(model_of(quiet))
