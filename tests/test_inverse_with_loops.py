"""Inverse dynamics with closed loops: efforts by virtual power, and the least where drives are more than freedoms."""

import numpy as np
import pytest
from helpers import arm, link, model_of, relative

from screwgen import assemble
from screwgen.algorithms.loop_loads import sharing
from screwgen.backends.numpy.closing import moving
from screwgen.backends.numpy.python import compiled

DRIVE = {"drives": [{"ratio": 10.0, "rotor_inertia": 1e-4}]}


def four_bar(driven: tuple[str, ...], **coupler) -> dict:
    """In the plane x-z, with a load on the coupler and drives on the named links."""
    drive = lambda name: {"joint": DRIVE} if name in driven else {}  # noqa: E731
    links = [
        link("crank", 0.3, "y", 2.0, **drive("crank")),
        link("coupler", 0.9, "y", 1.5, bodies=[{"at": "tip", "mass": 2.0}], **drive("coupler"), **coupler),
        link("rocker", 0.6, "y", 1.8, parent="world", joint={"mount": {"xyz": [0.8, 0.0, 0.0]}}),
    ]
    loop = {"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["y"]}}
    return arm(*links) | {"loops": [loop], "gravity": [0.0, 0.0, -9.81]}


def motion(model, seed: int) -> tuple[np.ndarray, ...]:
    """A closed posture, and rates and accelerations that keep it closed, by differences of the rates' directions."""
    rng, f = np.random.default_rng(seed), model.numpy()
    q = assemble(model, [rng.uniform(0.1, 0.8), -0.4, -1.5])
    along = lambda q: moving(f, q, np.eye(model.nv)[0] * 0.7)  # noqa: E731
    v, h = along(q), 1e-5
    ahead, back = (along(assemble(model, q + sign * h * v)) for sign in (1, -1))
    return q, v, (ahead - back) / (2 * h), rng.normal(size=(3, 6))


@pytest.mark.parametrize("seed", range(5))
def test_one_drive_gives_all_the_power_that_the_motion_takes(seed):
    """The loop gives none: f v of the open tree is the drive's torque times its rate."""
    model = model_of(four_bar(("crank",)))
    q, v, vdot, w_ext = motion(model, seed)
    force, wrenches = model.numpy().inverse_dynamics_with_loops(q, v, vdot, w_ext)
    needed = model.numpy().inverse_dynamics(q, v, vdot, w_ext)
    assert np.abs(force[1:]).max() < 1e-10 * np.abs(needed).max()
    assert force[0] * v[0] == pytest.approx(needed @ v, rel=1e-9)
    tau = np.array([force[0], 0.0, 0.0])
    found = model.numpy().forward_dynamics(q, v, tau, w_ext)[0]
    assert relative(found, vdot) < 1e-6  # as far as the differences go
    assert relative(model.numpy().inverse_dynamics(q, v, vdot, w_ext + wrenches), force) < 1e-10


def test_two_drives_share_with_the_least_efforts():
    model = model_of(four_bar(("crank", "coupler")))
    q, v, vdot, w_ext = motion(model, 1)
    force, _ = model.numpy().inverse_dynamics_with_loops(q, v, vdot, w_ext)
    needed, J = model.numpy().inverse_dynamics(q, v, vdot, w_ext), model.numpy().gap_slopes(q)
    least = np.linalg.lstsq(v[None, :2], [needed @ v], rcond=None)[0]  # of all that give the motion its power
    assert len(J) == 2 and abs(force[2]) < 1e-9 * np.abs(needed).max()
    assert force[:2] == pytest.approx(least, rel=1e-8)


def test_drives_on_all_axes_where_the_file_states_none():
    model = model_of(four_bar(()))
    assert model.chain.driven_axes == [0, 1, 2] and model.chain.passive_axes == []
    q, v, vdot, w_ext = motion(model, 2)
    force, _ = model.numpy().inverse_dynamics_with_loops(q, v, vdot, w_ext)
    needed = model.numpy().inverse_dynamics(q, v, vdot, w_ext)
    assert force == pytest.approx(v * (needed @ v) / (v @ v), rel=1e-8)


def test_nothing_acts_on_modes_of_a_motion_that_the_robot_makes():
    """With a coupler that bends; and what holds one that rests on a straight coupler stands in the modes' entries."""
    model = model_of(four_bar(("crank",), modes={"bending_z": 2}, section={"EIy": 2000.0}))
    f, q = model.numpy(), assemble(model, [0.3, -0.4, -1.5])
    v, tau = moving(f, q, np.ones(model.nv)), np.array([3.0, 0.0, 0.0])
    vdot, _ = f.forward_dynamics(q, v, tau, None)
    force, wrenches = f.inverse_dynamics_with_loops(q, v, vdot, None)
    assert force == pytest.approx(np.append(tau, np.zeros(2)), abs=1e-8)
    assert relative(wrenches, f.loop_wrenches(q, v, tau, None)) < 1e-9
    rest = np.zeros(model.nv)
    held, _ = f.inverse_dynamics_with_loops(q, rest, rest, None)
    assert np.abs(held[1:3]).max() < 1e-9 and np.abs(held[3:]).max() > 1.0


@pytest.mark.parametrize("slope", [1.0, 0.1, 0.03])
def test_nothing_acts_on_modes_that_hardly_move_a_loop(slope):
    """The forces of rows that modes alone determine; drives could bear all, and count little."""
    rng = np.random.default_rng(3)
    passive, modes, driven = rng.normal(size=(3, 1)), slope * rng.normal(size=(3, 4)), rng.normal(size=(3, 5))
    J, wanted = np.hstack([passive, modes, driven]), rng.normal(size=3)
    f = np.append(wanted @ np.hstack([passive, modes]), rng.normal(size=5))
    found, _ = compiled(sharing((1, 4, 5), 3, False))({"J": J.ravel().tolist(), "f": f.tolist()}, np.finfo(float).eps)
    assert found["x"] == pytest.approx(wanted, rel=1e-9)
