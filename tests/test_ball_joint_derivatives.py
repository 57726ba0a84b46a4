"""Derivatives of robots with ball joints in C: of accelerations, wrenches and steps, along changes of the posture."""

import numpy as np
import pytest
from conftest import swept
from helpers import model_of, quick, relative
from test_ball_joints import PROBE, TAU, begun

from screwgen.backends.numpy.dae_step import SERIES
from screwgen.integrators import METHODS


@pytest.fixture(scope="module")
def probe():
    return model_of(PROBE)


@pytest.fixture(scope="module")
def differentiated(probe):
    return quick(probe, derivatives=True)


@pytest.mark.parametrize("method", swept([*METHODS], *[*METHODS][3:]))
def test_derivatives_of_steps_in_c_are_those_of_moves(probe, differentiated, method):
    (q, v), h, tau = begun(probe), 1e-3, np.array(TAU)
    chain, nv = probe.chain, probe.nv
    after, rates, A, B = differentiated.step_derivatives(q, v, tau, np.zeros((4, 6)), h, method)
    assert relative(np.append(after, rates), np.concatenate(differentiated.step(q, v, tau, None, h, method))) < 1e-14

    def moved(u):
        there = chain.integrate(q, u[:nv], SERIES), v + u[nv : 2 * nv], tau + u[2 * nv :]
        there, faster = differentiated.step(*there, None, h, method)
        return np.append(chain.difference(after, there, SERIES), faster - rates)

    differences = [(moved(u) - moved(-u)) / 2e-6 for u in 1e-6 * np.eye(2 * nv + chain.n_tau)]
    assert relative(A, np.transpose(differences[: 2 * nv])) < 1e-8
    assert relative(B, np.transpose(differences[2 * nv :])) < 1e-7


def test_derivatives_in_c_are_those_in_numpy(probe, differentiated):
    q, v = begun(probe)
    given = q, v, np.array(TAU), np.zeros((4, 6))
    for found, expected in zip(differentiated.linearise(*given)[1:], probe.numpy().derivatives(*given), strict=True):
        assert relative(found, expected) < 1e-12
    wrench, by_q, by_v, _ = differentiated.linearise_wrenches(*given)
    numeric, chain, none = probe.numpy(), probe.chain, np.zeros(probe.nv)
    assert relative(wrench, numeric.forward_dynamics(*given)[1]) < 1e-12

    def at(u, w):
        return numeric.forward_dynamics(chain.integrate(q, u, SERIES), v + w, *given[2:])[1]

    for found, sides in ((by_q, lambda u: (u, none)), (by_v, lambda u: (none, u))):
        expected = [(at(*sides(u)) - at(*sides(-u))) / 2e-6 for u in 1e-6 * np.eye(chain.nv)]
        assert relative(found, np.moveaxis(expected, 0, -1)) < 1e-6
