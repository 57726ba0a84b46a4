"""The Bode example in short form: it ends in assertions about its figures, and prints its resonances."""

import importlib
import re

import pytest
from helpers import ROOT


@pytest.fixture
def bode(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "examples"))
    return importlib.import_module("bode_ella")


def test_bode_example(bode, capsys, tmp_path):
    assert bode.main(["--quick", "-o", str(tmp_path / "bode.png")]) == 0
    text = capsys.readouterr().out
    rows = re.findall(r"^ (\d\.\d) kg +([\d.]+) mm +(.*)$", text, re.MULTILINE)
    assert [(mass, sag) for mass, sag, _ in rows] == [("2.1", "36.8"), ("0.0", "19.0")]
    lowest = [float(hertz.split()[0]) for *_, hertz in rows]
    assert abs(lowest[0] - 9.166) < 0.01 and abs(lowest[1] - 16.310) < 0.01
    assert (tmp_path / "bode.png").read_bytes().startswith(b"\x89PNG")


def test_bad_output_is_one_line(bode, capsys, tmp_path):
    assert bode.main(["-o", str(tmp_path / "bode.jpg")]) == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1 and "must end in .png" in err and not list(tmp_path.iterdir())
