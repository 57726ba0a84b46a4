"""Modes against geometrically exact beams that Exudyn has moved: `make exact-beams` made the records."""

import json
import sys

import numpy as np
import pytest
from conftest import swept
from helpers import ROOT, QuickModel

import screwgen

sys.path.insert(0, str(ROOT / "bench"))

import exact_beams
import exact_slider_crank
import exact_swings

read = lambda name: json.loads((ROOT / "tests" / name).read_text(encoding="utf-8"))  # noqa: E731
RECORD, SOFT, SWINGS = (read(f"{n}.json") for n in ("ella_exact_beams", "ella_soft_exact_beams", "exact_swings"))
SAG = 394.0
"""Of the arm whose bending stiffness is a ninth, mm."""


def judge_of(record: dict) -> exact_beams.Samples:
    assert record["motion"] == exact_beams.MOTION
    return exact_beams.Samples(*(np.array(record[name]) for name in ("t", "tip", "moments")))


def compared(record: dict, robot) -> tuple[float, np.ndarray]:
    """How far the tip is off in mm, and the moments of base and elbow in % of their peaks."""
    judge = judge_of(record)
    run = exact_beams.thinned(exact_beams.modes_run(robot, sample=exact_beams.RECORDED))
    assert run.t == pytest.approx(judge.t)
    tip, moments = run.off(judge)
    return 1e3 * tip, 100 * moments / record["peaks"]


@pytest.mark.parametrize("order, millimetres, percent", [(1, 0.5, 0.5), (2, 0.1, 0.05)])
def test_two_polynomials_follow_exact_beams(order, millimetres, percent):
    tip, moments = compared(RECORD, exact_beams.arm("polynomial", 2, order))
    assert tip < millimetres
    assert np.all(moments < percent)


def test_one_clamped_free_mode_does_not():
    tip, moments = compared(RECORD, exact_beams.arm("clamped_free", 1))
    assert 5 < tip < 20
    assert np.all(moments > 2)


def soft(order: int, pieces: int) -> screwgen.Robot:
    return exact_beams.pieced(exact_beams.arm("polynomial", 2, order, SOFT["softer"]), pieces)


@pytest.mark.parametrize("order, pieces, share", [(1, 1, 0.035), (2, 1, 0.012), (2, 2, 0.002)])
def test_an_arm_that_hangs_through_rests_where_exact_beams_do(order, pieces, share):
    """After 0.1 s of the motion the reference has hardly begun to move. Distances over the sag of the tip."""
    start = exact_beams.RECORDED
    judge = np.array(SOFT["tip"][0])
    assert SOFT["t"][0] == start and -1e3 * judge[2] == pytest.approx(SAG, abs=0.5)
    apart = 1e3 * np.linalg.norm(screwgen.equilibrium(screwgen.derive(soft(order, pieces))).tip_position - judge)
    assert 0.5 * share < apart / SAG < share


@pytest.mark.long
def test_an_arm_that_hangs_through_moves_as_exact_beams_do():
    """Three pieces of order 2 a link; the tip stays within 1 % of the sag."""
    tip, moments = compared(SOFT, soft(2, 3))
    assert tip < 0.01 * SAG
    assert np.all(moments < 0.5)


@pytest.mark.parametrize("name, modes, pieces, share", [("spin_up", 4, 1, 1e-4), ("pendulum", 2, 2, 3e-3)])
def test_beams_that_turn_and_swing_follow_exact_ones(name, modes, pieces, share):
    """The tip, over its travel."""
    case, judge = exact_swings.CASES[name], np.array(SWINGS[name]["tip"])
    assert SWINGS[name]["t"] == pytest.approx(exact_swings.times(case)[1:])
    assert exact_swings.off(exact_swings.modes_run(case, modes, 2, pieces), judge, case)[1] < share


@pytest.mark.parametrize("which", swept([(3, 2, 2e-3), (2, 2, 0.06), (3, 1, 0.2)], (3, 2, 2e-3)))
@pytest.mark.filterwarnings("ignore::screwgen.ModelValidityWarning")
def test_the_rod_of_a_slider_crank_bends_as_an_exact_beam(which):
    """A rod in two pieces. The slider, over its travel; the rod's middle, over its largest deflection from the chord.

    Without order 2 the rod does not feel how inertia presses and pulls it: at most half of the buckling load.
    """
    (modes, order, share), record = which, read("exact_slider_crank.json")
    judge = np.stack([record["slider"], record["middle"]], axis=1)
    run = exact_slider_crank.modes_run(modes, order, longest=2e-5, derive=QuickModel)
    slider, middle = exact_slider_crank.off(run, judge)
    assert slider < (2e-4 if order == 2 else 1e-3)
    assert share / 5 < middle < share


def test_the_arm_starts_where_pd_holds_it():
    """The spring at the base carries the weights, at their levers along the nearly straight arm."""
    start = screwgen.equilibrium(screwgen.derive(exact_beams.arm("polynomial", 2))).q
    assert start[1:3] == pytest.approx(0, abs=1e-12)
    weight = 9.81 * (1.6302 * (0.95**2 / 2 + 0.93 * (0.95 + 0.93 / 2)) + 3.3 * 0.95 + 2.1 * 1.88)
    assert exact_beams.MOTION["kp"][0] * start[0] == pytest.approx(weight, rel=2e-3)
