"""A base whose motion is given, beside carts of axes, turned gravity, closed forms; the matrix has it beside others."""

from __future__ import annotations

import numpy as np
import pytest
from floating_robots import SATELLITE, start
from helpers import arm, link, model_of, quick, relative, rotation_of
from pydantic import ValidationError
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

import screwgen
from screwgen.studies.convergence import convergence

SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.2, "EIy": 50.0, "EIz": 60.0}}
BODY = {"at": "base", "mass": 0.7, "com": [0.1, -0.2, 0.3], "inertia": [0.1, 0.1, 0.1, 0.0, 0.0, 0.0]}
TIP = {"at": "tip", "mass": 0.5, "com": [0.1, 0.02, 0.0]}
TIMES = np.linspace(0.0, 1.0, 21)
WAVES = [0.3 * np.sin(3 * TIMES), 0.2 * np.cos(2 * TIMES), 0.1 * TIMES**2, 0.4 * np.sin(2 * TIMES), 0.3 * TIMES]
SEA = CubicSpline(TIMES, np.array([*WAVES, 0.5 * np.sin(TIMES + 1)]).T)


def carried(first: list[dict], **more) -> screwgen.Model:
    """An arm of two flexible links on the last of some."""
    fore = link("fore", 0.6, "y", bodies=[TIP], **SOFT)
    return model_of(arm(*first, link("boom", 0.9, ("z", "y"), parent=first[-1]["name"], **SOFT), fore) | more)


def moving(**hull) -> screwgen.Model:
    return carried([{"name": "hull", "joint": {"axes": []}, "bodies": [BODY]} | hull], base="moving")


def state(model: screwgen.Model, seed: int = 2) -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(seed)
    q, v = start(model, 1.0)
    return q, v, rng.normal(size=model.n_tau), rng.normal(size=(model.n_links, 6))


def euler(t: float) -> tuple[np.ndarray, np.ndarray]:
    """Place and quaternion, with rates, of the motion of a cart that slides and turns about z, y, x."""
    at, rate = SEA(t), SEA(t, 1)
    turns = [Rotation.from_euler("ZYX", at[3:] + s * 1e-6 * rate[3:]).as_quat(scalar_first=True) for s in (-1, 0, 1)]
    turns = [x if x @ turns[1] > 0 else -x for x in turns]
    return np.append(at[:3], turns[1]), np.append(rate[:3], (turns[2] - turns[0]) / 2e-6)


def test_a_run_is_that_on_a_cart_of_slides_and_hinges():
    """Over a step the one accelerates evenly in its own axes, the other along its axes: they differ by order h²."""
    given = {"actuation": ["motion"] * 3}
    slides = {"name": "cart", "bodies": [BODY], "joint": {"axes": [{"slide": x} for x in "xyz"]} | given}
    cart = carried([slides, {"name": "gimbal", "bodies": [BODY], "joint": {"axes": ["z", "y", "x"]} | given}])
    names = [*(f"cart.slide[{k}]" for k in range(3)), *(f"gimbal.joint[{k}]" for k in range(3))]
    axes = {name: lambda t, d=0, k=k: SEA(t, d)[k] for k, name in enumerate(names)}
    off = {}
    for h in (2e-3, 1e-3):
        run = screwgen.simulate(moving(), 1.0, h, motion={"base": euler}, integrator="rk4")
        beside = screwgen.simulate(cart, 1.0, h, motion=axes, integrator="rk4")
        off[h] = np.abs(run.q[-1, 7:] - beside.q[-1, 6:]).max()
        assert np.array_equal(run.q[:, :3], SEA(run.t)[:, :3])
        assert np.abs(run.tip_position - beside.tip_position).max() < 0.2 * h**2
    assert off[1e-3] < 2e-7 and off[2e-3] / off[1e-3] == pytest.approx(4.0, rel=0.02)


