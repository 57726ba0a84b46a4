"""The MPC example in its short form, its policy for late samples, and its parts against what they approximate."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import require_tool

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "examples"))

from mpc.arms import GOAL, LIMIT, STEP, Arms, at_rest  # noqa: E402
from mpc.generated import Generated  # noqa: E402
from mpc.loop import Motion  # noqa: E402
from mpc.ocp import Dynamics  # noqa: E402
from mpc.plan import Plan  # noqa: E402
from mpc.task import LATE_SAMPLES, rest, settling  # noqa: E402

pytestmark = pytest.mark.examples

PNGS = {"settling.png", "closed_loop.png", "latency.png", "late.png", "wrench.png"}
FILES = PNGS | {"report.md", "report.html", "results.json", "MANIFEST.sha256"}


@pytest.fixture(scope="module")
def arms() -> Arms:
    return Arms()


@pytest.fixture(scope="module")
def written(tmp_path_factory) -> Path:
    require_tool("cc")
    folder = tmp_path_factory.mktemp("mpc") / "out"
    command = [sys.executable, str(ROOT / "examples" / "mpc_ella.py"), "--quick", "-o", str(folder)]
    done = subprocess.run(command, env=os.environ | {"OMP_NUM_THREADS": "1"}, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "times as fast" in done.stdout and "late samples" in done.stdout
    return folder


@pytest.fixture(scope="module")
def results(written) -> dict:
    return json.loads((written / "results.json").read_text())


def test_everything_is_written_and_the_report_shows_it(written):
    assert {f.name for f in written.iterdir()} == FILES
    text = (written / "report.md").read_text()
    assert all(f"({name})" in text for name in PNGS)
    assert str(ROOT) not in text and "nan" not in text.lower().split()
    assert "*" not in (written / "report.html").read_text()


def test_every_sample_is_solved_in_time(results):
    """Processor time: the wall's depends on what else runs."""
    assert results["solved"] and results["samples"] == 91
    latency = results["latency"]
    assert latency["samples"] == {"warm": 270, "cold": 270}
    for times in (latency["warm_cpu"], latency["cold_cpu"]):
        assert 0 < times["sum"]["median"] <= times["sum"]["p99"] <= times["sum"]["max"] < 20.0
    parts = latency["warm_cpu"]
    assert parts["sum"]["median"] <= 1.05 * (parts["preparation"]["median"] + parts["feedback"]["median"])


def test_one_iteration_a_sample_settles_as_the_recorded_converged_ones(results):
    assert results["ghost"]["settling"][2] == pytest.approx(0.58, abs=0.005)
    assert results["settling"]["mpc"][2] <= 1.05 * results["ghost"]["settling"][2]


def test_without_a_plan_the_arm_comes_from_the_straight_posture_to_the_goal(results):
    assert results["settling"]["cold"][1] < 1.5 and results["offset"]["cold"] < 0.005


def test_late_samples_leave_the_tip_settled_and_torques_limited(results):
    assert set(results["late"]) == set(LATE_SAMPLES)
    assert all(times[0] is not None for times in results["late"].values())
    assert results["late"]["none"] == results["settling"]["mpc"]
    for peak in results["late_peak"].values():
        assert np.all(np.array(peak) <= LIMIT + 1e-9)


def test_a_late_sample_gets_the_next_torque_of_the_plan(arms):
    """The plan moves on by an interval; a sample in time goes on from there."""
    require_tool("cc")
    loop = Generated(arms, late=lambda k: k in (1, 2))
    loop.problem.options["patience"][:] = 0  # the arm does not move here
    x = loop.ends[0][0]
    found = loop.solve(loop.problem, x, 0.0)
    for k in range(4):
        planned, states = loop.problem.torques[1], loop.problem.states[1]
        found = loop.sample(x, found, 0.02 * k)
        assert found.late == (k in (1, 2)) and np.all(np.abs(found.u) <= LIMIT)
        assert np.array_equal(found.u[0], planned) == np.array_equal(found.x[0], states) == found.late
    assert found.converged


