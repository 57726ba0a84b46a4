"""Cylinders that drive joints, against the oracle, a Lagrangian by hand and the true loop; what users see of them."""

from functools import cache

import numpy as np
import pytest
from bad_robot_files import GOOD, refusal, refused
from helpers import arm, example, link, model_of, relative
from transmitted import (
    GAINS,
    gains_through_levers,
    held_posture,
    postures_under,
    power,
)

from screwgen import PD, Holding, SingularError, equilibrium, natural_frequencies, simulate
from screwgen.backends.c.project import CProject
from screwgen.backends.latex import document as latex
from screwgen.backends.numpy.travel_numbers import efforts, travels
from screwgen.plotting import plot
from screwgen.plugins import plugins
from screwgen.simulation.controller_files import read_pd
from screwgen.spec.inputs import input_units
from screwgen.spec.parameters import coordinate_units, parameters

# -------- a Lagrangian by hand

FRICTION = {"coulomb": 40.0, "viscous": 300.0, "velocity": 0.1}


def lift(crank=0.4, base=1.2, angle=-1.5, friction=FRICTION, modes=None, gravity=(0.3, 0.0, -9.81)) -> dict:
    """A boom on a cylinder, and a jib on a second one without mass and friction, both about y."""
    own = {"transmission": {"crank": crank, "base": base, "angle": angle}, "ratio": 30.0, "rotor_inertia": 0.02}
    other = {"transmission": {"crank": 1.5 * base, "base": base, "angle": 1.0}}
    first = own | ({"friction": friction} if friction else {})
    boom = link("boom", 2.0, "y", 5.0, modes, joint={"drives": [first]}, section={"EIy": 3e4})
    jib = link("jib", 1.0, "y", 3.0, joint={"drives": [other]}, bodies=[{"at": "tip", "mass": 4.0}])
    return arm(boom, jib, gravity=gravity)


# -------- runs, equilibria, linear models


@cache
def boom():
    return model_of(lift(modes={"bending_z": 1}))


START = np.array([0.2, 0.4, 0.0])


def test_the_power_of_a_cylinder_is_its_force_times_the_rate_of_its_length():
    model = model_of(lift(friction=None))
    power(model, START[:2], lambda t, q, v: (900 + 400 * np.sin(9 * t), -300.0))


def test_an_equilibrium_states_the_forces_of_cylinders_and_finds_postures_under_them():
    assert np.abs(held_posture(boom(), START[:2])).min() > 20
    alone = model_of({**lift(), "links": lift()["links"][:1]})
    force = postures_under(alone, 0.3, (0.29, 0.5))
    slope = [alone.numpy().forward_dynamics([0.3 + d], [0], force, None)[0][0] for d in (-1e-5, 1e-5)]
    assert (equilibrium(alone, [0.3], tau=force).stability == "stable") == (slope[1] < slope[0])


def test_a_dead_centre_needs_an_infinite_force_and_says_so():
    alone = model_of({**lift(), "links": lift()["links"][:1]})
    with pytest.raises(SingularError, match=r"^boom\.joint\[0\]: its cylinder is in a dead centre"):
        equilibrium(alone, [1.5], hold=True)
    assert np.isfinite(alone.numpy().forward_dynamics([1.5], [0.3], [1e4], None)[0]).all()
    assert efforts(alone.chain, np.zeros(1), [1.5], alone.parameter_values)[0] == 0
    for ask in (
        lambda p: travels(alone.chain, [1.5], p),
        lambda p: alone.numpy(p).forward_dynamics([1.5], [0], [1], None),
    ):
        with pytest.raises(SingularError, match="the joint of link 'boom' is singular in this posture"):
            ask(np.where(np.array(alone.parameter_values) == 0.4, 1.2, alone.parameter_values))