@pytest.mark.parametrize("seed", range(3))
def test_in_a_state_it_is_a_cart_of_slides_and_hinges(seed):
    """Where both move and accelerate alike: accelerations of all others, wrenches, and what the base takes."""
    given, rng = {"actuation": ["motion"] * 3}, np.random.default_rng(seed)
    slides = {"name": "cart", "bodies": [BODY | {"mass": 0.0, "inertia": None}]}
    slides["joint"] = {"axes": [{"slide": x} for x in "xyz"]} | given
    cart = carried([slides, {"name": "gimbal", "bodies": [BODY], "joint": {"axes": ["z", "y", "x"]} | given}])
    x, v, a = rng.uniform(-1, 1, 6), rng.normal(size=6), rng.normal(size=6)
    hull, (q, w, tau, w_ext) = moving(), state(moving(), seed)

    def turned(t: float) -> tuple[Rotation, np.ndarray]:
        """Attitude at a time, and the twist in its axes."""
        at, rate = x + t * v + t * t / 2 * a, v + t * a
        z, y, roll = (Rotation.from_euler(axis, angle) for axis, angle in zip("ZYX", at[3:], strict=True))
        omega = roll.inv().apply(np.add(y.inv().apply([0.0, 0.0, rate[3]]), [0.0, rate[4], 0.0]))
        omega[0] += rate[5]
        return z * y * roll, np.append(omega, (z * y * roll).inv().apply(rate[:3]))

    h, (turn, w[:6]) = 1e-3, turned(0.0)
    q[:7] = np.append(x[:3], turn.as_quat(scalar_first=True))
    after = [turned(k * h)[1] for k in (-2, -1, 1, 2)]
    tau[3:] = (8 * (after[2] - after[1]) - (after[3] - after[0])) / (12 * h)
    vdot, wrench = hull.numpy().forward_dynamics(q, w, tau, w_ext)
    beside = np.append(x, q[7:]), np.append(v, w[6:]), np.append(a, tau[:3])
    expected = cart.numpy().forward_dynamics(*beside, np.vstack([np.zeros(6), w_ext]))
    assert relative(vdot[6:], expected[0][6:]) < 1e-11 and relative(wrench[1:], expected[1][2:]) < 1e-11
    assert relative(hull.numpy().drive_effort(q, w, tau, w_ext)[3:], expected[1][1]) < 1e-11


@pytest.mark.parametrize("form", ["forward_dynamics", "dae_forward_dynamics"])
def test_at_rest_it_turns_gravity(form):
    """And steady acceleration is less of it: as a passenger of a lift knows."""
    model, fixed = moving(), carried([{"name": "hull", "joint": {"axes": []}, "bodies": [BODY]}])
    (q, v, tau, w_ext), lift = state(model), np.array([0.7, -1.3, 2.1])
    v[:6] = tau[3:9] = 0.0
    tau[6:9] = rotation_of(q[3:7]).T @ lift
    fall = rotation_of(q[3:7]).T @ (np.array(model.robot.gravity) - lift)
    p = fixed.chain.parameters.vector({f"gravity[{k}]": x for k, x in enumerate(fall)})
    vdot, wrench = getattr(model.numpy(), form)(q, v, tau, w_ext)
    expected = getattr(fixed.numpy(p), form)(q[7:], v[6:], tau[:3], w_ext)
    assert relative(vdot[6:], expected[0]) < 1e-13 and np.array_equal(vdot[:6], tau[3:])
    assert relative(wrench, expected[1]) < 1e-13
    assert relative(model.numpy().drive_effort(q, v, tau, w_ext)[3:], expected[1][0]) < 1e-12


@pytest.mark.parametrize("form", ["forward_dynamics", "dae_forward_dynamics"])
def test_what_a_base_does_afloat_takes_nothing(form):
    """The accelerations of a satellite, given, need no wrench and leave all others as they are."""
    afloat = model_of(SATELLITE)
    model = model_of(SATELLITE | {"base": "moving"})
    q, v, tau, w_ext = state(afloat)
    vdot, wrench = getattr(afloat.numpy(), form)(q, v, tau, w_ext)
    found = getattr(model.numpy(), form)(q, v, np.append(tau, vdot[:6]), w_ext)
    assert relative(found[0], vdot) < 1e-13 and relative(found[1], wrench) < 1e-12
    borne = model.numpy().drive_effort(q, v, np.append(tau, vdot[:6]), w_ext)
    assert np.abs(borne[4:]).max() < 1e-12 * np.abs(wrench).max()


