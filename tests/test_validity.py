"""The limits of the first-order model: each back end measures the same, the bounds fire where the error is, and users
are told."""

import json
import math
import warnings
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import screwgen
from docs.tools import limits
from screwgen.backends.c.links import WATCHED
from screwgen.backends.c.project import CProject
from screwgen.backends.c.runs import RUNS
from screwgen.bodies.validity import MEASURES
from screwgen.cli.main import main
from screwgen.integrators import METHODS
from screwgen.simulation.validity import BOUND, ModelLeftError, ModelValidityWarning, Validity, Watch

ELLA = "examples/ella.toml"


# ------------------------------------------------------------------------------ what is measured


def test_measures_of_a_posture_follow_from_statics():
    model = limits.beam(2.0, rpy=(0.0, -math.pi / 2, 0.0), rhoA=0.5)
    held = model.validity_at_rest(np.zeros(model.nq)).values[0]
    assert held[2] == pytest.approx(2.0 * 9.81 * 4 / (math.pi**2 * 10) + 0.5 * 9.81 / 7.8373474 / 10)
    q = np.zeros(model.nq)
    q[0] = 1e-3
    shapes = model.blocks(0)["validity"].values
    bent = model.validity_at_rest(q).values[0]
    assert bent[0] == pytest.approx(1e-3 * abs(float(shapes["deflection_shapes"][0, 0])))
    assert bent[1] > bent[0]


@pytest.mark.parametrize("stations", [False, True])
def test_where_modes_shear_the_load_is_over_haringxs(stations):
    """``P (1 + P/GA) = pi^2 EI / 4 l^2`` of the plane that buckles first; that of a massless rod is reached at one."""
    EI, l, GA, stiff = 10.0, 1.5, 30.0, {"EIz": 12.0, "GAy": 1e9}
    euler = math.pi**2 * EI / (4 * l**2)
    load = GA * (math.sqrt(1 + 4 * euler / GA) - 1) / 2
    assert load * (1 + load / GA) == pytest.approx(euler) and load < 0.85 * euler
    section = {"rhoA": 1e-9, "EIy": EI, "GAz": GA, "rhoIy": 1e-3, "rhoIz": 1e-3} | stiff
    whole = (
        section if not stations else [{"at": s} | {k: v * f for k, v in section.items()} for s, f in ((0, 1.7), (1, 1))]
    )
    modes = {"bending_y": 1, "bending_z": 1, "shear_y": 1, "shear_z": 1}
    table = {"name": "column", "length": l, "joint": {"axes": []}, "section": whole, "modes": modes}
    table["bodies"] = [{"at": "tip", "mass": load / 9.81}]
    robot = {"name": "column", "gravity": [-9.81, 0.0, 0.0], "links": [table]}
    model = screwgen.derive(screwgen.Robot.model_validate(robot))
    assert model.validity_at_rest(np.zeros(model.nq)).values[0, 2] == pytest.approx(1, rel=1e-6)


def test_a_stated_frequency_stands_for_the_stiffness():
    """The first frequency of a clamped-free beam gives back its EI."""
    links = {"length": 1.0, "joint": {"axes": []}, "name": "beam", "bodies": [{"at": "tip", "mass": 1.0}]}
    f = 1.8751040687**2 * math.sqrt(10.0 / 0.5) / (2 * math.pi)
    modes = {"basis": "clamped_free", "bending_z": 1, "frequencies": {"bending_z": [f]}}
    stated = links | {"section": {"rhoA": 0.5}, "modes": modes}
    plain = links | {"section": {"rhoA": 0.5, "EIy": 10.0}, "modes": {"basis": "clamped_free", "bending_z": 1}}
    found = []
    for link in (stated, plain):
        robot = screwgen.Robot.model_validate({"name": "beam", "gravity": [9.81, 0.0, 0.0], "links": [link]})
        found.append(screwgen.derive(robot).validity_at_rest(np.zeros(1)).values[0, 2])
    assert found[0] == pytest.approx(found[1], rel=1e-8) and found[0] < 0


def test_dynamics_cost_what_they_did():
    """No operation is added to what runs unless the measures are asked for, and those cost little."""
    for layout in ("fused", "modular"):
        project = CProject(screwgen.derive(screwgen.load("examples/ella_paper.toml")).chain, "test", layout=layout)
        measuring = sum(p.program.operation_count for p in project.links.passages("measuring"))
        asked = sum(p.program.operation_count for p in project.links.passages("joint_dynamics"))
        plain = sum(p.program.operation_count for p in project.links.passages("joint_dynamics", WATCHED))
        assert measuring + asked - plain < 0.05 * project.operations["total"]
    assert "motion" in RUNS["joint_dynamics"].results and project.operations["total"] == plain


