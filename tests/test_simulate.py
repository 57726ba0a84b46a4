"""Simulation: physics against the oracle, orders of the methods, what a run keeps and how it is stored."""

import os
from functools import cache, partial

import numpy as np
import pytest
from helpers import example, model_of

from screwgen import UsageError
from screwgen.integrators import METHODS
from screwgen.runtime.stepper import CompiledStepper
from screwgen.simulation.simulate import FORMS, simulate, time_grid

EXAMPLES = os.path.join(os.path.dirname(__file__), "..", "examples")


@cache
def ella():
    return example("ella")


def soft_dict(basis="clamped_free") -> dict:
    """Two soft links in space, modes of a few Hz: every method resolves them."""
    links = [
        {"name": name, "length": 0.8, "section": {"rhoA": 1.0, "EIy": 40.0, "EIz": 60.0, "rhoIp": 2e-2},
         "modes": {"basis": basis, "bending_y": 1, "bending_z": 1}, "damping": {"ratio": 0.02},
         "joint": {"axes": axes, "damping": [0.3] * len(axes)}, "bodies": [{"at": "tip", "mass": 1.0}]}
        for name, axes in (("upper", ["y", "z"]), ("fore", ["z"]))
    ]  # fmt: skip
    return {"name": "soft", "gravity": [0.0, 0.0, -9.81], "links": links}


@cache
def soft():
    return model_of(soft_dict())


START = {"q0": [0.3, -0.4, 0.5, 0.01, -0.02, 0.005, 0.01], "v0": [0.5, 0.2, -0.6, 0.0, 0.1, 0.0, 0.0]}


# -------- physics


def test_modal_implicit_stays_bounded_with_axial_modes_at_one_millisecond():
    run = simulate(ella(), 1.0, 1e-3, integrator="modal_implicit")
    total = run.energy.sum(axis=1)
    assert total.max() < 0.05 * np.ptp(run.energy[:, 0])
    assert np.abs(run.q[:, 3:]).max() < 0.05


END = 0.1


@cache
def reference():
    return simulate(soft(), END, END / 1000, integrator="rk4", **START)


@pytest.mark.parametrize(
    ("integrator", "order"),
    [("euler", 1), ("semi_implicit", 1), ("modal_implicit", 1), ("modal_midpoint", 2), ("rk4", 4)],
)
def test_order_of_convergence(integrator, order):
    exact = np.append(reference().q[-1], reference().v[-1])
    counts = {1: (1000, 2000), 2: (200, 400), 4: (40, 80)}[order]
    runs = [simulate(soft(), END, END / count, integrator=integrator, **START) for count in counts]
    errors = [np.linalg.norm(np.append(run.q[-1], run.v[-1]) - exact) for run in runs]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.2)


def test_every_method_has_its_order_tested():
    assert set(METHODS) == {"euler", "semi_implicit", "modal_implicit", "modal_midpoint", "rk4"}


# -------- what is given


def test_time_grid_ends_at_the_duration():
    assert np.allclose(time_grid(0.3, 0.1), [0.0, 0.1, 0.2, 0.3])
    assert np.allclose(time_grid(0.25, 0.1), [0.0, 0.1, 0.2, 0.25])
    assert np.allclose(time_grid(0.05, 0.1), [0.0, 0.05])
    assert len(time_grid(2.0, 1e-3)) == 2001 and time_grid(2.0, 1e-3)[-1] == 2.0


def test_a_shorter_last_step_lands_on_the_same_motion():
    whole = simulate(soft(), 0.05, 1e-3, integrator="rk4", **START)
    ragged = simulate(soft(), 0.05, 1.1e-3, integrator="rk4", **START)
    assert ragged.t[-1] == 0.05 and np.allclose(ragged.q[-1], whole.q[-1], atol=1e-8)


