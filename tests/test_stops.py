"""Compliant stops against the oracle, against solutions of their own, and what steps make of them."""

from functools import cache

import numpy as np
import pytest
from conformance import slopes
from conftest import swept
from helpers import arm, link, model_of, relative
from mixed_arms import Mixed, case_of, judged
from random_robots import random_state
from scipy.integrate import solve_ivp
from stop_robots import MIXED

from screwgen import equilibrium, natural_frequencies, simulate
from screwgen.algorithms import fused
from screwgen.elements import STOP
from screwgen.simulation.integrate import JointState, JointStepper
from screwgen.studies.analysis.spectrum import step_map


@cache
def everything(seed: int) -> Mixed:
    return case_of(MIXED, random_state(np.random.default_rng(seed), MIXED, angle=0.6))


def pressed(c: Mixed) -> int:
    """How many stops act in a case."""
    q, at = c.given[0], [x for own in c.model.numpy().constants for x in own.get("stop_at", ())]
    return sum(end.side * (q[end.coordinate] - x) > 0 for end, x in zip(c.model.chain.acted(STOP), at, strict=True))


# -------- against the oracle


@pytest.mark.parametrize("seed", swept(range(2), 1))
def test_stops_of_every_kind_in_one_robot(seed):
    c = everything(seed)
    assert 1 <= pressed(c) < len(c.model.chain.acted(STOP))
    judged(c, "fused")
    slopes.dynamics(c)


# -------- solutions of their own

PENDULUM = {"lower": -2.0, "upper": 0.5, "stiffness": 4000.0, "damping": 12.0}
"""Of a rod of 1 m and 3 kg that falls about y from 0 onto a stop."""


@cache
def rod():
    return model_of(arm(link("rod", 1.0, "y", 3.0, joint={"limits": [PENDULUM]}), gravity=(0.0, 0.0, -9.81)))


def dropped(duration: float, step: float, integrator="modal_midpoint", **table):
    """The run of the rod in C, with other numbers of its stop."""
    given = {f"rod.joint.limits[0].{name}": value for name, value in table.items()}
    return simulate(rod(), duration, step, integrator=integrator, parameters=given)


def falling(stiffness: float, damping: float, duration: float) -> tuple[list, np.ndarray]:
    """Times at which a rod touches and leaves its stop, and the state at the end, by solve_ivp with events."""
    inertia, weight = 3.0 / 3, 3.0 * 9.81 / 2
    push = lambda x: stiffness * (x[0] - 0.5) + damping * x[1]  # noqa: E731
    free = lambda t, x: [x[1], weight * np.cos(x[0]) / inertia]  # noqa: E731
    held = lambda t, x: [x[1], (weight * np.cos(x[0]) - push(x)) / inertia]  # noqa: E731
    touch, let_go = (lambda t, x: x[0] - 0.5), (lambda t, x: push(x))
    touch.terminal = let_go.terminal = True
    touch.direction, let_go.direction = 1, -1
    t, x, times, contact = 0.0, np.zeros(2), [], False
    while t < duration:
        law, event = (held, let_go) if contact else (free, touch)
        found = solve_ivp(law, (t, duration), x, events=event, rtol=1e-11, atol=1e-12)
        t, x = found.t[-1], found.y[:, -1]
        if t < duration:
            contact = not contact
            times.append(t)
    return times, x


def test_a_rod_bounces_on_its_stop_as_its_own_equation_says():
    times, end = falling(4000.0, 12.0, 0.8)
    assert len(times) >= 2
    errors = []
    for h in (2e-4, 1e-4):
        run = dropped(0.8, h)
        errors.append(np.abs([run.q[-1, 0] - end[0], run.v[-1, 0] - end[1]]).max())
    assert errors[1] < 2e-3 and errors[0] > 1.6 * errors[1], errors
    run = dropped(0.8, 1e-5, "rk4")
    assert abs(run.q[-1, 0] - end[0]) < 1e-4 and abs(run.v[-1, 0] - end[1]) < 2e-3


def test_without_damping_the_energy_returns_and_the_midpoint_rule_is_of_second_order():
    drift = []
    for h in (1e-3, 5e-4, 2.5e-4):
        total = dropped(1.0, h, damping=0.0).energy.sum(axis=1)
        drift.append(np.abs(total - total[0]).max())
    assert drift[0] < 0.1 and drift[1] < drift[0] / 2.5 and drift[2] < drift[1] / 2.5, drift


