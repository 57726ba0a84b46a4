"""Tips on paths: judged by the closed form of one mode, by plants that know more, by what no tip can follow."""

import numpy as np
import pytest
from helpers import arm, example, link, loaded_boom, model_of
from scipy.integrate import simpson
from test_planning import ella

import screwgen
from screwgen import UsageError

LENGTH, WAY, TIME = 1.2, 1.0, 1.2
PREVIEW, GEAR = 0.1, 50.0


def eased(s):
    """From 0 to 1 with rates, accelerations and their rates zero at both ends."""
    return s**4 * (35 - 84 * s + 70 * s**2 - 20 * s**3)


def sweep(t, way=WAY):
    """Places on a circle about the joint."""
    angle = way * eased(t / TIME)
    return LENGTH * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)


def circle(t):
    """Places on a circle in the plane of two links."""
    angle = 2 * np.pi * eased(t / 2.0)
    return np.stack([0.9 + 0.2 * np.cos(angle), 0.3 + 0.2 * np.sin(angle), 0 * angle], axis=-1)


def rod(order=2, modes=2, **more):
    """One link in a plane without gravity."""
    return model_of(loaded_boom({"rhoA": 0.6}, modes, length=LENGTH, **more) | {"order": order, "name": "arm"})


def planar(order=2, modes=2, stiffness=None):
    """Two links in a plane without gravity, perhaps behind gears that twist."""
    section, load = {"rhoA": 0.6, "EIy": 90.0, "EIz": 90.0}, [{"at": "tip", "mass": 0.3}]
    own = {"axes": "z", "section": section, "modes": {"bending_y": modes}, "bodies": load}
    rows = []
    for name, length, rotor in (("upper", 0.8, 0.3), ("fore", 0.7, 0.1)):
        gear = {"ratio": GEAR, "rotor_inertia": rotor / GEAR**2, "stiffness": stiffness, "damping": 2.0}
        rows.append(link(name, length=length, joint={"drives": gear} if stiffness else {"armature": [rotor]}, **own))
    return model_of(arm(*rows, order=order, gravity=[0.0, 0.0, 0.0]))


def law(model):
    """A joint law to play under."""
    return screwgen.PD((100.0, 60.0)[: model.n_joints], (30.0, 10.0)[: model.n_joints], (0.0,) * model.n_joints)


def miss(plant, plan, path, time, along=False):
    """How far the tip is from its path, m; `along` it alone, for a joint cannot mend what bending shortens."""
    run = screwgen.play(plant, plan, after=0.2).run
    goal = path(np.clip(run.t - PREVIEW, 0.0, time))
    off = run.tip_position - goal
    if along:
        ahead = np.stack([-goal[:, 1], goal[:, 0], 0 * goal[:, 0]], axis=-1) / LENGTH
        return np.abs((off * ahead).sum(axis=1)).max()
    return np.linalg.norm(off, axis=1).max()


def test_a_small_motion_of_one_mode_is_the_closed_form():
    """Bending is the two-sided convolution of the tip's acceleration with exp(-z |t|), z the zero of the arm.

    With `m θ̈ + M η̈ + K η = 0` and `y = l θ + c η` it is `η̈ − z² η = m / (l μ) ÿ`, `μ = m c / l − M`, `z² = K / μ`.
    """
    model, small = rod(order=1, modes=1), 1e-4
    plan = screwgen.track(model, lambda t: sweep(t, small), TIME, step=1e-3)
    M, K = model.numpy().mass_matrix(np.zeros(2)), model.numpy().constants[0]["K"][0]
    slope = LENGTH, model.numpy().tip_pose([0.0, 1e-3])[1][1] / 1e-3
    mu = M[0, 1] * slope[1] / slope[0] - M[1, 1]
    z, ease = np.sqrt(K / mu), np.polynomial.Polynomial([0, 0, 0, 0, 35, -84, 70, -20])

    def bent(t):
        found = 0.0
        for begin, end in ((0.0, np.clip(t, 0.0, TIME)), (np.clip(t, 0.0, TIME), TIME)):
            s = np.linspace(begin, end, 4001)
            acceleration = LENGTH * small * ease.deriv(2)(s / TIME) / TIME**2
            found -= simpson(np.exp(-z * np.abs(t - s)) * acceleration, x=s)
        return M[0, 1] / (LENGTH * mu * 2 * z) * found

    times, joints = plan.t[100:-1:100] - PREVIEW, plan.q[100:-1:100, 0]
    bending = slope[1] / LENGTH * np.array([bent(t) for t in times])
    wanted = small * eased(np.clip(times / TIME, 0.0, 1.0)) - bending
    assert np.abs(joints - wanted).max() < 1e-9 * np.abs(bending).max()


