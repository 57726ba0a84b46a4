"""Plans of arms with elastic drives: judged by bang-bang's closed form, by statics, by the arm beside least jerk."""

from dataclasses import replace

import numpy as np
import pytest
from helpers import G, arm, example, link, model_of
from scipy.linalg import expm
from scipy.optimize import brentq
from test_lqg import Compiled
from test_planning import bang_bang

import screwgen
from screwgen import UsageError
from screwgen.simulation.controllers import Holding

RATIO, ROTOR, STIFFNESS, LOAD, LENGTH, DENSITY = 50.0, 2e-4, 900.0, 2.0, 0.8, 1e-6
LAW = screwgen.PD((60.0,), (12.0,), (0.0,))
FRICTION = {"coulomb": 0.02, "viscous": 1e-4, "velocity": 0.5}


def geared(gravity=0.0, effort=None, **drive):
    """A light rigid link with a load that a motor turns through a gear that twists."""
    own = {"ratio": RATIO, "rotor_inertia": ROTOR, "stiffness": STIFFNESS, **drive}
    own = {key: x for key, x in own.items() if x is not None}
    limits = {} if effort is None else {"limits": {"effort": effort}}
    body = {"at": "tip", "mass": LOAD}
    row = link("rod", length=LENGTH, rhoA=DENSITY, bodies=[body], joint={"drives": own, **limits})
    return model_of(arm(row, gravity=[0.0, -gravity, 0.0]))


def test_the_shortest_time_of_an_elastic_drive_is_that_of_bang_bang():
    """A rotor, a spring and a load; the limit of the file is that of the motor, before the gear."""
    motor, load, way, effort = RATIO**2 * ROTOR, LOAD * LENGTH**2, 1.0, 15.0
    free = np.sqrt(STIFFNESS * (1 / motor + 1 / load)) / (2 * np.pi)
    plan = screwgen.plan(geared(effort=effort / RATIO / 0.97), [0.0], [way], "shortest", intervals=140)
    best = bang_bang(way, effort, motor + load, free)
    assert best * 0.998 <= plan.time <= 1.015 * best
    assert plan.tau_max[0] == pytest.approx(effort / 0.97) and plan.effort[0] <= effort * (1 + 1e-6)


@pytest.mark.parametrize("fast", [False, True])
def test_a_plan_begins_with_the_twist_of_its_gear_and_ends_at_rest(fast):
    """The load hangs on the gear: the joint is behind the rotor over the ratio by torque over stiffness."""
    model = geared(gravity=G)
    plan = screwgen.plan(model, [0.0], [1.0], 1.0, gains=LAW, fast=fast, intervals=48)
    arrived = screwgen.play(model, plan, step=5e-4)
    joint, rotor = arrived.run.q[0]
    held = LOAD * G * LENGTH * np.cos(joint)
    assert rotor == pytest.approx(0.0, abs=1e-10) and joint == pytest.approx(-held / STIFFNESS, rel=1e-6)
    assert plan.tau[0, 0] == pytest.approx(held, rel=1e-6)
    assert arrived.run.tau[0, 0] * RATIO == pytest.approx(plan.sampled(5e-4).tau[0, 0], rel=1e-6)
    jerk = least_jerk(model, plan, 5e-4)
    assert arrived.residual < 2e-3 * jerk and arrived.residual < 2e-5


def least_jerk(model, plan, step):
    """The residual of a path of least jerk under the same law, which also holds the weight."""
    law = screwgen.PD(tuple(plan.kp), tuple(plan.kd), tuple(plan.q[-1]), plan.time, gravity=Holding(model))
    steps = int(np.ceil(plan.time / step - 1e-9))
    begin = screwgen.play(model, plan, step=step).run.q[0]
    run = screwgen.simulate(model, (steps + round(1.0 / step)) * step, step, begin, controller=law)
    return float(np.linalg.norm(np.ptp(run.tip_position[run.t >= plan.time], axis=0)))


def test_other_loads_come_to_rest_each_with_the_twist_of_its_gear():
    model, left = geared(gravity=G), []
    for models in ((), [{"*.mass": 0.9}, {"*.mass": 1.1}]):
        plan = screwgen.plan(model, [0.0], [1.0], 1.2, gains=LAW, models=models, fast=True)
        loads = (screwgen.play(model, plan, parameters={"rod.bodies[0].mass": x * LOAD}) for x in (0.9, 1.1))
        left.append(max(x.residual for x in loads))
    assert left[1] < 0.35 * left[0]


