"""Elastic gears behind cylinders and four-bar linkages, against a Lagrangian with the rotor's angle."""

from functools import cache

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from bad_robot_files import GOOD, refused
from four_bar_robots import LINKAGE
from helpers import arm, link, model_of, relative

from screwgen import PD, Holding, SingularError, UsageError, equilibrium, natural_frequencies, simulate
from screwgen.backends.latex import document as latex
from screwgen.backends.numpy.travel_numbers import travels
from screwgen.plotting import plot
from screwgen.plugins import plugins
from screwgen.spec.inputs import input_units
from screwgen.spec.parameters import coordinate_units, parameters
from screwgen.studies.stiffness import stiffness_matrix

# -------- a Lagrangian whose coordinates are the joint's angle and the rotor's

CYLINDER = {"crank": 0.4, "base": 1.2, "angle": -1.5}
FRICTION = {"coulomb": 40.0, "viscous": 300.0, "velocity": 0.1}


def lift(k=None, damping=None, friction=None, modes=None, linkage=False, angle=-1.5, gravity=(0.3, 0.0, -9.81)) -> dict:
    """A boom on a cylinder or a linkage and a jib on a second cylinder with a rigid gear, both about y."""
    transmission = {"four_bar": LINKAGE} if linkage else CYLINDER | {"angle": angle}
    own = {"transmission": transmission, "ratio": 30.0, "rotor_inertia": 0.02}
    stated = {"stiffness": k, "damping": damping, "friction": friction}
    own |= {name: value for name, value in stated.items() if value is not None}
    other = {"transmission": {"crank": 1.8, "base": 1.2, "angle": 1.0}}
    boom = link("boom", 2.0, "y", 5.0, modes, joint={"drives": [own]}, section={"EIy": 3e4})
    jib = link("jib", 1.0, "y", 3.0, joint={"drives": [other]}, bodies=[{"at": "tip", "mass": 4.0}])
    return arm(boom, jib, gravity=gravity)


@cache
def lagrangian():
    """M and h of `lift` without modes, of angles, the rotor's angle over 30 and rates; also l, l', l''."""
    q, v, (k, d) = sp.symbols("q1:4"), sp.symbols("v1:4"), sp.symbols("k d")
    length = sp.sqrt(1.2**2 + 0.4**2 - 2 * 1.2 * 0.4 * sp.cos(q[0] - 1.5))
    rate = lambda f: sum(sp.diff(f, x) * y for x, y in zip(q, v, strict=True))  # noqa: E731
    along = lambda a, s: sp.Matrix([s * sp.cos(a), -s * sp.sin(a)])  # noqa: E731
    sums = (q[0], q[0] + q[1])
    places = (along(sums[0], 1.0), along(sums[0], 2.0) + along(sums[1], 0.5), along(sums[0], 2.0) + along(sums[1], 1.0))
    kinetic, potential = sp.Float("0.02") * 900 * v[2] ** 2 / 2, k * (q[2] - length) ** 2 / 2
    for mass, place in zip((10.0, 3.0, 4.0), places, strict=True):
        kinetic += mass * sum(rate(x) ** 2 for x in place) / 2
        potential -= mass * (0.3 * place[0] - 9.81 * place[1])
    kinetic += 10.0 * 4.0 / 12 * v[0] ** 2 / 2 + 3.0 / 12 * (v[0] + v[1]) ** 2 / 2
    stretch = v[2] - rate(length)
    lost = [-d * stretch * sp.diff(length, q[0]), 0, d * stretch + (300.0 + 40.0 / sp.sqrt(v[2] ** 2 + 0.01)) * v[2]]
    h = [
        rate(sp.diff(kinetic, w)) - sp.diff(kinetic - potential, x) + loss
        for x, w, loss in zip(q, v, lost, strict=True)
    ]
    slopes = [length, sp.diff(length, q[0]), sp.diff(length, q[0], 2)]
    return sp.lambdify((*q, *v, k, d), (sp.hessian(kinetic, v), h, slopes), "numpy")


