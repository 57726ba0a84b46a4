"""Lines and ropes that implicit steps take at their end: their limits, their energy, and one step in every back end."""

from __future__ import annotations

import numpy as np
import pytest
from batch_c import CompiledBatch, stepped
from helpers import model_of, relative
from scipy.integrate import solve_ivp

import screwgen
from screwgen.simulation.linearised import Linearised

METHODS = ("modal_implicit", "modal_midpoint")
LENGTH, ANGLE = 0.5, 0.7


def load(*lines: dict, boom: bool = False, gravity: float = 9.81):
    """A body that moves in a plane on lines, the first from 1 m above; ``boom``: it hangs from a flexible one."""
    body = {"at": "tip", "mass": 2.0, "inertia": [0.02, 0.03, 0.02, 0.0, 0.0, 0.0]}
    links = [{"name": "bob", "joint": {"axes": [{"slide": "x"}, {"slide": "z"}, "y"]}, "bodies": [body]}]
    ends = [{"world": [0.0, 0.0, 1.0]}, {"world": [0.2, 0.1, 1.0]}]
    if boom:
        section = {"rhoA": 2.0, "rhoIp": 1e-4, "EIy": 1e3}
        arm = {"name": "boom", "length": 0.9, "modes": {"bending_z": 1}, "section": section, "parent": "world"}
        links.append(arm | {"joint": {"axes": ["y"], "mount": {"xyz": [-0.9, 0.0, 1.0]}}})
        ends[0] = "boom.tip"
    forces = [
        {"name": f"line{k}", "between": [ends[k], "bob.tip"], "line": {"rest": LENGTH, "implicit": True} | line}
        for k, line in enumerate(lines)
    ]
    return model_of({"name": "hung", "gravity": [0.0, 0.0, -gravity], "links": links, "forces": forces})


def place(stretch: float = 0.0) -> np.ndarray:
    length = LENGTH + stretch
    return np.array([length * np.sin(ANGLE), 1.0 - length * np.cos(ANGLE), 0.0])


@pytest.mark.parametrize("slack", [False, True])
@pytest.mark.parametrize("method, order", [("modal_implicit", 1), ("modal_midpoint", 2)])
def test_without_bound_of_stiffness_it_is_a_pendulum(method, order, slack):
    swing = lambda t, y: [y[1], -9.81 / LENGTH * np.sin(y[0])]  # noqa: E731
    angle = solve_ivp(swing, (0, 1), [ANGLE, 0.0], rtol=1e-11, atol=1e-12).y[0, -1]
    model, off = load({"stiffness": 1e12, "slack": slack}), []
    for step in (1e-3, 5e-4):
        run = screwgen.simulate(model, 1.0, step, q0=place(), integrator=method)
        off.append(np.abs(run.q[-1, :2] - [LENGTH * np.sin(angle), 1.0 - LENGTH * np.cos(angle)]).max())
    assert off[0] < 10.0 ** (-2.5 * order) and off[0] / off[1] == pytest.approx(2.0**order, rel=0.05)


@pytest.mark.parametrize("slack", [False, True])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("stiffness", [1e3, 1e12])
def test_energy_never_grows_over_a_hundred_thousand_steps(stiffness, method, slack):
    """A body without weight turns about a point on a stretched line, whose energy swings a little by the methods."""
    model = load({"stiffness": stiffness, "slack": slack}, gravity=0.0)
    stepper, numeric = model.compile().stepper(1e-3, method=method, count=50), model.numpy()
    stepper.q[:] = place(1e-2 if stiffness < 1e6 else np.sqrt(0.5 / stiffness))
    stepper.v[:] = 1.5 * np.cos(ANGLE), 1.5 * np.sin(ANGLE), 0.0
    energies = [sum(numeric.energy(stepper.q[:3], stepper.v[:3]))]
    for _ in range(2000):
        stepper()
        energies.append(sum(numeric.energy(stepper.q[:3], stepper.v[:3])))
    assert max(energies) <= energies[0] * (1 + (2e-6 if method == "modal_midpoint" else 5e-5))
    assert max(energies[1000:]) <= max(energies[:1000])


def test_one_that_would_push_bears_nothing():
    """A stone is thrown up from where its rope is taut, falls freely, and is caught where the rope ends."""
    model = load({"stiffness": 1e9, "slack": True, "damping": 1e5})
    run = screwgen.simulate(model, 1.0, 1e-3, q0=[0.0, 0.5, 0.0], v0=[0.0, 2.0, 0.0])
    free = run.t < 0.4
    assert run.q[free, 1] == pytest.approx(0.5 + 2.0 * run.t[free] - 9.81 * run.t[free] ** 2 / 2, abs=1e-9)
    assert np.abs(run.q[run.t > 0.42, 1] - 0.5).max() < 1e-6


ROPES = ({"stiffness": 1e5, "damping": 30.0, "slack": True, "winch": True}, {"stiffness": 3e5, "slack": True})


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("seed", [0, 2])
def test_a_step_and_its_slopes_are_those_of_every_back_end(method, seed):
    """Of a winch's rope to a boom that bends and a rope to the world, both taut, or one of them."""
    model, rng, h = load(*ROPES, boom=True), np.random.default_rng(seed), 1e-3
    q = np.append(place(0.02), np.zeros(2)) + 0.01 * rng.normal(size=5)
    v, tau, w_ext = rng.normal(size=5), 0.02 * rng.normal(size=model.n_tau), rng.normal(size=(model.n_links, 6))
    compiled = model.compile(derivatives=True)
    step = lambda x: np.concatenate(compiled.step(x[:5], x[5:10], x[10:], w_ext, h, method))  # noqa: E731
    at = np.concatenate([q, v, tau])
    by_casadi = model.casadi()[f"step_{method}"](q, v, tau, w_ext.T, model.parameter_values, h)
    lanes = np.array([q, v])[:, :, None], tau[None, :, None], w_ext.reshape(1, -1, 1)
    for found in (
        np.concatenate([np.array(x).ravel() for x in by_casadi]),
        stepped(CompiledBatch(model), *lanes, method, dt=h)[0][:, -1].ravel(),
    ):
        assert relative(found, step(at)) < 1e-12
    *_, A, B = compiled.step_derivatives(q, v, tau, w_ext, h, method)
    differences = np.array([(step(at + e) - step(at - e)) / 2e-6 for e in 1e-6 * np.eye(len(at))]).T
    assert relative(np.hstack([A, B]), differences) < 1e-8


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("stretch", [0.0, -0.1])
def test_the_map_of_a_step_is_its_derivative(method, stretch):
    """Of a line without load, and of a rope that is slack."""
    model, at, h = load({"stiffness": 1e5, "damping": 8.0, "slack": stretch < 0}, gravity=0.0), place(stretch), 2e-3
    compiled, x = model.compile(), np.append(at, np.zeros(3))
    step = lambda x: np.concatenate(compiled.step(x[:3], x[3:], None, None, h, method))  # noqa: E731
    differences = np.array([(step(x + e) - step(x - e)) / 2e-6 for e in 1e-6 * np.eye(6)]).T
    assert relative(Linearised(model, at, np.zeros(3)).step_map(method, h), differences) < 1e-8


def test_beside_relaxation_it_is_refused():
    with pytest.raises(ValueError, match="is stated beside relaxation; a line that relaxes is not taken so"):
        load({"stiffness": 1.0, "relaxation": 1.0, "relaxation_time": 1.0})
