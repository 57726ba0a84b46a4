"""The product is whole without its plug-in: the package is copied without `screwgen/paper`, and still does its work."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
ROBOT = """
name = "flap"
gravity = [0.0, 0.0, -9.81]

[[links]]
name = "wing"
length = 0.6
section = { rhoA = 0.4, EIy = 12.0, EIz = 12.0 }
modes = { bending_y = 1 }
joint = { axes = ["y"] }
"""
WORK = """
import sys
from importlib.util import find_spec
import screwgen

assert find_spec("screwgen.paper") is None and screwgen.plugins.plugins() == ()
model = screwgen.derive(screwgen.load("flap.toml"))
functions = model.casadi()
assert len([functions[name] for name in functions]) > 10 and "cauchy" not in functions
assert not hasattr(model, "cauchy_names") and "z_rows" not in model.blocks(0)
for form in ("joint", "dae"):
    run = screwgen.simulate(model, 0.004, 0.001, [0.3, 0.0], form=form)
    assert len(run.t) == 5 and run.q[-1, 0] != 0.3
try:
    screwgen.derive(model.robot, formulation="printed")
except screwgen.UsageError as error:
    assert str(error) == "there is no formulation 'printed'; choose consistent"
assert not [name for name in sys.modules if name.startswith("screwgen.paper")]
"""


@pytest.fixture(scope="module")
def bare(tmp_path_factory) -> Path:
    """A folder with the package and its templates, but without the plug-in, and a robot file."""
    folder = tmp_path_factory.mktemp("bare")
    plugin = str(ROOT / "screwgen" / "paper")
    left_out = lambda where, names: {n for n in names if n == "__pycache__" or os.path.join(where, n) == plugin}  # noqa: E731
    shutil.copytree(ROOT / "screwgen", folder / "screwgen", ignore=left_out)
    shutil.copytree(ROOT / "templates", folder / "templates")
    shutil.copy(ROOT / "pyproject.toml", folder)
    (folder / "flap.toml").write_text(ROBOT, encoding="utf-8")
    return folder


def run(folder: Path, *arguments: str) -> subprocess.CompletedProcess:
    command = [sys.executable, *arguments]
    env = os.environ | {"PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True)


def test_everything_works_without_the_folder(bare):
    done = run(bare, "-c", WORK)
    assert done.returncode == 0, done.stderr


def test_the_command_line_works_without_the_folder(bare):
    done = run(bare, "-m", "screwgen", "--help")
    assert done.returncode == 0 and "generate" in done.stdout and "paper" not in done.stdout
    done = run(bare, "-m", "screwgen", "generate", "flap.toml", "-o", "out")
    assert done.returncode == 0, done.stderr
    assert {p.name for p in (bare / "out").iterdir()} > {"c", "casadi", "latex"}
    text = (bare / "out" / "latex" / "flap.tex").read_text()
    assert "Link class 1" in text and "Z-form" not in text and "Yaqubi" in text
    assert "Z-form" not in (bare / "out" / "casadi" / "README.md").read_text()


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("paper 29", "the command 'paper' is that of a plug-in which is not installed"),
        ("evaluate flap.toml --formulation printed", "--formulation: there is no 'printed'; choose consistent"),
    ],
)
def test_what_the_plug_in_adds_is_refused_on_one_line(bare, line, message):
    done = run(bare, "-m", "screwgen", *line.split())
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"screwgen: error: {message}\n")
