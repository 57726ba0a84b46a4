"""A kind of input made in Python: the acceleration of a ship that carries an arm.

The same arm with another gravity is the judge, and the arm on a cart that is driven with the acceleration.
"""

import copy
from dataclasses import dataclass

import numpy as np
import pytest
from helpers import arm, link, model_of, relative
from outside import Outside, every_check
from scipy.integrate import simpson

from screwgen import Input, Robot, RobotFileError, UsageError, derive, dump, equilibrium, simulate
from screwgen.plotting.run_panels import panels
from screwgen.runtime.estimator import Noise
from screwgen.simulation.estimator import Estimator


@dataclass(frozen=True)
class BaseAcceleration(Input):
    """The base of the arm accelerates, m/s², inertial axes; motion and energy are those that its passenger sees."""

    words = "an accelerated base"
    quantity = "gravity"

    def names(self, robot):
        return [f"ship.{x}" for x in ("surge", "sway", "heave")]

    def units(self, robot):
        return ["m/s²"] * 3

    def free_fall(self, entries):
        return [-a for a in entries]


A = np.array([0.7, -1.3, 2.1])
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
TENDON = {"name": "left", "at": [[0.0, 0.02, 0.01], [0.0, 0.01, 0.0]]}


def robot(*inputs, gravity=(0.0, -3.0, -6.0), tendons=(TENDON,), **more):
    """A flexible arm of two links whose second one slides, with a tendon along the first."""
    first = link("upper", 0.7, ("z", "y"), joint={"damping": [0.3, 0.2]}, tendons=list(tendons), **SOFT)
    slide = link("fore", 0.4, [{"slide": "x"}], **SOFT)
    return arm(first, slide, gravity=gravity, **({"inputs": inputs} if inputs else {}), **more)


MODEL, OTHER = model_of(robot(BaseAcceleration())), model_of(robot(gravity=tuple(np.array([0.0, -3.0, -6.0]) - A)))
Q = np.array([0.2, -0.4, 0.1, 0.004, -0.003, 0.002, 0.005])
V = 0.3 * np.cos(np.arange(MODEL.nv))
TAU, W_EXT = np.array([0.4, -0.3, 2.0, 5.0]), np.arange(12.0).reshape(2, 6) / 10


@pytest.fixture(scope="module")
def accelerated():
    expected = OTHER.numpy().forward_dynamics(Q, V, TAU, W_EXT)
    out = Outside(MODEL, (Q, V, np.append(TAU, A), W_EXT), *expected)
    out.robot = robot(BaseAcceleration())
    return out


@every_check
def test_it_acts_as_another_gravity_does(accelerated, check):
    accelerated.holds(check)


@pytest.mark.parametrize(
    "check",
    ["derivatives of wrenches", "document", "C folder", "mock-up unit", "acados", "acados, DAE form", "estimator"],
)
def test_it_goes_on_to(accelerated, check):
    accelerated.holds(check)


def test_it_acts_as_a_cart_does_that_is_driven_with_it():
    """The forces that move the cart of three slides so are found by its inverse dynamics."""
    rider = copy.deepcopy(robot(BaseAcceleration(), tendons=()))
    slides = [link(x, 0.1, [{"slide": x}], bodies=[{"at": "tip", "mass": 3.0}]) for x in "xyz"]
    first, second = rider["links"]
    first["joint"] |= {"mount": {"xyz": [-0.1, 0.0, 0.0], "rpy": [0.0, 0.0, 0.0]}}
    cart = model_of({**rider, "links": [*slides, first, second], "inputs": ()})
    found, wrench = model_of(rider).numpy().forward_dynamics(Q, V, np.append(TAU[:3], A), W_EXT)
    on_cart = np.r_[0.0, 0.0, 0.0, Q[:3], Q[3:]], np.r_[0.0, 0.0, 0.0, V], np.vstack([np.zeros((3, 6)), W_EXT])
    force = cart.numpy().inverse_dynamics(*on_cart[:2], np.append(A, found), on_cart[2])
    assert relative(force[3:6], TAU[:3]) < 1e-11 and np.abs(force[6:]).max() < 1e-9
    driven = cart.numpy().forward_dynamics(*on_cart[:2], np.append(force[:3], TAU[:3]), on_cart[2])
    assert relative(driven[0], np.append(A, found)) < 1e-10 and relative(driven[1][3:], wrench) < 1e-10


