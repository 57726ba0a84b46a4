"""Loops whose joints give way: springs and dampers across their rows, taken at the end of an implicit step."""

from __future__ import annotations

import warnings
from functools import partial

import casadi as ca
import numpy as np
import pytest
from batch_c import CompiledBatch, stepped
from fmi_units import Unit
from helpers import model_of

import screwgen
from screwgen import LoopWarning
from screwgen.backends.numpy.compliant import settled
from screwgen.integrators.methods import BUILT_IN
from screwgen.simulation.linearised import Linearised

SPRING = 0.25
"""J: the energy of the hinge's spring at first."""
IMPLICIT = ("modal_implicit", "modal_midpoint")
STIFFNESS = (1.0, 1e3, 1e6, 1e9, 1e12)
ARM = 0.5
"""m: from the hinge to the body's centre of mass."""


def massless(name, **more):
    return {"name": name, "bodies": [{"at": "base", "mass": 0.0}]} | more


def pendulum(stiffness=None, damping=None):
    """A body in a plane, whose eye a hinge joins to the wall: of constant mass matrix, with a nonlinear gap."""
    body = {"at": "base", "mass": 2.0, "inertia": [0.02, 0.03, 0.02, 0.0, 0.0, 0.0]}
    joint = {"axes": ["y"], "stiffness": stiffness, "damping": damping}
    return {
        "name": "pendulum",
        "gravity": [0.0, 0.0, -9.81],
        "links": [
            {"name": "bob", "joint": {"axes": [{"slide": "x"}, {"slide": "z"}, "y"]}, "bodies": [body]},
            massless("eye", joint={"axes": [], "mount": {"xyz": [-ARM, 0.0, 0.0]}}),
            massless("wall", parent="world", joint={"axes": []}),
        ],
        "loops": [{"between": ["wall.tip", "eye.tip"], "joint": {key: x for key, x in joint.items() if x is not None}}],
    }


def hanging(angle, out=0.0):
    """Coordinates with the hinge open by `out` along x, m."""
    return np.array([ARM * np.cos(angle) + out, -ARM * np.sin(angle), angle])


def linkage(stiffness=None, damping=None):
    """A four-bar linkage with a flexible coupler."""
    joint = {"axes": ["y"], "stiffness": stiffness, "damping": damping}
    bar = lambda name, length, **more: {  # noqa: E731
        "name": name,
        "length": length,
        "section": {"rhoA": 2.0, "rhoIp": 1e-4, "EIy": 1e3},
        "joint": {"axes": ["y"]},
        **more,
    }
    rocker = {"parent": "world", "joint": {"axes": ["y"], "mount": {"xyz": [0.8, 0.0, 0.0]}}}
    links = [bar("crank", 0.3), bar("coupler", 0.9, modes={"bending_z": 1}), bar("rocker", 0.6, **rocker)]
    loop = {
        "between": ["coupler.tip", "rocker.tip"],
        "joint": {key: x for key, x in joint.items() if x is not None},
    }
    return {"name": "linkage", "gravity": [0.0, 0.0, -9.81], "links": links, "loops": [loop]}


# ------------------------------------------------------------------------------------------ energy


@pytest.mark.parametrize("method", IMPLICIT)
@pytest.mark.parametrize("stiffness", STIFFNESS)
def test_energy_never_grows_over_a_hundred_thousand_steps(stiffness, method):
    """A swing through 4 rad/s at 1 ms, of a hinge that is stretched at first; by the midpoint rule it is kept up to an
    oscillation of second order, of 1.5e-5 J."""
    model = model_of(pendulum(stiffness))
    stepper, numeric = model.compile().stepper(1e-3, method=method, count=50), model.numpy()
    stepper.q[:] = hanging(0.5, 1e-3 if stiffness < 1e6 else np.sqrt(2 * SPRING / stiffness))
    energies = [sum(numeric.energy(stepper.q[:3], stepper.v[:3]))]
    for _ in range(2000):
        stepper()
        energies.append(sum(numeric.energy(stepper.q[:3], stepper.v[:3])))
    assert max(energies) <= energies[0] + (2e-5 if method == "modal_midpoint" else 0.0)
    assert energies[-1] < energies[0]


