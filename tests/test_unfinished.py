"""What a process that is killed leaves: it is never taken for a result, and the next one removes it."""

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from screwgen import UsageError, derive, simulate
from screwgen.cli.main import main
from screwgen.simulation.runs import outputs
from screwgen.spec.load import load
from screwgen.unfinished import part_of
from screwgen.viewer.frames import _folder

ROOT = Path(__file__).resolve().parents[1]
PENDULUM = """
name = "pendulum"
gravity = [0.0, 0.0, -9.81]
[[links]]
name = "rod"
length = 1.0
section = { rhoA = 0.5 }
joint = { axes = ["y"] }
"""


@pytest.fixture
def robot(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("robot.toml").write_text(PENDULUM)
    return "robot.toml"


@pytest.mark.parametrize("more", [(), ("--view", "run.html")], ids=["run", "run and page"])
def test_a_command_that_is_killed_leaves_what_the_next_one_removes(robot, more):
    command = ("simulate", robot, "--step", "1e-3", "--quiet", "-o", "run.npz", *more, "--duration")
    given = [sys.executable, "-m", "screwgen", *command, "4000"]
    with subprocess.Popen(given, env=os.environ | {"PYTHONPATH": str(ROOT)}) as process:
        while process.poll() is None and len(os.listdir()) < 2 + len(more) // 2:
            time.sleep(0.02)
        living = set(os.listdir()) - {robot}
        assert main([*command, "0.01"]) == 0
        made = {"run.npz", *more[1:]}
        assert set(os.listdir()) == {robot} | made | living  # what another one still writes stays
        process.kill()
    assert all(name.endswith(".part") for name in living) and len(living) == 1 + len(more) // 2
    assert main([*command, "0.01"]) == 0 and set(os.listdir()) == {robot} | made


@pytest.mark.parametrize("kept", [0, 1])
@pytest.mark.parametrize("suffix", [".npz", ".csv"])
def test_a_run_that_was_killed_before_its_first_sample_is_none(robot, suffix, kept):
    """Of one that had samples the file says more than its head, and is refused."""
    model, part = derive(load(robot)), Path("run.part.npy" if suffix == ".npz" else "run.part.csv")
    heads: list[bytes] = []

    def controller(t, q, v):
        heads.append(part.read_bytes())
        return [0.0]

    simulate(model, 2e-3, 1e-3, controller=controller, store=f"run{suffix}")
    part.write_bytes(heads[0] + b"1" * kept)
    if kept:
        with pytest.raises(UsageError, match=f"{part}: is there already: it keeps a run that was stopped; move it"):
            simulate(model, 2e-3, 1e-3, store=f"run{suffix}")
    else:
        simulate(model, 2e-3, 1e-3, store=f"run{suffix}")
    assert part.exists() == bool(kept)


def test_a_film_of_pictures_goes_on_where_a_killed_one_left_a_folder(robot):
    for target in (Path("new"), Path("empty")):
        left = part_of(target.absolute(), target if target.name == "empty" else None)
        left.mkdir(parents=True)
        (left / "0001.png").touch()
        _folder(target.absolute(), iter([np.zeros((4, 4, 3), np.uint8)]), str(target))
        assert os.listdir(target) == ["0001.png"] and not left.exists()


def test_two_processes_may_write_one_output(tmp_path):
    """The second leaves alone what the first has not finished."""
    path = tmp_path / "run.csv"
    with outputs(path) as (first,):
        with outputs(path) as (second,):
            second.write(b"second")
        first.write(b"first")
    assert path.read_bytes() == b"first" and os.listdir(tmp_path) == ["run.csv"]
