"""Intervals of identified numbers: how often they hold the true ones, and what is said where the model is wrong."""

from collections.abc import Sequence

import numpy as np
import pytest
from identified_arms import SENSORS, TRUE, elsewhere, swing
from synthetic_logs import logged

import screwgen
from screwgen.identification.logs import Log

RUNS = 200


def noisy(clean: Log, seed: int, sensors: Sequence[str], share: float = 0.01) -> Log:
    """The log with other noise on sensors."""
    rng, own = np.random.default_rng(seed), dict(clean.columns)
    for name in sensors:
        own[name] = own[name] + share * own[name].std() * rng.standard_normal(len(clean))
    return Log(clean.name, clean.t, own)


def coverage(model, clean: Log, true, columns, runs: int) -> dict[str, float]:
    """The share of runs in which the interval of each number holds the true one."""
    held = dict.fromkeys(true, 0)
    for seed in range(runs):
        log = noisy(clean, seed, [column.name for column in columns.sensors])
        found = screwgen.identify(model, log, free=list(true), sensors=columns, window=0.5)
        for name, value in true.items():
            held[name] += found[name].low <= value <= found[name].high
    return {name: count / runs for name, count in held.items()}


def pendulum():
    return elsewhere(), swing(2.0, 2e-3, 0.0), TRUE, SENSORS


def gantry():
    model, log, columns, true = logged("gantry", 4.0, 2e-3, 0.0)
    return model, log, true, columns


@pytest.mark.long
@pytest.mark.parametrize("robot", [pendulum, gantry])
def test_intervals_hold_the_true_number_in_95_of_100_cases(robot):
    """Of six and of eight numbers together, in 200 logs with other noise."""
    shares = coverage(*robot(), RUNS)
    assert 0.92 <= np.mean(list(shares.values())) <= 0.98, shares
    assert min(shares.values()) >= 0.9, shares
