"""Plans of arms whose joints cylinders and four-bar linkages move: judged by power, by statics, by runs of the arm."""

import ctypes
from dataclasses import replace

import numpy as np
import pytest
from clocked_c import ClockedLaw
from helpers import G, arm, link, model_of
from scipy.optimize import brentq
from test_plan_c import OK, Played
from test_tracking import eased

import screwgen
from screwgen import UsageError
from screwgen.planning.members import Still

LENGTH, LOAD, PISTON = 2.4, 150.0, 80.0
CRANK, BASE, ANGLE = 0.5, 1.1, 1.4
CYLINDER = {"transmission": {"crank": CRANK, "base": BASE, "angle": ANGLE}, "rotor_inertia": PISTON}
LENGTHS = {"ground": 0.45, "crank": 0.32, "coupler": 0.46, "rocker": 0.3, "angle": 1.2, "branch": "open"}
LINKAGE = {"transmission": {"four_bar": LENGTHS}, "rotor_inertia": 2e-3, "ratio": 120.0}
OIL = {"stiffness": 4e6, "damping": 2e3}
BELT = {"stiffness": 2e5, "damping": 1e2}
LAW = screwgen.PD((6e4,), (8e3,), (0.0,))
BOX = {"box": {"breadth": 0.12, "height": 0.2, "wall": 0.006}, "E": 2.1e11, "density": 7850.0, "nu": 0.3}
DRIVES = {
    "cylinder": CYLINDER,
    "four-bar": LINKAGE,
    "elastic cylinder": CYLINDER | OIL,
    "elastic four-bar": LINKAGE | BELT,
}


def lifted(drive, effort=None, rigid=False):
    """A stick with a load, which a drive lifts."""
    limits = {} if effort is None else {"limits": [{"effort": effort}]}
    joint = {"axes": [[0.0, -1.0, 0.0]], "drives": [drive], **limits}
    body = {"at": "tip", "mass": LOAD}
    if rigid:
        return model_of(arm(link("stick", length=LENGTH, rhoA=1e-6, bodies=[body], joint=joint), gravity=[0, 0, -G]))
    bent = {"length": LENGTH, "profile": BOX, "modes": {"bending_z": 2}, "damping": {"ratio": 0.01}}
    row = {"name": "stick", **bent, "joint": joint, "bodies": [body]}
    return model_of(arm(row, order=2, gravity=[0.0, 0.0, -G]))


def length(q):
    """Of the cylinder, by the law of cosines."""
    return np.sqrt(BASE**2 + CRANK**2 - 2 * BASE * CRANK * np.cos(q + ANGLE))


@pytest.mark.parametrize("kind", DRIVES)
def test_an_arm_on_a_lever_arrives_with_the_efforts_that_are_planned(kind):
    """What the plan says of drives is what they give in a run; links are at rest behind it."""
    model = lifted(DRIVES[kind])
    plan = screwgen.plan(model, [-0.4], [0.5], 1.5, gains=LAW, fast=True)
    arrived = screwgen.play(model, plan)
    assert arrived.residual < 1e-4 and np.abs(arrived.joints).max() < 1e-4
    assert arrived.effort == pytest.approx(plan.effort, rel=2e-3)


def test_the_force_of_a_cylinder_is_that_of_newtons_law():
    """Of a rigid stick: the weight and inertia of the load over the lever, and the piston that moves along."""
    plan = screwgen.plan(lifted(CYLINDER, rigid=True), [-0.4], [0.5], 1.5, gains=LAW, fast=True)
    q, v, a, h = plan.q[:, 0], plan.v[:, 0], plan.vdot[:, 0], 1e-4
    bend = (length(q + h) - 2 * length(q) + length(q - h)) / h**2
    torque = LOAD * LENGTH**2 * a + LOAD * G * LENGTH * np.cos(q)
    force = torque / lever(q) + PISTON * (lever(q) * a + bend * v**2)
    assert np.abs(plan.tau[:, 0] - force).max() < 1e-6 * plan.effort[0]


def test_a_limit_of_a_cylinder_holds_for_its_force_between_points_too():
    """The shortest lift: in the run its force goes up to the limit of the file and not beyond."""
    most = 16e3
    model = lifted(CYLINDER, effort=most)
    plan = screwgen.plan(model, [-0.4], [0.5], "shortest", gains=LAW)
    arrived = screwgen.play(model, plan, step=5e-4)
    assert plan.tau_max[0] == most and arrived.saturated == 0
    assert 0.9 * most < arrived.effort[0] < most
    with pytest.raises(UsageError, match=r"the limits of efforts forbid it"):
        screwgen.plan(model, [-0.4], [0.5], 0.7 * plan.time, gains=LAW)