@pytest.mark.parametrize(("make", "path", "time"), [(rod, sweep, TIME), (planar, circle, 2.0)])
def test_the_tip_is_on_its_path(make, path, time):
    """Within 0.02 mm in an arm of order 2, and planned by an exact model within 0.1 mm in one with four modes."""
    near = [0.0] if make is rod else [-0.5, 1.2]
    for order, modes, most in ((2, 2, 2e-5), ("exact", 4, 1e-4)):
        plan = screwgen.track(make(order), path, time, near=near, gains=law(make()), step=2e-3)
        assert plan.time == pytest.approx(time + 2 * PREVIEW) and plan.said["iterations"] <= 8
        found = miss(make(order, modes), plan, path, time, along=make is rod)
        rigid = screwgen.PD(tuple(plan.kp), tuple(plan.kd), tuple(plan.q[-1]), duration=time)
        run = screwgen.simulate(make(order, modes), time, 1e-3, q0=plan.q[0], controller=rigid)
        told = np.linalg.norm(run.tip_position - path(run.t), axis=1).max()
        assert found < most and found < 1e-3 * told


def test_the_tip_is_on_its_path_behind_gears_that_twist():
    design = planar(stiffness=600.0)
    plan = screwgen.track(design, circle, 2.0, near=[-0.5, 1.2], gains=law(design), step=2e-3)
    run = screwgen.play(design, plan).run
    assert np.abs(run.q[:, :2] - run.q[:, 2:4] / GEAR).max() > 1e-2 and miss(design, plan, circle, 2.0) < 2e-5
    assert miss(planar("exact", 4, 600.0), plan, circle, 2.0) < 1e-4


def on_a_gear(stiffness=900.0):
    """A light rod with a load, which a motor turns through a gear."""
    drive = {"ratio": GEAR, "rotor_inertia": 0.5 / GEAR**2, "stiffness": stiffness}
    load = [{"at": "tip", "mass": 2.0}]
    row = link("rod", length=LENGTH, rhoA=1e-9, section={"rhoIp": 1e-12}, bodies=load, joint={"drives": drive})
    return model_of(arm(row, gravity=[0.0, 0.0, 0.0]))


def test_a_rotor_leads_its_load_by_what_accelerates_it():
    """`k (θ − φ) = m l² φ̈` and `τ = J θ̈ + m l² φ̈`: the motor's torque takes four derivatives of the path."""
    plan = screwgen.track(on_a_gear(), sweep, TIME, step=1e-3)
    load, ease = 2.0 * LENGTH**2, np.polynomial.Polynomial([0, 0, 0, 0, 35, -84, 70, -20])
    at = plan.t - PREVIEW
    inner = (at > 0.05) & (at < TIME - 0.05)
    parts = {k: ease.deriv(k) if k else ease for k in (0, 2, 4)}
    angle, second, fourth = (part(at[inner] / TIME) / TIME**k for k, part in parts.items())
    assert np.abs(plan.q[inner, 0] - angle - load / 900.0 * second).max() < 1e-9
    assert np.abs(plan.tau[inner, 0] - 0.5 * (second + load / 900.0 * fourth) - load * second).max() < 1e-2


