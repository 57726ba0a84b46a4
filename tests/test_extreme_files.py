"""Robot files and states with numbers at the ends of their ranges: every command ends well or in one line, no warning.

The corners are drawn once and for all; what stands outside of the ranges is refused in `test_spec_ranges.py`.
"""

import json
import re
import warnings
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from screwgen import load
from screwgen.cli.main import main
from screwgen.simulation import compiled_runs, linearised
from screwgen.spec.ranges import RANGES

SHORT = "simulate arm.toml --duration 2e-3 --step 1e-3 -o run.csv --state state.json"
COMMANDS = (
    "modes arm.toml",
    "modes arm.toml --joints free",
    "evaluate arm.toml --state state.json",
    "evaluate arm.toml --state state.json --form dae",
    "equilibrium arm.toml",
    "equilibrium arm.toml --hold",
    "analyse arm.toml --state state.json",
    SHORT,
    f"{SHORT} --form dae",
)


def robot(rng, extreme: float) -> str:
    """One link with all that a file can state, each number at an end of its range with a probability, or ordinary."""

    def x(quantity: str, ordinary: float) -> float:
        allowed = RANGES[quantity]
        ends = (allowed.high, allowed.low or allowed.high * 1e-24)
        return float(rng.choice(ends)) if rng.random() < extreme else ordinary

    section = ", ".join(f"{key} = {x(key, 1e3)}" for key in ("EA", "EIy", "EIz", "GJ"))
    inertia = [*[x("inertia", 1.0)] * 3, 0, 0, 0]
    return f"""
name = "arm"
gravity = [{x("gravity", 1.0)}, 0.0, {-x("gravity", 9.81)}]
[[links]]
name = "a"
length = {x("length", 1.0)}
section = {{ rhoA = {x("rhoA", 1.0)}, rhoIp = {x("rhoIp", 1e-2)}, {section} }}
modes = {{ bending_y = 2 }}
damping = {{ ratio = {x("damping ratio", 0.01)}, time = {x("damping time", 0.001)} }}
bodies = [{{ at = "tip", mass = {x("mass", 1.0)}, com = [0, {x("position", 0.1)}, 0], inertia = {inertia} }}]
[links.joint]
axes = ["y"]
mount = {{ xyz = [{x("position", 0.1)}, 0, 0], rpy = [{x("turn", 0.3)}, 0, 0] }}
armature = {x("armature", 0.1)}
damping = {x("damping", 0.1)}
stiffness = {x("stiffness", 10.0)}
"""


@pytest.mark.parametrize("seed", range(3))
def test_numbers_at_the_ends_of_their_ranges_do_no_harm(capsys, monkeypatch, tmp_path, seed):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(compiled_runs, "has_compiler", lambda: False)
    rng = np.random.default_rng(seed)
    Path("arm.toml").write_text(robot(rng, (0.1, 0.3, 1.0)[seed % 3]))
    ends = [float(rng.choice([1.0, RANGES[key].high])) for key in ("q", "v", "tau")]
    Path("state.json").write_text(
        json.dumps({key: [value] for key, value in zip(("q", "v", "tau"), ends, strict=True)})
    )
    load("arm.toml")  # all sizes are in their ranges
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for command in COMMANDS:
            status = main(command.split())
            out, err = capsys.readouterr()
            errors = [x for x in err.splitlines() if not x.startswith(("screwgen: warning: ", "screwgen: note: "))]
            assert status in (0, 1, 2) and len(errors) == (status > 0), (command, err)
            assert not re.search(r"\b(nan|inf)", out, re.IGNORECASE), command
            if command.startswith("simulate") and status == 0:
                assert np.isfinite(np.loadtxt("run.csv", delimiter=",", skiprows=1)).all()


def test_a_mass_matrix_that_rounding_ends_is_said(capsys, monkeypatch, tmp_path):
    """That of the robot with one more mode per direction may be lost first; frequencies are printed all the same."""

    def lost(*_):
        raise np.linalg.LinAlgError("not positive definite")

    monkeypatch.setattr(import_module("screwgen.studies.convergence"), "vibrations", lost)
    path = tmp_path / "arm.toml"
    path.write_text(robot(np.random.default_rng(0), 0.0))
    assert main(["modes", str(path)]) == 0
    out, err = capsys.readouterr()
    assert "Hz              ?" in out and err.startswith("screwgen: note: ")
    assert "the mass matrix is singular to rounding; masses or lengths differ" in err


def test_derivatives_that_are_not_finite_are_said(capsys, monkeypatch, tmp_path):
    real = linearised._directional
    lost = lambda chain: lambda *given: [real(chain)(*given)[0] * np.inf]  # noqa: E731
    monkeypatch.setattr(linearised, "_directional", lost)
    path = tmp_path / "arm.toml"
    path.write_text(robot(np.random.default_rng(0), 0.0))
    with np.errstate(invalid="ignore"):
        assert main(["analyse", str(path), "--samples", "0"]) == 0
    assert "the accelerations have no finite derivatives" in " ".join(capsys.readouterr().out.split())
