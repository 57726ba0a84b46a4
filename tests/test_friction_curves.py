"""Friction that is a curve of the rate: Stribeck's, and the bend of strain-wave gears; with bristles and without."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import model_of
from scipy.integrate import solve_ivp

import screwgen
from screwgen.algorithms.law_programs import forces, replayed, secants
from screwgen.elements import BEND, FALLING, FALLING_LOADED, LOADED
from screwgen.interchange.urdf_write import export_urdf
from screwgen.simulation.integrate import JointState, JointStepper
from screwgen.spec.parameters import parameters
from screwgen.studies.analysis.spectrum import step_map

CURVE = {
    "coulomb": 1.0,
    "viscous": 0.4,
    "velocity": 1e-3,
    "stribeck": {"static": 1.6, "velocity": 0.1},
    "bend": {"friction": 0.7, "velocity": 0.5},
}
STICKING = {key: x for key, x in CURVE.items() if key != "velocity"} | {"memory": {"stiffness": 900.0, "damping": 2.0}}
GEAR = {"ratio": 20.0, "rotor_inertia": 5e-3, "stiffness": 800.0, "damping": 1.0}
INERTIA = 0.5
IMPLICIT = ("modal_midpoint", "modal_implicit")
METHODS = (*IMPLICIT, "rk4", "semi_implicit")


def arm(drive: dict, **joint):
    """A rigid link of 0.5 kg·m² about its vertical axis."""
    body = {"at": "base", "mass": 1.0, "com": [0.0] * 3, "inertia": [INERTIA, INERTIA, INERTIA, 0.0, 0.0, 0.0]}
    link = {"name": "arm", "length": 0.3, "bodies": [body], "joint": {"axes": ["z"], "drives": [drive], **joint}}
    return model_of({"name": "rubbing", "gravity": [0.0, 0.0, -9.81], "links": [link]})


def curve(w, friction=CURVE, smooth: bool = True):
    """The friction at steady rates; ``smooth``: that without bristles."""
    falling, bend = friction["stribeck"], friction["bend"]
    size = friction["coulomb"] + (falling["static"] - friction["coulomb"]) * np.exp(-((w / falling["velocity"]) ** 2))
    sign = w / np.sqrt(w**2 + friction["velocity"] ** 2) if smooth else np.sign(w)
    return friction["viscous"] * w + size * sign + bend["friction"] * w / np.sqrt(w**2 + bend["velocity"] ** 2)


RATES = np.concatenate([np.geomspace(1e-5, 30.0, 10), -np.geomspace(1e-5, 30.0, 10)])


@pytest.mark.parametrize("geared", [False, True])
def test_steady_rates_meet_the_curve(geared):
    """At twenty rates, of the joint and of the rotor behind an elastic gear."""
    model = arm((GEAR if geared else {}) | {"friction": CURVE})
    for w in RATES:
        at_joint, inertia = (w / GEAR["ratio"], GEAR["rotor_inertia"]) if geared else (w, INERTIA)
        a = model.numpy().forward_dynamics(np.zeros(model.nq), [at_joint, w][: model.nq], [0.0], None)[0]
        assert -a[-1] * inertia == pytest.approx(curve(w), rel=1e-12)


def test_steady_rates_of_bristles_meet_it_too():
    model = arm({"friction": STICKING})
    for w in RATES:
        size = (curve(w, CURVE, False) - CURVE["viscous"] * w) * np.sign(w)
        size -= CURVE["bend"]["friction"] * abs(w) / np.hypot(w, CURVE["bend"]["velocity"])
        a, zdot = model.numpy().forward_dynamics([0.0], [w, np.sign(w) * size / 900.0], [0.0], None)[0]
        assert abs(zdot) <= 1e-12 * abs(w) and -a * INERTIA == pytest.approx(curve(w, CURVE, False), rel=1e-12)


@pytest.mark.parametrize("law", [FALLING, LOADED, FALLING_LOADED, BEND], ids=lambda law: law.name)
def test_it_never_gives_energy(law):
    """In 10,000 states with numbers of their own, also where friction rises, and so for what steps take."""
    rng, names = np.random.default_rng(3), list(law.constants)
    numbers = 10.0 ** rng.uniform(-6, 6, (7, 10_000))
    given = dict(zip(names, law.prepared(*numbers[: len(names) + law.beside]), strict=True))
    given |= {"axis": rng.normal(size=10_000)} if law.beside else {}
    w, there = rng.choice([-1.0, 1.0], (2, 10_000)) * 10.0 ** rng.uniform(-8, 6, (2, 10_000))
    found = replayed(forces(law, (1,)), given | {"x": 0.0 * w, "w": w})
    assert np.all(found["force"] * w >= 0) and np.isfinite(found["by_w"]).all()
    taken = replayed(secants(law), given | {"side": 1.0, "x": 0.0 * w, "w": w, "there": there, "h": 1e-3 + 0.0 * w})
    assert np.all(taken["damping"] >= 0)
    assert not any(np.any(np.asarray(taken[name]) != 0) for name in ("stiffness", "rest", "constant"))


@pytest.mark.parametrize(
    ("friction", "method"),
    [*((CURVE, method) for method in METHODS), *((STICKING, method) for method in (*IMPLICIT, "rk4"))],
)
def test_nothing_is_gained(friction, method):
    """Energy never grows while nothing pushes, of implicit methods at steps that are a hundred times as long."""
    model, step = arm({"friction": friction}), 1e-2 if method in IMPLICIT else 1e-4
    run = screwgen.simulate(model, duration=1.0, step=step, v0=[3.0], integrator=method)
    total = run.energy.sum(axis=1)
    assert np.diff(total).max() <= 1e-9 * total[0] and total[-1] < 0.05 * total[0]


def drawn(model, k: float, rate: float, step: float, duration: float, method: str):
    """A run of the arm, which a spring of stiffness k draws whose other end turns at a rate."""
    law = lambda t, q, v: [k * (rate * t - q[0])]  # noqa: E731
    return screwgen.simulate(model, duration=duration, step=step, controller=law, integrator=method)


@pytest.mark.parametrize(
    ("method", "step", "share"),
    [
        ("modal_midpoint", 2e-4, 0.01),
        ("modal_implicit", 5e-5, 0.02),
        ("rk4", 2e-4, 0.01),
        ("semi_implicit", 2e-4, 0.01),
    ],
)
def test_a_spring_that_is_drawn_makes_it_stick_and_slip(method, step, share):
    """As SciPy finds it on equations that are written here: it sticks until the static friction, and slips in jumps."""
    k, rate, duration = 4.0, 0.1, 14.0
    friction = CURVE | {"viscous": 0.05, "bend": {"friction": 0.1, "velocity": 0.5}}

    def rates(t, x):
        return [x[1], (k * (rate * t - x[0]) - curve(x[1], friction)) / INERTIA]

    times = np.linspace(0.0, duration, 71)
    wanted = solve_ivp(rates, (0.0, duration), [0.0] * 2, method="Radau", rtol=1e-10, atol=1e-13, t_eval=times).y
    run = drawn(arm({"friction": friction}), k, rate, step, duration, method)
    found = np.array([np.interp(times, run.t, x[:, 0]) for x in (run.q, run.v)])
    assert np.all(np.abs(found - wanted).max(axis=1) <= share * np.abs(wanted).max(axis=1))
    pull, slips = k * (rate * run.t - run.q[:, 0]), np.flatnonzero(np.diff((run.v[:, 0] > 0.02).astype(int)) == 1)
    assert len(slips) >= 3 and pull[slips] == pytest.approx(friction["stribeck"]["static"], rel=0.05)
    assert pull[slips[0] :].min() < friction["coulomb"]


@pytest.mark.parametrize("w", [0.05, 0.8])
def test_a_step_leaves_a_steady_rate_as_the_slope_says_and_no_faster(w):
    """On the falling branch away from it, on the rising one towards it and never past it, at steps of any length."""
    model, e = arm({"friction": CURVE}), 1e-6
    slope = (curve(w + e) - curve(w - e)) / (2 * e)
    for step in (1e-3, 1e-1, 10.0):
        factor = step_map(model, "modal_implicit", [0.0], [w], step, [curve(w)])[1, 1]
        assert 0 < factor < 1 if slope > 0 else 1 < factor <= 1 - step * slope / INERTIA + 1e-6


@pytest.mark.parametrize("method", ["modal_implicit", "semi_implicit"])
@pytest.mark.parametrize("geared", [False, True])
def test_derivatives_of_steps_are_those_of_the_steps(method, geared):
    model, e = arm((GEAR if geared else {}) | {"friction": CURVE}), 1e-6
    q, v = np.array([0.2, 4.1])[: model.nq], np.array([0.3, 0.11][: model.nq]) if geared else np.array([0.11])
    stepper = JointStepper(model, method, model.parameter_values)
    after = lambda x: np.concatenate(stepper.step(JointState(*np.split(x, 2)), [0.7], np.zeros((6, 1)), 1e-3))  # noqa: E731
    x = np.append(q, v)
    columns = [
        (8 * (after(x + d) - after(x - d)) - (after(x + 2 * d) - after(x - 2 * d))) / (12 * e)
        for d in e * np.eye(len(x))
    ]
    found = step_map(model, method, q, v, 1e-3, [0.7])
    assert np.abs(found - np.array(columns).T).max() < 1e-6 * np.abs(found).max()


def test_every_number_is_a_parameter():
    """By name, unit and meaning; and what is computed changes with it as with another file."""
    model, other = arm({"friction": CURVE}), CURVE | {"bend": {"friction": 2.0, "velocity": 0.2}}
    of = {p.name.removeprefix("arm.joint.drives[0].friction."): p for p in parameters(model.robot)}
    units = {"stribeck.static": "N·m", "stribeck.velocity": "rad/s", "bend.friction": "N·m", "bend.velocity": "rad/s"}
    assert {name: of[name].unit for name in units} == units
    cylinder = {"transmission": {"crank": 0.3, "base": 0.6, "angle": 1.2}, "rotor_inertia": 2.0, "friction": CURVE}
    along = {p.name: p.unit for p in parameters(arm(cylinder).robot) if ".friction." in p.name}
    assert along == {of[name].name: unit.replace("rad", "m").replace("N·m", "N") for name, unit in units.items()} | {
        f"arm.joint.drives[0].friction.{name}": unit
        for name, unit in {"coulomb": "N", "viscous": "N·s/m", "velocity": "m/s"}.items()
    }
    changed = {of["bend.friction"].name: 2.0, of["bend.velocity"].name: 0.2}
    a = model.numpy(changed).forward_dynamics([0.0], [0.3], [0.0], None)[0]
    assert np.allclose(a, -curve(0.3, other) / INERTIA, rtol=1e-12)


@pytest.mark.parametrize(
    ("friction", "said"),
    [
        ({"viscous": 1.0, "stribeck": {"static": 2.0, "velocity": 0.1}}, "is stated without coulomb, to which"),
        ({"coulomb": 1.0, "stribeck": {"static": 2.0, "velocity": 0.1}}, "is missing; dry friction needs the rate"),
        ({"bend": {"friction": 2.0}}, "velocity"),
        ({"bend": {"friction": -2.0, "velocity": 0.1}}, "bend"),
        ({"bend": {"friction": 2.0, "velocity": 0.1}, "velocity": 0.2}, "is stated without coulomb, whose sign"),
    ],
)
def test_what_cannot_be_is_refused_in_a_line(friction, said):
    with pytest.raises(ValueError, match=said):
        arm({"friction": friction})


def test_what_has_no_place_for_it_says_so():
    """Equations in scalars have no exponentials, and a URDF has Coulomb's friction alone."""
    with pytest.raises(screwgen.UsageError, match=r"has no equations in scalars: its friction falls"):
        arm({"friction": CURVE}).equations()
    notes = export_urdf(arm({"friction": CURVE}).robot).notes
    assert [note.rpartition(".")[2] for note in notes if ".friction." in note] == [
        f"{name}: is left out" for name in ("velocity", "stribeck", "bend")
    ]
    assert any("friction.memory: is left out" in note for note in export_urdf(arm({"friction": STICKING}).robot).notes)


def test_the_bend_alone_is_friction():
    model = arm({"friction": {"bend": {"friction": 2.0, "velocity": 0.1}}})
    a = model.numpy().forward_dynamics([0.0], [0.3], [0.0], None)[0]
    assert np.allclose(a, -2.0 * 0.3 / np.hypot(0.3, 0.1) / INERTIA, rtol=1e-12)
