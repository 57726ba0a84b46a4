"""What noise in the starts of windows seems to tell: how often it is taken for what data tell, and data for it."""

import numpy as np
import pytest

from screwgen.identification.beside import how_of
from screwgen.identification.problem import Problem
from screwgen.identification.solve import Fit
from screwgen.identification.start_noise import CHANCE, beyond_noise, chance
from screwgen.identification.uncertainty import uncertainty
from screwgen.identification.unknowns import FreeNumber, Unknowns

SAMPLES, STEP, NOISE, LOGS = 100, 5e-3, 0.1, 20


class Vibration:
    """Readings of a vibration whose frequency goes with the root of what is sought, of some size in every window."""

    names, stated, states, spread, step = ["y"], np.array([np.nan]), np.arange(2), np.ones(1), STEP

    def __init__(self, windows):
        self.t, self.compared = STEP * np.arange(SAMPLES), np.zeros((windows, SAMPLES, 1))

    def waves(self, p):
        w = 40.0 * np.exp(np.asarray(p)[..., None] / 2) * self.t
        return np.cos(w), np.sin(w), w / 2

    def made(self, p, shift):
        cos, sin, _ = self.waves(p)
        return (shift[:, :1] * cos + shift[:, 1:] * sin)[..., None]

    def differences(self, problem, window, sought, shift):
        return self.compared[window] - self.made(sought[:, 0], shift)

    def continued(self, problem, sought, shift):
        return shift

    def linearised(self, problem, sought, shift):
        every = np.arange(len(shift))
        cos, sin, slope = self.waves(sought[0])
        by_p = (shift[:, :1] * sin - shift[:, 1:] * cos) * slope
        by_x = np.broadcast_to(-np.stack([cos, sin], -1)[None, :, None], (len(shift), SAMPLES, 1, 2))
        found = self.differences(problem, every, np.tile(sought, (len(shift), 1)), shift)
        return found, by_p[..., None, None], by_x


def told(windows, size, seed):
    """Whether a log tells the number that is sought, of vibrations so many times as large as noise makes them."""
    rng, group = np.random.default_rng(seed), Vibration(windows)
    phase, alone = rng.uniform(0, 2 * np.pi, windows), NOISE * np.sqrt(2 / SAMPLES)
    starts = size * alone * np.stack([np.cos(phase), np.sin(phase)], axis=1)
    group.compared = group.made(np.zeros(windows), starts) + NOISE * rng.standard_normal((windows, SAMPLES, 1))
    asked = Unknowns([FreeNumber("a", "parameter", 1.0, "", True, 1.0)])
    fit = Fit(Problem(None, [group], asked, how_of("modal_midpoint", 1, 1)), robust=False)
    return not uncertainty(fit, fit.run(40, np.array([0.2]))).directions


@pytest.mark.parametrize("windows", [1, 4])
def test_noise_tells_nothing_and_vibrations_beyond_it_do(windows):
    """In a log of one window, too, where noise varies most."""
    assert sum(told(windows, 0.0, seed) for seed in range(LOGS)) <= 1
    assert sum(told(windows, 6.0 if windows == 1 else 3.5, seed) for seed in range(LOGS)) >= LOGS - 2


@pytest.mark.parametrize(("freedom", "draws"), [(2, 8), (8, 1), (16, 8)])
def test_the_chance_is_that_of_a_search_of_noise(freedom, draws):
    """The largest χ² of cosines with random sizes on ± 1, over the mean of draws, passes the level no more often."""
    rng, x, runs = np.random.default_rng(1), np.linspace(-1.0, 1.0, 200), 4000
    rates = np.linspace(0.5, 6.0, 12)
    speed = np.sqrt(np.mean(rates**2))
    basis = np.concatenate([np.cos(np.outer(rates, x)), np.sin(np.outer(rates, x))]) / np.sqrt(len(rates))
    found = np.zeros((runs, len(x)))
    for _ in range(freedom):
        found += (rng.standard_normal((runs, len(basis))) @ basis) ** 2
    drawn = rng.chisquare(freedom * draws, runs) / draws
    ratio = np.sort(found.max(axis=1) / drawn)
    for share in (0.1, 0.03, 0.01):
        said = chance(float(ratio[int((1 - share) * runs)]), freedom, draws, speed)
        assert 0.7 * share < said < 2.0 * share


def test_directions_are_told_in_any_scale():
    """What noise alone tells is left out wherever it lies, and what is not in noise stays as it is."""
    rng = np.random.default_rng(0)
    mix = rng.standard_normal((3, 3)) * [[1.0], [1e3], [1e-3]]
    made = rng.chisquare(2, (8, 6, 1, 1)) * np.diag([0.0, 0.0, 1.0])
    A = np.diag([50.0, 2.0, 12.0])
    kept, all_told = beyond_noise(mix @ A @ mix.T, mix @ made @ mix.T)
    assert not all_told and CHANCE == 0.01
    assert kept == pytest.approx(mix @ np.diag([50.0, 2.0, 0.0]) @ mix.T, rel=1e-6, abs=1e-9 * np.abs(kept).max())
    kept, all_told = beyond_noise(mix @ (20 * A) @ mix.T, mix @ made @ mix.T)
    assert all_told and kept == pytest.approx(20 * mix @ A @ mix.T, rel=1e-6)