@pytest.mark.parametrize("seed", range(4))
def test_accelerations_equal_those_of_a_lagrangian_with_the_rotors_angle(seed):
    rng = np.random.default_rng(seed)
    k, d = 10 ** rng.uniform(4, 7), rng.uniform(10, 1000)
    model = model_of(lift(k=float(k), damping=float(d), friction=FRICTION))
    q, v, force = rng.uniform(-np.pi, np.pi, 2), rng.normal(size=2), rng.normal() * 300
    e, edot = rng.normal() * 1e-2, rng.normal() * 0.1
    l, slope, curve = lagrangian()(*q, 0, *v, 0, k, d)[2]
    s, sdot = l + e, slope * v[0] + edot
    M, h, _ = lagrangian()(*q, s, *v, sdot, k, d)
    push = rng.normal() * 200
    lever = model.numpy().levers([*q, e])[1]
    a = np.linalg.solve(np.array(M, float), np.array([0.0, lever * push, force]) - np.array(h, float).ravel())
    expected = [a[0], a[1], a[2] - slope * a[0] - curve * v[0] ** 2]
    for forward in (model.numpy().forward_dynamics, model.numpy().dae_forward_dynamics):
        assert relative(forward([*q, e], [*v, edot], [force, push], None)[0], expected) < 1e-9


# -------- runs

START, PUSH = np.array([0.2, 0.4]), {False: np.array([900.0, -300.0]), True: np.array([60.0, -300.0])}


@pytest.mark.parametrize("linkage", [False, True])
def test_stiff_gears_tend_to_the_rigid_one_as_1_over_k(linkage):
    given = dict(controller=PUSH[linkage], q0=START, backend="casadi")
    rigid = simulate(model_of(lift(linkage=linkage)), 0.02, 1e-3, integrator="rk4", **given).q[-1]
    errors = []
    for k in (1e6, 1e7, 1e8):
        model = model_of(lift(k=k, damping=2e-3 * k, linkage=linkage))
        run = simulate(model, 0.02, 1e-4, integrator="modal_midpoint", **given)
        errors.append(np.abs(run.q[-1, :2] - rigid).max())
    assert errors[0] < 2e-3 and errors[0] / errors[1] == pytest.approx(10, rel=0.5)
    assert errors[1] / errors[2] == pytest.approx(10, rel=0.5)


def test_a_gear_of_1_khz_bears_steps_of_1_ms_and_keeps_the_energy():
    model = model_of(lift(k=1e9))
    assert natural_frequencies(model, START, joints="free")[-1] > 1000
    run = simulate(model, 0.2, 1e-3, q0=START, integrator="modal_midpoint", backend="casadi")
    assert np.ptp(run.energy.sum(axis=1)) < 1e-5 * np.ptp(run.energy[:, 0])
    fine = simulate(model_of(lift(k=1e5)), 0.05, 1e-4, q0=START, integrator="rk4", backend="casadi")
    assert np.ptp(fine.energy.sum(axis=1)) < 1e-9 * np.ptp(fine.energy[:, 0])


def test_a_law_measures_the_rotor_and_reaches_its_goal():
    model = model_of(lift(k=2e5))
    law = PD(kp=(4e3, 1e3), kd=(1200.0, 300.0), q_des=(0.3, 0.3), duration=0.5, gravity=Holding(model))
    run = simulate(model, 1.0, 4e-3, q0=equilibrium(model, START, hold=True).q, controller=law, backend="casadi")
    assert np.abs(run.v[-1]).max() < 0.1 and np.abs(run.q[-1, :2] - 0.3).max() < 0.05


# -------- rest, vibrations, dead centres


@pytest.mark.parametrize("linkage", [False, True])
def test_rest_winds_the_gears_and_locked_drives_leave_joints_on_them(linkage):
    k = 3e3 if linkage else 2e5
    model = model_of(lift(k=k, linkage=linkage, modes={"bending_z": 1}))
    held = equilibrium(model, START, hold=True)
    assert held.q[2] == pytest.approx(held.tau[0] / k, rel=1e-12) and held.stability == "stable"
    assert np.abs(model.numpy().forward_dynamics(held.q, np.zeros(4), held.tau, None)[0]).max() < 1e-10
    found = equilibrium(model, held.q[:2] + 0.01, tau=held.tau)
    assert np.abs(model.numpy().forward_dynamics(found.q, np.zeros(4), held.tau, None)[0]).max() < 1e-9
    q = np.array([*START, 0.0, 0.0])
    rows = np.array([[travels(model.chain, START, model.parameter_values)[1][0], 0, 1, 0], [0, 1, 0, 0]])
    free = scipy.linalg.null_space(rows)
    M, K = (free.T @ x @ free for x in (model.numpy().mass_matrix(q), stiffness_matrix(model)))
    expected = np.sqrt(scipy.linalg.eigvalsh(K, M)) / (2 * np.pi)
    assert np.allclose(natural_frequencies(model, q), expected, rtol=1e-10)
    assert np.allclose(natural_frequencies(model, q, loaded=True), expected, rtol=0.02)