@pytest.mark.parametrize("elastic", [False, True])
def test_dry_friction_of_a_motor_is_borne_where_it_acts(elastic):
    """The arm arrives. Torques of a rigid drive, whose friction is stated at its axis, are those of Newton's law."""
    stiff = {"coulomb": 1.0, "viscous": 0.25, "velocity": 0.01}
    model = geared(friction=FRICTION) if elastic else geared(friction=stiff, stiffness=None)
    plan = screwgen.plan(model, [0.0], [1.0], 1.0, gains=LAW, intervals=48)
    assert screwgen.play(model, plan, step=5e-4).residual < 1e-3 * least_jerk(model, plan, 5e-4)
    if not elastic:
        v, inertia = plan.v[:, 0], RATIO**2 * ROTOR + LOAD * LENGTH**2
        friction, slips = np.sign(v) + 0.25 * v, np.abs(v) > 0.3
        assert slips.sum() > 30
        assert np.abs(plan.tau[:, 0] - inertia * plan.vdot[:, 0] - friction)[slips].max() < 1e-3


def test_friction_that_a_drive_cannot_bear_is_refused():
    model = geared(friction={"coulomb": 0.2, "velocity": 0.5})
    with pytest.raises(UsageError, match=r"the limits of (rates of )?efforts"):
        screwgen.plan(model, [0.0], [1.0], 1.0, gains=LAW, limits={"efforts": [12.0], "effort_rates": [150.0]})


def test_the_collaborative_arm_arrives():
    """Seven axes, six of them behind gears that twist, with dry friction; a path of least jerk leaves a millimetre."""
    model, start = example("elastic_joint"), [0.0, 0.3, 0.0, 0.8, 0.0, 0.5, 0.0]
    law = screwgen.PD((6e3, 6e3, 3e3, 3e3, 1e3, 1e3, 100.0), (400.0, 400.0, 200.0, 200.0, 60.0, 60.0, 6.0), (0.0,) * 7)
    goal = [0.8, 0.8, -0.3, 1.3, 0.4, 0.0, 0.5]
    plan = screwgen.plan(model, start, goal, 1.2, gains=law, fast=True)
    arrived = screwgen.play(model, plan)
    assert arrived.residual < 1e-4 and arrived.residual < 0.04 * least_jerk(model, plan, 1e-3)


def test_the_report_has_the_efforts_of_motors_times_the_ratio():
    model, most = geared(effort=0.5), 0.5 * RATIO
    report = screwgen.plan_report(model, screwgen.plan(model, [0.0], [1.0], 1.0, gains=LAW, fast=True), factors=(1.0,))
    run = report.first.run
    assert report.shares[0] == pytest.approx(RATIO * np.abs(run.tau[:-1, 0]).max() / most, rel=1e-12)
    assert report.first.rates[0] == pytest.approx(np.abs(run.v[:, 1]).max() / RATIO, rel=1e-12)
    assert report.robustness["stiffness"].parameters == ("rod.joint.drives[0].stiffness",)
    assert f'<td class="n">{most:.4g}</td>' in report.html()


def test_gains_of_an_elastic_drive_close_the_loop_about_its_rotor():
    """The loop that a clock closes about the linear model of the whole arm has the decay that is said."""
    model, step, slow = geared(gravity=G), 1e-3, []
    found = screwgen.gains(model, [[0.0], [1.0]], step=step)
    law = np.array([0.0, found.kp[0], 0.0, found.kd[0]]) / RATIO**2
    for angle in (0.0, 1.0):
        rest = screwgen.play(model, screwgen.plan(model, [angle], [angle + 0.1], 1.0, gains=LAW, fast=True)).run
        linear = model.linearise(rest.q[0], tau=rest.tau[0])
        whole = expm(step * np.block([[linear.A, linear.B], [np.zeros((1, 5))]]))
        s = np.log(np.linalg.eigvals(whole[:4, :4] - np.outer(whole[:4, 4], law)).astype(complex)) / step
        slow += [*-s.real[np.abs(s.imag) < 2 * np.pi * found.band]]
    assert found.decay == pytest.approx(min(slow), rel=1e-6) and found.decay > 3.0


def test_what_vibrates_behind_a_locked_rotor_is_the_load_on_the_gear():
    shaper = screwgen.shape(geared(), [-1.0], [1.0])
    frequency = np.sqrt(STIFFNESS / (LOAD * LENGTH**2)) / (2 * np.pi)
    assert shaper.vibrations([0.3])[0] == pytest.approx([frequency], rel=1e-6) and shaper.residual < 1e-6


