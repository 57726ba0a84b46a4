"""Rest of robots with ball joints, and their vibrations under weight: against closed forms, and in the dynamics."""

import numpy as np
import pytest
import random_robots as rr
from floating_robots import rod
from helpers import model_of
from resting_robots import outcome
from scipy.spatial.transform import Rotation

from screwgen import UsageError, equilibrium, mode_shapes
from screwgen.cli.main import main

MASS, LENGTH, G = 2.0, 0.7, 9.81
INERTIA = [0.02, 0.03, 0.05, 0.0, 0.0, 0.0]
PENDULUM = {
    "name": "pendulum",
    "gravity": [0.0, 0.0, -G],
    "links": [
        {
            "name": "bob",
            "joint": {"axes": "ball"},
            "bodies": [{"at": "base", "mass": MASS, "com": [LENGTH, 0.0, 0.0], "inertia": INERTIA}],
        }
    ],
}
ARM = PENDULUM | {"name": "arm", "links": [rod("arm", ["y"]), {**rod("hand", []), "joint": {"axes": "ball"}}]}


def quaternion(*vector: float) -> np.ndarray:
    """Of a turn by a vector, rad."""
    return Rotation.from_rotvec(vector).as_quat(scalar_first=True)


HANGING = quaternion(0.0, np.pi / 2, 0.0)


@pytest.mark.parametrize("start", [(0.3, 0.2, -1.0), (0.0, -1.5, 0.1), (2.0, 0.5, 0.3)])
def test_a_pendulum_on_a_ball_joint_hangs_down(start):
    """From any posture; a turn about the vertical is left to it."""
    found = equilibrium(model_of(PENDULUM), quaternion(*start))
    assert np.allclose(
        Rotation.from_quat(found.q, scalar_first=True).apply([1.0, 0.0, 0.0]), [0.0, 0.0, -1.0], atol=1e-9
    )
    assert abs(np.linalg.norm(found.q) - 1.0) < 1e-15
    assert found.stability == "neutral" and found.loose == ("bob.joint[0]",)


def test_upright_it_is_unstable():
    found = equilibrium(model_of(PENDULUM), quaternion(0.0, -np.pi / 2, 0.0))
    assert found.stability == "unstable" and {"bob.joint[1]", "bob.joint[2]"} <= set(found.loose)


def test_a_ball_joint_is_held_by_the_moment_of_its_weight():
    """In the axes of the link, whose x points 0.6 rad below the horizontal."""
    found = equilibrium(model_of(PENDULUM), quaternion(0.0, 0.6, 0.0), hold=True)
    assert np.allclose(found.tau, [0.0, -MASS * G * LENGTH * np.cos(0.6), 0.0], atol=1e-12)
    assert found.held_joints == ("bob.joint[0]", "bob.joint[1]", "bob.joint[2]")


@pytest.mark.parametrize("start", [(0.1, 0.5, 0.1), (-0.1, 0.3, 0.3)])
def test_torques_that_hold_an_arm_hold_it_where_joints_are_free(start):
    """Those of ball joints turn with the link, so nothing is least there; forces vanish, and nothing accelerates."""
    model, turn = model_of(ARM), quaternion(0.2, 0.4, -0.3)
    held = equilibrium(model, [0.5, *turn], hold=True)
    free = equilibrium(model, [0.6, *quaternion(*start)], held.tau)
    vdot = model.numpy().forward_dynamics(free.q, np.zeros(model.nv), held.tau, None)[0]
    pushed = model.numpy().forward_dynamics(free.q, np.zeros(model.nv), held.tau + 1.0, None)[0]
    assert np.abs(vdot).max() < 1e-9 * np.abs(pushed).max()
    assert not free.held and free.residual < 1e-10


def test_a_pendulum_on_a_ball_joint_swings_under_its_weight_in_both_planes():
    """About its two axes across the bob; the turn about the vertical is rigid."""
    found = mode_shapes(model_of(PENDULUM), HANGING, "free", loaded=True)
    expected = [np.sqrt(MASS * G * LENGTH / (x + MASS * LENGTH**2)) / (2 * np.pi) for x in INERTIA[1:3]]
    assert np.allclose(found.frequencies, sorted(expected), rtol=1e-9) and found.rigid == 1 and not found.growth.any()


def test_upright_it_falls_as_fast_as_it_would_swing():
    found = mode_shapes(model_of(PENDULUM), quaternion(0.0, -np.pi / 2, 0.0), "free", loaded=True)
    expected = [np.sqrt(MASS * G * LENGTH / (x + MASS * LENGTH**2)) for x in INERTIA[1:3]]
    assert np.allclose(np.sort(found.growth), sorted(expected), rtol=1e-9)


def test_a_table_of_modes_at_rates_is_not_of_a_ball_joint_that_turns():
    model = model_of(ARM | {"gravity": [0.0, 0.0, 0.0]})
    assert mode_shapes(model, rates=[0.5, 0.0, 0.0, 0.0]).frequencies.all()
    with pytest.raises(UsageError, match="rates: the ball joint of link 'hand' turns, for which there is no table of"):
        mode_shapes(model, rates=[0.5, 0.1, 0.0, 0.0])


def test_the_command_states_quaternions(tmp_path, capsys):
    (tmp_path / "arm.toml").write_text(rr.to_toml(ARM))
    given = ",".join(map(str, [0.5, *quaternion(0.2, 0.4, -0.3)]))
    assert main(["equilibrium", str(tmp_path / "arm.toml"), "--hold", "--q", given]) == 0
    said = capsys.readouterr().out
    assert "hand.joint.qw" in said and "hand.torque[2]" in said


@pytest.mark.parametrize("seed", [4, 7, 8, 15, 18, 19, 33])
def test_random_robots_with_ball_joints_rest_where_their_energy_is_lowest(seed):
    said, text, _ = outcome(seed, balls=True)
    assert said == "found", text