# ------------------------------------------------------------------------------ the bounds


@cache
def cases() -> tuple[limits.Case, ...]:
    return tuple(limits.quick())


def test_the_bounds_fire_where_the_error_passes_one_percent():
    """Within a factor of two either way, for every case that has a true error."""
    for case in cases():
        if case.reached >= 2:
            assert not abs(case.error) < 0.01, case
        if case.reached <= 0.51:
            assert abs(case.error) < 0.01, case
    assert sum(case.reached <= 0.51 for case in cases()) == 4


def test_the_errors_that_are_told_are_the_true_ones():
    for case in cases():
        if case.reached <= 10:
            told = Validity(("beam",), np.array([[case.value * (m == case.measure) for m in MEASURES]])).findings
            assert all(f.error == pytest.approx(abs(case.error), rel=0.35) for f in told)


def test_a_column_past_its_buckling_load_is_not_called_stable(tmp_path, capsys):
    model = limits.beam(1.5 * math.pi**2 * 10.0 / 4 / 9.81, rpy=(0.0, -math.pi / 2, 0.0))
    with pytest.warns(ModelValidityWarning, match=r"axial load over buckling load is 1\.5.*unstable.*lower the load"):
        assert screwgen.equilibrium(model).validity.buckled == ("beam",)
    with pytest.warns(ModelValidityWarning, match="unstable"):
        screwgen.natural_frequencies(model)
    path = tmp_path / "column.toml"
    path.write_text(screwgen.dump(model.robot))
    for command in (["equilibrium"], ["equilibrium", "--json"], ["modes", "--json"], ["evaluate"]):
        assert main([command[0], str(path), *command[1:]]) == 0
        out, err = capsys.readouterr()
        assert err.count("\n") == 1 and err.startswith("screwgen: warning: link 'beam': axial load")
        if command == ["equilibrium"]:
            assert "beyond the buckling load of beam" in out
        else:
            assert json.loads(out)["validity"]["past"][0]["measure"] == "axial_load"


# ------------------------------------------------------------------------------ runs


@pytest.mark.parametrize("way", [{}, {"backend": "numpy"}, {"every": 100}])
def test_a_spin_up_warns_early_and_stops(way):
    """Before the deflection passes a tenth of the length, and where it passes the length."""
    with (
        pytest.warns(ModelValidityWarning, match=r"rotation.*first past it at t = 3\.\d+ s") as said,
        pytest.raises(ModelLeftError, match=r"^t = 9\.\d+ s: link 'beam' bends by more than its length"),
    ):
        limits.spin_up(**way)
    assert len(said) == 1


def test_a_stopped_run_keeps_its_samples_and_fails(tmp_path, capsys):
    """The command line: exit status 1, one line each, and the file of --keep."""
    heavy = limits.beam(20.0, axes=["z"], armature=[1.0]).robot
    path, out = tmp_path / "heavy.toml", tmp_path / "run.npz"
    path.write_text(screwgen.dump(heavy))
    arguments = ["simulate", str(path), "--duration", "2", "--step", "2e-3", "--form", "dae", "-o", str(out)]
    assert main([*arguments, "--keep"]) == 1
    err = capsys.readouterr().err.splitlines()
    assert [line.split(":")[1] for line in err] == [" warning", " error"] and "run.part.npy keeps the run" in err[1]
    kept = np.load(tmp_path / "run.part.npy")
    assert 10 < len(kept) < 1000 and not out.exists()
    assert main(arguments) == 1 and not out.exists()


def test_a_limit_is_warned_of_once_for_a_model_and_link():
    """Runs and rollouts of other numbers say no more of it; another model does."""
    model, other = limits.beam(1.0), limits.beam(1.0)
    with warnings.catch_warnings(record=True, action="always") as noted:
        screwgen.simulate(model, 0.6, 2e-3, backend="casadi")
        screwgen.simulate(model, 0.7, 2e-3, backend="casadi", v0=0.01 * np.ones(model.nv))
        for rate in (0.0, 0.01):
            screwgen.rollout(model, np.r_[np.zeros(model.nq), np.full(model.nv, rate)], step=2e-3, steps=300)
        said = len(noted)
        screwgen.simulate(other, 0.6, 2e-3, backend="casadi")
    assert (said, len(noted)) == (1, 2) and all(w.category is ModelValidityWarning for w in noted)


