"""The judges of the paper's last sections: a frame of beam elements, a beam by Ritz's method, steps of Table 1."""

import numpy as np
import pytest

from screwgen.paper.arm import SECTION
from screwgen.paper.cauchy_state import measured_states, rate, solution_misfits, step_defects
from screwgen.paper.clamped_beam import Beam
from screwgen.paper.ella_judges import euler_growth, loop_work, root, symplectic_limit
from screwgen.paper.equation import TOLERANCE
from screwgen.paper.errata_ella import arm
from screwgen.paper.frame_elements import ELEMENTS, Bar, arm_bars, arm_frequencies, frequencies
from screwgen.paper.random_motion import RandomMotion

CLAMPED_FREE = [1.8751040687119611, 4.694091132974175, 7.854757438237613]
WITH_TIP_MASS = {1.0: [1.557298, 16.250085], 0.1: [2.967838, 19.355801]}
"""``(beta L)^2`` of a clamped beam with a tip mass of so many times its own: published."""


def scaled(L, EI, rhoA):
    """Frequency in Hz of ``(beta L)^2 = 1``."""
    return np.sqrt(EI / rhoA) / L**2 / (2 * np.pi)


def test_ritz_and_roots_give_the_published_numbers():
    beam = Beam(0.7, 900.0, 1.3)
    assert np.allclose(beam.frequencies(3) / scaled(0.7, 900.0, 1.3), np.square(CLAMPED_FREE), rtol=1e-12)
    assert np.allclose([root(n) for n in (1, 2, 3)], CLAMPED_FREE, rtol=1e-14)
    for mu, published in WITH_TIP_MASS.items():
        assert np.allclose(Beam(1.0, 1.0, 1.0, mu).squares[:2] ** 0.5, published, rtol=1e-6)
        assert np.allclose([root(n, mu) ** 2 for n in (1, 2)], published, rtol=1e-6)


def test_one_bar_of_elements_is_a_clamped_beam():
    bar = Bar(np.eye(3), 0.93, 0.0)
    z, y = (scaled(0.93, EI, SECTION.rhoA) for EI in (SECTION.EIy, SECTION.EIz))
    expected = sorted(unit * w**2 for unit in (y, z) for w in CLAMPED_FREE[:2])
    high = [(w / ELEMENTS) ** 4 / 1440 for w in CLAMPED_FREE[:2]]  # what a cubic element is too stiff by
    assert np.allclose(frequencies([bar])[:4] / expected - 1, np.repeat(high, 2), rtol=0.02)


def test_two_bars_in_line_are_one_beam():
    halves = [Bar(np.eye(3), 0.5, 0.0), Bar(np.eye(3), 0.5, 2.0)]
    assert np.allclose(frequencies(halves)[:4], frequencies([Bar(np.eye(3), 1.0, 2.0)])[:4], rtol=1e-6)


def test_the_elements_have_converged_and_do_not_care_for_axes():
    turned = [Bar(b.R, b.length, b.tip_mass) for b in arm_bars((0.0, 0.0, 0.4270))]
    assert np.allclose(frequencies(turned)[:4], arm_frequencies()[:4], rtol=1e-9)
    assert np.allclose(frequencies(arm_bars(), elements=12)[:2], arm_frequencies()[:2], rtol=1e-6)


@pytest.mark.parametrize("section_rotation", [True, False])
def test_the_derived_arm_has_the_frequencies_of_the_elements(section_rotation):
    error = np.abs(arm(section_rotation)[:4] / arm_frequencies(section_rotation)[:4] - 1)
    assert error[:3].max() < 1e-6
    assert error[3] < 2e-5  # it feels the links' stretching, of which the two axial modes leave this much out


@pytest.mark.parametrize("seed", [1, 2, 3, 4, 5])
def test_the_completed_system_gives_the_motion_and_the_printed_one_does_not(seed):
    motion = RandomMotion(seed)
    M = motion.values["M_sys:all"]
    assert np.linalg.matrix_rank(M, tol=1e-9 * np.linalg.norm(M)) == len(M) - 4  # two links, two axes each
    printed, completed = solution_misfits(motion.values, motion.links)
    assert printed > 1e-2 and completed <= TOLERANCE


@pytest.mark.parametrize("name", ["Zdot_star", "etaddot_star", "etadot", "Z"])
def test_a_wrong_rate_shows_in_a_step(name):
    motion = RandomMotion(2)
    assert step_defects(motion.values, motion.links)[1] <= TOLERANCE
    wrong = motion.values[f"{name}:all"].copy()
    wrong[0] *= 1.01
    motion.values[f"{name}:all"] = wrong
    assert step_defects(motion.values, motion.links)[1] > 1e-5


def test_rates_by_extrapolation():
    assert abs(rate(np.sin) - 1) < 1e-13
    states = measured_states(RandomMotion(1).links)
    assert states.shape == (2 * 24, 1)


def test_steps_of_an_oscillation():
    omega = 40.0
    assert euler_growth(omega, 1e-3) == pytest.approx(np.hypot(1, omega * 1e-3), rel=1e-12)
    assert symplectic_limit(omega) == pytest.approx(2 / omega, rel=1e-3)


def test_a_spring_on_joint_angles_does_no_work_round_a_closed_path():
    printed, joints, amount = loop_work(np.array([0.0, 80.0, 120.0]), 0.4)
    assert abs(joints) < 1e-12 < 0.1 < abs(printed) <= amount
