"""Measured frequencies in place of stiffness: against stiffness, the oracle, and the frequencies themselves.

`K_kk = M_kk (2π f_k)²`, the paper's wavenumber identification mode by mode.
"""

from __future__ import annotations

import copy

import numpy as np
import pytest
from conftest import swept
from helpers import casadi_forward, model_of, quick, relative
from measured_robots import BARE, FOUND, bare_frequencies, counted, flat, rod
from oracle_shapes import DIRECTIONS

from screwgen import natural_frequencies

# -------- a file with frequencies and the file with the stiffness that they amount to


# -------- frequencies of no uniform beam, against the oracle


# -------- the clamped bare link has the frequencies that the file states


def test_the_clamped_bare_link_has_the_stated_frequencies():
    assert np.allclose(bare_frequencies(FOUND), flat(FOUND), rtol=1e-12, atol=0)


@pytest.mark.long
@pytest.mark.parametrize("direction", DIRECTIONS[:4])
def test_32_modes_in_a_direction(direction):
    """Of shear none are stated."""
    ratio = np.random.default_rng(1).uniform(1.05, 1.4, 32)
    frequencies = {direction: [float(f) for f in np.cumprod(ratio)]}
    assert np.allclose(bare_frequencies(frequencies), flat(frequencies), rtol=1e-12, atol=0)


@pytest.mark.parametrize("count", swept([12, 32], 12))
def test_many_modes_in_all_back_ends(count):
    """Parameters beyond the ninth find their places."""
    ratio = np.random.default_rng(2).uniform(1.05, 1.3, count)
    frequencies = {"bending_y": [float(f) for f in 20 * np.cumprod(ratio)]}
    model, rng = model_of(rod(frequencies)), np.random.default_rng(3)
    q, v = (size * rng.normal(size=count) / np.arange(1, count + 1) ** 2 for size in (1e-4, 1e-3))
    expected = 1.2 * 0.8 * (2 * np.pi * np.array(frequencies["bending_y"])) ** 2
    assert np.allclose(model.numpy().constants[0]["K"], expected, rtol=1e-14, atol=0)
    state = (q, v, [], np.zeros((1, 6)))
    vdot, wrench = model.numpy().forward_dynamics(*state)
    for found in (casadi_forward(model, *state), quick(model).forward_dynamics(*state)):
        assert relative(found[0], vdot) < 1e-12 and relative(found[1], wrench) < 1e-12


@pytest.mark.parametrize("basis", ["clamped_free", "polynomial"])
def test_axial_and_torsion_may_be_measured_with_either_basis(basis):
    frequencies = {"axial": [700.0], "torsion": [210.0, 640.0]}
    modes = counted(frequencies, basis=basis, bending_y=2)
    robot = rod(modes=modes, section=BARE | {"EIz": 50.0})
    robot["links"][0]["modes"] = modes
    found = natural_frequencies(model_of(robot))
    assert all(np.isclose(found, f, rtol=1e-12).any() for f in flat(frequencies))


def test_another_second_frequency_moves_the_second_mode_alone():
    moved = copy.deepcopy(FOUND)
    moved["bending_y"][1] *= 1.1
    assert np.allclose(bare_frequencies(moved), flat(moved), rtol=1e-12, atol=0)
    first, second = (model_of(rod(f)).numpy().constants[0]["K"] for f in (FOUND, moved))
    ratio = np.divide(second, first)
    assert np.isclose(ratio[3], 1.21, rtol=1e-13)
    assert np.array_equal(np.delete(ratio, 3), np.ones(6))


def test_a_payload_lowers_the_frequencies_by_itself():
    """What is measured with the payload on is lower: it is not what the file asks for."""
    robot = rod({"bending_y": [20.0, 131.0]}, bodies=[{"at": "tip", "mass": 2.0}])
    assert natural_frequencies(model_of(robot))[0] < 0.5 * 20.0