@pytest.mark.parametrize("damping", [None, 40.0])
def test_rk4_keeps_energy_to_its_order(damping):
    """With half the step the error is a sixteenth, or less; and what a damper takes is what is lost."""
    model = model_of(pendulum(2e3, damping))
    numeric, lost = model.numpy(), []
    for step in (1e-3, 5e-4):
        run = screwgen.simulate(model, 0.4, step, q0=hanging(0.3, 2e-3), integrator="rk4")
        total = sum(numeric.energy(run.q[-1], run.v[-1])) - sum(numeric.energy(run.q[0], run.v[0]))
        if damping:
            rates = np.array([numeric.forward_dynamics(q, v, None, None)[0] for q, v in zip(run.q, run.v, strict=True)])
            still = model_of(pendulum(2e3)).numpy()
            free = np.array([still.forward_dynamics(q, v, None, None)[0] for q, v in zip(run.q, run.v, strict=True)])
            M = numeric.mass_matrix(run.q[0])
            power = np.einsum("ti,ij,tj->t", run.v, M, rates - free)
            total -= step / 3 * (power[0] + power[-1] + 4 * power[1:-1:2].sum() + 2 * power[2:-1:2].sum())
        lost.append(abs(total))
    assert lost[1] < 1e-7
    assert lost[0] > 12 * lost[1]


# ------------------------------------------------------------------------------------------ the rigid loop


@pytest.mark.parametrize("form", ["joint", "dae"])
def test_without_bound_of_stiffness_it_is_the_rigid_loop(form):
    """The two differ by the error of the method, 2e-7 rad after 0.3 s at 1 ms, and less with smaller steps."""
    rigid, soft = model_of(linkage()), model_of(linkage(1e12))
    q0 = screwgen.assemble(rigid, [1.0, -1.0, 1.2, 0.0])
    apart = []
    for step in (1e-3, 5e-4):
        ends = [screwgen.simulate(model, 0.3, step, q0=q0, form=form).q[-1] for model in (rigid, soft)]
        apart.append(np.abs(ends[0] - ends[1]).max())
    assert apart[0] < 5e-7
    assert apart[1] < 0.7 * apart[0]


WAYS = {"c": {}, "numpy": {"backend": "numpy"}, "dae": {"form": "dae"}}
"""How a run may be made."""


@pytest.mark.parametrize(("method", "order"), [("modal_midpoint", 0.45), ("modal_implicit", 0.6)])
def test_the_force_that_runs_report_is_that_of_the_rigid_loop(method, order):
    """At 1e12 N/m gaps that are 1e-8 m wrong would be 10 kN; with half the step the error is about half, or a third."""
    rigid, soft = model_of(linkage()), model_of(linkage(1e12))
    q0 = screwgen.assemble(rigid, [1.0, -1.0, 1.2, 0.0])
    apart = []
    for step in (1e-3, 5e-4):
        given = {"q0": q0, "integrator": method}
        expected = screwgen.simulate(rigid, 0.1, step, **given).wrench
        made = [screwgen.simulate(soft, 0.1, step, **given, **way) for way in WAYS.values()]
        runs = [run.wrench for run in made]
        start = np.append(q0, np.zeros(4))
        rolled = screwgen.rollout(soft, start, step=step, steps=len(expected) - 1, integrator=method)
        runs.append(rolled.wrench[0])
        axial = [x.validity.values[:, 2] for x in (rolled, made[0])]
        assert axial[0] == pytest.approx(axial[1], rel=0.05)  # of a rollout at some samples
        assert all(found == pytest.approx(runs[0], abs=1e-8) for found in runs[1:])
        apart.append(np.abs(runs[0] - expected).max() / np.abs(expected).max())
    assert apart[0] < 1e-4
    assert apart[1] < order * apart[0]


@pytest.mark.parametrize("stiffness", [1e9, 1e12, 1e15])
def test_a_body_that_hangs_is_held_by_its_weight(stiffness):
    """Whatever its gap is: at first none, which would be a hinge without a force."""
    run = screwgen.simulate(model_of(pendulum(stiffness)), 0.02, 1e-3, q0=hanging(np.pi / 2))
    held, z = run.wrench[:, 2, 3:], 1e-6 * stiffness / 2.0
    bears = z**4 / (1.0 + z**3 / 100.0)
    assert held[0, 2] == pytest.approx(2.0 * 9.81 * bears / (1.0 + bears), rel=1e-9)
    assert held == pytest.approx(np.tile([0.0, 0.0, 2.0 * 9.81], (len(held), 1)), abs=0.3 / z)


def test_rows_that_a_step_resolves_are_reported_as_they_are():
    """The difference falls with the eighth power of the step; explicit methods have none."""
    model, apart = model_of(pendulum(1e4)), []
    for step, method in ((1e-3, "modal_midpoint"), (5e-4, "modal_midpoint"), (1e-3, "rk4")):
        run = screwgen.simulate(model, 0.01, step, q0=hanging(0.3, 4e-4), integrator=method)
        plain = [model.numpy().forward_dynamics(q, v, None, None)[1] for q, v in zip(run.q, run.v, strict=True)]
        apart.append(np.abs(run.wrench - plain).max())
    assert apart[0] < 1e-3 * np.abs(plain).max()
    assert apart[1] < apart[0] / 100
    assert apart[2] < 1e-11


