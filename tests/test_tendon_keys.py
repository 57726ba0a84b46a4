"""Tendons in robot files: what is refused, in one line with its remedy, and what is read and written."""

from __future__ import annotations

import pytest

from screwgen import RobotFileError
from screwgen.spec.load import dump, loads

FILE = """
name = "pulled"
gravity = [0.0, 0.0, -9.81]

[[links]]
name = "arm"
length = 0.5
section = {{ rhoA = 1.0, EIy = 5.0, EIz = 4.0 }}
modes = {{ {modes} }}
joint = {{ axes = ["z"] }}
tendons = [{tendons}]
"""
AT = "at = [[0.0, 0.01, 0.0], [0.0, 0.005, 0.0]]"


def written(tendons: str, modes: str = "bending_y = 1") -> str:
    return FILE.format(tendons=tendons, modes=modes)


@pytest.mark.parametrize(
    "tendons, modes, said",
    [
        (f"{{ {AT} }}", "bending_y = 1", "name (link arm): is missing"),
        ('{ name = "a" }', "bending_y = 1", "at (link arm): is missing; state its offsets"),
        (f'{{ name = "a b", {AT} }}', "bending_y = 1", "it must be a C identifier"),
        ('{ name = "a", at = [[0.0, 0.01, 0.0]] }', "bending_y = 1", "has 1 entries; it must be two offsets"),
        ('{ name = "a", at = [[0.0, 0.01], [0.0, 0.01]] }', "bending_y = 1", "3"),
        ('{ name = "a", at = [[0.1, 0.01, 0.0], [0.0, 0.0, 0.0]] }', "bending_y = 1", "from and to say where the ends"),
        (f'{{ name = "a", from = 0.8, to = 0.3, {AT} }}', "bending_y = 1", "it must be beyond 0.8"),
        (f'{{ name = "a", from = -0.1, {AT} }}', "bending_y = 1", "it must be from 0 at the base to 1 at the tip"),
        (f'{{ name = "a", start = 0.1, {AT} }}', "bending_y = 1", "is an unknown key"),
        (f'{{ name = "a", actuated = 1, {AT} }}', "bending_y = 1", "true or false"),
        (f'{{ name = "a", {AT} }}', "", "give the link modes"),
        (", ".join(f'{{ name = "a{k}", {AT} }}' for k in range(65)), "bending_y = 1", "at most 64 tendons"),
        (f'{{ name = "a", foo = 1, bar = 2, {AT} }}', "bending_y = 1", "actuated; 1 more fault in the file"),
        (f'{{ name = "a", {AT} }}, {{ name = "a", actuated = false, {AT} }}', "bending_y = 1", "have one tension"),
    ],
)
def test_wrong_tendons_are_refused_in_a_line(tendons, modes, said):
    with pytest.raises(RobotFileError) as refused:
        loads(written(tendons, modes), "pulled.toml")
    text = str(refused.value)
    assert said in text and "tendons" in text and "\n" not in text


def test_files_are_written_as_they_are_read():
    robot = loads(written(f'{{ name = "a", from = 0.1, to = 0.8, {AT} }}'), "pulled.toml")
    assert "from = 0.1" in dump(robot)
    assert loads(dump(robot), "pulled.toml") == robot