def test_a_flexible_base_whose_frame_is_not_at_its_end():
    """All forms agree on the wrench at the origin of its frame, which is the effort; its slopes equal differences."""
    hull = {"length": 0.8, "frame_at": 0.3, **SOFT}
    model = moving(**hull)
    q, v, tau, w_ext = state(model)
    compiled, f = quick(model, derivatives=True), model.numpy()
    vdot, wrench = f.forward_dynamics(q, v, tau, w_ext)
    for found in (f.dae_forward_dynamics(q, v, tau, w_ext), compiled.forward_dynamics(q, v, tau, w_ext)):
        assert relative(found[0], vdot) < 1e-12 and relative(found[1], wrench) < 1e-12
    effort = f.drive_effort(q, v, tau, w_ext)
    assert relative(effort[3:], wrench[0]) < 1e-12 and np.array_equal(effort[:3], tau[:3])
    slopes, h = compiled.linearise_wrenches(q, v, tau, w_ext), 1e-6
    by_v = [(f.forward_dynamics(q, v + s * h * e, tau, w_ext)[1]) for e in np.eye(model.nv) for s in (-1, 1)]
    by_v = np.array([(b - a).ravel() / (2 * h) for a, b in zip(by_v[::2], by_v[1::2], strict=True)]).T
    assert relative(slopes[2].reshape(by_v.shape), by_v) < 1e-6


def test_a_pendulum_on_a_turntable():
    """`cos θ = g / (ω² l)`: it stands out at rest beside the table that turns."""
    rate, length = 5.0, 0.8
    bob = {"name": "bob", "joint": {"axes": ["y"]}, "bodies": [{"at": "tip", "mass": 2.0, "com": [0.0, 0.0, -length]}]}
    table = {"name": "table", "joint": {"axes": []}, "bodies": [BODY]}
    model = model_of(arm(table, bob, gravity=[0.0, 0.0, -9.81]) | {"base": "moving"})
    q, v = np.array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, np.arccos(9.81 / (rate**2 * length))]), np.zeros(7)
    v[2] = rate
    assert abs(model.numpy().forward_dynamics(q, v, np.zeros(7), None)[0][6]) < 1e-13
    turned = lambda t: ([0.0, 0.0, 0.0, 0.0, 0.0, rate * t], [0.0, 0.0, 0.0, 0.0, 0.0, rate])  # noqa: E731
    run = screwgen.simulate(model, 2.0, 1e-2, q0=q, motion={"base": turned}, integrator="rk4")
    assert np.abs(run.q[:, 7] - q[7]).max() < 1e-12 and (np.linalg.norm(run.q[:, 3:7], axis=1) - 1).max() < 1e-15
    assert rotation_of(run.q[-1, 3:7]) == pytest.approx(Rotation.from_rotvec([0, 0, 2 * rate]).as_matrix(), abs=1e-14)


def test_runs_by_all_that_steps():
    """In C, in Python, of the DAE form; quaternions and rotation vectors; it goes on where nothing is said."""
    model = moving()
    how = {"duration": 0.05, "step": 1e-3, "integrator": "rk4"}
    run = screwgen.simulate(model, motion={"base": SEA}, **how)
    turns = Rotation.from_rotvec(SEA(run.t)[:, 3:]).as_matrix()
    assert np.abs([rotation_of(q[3:7]) - R for q, R in zip(run.q, turns, strict=True)]).max() < 1e-14
    for more in ({"backend": "casadi"}, {"form": "dae"}):
        other = screwgen.simulate(model, motion={"base": SEA}, **how | more)
        assert np.abs(other.q - run.q).max() < 1e-11
    free = screwgen.simulate(model, controller=[0.0] * 3 + [0.0] * 5 + [2.0], **how)
    assert free.q[-1, 2] == pytest.approx(2.0 * 0.05**2 / 2, rel=1e-12)


