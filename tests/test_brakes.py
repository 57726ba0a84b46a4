"""Brakes beside welds, closed forms and refusals; the matrix has half-closed ones beside every feature."""

from __future__ import annotations

import copy

import numpy as np
import pytest
from helpers import arm, link, model_of, quick, relative
from pydantic import ValidationError

import screwgen
from screwgen.integrators import METHODS

SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.2, "EIy": 50.0, "EIz": 60.0}}
GEAR = {"rotor_inertia": 1e-3, "ratio": 20.0, "stiffness": 300.0, "damping": 1.0, "friction": {"viscous": 0.1}}
CYLINDER = {"transmission": {"base": 0.5, "crank": 0.2, "angle": 1.1}}
BODY = {"at": "tip", "mass": 0.8, "com": [0.0, 0.1, 0.05], "inertia": [0.02, 0.03, 0.04, 0.0, 0.001, 0.0]}


def three(*, held: str = "", drive: dict | None = None, angle: float = 0.4) -> dict:
    """Three links, the second of which has one axis: free, with a ``brake``, or welded at an angle."""
    joint: dict = (
        {"axes": ["y"]} | ({"drives": [drive]} if drive else {}) | ({"brake": True} if held == "brake" else {})
    )
    if held == "weld":
        joint = {"axes": [], "mount": {"rpy": [0.0, angle, 0.0]}}
    first = link("boom", 0.8, ("z", "x"), joint={"armature": [0.3, 0.2]}, **SOFT)
    return arm(first, {**link("fore", 0.5, (), **SOFT), "joint": joint}, link("hand", 0.3, ("y",), bodies=[BODY]))


@pytest.mark.parametrize("form", ["forward_dynamics", "dae_forward_dynamics"])
@pytest.mark.parametrize("drive", [None, CYLINDER], ids=["hinge", "cylinder"])
def test_a_closed_brake_is_a_weld(form, drive):
    """Accelerations of all others, and all joint wrenches; a drive that works against it changes nothing."""
    braked, welded = model_of(three(held="brake", drive=drive)), model_of(three(held="weld"))
    rng = np.random.default_rng(4)
    q, v, w_ext = 0.3 * rng.normal(size=8), rng.normal(size=8), rng.normal(size=(3, 6))
    q[2], v[2], others = 0.4, 0.0, np.arange(8) != 2
    expected = getattr(welded.numpy(), form)(q[others], v[others], [1.0, -2.0, 0.3], w_ext)
    for model in (braked.numpy(), quick(braked)) if form == "forward_dynamics" else (braked.numpy(),):
        vdot, wrench = getattr(model, form)(q, v, [1.0, -2.0, 7.0, 0.3, 1.0], w_ext)
        assert abs(vdot[2]) < 1e-13 * np.abs(vdot).max() and relative(vdot[others], expected[0]) < 1e-13
        assert relative(wrench, expected[1]) < 1e-13


def test_each_axis_of_a_joint_by_itself():
    """Where another one of the joint is closed, and where all are."""
    both = model_of(arm(link("boom", axes=("z", "y"), joint={"brake": [True, True]}, **SOFT), link("hand", axes="x")))
    one = {k: model_of(arm(link("boom", axes=(axis,), **SOFT), link("hand", axes="x"))) for k, axis in enumerate("zy")}
    rng = np.random.default_rng(8)
    q, v, w_ext = 0.3 * rng.normal(size=5), rng.normal(size=5), rng.normal(size=(2, 6))
    for free, alone in one.items():
        q[1 - free] = v[1 - free] = 0.0
        kept = np.arange(5) != 1 - free
        expected, _ = alone.numpy().forward_dynamics(q[kept], v[kept], [0.7, 0.2], w_ext)
        vdot, _ = both.numpy().forward_dynamics(q, v, [0.7, 0.7, 0.2, float(free == 1), float(free == 0)], w_ext)
        assert vdot[1 - free] == 0 and relative(vdot[kept], expected) < 1e-13
        q[1 - free], v[1 - free] = rng.normal(size=2)
    vdot, _ = both.numpy().forward_dynamics(q, 0 * v, [0.7, 0.7, 0.2, 1.0, 1.0], w_ext)
    assert not vdot[:2].any() and vdot[2:].all()


def test_an_open_brake_changes_nothing():
    """And the rotor of an elastic drive is what its brake holds: the arm swings on the gear."""
    free, braked = model_of(three(drive=GEAR)), model_of(three(held="brake", drive=GEAR))
    rng = np.random.default_rng(5)
    q, v, w_ext = 0.3 * rng.normal(size=9), rng.normal(size=9), rng.normal(size=(3, 6))
    tau = [1.0, -2.0, 0.1, 0.3]
    expected = free.numpy().forward_dynamics(q, v, tau, w_ext)
    for found in (braked.numpy(), quick(braked)):
        for value, wanted in zip(found.forward_dynamics(q, v, [*tau, 0.0], w_ext), expected, strict=True):
            assert relative(value, wanted) < 1e-14
    v[4] = 0.0
    vdot, _ = braked.numpy().forward_dynamics(q, v, [*tau, 1.0], w_ext)
    assert vdot[4] == 0 and abs(vdot[2]) > 1