@pytest.mark.parametrize("method", ["modal_midpoint", "modal_implicit"])
@pytest.mark.parametrize("damping", [0.0, 300.0])
def test_a_stop_of_a_kilohertz_does_not_limit_the_step(method, damping):
    """At 1 ms it stops the rod, returns no more energy than came, and the rod rests where its weight presses it."""
    stiffness = (2 * np.pi * 1000) ** 2
    run = dropped(3.0, 1e-3, method, stiffness=stiffness, damping=damping)
    total = run.energy.sum(axis=1)
    scale = np.ptp(run.energy[:, 0])
    assert (total - np.minimum.accumulate(total)).max() < 2e-3 * scale
    assert np.abs(run.v[-100:]).max() < (1e-9 if damping else 0.05)
    rest = 0.5 + 3.0 * 9.81 / 2 * np.cos(0.5) / stiffness
    assert abs(run.q[-1, 0] - rest) < (1e-10 if damping else 1e-4)
    if damping:
        assert np.ptp(run.q[-1000:, 0]) < 1e-12


def test_a_slide_on_its_stop_is_a_half_swing():
    """A slide without weight that hits a spring at 2 m/s turns back after half a period, at 2 m/s."""
    stop = {"upper": 0.1, "stiffness": 2000.0}
    model = model_of(arm(link("cart", axes=[{"slide": "x"}], rhoA=2.0, joint={"limits": [stop]}), gravity=(0, 0, 0)))
    swing = np.sqrt(2000.0 / model.numpy().mass_matrix([0.0])[0, 0])
    run = simulate(model, 0.3, 5e-4, v0=[2.0], backend="casadi")
    assert np.isclose(run.q[:, 0].max(), 0.1 + 2.0 / swing, rtol=1e-4)
    back = run.t[np.flatnonzero(np.diff(np.sign(run.q[:, 0] - 0.1)) < 0)[0]]
    assert abs(back - (0.05 + np.pi / swing)) < 6e-4 and np.isclose(run.v[-1, 0], -2.0, rtol=1e-5)


# -------- steps


@pytest.mark.parametrize("method", ["modal_implicit", "semi_implicit"])
def test_the_amplification_matrix_is_the_derivative_of_a_step(method):
    c, h, dt = everything(1), 1e-6, 1e-5
    q, v, tau, w_ext = c.given
    stepper = JointStepper(c.model, method, c.model.parameter_values)
    after = lambda x: np.concatenate(stepper.step(JointState(*np.split(x, 2)), tau, w_ext, dt))  # noqa: E731
    x = np.append(q, v)
    columns = [(after(x + e) - after(x - e)) / (2 * h) for e in h * np.eye(len(x))]
    assert relative(step_map(c.model, method, q, v, dt, tau, w_ext=w_ext), np.array(columns).T) < 1e-6


# -------- rest and vibration


def test_an_arm_rests_on_its_stop():
    found = equilibrium(rod(), [0.2])
    x = found.q[0] - 0.5
    assert x > 0 and np.isclose(4000.0 * x, 3.0 * 9.81 / 2 * np.cos(found.q[0]), rtol=1e-9)
    assert found.stability == "stable"
    A = rod().linearise(found.q).A
    weight = 3.0 * 9.81 / 2 * np.sin(found.q[0])
    assert np.allclose(A, [[0, 1], [-(4000.0 + weight), -12.0]], rtol=1e-9)


def test_natural_frequencies_have_the_stiffness_of_pressed_stops():
    assert natural_frequencies(rod(), [0.4], "free") == [0.0]
    assert np.allclose(natural_frequencies(rod(), [0.51], "free"), np.sqrt(4000.0) / (2 * np.pi))
    assert np.allclose(natural_frequencies(rod(), [-2.1], "free"), np.sqrt(4000.0) / (2 * np.pi))


def test_gears_carry_what_a_stop_takes():
    """The stop is on the joint's side: a rotor that pushes against it winds its gear."""
    drive = {"ratio": 50.0, "rotor_inertia": 1e-4, "stiffness": 3000.0}
    joint = {"drives": [drive], "limits": [{"upper": 0.1, "stiffness": 1e5, "damping": 100.0}], "damping": [5.0]}
    model = model_of(arm(link("arm", 1.0, "z", 1.0, joint=joint)))
    found = equilibrium(model, [0.0], tau=[2.0])
    assert np.isclose(found.q[0], 0.1 + 100.0 / 1e5) and np.isclose(found.q[1] / 50.0 - found.q[0], 100.0 / 3000.0)


# -------- cost


def test_stops_cost_the_dynamics_of_the_steps_nothing():
    def operations(joint: dict) -> int:
        links = (link(f"l{i}", 0.4, "yz"[i % 2], joint=joint) for i in range(4))
        return fused.complete_dynamics(model_of(arm(*links)).chain).operation_count

    table = {"lower": -1.0, "upper": 1.0, "stiffness": 1e4, "damping": 5.0}
    assert operations({"damping": [1.0], "limits": [table]}) == operations({"damping": [1.0]})
    assert operations({"limits": [{"lower": -1.0, "upper": 1.0}]}) == operations({})
