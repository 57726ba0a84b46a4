"""Dahl's friction, a key of `friction`: Coulomb's at a steady rate, its stiffness at rest, the area of its loops."""

from __future__ import annotations

import re

import numpy as np
import pytest
from helpers import relative
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from test_internal_states import cart

import screwgen

COULOMB, STIFF = 1.0, 1e4
WAY = COULOMB / STIFF


def yielding(ductility: float | None):
    """The friction of a mass of 1 kg."""
    own = {} if ductility is None else {"ductility": ductility}
    return cart({"coulomb": COULOMB, "dahl": {"stiffness": STIFF} | own})


def force(model, z: float, w: float = 1.0) -> float:
    """What friction takes of the mass."""
    return -model.numpy().forward_dynamics([0.0], [w, z], [0.0], None)[0][0]


def moved(model, z: float, way: float) -> tuple[float, float]:
    """The deflection after a way of the mass, and the work of friction on it."""
    sign = np.sign(way)

    def rates(_, x):
        vdot = model.numpy().forward_dynamics([0.0], [sign, x[0]], [0.0], None)[0]
        return [vdot[1], -vdot[0] * sign]

    return tuple(solve_ivp(rates, (0.0, abs(way)), [z, 0.0], rtol=1e-10, atol=1e-16).y[:, -1])


@pytest.mark.parametrize("ductility", [None, 0.4, 1.0])
def test_it_is_coulombs_friction_where_it_slips(ductility):
    model = yielding(ductility)
    z, _ = moved(model, 0.0, 2000 * WAY)
    assert force(model, z) == pytest.approx(COULOMB, rel=1e-3 if ductility == 1.0 else 1e-9)
    assert force(model, moved(model, z, -2000 * WAY)[0], -1.0) == pytest.approx(-COULOMB, rel=1e-3)
    run = screwgen.simulate(model, 0.5, 1e-3, controller=lambda t, q, v: [2.0])
    assert (run.v[-1, 0] - run.v[-101, 0]) / 0.1 == pytest.approx(2.0 - COULOMB, rel=1e-3)


@pytest.mark.parametrize("ductility", [None, 0.4, 1.0])
def test_from_rest_it_is_a_spring(ductility):
    model = yielding(ductility)
    assert force(model, moved(model, 0.0, 1e-5 * WAY)[0]) == pytest.approx(1e-5 * COULOMB, rel=1e-4)
    run = screwgen.simulate(model, 0.4, 1e-4, controller=lambda t, q, v: [0.01 * COULOMB])
    turns = np.flatnonzero(np.diff(np.sign(run.v[:, 0])) < 0)
    assert np.diff(run.t[turns]).mean() == pytest.approx(2 * np.pi / np.sqrt(STIFF), rel=0.02)


def passed(u: float, b: float) -> float:
    """How the share u that is left falls with the way, in a unit in which that is linear."""
    return np.log(u / (1 - b + b * u)) / (1 - b)


def worked(u: float, b: float) -> float:
    """The integral of (1 - u)/(u (1 - b + b u))."""
    return (np.log(u) - (np.log(1 - b + b * u) / b if b else u)) / (1 - b)


@pytest.mark.parametrize("ductility", [None, 0.3, 0.8])
@pytest.mark.parametrize("ways", [0.2, 1.5, 6.0])
def test_the_area_of_its_loop_is_that_of_the_closed_form(ductility, ways):
    """Between two ends the friction returns to what it was; the area is what it takes to and fro."""
    model, b = yielding(ductility), ductility or 0.0
    reached = brentq(lambda f: passed(1 + f, b) - passed(1 - f, b) - 2 * ways, 1e-9, 1 - 1e-12, xtol=1e-14)
    area = 2 * COULOMB * WAY * (worked(1 + reached, b) - worked(1 - reached, b))
    z, there = moved(model, -reached * WAY, 2 * ways * WAY)
    back, again = moved(model, z, -2 * ways * WAY)
    assert z == pytest.approx(reached * WAY, rel=1e-7) and back == pytest.approx(-z, rel=1e-7)
    assert there + again == pytest.approx(area, rel=1e-7)


@pytest.mark.parametrize("method", ["modal_midpoint", "modal_implicit", "rk4", "semi_implicit"])
def test_a_run_is_that_of_a_stiff_solver(method):
    def rates(t, x):
        _, w, z = x
        left = abs(1 - STIFF * z * np.sign(w) / COULOMB)
        return [w, 2.5 * np.sin(40.0 * t) - STIFF * z, (0.6 + 0.4 * left) * (w - STIFF * abs(w) * z / COULOMB)]

    wanted = solve_ivp(rates, (0.0, 0.1), [0.0] * 3, method="Radau", rtol=1e-9, atol=1e-13).y[:, -1]
    run = screwgen.simulate(
        yielding(0.4), 0.1, 1e-5, controller=lambda t, q, v: [2.5 * np.sin(40.0 * t)], integrator=method
    )
    assert np.abs([run.q[-1, 0], *run.v[-1]] - wanted).max() <= 3e-3 * np.abs(wanted).max()


def test_without_ductility_it_is_lugres_without_damping():
    lugre = cart({"coulomb": COULOMB, "memory": {"stiffness": STIFF}})
    for state in ([0.3, 2e-5], [-0.3, 2e-5], [0.0, -5e-5]):
        found, other = (x.numpy().forward_dynamics([0.0], state, [0.2], None)[0] for x in (yielding(None), lugre))
        assert relative(found, other) < 1e-14


@pytest.mark.parametrize(
    ("friction", "said"),
    [
        ({"dahl": {"stiffness": 9.0}}, "states no friction"),
        ({"coulomb": 1.0, "dahl": {}}, "dahl.stiffness"),
        ({"coulomb": 1.0, "dahl": {"stiffness": 9.0, "ductility": 1.5}}, "must be 0, or from 1e-12 to 1"),
        ({"coulomb": 1.0, "velocity": 0.1, "dahl": {"stiffness": 9.0}}, "is stated beside dahl, whose bristles stick"),
        (
            {"coulomb": 1.0, "memory": {"stiffness": 9.0}, "dahl": {"stiffness": 9.0}},
            "is stated beside memory, and friction has one memory; leave one out",
        ),
    ],
)
def test_what_cannot_be_is_refused_in_a_line(friction, said):
    with pytest.raises(ValueError, match=re.compile(said, re.DOTALL)):
        cart(friction)