def test_bounds_of_efforts_are_those_of_the_motor_times_the_ratio():
    found = screwgen.gains(geared(effort=1.2), [[0.0]], bounds={"jump": [0.1]})
    assert 0.5 * 1.2 * RATIO < found.jump_efforts[0] <= 1.2 * RATIO


@pytest.fixture(scope="module")
def filtered():
    """A law with a filter of an arm that hangs on its gear, over postures and loads."""
    model = geared(gravity=G, effort=1.2)
    return model, screwgen.lqg(model, {"rod.joint[0]": [-0.5, 0.5], "rod.bodies[0].mass": [0.7, 1.3]})


def test_the_loop_of_a_filter_and_the_whole_arm_decays_as_is_said(filtered):
    """The arm's own linear model, sampled, with the steps that the law itself does: these are affine within limits."""
    model, law = filtered
    step, slow = law.step, []
    for angle, load in law.grid.vertices:
        p = model.chain.parameters.vector({"rod.bodies[0].mass": load * LOAD})
        weight = G * LENGTH * (load * LOAD + DENSITY * LENGTH / 2)
        twist = brentq(lambda x, a=angle, w=weight: STIFFNESS * x + w * np.cos(a + x), -0.1, 0.1)
        rest = np.array([angle + twist, RATIO * angle])
        hold = weight * np.cos(rest[0])
        linear = model.linearise(rest, tau=[hold / RATIO], parameters=p)
        whole = expm(step * np.block([[linear.A, linear.B], [np.zeros((1, 5))]]))

        def moved(x, angle=angle, load=load, hold=hold, whole=whole):
            memory = law.start([angle], [load])
            memory.x, memory.z = memory.x + x[4:8], memory.z + x[8:]
            tau = law.sample(memory, [angle + x[1] / RATIO], [angle], loads=[load]) - hold
            behind = law.start([angle], [load])
            return np.concatenate([whole[:4] @ [*x[:4], tau[0] / RATIO], memory.x - behind.x, memory.z - behind.z])

        assert np.abs(moved(np.zeros(9))).max() < 1e-9
        loop = np.array([moved(1e-4 * e) - moved(-1e-4 * e) for e in np.eye(9)]).T / 2e-4
        s = np.log(np.linalg.eigvals(loop).astype(complex)) / step
        slow += [*-s.real[np.abs(s.imag) < 2 * np.pi * 0.025 / step]]
    said = next(line for line in law.lines if line.startswith("4 vertices"))
    assert f"slowest decay {min(slow):.3g} 1/s" in said and min(slow) > 3.0


def test_a_law_with_a_filter_brings_an_elastic_drive_to_rest(filtered):
    model, law = filtered
    p = model.chain.parameters.vector({"rod.bodies[0].mass": 1.2 * LOAD})
    controller = screwgen.LqgLaw.of(law, [0.4], duration=0.8, loads=(1.2,))
    begin = np.array([-1.2 * LOAD * G * LENGTH / STIFFNESS, 0.0])
    run = screwgen.simulate(model, 4.0, law.step, begin, controller=controller, parameters=p)
    assert np.abs(run.tau).max() <= 1.2 and run.q[-1, 1] / RATIO == pytest.approx(0.4, abs=1e-6)
    held = 1.2 * LOAD * G * LENGTH * np.cos(run.q[-1, 0])
    assert RATIO * run.tau[-1, 0] == pytest.approx(held, rel=1e-5) and np.abs(run.v[-1]).max() < 1e-4


def test_c_of_a_law_with_a_filter_gives_what_python_gives(filtered, tmp_path):
    law = replace(filtered[1], robot="boom")
    c, rng, memory = Compiled(law, tmp_path), np.random.default_rng(3), law.start([0.1], [1.1])
    assert c.start(0.1, 0.0, 0.0, 1.1) == 0
    for k in range(1000):
        q, y = 0.4 * np.sin(3e-3 * k), 0.4 * np.sin(3e-3 * k) + 1e-3 * rng.normal()
        wanted = law.sample(memory, [y], [q], [1.2 * np.cos(3e-3 * k)], [1.1])
        assert c.sample(law.step * k, y, q, 1.2 * np.cos(3e-3 * k), 1.1) == 0
        assert c.effort[0] == pytest.approx(wanted[0], abs=1e-12 * law.tau_max[0])
