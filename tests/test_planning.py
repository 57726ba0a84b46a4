"""Plans of motions that end at rest: judged by bang-bang's closed form, by the arm itself, by what forbids them."""

import signal
from dataclasses import replace

import numpy as np
import pytest
from helpers import arm, example, link, loaded_boom, model_of

import screwgen
from screwgen import UsageError
from screwgen.planning.followed import efforts_with_law
from screwgen.planning.plan import PlanWarning
from screwgen.simulation.played import Played, read_played

ROTOR, LOAD, EI, LENGTH = 0.4, 1.0, 40.0, 1.0
LAW = screwgen.PD((60.0,), (12.0,), (0.0,))


def one_mode(gravity=False):
    """A light rod in a plane that carries a load: a rotor, a spring and a mass."""
    section = {"rhoA": 1e-6, "EIy": EI, "EIz": EI}
    own = {"length": LENGTH, "joint": {"armature": [ROTOR]}, "bodies": [{"at": "tip", "mass": LOAD}]}
    return model_of(loaded_boom(section, modes=1, gravity=-9.81 if gravity else 0.0, **own))


def bang_bang(way, effort, inertia, frequency):
    """The shortest time of a rest-to-rest motion of one undamped mode: bang-bang with three switches.

    The switches at ±s and 0 about the middle leave the rigid motion and the mode at rest: with half the time h the
    rigid one goes (h² − 2 s²) effort / inertia, and the mode rests where 1 + cos(w h) = 2 cos(w s).
    """
    w = 2 * np.pi * frequency
    h = np.linspace(np.sqrt(way * inertia / effort), 3 * np.sqrt(way * inertia / effort), 400001)
    s = np.sqrt(np.maximum(h**2 - way * inertia / effort, 0.0) / 2)
    open_by = 1 + np.cos(w * h) - 2 * np.cos(w * s)
    k = int(np.flatnonzero(np.diff(np.sign(open_by)) != 0)[0])
    return 2 * h[k]


def test_the_shortest_time_of_one_mode_is_that_of_bang_bang():
    model, way, effort = one_mode(), 1.0, 20.0
    free = float(np.abs(model.linearise([0.0, 0.0]).eigenvalues().imag).max()) / (2 * np.pi)
    plan = screwgen.plan(model, [0.0], [way], "shortest", limits={"efforts": [effort / 0.97]}, intervals=140)
    inertia = ROTOR + LOAD * LENGTH**2
    best = bang_bang(way, effort, inertia, free)
    assert best * 0.998 <= plan.time <= 1.015 * best


def test_a_plan_leaves_its_model_at_rest_and_keeps_limits():
    model = one_mode()
    plan = screwgen.plan(model, [0.0], [1.0], 0.9, gains=LAW)
    arrived = screwgen.play(model, plan, step=5e-4)
    jerk = screwgen.play(model, smooth(plan), step=5e-4)
    assert arrived.residual < 2e-3 * jerk.residual
    most = 0.9 * plan.effort
    tight = screwgen.plan(model, [0.0], [1.0], 0.9, gains=LAW, limits={"efforts": most})
    assert (tight.effort <= 0.97 * most * (1 + 1e-6)).all() and tight.said["cost"] > plan.said["cost"]
    assert screwgen.play(model, tight, step=5e-4).saturated == 0


def test_limits_hold_between_the_points_of_a_plan():
    model, t = one_mode(), np.linspace(0.0, 0.9, 5001)
    free = screwgen.plan(model, [0.0], [1.0], 0.9, gains=LAW, intervals=12)
    most = 0.87 * np.abs(free.reference(t)[1]).max()
    plan = screwgen.plan(model, [0.0], [1.0], 0.9, gains=LAW, intervals=12, limits={"rates": [most]})
    assert np.abs(plan.v).max() == pytest.approx(most, rel=1e-3)
    assert np.abs(plan.reference(t)[1]).max() <= (1 + 2e-4) * most