def test_other_loads_come_to_rest_behind_a_lever():
    """The law's torque goes through the lever of each arm's own posture: efforts stay, and loads sag."""
    model, left = lifted(CYLINDER), []
    for models in ((), [{"*.bodies[0].mass": 0.8}, {"*.bodies[0].mass": 1.2}]):
        plan = screwgen.plan(model, [-0.4], [0.5], 1.5, gains=LAW, models=models, fast=True)
        runs = [screwgen.play(model, plan, parameters={"stick.bodies[0].mass": x * LOAD}) for x in (0.8, 1.2)]
        left.append(max(x.residual for x in runs))
    assert left[1] < 0.5 * left[0]


def test_an_elastic_cylinder_begins_with_the_stretch_of_its_oil():
    """The piston is where a rigid one has the joint; the joint sags until the oil bears the load."""
    model = lifted(CYLINDER | OIL, rigid=True)
    plan = screwgen.plan(model, [-0.4], [0.5], 1.5, gains=LAW, fast=True)
    joint, stretch = screwgen.play(model, plan).run.q[0]
    held = lambda q: LOAD * G * LENGTH * np.cos(q) / lever(q)  # noqa: E731
    sagged = brentq(lambda q: OIL["stiffness"] * (length(-0.4) - length(q)) - held(q), -0.6, -0.3)
    assert joint == pytest.approx(sagged, rel=1e-6) and stretch == pytest.approx(length(-0.4) - length(joint), rel=1e-9)
    assert plan.tau[0, 0] == pytest.approx(held(joint), rel=1e-5)


def test_a_law_measures_the_coordinate_whose_rate_it_measures():
    """Behind an elastic gear: along a run the rates that a law sees are the slopes of the coordinates that it sees."""
    model, h = lifted(CYLINDER | {"stiffness": 2e5, "damping": 1e2}, rigid=True), 1e-6
    law = LAW.through(model.chain, model.parameter_values)
    q, v = np.array([0.3, -0.05]), np.array([0.8, 0.4])
    there, rate = law.seen(q, v)
    assert length(there[0]) == pytest.approx(length(0.3) - 0.05, rel=1e-12)
    before, after = (law.seen(q + x * v, v)[0][0] for x in (-h, h))
    assert rate[0] == pytest.approx((after - before) / (2 * h), rel=1e-8)


def test_c_of_a_plan_gives_what_python_gives(tmp_path):
    """Its efforts are the forces of the cylinder."""
    plan = replace(screwgen.plan(lifted(CYLINDER), [-0.4], [0.5], 1.5, gains=LAW, fast=True), robot="boom")
    c, wanted = Played(plan, tmp_path), plan.sampled(1e-3)
    assert c.start(0.0) == OK and plan.effort[0] > 1e4
    for t, *row in zip(*wanted, strict=True):
        for found, value in zip(c.values(t), row, strict=True):
            assert np.abs(found - value).max() < 1e-12 * max(1.0, np.abs(value).max())


def test_a_dead_centre_is_one_line():
    with pytest.raises(UsageError, match="its cylinder is in a dead centre, where no force turns the joint"):
        screwgen.plan(lifted(CYLINDER), [-ANGLE], [0.5], 1.5, gains=LAW, fast=True)


def lever(q):
    """The slope of the length."""
    return BASE * CRANK * np.sin(q + ANGLE) / length(q)


@pytest.mark.parametrize("kind", ["cylinder", "elastic four-bar"])
def test_gains_and_shapers_behind_a_lever_know_how_it_changes(kind):
    """Poles of the loop are those of the exact slopes of accelerations under the forces that hold the arm."""
    model, at = lifted(DRIVES[kind]), -0.3
    still = Still(model, np.array(model.parameter_values))
    rest, n = still.held(np.array([at])), model.nq
    q = still.drives.to_robot(rest.q)
    linear = model.linearise(q, tau=rest.effort / still.drives.effort_ratios)
    shaped = screwgen.shape(model, [at], [at], gains=LAW, modes=2)
    controller = replace(LAW, q_des=(at,)).through(model.chain, model.parameter_values)
    x, h = np.append(q, 0.0 * q), 1e-6 * np.eye(2 * n)
    slopes = [(controller(0.0, *np.split(x + e, [n])) - controller(0.0, *np.split(x - e, [n]))) / 2e-6 for e in h]
    poles = np.linalg.eigvals(linear.A + linear.B[:, :1] @ np.transpose(slopes))
    found, damping = (x.ravel() for x in shaped.vibrations([]))
    wanted = 2 * np.pi * found * (-damping + 1j * np.sqrt(1 - damping**2))
    assert np.abs(wanted[:, None] - poles).min(axis=1) == pytest.approx([0.0, 0.0], abs=1e-5 * np.abs(wanted).max())
    assert "closed loop" in shaped.vibrates and (np.diff(found) > 0).all()


