"""Poses, twists, displacement fields, tip deformation and spectra against definitions that share no code with them."""

import numpy as np
import pytest
from helpers import drawn, example
from scipy.linalg import expm

from screwgen import UsageError
from screwgen.simulation.motion import (
    amplitude_spectrum,
    displacements,
    modal_columns,
    screws,
    tip_deformation,
    tip_position,
)


def hat(a):
    return np.cross(np.eye(3), a)


def states(case, count=4):
    rng = np.random.default_rng(7)
    q = case.inputs[0] + 0.05 * rng.standard_normal((count, case.model.nq))
    return q, 0.5 * rng.standard_normal((count, case.model.nq))


@pytest.mark.parametrize("seed", range(3))
def test_coordinates_and_twists_are_the_oracles(seed):
    case = drawn(seed, 3)
    q, v = states(case)
    found = screws(case.model, q, v)
    for k in range(len(q)):
        expected, twists = case.oracle.poses(q[k]), case.oracle.link_twists(q[k], v[k])
        for i in range(3):
            R = expected["R"][i]
            assert np.allclose(expm(hat(found.theta[k, i])), R, rtol=0, atol=1e-11)
            assert np.allclose(R @ found.r[k, i], expected["origin"][i], rtol=0, atol=1e-11)
        assert np.allclose(np.hstack([found.omega[k], found.v[k]]), twists, rtol=1e-10, atol=1e-10)


def test_displacements_of_the_papers_arm_are_the_clamped_free_curve():
    model = example("ella")
    q = np.zeros((2, model.nq))
    q[1, modal_columns(model, 1, "bending_z")[0]] = 0.01
    q[1, modal_columns(model, 1, "axial")[0]] = 0.002
    s = np.linspace(0, 1, 9)
    field = displacements(model, q, 1, s)
    x = 1.8751040687119611
    sigma = (np.sinh(x) - np.sin(x)) / (np.cosh(x) + np.cos(x))
    curve = np.cosh(x * s) - np.cos(x * s) - sigma * (np.sinh(x * s) - np.sin(x * s))
    assert np.allclose(field[1, :, 2], 0.01 * curve, atol=1e-15)
    assert np.allclose(field[1, :, 0], 0.002 * np.sqrt(2) * np.sin(np.pi * s / 2), atol=1e-15)
    assert not field[0].any() and not field[1, :, 1].any() and not displacements(model, q, 0, s).any()


@pytest.mark.parametrize("seed", range(2))
def test_tip_deformation_is_between_the_oracles_tips(seed):
    case = drawn(seed, 2)
    q, _ = states(case)
    q[0, case.model.n_joints :] = 0.0
    found = tip_deformation(case.model, q)
    assert not found[0].any()
    for k in range(len(q)):
        straight = np.append(q[k, : case.model.n_joints], np.zeros(case.model.nq - case.model.n_joints))
        tip = case.oracle.tip_pose(q[k])[1]
        assert np.allclose(tip_position(case.model, q)[k], tip, rtol=0, atol=1e-11)
        assert np.allclose(found[k], tip - case.oracle.tip_pose(straight)[1], rtol=0, atol=1e-11)


def test_the_last_links_tip_displacement_is_the_papers_vector_in_the_straight_arm():
    """At q = 0 with link 1 straight the tip deformation is link 2's own tip displacement."""
    model = example("ella")
    q = np.zeros((1, model.nq))
    q[0, model.n_joints :] = [0, 0, 0, -0.01, 0.003, -0.004]
    assert np.allclose(tip_deformation(model, q)[0], displacements(model, q, 1, [1.0])[0, 0], atol=1e-15)


@pytest.mark.parametrize("taper", [True, False])
def test_a_sine_on_the_grid_shows_with_its_amplitude(taper):
    t = np.arange(2000) * 1e-3
    x = np.column_stack([3.0 + 0.7 * np.sin(2 * np.pi * 5 * t), 0.2 * np.cos(2 * np.pi * 40 * t + 1)])
    f, a = amplitude_spectrum(t, x, taper)
    assert np.isclose(f[np.argmax(a[:, 0])], 5.0) and np.isclose(a[:, 0].max(), 0.7, rtol=1e-10)
    assert np.isclose(f[np.argmax(a[:, 1])], 40.0) and np.isclose(a[:, 1].max(), 0.2, rtol=1e-10)
    assert a[0].max() < 1e-12 and f[-1] == 500.0


def test_bad_samples_are_refused():
    model = example("ella")
    with pytest.raises(UsageError, match="must be"):
        tip_position(model, np.zeros(model.nq))
    with pytest.raises(UsageError, match="even"):
        amplitude_spectrum(np.array([0.0, 1.0, 2.0, 4.0, 5.0]), np.zeros(5))