def test_a_plan_of_few_intervals_leaves_the_law_what_it_takes(monkeypatch):
    """Twelve intervals do not resolve the second mode; what the law then gives besides is that of a run."""
    model, law, said = model_of(loaded_boom({"rhoA": 0.6})), screwgen.PD((60.0,), (12.0,), (0.0,)), []
    asked = {"gains": law, "limits": {"efforts": [8.5]}, "intervals": 12}
    plan = screwgen.plan(model, [0.0], [1.0], 1.0, **asked)
    arrived = screwgen.play(model, plan, step=2.5e-4)
    assert arrived.saturated == 0 and 8.4 < arrived.effort[0] < 8.5 and plan.effort[0] < 0.96 * 8.5

    def only_said(task, members, found, search):
        said.append(efforts_with_law(task, members[0], found))
        return found

    monkeypatch.setattr("screwgen.planning.make.within_efforts", only_said)
    tight = screwgen.plan(model, [0.0], [1.0], 1.0, **asked)
    assert screwgen.play(model, tight, step=2.5e-4).saturated > 50
    free = screwgen.play(model, replace(tight, tau_max=np.array([np.inf])), step=2.5e-4)
    assert said[0] == pytest.approx(free.effort, rel=3e-3) and said[0] > 8.5


def test_the_shortest_plan_leaves_the_law_what_it_takes(monkeypatch):
    """It takes longer for that; without a look at what follows it the drive saturates."""
    model, law = model_of(loaded_boom({"rhoA": 0.6})), screwgen.PD((60.0,), (12.0,), (0.0,))
    asked = {"gains": law, "limits": {"efforts": [8.5]}, "intervals": 12}
    plan = screwgen.plan(model, [0.0], [1.0], "shortest", **asked)
    arrived = screwgen.play(model, plan, step=2.5e-4)
    assert arrived.saturated == 0 and 0.97 * 8.5 < arrived.effort[0] < 8.5
    monkeypatch.setattr("screwgen.planning.make.within_efforts", lambda task, members, found, search: found)
    bare = screwgen.plan(model, [0.0], [1.0], "shortest", **asked)
    assert bare.time < plan.time < 1.05 * bare.time
    assert screwgen.play(model, bare, step=2.5e-4).saturated > 100


@pytest.mark.parametrize("most, said", [(np.nan, "could not be found"), (30.0, r"limit of a drive by 2\.5e\+02 %")])
def test_what_the_law_takes_is_told_where_no_tighter_limits_leave_it(monkeypatch, most, said):
    """Of a motion that the finer grid does not follow, or of one whose limits would have to fall below zero."""
    monkeypatch.setattr("screwgen.planning.followed.efforts_with_law", lambda *given: np.array([most]))
    with pytest.warns(PlanWarning, match=said):
        screwgen.plan(one_mode(), [0.0], [1.0], 1.2, gains=LAW, limits={"efforts": [8.5]})


def test_a_load_is_carried_along_in_the_shortest_time():
    """A pendulum on a trolley, which no drive moves, swings to the angle that it had."""
    slide = {"axes": [{"slide": "x"}], "armature": [5.0]}
    links = [
        {"name": "cart", "joint": slide, "bodies": [{"at": "base", "mass": 3.0}]},
        {"name": "load", "joint": {"axes": ["y"]}, "bodies": [{"at": "base", "mass": 2.0, "com": [0.0, 0.0, -1.0]}]},
    ]
    trolley = screwgen.derive(screwgen.Robot(name="trolley", gravity=[0.0, 0.0, -9.81], links=links))
    plan = screwgen.plan(trolley, [0.0, 0.0], [1.0, 0.0], "shortest", limits={"efforts": [20.0, 0.0]}, intervals=60)
    best = bang_bang(1.0, 0.97 * 20.0, 10.0, np.sqrt(9.81 * 10.0 / 8.0) / (2 * np.pi))
    assert best < plan.time < 1.03 * best and np.abs(plan.tau[:, 1]).max() < 1e-9


def test_an_interruption_ends_the_search():
    """The solver took it for a motion that cannot be found, and the search went on to another one."""
    with pytest.raises(KeyboardInterrupt):
        screwgen.plan(
            one_mode(), [0.0], [1.0], 1.2, progress=lambda i, _: i == 2 and signal.raise_signal(signal.SIGINT)
        )


def test_a_robust_plan_leaves_the_law_what_it_takes_of_every_model():
    """The heavier arm saturates its drive for 87 samples where the first model alone is followed."""
    model, law = model_of(loaded_boom({"rhoA": 0.6})), screwgen.PD((60.0,), (12.0,), (0.0,))
    asked = {"gains": law, "limits": {"efforts": [9.5]}, "intervals": 12, "models": [{"*.mass": 1.2}]}
    plan = screwgen.plan(model, [0.0], [1.0], 1.0, **asked)
    arrived = screwgen.play(model, plan, step=2.5e-4, parameters={"rod.bodies[0].mass": 1.2})
    assert arrived.saturated == 0 and 9.3 < arrived.effort[0] < 9.5


