"""What drives through cylinders and through linkages are held against alike."""

import numpy as np
import pytest
from helpers import relative

from screwgen import PD, Model, equilibrium, simulate
from screwgen.backends.numpy.travel_numbers import travels

GAINS = (4e3, 1e3), (4e2, 90.0)


def power(model: Model, start: np.ndarray, controller) -> None:
    """The work of the inputs along their travels is the gain of energy, and the integral of their powers."""
    run = simulate(model, 0.4, 1e-4, q0=start, controller=controller)
    ways = np.array([travels(model.chain, q, model.parameter_values)[0] for q in run.q])
    work = np.sum((run.tau[1:] + run.tau[:-1]) / 2 * np.diff(ways, axis=0))
    gained = run.energy.sum(axis=1)[-1] - run.energy.sum(axis=1)[0]
    assert abs(work) > 20 and work == pytest.approx(gained, rel=2e-4)
    powers = run.drive_power.sum(axis=1)
    assert np.sum((powers[1:] + powers[:-1]) / 2 * np.diff(run.t)) == pytest.approx(gained, rel=2e-4)


def held_posture(model: Model, q: np.ndarray) -> np.ndarray:
    """The inputs that hold a posture: no acceleration, and by their levers the torques of the joints."""
    held, numeric = equilibrium(model, q, hold=True), model.numpy()
    assert relative(numeric.forward_dynamics(held.q, 0 * held.q, held.tau, None)[0], 0 * held.q) < 1e-9
    torques = numeric.inverse_dynamics(held.q, None, None, None)[: len(q)]
    assert np.allclose(held.tau * numeric.levers(held.q), torques)
    return held.tau


def postures_under(model: Model, held: float, starts) -> np.ndarray:
    """The input that holds a posture of one joint; under it postures at rest are found from others."""
    force = equilibrium(model, [held], hold=True).tau
    for x in (equilibrium(model, [q], tau=force) for q in starts):
        assert abs(model.numpy().forward_dynamics(x.q, [0], force, None)[0][0]) < 1e-8
    return force


def gains_through_levers(model: Model, start: np.ndarray) -> None:
    """A law's torques at the joints, over the levers."""
    q = start + np.array([0.02, -0.01, 0.0])
    free = PD(*GAINS, start[:2]).through(model.chain, model.parameter_values)
    expected = np.array([-4e3 * 0.02, 1e3 * 0.01]) / model.numpy().levers(q)
    assert np.allclose(free(0.0, q, 0 * q), expected)
