"""Rods to second order: the graded Lagrangian of the oracle in every back end, and published numbers."""

from functools import cache

import numpy as np
import pytest
import scipy.linalg
from helpers import Case, arm, casadi_forward, drawn, flat, link, model_of, quick
from test_derivatives import by_casadi, worst
from test_dynamics import check, dae_errors

SEEDS = range(10)
COMPILED = range(4)


@cache
def case_of(seed: int) -> Case:
    """Orders 1 and 2 mixed in one arm, all features of robot files."""
    return drawn(700 + seed, 1 + seed % 4, second_order=0.7)


@pytest.mark.parametrize("seed", SEEDS)
def test_random_robots_equal_the_oracle(seed):
    case = case_of(seed)
    judge = lambda result: case.oracle.errors(case.state, *result)  # noqa: E731
    numeric = case.model.numpy()
    errors = {
        "NumPy": judge(numeric.forward_dynamics(*case.inputs)),
        "NumPy, DAE": judge(numeric.dae_forward_dynamics(*case.inputs)),
        "CasADi": judge(casadi_forward(case.model, *case.inputs)),
        "CasADi, DAE": dae_errors(case),
    }
    check(case, errors)
    q, v = case.inputs[:2]
    assert np.allclose(numeric.energy(q, v), case.oracle.energy(q, v), rtol=1e-11)


@pytest.mark.parametrize("seed", COMPILED)
def test_compiled_c_equals_the_oracle(seed):
    case = case_of(seed)
    compiled = quick(case.model, layout=("fused", "modular")[seed % 2])
    results = {form: compiled.forward_dynamics(*case.inputs, form=form) for form in ("joint", "dae")}
    check(case, {form: case.oracle.errors(case.state, *result) for form, result in results.items()})


@pytest.mark.parametrize("seed", SEEDS)
def test_analytic_derivatives_equal_casadi(seed):
    case = case_of(seed)
    assert worst(case.model.numpy().derivatives(*case.inputs), by_casadi(case.model, *case.inputs)) <= case.tolerance


def test_most_of_the_robots_have_links_of_second_order():
    orders = [key.order for seed in SEEDS for key in case_of(seed).model.chain.keys]
    assert 0.3 <= orders.count(2) / len(orders) <= 0.9


# ------------------------------------------------------------------------------------ published numbers


def cantilever(modes: int, direction="bending_z", axis="z", **more):
    """A rod of unit length, mass per length and stiffness on a hub that turns about z."""
    section = {"EIy": 1.0, "EIz": 1.0, "EA": 1e4}
    links = [link("rod", 1.0, axis, 1.0, {direction: modes}, section=section, **more)]
    return model_of(arm(*links, gravity=(0, 0, 0), order=2))


def rotating_frequencies(model, rate: float) -> np.ndarray:
    """Circular frequencies of the modes about the steady rotation of the hub, its rate held; no Coriolis coupling."""
    q, v = np.zeros(model.nq), np.zeros(model.nq)
    v[0] = rate
    J = model.casadi()["ode"].jacobian() if False else None
    assert J is None
    slope = model.numpy().derivatives(q, v, np.zeros(model.n_joints), np.zeros((1, 6)))[0]
    M = model.numpy().mass_matrix(q)
    K = -(M @ slope)[1:, 1:]
    return np.sqrt(scipy.linalg.eigh((K + K.T) / 2, M[1:, 1:], eigvals_only=True))


SPEEDS = (0, 2, 4, 6, 8, 10, 12)
FLAP = {
    0: (3.51602, 4.13732, 5.58500, 7.36037, 9.25684, 11.20233, 13.17015),
    1: (22.03449, 22.61492, 24.27335, 26.80908, 29.99538, 33.64037, 37.60311),
}


@pytest.mark.parametrize("modes, bound", [(5, 2e-4), (8, 2e-6)])
def test_a_rotating_cantilever_stiffens(modes, bound):
    """Flapwise frequencies of a cantilever on a hub of no radius; lagwise, omega^2 is less by the square of the rate."""
    flap, lag = cantilever(modes), cantilever(modes, "bending_y")
    for k, rate in enumerate(SPEEDS):
        found = rotating_frequencies(flap, rate)[:2]
        assert np.allclose(found, [FLAP[0][k], FLAP[1][k]], rtol=bound, atol=1e-5)
        assert np.allclose(rotating_frequencies(lag, rate)[:2] ** 2, found**2 - rate**2, rtol=1e-9, atol=1e-9)