def smooth(plan):
    """The same way along a path of least jerk, with the torques of a rigid arm."""
    s, T = (plan.t / plan.time)[:, None], plan.time
    way = plan.q[-1] - plan.q[0]
    q = plan.q[0] + way * s**3 * (10 - 15 * s + 6 * s**2)
    v, a = way * 30 * (s * (1 - s)) ** 2 / T, way * (60 * s - 180 * s**2 + 120 * s**3) / T**2
    rigid = (ROTOR + LOAD * LENGTH**2) * a
    return screwgen.MotionPlan(plan.robot, plan.joints, plan.t, q, v, a, rigid, plan.kp, plan.kd, plan.tau_max)


def test_a_plan_is_played_from_its_start(recwarn):
    """Without a state; from another one it is told."""
    model = one_mode()
    plan = screwgen.plan(model, [0.4], [1.0], 0.9, gains=LAW)
    played = screwgen.simulate(model, 0.1, 1e-3, controller=Played.of(plan))
    assert played.q[0] == pytest.approx([0.4, 0.0], abs=1e-12) and not [x for x in recwarn if x.category is PlanWarning]
    with pytest.warns(PlanWarning, match=r"the plan starts at 0\.4 of rod\.joint\[0\], the run at 0:"):
        screwgen.simulate(model, 0.1, 1e-3, [0.0, 0.0], controller=Played.of(plan))


def test_a_robust_plan_brings_other_loads_to_rest():
    model = one_mode()
    loads = [{"*.mass": 0.7}, {"*.mass": 1.3}]
    plans = [screwgen.plan(model, [0.0], [1.0], 1.2, gains=LAW, models=m, intervals=30) for m in ((), loads)]
    left = [
        max(screwgen.play(model, p, parameters={"rod.bodies[0].mass": x * LOAD}).residual for x in (0.7, 1.3))
        for p in plans
    ]
    assert left[1] < 0.12 * left[0]


def test_a_cart_leaves_the_load_on_its_rope_at_rest():
    cart = link("cart", axes=[{"slide": "y"}], length=0.1, modes={}, section={"rhoA": 0.1})
    rope = link("rope", axes=["z"], length=1.0, modes={}, section={"rhoA": 0.05}, bodies=[{"at": "tip", "mass": 2.0}])
    model = model_of({**arm({**cart, "bodies": [{"at": "tip", "mass": 5.0}]}, rope), "gravity": [9.81, 0.0, 0.0]})
    plan = screwgen.plan(model, [0.0, 0.0], [0.8, 0.0], 1.6, limits={"efforts": [200.0, 0.0]})
    assert plan.effort[1] == 0 and np.abs(plan.q[:, 1]).max() > 0.1
    arrived = screwgen.play(model, plan)
    assert arrived.residual < 5e-5 and arrived.saturated == 0


def test_references_and_means_of_torques_are_those_of_the_polynomials():
    plan = screwgen.plan(one_mode(), [0.0], [1.0], 0.9)
    q, v = plan.reference(plan.t)
    assert np.abs(q - plan.q).max() < 1e-13 and np.abs(v - plan.v).max() < 1e-12
    t = np.linspace(0.0, 0.9, 20001)
    fine = plan.reference(t)
    assert np.abs(np.gradient(fine[0], t, axis=0) - fine[1])[1:-1].max() < 1e-5
    own = np.array([np.interp(t, plan.t, column) for column in plan.tau.T]).T
    mean = (own[4000:9000] + own[4001:9001]).mean(axis=0) / 2
    assert np.abs(plan.mean_torque(t[4000], t[9000]) - mean).max() < 1e-5
    assert plan.mean_torque(2.0, 3.0) == plan.tau[-1] and plan.mean_torque(-2.0, -1.0) == plan.tau[0]


