"""Examples in their short form: their own assertions hold, they draw, and say in a line what is wrong."""

import importlib
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import package, require_tool
from helpers import ROOT, arm, link, model_of


@pytest.fixture
def example(monkeypatch):
    """An example as a module, by its name."""
    monkeypatch.syspath_prepend(str(ROOT / "examples"))
    return importlib.import_module


def run(name: str, *arguments: str) -> subprocess.CompletedProcess:
    """An example in a process of its own, which ends well."""
    command = [sys.executable, str(ROOT / "examples" / name), *arguments]
    env = os.environ | {"PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1"}
    done = subprocess.run(command, cwd=ROOT, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done


def test_resonances_in_the_bode_plot(example, capsys, tmp_path):
    bode = example("bode_ella")
    assert bode.main(["--quick", "-o", str(tmp_path / "bode.png")]) == 0
    rows = re.findall(r"^ (\d\.\d) kg +([\d.]+) mm +(.*)$", capsys.readouterr().out, re.MULTILINE)
    assert [(mass, sag) for mass, sag, _ in rows] == [("2.1", "36.8"), ("0.0", "19.0")]
    lowest = [float(hertz.split()[0]) for *_, hertz in rows]
    assert abs(lowest[0] - 9.166) < 0.01 and abs(lowest[1] - 16.310) < 0.01
    assert (tmp_path / "bode.png").read_bytes().startswith(b"\x89PNG")
    assert bode.main(["-o", str(tmp_path / "bode.jpg")]) == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1 and "must end in .png" in err and len(list(tmp_path.iterdir())) == 1


@pytest.mark.examples
def test_two_units_move_together(example, capsys, tmp_path):
    assert example("fmu_motor").main(["--short", "-o", str(tmp_path)])["apart"] < 1e-5
    assert "mrad from the goal" in capsys.readouterr().out
    for name in ("fmu_motor.png", "fmu_fall.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")


@pytest.mark.examples
def test_a_winch_that_knows_the_sea_holds_the_load_still():
    """Within a twentieth of what it does without; the rope carries the load's 14.7 kN all the time."""
    said = run("ship_crane.py").stdout
    still, moved = (int(x) for x in re.findall(r"within (\d+) mm", said))
    assert still < 0.05 * moved and "bears 14." in said
    assert (ROOT / "build" / "ship_crane" / "ship_crane.html").exists()


@pytest.mark.examples
def test_a_soft_gripper_closes():
    said = run("soft_gripper.py").stdout
    apart = [float(x) for x in re.findall(r"tips +([\d.]+) mm apart", said)]
    assert apart == sorted(apart, reverse=True) and apart[0] > 150 and apart[-1] < 20
    assert (ROOT / "build" / "soft_gripper" / "soft_gripper.html").exists()


@pytest.mark.examples
def test_a_finger_presses_on_a_wall_as_a_cantilever_and_rubs_along_it():
    """Friction holds the finger on the way up and pushes it on the way down, 0.6 of what the wall bears."""
    said = run("finger_on_wall.py").stdout
    found = np.array(
        re.findall(r"bears ([\d.]+) N \(a cantilever ([\d.]+) N\), the hand lifts ([+-][\d.]+)", said), float
    )
    assert found[:, 0] == pytest.approx(found[:, 1], rel=0.03) and abs(found[0, 2]) < 0.002
    assert found[1:, 2] / found[1:, 0] == pytest.approx([0.595, -0.595], abs=0.003)
    assert (ROOT / "build" / "finger_on_wall" / "finger_on_wall.html").exists()


@pytest.mark.examples
def test_demo_runs_over_an_older_folder():
    """Of another arm of the same name: the folder is replaced."""
    require_tool("make")
    require_tool("cc")
    header = ROOT / "build" / "ella" / "c" / "ella.h"
    model_of(arm(link()) | {"name": "ella"}).write(ROOT / "build" / "ella", targets=("c",))
    before = header.read_text()
    assert "set points" in run("demo.py").stdout and (ROOT / "build" / "ella.png").exists()
    assert header.read_text() != before


@pytest.mark.examples
def test_do_mpc_closes_the_loop_on_ella():
    require_tool("cc")
    done = run("do_mpc_ella.py", "--short")
    assert not done.stderr and "do-mpc and generated C" in done.stdout


@pytest.mark.examples
def test_gains_are_tuned_by_gradients_of_jax():
    package("jax")
    assert "JAX and the C" in run("jax_tuning.py", "--short").stdout