def test_at_rest_wherever_it_stands():
    model = moving(frame_at=0.2, length=0.5, section={"rhoA": 2.0})
    q, *_ = state(model)
    rest = screwgen.equilibrium(model, np.append(q[:10], np.zeros(4)), hold=True)
    vdot, wrench = model.numpy().forward_dynamics(rest.q, np.zeros(model.nv), rest.tau, None)
    assert np.abs(vdot).max() < 1e-9 and np.array_equal(rest.q[:7], q[:7]) and not rest.tau[3:].any()
    assert relative(rest.wrench, wrench) < 1e-9 and relative(rest.effort[3:], wrench[0]) < 1e-9
    assert relative(rest.tip_position, model.numpy().tip_pose(rest.q)[1]) < 1e-12
    assert rest.q_names == tuple(model.q_names)
    fixed = carried([{"name": "hull", "joint": {"axes": []}, "bodies": [BODY]}])
    fall = dict(zip((f"gravity[{k}]" for k in range(3)), rotation_of(q[3:7]).T @ model.robot.gravity, strict=True))
    how = {"loaded": True}
    found = screwgen.natural_frequencies(model, np.append(q[:10], np.zeros(4)), **how)
    assert relative(found, screwgen.natural_frequencies(fixed, q[7:10], parameters=fall, **how)) < 1e-9
    assert screwgen.mode_shapes(model, joints="free").shapes.shape[0] == model.nv
    more, of_fixed = (
        convergence(*x, **how) for x in ((model, np.append(q[:10], np.zeros(4))), (fixed, q[7:10], "locked", fall))
    )
    assert len(more.total) == len(found) and relative(more.total, of_fixed.total) < 1e-6
    with pytest.raises(screwgen.UsageError, match="accelerates the base"):
        screwgen.equilibrium(model, q, np.eye(model.n_tau)[4])


def test_names_and_the_file(tmp_path):
    model = moving()
    (tmp_path / "again.toml").write_text(screwgen.dump(model.robot), encoding="utf-8")
    assert screwgen.load(tmp_path / "again.toml") == model.robot and 'base = "moving"' in screwgen.dump(model.robot)
    assert model.tau_names[3:] == [f"base.twist_rate[{k}]" for k in range(6)] and model.q_names[0] == "base.x"
    run = screwgen.simulate(model, 0.01, 1e-3)
    assert {"base.twist_effort[5]", "base.twist_power[0]"} <= set(run.columns)


@pytest.mark.parametrize("joint", [{"axes": ["z"]}, {"axes": [], "mount": {"xyz": [1.0, 0.0, 0.0]}}])
def test_what_a_file_may_not_say(joint):
    with pytest.raises(ValidationError) as caught:
        moving(joint=joint)
    message = caught.value.errors()[0]["msg"]
    assert "moving" in message and len(message.splitlines()) == 1


@pytest.mark.parametrize(
    "curve, said",
    [
        (lambda t: [0.0] * 8, "base gives 8 numbers; give a spline"),
        (lambda t: [0.0] * 14, "a quaternion of zeros"),
        (lambda t: [np.nan] * 12, "gives a NaN"),
    ],
)
def test_what_a_run_may_not_be_told(curve, said):
    with pytest.raises(screwgen.UsageError, match="motion") as caught:
        screwgen.simulate(moving(), 0.1, 1e-2, motion={"base": curve})
    assert said in str(caught.value) and "\n" not in str(caught.value)
    with pytest.raises(screwgen.UsageError, match="there is no coordinate 'base'"):
        screwgen.simulate(model_of(SATELLITE), 0.1, 1e-2, motion={"base": SEA})
