"""The example of two units in its short form: its own assertions hold, and it draws."""

import importlib

import pytest
from helpers import ROOT

pytestmark = pytest.mark.examples


def test_two_units_move_together(monkeypatch, capsys, tmp_path):
    monkeypatch.syspath_prepend(str(ROOT / "examples"))
    figures = importlib.import_module("fmu_motor").main(["--short", "-o", str(tmp_path)])
    assert figures["apart"] < 1e-5
    assert "mrad from the goal" in capsys.readouterr().out
    for name in ("fmu_motor.png", "fmu_fall.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")