def test_a_cylinder_passes_its_dead_centre_and_needs_an_infinite_force_there():
    model = model_of(lift(k=2e5, damping=1000.0))
    assert model.numpy().levers([1.5, 0.0, 0.0])[0] == 0.0
    run = simulate(model, 0.1, 1e-3, q0=[1.4, 0.4], v0=[2.0, 0.0], controller=np.array([500.0, 0.0]), backend="casadi")
    assert run.q[-1, 0] > 1.55 and np.ptp(run.q[:, 2]) < 0.01
    with pytest.raises(SingularError, match=r"boom.joint\[0\]: its cylinder is in a dead centre, where no force turns"):
        equilibrium(model, [1.5, 0.4], hold=True)


def test_an_elastic_gear_does_not_carry_a_linkage_through_the_end_of_its_reach():
    model = model_of(lift(k=3e3, linkage=True))
    end = model.chain.reach[0, 0]
    for q in (end - 1e-3, end + 1e-5):
        with pytest.raises(SingularError, match=r"where crank and coupler are in line, with an elastic gear 0\.05"):
            model.numpy().forward_dynamics([q, 0.0, 0.0], np.zeros(3), np.zeros(2), None)
    for k, step in ((3e3, 2e-4), (1e6, 1e-3)):
        model = model_of(lift(k=k, linkage=True))
        with pytest.raises(SingularError, match=r"t = 0\.\d+ s: the joint of link 'boom' is singular in this posture"):
            simulate(model, 0.1, step, q0=[end + 0.02, 0.0], v0=[-2.0, 0.0], backend="casadi")


# -------- what users see


def test_names_units_and_parameters():
    cylinder, linkage = model_of(lift(k=2e5)), model_of(lift(k=3e3, linkage=True))
    assert cylinder.q_names[2] == "boom.stretch[0]" and cylinder.v_names[2] == "boom.stretch_rate[0]"
    assert linkage.q_names[2] == "boom.gear[0]" and input_units(linkage.robot) == ["N·m", "N"]
    assert coordinate_units(cylinder.robot)[2] == "m" and coordinate_units(linkage.robot)[2] == "rad"
    units = [
        {x.name: x.unit for x in parameters(m.robot)}["boom.joint.drives[0].stiffness"] for m in (cylinder, linkage)
    ]
    assert units == ["N/m", "N·m/rad"] and input_units(cylinder.robot) == ["N", "N"]


@pytest.mark.parametrize("kind", ["crank = 0.3, base = 0.8, angle = 1.0", "four_bar"])
def test_a_gear_without_a_rotor_is_refused(tmp_path, kind):
    given = ", ".join(f"{k} = {x!r}".replace("'", '"') for k, x in LINKAGE.items())
    table = f"transmission = {{ {f'four_bar = {{ {given} }}' if kind == 'four_bar' else kind} }}, stiffness = 1e6"
    text = GOOD.replace("armature = [0.1, 0.2]", f"drives = [ {{ {table} }}, {{}} ]")
    refused(tmp_path, text, "links[0].joint.drives[0].rotor_inertia", "the rotor of an elastic drive needs its inertia")


def test_the_dae_as_differential_equations_is_refused_in_one_line():
    model = model_of(lift(k=2e5))
    with pytest.raises(UsageError, match="has an elastic gear behind a transmission, for which the DAE has no"):
        model.casadi()["dae"]


def test_figures_and_documents_show_the_stretch():
    model = model_of(lift(k=2e5))
    run = simulate(model, 0.002, 1e-3, q0=START, backend="casadi")
    shown = {panel.title: panel.unit for panel in plot.panels(run, None, model) if panel.lines}
    assert shown["Rotors ahead of their cylinders"] == "m"
    text = latex.tex(latex.content(model.robot, plugins()))
    assert r"F_g" in text and "ahead of the travel" in text
