"""Real-time control with acados in its short form; its own claims hold, and what is missing is said in one line."""

import json
import os
import subprocess
import sys
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from conftest import lacking, require_tool

import screwgen

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "examples"))

from with_acados import arm, generated  # noqa: E402
from with_acados.dynamics import discrete  # noqa: E402
from with_acados.install import Missing, acados_template  # noqa: E402
from with_acados.judge import Judge  # noqa: E402

EXAMPLE = [sys.executable, str(ROOT / "examples" / "nmpc_acados.py")]
ARM = ROOT / "examples" / "flexible_arm.toml"


def require_acados() -> None:
    """Skips where acados cannot be had, or fails if REQUIRE_TOOLS=1."""
    require_tool("cc")
    try:
        acados_template()
    except Missing as error:
        lacking(f"acados: {error}")


def run(*arguments: str, **more: str) -> subprocess.CompletedProcess:
    env = os.environ | {"PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1"} | more
    return subprocess.run([*EXAMPLE, *arguments], env=env, capture_output=True, text=True)


@pytest.fixture(scope="module")
def results(tmp_path_factory) -> dict:
    require_acados()
    folder = tmp_path_factory.mktemp("nmpc_acados")
    done = run("--short", "-o", str(folder))
    assert done.returncode == 0, done.stdout + done.stderr
    assert "settled" in done.stdout
    return json.loads((folder / "results.json").read_text())


@pytest.mark.examples
def test_ella_settles_as_under_ipopt_and_every_sample_is_solved(results):
    n = results["ella"]
    assert n["solved"] and n["samples"] == 50 and n["peak_over_limit"] <= 1 + 1e-9
    assert n["bands_m"][2] == 0.005 and n["settling_s"][2] <= 0.61
    assert n["torque_beside_ipopt"] <= 1e-3


@pytest.mark.examples
def test_a_cold_start_without_a_plan_converges(results):
    assert results["ella"]["cold_start"] <= 1e-6


@pytest.mark.examples
def test_the_published_arm_settles_within_its_bounds(results):
    n = results["flexible_arm"]
    assert n["N"] == 125 and n["states"] == 14 and n["solved"]
    assert n["settling_s"][0] <= 1.1 and n["peak_over_limit"] <= 1 + 1e-6 and n["rate_over_bound"][0] <= 1.1


@pytest.mark.examples
def test_one_iteration_is_near_converged_ipopt(results):
    off = results["flexible_arm"]["beside_ipopt"]
    assert all(off["converged"]) and len(off["torque"]) == 2
    assert max(off["torque"]) <= 0.1


@pytest.mark.examples
def test_the_generated_c_solves_the_published_arm_in_the_same_run(results):
    (n,) = results["flexible_arm"]["generated"].values()
    assert n["solved"] and n["samples"] == results["flexible_arm"]["samples"] == 240
    assert n["settling_s"][0] <= 1.1 and n["peak_over_limit"] <= 1 + 1e-6 and n["rate_over_bound"][0] <= 1.01
    off = n["beside_ipopt"]
    assert all(off["converged"]) and len(off["torque"]) == 2 and max(off["torque"]) <= 0.1


@pytest.mark.examples
def test_without_blocks_the_generated_c_solves_the_same_problem_as_ipopt(monkeypatch):
    """Forty intervals, each a block: converged torques and states from rest near the goal."""
    require_tool("cc")
    monkeypatch.setitem(generated.PATTERNS, "40", ((1, 40),))
    task = arm.Task(modes=2, N=40)
    control, (x, tau), nq = (
        generated.controller(task, "40"),
        task.rest(arm.GOAL + np.array([0.3, -0.2, 0.2])),
        task.model.nq,
    )
    control.initialise(x[:nq], x[nq:], tau)
    control.feedback(x[:nq], x[nq:])
    found = Judge(task.problem, *task.reference()).solve(x, control.states, control.torques)
    assert control.converged and found.converged
    assert np.abs((control.torques - found.u) / arm.LIMIT).max() <= 1e-6
    assert np.abs(control.states - found.x).max() <= 1e-5
    assert np.abs(found.u[0] / arm.LIMIT).max() > 0.1


@pytest.mark.examples
def test_times_have_parts_and_a_sum(results):
    for n in [*results.values(), *results["flexible_arm"]["generated"].values()]:
        t = n["times_ms"]
        assert t["sample"]["median"] > 0 and t["sample"]["max"] >= t["sample"]["p99"] >= t["sample"]["median"]
        assert t["sample"]["mean"] == pytest.approx(sum(part["mean"] for k, part in t.items() if k != "sample"))


@pytest.mark.examples
def test_the_script_that_make_acados_runs_leaves_what_is_there():
    """`make acados` is examples/with_acados/install.py."""
    require_acados()
    command = [sys.executable, str(ROOT / "examples" / "with_acados" / "install.py")]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.startswith("acados is in ") and not done.stderr


def test_without_acados_one_line_says_what_to_do(tmp_path):
    done = run("--short", "-o", str(tmp_path / "out"), ACADOS_SOURCE_DIR=str(tmp_path))
    assert done.returncode == 1 and not (tmp_path / "out").exists()
    (line,) = done.stderr.splitlines()
    assert line.startswith("nmpc_acados: error: the acados in ") and "make acados" in line


def test_the_published_arm_is_the_published_one():
    """Mass 0.3935 kg and EI 19/3 N·m² of a link, nine coordinates, the tip's height at zero angles."""
    robot = screwgen.load(ARM)
    for link in robot.links:
        assert link.length * link.section.rhoA == pytest.approx(0.3935)
        assert link.section.EIy == pytest.approx(19 / 3)
    model = screwgen.derive(robot)
    pose = model.casadi()["tip_pose"](np.zeros(9), model.parameter_values)[1]
    assert model.nq == 9 and np.allclose(np.array(pose).ravel(), [1.0, 0.0, 0.15], rtol=0, atol=1e-15)


def test_the_source_of_discrete_dynamics_has_both_functions_and_no_hessian():
    x, u, p = ca.SX.sym("x", 2), ca.SX.sym("u"), ca.SX.sym("p")
    source = discrete("little", x, u, p, ca.vertcat(x[0] + 0.1 * x[1], x[1] - p * ca.sin(x[0]) + u))
    assert "int little_disc(void **in" in source and "int little_disc_jac(void **in" in source
    assert "#define NX 2" in source and "#define NU 1" in source and "hess" not in source
