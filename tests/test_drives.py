"""What the equations of gears and rotors must do: limits, energy, friction, rest, vibrations, cost."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from drive_robots import ARMATURE, MIXED, RATIO, mixed, pendulum, swing
from helpers import Case, arm, case_of, link, model_of, quick, relative
from random_robots import random_state

from screwgen import PD, Holding, equilibrium, natural_frequencies, simulate
from screwgen.algorithms import fused
from screwgen.simulation.integrate import JointState, JointStepper
from screwgen.simulation.motion import screws
from screwgen.studies.analysis.spectrum import growth, step_map


@cache
def everything(seed: int) -> Case:
    return case_of(MIXED, random_state(np.random.default_rng(seed), MIXED))


# -------- steps


def test_a_stiff_gear_tends_to_the_armature():
    """The error of a motion falls as 1/k: k 1e4 … 1e9 N·m/rad."""
    tau, q, v = np.array([20.0, -5.0]), np.array([0.3, -0.5]), np.array([0.7, -0.4])
    rigid = simulate(swing(modes=0), 0.1, 1e-4, q, v, tau, backend="casadi", every=50)
    qdd = swing(modes=0).numpy().forward_dynamics(q, v, tau, None)[0]
    errors = []
    for k in 10.0 ** np.arange(4, 10):
        soft = swing(k, modes=0)
        q0 = np.append(q, RATIO * (q + (tau - ARMATURE * qdd) / k))
        run = simulate(soft, 0.1, 1e-4, q0, v, tau / RATIO, backend="casadi", every=50)
        errors.append(np.abs(run.q[:, :2] - rigid.q[:, :2]).max())
    assert 1e-6 < errors[0] < 1e-3
    assert np.allclose(np.array(errors[:-1]) / errors[1:], 10.0, rtol=0.1), errors


def test_gears_of_a_kilohertz_do_not_limit_the_step():
    k = (2 * np.pi * 1000) ** 2 * ARMATURE
    model = swing(k)
    growths = {m: growth(step_map(model, m, [np.pi / 2, 0.0], np.zeros(6), 1e-3)) for m in ("modal_midpoint", "rk4")}
    assert abs(growths["modal_midpoint"] - 1) < 1e-9 and growths["rk4"] > 1e3
    run = simulate(model, 3.0, 1e-3, [0.3, -0.5], every=10)
    total = run.energy.sum(axis=1)
    assert np.ptp(run.energy[:, 0]) > 1.0 and np.ptp(total) < 1e-4 * np.ptp(run.energy[:, 0])


def test_energy_is_kept_without_damping():
    """Of second order in the step, and the power is that of torques, gears and friction."""
    drift = []
    for h in (1e-3, 5e-4):
        total = simulate(swing(3e3), 0.5, h, [0.3, -0.5], [1.0, 1.0], backend="casadi").energy.sum(axis=1)
        drift.append(np.abs(total - total[0]).max())
    assert drift[0] < 1e-4 and 2.0 < drift[0] / drift[1] < 6.0
    c = everything(4)
    q, v, tau, w_ext = c.inputs
    vdot = c.model.numpy().forward_dynamics(*c.inputs)[0]
    assert np.isclose(c.oracle.energy_rate(q, v, vdot), c.oracle.power(q, v, tau, w_ext), rtol=1e-9)


# -------- friction


@pytest.mark.parametrize("method", ["modal_midpoint", "modal_implicit"])
@pytest.mark.parametrize("share", [0.5, 0.99])
def test_a_stuck_axis_creeps_as_stated(method, share):
    """Under a torque below dry friction c the rotor turns by w = v_f (tau/c) / sqrt(1 - (tau/c)²)."""
    dry, velocity = 0.4, 0.01
    model = stuck(dry, velocity)
    run = simulate(model, 4.0, 1e-3, controller=[share * dry, 0.0], backend="casadi", integrator=method, every=100)
    w = velocity * share / np.sqrt(1 - share**2)
    assert np.isclose(run.v[-1, 2], w, rtol=1e-6) and np.isclose(run.v[-1, 0] * RATIO, w, rtol=1e-6)


@cache
def stuck(dry: float, velocity: float):
    return model_of(pendulum(3e3, 20.0, {"coulomb": dry, "velocity": velocity}, gravity=(0.0, 0.0, 0.0)))


def test_dry_friction_does_not_limit_the_step():
    """Friction whose slope at rest has a time constant of 1e-7 s, at steps of 1 ms: the rotor stops and stays.

    The midpoint rule leaves its rate an error that changes sign at every step and hardly decays; nothing moves by it.
    """
    for method in ("modal_implicit", "modal_midpoint"):
        run = simulate(stuck(10.0, 1e-3), 0.5, 1e-3, v0=[0.05, 0.0], backend="casadi", integrator=method)
        assert run.energy[-1].sum() < 0.1 * run.energy[0].sum() and np.ptp(run.q[100:, 2]) < 1e-3
    assert np.abs((run.v[-2] + run.v[-1])[2]) < 0.05 * np.abs(run.v[-1, 2])


def test_derivatives_are_finite_at_rest():
    model = mixed()
    rest = np.zeros(model.nq), np.zeros(model.nv), np.zeros(model.n_tau), np.zeros((6, model.n_links))
    slopes = model.casadi()["forward_dynamics"].jacobian()(*rest, model.parameter_values, 0, 0)
    assert all(np.isfinite(x.full()).all() for x in slopes)
    for found, expected in zip(model.numpy().derivatives(*rest[:3], None), slopes[:3], strict=True):
        assert relative(found, expected.full()) < 1e-9


@pytest.mark.parametrize("method", ["modal_implicit", "semi_implicit"])
def test_the_amplification_matrix_is_the_derivative_of_a_step(method):
    """In motion, with dry friction; of the methods that evaluate the dynamics once."""
    c, h = everything(7), 1e-5
    q, v, tau, w_ext = c.inputs
    stepper = JointStepper(c.model, method, c.model.parameter_values)
    after = lambda x: np.concatenate(stepper.step(JointState(*np.split(x, 2)), tau, w_ext, 1e-3))  # noqa: E731
    x, columns = np.append(q, v), []
    for e in h * np.eye(len(x)):
        columns.append((8 * (after(x + e) - after(x - e)) - (after(x + 2 * e) - after(x - 2 * e))) / (12 * h))
    assert relative(step_map(c.model, method, q, v, 1e-3, tau, w_ext=w_ext), np.array(columns).T) < 1e-6


def test_a_pd_law_works_through_gears():
    """Gains and limits are those at the joint: the rotor is measured, and gets its share of the torque."""
    model, q = swing(3e3), np.array([0.4, -0.2])
    law = PD((900.0, 400.0), (120.0, 60.0), tuple(q), duration=0.4, tau_max=(150.0, 60.0), gravity=Holding(model))
    run = simulate(model, 1.0, 1e-3, controller=law, backend="casadi", every=10)
    assert np.abs(run.q[-1, :2] - q).max() < 2e-2 and np.abs(run.tau).max() < 150.0 / RATIO
    plain = replace(law, gravity=None)
    runs = [simulate(model, 0.2, 1e-3, controller=plain, backend=b, every=10) for b in ("c", "numpy")]
    assert relative(runs[0].q, runs[1].q) < 1e-9 and relative(runs[0].tau, runs[1].tau) < 1e-9
    rest = equilibrium(model, q, hold=True)
    assert relative(Holding(model)(q), rest.tau) < 1e-9


def test_screws_and_poses_of_runs_know_where_twists_stand():
    c = everything(8)
    q, v = c.inputs[:2]
    found = screws(c.model, q[None], v[None])
    assert relative(np.hstack([found.omega[0], found.v[0]]), c.oracle.link_twists(q, v)) < 1e-11


# -------- rest and vibration


def test_held_at_rest_gears_pass_on_the_torques():
    """Nothing accelerates; a rotor is wound by tau N / k and its torque is that of the joint over the ratio."""
    model, rng = mixed(), np.random.default_rng(5)
    q = rng.uniform(-1, 1, model.n_joints)
    e = equilibrium(model, q, hold="all")
    assert np.array_equal(e.q[: model.n_joints], q) and e.residual < 1e-10
    vdot = model.numpy().forward_dynamics(e.q, np.zeros(model.nv), e.tau, None)[0]
    weight = np.abs(model.numpy().forward_dynamics(e.q, np.zeros(model.nv), None, None)[0]).max()
    assert np.abs(vdot).max() < 1e-8 * weight and np.abs(e.tau).min() > 1e-6
    wound = e.q[model.n_joints] - 600.0 * q[0]
    assert np.isclose(wound, e.tau[0] * 600.0**2 / 4e4, rtol=1e-9)


def test_free_arms_hang_where_those_with_rigid_gears_do():
    soft, stiff = (equilibrium(swing(k), [0.4, 0.2], tau=[0.05, 0.0] if k else [2.5, 0.0]) for k in (3e3, None))
    assert np.allclose(np.delete(soft.q, [2, 3]), stiff.q, atol=1e-9) and soft.stability == stiff.stability == "stable"
    assert np.isclose(soft.q[2], RATIO * (soft.q[0] + 2.5 / 3e3), atol=1e-9)


def test_gravity_of_the_c_holds_the_arm():
    model, q = mixed(), np.linspace(-0.4, 0.4, mixed().n_joints)
    force, rest = quick(model).gravity(np.append(q, np.zeros(model.nq - len(q))))
    e = equilibrium(model, q, hold="all")
    assert relative(force[: model.n_tau], e.tau) < 1e-6 and relative(rest, e.q) < 1e-6


def test_natural_frequencies_of_free_joints_equal_the_oracle():
    c = everything(6)
    found = natural_frequencies(c.model, c.inputs[0], "free")
    expected = c.oracle.frequencies(c.inputs[0], "free")
    elastic = expected > 1e-3
    assert len(found) == len(expected) and np.count_nonzero(found == 0) == np.count_nonzero(~elastic)
    assert np.allclose(found[elastic], expected[elastic], rtol=1e-6)


# -------- cost


def test_an_elastic_axis_costs_few_operations():
    """At most 5 % of those of an axis with an armature, even where links are rigid; friction costs the dynamics 0."""

    def operations(joint: dict, modes: dict | None) -> int:
        links = [link(f"l{i}", 0.4, "yz"[i % 2], modes=modes, joint=joint) for i in range(6)]
        return fused.complete_dynamics(model_of(arm(*links)).chain).operation_count

    drive = {"ratio": 50.0, "rotor_inertia": 1e-4, "stiffness": 1e4, "damping": 3.0}
    friction = {"friction": {"coulomb": 0.1, "velocity": 0.1}}
    for modes in (None, {"bending_y": 2, "bending_z": 2}):
        bare = operations({"armature": [0.1]}, modes)
        elastic = operations({"drives": [drive]}, modes)
        assert bare < elastic < 1.05 * bare
        assert operations({"drives": [drive | friction]}, modes) == elastic
        assert operations({"drives": [{"ratio": 50.0, "rotor_inertia": 1e-4}]}, modes) == bare