def test_peaks_between_samples_are_seen():
    model = limits.beam(1.0)
    find = lambda every: screwgen.simulate(model, 1.0, 2e-3, every=every, backend="casadi").validity  # noqa: E731
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelValidityWarning)
        fine, coarse = find(1), find(500)
    assert fine.values[0, 0] > 0.6 and 0.4 < fine.at[0, 0] < 0.7
    assert coarse.values[0, 0] == pytest.approx(fine.values[0, 0], rel=0.02)


def test_a_method_that_diverges_is_not_taken_for_a_model_that_is_left():
    watch = Watch(["a", "b"])
    assert watch(0.0, np.array([[0.5, 0, 0, 0], [0.1, 0, 0, 0]]))
    assert not watch(0.1, np.array([[0.5, 0, 0, 0], [1.1, 0, 0, 0]])) and not watch.jumped
    assert "link 'b'" in str(watch.left())
    assert not watch(0.2, np.array([[0.5, 0, 0, 0], [7.0, 0, 0, 0]])) and watch.jumped
    assert set(METHODS) >= {"euler", "modal_midpoint"}


# ------------------------------------------------------------------------------ what is said


def test_one_line_says_which_when_how_much_and_what_to_do():
    values = np.zeros((2, 4))
    values[1] = 0.05, 0.7, -0.03, 0.1
    over = Validity(("a", "b"), values, np.full((2, 4), 1.5), np.full((2, 4), 2.0))
    line = over.line()
    assert "\n" not in line and line.startswith("link 'b': slope of the tip in rad is 0.7, past its bound 0.35")
    assert "first past it at t = 1.5 s, largest at 2 s" in line and "4.1 % off" in line
    assert "segments = 2" in line and "1 more past their bounds" in line
    assert not over.holds and replace(over, values=values / 10).holds and not replace(over, values=values / 10).line()


def test_numbers_that_overflow_are_no_traceback():
    huge = Validity(("a",), np.array([[np.inf, np.nan, -np.inf, 1e300]]))
    assert json.loads(json.dumps(huge.record(), allow_nan=False))["measures"]["a"]["deflection"] is None
    assert "100 % or more" in huge.line() and "inf" in huge.table()


def test_the_examples_keep_within_the_bounds():
    """ELLA at rest in any posture; its demo is run by tests of its own."""
    model = screwgen.derive(screwgen.load(ELLA))
    with warnings.catch_warnings():
        warnings.simplefilter("error", ModelValidityWarning)
        for shoulder in np.linspace(-math.pi, math.pi, 9):
            assert model.validity_at_rest(np.append([shoulder, 0.0, 0.0], np.zeros(model.nq - 3))).holds
    assert list(BOUND) == list(MEASURES)


def test_rollouts_find_the_scenario_that_leaves():
    """The one that turns fast among many; bending at whatever sample it is largest."""
    model = limits.beam(1.0, rhoA=1.0, axes=["z"], armature=[1.0])
    x0 = np.zeros((40, 2 * model.nq))
    x0[17, model.nq] = 12.0
    with pytest.warns(ModelValidityWarning, match="link 'beam'"):
        found = screwgen.rollout(model, x0, step=1e-3, steps=30)
    assert found.validity.values[0, 3] == pytest.approx(144 / 10, rel=0.01)
    shapes = model.blocks(0)["validity"].values["deflection_shapes"]
    row, eta = np.array(shapes.tolist(), float), found.q[..., 1:]
    assert found.validity.values[0, 0] == pytest.approx(np.linalg.norm(eta @ row.T, axis=2).max(), rel=1e-9)


def test_analyse_prints_the_table_of_a_state_and_of_a_run(tmp_path, capsys):
    model = limits.beam(2.0, axes=["z"], armature=[1.0])
    robot, out = tmp_path / "beam.toml", tmp_path / "run.npz"
    robot.write_text(screwgen.dump(model.robot))
    with pytest.warns(ModelValidityWarning):
        run = screwgen.simulate(model, 0.2, 1e-3, backend="casadi")
    run.save(out)
    assert main(["analyse", str(robot), "--state", str(out), "--json"]) == 0
    record = json.loads(capsys.readouterr().out)[str(out)]
    assert record["measures"]["beam"]["deflection"] == pytest.approx(run.validity.values[0, 0], rel=1e-12)
    assert record["past"][0]["first"] == run.validity.findings[0].first
    assert main(["analyse", str(robot), "--state", str(out)]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert f"Limits of the model, {out}" in said
    assert "link 'beam': tip deflection over length is" in said
    np.savez(out, **{name: getattr(run, name) for name in ("t", "q", "v", "tau")}, wrench=run.wrench + 1.0)
    assert main(["analyse", str(robot), "--state", str(out)]) == 2
    assert "wrenches on the tips are not in a run's file" in capsys.readouterr().err
