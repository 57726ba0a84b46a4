"""Random robots with everything at once against the oracle; `python tests/mixed_arms.py 0 300` judges more of them."""

import numpy as np
import pytest
from conftest import swept
from helpers import arm, link, model_of
from mixed_arms import drawn, judged, layout_of

KEPT = (3, 5)
LOCKED = 91060
"""Whose loop takes away all accelerations of its joints."""
BEHIND = 95064
"""Among whose tips a marker of a force comes after that of the last link."""


@pytest.mark.parametrize("seed", [*swept(range(24), 1, KEPT[0]), LOCKED])
def test_a_random_robot_equals_the_oracle_in_every_back_end(seed, tmp_path):
    judged(drawn(seed, tmp_path), "modular" if seed in KEPT else layout_of(seed))


@pytest.mark.parametrize("seed", [*swept(range(93001, 93013), 93010), BEHIND])
def test_a_random_robot_with_ball_joints_springs_tendons_and_markers_equals_the_oracle(seed, tmp_path):
    judged(drawn(seed, tmp_path, dress=True), layout_of(seed))


def test_rows_of_a_loop_that_stays_open_are_kept():
    """Where the gap is smallest, rows depend on each other: that is no place to judge them."""
    slider = link(
        "slider", 0.1, [{"slide": [np.cos(0.5), 0.0, np.sin(0.5)]}], joint={"mount": {"rpy": [0.0, 0.5, 0.0]}}
    )
    swing = link("swing", 0.3, "y", parent="world", joint={"mount": {"xyz": [0.0, 0.0, 1.0]}})
    ball = {"between": ["slider.tip", "swing.tip"], "joint": {"axes": ["x", "y", "z"]}}
    assert [row.text[-1] for row in model_of(arm(slider, swing) | {"loops": [ball]}).chain.closing.rows] == ["x", "z"]
