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
REFUSED = {
    "paper 29": "the command 'paper' is that of a plug-in which is not installed",
    "evaluate flap.toml --formulation printed": "--formulation: there is no 'printed'; choose consistent",
}
"""What the plug-in adds, and the line that says that it is not there."""

MODEL = """
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
COMMANDS = f"""
import io
from contextlib import redirect_stderr, redirect_stdout
from screwgen.cli.main import main

def command(line):
    with redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
        status = main(line.split())
    return status, out.getvalue(), err.getvalue()

status, out, _ = command("--help")
assert status == 0 and "generate" in out and "paper" not in out
assert command("generate flap.toml -o out")[0] == 0
for line, message in {REFUSED}.items():
    assert command(line) == (2, "", f"screwgen: error: {{message}}\\n"), line
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


def test_everything_works_without_the_folder(bare):
    """The model and the command line, in a process that has never seen the plug-in."""
    env = os.environ | {"PYTHONPATH": str(bare), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-c", MODEL + COMMANDS]
    done = subprocess.run(command, cwd=bare, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert {p.name for p in (bare / "out").iterdir()} > {"c", "casadi", "latex"}
    text = (bare / "out" / "latex" / "flap.tex").read_text()
    assert "Link class 1" in text and "Z-form" not in text and "Yaqubi" in text
    assert "Z-form" not in (bare / "out" / "casadi" / "README.md").read_text()