def test_a_plan_is_the_same_from_its_file(tmp_path):
    from screwgen.planning.plan_files import write_csv, write_npz

    plan = screwgen.plan(one_mode(), [0.0], [1.0], 0.9, gains=LAW, intervals=8)
    with open(tmp_path / "plan.npz", "wb") as stream:
        write_npz(plan, stream)
    read = screwgen.read_plan(tmp_path / "plan.npz")
    assert all(np.array_equal(getattr(read, n), getattr(plan, n)) for n in ("t", "q", "v", "vdot", "tau", "kp", "kd"))
    with open(tmp_path / "plan.csv", "wb") as stream:
        write_csv(plan, stream, 1e-2)
    rows = np.loadtxt(tmp_path / "plan.csv", delimiter=",", skiprows=1)
    s = plan.sampled(1e-2)
    assert np.array_equal(rows, np.column_stack([s.t, s.q, s.v, s.tau])) and len(rows) == 91
    other = model_of({**one_mode().robot.model_dump(exclude_unset=True), "name": "other"})
    with pytest.warns(PlanWarning, match=r"plan\.npz: a plan for robot '\w+' is played by 'other', whose torques may"):
        read_played(tmp_path / "plan.npz", other)
    np.savez(tmp_path / "bad.npz", t=np.zeros(3))
    with pytest.raises(UsageError, match=r"bad\.npz: cannot be read as a plan"):
        screwgen.read_plan(tmp_path / "bad.npz")


@pytest.mark.parametrize(
    ("said", "goal", "time", "more"),
    [
        (r"goal: rod\.joint\[0\] is 1; its limits are -inf and 0\.5", 1.0, 1.0, {"limits": {"upper": [0.5]}}),
        (r"time: rod\.joint\[0\] goes 1 in 0\.5 s.* more than 1 s", 1.0, 0.5, {"limits": {"rates": [1.0]}}),
        (r"the limits of efforts forbid it; without limits rod\.joint\[0\]", 1.0, 0.8, {"limits": {"efforts": [5.0]}}),
        (r"nothing limits efforts or rates", 1.0, "shortest", {}),
        (r"goal: is the start", 0.0, 1.0, {}),
        (r"models: several share .* give gains", 1.0, 1.0, {"models": [{"*.mass": 0.7}]}),
        (r"limits: there is no 'speed'", 1.0, 1.0, {"limits": {"speed": [1.0]}}),
    ],
)
def test_what_forbids_a_plan_is_one_line(said, goal, time, more):
    with pytest.raises(UsageError, match=said) as caught:
        screwgen.plan(one_mode(), [0.0], [goal], time, intervals=12, **more)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("parallelogram", "loops"),
        ("tentacle", "no joints"),
        ("space_arm", "floating base"),
        ("ship_crane", "inputs that load links"),
    ],
)
def test_robots_without_a_plan_are_refused(name, what):
    model = example(name)
    with pytest.raises(UsageError, match=what):
        screwgen.plan(model, [0.0] * model.n_joints, [0.1] * model.n_joints, 1.0)


@pytest.mark.parametrize("kind", ["zv", "zvd", "ei"])
@pytest.mark.parametrize("damping", [0.0, 0.1])
def test_shapers_leave_what_theory_says(kind, damping):
    shaper = screwgen.shaper(2.0, damping, kind)
    assert abs(shaper.amplitudes.sum() - 1) < 1e-15
    assert shaper.delay == pytest.approx((1 if kind == "zv" else 2) * 0.25 / np.sqrt(1 - damping**2))
    assert abs(shaper.residual(2.0, damping) - (0.05 if kind == "ei" else 0.0)) < 1e-14
    if not damping:
        x = np.cos(np.pi / 2 * np.linspace(0.6, 1.4, 9))
        expected = {"zv": np.abs(x), "zvd": x**2, "ei": np.abs(x**2 * 0.95 + 0.05 * (2 * x**2 - 1))}[kind]
        assert np.abs(shaper.residual(2.0 * np.linspace(0.6, 1.4, 9)) - expected).max() < 1e-3


def test_gains_are_stable_in_the_sampled_loop_of_the_arm():
    model = one_mode()
    law = screwgen.gains(model, [[0.0]])
    pd = screwgen.PD(tuple(law.kp), tuple(law.kd), (0.0,))
    run = screwgen.simulate(model, 12.0 / law.decay, 1e-3, q0=[0.05, 0.0], controller=pd)
    assert law.decay > 1 and law.spare >= 1.9
    late, early = (np.abs(run.q[s, 0]).max() for s in (slice(-50, None), slice(0, 50)))
    assert late < 1e-3 * early


