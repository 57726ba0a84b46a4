"""Intervals of identified numbers: how often they hold the true ones, and what is said where the model is wrong."""

import numpy as np
import pytest
from identified_arms import SENSORS, TRUE, elsewhere, swing

import screwgen
from screwgen.identification.logs import Log

RUNS = 200


def noisy(clean: Log, seed: int, share: float = 0.01) -> Log:
    """The log with other noise."""
    rng, own = np.random.default_rng(seed), dict(clean.columns)
    for name in ("angle", "gauge"):
        own[name] = own[name] + share * own[name].std() * rng.standard_normal(len(clean))
    return Log(clean.name, clean.t, own)


def coverage(runs: int, seconds: float = 2.0, step: float = 2e-3) -> dict[str, float]:
    """The share of runs in which the interval of each number holds the true one."""
    clean, model = swing(seconds, step, 0.0), elsewhere()
    held = dict.fromkeys(TRUE, 0)
    for seed in range(runs):
        found = screwgen.identify(model, noisy(clean, seed), free=list(TRUE), sensors=SENSORS, window=0.5)
        for name, true in TRUE.items():
            held[name] += found[name].low <= true <= found[name].high
    return {name: count / runs for name, count in held.items()}


@pytest.mark.long
def test_intervals_hold_the_true_number_in_95_of_100_cases():
    """Of six numbers together, in 200 logs with other noise."""
    shares = coverage(RUNS)
    assert 0.92 <= np.mean(list(shares.values())) <= 0.98, shares
    assert min(shares.values()) >= 0.9, shares