def test_forces_after_a_jump_are_those_of_a_run():
    """Of the cylinder, in the posture where its lever is shortest; gains that would take more are not found."""
    model, jump, most = lifted(CYLINDER), 0.01, 1.25e4
    bounds = {"jump": [jump], "efforts": [most]}
    found = screwgen.gains(model, [[-0.4], [0.5]], bounds=bounds)
    assert found.jump_efforts[0] <= most * (1 + 1e-4) and found.decay > 3
    reached = []
    for at in (-0.4, 0.5):
        still = Still(model, np.array(model.parameter_values))
        rest = still.held(np.array([at]))

        def law(t, q, v, at=at, held=rest.effort[0]):
            return held + (found.kp * (at + jump - q[:1]) - found.kd * v[:1]) / lever(q[0])

        run = screwgen.simulate(model, 1.5, found.step, rest.q, controller=law)
        reached.append(np.abs(run.tau).max())
    assert max(reached) == pytest.approx(found.jump_efforts[0], rel=0.01)


@pytest.mark.parametrize("integral", [False, True])
def test_c_of_gains_takes_the_lever(tmp_path, integral):
    """It gives the forces of the controller, also at the limit and where pushing turns the joint back."""
    found = screwgen.gains(lifted(CYLINDER, effort=16e3), [[0.0]], integral=integral)
    more = {"ki": found.ki} if integral else {}
    goal = {"q_des": (0.6,), "duration": 0.8, "tau_max": tuple(found.tau_max), "q_start": (-0.4,)}
    law = (screwgen.PID if integral else screwgen.PD)(found.kp, found.kd, **more, **goal)
    model, state = lifted(CYLINDER, effort=16e3), {"z": 1} if integral else {}
    law = law.through(model.chain, model.parameter_values)
    given = dict.fromkeys(("measured", "rate", "q", "v", "tau", "lever"), 1)
    c = ClockedLaw(replace(found, robot="boom").c(), tmp_path, "law", state, given)
    assert c.library.boom_law_start(ctypes.byref(c.state)) == OK
    rng, clipped = np.random.default_rng(4), 0
    for k in range(1000):
        t, y = k * found.step, float(rng.choice([-1.0, 1.0]) * 0.2 - ANGLE + rng.choice([0.9, -0.9]))
        w = float(rng.normal())
        wanted = law(t, np.array([y, 0.0, 0.0]), np.array([w, 0.0, 0.0]))
        c.put(y, w, *law.reference(t), 0.0, float(lever(y)))
        assert c.sample_put(t) == OK and c.effort[0] == pytest.approx(wanted[0], abs=1e-9 * 16e3)
        clipped += abs(c.effort[0]) == 16e3
    assert 10 < clipped < 1000
    c.put(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert c.sample_put(1000 * found.step) == 2, "no lever is no number"


def test_gains_in_a_dead_centre_are_refused():
    with pytest.raises(UsageError, match="its cylinder is in a dead centre, where no force turns the joint"):
        screwgen.gains(lifted(CYLINDER), [[-ANGLE]])


def test_a_tip_is_on_its_path_by_the_force_of_a_cylinder():
    """Played, it is off by a small share of its way; the posture of the start is found by its place."""
    model, time = lifted(CYLINDER), 1.5
    angle = lambda t: -0.4 + 0.9 * eased(t / time)  # noqa: E731
    path = lambda t: LENGTH * np.stack([np.cos(angle(t)), 0 * t, np.sin(angle(t))], axis=-1)  # noqa: E731
    plan = screwgen.track(model, path, time, step=2e-3, gains=LAW)
    run = screwgen.play(model, plan).run
    goal = path(np.clip(run.t - plan.said["preview"], 0.0, time))
    across = np.stack([-goal[:, 2], goal[:, 0]], axis=1) / LENGTH
    assert np.abs(((run.tip_position - goal)[:, [0, 2]] * across).sum(axis=1)).max() < 1e-4
    assert screwgen.inverse_kinematics(model, run.tip_position[0]) == pytest.approx(plan.q[0], abs=1e-4)
