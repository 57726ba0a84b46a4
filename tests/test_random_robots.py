"""Random robots against the oracle: of every kind of link and joint, and with everything at once in every back end.

`python tests/mixed_arms.py 0 300` judges more of those with everything.
"""

from collections.abc import Callable
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import flexible_robots as fr
import mixed_arms
import numpy as np
import pytest
import random_robots as rr
from conformance import numbers
from conformance.judge import Judge
from conformance.twin import as_turns
from conftest import swept
from helpers import arm, link, model_of

from screwgen.elements import CYLINDER, STOP

KEPT = (3, 5)


@pytest.mark.parametrize("seed", swept(range(24), *KEPT))
def test_with_everything_in_every_back_end(seed, tmp_path):
    every, layouts = mixed_arms.EVERY, mixed_arms.LAYOUTS
    layout = "modular" if seed in KEPT else layouts[seed // every % 2] if seed % every == 0 else None
    mixed_arms.judged(mixed_arms.drawn(seed, tmp_path), layout)


class Sweep(NamedTuple):
    """Robots of one kind: their seeds, of which some are `kept`; by the seed `links[0]` to `links[1]` links."""

    seeds: range
    kept: tuple[int, ...]
    links: tuple[int, int]
    limits: dict
    has: Callable
    """What each of the kept ones has in its chain."""


SWEEPS = {
    "second order": Sweep(
        range(700, 740),
        (701, 706),
        (1, 4),
        dict(second_order=0.7, stations=0.3),
        lambda chain: any(key.order == 2 for key in chain.keys),
    ),
    "damping of the material": Sweep(
        range(2300, 2330),
        (2300, 2303),
        (1, 2),
        dict(time=0.8, exact=0.3, second_order=0.3, stations=0.4, shear=0.3, branching=0.3),
        lambda chain: any("time" in key.damping for key in chain.keys),
    ),
    "shear": Sweep(
        range(1500, 1530),
        (1504, 1514, 1515),
        (1, 4),
        dict(second_order=0.5, stations=0.4, shear=0.7, rigid=0.1),
        lambda chain: any(any(key.counts[4:]) for key in chain.keys),
    ),
    "stations": Sweep(
        range(700, 716), (700, 703, 709), (1, 4), dict(stations=0.75, rigid=0.1), lambda chain: bool(chain.coupled)
    ),
    "bodies from files": Sweep(
        range(900, 940),
        (901, 902),
        (1, 3),
        dict(robots=fr.random_arm, states=fr.random_state, second_order=0.3, stations=0.2, max_modes=2),
        lambda chain: any(key.elastic for key in chain.keys),
    ),
    "slides and screws": Sweep(
        range(7000, 7024),
        (7001, 7002),
        (1, 4),
        dict(sliding=0.7, second_order=0.2),
        lambda chain: not all(screw.turn for link in chain.robot.links for screw in link.joint.screws),
    ),
    "trees": Sweep(
        range(9000, 9024),
        (9001, 9005),
        (3, 8),
        dict(branching=0.7, sliding=0.2, second_order=0.1, max_modes=1),
        lambda chain: not chain.tree.is_chain,
    ),
    "cylinders": Sweep(
        range(8100, 8116),
        (8103, 8104),
        (1, 3),
        dict(drives=0.5, cylinders=0.7, sliding=0.2, branching=0.3),
        lambda chain: CYLINDER in chain.travels.values(),
    ),
    "stops": Sweep(
        range(8800, 8824),
        (8801, 8803),
        (1, 4),
        dict(stops=0.9, drives=0.3, sliding=0.3, branching=0.3),
        lambda chain: bool(chain.acted(STOP)),
    ),
}


@cache
def case_of(kind: str, seed: int) -> mixed_arms.Mixed:
    sweep = SWEEPS[kind]
    least, most = sweep.links
    count = least + seed % (most - least + 1)
    robot, state, oracle = rr.draw_regular(np.random.default_rng(seed), count, **sweep.limits)
    with TemporaryDirectory() as folder:
        found = mixed_arms.Mixed(Judge(robot, as_turns(robot), oracle, state), Path(folder))
        assert found.model.chain.n >= count
    return found


ALL = [x for kind, own in SWEEPS.items() for x in swept([(kind, n) for n in own.seeds], *((kind, n) for n in own.kept))]


@pytest.mark.parametrize("robot", ALL, ids=lambda robot: "{}-{}".format(*robot))
def test_of_every_kind(robot):
    """Both forms by NumPy, inverse dynamics, mass matrix and energy."""
    case = case_of(*robot)
    numbers.judge(case)
    numbers.numpy_dae(case)


@pytest.mark.parametrize("kind", SWEEPS)
def test_the_robots_have_what_they_should(kind):
    assert all(SWEEPS[kind].has(case_of(kind, seed).model.chain) for seed in SWEEPS[kind].kept)


def test_rows_of_a_loop_that_stays_open_are_kept():
    """Where the gap is smallest, rows depend on each other: that is no place to judge them."""
    slider = link(
        "slider", 0.1, [{"slide": [np.cos(0.5), 0.0, np.sin(0.5)]}], joint={"mount": {"rpy": [0.0, 0.5, 0.0]}}
    )
    swing = link("swing", 0.3, "y", parent="world", joint={"mount": {"xyz": [0.0, 0.0, 1.0]}})
    ball = {"between": ["slider.tip", "swing.tip"], "joint": {"axes": ["x", "y", "z"]}}
    assert [row.text[-1] for row in model_of(arm(slider, swing) | {"loops": [ball]}).chain.closing.rows] == ["x", "z"]
