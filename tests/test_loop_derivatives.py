"""Exact derivatives of robots with loops, in NumPy and C: against differences of 40 digits, and CasADi."""

import mpmath
import numpy as np
import pytest
from dual_arm import dual_arm
from dual_arm import start as flying
from helpers import model_of, quick, relative
from test_linear_loops import BALL, GEAR, linkage

from screwgen import SingularError
from screwgen.algorithms import fused
from screwgen.algorithms.functions import Functions
from screwgen.ir.replay import run

H = mpmath.mpf("1e-12")


def precise(link, phase, program, given):
    return run(program, given, fused.precise)[0]


def differences(model, given, direction) -> np.ndarray:
    """`v̇` along a direction (dq of the rates, dv, dtau), by central differences of 40 digits."""
    with mpmath.workdps(40):
        p, constants = fused.exact(model.chain)
        functions = Functions(model.chain, constants, p[:3], precise)
        q, v, tau, w_ext = ([mpmath.mpf(x) for x in np.ravel(values)] for values in given)
        dq, dv, dtau = ([mpmath.mpf(x) for x in part] for part in direction)
        rates = functions.coordinate_rates(q, dq)

        def at(h):
            moved = ([a + h * b for a, b in zip(x, y, strict=True)] for x, y in ((q, rates), (v, dv), (tau, dtau)))
            return functions.forward_dynamics(*moved, w_ext)[0]

        return np.array([float((a - b) / (2 * H)) for a, b in zip(at(H), at(-H), strict=True)])


def error(model, given, found) -> float:
    """Of derivatives (by q, v, tau), each along a direction of its own."""
    rng, worst = np.random.default_rng(4), 0.0
    for k, matrix in enumerate(found):
        direction = [rng.normal(size=x.shape[1]) * (j == k) for j, x in enumerate(found)]
        worst = max(worst, relative(matrix @ direction[k], differences(model, given, direction)))
    return worst


def moved(model, q, seed=0):
    """A state near a closed one, whose loops are open by some millimetres, and open further."""
    rng, chain = np.random.default_rng(seed), model.chain
    size = np.where(np.arange(chain.nq) < chain.eta_q, 0.05, 0.003) * (np.arange(chain.nq) >= chain.base_q)
    q = q + size * rng.normal(size=chain.nq)
    return q, rng.normal(size=chain.nv), rng.normal(size=chain.n_tau), rng.normal(size=(chain.n, 6))


@pytest.fixture(scope="module")
def bent():
    """A linkage in space whose coupler bends, with an elastic gear."""
    bending = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.5, "EIy": 300.0, "EIz": 300.0}}
    return linkage(BALL, {"joint": {"drives": [GEAR]}}, bending)


def test_c_and_numpy_equal_differences_of_forty_digits(bent):
    given = moved(bent, bent.chain.home)
    expected = bent.numpy().derivatives(*given)
    assert error(bent, given, expected) < 1e-12
    vdot, *found = quick(bent, derivatives=True).linearise(*given)
    assert max(relative(a, b) for a, b in zip(found, expected, strict=True)) < 1e-11
    assert relative(vdot, bent.numpy().forward_dynamics(*given)[0]) < 1e-11


def test_a_loop_on_a_floating_base():
    """Derivatives with the pose are those along ``pose exp(delta)``; the loop is opened."""
    model = model_of(dual_arm())
    q, v = flying(model)
    given = (q + 0.01 * np.cos(np.arange(model.nq)) * (np.arange(model.nq) >= 7), v, *moved(model, q)[2:])
    assert error(model, given, model.numpy().derivatives(*given)) < 1e-10
    columns = [model.numpy().gaps(given[0], unit)[1] for unit in np.eye(model.nv)]
    assert np.array_equal(model.numpy().gap_slopes(given[0]), np.array(columns).T)  # with gears and dry friction


def test_rows_that_depend_on_each_other_are_singular(bent):
    """A linkage in line: no motion changes its length."""
    rest = [np.zeros(n) for n in (bent.nq, bent.nv, bent.n_tau)]
    with pytest.raises(SingularError, match="loops of 'arm' are singular"):
        bent.numpy().derivatives(*rest, None)
    with pytest.raises(SingularError, match="link 'rocker' is singular"):
        quick(bent, derivatives=True).linearise(*rest, np.zeros((3, 6)))
