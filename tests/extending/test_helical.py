"""Joints made in Python of the contract, a screw that turns and travels: the helical and the sliding one."""

import tomllib
from functools import cache, partial

import judges
import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import Case, model_of, quick
from oracle import Oracle

from screwgen import PD, Robot, Screw, simulate
from screwgen.runtime.compiled import CompiledStepper
from screwgen.spec import dump


def helical(axis, pitch: float) -> Screw:
    """A nut on a thread: `pitch` m a turn."""
    return Screw(tuple(axis), turn=True, travel=pitch / (2 * np.pi))


def sliding(axis) -> Screw:
    return Screw(tuple(axis), turn=False, travel=1.0)


@cache
def with_screws(seed: int) -> Case:
    """A random arm some of whose axes became threads and slides, in a random state."""
    rng = np.random.default_rng([seed, 2026])
    robot, state, _ = rr.draw_regular(rng, 3)
    for link in robot["links"]:
        link["joint"]["axes"] = [_screw(rng, axis) for axis in link["joint"]["axes"]]
    robot["links"][-1]["joint"] = {"axes": [helical(_unit(rng), 0.3)], "damping": [0.2], "armature": [0.05]}
    robot["links"][0]["joint"] = {
        "axes": [sliding(_unit(rng)), "x"],
        "stiffness": [30.0, 2.0],
        "mount": {"xyz": [0.1, 0.2, 0.3]},
    }
    state = rr.random_state(rng, robot)
    return Case(robot, state, Oracle(robot), model_of(robot))


def _screw(rng, axis):
    if not isinstance(axis, list):
        return axis
    return rng.choice([helical, lambda a, _: sliding(a)])(np.array(axis) / np.linalg.norm(axis), 0.4)


def _unit(rng) -> np.ndarray:
    vector = rng.normal(size=3)
    return vector / np.linalg.norm(vector)


@pytest.fixture(scope="module", params=swept(range(4), 0, 1))
def case(request) -> Case:
    return with_screws(request.param)


def test_accelerations_and_wrenches_are_those_of_lagrange(case):
    vdot, wrench = case.model.numpy().forward_dynamics(*case.inputs)
    assert max(case.oracle.errors(case.state, vdot, wrench).values()) < case.tolerance


def test_the_assembled_system_of_the_dae_form_has_the_same_solution(case):
    q, v, tau, w_ext = case.inputs
    numeric, m = case.model.numpy(), case.model.n_joints
    M, H, W = numeric.assemble(numeric.dae_state(q, v), tau, w_ext)
    z = np.linalg.solve(M, W - H)
    wrench = np.array([z[12 * i : 12 * i + 6] for i in range(case.model.n_links)])
    vdot, expected = numeric.forward_dynamics(q, v, tau, w_ext)
    assert np.allclose(wrench, expected, rtol=0, atol=1e-7 * abs(expected).max())
    assert np.allclose(z[12 * case.model.n_links :], vdot[m:], rtol=0, atol=1e-7 * abs(vdot).max())


def test_derivatives_are_those_of_differences(case):
    judges.differences(case.model, *case.inputs, tolerance=3e-6)


def test_casadi_and_c_compute_the_same(case):
    q, v, tau, w_ext = case.inputs
    expected, _ = case.model.numpy().forward_dynamics(q, v, tau, w_ext)
    function = case.model.casadi()["forward_dynamics"]
    found = [function(q, v, tau, w_ext.T, case.model.parameter_values)[0].full().ravel()]
    for layout in ("fused", "modular"):
        compiled = quick(case.model, layout=layout)
        found += [compiled.forward_dynamics(q, v, tau, w_ext, form)[0] for form in ("joint", "dae")]
    for vdot in found:
        assert np.allclose(vdot, expected, rtol=0, atol=case.agreement * abs(expected).max())


@pytest.mark.parametrize("form", ["joint", "dae"])
def test_a_nut_on_a_thread_falls_as_its_equation_says(form):
    """`(I + m l²) q'' = m g l` with l the travel per radian."""
    travel, inertia, mass = 0.02, 0.004, 2.0
    body = {"at": "base", "mass": mass, "inertia": [inertia] * 3 + [0.0] * 3}
    nut = {
        "name": "nut",
        "length": 0.1,
        "section": {"rhoA": 1e-9},
        "joint": {"axes": [Screw((0.0, 0.0, 1.0), travel=travel)]},
        "bodies": [body],
    }
    model = model_of({"name": "thread", "gravity": [0.0, 0.0, -9.81], "links": [nut]})
    run = simulate(model, duration=0.5, step=1e-3, form=form, integrator="rk4")
    expected = -mass * 9.81 * travel / (inertia + mass * travel**2)
    assert run.q[-1, 0] == pytest.approx(expected * 0.5**2 / 2, rel=1e-8)
    assert model.parameter_names[3:] == ["nut.length", "nut.rhoA", "nut.bodies[0].mass", *model.parameter_names[6:]]


def test_a_slide_keeps_its_energy_in_both_forms():
    case = with_screws(1)
    q, v = 0.1 * case.inputs[0], 0.1 * case.inputs[1]
    compiled = partial(CompiledStepper, quick(case.model, layout="modular"))
    ends = [
        simulate(case.model, duration=0.02, step=2e-4, q0=q, v0=v, form=form, integrator="modal_midpoint").q[-1]
        for form in (compiled, "dae")
    ]
    assert np.allclose(*ends, rtol=0, atol=1e-6)


def test_a_slide_is_driven_by_a_control_law_to_its_goal():
    cart = {
        "name": "cart",
        "length": 0.2,
        "section": {"rhoA": 5.0},
        "joint": {"axes": [sliding((1.0, 0.0, 0.0))], "damping": [1.0]},
    }
    model = model_of({"name": "rail", "gravity": [0.0, 0.0, -9.81], "links": [cart]})
    run = simulate(model, duration=8.0, step=2e-3, controller=PD(kp=[4.0], kd=[3.0], q_des=[0.5]))
    assert run.q[-1, 0] == pytest.approx(0.5, abs=1e-3)
    assert [p for p in model.parameter_names if "damping" in p] == ["cart.joint.damping[0]"]


def test_a_robot_file_states_them_too(case):
    robot = case.model.robot
    text = dump(robot)
    assert "{ slide = [" in text and "{ screw = [" in text and "pitch = " in text
    assert Robot.model_validate(tomllib.loads(text)) == robot
