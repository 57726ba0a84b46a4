"""Springs and dampers of joints in the modal steps: implicit, in every form, precision and back end."""

from functools import cache

import numpy as np
import pytest
from helpers import arm, example_dict, link, model_of, quick

from screwgen import SingularError
from screwgen.runtime.compiled import Compiled
from screwgen.simulation.dae import DaeStepper
from screwgen.simulation.integrate import JointStepper
from screwgen.studies.analysis.spectrum import growth, step_map

DAMPING = {"upper_arm": (600.0, 600.0), "forearm": (150.0,)}
START = np.array([-0.3, 0.4, 0.5, *6 * [0.0]]), np.array([1.0, -2.0, 1.5, *6 * [0.0]])
INPUTS = np.array([30.0, 20.0, 10.0]), np.zeros((2, 6))
DURATION = 0.05


@cache
def ella():
    """ELLA with dampers in its joints, and springs of no stiffness."""
    robot = example_dict("ella")
    for part in robot["links"]:
        part["joint"] |= {"damping": list(DAMPING[part["name"]]), "stiffness": [0.0] * len(part["joint"]["axes"])}
    return model_of(robot)


@cache
def compiled(layout: str, single=False) -> Compiled:
    return quick(ella(), layout=layout, single=single)


def springs(**values: float) -> np.ndarray:
    """ELLA's parameters with every joint's damping and stiffness replaced."""
    p = np.array(ella().parameter_values)
    for name, value in values.items():
        p[[f".joint.{name}[" in other for other in ella().parameter_names]] = value
    return p


# -------- heavy dampers


@cache
def fine() -> np.ndarray:
    """The coordinates at the end by explicit steps of 4 µs."""
    return compiled("fused").step(*START, *INPUTS, 4e-6, "rk4", round(DURATION / 4e-6))[0]


def joint_form(c: Compiled, h: float, method: str) -> np.ndarray:
    return c.step(*START, *INPUTS, h, method, round(DURATION / h))[0]


def dae_form(c: Compiled, h: float, method: str) -> np.ndarray:
    x = c.dae_step(c.dae_state(*START), *INPUTS, h, method, round(DURATION / h))
    return np.append(x[-3:], x[14:20])


WAYS = {
    "C": lambda *given: joint_form(compiled("fused"), *given),
    "C, float, DAE form": lambda *given: dae_form(compiled("modular", True), *given),
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(("method", "order", "error"), [("modal_implicit", 1, 1.5e-3), ("modal_midpoint", 2, 4e-5)])
def test_heavy_dampers_step_to_what_fine_explicit_steps_give(way, method, order, error):
    """600, 600 and 150 N m s/rad at 0.5 and 1 ms, where explicit dampers bear some 10 µs."""
    errors = [np.abs(WAYS[way](h, method) - fine()).max() for h in (1e-3, 5e-4)]
    assert errors[0] < error
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.25)


@pytest.mark.parametrize("method", ["modal_implicit", "modal_midpoint"])
def test_a_million_times_that_damping_holds_the_joints(method):
    c = compiled("fused")
    c.prepare(springs(damping=1e9))
    try:
        q, v = c.step(START[0], np.zeros(9), *INPUTS, 1e-3, method, 500)
        x = c.dae_step(c.dae_state(START[0], np.zeros(9)), *INPUTS, 1e-3, method, 500)
    finally:
        c.prepare(ella().parameter_values)
    assert np.allclose(q[:3], START[0][:3], rtol=0, atol=1e-6) and np.allclose(x[-3:], START[0][:3], rtol=0, atol=1e-6)
    assert np.abs(v).max() < 1


# -------- energy


def pendulum(stiffness: float, damping: float):
    """A rigid link on a spring and a damper; no gravity, a moment of inertia of 1/3 kg m^2."""
    joint = {"stiffness": [stiffness], "damping": [damping]}
    return model_of(arm(link(axes="z", joint=joint), gravity=(0, 0, 0)))