def test_free_joints_vibrate_on_the_forces_that_hold_them():
    """A force that stays the same while its lever grows or falls is a spring of the joint."""
    robot = lift(friction=None, modes={"bending_z": 1})
    model = model_of(robot | {"links": robot["links"][:1]})
    held = equilibrium(model, [-0.3], hold=True)
    poles = model.linearise(held.q, tau=held.tau).eigenvalues()
    found = natural_frequencies(model, [-0.3], joints="free", loaded=True)
    assert np.allclose(found, np.sort(poles.imag[poles.imag > 0]) / (2 * np.pi), rtol=1e-7)
    assert found[0] > 0.02 and natural_frequencies(model, [-0.3], joints="free")[0] == 0


def test_a_law_gives_cylinders_the_forces_of_its_torques():
    model = boom()
    law = PD(*GAINS, START[:2] + 0.2, gravity=Holding(model), tau_max=(900.0, 1e4), duration=0.3)
    ready = law.through(model.chain, model.parameter_values).starting_at(START)
    assert not ready.plain and np.allclose(ready.bounds, (900.0, 1e4))
    gains_through_levers(model, START)
    run = simulate(model, 0.6, 2e-3, q0=START, controller=law, integrator="modal_midpoint")
    assert np.abs(run.tau[:, 0]).max() == 900.0 and np.abs(run.q[-1, :2] - START[:2] - 0.2).max() < 0.3
    titles = [axes.get_title(loc="left") for axes in plot.figure(run, model, law).axes]
    assert "Forces of drives" in titles and "Joint torques" not in titles


# -------- the crane of the examples and its true loop


def test_the_crane_equals_its_true_loop_where_barrel_and_rod_have_no_mass():
    """The difference falls in proportion to the masses; what is left is extrapolated to none."""
    crane, loop = example("crane"), example("crane_loop")
    rng = np.random.default_rng(3)
    q, v = np.zeros(crane.nq), rng.normal(size=crane.nq) * 0.3
    q[:3], q[3:], v[3:] = (0.4, 0.6, 0.7), rng.normal(size=crane.nq - 3) * 1e-3, v[3:] * 0.02
    tau = np.array([800.0, 2.4e4, 9e3])
    eye, turned = 0.9 * np.array([np.cos(q[1]), np.sin(q[1])]), 0.9 * np.array([-np.sin(q[1]), np.cos(q[1])]) * v[1]
    way = eye - (0.35, -1.2)
    length = np.hypot(*way)
    across = np.array([-way[1], way[0]]) / length
    own_q, own_v = [np.arctan2(way[1], way[0]), length - 1.3], [across @ turned / length, way @ turned / length]
    closed = np.r_[q[:3], own_q, q[3:]], np.r_[v[:3], own_v, v[3:]], (tau[0], 0.0, tau[2], 0.0, tau[1])
    expected = crane.numpy().forward_dynamics(q, v, tau, None)[0]
    masses = [loop.parameter_names.index(f"{name}.rhoA") for name in ("barrel", "rod")]

    def found(share: float) -> np.ndarray:
        p = np.array(loop.parameter_values)
        p[masses] *= share
        return np.delete(loop.numpy(p).forward_dynamics(*closed, None)[0], [3, 4])

    coarse, fine = found(1e-4), found(1e-5)
    errors = [relative(x, expected) for x in (coarse, fine, (10 * fine - coarse) / 9)]
    assert errors[0] / errors[1] == pytest.approx(10, rel=1e-3) and errors[0] < 1e-4 and errors[2] < 1e-9


@pytest.mark.long
def test_the_crane_of_the_examples_follows_its_law():
    model = example("crane")
    law = read_pd("examples/crane_law.toml", model)
    run = simulate(model, 9.5, 2e-3, controller=law, integrator="modal_midpoint")
    assert np.abs(run.q[-1, :3] - law.q_des).max() < 0.1


# -------- what users see

