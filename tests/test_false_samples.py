"""Predictive control under false samples and in wrong hands: a slice of false_samples.py, and names of robots."""

import subprocess

import pytest
from c_tools import SANITIZERS, complaint
from conftest import require_tool
from false_samples import program
from helpers import arm, link, model_of, unfolded

import screwgen
from screwgen.studies.predictive import project


@pytest.mark.parametrize("robot", ["flexible", "bristles"])
def test_one_false_sample_does_not_latch_the_controller(tmp_path, robot):
    run = program(robot, tmp_path, "-O1")
    done = subprocess.run([run, "12"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout
    assert done.stdout.count("at the goal after") == 3 and "0 failures" in done.stdout


@pytest.mark.parametrize("robot", ["rigid", "bristles"])
def test_calls_in_any_order_with_any_numbers(tmp_path, robot):
    run = program(robot, tmp_path, "-O1", *SANITIZERS, driver="mpc_abuse")
    assert complaint(subprocess.run([run], capture_output=True, text=True)) == []


PLAIN = """
horizon = { intervals = 2, step = 0.02 }
goal = { joints = [0.1] }
cost = { joints = 1.0, torques = 0.1 }
bounds = { torques = 1.0 }
"""


@pytest.mark.parametrize("name", ["daqp", "daqp_aux", "lu", "p", "goal", "dae", "inverse"])
def test_names_of_robots_that_the_code_has_already(tmp_path, name):
    """The solver's compile; those of our own code are refused in a line."""
    (tmp_path / "mpc.toml").write_text(PLAIN)
    model = model_of(arm(link("a")) | {"name": name})
    if name in ("goal", "dae", "inverse"):
        with pytest.raises(screwgen.ScrewgenError, match=f"robot '{name}': the generated C has .* choose another name"):
            project(model, tmp_path / "mpc.toml").files()
        return
    unfolded(tmp_path, project(model, tmp_path / "mpc.toml").files())
    command = [require_tool("gcc"), "-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"]
    done = subprocess.run([*command, f"{name}_qp.c", f"{name}_mpc.c"], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[:2000]
