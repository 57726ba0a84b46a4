"""ELLA's modes against geometrically exact beams that Exudyn has moved: `make exact-beams` made the record."""

import json
import sys
from pathlib import Path

import numpy as np
import pytest

import screwgen

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "bench"))

import exact_beams  # noqa: E402

RECORD = json.loads((ROOT / "tests" / "ella_exact_beams.json").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def judge() -> exact_beams.Samples:
    assert RECORD["motion"] == exact_beams.MOTION
    return exact_beams.Samples(*(np.array(RECORD[name]) for name in ("t", "tip", "moments")))


def compared(judge: exact_beams.Samples, basis: str, count: int) -> tuple[float, np.ndarray]:
    """How far the tip is off in mm, and the moments of base and elbow in % of their peaks."""
    run = exact_beams.thinned(exact_beams.modes_run(basis, count, sample=exact_beams.RECORDED))
    assert run.t == pytest.approx(judge.t)
    tip, moments = run.off(judge)
    return 1e3 * tip, 100 * moments / RECORD["peaks"]


def test_two_polynomials_follow_exact_beams(judge):
    tip, moments = compared(judge, "polynomial", 2)
    assert tip < 0.5
    assert np.all(moments < 0.5)


def test_one_clamped_free_mode_does_not(judge):
    tip, moments = compared(judge, "clamped_free", 1)
    assert 5 < tip < 20
    assert np.all(moments > 2)


def test_the_arm_starts_where_pd_holds_it():
    """The spring at the base carries the weights, at their levers along the nearly straight arm."""
    start = screwgen.equilibrium(screwgen.derive(exact_beams.arm("polynomial", 2))).q
    assert start[1:3] == pytest.approx(0, abs=1e-12)
    weight = 9.81 * (1.6302 * (0.95**2 / 2 + 0.93 * (0.95 + 0.93 / 2)) + 3.3 * 0.95 + 2.1 * 1.88)
    assert exact_beams.MOTION["kp"][0] * start[0] == pytest.approx(weight, rel=2e-3)
