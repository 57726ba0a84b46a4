"""The MPC example in its short form, and its parts against what they approximate."""

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

from mpc.arms import GOAL, LIMIT, Arms, at_rest  # noqa: E402
from mpc.ocp import Dynamics  # noqa: E402

FILES = {"closed_loop.png", "solves.png", "wrench.png", "report.md", "report.html", "results.json", "MANIFEST.sha256"}


@pytest.fixture(scope="module")
def written(tmp_path_factory) -> Path:
    require_tool("cc")
    folder = tmp_path_factory.mktemp("mpc") / "out"
    command = [sys.executable, str(ROOT / "examples" / "mpc_ella.py"), "--quick", "-o", str(folder)]
    done = subprocess.run(command, env=os.environ | {"OMP_NUM_THREADS": "1"}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "times" in done.stdout and "converged" in done.stdout
    return folder


@pytest.fixture(scope="module")
def results(written) -> dict:
    return json.loads((written / "results.json").read_text())


def test_everything_is_written_and_the_report_shows_it(written):
    assert {f.name for f in written.iterdir()} == FILES
    text = (written / "report.md").read_text()
    assert all(f"({name})" in text for name in FILES if name.endswith(".png"))
    assert str(ROOT) not in text and "nan" not in text.lower().split()


def test_every_solve_converges(results):
    assert results["converged"] and results["solves"] == 50 and results["plans_converged"]
    assert all(first["converged"] for first in results["first"])


def test_the_tip_settles_before_that_of_the_pd_of_the_short_form_within_equal_limits(results):
    assert results["payload_error"] == pytest.approx(0.3)
    assert results["faster"] > 1.0 and results["mpc"]["residual"] < results["band"]
    for name in ("mpc", "pd"):
        assert np.all(np.array(results[name]["peak"]) <= LIMIT + 1e-9)


def test_the_bounded_wrench_stays_inside_in_the_plant_and_leaves_without_the_bound(results):
    moments, bound = results["wrench"]["plant"], results["wrench"]["bound"]
    assert moments["bounded"] < bound < moments["free"]
    assert results["wrench"]["margin"] == pytest.approx(bound - moments["bounded"])


def test_the_target_is_the_rest_that_the_bias_gives():
    arms = Arms()
    x, u = Dynamics(arms.model).target(GOAL, np.zeros(8))
    q, hold = at_rest(arms.model, GOAL, arms.model.parameter_values)
    assert np.allclose(x[:7], q, rtol=1e-7, atol=1e-10) and np.allclose(u, hold, rtol=1e-7, atol=1e-7)


def test_the_projection_keeps_joints_and_leaves_out_axial_modes():
    arms = Arms()
    axial = [k for k, name in enumerate(arms.plant.q_names) if "axial" in name]
    assert np.array_equal(arms.projection[:3], np.eye(3, arms.plant.nq))
    assert len(axial) == 2 and not arms.projection[:, axial].any()
    # The lowest shapes of two bases differ little.
    lowest = [k for k, name in enumerate(arms.plant.q_names) if name.endswith("[0]") and "bending" in name]
    assert np.allclose(arms.projection[3:, lowest], np.eye(4), atol=0.05)