def test_a_path_whose_acceleration_a_rotor_cannot_follow_is_refused():
    """Its third derivative jumps; where links bend, or gears do not, it is smooth enough."""

    def jerked(t):
        s = t / TIME
        angle = s**3 * (10 - 15 * s + 6 * s**2)
        return LENGTH * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)

    with pytest.raises(UsageError, match=r"its acceleration or the rate of that jumps at .*third derivative"):
        screwgen.track(on_a_gear(), jerked, TIME, step=1e-3)
    assert screwgen.track(rod(), jerked, TIME, step=1e-3).effort[0] < 20.0


def test_a_tip_path_is_played_from_c_as_any_plan():
    files = screwgen.track(rod(), sweep, TIME, step=1e-2).c()
    assert set(files) == {"arm_plan.h", "arm_plan.c"}


def turned(t):
    """A path whose rate jumps in the middle."""
    return sweep(TIME * np.minimum(t / TIME, 1 - t / TIME))


@pytest.mark.parametrize(
    ("path", "more", "said"),
    [
        (lambda t: 1.01 * sweep(t), {}, "is out of reach, by 0.012 m"),
        (lambda t: np.where(t[:, None] > 0.5, sweep(t + 0.1), sweep(t)), {}, "it or its rate jumps at 0.5"),
        (turned, {}, "it or its rate jumps at 0.6"),
        (lambda t: sweep(t)[:, :2], {}, "path: gives an array of shape"),
        (lambda t: sweep(t) * np.nan, {}, "path: gives a NaN"),
        ([0.0, 1.0], {}, "path: is no function of t"),
        (sweep, {"preview": 0.02}, "preview: 0.02 s leaves out"),
        (sweep, {"preview": -1.0}, "the preview is -1"),
    ],
)
def test_what_no_tip_can_follow_is_one_line(path, more, said):
    with pytest.raises(UsageError) as caught:
        screwgen.track(rod(), path, TIME, step=1e-2, **more)
    assert said in str(caught.value) and "\n" not in str(caught.value)


def test_a_stretched_arm_and_weak_drives_are_refused():
    stretch = lambda t: np.stack([1.2 + 0.3 * eased(t), 0 * t, 0 * t], axis=-1)  # noqa: E731
    with pytest.raises(UsageError, match="cannot move the tip in 2 directions"):
        screwgen.track(planar(), stretch, 1.0, near=[-0.5, 1.2], step=1e-2)
    narrow = rod(joint={"armature": [0.3], "limits": [{"lower": -1.0, "upper": 0.9}]})
    with pytest.raises(UsageError, match=r"goes from .* to 1; its limits are -1 and 0.9"):
        screwgen.track(narrow, sweep, TIME, step=1e-2)
    weak = rod(joint={"armature": [0.3], "limits": [{"effort": 5.0}]})
    with pytest.raises(UsageError, match=r"whose limit is 5; take more time"):
        screwgen.track(weak, sweep, TIME, step=1e-2)


def test_robots_whose_joints_alone_do_not_say_the_tip_are_refused():
    with pytest.raises(UsageError, match="loops"):
        screwgen.track(example("parallelogram"), sweep, TIME)


@pytest.mark.long
def test_ella_draws_a_circle_under_gravity():
    """Three joints, planned with order 2 and two modes per plane, played in an exact arm with four."""
    design, near = ella(2, 2), [0.2, -0.5, 0.9]
    place = design.numpy().tip_pose(np.append(near, np.zeros(design.nq - 3)))[1]

    def drawn(t):
        angle = 2 * np.pi * eased(t / 2.0)
        return place + 0.2 * np.stack([0 * angle, np.sin(angle), 1 - np.cos(angle)], axis=-1)

    gains = screwgen.PD((711.0, 5500.0, 179.0), (153.0, 204.0, 33.7), (0.0,) * 3)
    plan = screwgen.track(design, drawn, 2.0, near=near, gains=gains, step=4e-3)
    assert miss(design, plan, drawn, 2.0) < 2e-5 and miss(ella("exact", 4), plan, drawn, 2.0) < 1e-4
