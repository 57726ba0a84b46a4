"""Axes whose motion is given, beside closed forms, limits and refusals; the matrix has them beside every feature."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import arm, link, model_of, quick
from pydantic import ValidationError
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

import screwgen

LENGTH, MASS = 0.8, 0.7
CURVE = CubicSpline(np.linspace(0.0, 2.0, 21), 0.3 * np.sin(np.linspace(0.0, 4.0, 21)) ** 2)
GRAVITY = [0.0, 0.0, -9.81]


def cart(*, actuation: str, armature: float = 0.0) -> screwgen.Model:
    """A pendulum, a point at the end of a rod without mass, on a cart."""
    joint = {"axes": [{"slide": "x"}], "actuation": actuation} | ({"armature": [armature]} if armature else {})
    carriage = {"name": "cart", "joint": joint, "bodies": [{"at": "tip", "mass": 2.0}]}
    bob = {"at": "tip", "mass": MASS, "com": [0.0, 0.0, -LENGTH]}
    return model_of(arm(carriage, {"name": "bob", "joint": {"axes": ["y"]}, "bodies": [bob]}, gravity=GRAVITY))


@pytest.mark.parametrize("form", ["joint", "dae"])
@pytest.mark.parametrize("integrator, error", [("rk4", 1e-6), ("modal_midpoint", 4e-6)])
def test_a_pendulum_on_a_cart_that_is_driven(form, integrator, error):
    """`l θ'' = -g sin θ + a cos θ`, θ from the hanging position towards -x, at the exact acceleration of the spline."""

    def rates(t, y):
        return [y[1], (-9.81 * np.sin(y[0]) + CURVE(t, 2) * np.cos(y[0])) / LENGTH]

    exact = solve_ivp(rates, (0.0, 2.0), [0.4, 0.0], rtol=1e-11, atol=1e-12, t_eval=[2.0])
    run = screwgen.simulate(
        cart(actuation="motion"),
        2.0,
        1e-3,
        q0=[0.0, 0.4],
        motion={"cart.slide[0]": CURVE},
        integrator=integrator,
        form=form,
    )
    assert run.q[-1, 1] == pytest.approx(exact.y[0, -1], abs=error)
    assert np.array_equal(run.q[:, 0], CURVE(run.t)) and np.array_equal(run.v[:, 0], CURVE(run.t, 1))
    theta, rate = run.q[:-1, 1], run.v[:-1, 1]
    a = np.diff(CURVE(run.t, 1)) / 1e-3
    swing = (-9.81 * np.sin(theta) + a * np.cos(theta)) / LENGTH
    pull = (2.0 + MASS) * a - MASS * LENGTH * (swing * np.cos(theta) - rate**2 * np.sin(theta))
    assert np.abs(run.drive_effort[:-1, 0] - pull).max() < 1e-10 * np.abs(pull).max()


def test_it_is_the_limit_of_a_large_armature():
    """`J` kg·m² under `J a` N·m accelerate by `a` and something of the order of 1 / J."""
    rng, found = np.random.default_rng(3), {}
    q, v, w_ext = rng.normal(size=2), rng.normal(size=2), rng.normal(size=(2, 6))
    exact = cart(actuation="motion").numpy().forward_dynamics(q, v, [1.7, 0.2], w_ext)
    for armature in (1e4, 1e6):
        large = cart(actuation="torque", armature=armature).numpy()
        found[armature] = np.abs(large.forward_dynamics(q, v, [1.7 * armature, 0.2], w_ext)[0] - exact[0]).max()
    assert found[1e6] < 1e-4 and found[1e4] / found[1e6] == pytest.approx(100, rel=0.01)


def test_motion_and_effort_are_each_other_s_inverse():
    """What the motion takes, given as torques, makes the motion, of rigid drives and of elastic ones."""
    gear = {"rotor_inertia": 1e-3, "ratio": 20.0, "stiffness": 300.0, "damping": 1.0, "friction": {"viscous": 0.1}}
    soft = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.2, "EIy": 50.0, "EIz": 60.0}}

    boom = link("boom", axes=("z", "y"), **soft, joint={"armature": [0.3, 0.2]})
    free = model_of(arm(boom, link("fore", axes="y", **soft, joint={"drives": [gear]}), gravity=GRAVITY))

    told = _moved(free)
    rng = np.random.default_rng(1)
    for _ in range(5):
        q, v, tau = 0.3 * rng.normal(size=told.nq), rng.normal(size=told.nv), rng.normal(size=3)
        w_ext = rng.normal(size=(2, 6))
        vdot, wrench = told.numpy().forward_dynamics(q, v, tau, w_ext)
        effort = told.numpy().drive_effort(q, v, tau, w_ext)
        again, borne = free.numpy().forward_dynamics(q, v, effort, w_ext)
        assert vdot[[0, 3]] == pytest.approx(tau[[0, 2]], abs=1e-15) and effort[1] == tau[1]
        force = free.numpy().inverse_dynamics(q, v, vdot, w_ext)
        assert np.abs(force - [*effort[:2], 0.0, effort[2], *np.zeros(4)]).max() < 1e-12 * np.abs(force).max()
        scale = np.abs(free.numpy().mass_matrix(q)).max() / np.abs(np.diag(free.numpy().mass_matrix(q))).min()
        assert np.abs(again - vdot).max() < 1e-13 * scale * np.abs(vdot).max()
        assert np.abs(borne - wrench).max() < 1e-12 * scale * np.abs(wrench).max()


def _moved(free: screwgen.Model) -> screwgen.Model:
    """The first axis of the boom and the rotor of the fore are told where to go."""
    boom, fore = free.robot.links
    boom = boom.model_copy(update={"joint": boom.joint.model_copy(update={"actuation": ("motion", "torque")})})
    fore = fore.model_copy(update={"joint": fore.joint.model_copy(update={"actuation": ("motion",)})})
    return screwgen.derive(free.robot.model_copy(update={"links": (boom, fore)}))


def test_names_and_units_and_what_holds_it():
    model = cart(actuation="motion")
    assert model.tau_names == ["cart.acceleration[0]", "bob.torque[0]"]
    rest = screwgen.equilibrium(model)
    assert rest.held_joints == ("cart.slide[0]",) and not rest.tau.any()
    weighed = screwgen.equilibrium(model, parameters={"gravity[0]": 3.0})
    assert weighed.effort[0] == pytest.approx(-3.0 * (2.0 + MASS), rel=1e-9) and weighed.tau[0] == 0


def test_two_couplings_of_axes_one_of_which_is_driven():
    """A wheel of inertia that follows a driven axis takes its share of the effort."""
    wheel = {"at": "tip", "mass": 1.0, "inertia": [0.2, 0.2, 0.2, 0.0, 0.0, 0.0]}
    robot = arm(
        {"name": "pinion", "bodies": [wheel], "joint": {"axes": ["z"], "actuation": "motion"}},
        {"name": "gear", "parent": "world", "bodies": [wheel], "joint": {"axes": ["z"], "mount": {"xyz": [1.0, 0, 0]}}},
        gravity=[0.0, 0.0, 0.0],
    )
    robot["couplings"] = [{"axis": "gear.joint[0]", "of": "pinion.joint[0]", "ratio": -0.5}]
    model, rest = model_of(robot), np.zeros(2)
    vdot, _ = model.numpy().forward_dynamics(rest, rest, [3.0, 0.0], None)
    assert vdot == pytest.approx([3.0, -1.5], abs=1e-13)
    assert model.numpy().drive_effort(rest, rest, [3.0, 0.0], None)[0] == pytest.approx(0.2 * 3.0 + 0.25 * 0.2 * 3.0)
    assert quick(model).forward_dynamics(rest, rest, [3.0, 0.0])[0] == pytest.approx([3.0, -1.5], abs=1e-13)


@pytest.mark.parametrize(
    "joint, said",
    [
        ({"actuation": "speed"}, 'is "speed"; it must be "torque" or "motion"'),
        ({"actuation": ["motion", "motion"]}, "has length 2; it must hold one word per axis, 1"),
        (
            {"actuation": "motion", "drives": [{"transmission": {"base": 0.5, "crank": 0.2, "angle": 1.1}}]},
            "of an axis that a cylinder drives",
        ),
    ],
)
def test_what_a_file_may_not_say(joint, said):
    with pytest.raises(ValidationError) as caught:
        model_of(arm(link("a", axes="z", joint=joint)))
    assert said in caught.value.errors()[0]["msg"]


@pytest.mark.parametrize(
    "motion, said",
    [
        ({"bob.joint[0]": CURVE}, "there is no coordinate 'bob.joint[0]'"),
        ({"cart.slide[0]": lambda t: [t, t, t]}, "cart.slide[0] gives 3 numbers"),
        ({"cart.slide[0]": lambda t: [np.nan, t]}, "gives a NaN"),
        ({"cart.slide[0]": lambda t: [np.sin(9 * t), 0.0]}, "gives the rate 0 at t = 0.0011 s, its coordinate has 9"),
        ({"cart.slide[0]": lambda t: [t]}, "cart.slide[0] gives 1 number"),
        ({"cart.slide[0]": 0.3}, "is no function of t"),
        ({"cart.slide[0]": CubicSpline([0.0, 0.05], [0.0, 1.0])}, "from 0 to 0.05 s; the run goes from 0 to 0.1 s"),
    ],
)
def test_what_a_run_may_not_be_told(motion, said):
    with pytest.raises(screwgen.UsageError, match="motion") as caught:
        screwgen.simulate(cart(actuation="motion"), 0.1, 1e-2, motion=motion)
    assert said in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize("loaded", [False, True])
def test_free_joints_vibrate_beside_axes_whose_motion_is_given(loaded):
    """A given axis stands, and of an elastic drive its rotor: as in an arm with a weld there, and with a spring."""
    gear = {"rotor_inertia": 1e-3, "ratio": 20.0, "stiffness": 300.0}
    soft = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.2, "EIy": 500.0, "EIz": 600.0}}

    def robot(root: dict, elbow: dict) -> screwgen.Model:
        hand = link("hand", 0.3, axes="y", bodies=[{"at": "tip", "mass": 0.4}])
        hand["joint"] |= {"stiffness": [40.0], "drives": [gear]}
        root, fore = link("root", axes="", **soft, joint=root), link("fore", axes="y", **soft, joint=elbow)
        return model_of(arm(root, fore, hand, gravity=GRAVITY))

    told = robot({"axes": ["z"], "actuation": "motion"}, {"drives": [gear], "actuation": "motion"})
    held = robot({"axes": [], "mount": {"rpy": [0.0, 0.0, 0.2]}}, {"stiffness": [300.0]})
    found = screwgen.natural_frequencies(told, [0.2, -0.4, 0.3], "free", loaded=loaded)
    expected = screwgen.natural_frequencies(held, [-0.4, 0.3], "free", loaded=loaded)
    assert found == pytest.approx(expected, rel=1e-9) and len(found) == told.nv - 2
