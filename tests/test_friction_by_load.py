"""Friction that grows with the load of an elastic gear: closed forms, the oracle, all back ends beside each other."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from bad_robot_files import GOOD, refused
from conftest import package
from helpers import arm, casadi_forward, case_of, disagreement, link, model_of, quick, quick_batch, relative
from random_robots import random_state
from step_judges import by_casadi, point

import screwgen
from screwgen.simulation.integrate import JointState, JointStepper
from screwgen.studies.analysis.spectrum import step_map

DRY = {"coulomb": 0.3, "viscous": 0.02, "velocity": 0.2, "load": 0.6}
STRIBECK = {"stribeck": {"static": 0.7, "velocity": 0.4}}
STICKING = {"coulomb": 0.3, "viscous": 0.02, "load": 0.6, "memory": {"stiffness": 40.0, "damping": 0.3}}
GEAR = {"ratio": 30.0, "rotor_inertia": 2e-4, "stiffness": 900.0, "damping": 2.0}
DIRECT = {"rotor_inertia": 0.3, "stiffness": 60.0, "damping": 0.5}
SOFT = {"EA": 5e4, "EIy": 300.0, "EIz": 500.0, "GJ": 20.0}
TIP = {"at": "tip", "mass": 1.0, "com": [0.1, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.001, 0.0, 0.0]}


def robot(dry: dict) -> dict:
    """Two bending links; of three drives one states no ratio, and one no load."""
    drives = [GEAR | {"friction": dry | STRIBECK}, DIRECT | {"friction": dry}]
    plain = GEAR | {"friction": {"coulomb": 0.2, "velocity": 0.1}}
    bent = {"modes": {"bending_z": 1}, "section": SOFT}
    return arm(
        link("a", 0.7, "yz", joint={"drives": drives}, **bent),
        link("b", 0.5, "y", joint={"drives": [plain]}, bodies=[TIP]),
    )


ROBOTS = {"dry": robot(DRY), "bristles": robot(STICKING)}
MODELS = {name: model_of(own) for name, own in ROBOTS.items()}
BOTH = pytest.mark.parametrize("name", ROBOTS)


def loaded_point(name, seed=3):
    """A state in which gears are stretched, also away from the load, and bristles bent."""
    model, rng = MODELS[name], np.random.default_rng(seed)
    q, v, tau, w_ext = point(model, seed)
    q[3:6] += [9.0, -0.6, 2.0] * rng.uniform(0.5, 1.0, 3)
    return q, np.append(v, rng.uniform(-0.02, 0.02, model.chain.n_internal)), tau, w_ext


def constant(tau):
    return lambda t, q, v: tau


# -------- closed forms


def turning(drive: dict):
    """A rigid body of 0.5 kg·m² that a drive turns about its vertical axis."""
    body = {"at": "base", "mass": 1.0, "com": [0.0] * 3, "inertia": [0.5, 0.5, 0.5, 0.0, 0.0, 0.0]}
    joint = {"axes": ["z"], "drives": [drive]}
    return model_of(arm({"name": "arm", "length": 0.3, "bodies": [body], "joint": joint}))


def test_the_size_is_that_of_the_file_at_twenty_loads():
    """`coulomb + load |torque on the rotor|`, whatever the signs of rate and load."""
    model = turning(GEAR | {"friction": DRY | {"velocity": 1e-9}})
    for torque in np.linspace(-40.0, 40.0, 20):  # of the gear at the joint
        for w in (-2.0, 5.0):
            q, rates = [0.4, 30.0 * (0.4 + torque / 900.0)], [w / 30.0, w]
            a = model.numpy().forward_dynamics(q, rates, [0.0], None)[0][1]
            friction = -a * GEAR["rotor_inertia"] - torque / 30.0
            assert friction == pytest.approx(0.02 * w + np.sign(w) * (0.3 + 0.6 * abs(torque) / 30.0), rel=1e-9)


@pytest.mark.parametrize("dry", [DRY | {"velocity": 1e-4}, STICKING], ids=ROBOTS)
@pytest.mark.parametrize("load", [12.0, -12.0])
def test_at_a_steady_rate_the_effort_is_friction_and_load(dry, load):
    """A torque on the arm resists the drive, or drives it: what the effort leaves is viscous friction."""
    model = turning(GEAR | {"friction": dry})
    effort = load / 30.0 + 0.3 + 0.6 * abs(load) / 30.0 + 0.02 * 4.0  # which turns the rotor by 4 rad/s
    run = screwgen.simulate(
        model, duration=20.0, step=2e-3, controller=constant([effort]), w_ext=[[0.0, 0.0, -load, 0.0, 0.0, 0.0]]
    )
    assert run.v[-1, 1] == pytest.approx(4.0, rel=1e-6) and run.v[-1, 0] == pytest.approx(4.0 / 30.0, rel=1e-6)


def test_it_holds_a_load_that_it_would_not_hold_without():
    """Of a gear whose share is above one the load does not turn the rotor back, as of a worm gear."""
    load, stretched = [[0.0, 0.0, 20.0, 0.0, 0.0, 0.0]], [20.0 / 900.0, 0.0]
    for share, rate in ((1.2, 0.0), (0.8, (0.2 * 20.0 / 30.0 - 0.01) / 0.02)):
        model = turning(GEAR | {"friction": STICKING | {"coulomb": 0.01, "load": share}})
        run = screwgen.simulate(model, 10.0, 1e-3, q0=stretched, w_ext=load)
        assert run.v[-1, 1] == pytest.approx(rate, rel=1e-6, abs=1e-9)


@BOTH
def test_nothing_is_gained(name):
    run = screwgen.simulate(MODELS[name], 2.0, 2e-3, q0=[0.4, -0.3, 0.5, 14.0, -0.5, 17.0, 0.0])
    total = run.energy.sum(axis=1)
    assert np.diff(total).max() <= 1e-6 * np.ptp(run.energy[:, 0]) and total[-1] < total[0]


# -------- beside others


@pytest.mark.parametrize("seed", range(5))
def test_the_oracle_finds_the_same(seed):
    case = case_of(ROBOTS["dry"], random_state(np.random.default_rng(seed), ROBOTS["dry"]))
    given = case.inputs
    found = case.model.numpy().forward_dynamics(*given)
    assert disagreement(case.oracle, found, case.oracle.forward_dynamics(*given)) < 1e-10


def test_bristles_are_those_of_their_equations():
    """Beside the same robot without friction, whose rotors feel what is written here as torques."""
    q, v, tau, w_ext = loaded_point("bristles")
    model, frictionless = MODELS["bristles"], robot({"viscous": 0.0})
    for place in frictionless["links"]:
        place["joint"]["drives"] = [{k: x for k, x in d.items() if k != "friction"} for d in place["joint"]["drives"]]
    w, z, loads = v[3:5], v[7:], [900.0 / 30.0 * (q[3] / 30.0 - q[0]), 60.0 * (q[4] - q[1])]
    size = 0.3 + 0.6 * np.abs(loads) + [0.4 * np.exp(-((w[0] / 0.4) ** 2)), 0.0]
    zdot = w - 40.0 * np.abs(w) * z / size
    friction = np.append(40.0 * z + 0.3 * zdot + 0.02 * w, 0.2 * v[5] / np.hypot(v[5], 0.1))
    free = model_of(frictionless).numpy().forward_dynamics(q, v[:7], tau - friction, w_ext)
    found = model.numpy().forward_dynamics(q, v, tau, w_ext)
    assert relative(found[0], np.append(free[0], zdot)) < 1e-12


@BOTH
def test_every_back_end_finds_the_same(name):
    model, given = MODELS[name], loaded_point(name)
    expected = model.numpy().forward_dynamics(*given)[0]
    assert relative(casadi_forward(model, *given)[0], expected) < 1e-12
    assert relative(quick(model).forward_dynamics(*given)[0], expected) < 1e-12
    package("jax").config.update("jax_enable_x64", True)
    assert relative(model.jax()["forward_dynamics"](*given, model.parameter_values)[0], expected) < 1e-12


@BOTH
@pytest.mark.parametrize("method", ["modal_midpoint", "modal_implicit", "rk4"])
def test_every_back_end_steps_alike(name, method):
    model, (q, v, tau, w_ext), h = MODELS[name], loaded_point(name), 1e-3
    stepper = JointStepper(model, method, model.parameter_values)
    after = stepper.step(JointState(q, v), tau, w_ext, h)
    expected = np.concatenate([after.q, after.v])
    found = {
        "C": quick(model).step(q, v, tau, w_ext, h, method),
        "CasADi": model.casadi()[f"step_{method}"](q, v, tau, w_ext.T, model.parameter_values, h),
        "JAX": model.jax()[f"step_{method}"](q, v, tau, w_ext, model.parameter_values, h),
    }
    for of, values in found.items():
        assert relative(np.concatenate([np.ravel(x) for x in values]), expected) < 1e-12, of


@BOTH
def test_runs_of_the_maximal_form_and_of_lanes_are_those_of_the_joint_form(name):
    model, (q, v, *_) = MODELS[name], loaded_point(name)
    tau, gaps = [0.5, -1.0, 0.1], []
    for h in (1e-3, 5e-4):
        of = {"duration": 0.05, "step": h, "q0": q, "v0": v, "controller": constant(tau)}
        run, dae = (screwgen.simulate(model, form=form, **of) for form in ("joint", "dae"))
        gaps.append(relative(dae.v[-1], run.v[-1]))
    assert gaps[0] < 1e-5 and gaps[0] / gaps[1] > 3.0  # of second order in the step
    quick_batch(model)
    lanes = screwgen.rollout(model, np.append(q, v), tau, step=h, steps=100)
    assert relative(lanes.v[0], run.v) < 1e-10


# -------- slopes


@BOTH
@pytest.mark.parametrize("method", ["modal_midpoint", "modal_implicit", "rk4"])
def test_derivatives_of_steps_are_those_of_casadi(name, method):
    model, x, h = MODELS[name], loaded_point(name), 2e-3
    _, _, *AB = quick(model, derivatives=True).step_derivatives(*x, h, method)
    symbols = [ca.SX.sym(name, size) for name, size in zip("qvu", (model.nq, len(x[1]), len(x[2])), strict=True)]
    after = ca.vertcat(*model.casadi()[f"step_{method}"](*symbols, x[3].T, model.parameter_values, h))
    expected = [ca.jacobian(after, ca.vertcat(*symbols[:2])), ca.jacobian(after, symbols[2])]
    for mine, other in zip(AB, ca.Function("AB", symbols, expected)(*x[:3]), strict=True):
        assert relative(mine, other.full()) < 1e-10


def test_the_map_of_a_step_is_its_derivative():
    model, (q, v, tau, w_ext), h = MODELS["dry"], loaded_point("dry"), 2e-3
    A, _ = by_casadi(model, "modal_implicit", q, v, tau, w_ext, h)
    assert relative(step_map(model, "modal_implicit", q, v, h, tau=tau, w_ext=w_ext), A) < 1e-9


# -------- files

ELASTIC = "{ rotor_inertia = 1e-4, stiffness = 1e4, friction = { load = 0.1"


@pytest.mark.parametrize(
    ("drives", "where", "fragment"),
    [
        (
            "{ friction = { coulomb = 1.0, velocity = 0.1, load = 0.1 } }",
            "friction.load",
            "no stretch that tells the load",
        ),
        (f"{ELASTIC}, viscous = 1.0 }} }}", "friction.load", "without coulomb"),
        (f"{ELASTIC.replace('0.1', '-0.1')}, coulomb = 1.0, velocity = 0.1 }} }}", "friction.load", "must be >= 0"),
    ],
)
def test_what_tells_no_load_is_refused_in_one_line(tmp_path, drives, where, fragment):
    refused(
        tmp_path,
        GOOD.replace("[0.1, 0.2]", f"[0.1, 0.2]\ndrives = [{{}}, {drives}]"),
        f"links[0].joint.drives[1].{where}",
        fragment,
    )