def ella(order, modes):
    """The example with rotors, of another order and number of modes per plane."""
    from helpers import example_dict

    robot = {**example_dict("converged"), "order": order}
    links = robot["links"]
    for row, rotors in zip(links, ([0.2, 0.2], [0.1]), strict=True):
        row["modes"] = {"bending_y": modes, "bending_z": modes, "torsion": 1}
        row["joint"] = {**row["joint"], "armature": rotors}
    return model_of(robot)


@pytest.mark.long
def test_a_plan_of_ella_leaves_an_exact_arm_at_rest():
    design, plant = ella(1, 2), ella("exact", 4)
    found = screwgen.gains(design, [[0.0, 0.0, 0.0], [-0.5, 0.7, 0.45]])
    law = screwgen.PD(tuple(found.kp), tuple(found.kd), (0.0, 0.0, 0.0))
    payloads = [{"forearm.bodies[0].mass": f} for f in (0.7, 1.3)]
    own = dict(zip(plant.parameter_names, plant.parameter_values, strict=True))
    off = [{name: f * x for name, x in own.items() if name.endswith(("EIy", "EIz"))} for f in (0.8, 1.2)]
    off += [{"forearm.bodies[0].mass": f * own["forearm.bodies[0].mass"]} for f in (0.7, 1.3)]
    goal = [-0.5, 0.7, 0.45]
    nominal = screwgen.plan(design, [0.0] * 3, goal, 1.2, gains=law)
    assert nominal.said["iterations"] <= 30
    assert screwgen.play(plant, nominal).residual <= 2e-4
    robust = screwgen.plan(design, [0.0] * 3, goal, 1.2, gains=law, models=payloads)
    assert max(screwgen.play(plant, robust, parameters=p).residual for p in ({}, *off)) <= 3e-3


LOADS = {
    "strains": lambda model, plan, r: max(float(np.abs(model.numpy().strain(q)).max()) for q in r.q),
    "wrenches": lambda model, plan, r: float(np.abs(r.wrench[:, 0, 2]).max()),
    "effort_rates": lambda model, plan, r: float(np.abs(np.diff(plan.sampled(1e-3).tau[:-1, 0])).max() / 1e-3),
}


@pytest.mark.parametrize("name", LOADS)
def test_loads_keep_their_limits(name):
    """In a run of the plan: four fifths of what they are without; less than the motion takes is refused."""
    model, reached = one_mode(), []
    limit = {
        "strains": lambda x: {"rod.base_strain.*": x},
        "wrenches": lambda x: {"rod.tau_z": x},
        "effort_rates": lambda x: [x],
    }[name]
    for share in (None, 0.8):
        given = {} if share is None else {name: limit(share * reached[0])}
        plan = screwgen.plan(model, [0.0], [1.0], 0.9, gains=LAW, limits=given, intervals=40)
        reached.append(LOADS[name](model, plan, screwgen.play(model, plan, step=5e-4).run))
    assert 0.75 * reached[0] < reached[1] < 0.805 * reached[0]
    words = {"strains": "strains", "wrenches": "joint wrenches", "effort_rates": "rates of efforts"}[name]
    with pytest.raises(UsageError, match=f"the limits of {words} forbid it; without limits rod"):
        screwgen.plan(model, [0.0], [1.0], 0.9, intervals=12, limits={name: limit(0.3 * reached[0])})


@pytest.mark.parametrize(
    ("said", "limits"),
    [
        (
            r"limits: strains: there is no 'rod\.twist'; choose of rod\.base_strain\.bending_y",
            {"strains": {"rod.twist": 1.0}},
        ),
        (r"limits: wrenches: rod\.F_x: must be > 0", {"wrenches": {"rod.F_x": 0.0}}),
        (r"limits: wrenches: must be a table", {"wrenches": [1.0]}),
        (r"limits: effort_rates: must be positive", {"effort_rates": [0.0]}),
    ],
)
def test_limits_of_loads_that_are_none_are_one_line(said, limits):
    with pytest.raises(UsageError, match=said):
        screwgen.plan(one_mode(), [0.0], [1.0], 0.9, limits=limits)


def test_a_rest_that_bends_too_far_is_refused():
    """The mode has one curvature: half of that which a load of 9.81 N has at the base of a cantilever."""
    said = r"start: at rest rod\.base_strain\.bending_y is 0\.1226; its limit is 0\.1"
    with pytest.raises(UsageError, match=said):
        screwgen.plan(one_mode(gravity=True), [0.0], [1.0], 0.9, limits={"strains": {"*": 0.1}})
