"""Intervals of a linear fit whose windows have starts of their own, in many draws of the noise."""

import numpy as np
import pytest

from screwgen.identification.beside import how_of
from screwgen.identification.problem import Problem
from screwgen.identification.solve import Fit
from screwgen.identification.uncertainty import uncertainty
from screwgen.identification.unknowns import FreeNumber, Unknowns

WINDOWS, SAMPLES, STATES, SOUGHT, DRAWS = 8, 50, 12, 4, 200
NOISE = 0.1


class Lines:
    """Readings that are linear in what is sought and in the starts of windows: slow waves of some phases."""

    names, stated, states, step, spread = ["y"], np.array([np.nan]), np.arange(STATES), 0.01, np.ones(1)

    def __init__(self, rng):
        t = np.linspace(0.0, 1.0, SAMPLES)[:, None]
        waves = lambda n: np.cos(rng.uniform(0, 12, (WINDOWS, 1, n)) * t + rng.uniform(0, 7, (WINDOWS, 1, n)))  # noqa: E731
        self.by_p, self.by_x = 3 * waves(SOUGHT), 3 * waves(STATES)
        self.compared = np.zeros((WINDOWS, SAMPLES, 1))

    def differences(self, problem, window, sought, shift):
        made = self.by_p[window] @ sought[..., None] + self.by_x[window] @ shift[..., None]
        return self.compared[window] - made

    def continued(self, problem, sought, shift):
        return shift

    def linearised(self, problem, sought, shift):
        every = np.arange(WINDOWS)
        found = self.differences(problem, every, np.tile(sought, (WINDOWS, 1)), shift)
        return found, -self.by_p[:, :, None], -self.by_x[:, :, None]


def deviates(noise, seed=1):
    """(draws, sought): errors over half intervals, where the truth is 0; `noise` of a generator (WINDOWS, SAMPLES)."""
    rng = np.random.default_rng(seed)
    group, out = Lines(rng), []
    asked = Unknowns([FreeNumber(f"a{k}", "parameter", 0.0, "", False, 1.0) for k in range(SOUGHT)])
    for _ in range(DRAWS):
        group.compared = noise(rng)[..., None] + group.by_x @ rng.standard_normal((WINDOWS, STATES, 1))
        fit = Fit(Problem(None, [group], asked, how_of("modal_midpoint", 1, 1)), robust=False)
        at = fit.run(20, np.zeros(SOUGHT))
        known = uncertainty(fit, at)
        out.append(at.sought / (known.quantile * known.deviation))
    return np.array(out)


def white(rng):
    return NOISE * rng.standard_normal((WINDOWS, SAMPLES))


def lasting(rng):
    """Noise that lasts for a while, as what a model lacks."""
    return NOISE * np.repeat(rng.standard_normal((WINDOWS, SAMPLES // 10)), 10, axis=1)


@pytest.mark.parametrize(("noise", "most"), [(white, 0.98), (lasting, 1.0)])
def test_intervals_hold_the_number_in_95_of_100_cases(noise, most):
    """Though a window has a start for every four of its samples, which follow the noise."""
    held = np.abs(deviates(noise)) < 1
    assert 0.92 <= held.mean() <= most, held.mean(axis=0)
    assert held.mean(axis=0).min() >= 0.9