def test_what_runs_report_is_known_of_a_state():
    model, h = model_of(linkage(3e7, 200.0)), 1e-3
    q0 = screwgen.assemble(model_of(linkage()), [1.0, -1.0, 1.2, 0.0])
    run, numeric = screwgen.simulate(model, 0.02, h, q0=q0), model.numpy()
    for q, v, wrench in zip(run.q, run.v, run.wrench, strict=True):
        w_ext = settled(numeric, q, v, None, None, h)
        assert numeric.forward_dynamics(q, v, None, w_ext)[1] == pytest.approx(wrench, abs=1e-9)


def test_a_mock_up_unit_answers_as_runs_do():
    unit = Unit("fmu3", "cs", partial(linkage, 1e12))
    names, q0 = unit.model.wrench_names, screwgen.assemble(model_of(linkage()), [1.0, -1.0, 1.2, 0.0])
    unit.ready(**dict(zip(unit.states[:4], q0, strict=True)), **{"solver.step": 1e-3})
    found = [unit.get(names)]
    for k in range(20):
        unit.step(k * 1e-3, 1e-3)
        found.append(unit.get(names))
    run = screwgen.simulate(unit.model, 0.02, 1e-3, q0=q0, integrator="modal_implicit")
    assert np.array(found) == pytest.approx(run.wrench.reshape(21, -1), abs=1e-8)


def test_at_rest_its_gap_is_the_load_over_the_stiffness():
    model = model_of(pendulum(1e4))
    rest = screwgen.equilibrium(model, hanging(np.pi / 2))
    assert rest.q == pytest.approx(hanging(np.pi / 2) - [0.0, 2.0 * 9.81 / 1e4, 0.0], abs=1e-9)


def test_its_rows_are_seen_in_vibrations():
    """A body of 2 kg on a weld of 1e4 N/m, which it stretches along its arm without turning."""
    weld = pendulum(1e4)
    weld["loops"][0]["joint"]["axes"] = []
    found = screwgen.natural_frequencies(model_of(weld), hanging(0.0), joints="free")
    assert np.isclose(found, np.sqrt(1e4 / 2.0) / (2 * np.pi)).any()


# ------------------------------------------------------------------------------------------ every stepper alike


@pytest.mark.parametrize("method", [m.name for m in BUILT_IN])
def test_a_step_is_the_same_in_every_back_end(method):
    model, dt = model_of(linkage(1e5, 30.0)), 1e-3 if method in IMPLICIT else 1e-5
    rng = np.random.default_rng(3)
    q = screwgen.assemble(model_of(linkage()), [1.0, -1.0, 1.2, 0.0]) + 1e-3 * rng.normal(size=4)
    v, tau, w_ext = rng.normal(size=4), rng.normal(size=3), rng.normal(size=(3, 6))
    compiled = [model.compile(layout=layout) for layout in ("fused", "modular")]
    found = [np.concatenate(c.step(q, v, tau, w_ext, dt, method)) for c in compiled]
    by_casadi = model.casadi()[f"step_{method}"](q, v, tau, w_ext.T, model.parameter_values, dt)
    found.append(np.concatenate([np.array(x).ravel() for x in by_casadi]))
    lanes = np.array([q, v])[:, :, None], tau[None, :, None], w_ext.reshape(1, -1, 1)
    found.append(stepped(CompiledBatch(model), *lanes, method, dt=dt)[0][:, -1].ravel())
    for other in found[1:]:
        assert other == pytest.approx(found[0], rel=1e-9, abs=1e-11)


@pytest.mark.parametrize("method", IMPLICIT)
def test_both_forms_make_the_same_run(method):
    model = model_of(linkage(1e7, 100.0))
    q0 = screwgen.assemble(model_of(linkage()), [1.0, -1.0, 1.2, 0.0])
    ends = [screwgen.simulate(model, 0.1, 1e-3, q0=q0, integrator=method, form=form) for form in ("joint", "dae")]
    assert ends[0].q[-1] == pytest.approx(ends[1].q[-1], abs=1e-9)


@pytest.mark.parametrize("method", IMPLICIT)
def test_the_step_map_of_an_unloaded_joint_is_that_of_the_step(method):
    robot = pendulum(1e5, 8.0) | {"gravity": [0.0, 0.0, 0.0]}
    model, h = model_of(robot), 2e-3
    q, size = hanging(0.4), 1e-6
    compiled = model.compile()
    step = lambda x: np.concatenate(compiled.step(x[:3], x[3:], None, None, h, method))  # noqa: E731
    at = np.append(q, np.zeros(3))
    differences = np.array([(step(at + size * e) - step(at - size * e)) / (2 * size) for e in np.eye(6)]).T
    found = Linearised(model, q, np.zeros(3)).step_map(method, h)
    assert found == pytest.approx(differences, rel=1e-5, abs=1e-5 * np.abs(differences).max())