def test_controller_is_asked_once_a_step_and_its_torque_held():
    calls = []

    def controller(t, q, v):
        calls.append(t)
        q[:] = np.nan  # a copy: the run is not disturbed
        return [t, 2 * t, 3 * t]

    run = simulate(soft(), 0.01, 1e-3, controller=controller)
    assert np.array_equal(np.unique(calls), run.t)
    assert np.array_equal(run.tau, np.outer(run.t, [1, 2, 3]))
    assert np.isfinite(run.q).all()


def test_wrenches_may_be_a_function_or_a_constant():
    load_ = np.array([[0.0] * 6, [0.0, 0.0, 0.0, 0.0, 5.0, 0.0]])
    constant = simulate(soft(), 0.02, 1e-3, w_ext=load_)
    named = {soft().chain.names[-1]: load_[-1]}
    for given in (lambda t, q, v: load_, named, lambda t, q, v: named):
        assert np.array_equal(constant.q, simulate(soft(), 0.02, 1e-3, w_ext=given).q)
    assert not np.allclose(constant.q, simulate(soft(), 0.02, 1e-3).q)


def test_parameters_by_name_equal_another_file():
    heavy = soft_dict()
    heavy["links"][1]["bodies"][0]["mass"] = 2.5
    expected = simulate(model_of(heavy), 0.05, 1e-3, backend="casadi", **START)
    found = simulate(soft(), 0.05, 1e-3, parameters={"fore.bodies[0].mass": 2.5}, **START)
    assert np.allclose(found.q, expected.q, rtol=1e-12) and np.allclose(found.energy, expected.energy, rtol=1e-12)


BAD = {
    "duration": ({"duration": -1.0}, "duration"),
    "step": ({"step": 0.0}, "step"),
    "too many": ({"step": 1e-12}, "steps"),
    "integrator": ({"integrator": "heun"}, "rk4"),
    "form": ({"form": "lagrange"}, "joint"),
    "q0": ({"q0": [1.0, 2.0]}, "q0 has length 2"),
    "q0 nan": ({"q0": [1.0, 2.0, np.nan]}, "q0"),
    "controller shape": ({"controller": lambda t, q, v: [1.0]}, r"t = 0 s: the controller .*\(3,\)"),
    "controller none": ({"controller": lambda t, q, v: None}, "controller"),
    "controller nan": ({"controller": lambda t, q, v: [np.nan] * 3}, "controller"),
    "w_ext": ({"w_ext": [1.0, 2.0]}, "w_ext"),
    "parameters": ({"parameters": [1.0]}, "parameters: has 1 numbers"),
    "parameter name": ({"parameters": {"fore.colour": 1.0}}, "fore.colour"),
    "memory": ({"duration": 5e7, "step": 1.0}, "GB"),
}


@pytest.mark.parametrize("case", BAD)
def test_arguments_without_sense_are_refused(case):
    arguments, message = BAD[case]
    with pytest.raises(UsageError, match=message) as caught:
        simulate(soft(), **({"duration": 0.01, "step": 1e-3} | arguments))
    assert "\n" not in str(caught.value)


# -------- forms of one's own


def test_a_form_is_an_argument():
    """What makes a stepper stands where a form is named; it has to say which integrator to take, or be told."""
    model = ella()
    form, posture = partial(CompiledStepper, model.compile()), [0.1, 0.2, 0.3]
    run = simulate(model, 0.01, 1e-3, posture, form=form, integrator="modal_midpoint")
    assert np.abs(run.q - simulate(model, 0.01, 1e-3, posture, backend="casadi").q).max() < 1e-12
    with pytest.raises(UsageError, match="this form names no integrator of its own; give one"):
        simulate(model, 0.01, 1e-3, form=form)
    with pytest.raises(UsageError, match="the backend 'c' steps the joint form"):
        simulate(model, 0.01, 1e-3, form=form, integrator="rk4", backend="c")
    with pytest.raises(TypeError):
        FORMS["compiled"] = form
