"""The tentacle of examples/tentacle.py: measured shapes that the fit has not seen; what mirrors what."""

import importlib

import numpy as np
import pytest
from helpers import ROOT

PUBLISHED = 15.8
"""mm: the published mean distance with fitted E, nu and density, by another model of the same kind."""


@pytest.fixture
def tentacle(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "examples"))
    return importlib.import_module("tentacle")


@pytest.mark.examples
def test_markers_of_other_shapes_are_within_12_mm(tentacle, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(tentacle, "FOLDER", tmp_path)
    tentacle.main()
    (line,) = [x for x in capsys.readouterr().out.splitlines() if "the other shapes" in x]
    guessed, fitted = map(float, line.split()[-2:])
    assert fitted <= 12.0 < PUBLISHED < guessed
    assert (tmp_path / "tentacle.png").stat().st_size > 20_000


def test_two_tendons_pull_alike(tentacle):
    """Equal tensions keep the tentacle in its plane; one pulled or the other is the mirrored shape."""
    arm, S = tentacle.Tentacle(), np.array([1.0, -1.0, 1.0])
    p = arm.parameters(**tentacle.GUESS)
    ends = [arm.model.numpy(p).tip_pose(arm.rest(np.array(T), p))[1] for T in ((4.0, 0.0), (0.0, 4.0), (3.0, 3.0))]
    assert ends[0] == pytest.approx(S * ends[1], abs=1e-8)
    assert ends[2][1] == pytest.approx(0.0, abs=1e-8)
    assert ends[2][0] > 0.05