def test_its_power_is_what_the_passenger_sees_the_arm_gain():
    plain = robot(BaseAcceleration(), tendons=())
    for one in plain["links"]:
        one["joint"].pop("damping", None)
    tau = np.append(TAU[:3], A)
    run = simulate(model_of(plain), 0.01, 1e-5, q0=Q, v0=V, controller=tau, integrator="rk4")
    gained = run.energy.sum(axis=1) - run.energy[0].sum()
    assert gained[-1] == pytest.approx(simpson(run.drive_power.sum(axis=1), x=run.t), rel=1e-7)
    shown = {panel.title: panel for panel in panels(run)}
    assert shown["Other inputs"].unit == "m/s²" and "3 other inputs" in repr(run)
    assert run.names_of("drive_power")[3:] == tuple(f"ship.{x}.power" for x in ("surge", "sway", "heave"))


def test_sensors_equilibria_and_scales_know_it():
    tau = np.append(TAU, A)
    felt, expected = (m.numpy().accelerometer(Q, V, x, W_EXT) for m, x in ((MODEL, tau), (OTHER, TAU)))
    assert relative(felt, expected) < 1e-12
    held = [equilibrium(m, Q[:3], x[3:], hold="all") for m, x in ((MODEL, tau), (OTHER, TAU))]
    assert relative(held[0].q, held[1].q) < 1e-12 and relative(held[0].wrench, held[1].wrench) < 1e-12
    assert relative(held[0].tau, np.append(held[1].tau, A)) < 1e-12
    scales = np.ravel(MODEL.casadi()["scaling"](MODEL.parameter_values)[2])
    assert len(scales) == 7 and (scales > 0).all()


def test_its_power_is_told_beside_internal_states():
    """Bristles add an entry to the state, not to what an input does work on."""
    found = []
    for friction in ({}, {"coulomb": 0.4, "memory": {"stiffness": 50.0, "damping": 0.1}}):
        one = robot(BaseAcceleration())
        one["links"][1]["joint"] |= {"drives": [{"friction": friction}]} if friction else {}
        model = model_of(one)
        v = np.append(V, np.zeros(model.chain.nvz - model.nv))
        found.append(model.numpy().drive_power(Q, v, np.append(TAU, A))[-3:])
    assert np.abs(found[0]).min() > 0.1 and relative(*found) < 1e-12


def test_steps_with_a_line_to_the_world_that_is_taken_at_their_end_know_it():
    line = {"stiffness": 400.0, "rest": 0.2, "damping": 8.0, "implicit": True}
    mooring = [{"name": "mooring", "between": [{"world": [0.3, 0.4, -0.5]}, "fore.tip"], "line": line}]
    one, other = (
        model_of(robot(*own, forces=mooring, gravity=tuple(np.array([0.0, -3.0, -6.0]) - a)))
        for own, a in (([BaseAcceleration()], 0 * A), ([], A))
    )
    found = [simulate(m, 0.02, 1e-3, q0=Q, v0=V, controller=x) for m, x in ((one, np.append(TAU, A)), (other, TAU))]
    assert relative(found[0].q, found[1].q) < 1e-10 and relative(found[0].v, found[1].v) < 1e-10


def test_accelerometers_of_filters_feel_it():
    names, found = ["encoder", "acceleration", "accelerometer"], []
    for model, tau in ((MODEL, np.append(TAU, A)), (OTHER, TAU)):
        own = Estimator(model, measurements=names)
        own.start(Q, V, 1e-2, 1e-1, Noise(1e-2, 1e-10, sensors=dict.fromkeys(names, 0.1)))
        rows = {row.name: row for row in own.measurements}
        found.append([own.compared(rows[x], np.zeros(rows[x].n_values(model.chain)), tau, W_EXT) for x in names[1:]])
    for one, other in zip(*found, strict=True):
        assert relative(one.rest, other.rest) < 1e-12 and relative(one[0], other[0]) < 1e-12


def test_what_does_not_know_it_says_so():
    with pytest.raises(UsageError, match="inputs are objects made in Python; a robot file cannot state them"):
        dump(Robot(**robot(BaseAcceleration())))
    with pytest.raises(RobotFileError, match=r"inputs\[0\]: is 3.0; it must be an object of a subclass of"):
        Robot(**robot(3.0))
    with pytest.raises(RobotFileError, match=r'inputs.1.: is "an accelerated base" again; leave one of them out'):
        Robot(**robot(BaseAcceleration(), BaseAcceleration()))
    named = {"names": lambda self, robot: [f"base.force[{k}]" for k in range(3)]}
    with pytest.raises(UsageError, match=r"inputs: 'base.force\[0\]' is a name that the product's own inputs have"):
        derive(Robot(**robot(type("Pushed", (BaseAcceleration,), named)())))
