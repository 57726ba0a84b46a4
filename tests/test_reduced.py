"""Arms with bodies from finite elements against the oracle, whose bodies are points: every back end and form."""

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import flexible_robots as fr
import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import Case, model_of, relative

SEEDS = range(900, 940)


@cache
def mixed(seed: int) -> Case:
    """A random arm of one to three links, some of them bodies of points, one in two of second order."""
    rng = np.random.default_rng(seed)
    limits = {"second_order": 0.3, "stations": 0.2, "max_modes": 2}
    robot, state, oracle = rr.draw_regular(rng, 1 + seed % 3, robots=fr.random_arm, states=fr.random_state, **limits)
    with TemporaryDirectory() as folder:
        return Case(robot, state, oracle, model_of(fr.with_files(robot, Path(folder))))


every = pytest.mark.parametrize("seed", swept(SEEDS, *SEEDS[:9]))


def test_bodies_are_of_both_orders_and_some_tips_have_axes_of_their_own():
    bodies = [key.elastic for seed in SEEDS[:9] for key in mixed(seed).model.chain.keys if key.elastic]
    assert {b.geometric for b in bodies} == {False, True}
    assert any(not np.array_equal(b.tip.axes, np.eye(3)) for b in bodies)
    assert any(b.damping.any() for b in bodies) and any(len(b.coupled) for b in bodies)


@every
def test_numpy_in_both_forms(seed):
    case = mixed(seed)
    numeric = case.model.numpy()
    for form in (numeric.forward_dynamics, numeric.dae_forward_dynamics):
        assert max(case.oracle.errors(case.state, *form(*case.inputs)).values()) <= case.tolerance


@every
def test_inverse_dynamics_mass_matrix_and_energy(seed):
    case = mixed(seed)
    (q, v, _, w_ext), numeric = case.inputs, case.model.numpy()
    vdot = np.random.default_rng(seed).uniform(-1, 1, len(q))
    expected = case.oracle.inverse_dynamics(q, v, vdot, w_ext)
    assert relative(numeric.inverse_dynamics(q, v, vdot, w_ext), expected) < 1e-11
    assert relative(numeric.mass_matrix(q), case.oracle.mass_matrix(q)) < 1e-12
    assert np.allclose(numeric.energy(q, v), case.oracle.energy(q, v), rtol=1e-12)