@pytest.mark.parametrize("stiffness", [1e2, 1e6, 1e12])
def test_a_spring_alone_is_kept_by_midpoint_and_damped_by_implicit(stiffness):
    h, rest = 1e-3, ([0.0], [0.0])
    model, damped = pendulum(stiffness, 0.0), pendulum(stiffness, 1e-2 * np.sqrt(stiffness))
    assert growth(step_map(model, "modal_midpoint", *rest, h)) == pytest.approx(1, abs=1e-9)
    assert growth(step_map(model, "modal_implicit", *rest, h)) < 1
    explicit = growth(step_map(model, "semi_implicit", *rest, h))
    assert (explicit > 1 + 1e-6) == (h * np.sqrt(3 * stiffness) > 2)
    for method in ("modal_midpoint", "modal_implicit"):
        assert growth(step_map(damped, method, *rest, h)) < 1


def test_a_heavy_damper_alone_bounds_explicit_steps_only():
    rest, b = ([0.0], [0.0]), 600.0
    limit = 2 / 3 / b
    for h in (0.99 * limit, 1.01 * limit, 1e3 * limit):
        S = {method: step_map(pendulum(0.0, b), method, *rest, h) for method in ("semi_implicit", "modal_midpoint")}
        assert (growth(S["semi_implicit"]) > 1 + 1e-6) == (h > limit)
        assert growth(S["modal_midpoint"]) < 1 + 1e-9


@pytest.mark.parametrize("form", ["joint", "dae"])
@pytest.mark.parametrize("stiffness", [1e3, 1e5, 1e9])
def test_stiff_springs_in_motion_gain_no_energy(form, stiffness):
    """2 s at 1 ms of three sprung joints that start with 280 J at most."""
    c, p, free = compiled("fused"), springs(damping=0.0, stiffness=stiffness), (np.zeros(3), np.zeros((2, 6)))
    judge, soft = ella().numpy(p), max(1.0, stiffness / 1e3)
    q, v = np.array([-0.3, 0.4, 0.5, 0.0, 0.004, -0.003, 0.0, 0.002, 0.003]), np.zeros(9)
    q[:3] /= soft
    v[:3] = np.array([1.0, -1.0, 1.5]) / np.sqrt(soft)
    first, reader = sum(judge.energy(q, v)), DaeStepper(ella(), "modal_midpoint", p)
    c.prepare(p)
    try:
        x = c.dae_state(q, v)
        for _ in range(4):
            if form == "joint":
                q, v = c.step(q, v, *free, 1e-3, "modal_midpoint", 500)
            else:
                x = c.dae_step(x, *free, 1e-3, "modal_midpoint", 500)
                q, v = reader.coordinates(x)
            assert -0.15 * first < sum(judge.energy(q, v)) - first < 0.02 * first
    finally:
        c.prepare(ella().parameter_values)


# -------- a spring without inertia


def test_a_spring_that_turns_nothing_goes_where_the_torque_holds_it():
    """A rod about its own axis, without spin inertia: singular to explicit steps, at rest in the spring to implicit."""
    joint = {"stiffness": [50.0], "damping": [2.0]}
    robot = arm({"name": "rod", "length": 1.0, "section": {"rhoA": 1.0}, "joint": {"axes": ["x"]} | joint})
    model, given = model_of(robot), (np.array([5.0]), np.zeros((1, 6)))
    implicit = JointStepper(model, "modal_implicit", model.parameter_values)
    x = implicit.initial([0.3], [0.0])
    for k in range(1000):
        x = implicit.step(x, *given, 1e-3)
        assert 0.1 < x.q[0] < 0.3 and abs(x.q[0] - 0.1 - 0.2 * np.exp(-25e-3 * (k + 1))) < 3e-3
    with pytest.raises(SingularError, match="rod"):
        model.numpy().forward_dynamics([0.3], [0.0], *given)