def test_the_tip_settles_twice_as_fast_as_under_pd_within_equal_limits(results):
    assert results["payload_error"] == pytest.approx(0.3)
    assert results["payload_found"] == pytest.approx(0.63, abs=0.005)
    assert results["headline"]["band"] == 0.005 and results["headline"]["faster"] >= 2.0
    for peak in results["peak"].values():
        assert np.all(np.array(peak) <= LIMIT + 1e-9)


def test_a_pd_for_the_nominal_payload_rests_away_from_the_goal_and_one_that_is_told_at_it(results):
    assert results["offset"]["pd"] > 0.005 and results["settling"]["pd"][2] is None
    assert results["offset"]["told"] < 1e-3 and results["offset"]["mpc"] < 2e-3


def test_the_bounded_wrench_stays_inside_in_the_plant_and_leaves_without_the_bound(results):
    moments, bound = results["wrench"]["plant"], results["wrench"]["bound"]
    assert moments["bounded"] < bound < moments["free"]
    assert results["wrench"]["margin"] == pytest.approx(bound - moments["bounded"])


def test_settling_is_the_last_time_outside_and_none_if_the_tip_is_outside_late():
    away = np.r_[np.full(100, 1.0), np.full(50, 0.001), np.full(20, 0.01), np.full(800, 0.002)]
    motion = Motion(*3 * [np.zeros((970, 3))], tip=away[:, None] * [1.0, 0.0, 0.0])
    assert settling(motion, np.zeros(3), 0.005) == pytest.approx(170 * STEP)
    assert settling(motion, np.zeros(3), 0.02) == pytest.approx(100 * STEP)
    assert settling(motion, np.zeros(3), 0.001) is None
    assert settling(motion, rest(motion), 0.001) == pytest.approx(170 * STEP)


def test_a_plan_gives_its_nodes_and_the_mean_of_its_torques():
    x, u = np.linspace(0, 1, 4)[:, None] * np.ones(22), np.array([[1.0, 2, 3], [4, 5, 6], [7, 8, 9]])
    plan = Plan(0.3, x, u, np.full(3, 10.0), True, 1, 0.0)
    assert np.allclose(plan.states(0.1), x[1]) and np.allclose(plan.states(5.0), x[3])
    assert np.allclose(plan.torques(0.1, 0.1), u[1]) and np.allclose(plan.torques(0.05, 0.1), u[:2].mean(axis=0))
    assert np.allclose(plan.torques([0.25, 0.4], 0.1), [[8.5, 9, 9.5], [10, 10, 10]])


def test_the_target_rests_with_its_tip_at_the_goal(arms):
    dynamics = Dynamics(arms.model)
    x, u = dynamics.rest_there(arms.goal, 0.63)
    assert np.allclose(np.array(dynamics.tip(x, 0.63)).ravel(), arms.goal, rtol=0, atol=1e-9)
    assert np.abs(np.array(dynamics.rate(x, u, 0.63))).max() < 1e-6
    q, _ = at_rest(arms.plant, GOAL, arms.nominal)
    assert np.allclose(dynamics.rest_there(arms.goal, 0.0)[0][:3], q[:3], rtol=0, atol=1e-4)


def test_the_projection_keeps_joints_and_leaves_out_axial_modes(arms):
    axial = [k for k, name in enumerate(arms.plant.q_names) if "axial" in name]
    assert np.array_equal(arms.projection[:3], np.eye(3, arms.plant.nq))
    assert len(axial) == 2 and not arms.projection[:, axial].any()
    # The lowest shapes of two and of three polynomials differ little.
    lowest = [k for k, name in enumerate(arms.plant.q_names) if name.endswith("[0]") and "bending" in name]
    own = [k for k, name in enumerate(arms.model.q_names) if name.endswith("[0]") and "bending" in name]
    assert np.allclose(arms.projection[np.ix_(own, lowest)], np.eye(4), atol=0.05)