J, LEVER, MASS = 0.9, 0.6, 2.5


def wheel(brake: object = True, **joint) -> screwgen.Model:
    """A bob on an arm without mass that turns about y: `J` about the axis."""
    body = {"at": "tip", "mass": MASS, "com": [LEVER, 0.0, 0.0], "inertia": [J - MASS * LEVER**2] * 3 + [0.0] * 3}
    return model_of(arm({"name": "arm", "joint": {"axes": ["y"], "brake": brake} | joint, "bodies": [body]}))


@pytest.mark.parametrize("closed", [0.0, 0.29, 0.8, 1.0])
def test_in_between_it_is_a_flywheel(closed):
    """`J_b (1 / (1 - b)² - 1)` on the axis, and a share of what stops it; beyond the ends it is at them."""
    model, (tau, rate) = wheel({"inertia": 0.7, "time": 0.3}), (3.0, 1.7)
    weight, stop = MASS * 9.81 * LEVER, -closed * rate / 0.3
    firm = 0.7 / (1 - closed) ** 2 - 0.7 if closed < 1 else np.inf
    expected = stop if closed == 1 else (tau + weight + firm * stop) / (J + firm)
    for said in {0.0: (0.0, -0.4), 1.0: (1.0, 3.0)}.get(closed, (closed,)):
        assert model.numpy().forward_dynamics([0.0], [rate], [tau, said], None)[0][0] == pytest.approx(
            expected, rel=1e-13
        )
    effort = model.numpy().drive_effort([0.0], [rate], [tau, closed], None)
    assert effort == pytest.approx([tau, J * expected - tau - weight], rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("integrator", ["rk4", "modal_midpoint", "modal_implicit"])
def test_one_that_closes_stops_its_axis_and_holds_it(integrator):
    """`exp(-t / T)`; what it takes is the kinetic energy; then it bears the weight, to the last digit."""
    turning = wheel({"time": 0.02}).robot.model_copy(update={"gravity": (0.0, 0.0, 0.0)})
    run = screwgen.simulate(screwgen.derive(turning), 0.2, 1e-4, v0=[2.0], controller=[0.0, 1.0], integrator=integrator)
    assert run.v[:, 0] == pytest.approx(
        2.0 * np.exp(-run.t / 0.02), abs=0.011 if integrator == "modal_implicit" else 1e-4
    )
    if integrator == "rk4":
        assert run.drive_effort[:, 1] == pytest.approx(-J * run.v[:, 0] / 0.02, abs=1e-9)
        assert np.trapezoid(run.effort_power[:, 1], run.t) == pytest.approx(-J * 2.0**2 / 2, rel=1e-4)
    held = screwgen.simulate(wheel(), 0.1, 1e-3, q0=[0.3], controller=[5.0, 1.0], integrator=integrator)
    assert not held.v.any() and (held.q == 0.3).all()
    assert held.drive_effort[:, 1] == pytest.approx(-MASS * 9.81 * LEVER * np.cos(0.3) - 5.0, rel=1e-13)


@pytest.mark.parametrize("closed", [[1.0, 0.0, 1.0], [0.3, 1.0, 0.999]])
def test_derivatives_where_brakes_are_closed(closed):
    """In NumPy and in C, beside differences to inside of the range, and of every step."""
    first = link("boom", axes=("z", "y"), joint={"armature": [0.3, 0.2], "brake": [True, {"inertia": 0.4}]}, **SOFT)
    fore = link("fore", axes="y", joint={"drives": [GEAR], "brake": {"inertia": 2e-3}}, **SOFT)
    model, rng = model_of(arm(first, fore)), np.random.default_rng(6)
    q, v, w_ext = 0.3 * rng.normal(size=model.nq), rng.normal(size=model.nv), rng.normal(size=(2, 6))
    tau = np.array([1.0, -2.0, 0.1, *closed])
    compiled, exact = quick(model, derivatives=True), model.numpy().derivatives(q, v, tau, w_ext)
    assert max(map(relative, compiled.linearise(q, v, tau, w_ext)[1:], exact)) < 1e-11
    accelerate = lambda q, v, tau: model.numpy().forward_dynamics(q, v, tau, w_ext)[0]  # noqa: E731
    for found, wanted in zip(exact, sloped(accelerate, q, v, tau), strict=True):
        assert relative(found, wanted) < 1e-6
    for method in METHODS:
        step = lambda q, v, tau, m=method: np.concatenate(compiled.step(q, v, tau, w_ext, 2e-3, m))  # noqa: E731
        _, _, A, B = compiled.step_derivatives(q, v, tau, w_ext, 2e-3, method)
        assert relative(np.hstack([A, B]), np.hstack(sloped(step, q, v, tau))) < 1e-5, method


def sloped(f, *at, h: float = 1e-6) -> list[np.ndarray]:
    """Differences of second order; of brakes to the inside of their range."""
    out = []
    for k, x in enumerate(at):
        columns = []
        for j in range(len(x)):
            one = (-1.0 if x[j] > 0.5 else 1.0) if k == 2 and j >= len(x) - 3 else 0.0
            there = [
                f(*at[:k], x + s * h * np.eye(len(x))[j], *at[k + 1 :]) for s in ((0, one, 2 * one) if one else (-1, 1))
            ]
            three = -3 * there[0] + 4 * there[1] - there[2] if one else there[1] - there[0]
            columns.append(three / (2 * h * (one or 1.0)))
        out.append(np.array(columns).T)
    return out


def test_names_units_and_the_file(tmp_path):
    model = wheel({"time": 0.05})
    assert model.tau_names == ["arm.torque[0]", "arm.brake[0]"]
    assert {"arm.joint.brake[0].inertia", "arm.joint.brake[0].time"} < set(model.parameter_names)
    slide = link("cart", axes=[{"slide": "x"}, "y"], joint={"brake": [True, {"time": 0.05, "inertia": 3.0}]})
    robot = model_of(arm(slide)).robot
    (tmp_path / "again.toml").write_text(screwgen.dump(robot), encoding="utf-8")
    assert screwgen.load(tmp_path / "again.toml") == robot and "brake = [true, {" in screwgen.dump(robot)
    assert screwgen.derive(robot).tau_names[2:] == ["cart.brake[0]", "cart.brake[1]"]
    run = screwgen.simulate(wheel(), 0.01, 1e-3, controller=[0.0, 1.0])
    assert {"arm.brake_effort[0]", "arm.brake_power[0]"} <= set(run.columns)


@pytest.mark.parametrize(
    "joint, said",
    [
        ({"brake": 1.0}, "must be an array of true, false or tables"),
        ({"brake": [0.5]}, "must be true, false or a table"),
        ({"brake": [True, False]}, "has length 2; it must hold one entry per axis, 1"),
        ({"brake": {"time": 0.0}}, "must be > 0"),
        ({"brake": True, "actuation": "motion"}, 'of an axis with actuation "motion"'),
        ({"brake": True, "drives": [GEAR | CYLINDER]}, "a cylinder with an elastic gear drives"),
    ],
)
def test_what_a_file_may_not_say(joint, said):
    with pytest.raises((ValidationError, screwgen.RobotFileError)) as caught:
        model_of(copy.deepcopy(arm(link("a", axes="z", joint=joint))))
    message = caught.value.errors()[0]["msg"] if isinstance(caught.value, ValidationError) else str(caught.value)
    assert said in message and len(message.splitlines()) == 1


def test_a_linkage_whose_brakes_are_all_closed():
    """A parallelogram: one brake holds it as two do, and where all are closed its rows have nothing to move."""
    links = [link(name, 1.0, "y", joint={"brake": True}) for name in ("left", "top", "right")]
    links[2] |= {"parent": "world", "joint": links[2]["joint"] | {"mount": {"xyz": [1.0, 0.0, 0.0]}}}
    robot = arm(*links) | {"loops": [{"between": ["top.tip", "right.tip"], "joint": {"axes": ["x", "y", "z"]}}]}
    model, q = model_of(robot), np.array([-1.0, 1.0, -1.0])
    accelerate = lambda *closed: model.numpy().forward_dynamics(q, np.zeros(3), [0.0, 0.0, 0.0, *closed], None)[0]  # noqa: E731
    free = accelerate(0.0, 0.0, 0.0)
    assert free == pytest.approx([free[0], -free[0], free[0]], rel=1e-12) and free[0] > 1
    assert np.abs(accelerate(0.0, 1.0, 0.0)).max() < 1e-13
    with pytest.raises(screwgen.SingularError, match="open a brake"):
        accelerate(1.0, 1.0, 1.0)


def test_an_arm_at_rest_on_its_brakes():
    """What is held has its effort; without it no search finds where a closed brake holds."""
    model, q = model_of(three(held="brake")), [0.1, 0.2, 0.3, 0.4]
    tau = [0.0, 0.0, 0.0, 0.0, 1.0]
    held, open_ = (screwgen.equilibrium(model, tau=x, q=q, hold="all") for x in (tau, None))
    assert np.array_equal(held.q, open_.q) and np.array_equal(held.tau[:4], open_.tau[:4])
    with pytest.raises(screwgen.UsageError, match=r"fore\.brake\[0\] is closed and holds its axis anywhere; hold fore"):
        screwgen.equilibrium(model, tau=tau)


def test_a_step_too_long_for_a_brake_is_told():
    model = model_of(three(held="brake"))
    with pytest.warns(UserWarning, match=r"fore\.joint\.brake\[0\]\.time = 0\.02 s: .* needs steps below 0\.04 s"):
        screwgen.simulate(model, 0.05, 0.05)