TABLE = "transmission = { crank = 0.3, base = 0.8, angle = 1.0 }"
UPPER = "links[0].joint.drives"
KEY = f"{UPPER}[0].transmission"
WRONG = [
    ("transmission = {}", f"{KEY}.crank", "is missing"),
    ("transmission = { crank = 0.3, angle = 1.0 }", f"{KEY}.base", "is missing"),
    ("transmission = { crank = 0.3, base = 0.8 }", f"{KEY}.angle", "is missing"),
    ("transmission = { crank = 0.0, base = 0.8, angle = 1.0 }", f"{KEY}.crank", "is 0.0; it must be > 0"),
    ("transmission = { crank = 0.3, base = -0.8, angle = 1.0 }", f"{KEY}.base", "is -0.8; it must be > 0"),
    ("transmission = { crank = 0.3, base = 1e9, angle = 1.0 }", f"{KEY}.base", "it must be from 1e-06 to 1e+06 m"),
    ("transmission = { crank = 0.8, base = 0.8, angle = 1.0 }", f"{KEY}.crank", "as long as base, so that the"),
    ("transmission = { crank = 0.3, base = 0.8, angle = nan }", f"{KEY}.angle", "is nan"),
    ('transmission = { crank = 0.3, base = 0.8, angle = "x" }', f"{KEY}.angle", 'is "x"'),
    ("transmission = { crank = 0.3, base = 0.8, angel = 1.0 }", f"{KEY}.angel", "did you mean angle?"),
    ('transmission = "cylinder"', KEY, "must be a table of crank, base, angle"),
    (f"{TABLE}, rotor_inertia = 1.0, stiffness = -1e6", f"{UPPER}[0].stiffness", "is -1000000.0; it must be > 0"),
    (f"{TABLE}, rotor_inertia = 1.0, damping = 9.0", f"{UPPER}[0].damping", "is stated without stiffness"),
    (f"{TABLE}, ratio = 3.0", f"{UPPER}[0].ratio", "is stated without rotor_inertia"),
]


@pytest.mark.parametrize(("table", "where", "fragment"), WRONG)
def test_wrong_transmissions_are_refused_in_one_line(tmp_path, table, where, fragment):
    refused(tmp_path, GOOD.replace("armature = [0.1, 0.2]", f"drives = [ {{ {table} }}, {{}} ]"), where, fragment)


@pytest.mark.parametrize("axis", ['{ slide = "y" }', '{ screw = "y", pitch = 0.1 }'])
def test_cylinders_of_axes_that_slide_are_refused(tmp_path, axis):
    path = tmp_path / "bot.toml"
    path.write_text(GOOD.replace('axes = ["z"] }', f"axes = [{axis}], drives = {{ {TABLE} }} }}"), "utf-8")
    assert refusal(path).startswith(
        "links[1].joint.drives[0].transmission (link fore): is stated of an axis along which the link"
    )


def test_names_units_and_parameters():
    model = boom()
    assert model.tau_names == ["boom.force[0]", "jib.force[0]"] and input_units(model.robot) == ["N", "N"]
    assert model.q_names[0] == "boom.joint[0]" and coordinate_units(model.robot)[:2] == ["rad", "rad"]
    of = {x.name: x for x in parameters(model.robot)}
    assert of["boom.joint.drives[0].transmission.crank"].unit == "m"
    assert (
        of["boom.joint.drives[0].ratio"].unit == "rad/m" and of["boom.joint.drives[0].friction.viscous"].unit == "N·s/m"
    )
    moved = {"boom.joint.drives[0].transmission.angle": -1.0}
    other = model_of(lift(angle=-1.0, modes={"bending_z": 1}))
    given = START, START, [500.0, 20.0], None
    assert np.allclose(model.numpy(moved).forward_dynamics(*given)[0], other.numpy().forward_dynamics(*given)[0])
    linear = model.linearise(START)
    assert linear.input_names[:2] == ("boom.force[0]", "jib.force[0]") and linear.input_units[:2] == ("N", "N")


def test_documents_and_headers_say_what_a_force_does():
    text = latex.tex(latex.content(boom().robot, plugins()))
    assert r"J_r\,N^2\,l'\,l''\,\dot{q}^2" in text and "force of the cylinder, positive where it extends it" in text
    header = CProject(boom().chain, "1").files()["arm.h"]
    assert "N where a cylinder drives it" in header and "void arm_levers(" in header
