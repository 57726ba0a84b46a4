"""Lines that relax: a spring beside another that is in series with a damper, by closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import model_of

import screwgen
from screwgen.interactions import KINDS

STIFFNESS, RELAXING, TIME, REST = 200.0, 300.0, 0.05, 1.0


def strapped(mass: float, **line) -> screwgen.Model:
    """A body that slides along a strap to the world, without weight."""
    body = {"at": "tip", "mass": mass, "inertia": [0.1, 0.1, 0.1, 0.0, 0.0, 0.0]}
    link = {"name": "sled", "joint": {"axes": [{"slide": "x"}]}, "bodies": [body]}
    law = {"stiffness": STIFFNESS, "rest": REST, "relaxation": RELAXING, "relaxation_time": TIME} | line
    strap = {"name": "strap", "between": ["world", "sled.tip"], "line": law}
    return model_of({"name": "strapped", "gravity": [0.0, 0.0, 0.0], "links": [link], "forces": [strap]})


@pytest.mark.parametrize("integrator", ["rk4", "modal_implicit"])
def test_what_is_held_stretched_relaxes_exponentially(integrator):
    """A body so heavy that it stays; a step of the implicit method divides by 1 + h/T."""
    step = 1e-3
    run = screwgen.simulate(strapped(1e12), 0.2, step, q0=[1.5], v0=[0.0, 0.1], integrator=integrator)
    factor = np.exp(-step / TIME) if integrator == "rk4" else 1 / (1 + step / TIME)
    z = 0.1 * factor ** np.arange(len(run.t))
    assert run.v[:, 1] == pytest.approx(z, rel=1e-8)
    assert run.force_quantities[:, 1] == pytest.approx(STIFFNESS * 0.5 + RELAXING * z, rel=1e-8)


def closed_form(t: np.ndarray, mass: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Stretch, its rate and the stretch of the spring that relaxes, from a stretch of 0.1 m at rest, all relaxed."""
    A = np.array([[0.0, 1.0, 0.0], [-STIFFNESS / mass, 0.0, -RELAXING / mass], [0.0, 1.0, -1.0 / TIME]])
    roots, modes = np.linalg.eig(A)
    shares = np.linalg.solve(modes, [0.1, 0.0, 0.0])
    return tuple((modes @ (shares[:, None] * np.exp(np.outer(roots, t)))).real)


@pytest.mark.parametrize(("integrator", "order"), [("rk4", 4), ("modal_midpoint", 2), ("modal_implicit", 1)])
def test_a_body_on_it_moves_as_the_standard_linear_solid_says(integrator, order):
    mass, errors = 2.0, []
    for step in (4e-3, 2e-3):
        run = screwgen.simulate(strapped(mass), 0.6, step, q0=[REST + 0.1], integrator=integrator)
        found = np.column_stack([run.q[:, 0] - REST, 0.1 * run.v[:, 0], run.v[:, 1]])
        errors.append(np.abs(found - np.column_stack(closed_form(run.t, mass)) * [1.0, 0.1, 1.0]).max())
    assert errors[0] / errors[1] == pytest.approx(2.0**order, rel=0.15), errors
    assert errors[1] < 0.1 * 2.0 ** (-3 * order)


def test_what_its_energy_loses_is_what_its_damper_takes():
    run = screwgen.simulate(strapped(2.0), 0.6, 1e-3, q0=[REST + 0.1], integrator="rk4")
    loss = RELAXING / TIME * run.v[:, 1] ** 2
    lost = np.append(0.0, np.cumsum((loss[1:] + loss[:-1]) / 2 * np.diff(run.t)))
    energy = run.energy.sum(axis=1)
    assert energy[0] - energy == pytest.approx(lost, abs=2e-5) and lost[-1] > 0.5


def test_steps_far_longer_than_its_time_are_stable():
    model = strapped(2.0, relaxation_time=1e-6)
    run = screwgen.simulate(model, 2.0, 5e-3, q0=[REST + 0.1], integrator="modal_implicit")
    omega, bare = np.sqrt(STIFFNESS / 2.0), run.q[:, 0] - REST
    assert np.abs(bare).max() < 0.11 and np.abs(run.v[1:, 1]).max() < 2e-6 * 0.1 * omega


def test_a_slack_strap_does_not_stretch():
    law = KINDS["line"](300.0, 1.0, relaxation=9.0, relaxation_time=0.5, slack=True)
    model = strapped(2.0, slack=True)
    assert model.numpy().forward_dynamics([0.6], [0.3, 0.02], None, None)[0] == pytest.approx([0.0, -0.02 / TIME])
    assert law.shape.states.keys() == {"relaxed"} and model.v_names[1] == "strap.relaxed_state[0]"