@pytest.mark.parametrize("stiffness", [1e4, 1e12])
def test_derivatives_of_a_step_in_c_are_those_of_casadi_and_differences_of_the_step(stiffness):
    """Two derivatives by rounding differ the more the stiffer a row is, at 1e12 N/m by 2e-9 of the largest."""
    model, h, x = model_of(linkage(stiffness, 20.0)), 1e-3, ca.MX.sym("x", 11)
    rng = np.random.default_rng(1)
    q = screwgen.assemble(model_of(linkage()), [1.0, -1.0, 1.2, 0.0]) + 1.0 / stiffness
    v, tau, w_ext = rng.normal(size=4), rng.normal(size=3), rng.normal(size=(3, 6))
    compiled, at = model.compile(derivatives=True), np.concatenate([q, v, tau])
    for method in IMPLICIT:
        step = partial(lambda m, x: np.concatenate(compiled.step(x[:4], x[4:8], x[8:], w_ext, h, m)), method)
        *new, A, B = compiled.step_derivatives(q, v, tau, w_ext, h, method)
        assert np.concatenate(new) == pytest.approx(step(at), rel=1e-14)
        after = model.casadi()[f"step_{method}"](x[:4], x[4:8], x[8:], w_ext.T, model.parameter_values, h)
        by_casadi = np.array(ca.Function("slopes", [x], [ca.jacobian(ca.vertcat(*after), x)])(at))
        slopes = np.hstack([A, B])
        assert np.abs(slopes - by_casadi).max() < (1e-11 if stiffness < 1e12 else 1e-8) * np.abs(slopes).max()
        differences = np.array([(step(at + e) - step(at - e)) / 2e-6 for e in 1e-6 * np.eye(11)]).T
        assert np.abs(slopes - differences).max() < 1e-5 * np.abs(slopes).max()


def beside_a_rigid_one(stiffness):
    """A second linkage that shares the crank, rigid."""
    robot = linkage(stiffness)
    twin = [link | {"name": f"{link['name']}2"} for link in robot["links"][1:]]
    twin[0]["parent"] = "crank"
    robot["links"] += twin
    robot["loops"].append({"between": ["coupler2.tip", "rocker2.tip"], "joint": {"axes": ["y"]}})
    return robot


def test_beside_a_rigid_loop_both_hold():
    """Its row and the soft ones are solved for together."""
    robot = beside_a_rigid_one(1e12)
    rigid = robot | {"loops": [{**robot["loops"][0], "joint": {"axes": ["y"]}}, robot["loops"][1]]}
    q0 = screwgen.assemble(model_of(rigid), [1.0, -1.0, 1.2, -1.0, 1.2, 0.0, 0.0])
    ends = [screwgen.simulate(model_of(x), 0.1, 1e-3, q0=q0).q[-1] for x in (robot, rigid)]
    assert ends[0] == pytest.approx(ends[1], abs=1e-5)


@pytest.mark.parametrize("method", IMPLICIT)
def test_derivatives_of_a_step_beside_a_rigid_loop(method):
    """By differences of the step, whose rigid rows are among those that are solved for."""
    robot = beside_a_rigid_one(1e5)
    model, rng = model_of(robot), np.random.default_rng(4)
    rigid = robot | {"loops": [{**robot["loops"][0], "joint": {"axes": ["y"]}}, robot["loops"][1]]}
    q, v = screwgen.assemble(model_of(rigid), [1.0, -1.0, 1.2, -1.0, 1.2, 0.0, 0.0]), rng.normal(size=7)
    compiled, tau = model.compile(derivatives=True), rng.normal(size=model.n_tau)
    step = lambda x: np.concatenate(compiled.step(x[:7], x[7:14], x[14:], None, 1e-3, method))  # noqa: E731
    *_, A, B = compiled.step_derivatives(q, v, tau, None, 1e-3, method)
    at, size = np.concatenate([q, v, tau]), 1e-6
    differences = np.array([(step(at + e) - step(at - e)) / (2 * size) for e in size * np.eye(len(at))]).T
    assert np.hstack([A, B]) == pytest.approx(differences, abs=1e-7 * np.abs(differences).max())


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_energy_that_many_steps_gain_is_said(backend):
    """None of them is far off, and the loop stays closed: steps of first order gain it bit by bit."""
    model = model_of(pendulum())
    start = dict(q0=hanging(0.5), backend=backend, every=20)
    with pytest.warns(LoopWarning, match=r"by t = \S+ s steps have gained \d\d % of the largest kinetic energy out of"):
        run = screwgen.simulate(model, 8.0, 4e-3, integrator="modal_implicit", **start)
    total = run.energy.sum(axis=1)
    assert total[-1] - total[0] > 0.05 * run.energy[:, 0].max()
    with warnings.catch_warnings():
        warnings.simplefilter("error", LoopWarning)
        screwgen.simulate(model, 8.0, 4e-3, **start)
